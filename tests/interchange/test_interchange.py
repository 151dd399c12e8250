"""Files for other codes, read by those codes, and what they wrote, read here.

Needs DEMETER (the binary) and DEMETER_RUN (the folder of a run). Each test runs where its program is installed: `lmp`,
`liggghts`, `yade` on the path, the packages `ovito` and `ase`.
"""

import csv
import gzip
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from programs import DEMETER, call, lammps_since, program

RUN = os.environ["DEMETER_RUN"]


def convert(source, target, *options):
    done = subprocess.run([DEMETER, "convert", str(source), str(target), "--overwrite", *options], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def columns(path):
    """The columns of a CSV file by name, sorted by id."""
    with open(path) as file:
        rows = list(csv.DictReader(file))
    table = {}
    for title in rows[0]:
        values = [row[title] for row in rows]
        try:
            table[title.split(" [")[0]] = np.array(values, dtype=float)
        except ValueError:
            table[title.split(" [")[0]] = np.array(values)
    if "id" in table:
        order = np.argsort(table["id"], kind="stable")
        table = {name: values[order] for name, values in table.items()}
    return table


def same(table, other, names, relative=0.0):
    for name in names.split():
        scale = np.abs(table[name]).max()
        np.testing.assert_allclose(other[name], table[name], rtol=relative, atol=relative * scale, err_msg=name)


MOVING = "x y z vx vy vz wx wy wz"


@pytest.fixture
def ours(tmp_path):
    """The last frame of the run as CSV, and its columns."""
    convert(RUN, tmp_path / "ours.csv")
    return columns(tmp_path / "ours.csv")


@program("lmp")
def test_lammps_reads_our_data_and_we_its_data_and_dumps(tmp_path, ours):
    convert(RUN, tmp_path / "in.data")
    form = "modify format float %.17g"
    script = f"""units si
atom_style sphere
boundary f f f
read_data in.data
write_dump all custom back.dump id type x y z radius mass vx vy vz omegax omegay omegaz {form} units yes
write_dump all custom back.dump.gz id type x y z radius mass vx vy vz omegax omegay omegaz {form} units yes
write_data back.data
change_box all triclinic
change_box all xy final 0.001 boundary p p p
write_dump all custom tilted.dump id type xs ys zs radius mass {form}
write_data tilted.data
"""
    (tmp_path / "in.lammps").write_text(script)
    call(tmp_path, ["lmp", "-in", "in.lammps", "-log", "none"], script)
    for name in ["back.dump", "back.dump.gz"]:
        convert(tmp_path / name, tmp_path / "back.csv")
        back = columns(tmp_path / "back.csv")
        same(ours, back, f"id {MOVING} diameter")
        same(ours, back, "density", 1e-14)
    # `write_data` of older versions writes 6 digits
    convert(tmp_path / "back.data", tmp_path / "back.csv")
    same(ours, columns(tmp_path / "back.csv"), f"{MOVING} diameter density", 2e-5)
    for name in ["tilted.dump", "tilted.data"]:
        convert(tmp_path / name, tmp_path / "tilted.xyz")
        lattice = (tmp_path / "tilted.xyz").read_text().splitlines()[1].split('"')[1].split()
        assert abs(float(lattice[3]) - 0.001) < 1e-12, name
        convert(tmp_path / name, tmp_path / "tilted.csv")
        same(ours, columns(tmp_path / "tilted.csv"), "x y z", 2e-5)


@program("lmp")
def test_lammps_reads_our_dump(tmp_path, ours):
    convert(RUN, tmp_path / "in.data", "--frame", "0")
    convert(RUN, tmp_path / "in.dump", "--frame", "all")
    steps = [line for line in (tmp_path / "in.dump").read_text().splitlines()]
    last = steps[len(steps) - 1 - steps[::-1].index("ITEM: TIMESTEP") + 1]
    script = f"""units si
atom_style sphere
boundary f f f
read_data in.data
read_dump in.dump {last} x y z vx vy vz box yes replace yes
write_dump all custom back.dump id x y z radius vx vy vz modify format float %.17g
"""
    (tmp_path / "in.lammps").write_text(script)
    call(tmp_path, ["lmp", "-in", "in.lammps", "-log", "none"], script)
    convert(tmp_path / "back.dump", tmp_path / "back.csv")
    # places pass through shares of the box there
    same(ours, columns(tmp_path / "back.csv"), "id x y z vx vy vz", 1e-14)


@program("lmp")
def test_a_hybrid_style_of_lammps_is_read(tmp_path):
    script = """units si
atom_style hybrid sphere charge
boundary f f f
region box block 0 1 0 1 0 1
create_box 2 box
create_atoms 1 single 0.1 0.2 0.3
create_atoms 2 single 0.4 0.2 0.3
set group all diameter 0.01 density 2500 charge 0.5
mass * 1
write_data hybrid.data
"""
    (tmp_path / "in.lammps").write_text(script)
    call(tmp_path, ["lmp", "-in", "in.lammps", "-log", "none"], script)
    # LAMMPS writes `Atoms # hybrid`, without the parts
    command = [DEMETER, "convert", "hybrid.data", "hybrid.csv"]
    refused = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert refused.returncode == 2 and "--atom-style" in refused.stderr, refused.stderr
    convert(tmp_path / "hybrid.data", tmp_path / "hybrid.csv", "--atom-style", "hybrid sphere charge")
    table = columns(tmp_path / "hybrid.csv")
    assert list(table["charge"]) == [0.5, 0.5] and list(table["diameter"]) == [0.01, 0.01]


@program("liggghts")
def test_liggghts_reads_our_data_and_we_its_data_and_dumps(tmp_path, ours):
    convert(RUN, tmp_path / "in.liggghts")
    script = f"""atom_style granular
atom_modify map array sort 0 0.0
boundary f f f
newton off
communicate single vel yes
units si
read_data in.liggghts
neighbor 0.001 bin
pair_style none
timestep 1e-9
fix move all nve/sphere
dump d all custom 1 back.dump id type mass x y z radius density vx vy vz omegax omegay omegaz
dump_modify d format "%d %d{' %.17g' * 12}"
run 0
write_data back.data
"""
    (tmp_path / "in.script").write_text(script)
    call(tmp_path, ["liggghts", "-in", "in.script", "-log", "none"], script)
    for name in ["back.dump", "back.data"]:
        convert(tmp_path / name, tmp_path / "back.csv")
        back = columns(tmp_path / "back.csv")
        same(ours, back, f"id {MOVING} diameter")
        # kept as a mass there
        same(ours, back, "density", 1e-15)


@program("yade")
def test_yade_reads_our_packing_and_we_its(tmp_path, ours):
    convert(RUN, tmp_path / "in.yade")
    script = """from yade import export, ymport
O.bodies.append(ymport.text('in.yade'))
with open('exact.csv', 'w') as out:
    out.write('x,y,z,radius\\n')
    for b in O.bodies:
        out.write('%r,%r,%r,%r\\n' % (*(float(v) for v in b.state.pos), float(b.shape.radius)))
export.text('back.txt')
export.textExt('material.txt', format='x_y_z_r_matId')
export.textExt('attributes.txt', format='x_y_z_r_attrs', attrs=['b.id', 'b.state.vel'], comment='number vx vy vz')
"""
    (tmp_path / "script.py").write_text(script)
    call(tmp_path, ["yade", "-n", "-x", "script.py"], script)
    # ids are those of the order in the file
    convert(RUN, tmp_path / "order.yade")
    convert(tmp_path / "order.yade", tmp_path / "order.csv")
    order = columns(tmp_path / "order.csv")
    same(order, columns(tmp_path / "exact.csv"), "x y z")
    # YADE writes 6 digits
    for name in ["back.txt", "material.txt", "attributes.txt"]:
        convert(tmp_path / name, tmp_path / "back.csv")
        back = columns(tmp_path / "back.csv")
        same(order, back, "x y z diameter", 1e-5)
    assert list(back["number"]) == list(range(len(order["x"])))


def test_ovito_reads_our_files_and_we_its(tmp_path, ours):
    io = pytest.importorskip("ovito.io")
    convert(RUN, tmp_path / "in.xyz", "--frame", "all")
    convert(RUN, tmp_path / "in.dump", "--frame", "all")
    convert(RUN, tmp_path / "in.data")
    for name, atom_style in [("in.xyz", None), ("in.dump", None), ("in.data", "sphere")]:
        pipeline = io.import_file(str(tmp_path / name), **({"atom_style": atom_style} if atom_style else {}))
        if name != "in.data":
            assert pipeline.source.num_frames > 5
        data = pipeline.compute(pipeline.source.num_frames - 1)
        particles = data.particles
        order = np.argsort(np.asarray(particles["Particle Identifier"]))
        read = {axis: np.asarray(particles.positions)[order, k] for k, axis in enumerate("xyz")}
        # its reader of numbers errs in the last bit
        same(ours, read, "x y z", 1e-15)
        np.testing.assert_allclose(2 * np.asarray(particles["Radius"])[order], ours["diameter"], rtol=1e-6)
        velocity = np.asarray(particles["Velocity"])[order]
        same(ours, {f"v{axis}": velocity[:, k] for k, axis in enumerate("xyz")}, "vx vy vz", 1e-15)
        if name == "in.xyz":
            types = particles.particle_types
            assert {kind.name for kind in types.types if kind.id in set(types)} == {"soft"}
            assert data.attributes["Time"] == pytest.approx(0.1, abs=1e-4)
            assert np.asarray(particles["Orientation"]).shape == (len(order), 4)
        exported = ["Particle Identifier", "Particle Type", "Position.X", "Position.Y", "Position.Z", "Radius"]
        exported += ["Velocity.X", "Velocity.Y", "Velocity.Z"]
        for form, ending in [("xyz", "xyz"), ("lammps/dump", "dump")]:
            if form == "lammps/dump" and data.cell is None:
                continue
            back = tmp_path / f"back.{ending}"
            precision = {"precision": 17} if form == "xyz" else {}
            io.export_file(pipeline, str(back), form, columns=exported, frame=pipeline.source.num_frames - 1, **precision)
            convert(back, tmp_path / "back.csv")
            same(ours, columns(tmp_path / "back.csv"), "x y z vx vy vz diameter", 1e-6 if form != "xyz" else 1e-7)


def test_ase_reads_our_extended_xyz_and_we_its(tmp_path, ours):
    io = pytest.importorskip("ase.io")
    convert(RUN, tmp_path / "in.xyz", "--frame", "all", "--columns", "type,x,y,z,id,radius,density,vx,vy,vz")
    frames = io.read(tmp_path / "in.xyz", index=":")
    assert len(frames) > 5
    last = frames[-1]
    order = np.argsort(last.arrays["id"])
    read = {axis: last.positions[order, k] for k, axis in enumerate("xyz")}
    same(ours, read, "x y z", 1e-15)
    np.testing.assert_array_equal(2 * last.arrays["radius"][order], ours["diameter"])
    assert last.info["Time"] == pytest.approx(0.1, abs=1e-4)
    io.write(tmp_path / "back.xyz", last, format="extxyz")
    convert(tmp_path / "back.xyz", tmp_path / "back.csv")
    # ASE writes 8 decimals, which are metres here
    np.testing.assert_allclose(columns(tmp_path / "back.csv")["x"], ours["x"], atol=1e-8)


SHEARED = """
[simulation]
max_overlap = 0.3
[domain]
lower = "0 0 0 mm"
upper = "10 10 10 mm"
periodic = ["x", "y", "z"]
deform = { shear = { flow = "x", gradient = "z", rate = "20 1/s" } }
[material.m]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
[[grains]]
material = "m"
source = "random"
region = { shape = "box", lower = "0 0 0 mm", upper = "10 10 10 mm" }
diameter = "1.5 mm"
count = 60
[[stage]]
duration = "20 ms"
[output]
frames = "5 ms"
"""


def nearest(places, edges):
    """Distances between all grains, of the nearest images."""
    apart = places[:, None] - places[None]
    shifts = np.array([[i, j, k] for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]) @ edges
    whole = np.round(apart @ np.linalg.inv(edges)) @ edges
    return np.sqrt((((apart - whole)[:, :, None] + shifts) ** 2).sum(axis=-1)).min(axis=-1)


# the first edge leaves the x axis: LAMMPS knows such boxes since 17 April 2024, by their `general` names
GENERAL = SHEARED.replace('flow = "x", gradient = "z"', 'flow = "z", gradient = "x"')


def edges_of(path):
    """The edges of the box of an extended XYZ file, row by row."""
    lattice = Path(path).read_text().splitlines()[1].split('Lattice="')[1].split('"')[0]
    return np.array(lattice.split(), dtype=float).reshape(3, 3)


def places_of(path, tmp_path):
    convert(path, tmp_path / "places.csv")
    table = columns(tmp_path / "places.csv")
    return np.stack([table[axis] for axis in "xyz"], axis=1)


@pytest.fixture
def general(tmp_path):
    """The folder of a run in a box with edges in any direction, the edges, and the distances of the nearest images."""
    (tmp_path / "general.toml").write_text(GENERAL)
    call(tmp_path, [DEMETER, "run", "general.toml", "--out", "general"], GENERAL)
    convert(tmp_path / "general", tmp_path / "general.xyz", "--frame", "last")
    edges = edges_of(tmp_path / "general.xyz")
    # 20 ms at 20 1/s: 0.4 of the width
    np.testing.assert_allclose(edges, np.array([[1, 0, 0.4], [0, 1, 0], [0, 0, 1]]) * 0.01, atol=1e-5)
    return tmp_path / "general", edges, nearest(places_of(tmp_path / "general", tmp_path), edges)


def test_ase_reads_a_box_with_edges_in_any_direction_and_we_its(tmp_path, general):
    io = pytest.importorskip("ase.io")
    run, edges, apart = general
    # ASE takes names of materials for chemical elements
    convert(run, tmp_path / "in.xyz", "--frame", "last", "--columns", "type,x,y,z,id,radius,density")
    read = io.read(tmp_path / "in.xyz")
    np.testing.assert_array_equal(read.cell.array, edges)
    assert read.pbc.all()
    order = np.argsort(read.arrays["id"])
    np.testing.assert_allclose(read.get_all_distances(mic=True)[np.ix_(order, order)], apart, atol=1e-12)
    # turned, so that no edge lies along an axis; in lengths that the 8 decimals of ASE hold well
    read.set_cell(read.cell.array * 1e3, scale_atoms=True)
    read.rotate(37, (1, 2, 3), rotate_cell=True)
    read.wrap()
    io.write(tmp_path / "back.xyz", read, format="extxyz")
    convert(tmp_path / "back.xyz", tmp_path / "ours.xyz")
    np.testing.assert_allclose(edges_of(tmp_path / "ours.xyz"), read.cell.array, atol=1e-7)
    places = places_of(tmp_path / "back.xyz", tmp_path)
    np.testing.assert_allclose(nearest(places, edges_of(tmp_path / "ours.xyz")), apart * 1e3, atol=1e-6)


def test_ovito_reads_a_box_with_edges_in_any_direction_and_we_its(tmp_path, general):
    io = pytest.importorskip("ovito.io")
    run, edges, apart = general
    for name, options in [("in.xyz", {}), ("in.dump", {}), ("in.data", {"atom_style": "sphere"})]:
        convert(run, tmp_path / name, "--frame", "last")
        data = io.import_file(str(tmp_path / name), **options).compute()
        assert all(data.cell.pbc), name
        box = np.asarray(data.cell)[:, :3].T
        order = np.argsort(np.asarray(data.particles["Particle Identifier"]))
        places = np.asarray(data.particles.positions)[order]
        # LAMMPS boxes are told by a right hand; images and distances are the same
        np.testing.assert_allclose(abs(np.linalg.det(box)), abs(np.linalg.det(edges)), rtol=1e-12)
        np.testing.assert_allclose(nearest(places, box), apart, atol=1e-12, err_msg=name)
        if name == "in.xyz":
            np.testing.assert_allclose(box, edges, atol=1e-15)
            export = {"columns": ["Particle Identifier", "Position.X", "Position.Y", "Position.Z", "Radius"], "precision": 17}
            io.export_file(data, str(tmp_path / "back.xyz"), "xyz", **export)
            convert(tmp_path / "back.xyz", tmp_path / "ours.xyz")
            np.testing.assert_allclose(edges_of(tmp_path / "ours.xyz"), edges, atol=1e-12)
            np.testing.assert_allclose(nearest(places_of(tmp_path / "back.xyz", tmp_path), edges), apart, atol=1e-12)


@lammps_since("17 Apr 2024")
def test_lammps_reads_a_box_with_edges_in_any_direction_and_we_its(tmp_path, general):
    run, edges, apart = general
    convert(run, tmp_path / "in.data")
    form = "modify format float %.17g"
    script = f"""units si
atom_style sphere
boundary p p p
read_data in.data
write_dump all custom general.dump id type x y z radius mass {form} triclinic/general yes
write_dump all custom turned.dump id type x y z radius mass {form}
write_data general.data triclinic/general nocoeff
"""
    (tmp_path / "in.lammps").write_text(script)
    call(tmp_path, ["lmp", "-in", "in.lammps", "-log", "none"], script)
    for name, digits in [("general.dump", 1e-12), ("turned.dump", 1e-12), ("general.data", 1e-8)]:
        convert(tmp_path / name, tmp_path / "ours.xyz")
        box = edges_of(tmp_path / "ours.xyz")
        if name != "turned.dump":
            np.testing.assert_allclose(box, edges, atol=digits, err_msg=name)
        # LAMMPS itself turns the box until the first edge lies along x
        np.testing.assert_allclose(nearest(places_of(tmp_path / name, tmp_path), box), apart, atol=digits, err_msg=name)


@program("lmp")
def test_lammps_reads_a_box_that_was_sheared(tmp_path):
    (tmp_path / "sheared.toml").write_text(SHEARED)
    command = [DEMETER, "run", "sheared.toml", "--out", "run"]
    call(tmp_path, command, SHEARED)
    convert(tmp_path / "run", tmp_path / "in.data")
    script = """units si
atom_style sphere
boundary p p p
read_data in.data
write_dump all custom back.dump id type x y z radius mass modify format float %.17g
"""
    (tmp_path / "in.lammps").write_text(script)
    call(tmp_path, ["lmp", "-in", "in.lammps", "-log", "none"], script)
    convert(tmp_path / "run", tmp_path / "ours.xyz", "--frame", "last")
    convert(tmp_path / "back.dump", tmp_path / "back.xyz")
    boxes = []
    for name in ["ours.xyz", "back.xyz"]:
        lattice = (tmp_path / name).read_text().splitlines()[1].split('Lattice="')[1].split('"')[0]
        boxes.append(np.array(lattice.split(), dtype=float).reshape(3, 3))
    # 20 ms at 20 1/s: 0.4 of the height
    np.testing.assert_allclose(boxes[0][2, 0], 4e-3, rtol=1e-3)
    np.testing.assert_allclose(boxes[1], boxes[0], atol=1e-15)
    convert(tmp_path / "run", tmp_path / "ours.csv")
    convert(tmp_path / "back.dump", tmp_path / "back.csv")
    ours, back = columns(tmp_path / "ours.csv"), columns(tmp_path / "back.csv")
    places = [np.stack([table[axis] for axis in "xyz"], axis=1) for table in (ours, back)]
    np.testing.assert_allclose(nearest(places[1], boxes[0]), nearest(places[0], boxes[0]), atol=1e-12)


BOOK = Path(__file__).parents[2] / "book/src/files"
TOP = 0.06


def settled(path, tmp_path):
    """The last moment of what another code wrote of its box in the book: 300 beads that lie in it."""
    convert(path, tmp_path / "theirs.csv", "--density", "2500 kg/m^3")
    beads = columns(tmp_path / "theirs.csv")
    assert len(beads["x"]) == 300
    assert (beads["z"] > 0).all() and (beads["z"] < TOP).all()
    if "vx" in beads:
        speeds = np.sqrt(beads["vx"] ** 2 + beads["vy"] ** 2 + beads["vz"] ** 2)
        assert np.median(speeds) < 0.05


@program("lmp")
def test_the_input_for_lammps_in_the_book_runs(tmp_path):
    call(tmp_path, ["lmp", "-in", str(BOOK / "box.lammps"), "-log", "none"], "box.lammps")
    settled(tmp_path / "grains.dump", tmp_path)


@program("liggghts")
def test_the_input_for_liggghts_in_the_book_runs(tmp_path):
    call(tmp_path, ["liggghts", "-in", str(BOOK / "box.liggghts"), "-log", "none"], "box.liggghts")
    settled(tmp_path / "grains.30000.dump", tmp_path)


@program("yade")
def test_the_script_for_yade_in_the_book_runs(tmp_path):
    # ends by itself only where it says so
    script = (BOOK / "box.yade.py").read_text() + "\nfrom yade import export\nexport.text('packing.txt')\n"
    (tmp_path / "box.py").write_text(script)
    call(tmp_path, ["yade", "-n", "-x", "box.py"], script)
    settled(tmp_path / "packing.txt", tmp_path)


def test_a_packing_of_a_dump_is_grains_of_a_run(tmp_path, ours):
    convert(RUN, tmp_path / "start.dump", "--frame", "all")
    with open(tmp_path / "start.dump", "rb") as plain, gzip.open(tmp_path / "start.dump.gz", "wb") as packed:
        packed.write(plain.read())
    scenario = Path(__file__).parent.parent / "python" / "scenario.toml"
    command = [DEMETER, "run", str(scenario), "--out", "again", "--set", "stage[0].duration='1 us'"]
    source = f'grains=[{{ material = "soft", source = "file", file = "{tmp_path}/start.dump.gz" }}]'
    done = subprocess.run([*command, "--set", source], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    convert(tmp_path / "again", tmp_path / "again.csv", "--frame", "0")
    same(ours, columns(tmp_path / "again.csv"), "id x y z vx vy vz diameter")
