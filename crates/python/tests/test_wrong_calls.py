"""Calls that newcomers get wrong: each is refused with what, where, which value and what is allowed, and nothing is harmed."""

import copy
import multiprocessing
import pickle
import signal
import threading
from pathlib import Path

import numpy as np
import pytest

import demeter

GLASS = {"young_modulus": "1 MPa", "poisson_ratio": 0.25, "density": 2500.0}


@pytest.fixture
def sim(bed):
    return demeter.Simulation(bed, threads=1)


def zeros(state):
    return np.zeros((len(state), 3))


CALLS = {
    # name: what is called, the Python exception that it is, too, and what the message tells
    "steps that are no whole number": (lambda s: s.step(2.5), TypeError, ["`n`", "whole number", "2.5", "float"]),
    "steps as a text": (lambda s: s.step("10"), TypeError, ["`n`", "'10'", "str"]),
    "steps below zero": (lambda s: s.step(-1), ValueError, ["`n`", "-1", "from 0 on"]),
    "steps that are True": (lambda s: s.step(True), TypeError, ["`n`", "True"]),
    "more steps than there are numbers": (lambda s: s.step(10**30), ValueError, ["`n`", "1000000"]),
    "a time without its unit": (lambda s: s.run_until("0.02"), ValueError, ["`until`", '"0.02"', "no unit", "(s)"]),
    "a time with a wrong unit": (lambda s: s.run_until("20 mm"), ValueError, ["`until`", "time", '"20 mm"']),
    "a time with an unknown unit": (lambda s: s.run_until("20 msec"), ValueError, ["`until`", "msec", "time"]),
    "a time that is no number": (lambda s: s.run_until(float("nan")), ValueError, ["`until`", "NaN", "finite"]),
    "a time that never comes": (lambda s: s.run_until(float("inf")), ValueError, ["`until`", "inf", "finite"]),
    "a time before the beginning": (lambda s: s.run_until(-1), ValueError, ["`until`", "-1 s", "beginning"]),
    "a time that is a list": (lambda s: s.run_until([1]), TypeError, ["`until`", "[1]", "function"]),
    "a time that is over": (lambda s: s.step(5) or s.run_until(0.0), ValueError, ["`until`", "already", "sim.time +"]),
    "an end of a plain time": (lambda s: s.run_until("1 ms", at_most="2 ms"), TypeError, ["at_most", "function"]),
    "a callback that was called": (lambda s: s.every("1 ms", print()), None, []),
    "a callback that is no function": (lambda s: s.every("1 ms", 3), TypeError, ["`function`", "3", "no brackets"]),
    "a callback without a cadence": (lambda s: s.every(zeros, zeros), TypeError, ["`interval`", "(s)", "function"]),
    "a cadence of nothing": (lambda s: s.every(0, zeros), ValueError, ["`interval`", "0", "from 1 on"]),
    "a cadence below zero": (lambda s: s.every("-1 ms", zeros), ValueError, ["`interval`", "-0.001", "above 0"]),
    "a function that is not called": (lambda s: s.cancel(zeros), KeyError, ["not called", "every"]),
    "a force that is no function": (lambda s: s.add_force([0, 0, 1]), TypeError, ["`function`", "[0, 0, 1]"]),
    "a wall that is not there": (
        lambda s: s.move_wall("plaet", velocity=lambda t: (0, 0, 1)),
        KeyError,
        ["no wall `plaet`", "did you mean `plate`"],
    ),
    "a wall by its number": (lambda s: s.move_wall(1, velocity=lambda t: (0, 0, 1)), TypeError, ["`wall`", "1"]),
    "a motion that is no function": (lambda s: s.move_wall("plate", velocity=(0, 0, 1)), TypeError, ["`velocity`", "time"]),
    "two motions": (
        lambda s: s.move_wall("plate", velocity=lambda t: (0, 0, 1), position=lambda t: (0, 0, 1)),
        TypeError,
        ["give one of"],
    ),
    "a motion of one number": (lambda s: s.move_wall("plate", velocity=lambda t: t), TypeError, ["three numbers", "0.0"]),
    "a turn of three numbers": (
        lambda s: s.move_wall("plate", angle=lambda t: (0, 0, t), axis=(0, 0, 1)),
        TypeError,
        ["one number", "(0, 0, 0.0)"],
    ),
    "a motion that is not finite": (
        lambda s: s.move_wall("plate", velocity=lambda t: (0, 0, np.inf)),
        None,
        ["`plate`", "not finite"],
    ),
    "an axis without a direction": (
        lambda s: s.move_wall("plate", angle=lambda t: t, axis=(0, 0, 0)),
        ValueError,
        ["`axis`", "no direction"],
    ),
    "an axis in words": (lambda s: s.move_wall("plate", angle=lambda t: t, axis="z"), TypeError, ["`axis`", "'z'", "(0, 0, 1)"]),
    "an axis of two numbers": (lambda s: s.move_wall("plate", angle=lambda t: t, axis=(0, 1)), TypeError, ["`axis`", "(0, 1)"]),
    "a point in a wrong unit": (
        lambda s: s.move_wall("plate", angle=lambda t: t, axis=(0, 0, 1), point=("1 mm", 0, "1 s")),
        ValueError,
        ["`point`", "length", '"1 s"'],
    ),
    "an axis where nothing turns": (
        lambda s: s.move_wall("plate", velocity=lambda t: (0, 0, 0), axis=(0, 0, 1)),
        TypeError,
        ["no `axis`", "angle"],
    ),
    "positions of too few grains": (lambda s: setattr(s, "positions", s.positions[:-1]), ValueError, ["49", "50"]),
    "positions of two columns": (lambda s: setattr(s, "positions", s.positions[:, :2]), ValueError, ["(50, 2)", "(n, 3)"]),
    "positions in one row": (lambda s: setattr(s, "positions", np.zeros(150)), ValueError, ["(150,)", "(n, 3)"]),
    "complex positions": (lambda s: setattr(s, "positions", s.positions * 1j), TypeError, ["`positions`", "numbers"]),
    "positions as texts": (lambda s: setattr(s, "positions", [["1 mm"] * 3] * 50), TypeError, ["`positions`", "'1 mm'"]),
    "positions that are None": (lambda s: setattr(s, "positions", None), TypeError, ["`positions`", "None"]),
    "velocities that are not finite": (
        lambda s: setattr(s, "velocities", np.full((50, 3), np.nan)),
        ValueError,
        ["velocity", "grain", "NaN", "not finite"],
    ),
    "masked velocities": (
        lambda s: setattr(s, "velocities", np.ma.masked_less(np.full((50, 3), -1.0), 0.0)),
        ValueError,
        ["`velocities`", "masked", ".filled"],
    ),
    "a ragged list": (lambda s: setattr(s, "velocities", [[0, 0, 0], [0, 0]]), TypeError, ["`velocities`", "(n, 3)"]),
    "a grain that is not there": (lambda s: s.indices([51]), KeyError, ["no grain 51", "50 with ids from 1 to 50"]),
    "an id that is no list": (lambda s: s.indices(17), TypeError, ["`ids`", "17", "as [17]"]),
    "an id below zero": (lambda s: s.indices([-1]), ValueError, ["`ids`", "-1"]),
    "an id that is no whole number": (lambda s: s.indices([1.5]), TypeError, ["`ids`", "1.5"]),
    "a bar that is a number": (lambda s: s.run(progress=3), TypeError, ["`progress`", "3", "True"]),
    "a checkpoint of a run without a folder": (lambda s: s.checkpoint(), None, ["folder"]),
    "a checkpoint at a number": (lambda s: s.checkpoint(3.5), TypeError, ["`folder`", "3.5"]),
    "a copy": (lambda s: copy.deepcopy(s), TypeError, ["copied", "sim.checkpoint(folder)"]),
    "a pickle": (lambda s: pickle.dumps(s), TypeError, ["pickled", "Simulation.resume"]),
}


@pytest.mark.parametrize("name", CALLS)
def test_a_wrong_call_is_refused_and_harms_nothing(sim, name):
    call, of_python, words = CALLS[name]
    if name == "a callback that was called":
        call(sim)  # a decorator, then
        return
    with pytest.raises(demeter.Error) as caught:
        call(sim)
    told = str(caught.value)
    for word in words:
        assert word in told, told
    if of_python is not None:
        assert isinstance(caught.value, of_python) and isinstance(caught.value, demeter.ArgumentError)
    assert not told.startswith(("'", '"')), "as a message, not in the quotes of a KeyError"
    sim.step(2)
    assert np.isfinite(sim.positions).all()


WITHOUT_A_RUN = {
    "a scenario that is a number": (lambda p: demeter.run(3), TypeError, ["a path, a TOML text or a dict", "3"]),
    "a scenario that is None": (lambda p: demeter.Simulation(None), TypeError, ["None"]),
    "a file that is not there": (lambda p: demeter.run("drum.tml"), None, ["drum.tml", "no such file"]),
    "a folder for a scenario": (lambda p: demeter.run(p), None, [str]),
    "a text that is no TOML": (lambda p: demeter.run("grains = ["), None, ["text"]),
    "threads as a text": (lambda p: demeter.run({}, threads="all"), TypeError, ["`threads`", "'all'"]),
    "no threads": (lambda p: demeter.run({}, threads=0), ValueError, ["`threads`", "0", "from 1 on"]),
    "overwrite as a text": (lambda p: demeter.run({}, overwrite="yes"), TypeError, ["`overwrite`", "'yes'", "True or False"]),
    "an out without a name": (lambda p: demeter.run({}, out=""), ValueError, ["`out`", "''", "path"]),
    "an out that is a number": (lambda p: demeter.run({}, out=3), TypeError, ["`out`", "path"]),
    "a template that is not there": (lambda p: demeter.Scenario.template("dram"), KeyError, ["`dram`", "did you mean `drum`"]),
    "a template that is a number": (lambda p: demeter.Scenario.template(1), TypeError, ["`name`", "1"]),
    "a dict for from_toml": (lambda p: demeter.Scenario.from_toml({}), TypeError, ["from_dict"]),
    "a path for from_dict": (lambda p: demeter.Scenario.from_dict("a.toml"), TypeError, ["`tables`", "a dict", "from_toml"]),
    "changes that are a list": (
        lambda p: demeter.Scenario.template("settle", set=["seed=3"]),
        TypeError,
        ["`set`", "a dict", "grains[0].count"],
    ),
    "a change whose key is a number": (lambda p: demeter.Scenario.template("settle", set={1: 2}), TypeError, ["keys of `set`", "1"]),
    "a change of a key that is misspelt": (
        lambda p: demeter.Scenario.template("settle", set={"grains[0].cuont": 2}),
        None,
        ["cuont", "did you mean `count`"],
    ),
    "a series of no run": (lambda p: demeter.read_series(p / "none"), None, ["none"]),
    "frames of a folder that is no run": (lambda p: demeter.frames(p), None, ["not the folder of a Demeter run"]),
    "a frame of no run": (lambda p: demeter.read_frame(p / "none"), None, ["none"]),
    "resume of no run": (lambda p: demeter.resume(p), None, ["not the folder of a Demeter run"]),
    "a number for a folder": (lambda p: demeter.read_series(3.0), TypeError, ["`folder`", "3.0"]),
    "a law that is not there": (lambda p: demeter.laws("hertz-tusji"), KeyError, ["`hertz-tusji`", "did you mean `hertz-tsuji`"]),
    "a law that is a number": (lambda p: demeter.laws(3), TypeError, ["`name`", "3"]),
    "a mass in metres": (
        lambda p: demeter.damped_spring("hertz", mass="1 m", velocity=1, restitution=0.5, stiffness=1),
        ValueError,
        ["`mass`", "mass", '"1 m"', "(kg)"],
    ),
    "a spring that is not there": (
        lambda p: demeter.damped_spring("herz", mass=1, velocity=1, restitution=0.5, stiffness=1),
        ValueError,
        ['"herz"', '"hertz"'],
    ),
    "a restitution as a word": (
        lambda p: demeter.damped_spring("hertz", mass=1, velocity=1, restitution="high", stiffness=1),
        ValueError,
        ["`restitution`", "high"],
    ),
    "a linear stiffness of a Hertzian spring": (
        lambda p: demeter.damped_spring("hertz", mass=1, velocity=1, restitution=0.5, stiffness="1 kN/m"),
        ValueError,
        ["`stiffness`", "stiffness of a Hertzian contact", '"1 N/m^1.5"', '"1 kN/m"'],
    ),
    "a spring beyond all numbers": (
        lambda p: demeter.damped_spring("linear", mass=1e300, velocity=1e300, restitution=0.5, stiffness=1e-300),
        demeter.CollisionError,
        ["contact time [s]", "finite"],
    ),
    "a truth for a quantity": (lambda p: demeter.si(True), TypeError, ["True"]),
    "a unit that is not there": (lambda p: demeter.si("2 mmm"), ValueError, ["mmm"]),
    "a quantity that is None": (lambda p: demeter.si(None), TypeError, ["None"]),
    "bodies without a law": (lambda p: demeter.collide({}), None, ["dict"]),
    "too many moments": (lambda p: demeter.collide("a = 1", course=10**12), ValueError, ["`course`", "at most"]),
    "radii that fall": (lambda p: demeter.sticking("a = 1", ("2 um", "1 um")), None, []),
    "a run to compare that is not there": (lambda p: demeter.compare(p / "a", p / "b"), None, ["a"]),
    "nothing to compare": (lambda p: demeter.compare([], p / "b"), ValueError, ["`runs`", "empty"]),
    "a task that is not there": (lambda p: demeter.fit("mcc.tml"), None, ["mcc.tml", "no such file"]),
}


@pytest.mark.parametrize("name", WITHOUT_A_RUN)
def test_a_wrong_call_without_a_run_is_refused(tmp_path, name):
    call, of_python, words = WITHOUT_A_RUN[name]
    with pytest.raises(demeter.Error) as caught:
        call(tmp_path)
    told = str(caught.value)
    for word in words:
        assert (str(tmp_path) if word is str else word) in told, told
    if of_python is not None:
        assert isinstance(caught.value, of_python)


ANSWERS = {
    "not finite": (lambda s: np.full((len(s), 3), np.nan), demeter.Fault, ["grain", "not finite"]),
    "too few rows": (lambda s: np.zeros((3, 3)), demeter.WrongValue, ["(3, 3)", "(50, 3)", "state.ids"]),
    "one row": (lambda s: np.zeros(3), demeter.WrongValue, ["(3,)", "(n, 3)"]),
    "complex": (lambda s: zeros(s) + 1j, demeter.WrongType, ["`forces`"]),
    "a text": (lambda s: "down", demeter.WrongType, ["'down'"]),
    "a number": (lambda s: -9.81, demeter.WrongValue, ["()", "(n, 3)"]),
    "three arrays": (lambda s: (zeros(s), zeros(s), zeros(s)), demeter.WrongType, ["(forces, torques)"]),
    "torques of a wrong shape": (lambda s: (zeros(s), zeros(s)[:-1]), demeter.WrongValue, ["torques", "(49, 3)"]),
    "a generator": (lambda s: (x for x in range(3)), demeter.WrongType, ["generator"]),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_a_wrong_answer_of_a_force_is_told_and_the_run_can_go_on(sim, name):
    answer, error, words = ANSWERS[name]
    sim.add_force(answer)
    with pytest.raises(error) as caught:
        sim.step(10)
    for word in words:
        assert word in str(caught.value), str(caught.value)
    sim.clear_forces()
    sim.step(10)
    assert abs(sim.residual) < 1e-3


def test_a_force_cannot_reach_into_the_step_that_asks_it(sim):
    told = []

    def meddles(state):
        for reach in (lambda: sim.positions, lambda: sim.step(), sim.contacts, lambda: sim.checkpoint("x"), sim.close):
            with pytest.raises(demeter.RunError) as caught:
                reach()
            told.append(str(caught.value))
        return zeros(state)

    sim.add_force(meddles)
    sim.step(2)
    assert told and all("middle of a step" in text or "runs" in text for text in told)


def test_ctrl_c_in_a_force_comes_out_and_the_run_goes_on(sim):
    def interrupted(state):
        if state.step == 5:
            raise KeyboardInterrupt
        return zeros(state)

    sim.add_force(interrupted)
    with pytest.raises(KeyboardInterrupt):
        sim.step(10)
    sim.step(10)
    assert sim.steps == 15


def test_a_callback_may_add_and_cancel_callbacks(sim):
    calls = []

    def once(s):
        calls.append(s.steps)
        s.cancel(once)
        s.every(3, lambda s: calls.append(-s.steps))

    sim.every(2, once)
    sim.step(8)
    assert calls == [2, -5, -8]


def test_functions_that_compare_as_they_like_do_not_lock_the_list(sim):
    class Odd:
        def __call__(self, s):
            pass

        def __eq__(self, other):
            sim.every(1, print)
            raise ValueError("as it likes")

        __hash__ = None

    sim.every(10, Odd())
    with pytest.raises(demeter.UnknownName):
        sim.cancel(lambda s: None)


def test_an_error_tells_the_same_after_a_pickle(bed):
    bed["stage"][0]["duration"] = "20 mm"
    with pytest.raises(demeter.ScenarioError) as caught:
        demeter.run(bed)
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.faults == caught.value.faults
    with pytest.raises(demeter.UnknownName) as caught:
        demeter.laws("hertz")
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_a_simulation_is_closed_by_with(bed, tmp_path):
    folder = tmp_path / "run"
    with demeter.Simulation(bed, out=folder) as sim:
        sim.run_until("2 ms")
        rows = len(sim.series()["step"])
        with pytest.raises(demeter.OutputError, match=r"sim\.close\(\)"):
            demeter.Simulation(bed, out=folder, overwrite=True)
    assert sim.positions.shape == (50, 3), "its state stays"
    for goes_on in (sim.step, sim.run, sim.checkpoint, sim.series, lambda: sim.run_until(lambda s: True), sim.__enter__):
        with pytest.raises(demeter.RunError, match=r"was closed.*Simulation\.resume"):
            goes_on()
    assert len(demeter.read_series(folder)["step"]) == rows > 1
    again = demeter.Simulation(bed, out=folder, overwrite=True)
    with pytest.raises(ZeroDivisionError), again:
        1 / 0
    sim.close()


def test_a_cell_of_a_notebook_can_be_run_again(bed, tmp_path):
    for _ in range(2):
        sim = demeter.run(bed, out=tmp_path / "run", overwrite=True)
    sim.checkpoint()
    other = demeter.resume(tmp_path / "run")
    assert other.steps == sim.steps
    with pytest.raises(demeter.OutputError, match="overwrite=True"):
        demeter.run(bed, out=tmp_path / "run")


def test_after_the_end_all_is_there(bed):
    sim = demeter.run(bed)
    steps = sim.steps
    assert sim.run() and sim.steps == steps and not sim.run_stage() and sim.stage is None
    assert not sim.run_until(lambda s: False)
    sim.step(2)
    assert sim.steps == steps + 2 and sim.finished


def test_after_a_fault_the_run_says_so_again(bed):
    bed["simulation"]["max_overlap"] = 1e-6
    sim = demeter.Simulation(bed)
    for _ in range(2):
        with pytest.raises(demeter.Fault, match="overlaps"):
            sim.run()
    assert np.isfinite(sim.positions).all() and len(sim.contacts()["i"]) >= 0
    # and does not step over what its model does not cover
    steps = sim.steps
    with pytest.raises(demeter.Fault, match="overlaps"):
        sim.step(10)
    assert sim.steps == steps and not sim.finished
    # until somebody changed it
    sim.velocities = sim.velocities * 0.5
    with pytest.raises(demeter.Fault, match="overlaps"):
        sim.step(10)
    assert sim.steps > steps


def test_arrays_of_before_stay_when_grains_come(bed):
    bed["grains"] = []
    bed["feed"] = [
        {
            "name": "rain",
            "material": "glass",
            "diameter": "4 mm",
            "from": {"shape": "rectangle", "center": [0.01, 0.01, 0.06], "half_u": [0.006, 0, 0], "half_v": [0, 0.006, 0]},
            "velocity": [0, 0, -0.5],
            "number_rate": "2000 1/s",
        }
    ]
    sim = demeter.Simulation(bed)
    before = sim.positions
    sim.run_until("10 ms")
    assert len(before) == 0 and len(sim.positions) == len(sim) > 3
    old = sim.positions
    sim.run_until("15 ms")
    with pytest.raises(demeter.WrongValue, match=f"{len(old)} vectors for {len(sim)} grains"):
        sim.positions = old


def in_a_fork(queue, sim):
    try:
        sim.step()
    except demeter.RunError as error:
        queue.put(str(error))
    queue.put(demeter.sticking(*STICKING)["velocity"].tolist())


STICKING = (
    {
        "material": {"mcc": {"young_modulus": "6 GPa", "poisson_ratio": 0.3, "density": 1500}},
        "a": {"material": "mcc", "radius": 5e-3},
        "b": {"material": "mcc", "radius": 5e-3},
        "contact": {"normal": {"law": "jkr", "work_of_adhesion": "0.1 N/m"}},
        "impact": {"velocity": 1.0},
    },
    ("0.1 um", "1 um"),
)


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_fork_is_told_that_the_threads_are_missing_and_does_not_hang(sim):
    here = demeter.sticking(*STICKING)["velocity"].tolist()
    sim.step()
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=in_a_fork, args=(queue, sim), daemon=True)
    child.start()
    assert "fork" in queue.get(timeout=60) and queue.get(timeout=60) == here
    child.join(60)
    assert child.exitcode == 0
    sim.step()


def test_ctrl_c_ends_a_fit_of_runs(tmp_path):
    squeeze = Path(__file__).parents[2] / "demeter/src/calibrate/packing/squeeze.toml"
    slow = {"stage[0].stage[0].duration": "1000 s", "stage[0].stage[0].motion.top.velocity": "0 0 -1 um/s", "output.series": "1 s"}
    long = demeter.Scenario.from_toml(squeeze, set=slow)
    (tmp_path / "long.toml").write_text(long.to_toml(), "utf-8")
    task = {
        "packing": {
            "scenario": str(tmp_path / "long.toml"),
            "unknown": {"key": "material.gel.young_modulus", "from": "30 kPa", "to": "70 kPa"},
            "match": "top",
            "unload": False,
            "measured": {"loading": [[0.1, 1.0]]},
        }
    }
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
    try:
        with pytest.raises(KeyboardInterrupt):
            timer.start()
            demeter.fit(task, out=tmp_path / "trials")
            timer.join()
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)


def test_everything_has_its_help():
    for name in demeter.demeter.__all__:
        thing = getattr(demeter, name)
        assert name.startswith("__") or (thing.__doc__ or "").strip(), name
        for member in dir(thing) if isinstance(thing, type) and not issubclass(thing, BaseException) else []:
            if not member.startswith("_"):
                assert (getattr(thing, member).__doc__ or "").strip(), f"{name}.{member}"
