"""Runs in one's hands: pauses, callbacks, arrays, functions, folders."""

import gc
import signal
import threading
import time
import weakref

import numpy as np
import pytest

import demeter
from conftest import same
from demeter._progress import Bar


def test_pauses_change_nothing(bed):
    whole = demeter.run(bed, threads=1)
    assert whole.finished and whole.summary["finished"]
    pieces = demeter.Simulation(bed, threads=2)
    assert pieces.stage == "settle"
    assert pieces.run_stage() and pieces.stage == "press"
    assert pieces.run_until("21 ms")
    assert pieces.time == pytest.approx(0.021, abs=pieces.dt)
    pieces.step(3)
    assert pieces.run()
    assert same(whole, pieces)
    for title, column in whole.series().items():
        assert list(column) == list(pieces.series()[title]), title
    pieces.step(10)  # beyond the protocol
    assert pieces.steps == whole.steps + 10


def test_conditions(bed):
    sim = demeter.Simulation(bed)
    assert sim.run_until(lambda s: s.velocities[:, 2].min() < -0.1, every=10)
    assert sim.velocities[:, 2].min() < -0.1 and sim.time < 0.015
    assert not sim.run_until(lambda s: False, at_most="16 ms")
    assert sim.time == pytest.approx(0.016, abs=sim.dt)
    with pytest.raises(ValueError, match="already"):
        sim.run_until("1 ms")
    with pytest.raises(TypeError, match="a time"):
        sim.run_until(None)
    with pytest.raises(ValueError, match="time"):
        sim.run_until("1 mm")
    with pytest.raises(ZeroDivisionError):
        sim.run_until(lambda s: 1 / 0)
    sim.step()


def test_callbacks(bed):
    sim = demeter.Simulation(bed)
    seen, counted = [], []

    @sim.every("1 ms")
    def watch(s):
        seen.append(s.time)

    sim.every(100, lambda s: counted.append(s.steps))
    sim.run()
    assert 29 <= len(seen) <= 31 and np.allclose(np.diff(seen), 1e-3, rtol=1e-2)
    assert counted == list(range(100, sim.steps + 1, 100))
    sim.cancel(watch)
    calls = len(seen)
    sim.step(1000)
    assert len(seen) == calls
    with pytest.raises(ValueError):
        sim.every(0, watch)
    with pytest.raises(TypeError, match="function"):
        sim.every(1, 3)


def test_what_a_callback_raises_comes_out_and_the_run_goes_on(bed):
    class Mine(Exception):
        pass

    error = Mine("as it was")
    sim = demeter.Simulation(bed, threads=1)

    def fails(s):
        raise error

    sim.every(500, fails)
    with pytest.raises(Mine) as caught:
        sim.run()
    assert caught.value is error and sim.steps == 500
    sim.cancel(fails)
    assert sim.run()
    assert same(sim, demeter.run(bed, threads=1))


def test_a_callback_may_stop_but_not_run(bed):
    sim = demeter.Simulation(bed)
    sim.every(200, lambda s: s.stop())
    assert not sim.run() and sim.steps == 200
    sim = demeter.Simulation(bed)
    sim.every(10, lambda s: s.step())
    with pytest.raises(demeter.RunError, match="runs already"):
        sim.run()


def test_arrays_share_memory_and_never_dangle(bed):
    sim = demeter.Simulation(bed)
    sim.step(10)
    positions, radii, velocities = sim.positions, sim.radii, sim.velocities
    assert positions.shape == (50, 3) and radii.shape == (50,) and sim.ids.dtype == np.uint32
    assert not positions.flags.owndata and not positions.flags.writeable
    assert np.shares_memory(positions, sim.positions)
    with pytest.raises(ValueError):
        positions[0, 0] = 1.0
    before, speeds = positions.copy(), velocities.copy()
    sim.run()
    # they show the moment at which they were taken
    assert np.array_equal(positions, before) and np.array_equal(velocities, speeds)
    assert not np.shares_memory(positions, sim.positions)
    assert not np.array_equal(positions, sim.positions)
    del sim
    gc.collect()
    assert np.array_equal(positions, before) and np.allclose(radii, 2e-3)


def test_orientations_are_followed_where_that_is_asked_for(bed):
    sim = demeter.Simulation(bed)
    with pytest.raises(demeter.RunError, match="orientations = true"):
        sim.orientations


def test_orientations_are_shown_without_a_copy(bed):
    bed["simulation"]["orientations"] = True
    sim = demeter.run(bed)
    orientations = sim.orientations
    assert orientations.shape == (50, 4) and not orientations.flags.owndata and not orientations.flags.writeable
    assert np.shares_memory(orientations, sim.orientations)
    assert np.allclose(np.linalg.norm(orientations, axis=1), 1, rtol=0, atol=1e-9)
    assert (np.abs(orientations[:, 3]) < 1).any(), "some grain has turned"
    before = orientations.copy()
    sim.step(100)
    assert np.array_equal(orientations, before) and not np.array_equal(orientations, sim.orientations)


def test_an_array_keeps_its_simulation(bed):
    sim = demeter.Simulation(bed)
    sim.step()
    gone = weakref.ref(sim)
    positions = sim.positions
    copy = positions.copy()
    del sim
    gc.collect()
    assert gone() is not None and np.array_equal(positions, copy)
    del positions
    gc.collect()
    assert gone() is None


def test_a_cycle_through_a_callback_is_collected(bed):
    sim = demeter.Simulation(bed)
    sim.every(10, lambda s, own=sim: None)
    sim.add_force(lambda state, own=sim: None)
    gone = weakref.ref(sim)
    del sim
    gc.collect()
    assert gone() is None


def test_rows_are_found_by_id(bed):
    sim = demeter.run(bed)
    assert list(sim.ids[sim.indices()]) == list(range(1, 51))
    assert list(sim.ids[sim.indices([7, 3])]) == [7, 3]
    with pytest.raises(KeyError, match="99"):
        sim.indices([99])


def test_setters_keep_the_books(bed):
    sim = demeter.Simulation(bed)
    sim.run_until("18 ms")
    sim.velocities = sim.velocities * 0.5
    sim.angular_velocities = np.zeros((50, 3))
    sim.positions = sim.positions + [0, 0, 1e-5]
    sim.step(500)
    assert abs(sim.residual) < 1e-3
    assert sim.energies()["custom_work"] != 0
    with pytest.raises(ValueError, match="49 vectors for 50 grains"):
        sim.positions = sim.positions[1:]
    with pytest.raises(ValueError, match="not finite"):
        sim.velocities = np.full((50, 3), np.nan)
    with pytest.raises(TypeError, match="array of numbers"):
        sim.velocities = "fast"
    with pytest.raises(ValueError, match=r"\(n, 3\)"):
        sim.velocities = np.zeros((50, 2))
    one = sim.positions.copy()
    one[0] = one[1]
    with pytest.raises(demeter.Fault, match="overlaps"):
        sim.positions = one


def test_contacts_walls_and_measures(bed):
    sim = demeter.run(bed)
    contacts = sim.contacts()
    assert len(contacts["i"]) > 50 and np.allclose(np.linalg.norm(contacts["normal"], axis=1), 1)
    total = np.zeros(3)
    for i, j, force in zip(contacts["i"], contacts["j"], contacts["force"]):
        total += force if j == 0 else 0
    walls = sum(wall["force"] for wall in sim.walls.values())
    assert np.allclose(total, -walls, rtol=1e-6, atol=1e-9)
    measures = sim.measures()
    assert measures["grains"] == 50 and measures["time [s]"] == sim.time
    assert measures["energy residual"] == pytest.approx(sim.residual)
    assert sim.walls["plate"]["displacement"][2] == pytest.approx(-0.002, rel=1e-3)


def test_contacts_are_put_together_once_for_every_state(bed):
    sim = demeter.run(bed)
    before, again = sim.contacts(), sim.contacts()
    for name, array in before.items():
        assert not array.flags.owndata and not array.flags.writeable and array.flags.c_contiguous
        assert np.shares_memory(array, again[name]), name
    copies = {name: array.copy() for name, array in before.items()}
    with pytest.raises(ValueError):
        before["force"][0] = 0.0
    assert np.array_equal(before["force"], before["normal_force"] + before["tangential_force"])
    sim.energies(), sim.measures(), sim.positions
    assert np.shares_memory(before["force"], sim.contacts()["force"]), "nothing has changed"
    sim.step(20)
    after = sim.contacts()
    assert not np.array_equal(before["overlap"], after["overlap"])
    for name, array in before.items():
        assert not np.shares_memory(array, after[name]) and np.array_equal(array, copies[name])
    sim.velocities = np.zeros((50, 3))
    assert not np.shares_memory(after["force"], sim.contacts()["force"]), "forces were found anew"
    del sim, again, after
    gc.collect()
    assert all(np.array_equal(array, copies[name]) for name, array in before.items())


def test_contacts_of_a_callback_outlive_it(bed):
    sim = demeter.Simulation(bed)
    kept = []
    sim.every("2 ms", lambda s: kept.append((s.contacts()["overlap"], s.contacts()["overlap"].copy())))
    sim.run()
    assert len(kept) > 5 and all(np.array_equal(shown, then) for shown, then in kept)
    assert demeter.Simulation(bed).contacts()["force"].shape[1] == 3


def test_progress_is_told(bed, capsys, monkeypatch):
    bed["stage"][0]["duration"] = "60 s"
    sim = demeter.Simulation(bed)
    told = []
    enough = sim.every("1 ms", lambda s: s.stop() if len(told) > 2 else None)
    assert not sim.run(progress=told.append)
    sim.cancel(enough)
    last = told[-1]
    assert last["stage"] == "settle" and (last["stage_number"], last["stages"]) == (1, 2)
    assert 0 < last["step"] < last["steps"] and last["grains"] == 50 and last["time"] == pytest.approx(last["step"] * sim.dt)
    assert last["steps_per_second"] > 0 and last["seconds_left"] > 0 and told[0]["elapsed"] < last["elapsed"]
    bar = Bar()
    bar(last)
    bar.close()
    line = capsys.readouterr().err
    assert "settle (1/2)" in line and line.endswith("left\n")
    closed = []
    monkeypatch.setattr(Bar, "close", lambda bar: closed.append(bar))
    sim.run_until(sim.time + 1e-4, progress=True)
    assert len(closed) == 1
    with pytest.raises(TypeError, match="progress"):
        sim.run(progress=3)

    def fails(place):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        sim.run(progress=fails)
    sim.run_until(sim.time + 1e-4, progress=False)


def test_a_wall_moves_as_a_function_tells(bed):
    sim = demeter.Simulation(bed)
    start = sim.walls["plate"]["position"][2]
    sim.move_wall("plate", position=lambda t: (0, 0, -0.01 * np.sin(100 * t)))
    sim.step(1000)
    plate = sim.walls["plate"]
    assert plate["position"][2] - start == pytest.approx(-0.01 * np.sin(100 * sim.time), abs=1e-12)
    assert plate["velocity"][2] == pytest.approx(-np.cos(100 * sim.time), rel=1e-4)
    sim.move_wall("plate", angular_velocity=lambda t: 2.0, axis=(0, 0, 1), point=(0.01, 0.01, 0))
    sim.step(10)
    assert sim.walls["plate"]["angular_velocity"][2] == 2.0
    with pytest.raises(KeyError, match="known are `box`, `plate`"):
        sim.move_wall("lid", velocity=lambda t: (0, 0, 0))
    with pytest.raises(TypeError, match="give one"):
        sim.move_wall("plate")
    with pytest.raises(TypeError, match="axis"):
        sim.move_wall("plate", angle=lambda t: t)
    with pytest.raises(TypeError, match="three numbers"):
        sim.move_wall("plate", velocity=lambda t: 3)
    with pytest.raises(ZeroDivisionError):
        sim.move_wall("plate", velocity=lambda t: 1 / 0)


def test_the_interpreter_is_free_and_other_threads_are_refused(bed):
    sim = demeter.Simulation(bed)
    refused, ticks = [], 0
    worker = threading.Thread(target=sim.run)
    worker.start()
    while worker.is_alive():
        ticks += 1
        try:
            sim.positions
        except demeter.RunError as error:
            refused.append(error)
        time.sleep(0.001)
    worker.join()
    assert ticks > 1 and sim.finished
    assert all("middle of a step" in str(error) and "other threads" in str(error) for error in refused)


def test_ctrl_c(bed, tmp_path):
    # a process that was started in the background does not hear it by itself
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        interrupted(bed, tmp_path)
    finally:
        signal.signal(signal.SIGINT, before)


def interrupted(bed, tmp_path):
    bed["stage"][0]["duration"] = "60 s"
    sim = demeter.Simulation(bed, out=tmp_path / "run")
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    sim.every(10, lambda s: timer.start() if s.steps == 10 else None)
    with pytest.raises(KeyboardInterrupt):
        sim.run()
    steps = sim.steps
    assert steps > 0 and (tmp_path / "run" / "checkpoint.latest").is_file()
    sim.step(5)
    assert sim.steps == steps + 5


def test_rows_that_a_finished_run_lacks_are_told(bed, tmp_path, caplog):
    folder = tmp_path / "run"
    demeter.Simulation(bed, out=folder).run()
    rows = len(demeter.read_series(folder)["step"])
    assert not caplog.records
    lines = (folder / "series.csv").read_text().splitlines(keepends=True)
    (folder / "series.csv").write_text("".join(lines[:6]))
    assert len(demeter.read_series(folder)["step"]) == 5 < rows
    assert len(caplog.records) == 1 and "rows are missing" in caplog.text and "series.csv" in caplog.text


def test_folders_series_frames_and_resume(bed, tmp_path):
    folder = tmp_path / "run"
    sim = demeter.Simulation(bed, out=folder)
    sim.run_until("12 ms")
    sim.checkpoint()
    positions, indices = sim.positions, sim.indices()
    with pytest.raises(demeter.OutputError):
        demeter.Simulation.resume(folder)
    sim.run()
    final = sim.positions[sim.indices()]
    series = sim.series()
    assert list(series) == list(demeter.read_series(folder)) and len(series["time [s]"]) >= 31
    assert set(series["stage"]) == {"settle", "press"}
    assert len(demeter.frames(folder)) >= 7
    frame = demeter.read_frame(folder)
    assert frame["time"] == pytest.approx(sim.time) and frame["grains"]["points"].shape == (50, 3)
    assert np.array_equal(np.sort(frame["grains"]["id"]), np.arange(1, 51))
    with pytest.raises(IndexError):
        demeter.read_frame(folder, 99)
    del sim, positions, indices
    gc.collect()
    with pytest.raises(demeter.OutputError, match="holds a run|overwrite"):
        demeter.Simulation(bed, out=folder)
    half = demeter.Simulation(bed)
    half.run_until("12 ms")
    saved = half.checkpoint(tmp_path / "half")
    resumed = demeter.resume(saved)
    assert np.array_equal(resumed.positions[resumed.indices()], final)
    saved = half.checkpoint(tmp_path / "longer")
    scenario = tmp_path / "longer" / "scenario.toml"
    scenario.write_text(scenario.read_text() + '\n[[stage]]\nname = "more"\nsteps = 10\n')
    with pytest.raises(demeter.RunError, match="changed=True"):
        demeter.resume(saved)
    longer = demeter.resume(saved, changed=True)
    assert longer.time > resumed.time and len(longer.positions) == 50
    with pytest.raises(demeter.Error):
        demeter.Simulation.resume(tmp_path / "nowhere")


@pytest.mark.parametrize(
    "motion",
    [
        {"position": lambda t: (0, 0, 0.05 - 0.01 * np.sin(100 * t))},
        {"velocity": lambda t: (0, 0, -np.cos(100 * t))},
        {"angle": lambda t: 1.0 + 0.1 * np.sin(300 * t), "axis": (0, 0, 1), "point": (0.01, 0.01, 0)},
        {"angular_velocity": lambda t: 3 * np.cos(300 * t), "axis": (0, 0.6, 0.8)},
    ],
    ids=lambda motion: next(iter(motion)),
)
def test_a_motion_told_again_after_a_restart_goes_on_to_the_same_bits(bed, tmp_path, motion):
    def state(sim):
        plate = sim.walls["plate"]
        return [sim.positions[sim.indices()], plate["position"], plate["velocity"], plate["angular_velocity"]]

    sim = demeter.Simulation(bed)
    sim.step(37)
    sim.move_wall("plate", **motion)
    sim.step(1200)
    sim.checkpoint(tmp_path / "saved")
    sim.checkpoint(tmp_path / "late")
    sim.step(800)
    resumed = demeter.Simulation.resume(tmp_path / "saved")
    resumed.move_wall("plate", **motion)
    resumed.step(800)
    assert all(np.array_equal(*pair) for pair in zip(state(sim), state(resumed)))
    # told in a step that is not the first, it begins where the wall stands
    late = demeter.Simulation.resume(tmp_path / "late")
    late.step(1)
    before = late.walls["plate"]["position"]
    late.move_wall("plate", **motion)
    assert np.array_equal(late.walls["plate"]["position"], before)


def test_a_resumed_run_says_what_it_lacks(bed, tmp_path):
    def push(state):
        return np.tile([0, 0, 1e-4], (len(state), 1))

    sim = demeter.Simulation(bed)
    sim.add_force(push)
    sim.move_wall("plate", velocity=lambda t: (0, 0, -0.1))
    sim.step(200)
    sim.checkpoint(tmp_path / "saved")
    sim.step(200)
    resumed = demeter.Simulation.resume(tmp_path / "saved")
    told = " ".join(resumed.messages)
    assert "custom force" in told and "`plate`" in told
    resumed.add_force(push)
    resumed.step(200)
    assert np.array_equal(sim.velocities[sim.indices()], resumed.velocities[resumed.indices()])


def test_a_fault_has_its_message(bed):
    bed["simulation"]["max_overlap"] = 1e-6
    with pytest.raises(demeter.Fault, match="overlaps") as caught:
        demeter.run(bed)
    assert caught.value.grain > 0 and isinstance(caught.value, demeter.RunError)


def test_functions_that_are_asked_no_more_are_let_go(bed):
    sim = demeter.Simulation(bed)

    def push():
        return lambda state: np.zeros((len(state), 3))

    def lift():
        return lambda t: (0, 0, 0)

    alive = []
    for _ in range(5):
        force, motion = push(), lift()
        alive += [weakref.ref(force), weakref.ref(motion)]
        sim.clear_forces()
        sim.add_force(force)
        sim.move_wall("plate", velocity=motion)
        sim.step(2)
    del force, motion
    gc.collect()
    sim.step(1)
    assert sum(function() is not None for function in alive) == 2


def test_fixed_grains_stay_and_images_are_brought_back(bed):
    bed["domain"] = {"lower": [0, 0, -1], "upper": [0.02, 0.02, 1], "periodic": ["x", "y"]}
    bed["wall"] = [{"name": "plate", "material": "glass", "shape": "plane", "point": [0, 0, 0], "normal": "z"}]
    bed["grains"].append({"material": "glass", "source": "list", "positions": [[0.01, 0.01, 0.5]], "diameter": "2 mm", "fixed": True})
    sim = demeter.Simulation(bed)
    assert sim.fixed.sum() == 1 and sim.fixed.dtype == bool
    at = int(np.flatnonzero(sim.fixed)[0])
    sim.velocities = np.tile([0, 0, 1.0], (len(sim.ids), 1))
    sim.angular_velocities = np.ones((len(sim.ids), 3))
    assert sim.velocities[at].tolist() == [0, 0, 0] and sim.angular_velocities[at].tolist() == [0, 0, 0]
    assert (sim.velocities[~sim.fixed] == [0, 0, 1]).all()
    sim.positions = sim.positions + [0.14, -0.06, 0]
    sim.step(10)
    inside = sim.positions[:, :2]
    assert (inside >= -0.001).all() and (inside <= 0.021).all()


def test_a_checkpoint_may_take_the_place_of_another(bed, tmp_path):
    sim = demeter.Simulation(bed)
    for steps in [10, 20]:
        sim.step(10)
        sim.checkpoint(tmp_path / "saved", overwrite=True)
        assert demeter.Simulation.resume(tmp_path / "saved").steps == steps
    with pytest.raises(demeter.Error, match="overwrite"):
        sim.checkpoint(tmp_path / "saved")


def test_threads(bed):
    for threads in [0, 5000, 10**30]:
        with pytest.raises(demeter.WrongValue, match="threads"):
            demeter.Simulation(bed, threads=threads)


def test_pandas(bed):
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(demeter.run(bed).series())
    assert len(table) >= 31 and table["energy residual"].abs().max() < 1e-2
