"""Opens the folder of a run with PyVista from PyPI and checks that it tells one consistent story.

DEMETER_RUN names the folder. The run must write at least one frame at the time of a row of its series.

    pip install -r tests/python/requirements.txt
    DEMETER_RUN=runs/hydrogel-compression pytest tests/python
"""

import csv
import json
import os
from pathlib import Path

import numpy as np
import pytest
import pyvista

# relative precision of forces in the contact plane, which are told in single precision
SINGLE = 1e-7

KINDS = ("grains", "contacts", "walls")
GRAIN_ARRAYS = {
    "id": 1,
    "material": 1,
    "radius": 1,
    "diameter": 1,
    "mass": 1,
    "velocity": 3,
    "angular_velocity": 3,
    "orientation": 4,
    "force": 3,
    "torque": 3,
    "coordination": 1,
}
CONTACT_ARRAYS = {
    "id_i": 1,
    "id_j": 1,
    "wall": 1,
    "element": 1,
    "normal": 3,
    "overlap": 1,
    "normal_force": 3,
    "tangential_force": 3,
    "force": 3,
    "normal_force_magnitude": 1,
    "force_magnitude": 1,
    "rolling_torque": 3,
}
WALL_ARRAYS = {"wall": 1, "force": 3, "torque": 3, "velocity": 3}
INTEGERS = {"id", "material", "coordination", "id_i", "id_j", "wall", "element"}


@pytest.fixture(scope="module")
def run():
    if "DEMETER_RUN" not in os.environ:
        pytest.fail("set DEMETER_RUN to the folder of a run")
    return Path(os.environ["DEMETER_RUN"])


@pytest.fixture(scope="module")
def frames(run):
    """Per time: the grains, contacts and walls, as the collections name them."""
    readers = {kind: pyvista.get_reader(str(run / f"{kind}.pvd")) for kind in KINDS}
    times = readers["grains"].time_values
    assert len(times) > 0, "the run wrote no frame"
    for kind in KINDS:
        assert list(readers[kind].time_values) == list(times), kind
    result = []
    for k, time in enumerate(times):
        frame = {}
        for kind, reader in readers.items():
            reader.set_active_time_point(k)
            frame[kind] = reader.read()[0]
        result.append((time, frame))
    return result


@pytest.fixture(scope="module")
def series(run):
    with open(run / "series.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file, strict=True))
    assert rows, "the series has no row"
    return rows


def check_arrays(data, count, expected):
    for name, components in expected.items():
        array = np.asarray(data[name])
        shape = (count,) if components == 1 else (count, components)
        assert array.shape == shape, name
        if name in INTEGERS:
            assert np.issubdtype(array.dtype, np.integer), name
        else:
            assert array.dtype == np.float64, name
            assert np.isfinite(array).all(), name


def test_every_file_on_disk_is_in_a_collection(run, frames):
    for kind in KINDS:
        assert len(list((run / "frames").glob(f"{kind}_*.vtp"))) == len(frames)
    assert not list(run.rglob("*.part"))


def test_files_carry_their_time(frames):
    for time, frame in frames:
        for kind in KINDS:
            assert frame[kind].field_data["TimeValue"][0] == time
            assert frame[kind].field_data["step"][0] == frame["grains"].field_data["step"][0]


def test_grains(frames):
    for _, frame in frames:
        grains = frame["grains"]
        n = grains.n_points
        assert grains.n_cells == n
        check_arrays(grains.point_data, n, GRAIN_ARRAYS)
        if n == 0:
            continue
        assert np.asarray(grains.points).dtype == np.float64
        assert len(np.unique(grains["id"])) == n
        assert (grains["radius"] > 0).all() and (grains["mass"] > 0).all()
        assert (grains["diameter"] == 2 * grains["radius"]).all()
        assert np.allclose(np.linalg.norm(grains["orientation"], axis=1), 1, rtol=0, atol=1e-9)
        assert (grains["material"] < len(grains.field_data["material_names"])).all()


def test_contacts_name_grains_and_walls_of_the_frame(frames):
    for _, frame in frames:
        contacts, ids = frame["contacts"], frame["grains"]["id"]
        n = contacts.n_points
        assert contacts.n_cells == n
        check_arrays(contacts.point_data, n, CONTACT_ARRAYS)
        if n == 0:
            assert (frame["grains"]["coordination"] == 0).all()
            continue
        at_wall = contacts["wall"] >= 0
        assert np.isin(contacts["id_i"], ids).all()
        assert np.isin(contacts["id_j"][~at_wall], ids).all()
        assert (contacts["id_j"][at_wall] == 0).all()
        assert (contacts["id_i"][~at_wall] < contacts["id_j"][~at_wall]).all()
        assert (contacts["wall"] < len(frame["walls"].field_data["wall_names"])).all()
        ends = np.concatenate([contacts["id_i"], contacts["id_j"][~at_wall]])
        counts = dict(zip(*np.unique(ends, return_counts=True)))
        assert [counts.get(i, 0) for i in ids] == list(frame["grains"]["coordination"])


def test_contact_forces_stand_as_their_names_say(frames):
    for _, frame in frames:
        contacts = frame["contacts"]
        if contacts.n_points == 0:
            continue
        normal, normal_force = contacts["normal"], contacts["normal_force"]
        tangential_force, force = contacts["tangential_force"], contacts["force"]
        scale = contacts["force_magnitude"].max()
        assert np.allclose(np.linalg.norm(normal, axis=1), 1, rtol=0, atol=1e-12)
        assert np.abs(np.cross(normal, normal_force)).max() <= 1e-9 * scale, "normal force along the normal"
        along = np.einsum("ij,ij->i", normal, tangential_force)
        assert np.abs(along).max() <= SINGLE * scale, "tangential force across the normal"
        assert np.abs(normal_force + tangential_force - force).max() <= 1e-12 * scale
        for name, vectors in (("force_magnitude", force), ("normal_force_magnitude", normal_force)):
            assert np.allclose(contacts[name], np.linalg.norm(vectors, axis=1), rtol=1e-12, atol=0)


def test_walls(frames):
    for _, frame in frames:
        walls = frame["walls"]
        n = walls.n_cells
        assert walls.n_points == 3 * n
        check_arrays(walls.cell_data, n, WALL_ARRAYS)


def test_wall_forces_are_those_of_the_series(frames, series):
    rows = {float(row["time [s]"]): row for row in series}
    compared = 0
    for time, frame in frames:
        if time not in rows or frame["contacts"].n_points == 0:
            continue
        contacts = frame["contacts"]
        for index, name in enumerate(frame["walls"].field_data["wall_names"]):
            mine = contacts["wall"] == index
            total = -contacts["force"][mine].sum(axis=0)
            row = [float(rows[time][f"wall {name} force {axis} [N]"]) for axis in "xyz"]
            scale = contacts["force_magnitude"][mine].sum()
            assert np.abs(total - row).max() <= SINGLE * scale, (time, name)
            shown = frame["walls"]["force"][frame["walls"]["wall"] == index]
            assert np.abs(shown - row).max(initial=0) <= 1e-9 * scale, (time, name)
            assert int(rows[time][f"wall {name} contacts"]) == mine.sum()
            compared += 1
    assert compared > 0, "no frame with contacts was written at the time of a row of the series"


def test_series_is_in_order_and_complete(series):
    steps = [int(row["step"]) for row in series]
    assert steps == sorted(set(steps))
    for row in series:
        assert None not in row and None not in row.values()
        assert row["stage"]
        for name, text in row.items():
            if name != "stage":
                float(text)


def test_summary_agrees_with_the_series(run, series):
    summary = json.loads((run / "summary.json").read_text(encoding="utf-8"))
    assert summary["steps"] >= int(series[-1]["step"])
    assert summary["version"]


def test_fields_hold_the_mass_and_the_momentum_of_the_grains(run, frames):
    if not (run / "fields" / "bulk.pvd").exists():
        pytest.skip("the run measured no field `bulk`")
    reader = pyvista.get_reader(str(run / "fields" / "bulk.pvd"))
    assert list(reader.time_values) == [time for time, _ in frames]
    for k, (_, frame) in enumerate(frames):
        reader.set_active_time_point(k)
        field = reader.read()[0]
        assert isinstance(field, pyvista.ImageData) and field.n_cells == 20 * 20 * 25
        volume = np.prod(field.spacing)
        mass = frame["grains"].point_data["mass"]
        momentum = (mass[:, None] * frame["grains"].point_data["velocity"]).sum(axis=0)
        # cells tell the field at their middles, so their sum is not exact
        assert np.isclose(field.cell_data["density"].sum() * volume, mass.sum(), rtol=0.02)
        scale = (mass * np.linalg.norm(frame["grains"].point_data["velocity"], axis=1)).sum()
        assert np.allclose(field.cell_data["momentum"].sum(axis=0) * volume, momentum, atol=0.02 * scale + 1e-12)
        moving = np.isfinite(field.cell_data["velocity"]).all(axis=1)
        assert moving.any() and (moving == (field.cell_data["density"] > 0)).all()
