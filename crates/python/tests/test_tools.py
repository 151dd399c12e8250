"""Two bodies, fits, comparisons and closed forms."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import demeter

MCC = {
    "material": {"mcc": {"young_modulus": "6 GPa", "poisson_ratio": 0.3, "density": 1500}},
    "a": {"material": "mcc", "radius": 5e-3},
    "b": {"material": "mcc", "radius": "5 mm"},
    "contact": {"normal": {"law": "hertz-tsuji", "restitution": 0.54}},
    "impact": {"velocity": 1.0},
}


def test_collide():
    report = demeter.collide(MCC, course=101)
    assert report["restitution"] == pytest.approx(0.54, rel=1e-9) and report["outcome"] == "rebound"
    assert report["course"]["force"].max() == pytest.approx(report["max_force"], rel=1e-2)
    slower = demeter.collide(MCC, set={"impact.velocity": "0.1 m/s"})
    assert slower["contact_time"] > report["contact_time"]
    assert demeter.collide(MCC, engine=True)["restitution"] == pytest.approx(0.54, abs=1e-4)
    by_steps = demeter.collide(MCC, engine=True, course=11)["course"]
    assert len(by_steps["time"]) == 11 and by_steps["time"][-1] > 0.9 * report["contact_time"]
    with pytest.raises(demeter.WrongValue, match="points"):
        demeter.sticking(MCC, ("1 um", "2 um"), points=1)


def test_an_oblique_collision_slides_or_sticks_as_rigid_bodies_do():
    bodies = {
        "material": {"glass": {"young_modulus": "70 GPa", "poisson_ratio": 0.22, "density": 2500}},
        "a": {"material": "glass", "radius": "2.5 mm"},
        "b": {"material": "glass", "wall": True},
        "contact": {
            "normal": {"law": "hertz-tsuji", "restitution": 0.98},
            "tangential": {"law": "mindlin-history", "friction": 0.09},
        },
        "impact": {"velocity": 2, "angle": np.pi / 3},
    }
    report = demeter.collide(bodies)
    # sliding all the time: friction takes mu times the change of the normal velocity
    normal, along = 2 * np.cos(np.pi / 3), 2 * np.sin(np.pi / 3)
    assert report["restitution"] == pytest.approx(0.98, rel=1e-3)
    assert -report["tangential_restitution"] == pytest.approx(1 - 0.09 * 1.98 * normal / along * 7 / 2, rel=1e-2)
    head_on = demeter.collide(bodies, set={"impact.angle": 0})
    assert head_on["restitution"] == pytest.approx(0.98, rel=1e-6)
    told = demeter.collide(bodies, set={"impact.angle": "60 deg"})
    assert told["restitution"] == report["restitution"]


def test_the_closed_form_is_what_the_collision_shows():
    report = demeter.collide(MCC)
    mass = 1500 * 4 / 3 * np.pi * 5e-3**3 / 2
    effective = 6e9 / (1 - 0.3**2) / 2
    spring = demeter.damped_spring(
        "hertz", mass=mass, velocity="1 m/s", restitution=0.54, stiffness=4 / 3 * effective * np.sqrt(2.5e-3)
    )
    for name in ("contact_time", "max_overlap", "max_force"):
        assert spring[name] == pytest.approx(report[name], rel=1e-6)
    told = demeter.damped_spring("hertz", mass=mass, velocity=1, restitution=0.54, stiffness=f"{spring['stiffness']} N/m^1.5")
    assert told == spring
    back = demeter.damped_spring(
        "hertz", mass=mass, velocity=1, contact_time=spring["contact_time"], max_overlap=spring["max_overlap"]
    )
    assert back["restitution"] == pytest.approx(0.54, rel=1e-9)
    with pytest.raises(TypeError, match="give `restitution`"):
        demeter.damped_spring("linear", mass=1, velocity=1, restitution=0.5)
    with pytest.raises(ValueError, match="`mass` must be a mass"):
        demeter.damped_spring("linear", mass="1 m", velocity=1, restitution=0.5, stiffness=1)


@pytest.mark.parametrize(
    ("told", "word"),
    [
        ({"restitution": 1.1}, "restitution is 1.1"),
        ({"restitution": 0}, "restitution is 0"),
        ({"restitution": float("nan")}, "restitution is NaN"),
        ({"mass": -1}, "`mass` is -1"),
        ({"velocity": 0}, "`velocity` is 0"),
        ({"stiffness": "-1 kN/m"}, "`stiffness` is -1000"),
        ({"stiffness": None, "contact_time": float("inf")}, "`contact_time` is inf"),
    ],
)
def test_a_wrong_value_of_a_damped_spring_is_a_wrong_argument(told, word):
    given = {"mass": 1, "velocity": 1, "restitution": 0.5, "stiffness": 1000} | told
    given = {name: value for name, value in given.items() if value is not None}
    with pytest.raises(demeter.WrongValue, match=word):
        demeter.damped_spring("linear", **given)


@pytest.mark.parametrize("law", ["linear", "hertz"])
def test_a_spring_without_loss_has_a_damping_of_zero(law):
    damping = demeter.damped_spring(law, mass=1, velocity=1, restitution=1, stiffness=1)["damping"]
    assert str(damping) == "0.0"


def test_contact_curve():
    curve = demeter.contact_curve(MCC)
    assert set(curve["branch"]) >= {"load", "unload"}
    assert curve["force"].max() > 0 and len(curve["force"]) == len(curve["branch"])


def test_sticking():
    bodies = dict(MCC, contact={"normal": {"law": "jkr", "work_of_adhesion": "0.1 N/m"}})
    found = demeter.sticking(bodies, ("0.1 um", 1e-6), points=3)
    assert np.all(np.diff(found["velocity"]) < 0)
    for pair in (["0.1 um", "1 um"], np.array([1e-7, 1e-6])):
        assert np.array_equal(demeter.sticking(bodies, pair, points=3)["velocity"], found["velocity"])
    for one in ("1 um", np.float64(1e-6), np.array(1e-6)):
        assert len(demeter.sticking(bodies, one)["velocity"]) == 1
    with pytest.raises(demeter.WrongValue, match="a pair of the least and the largest"):
        demeter.sticking(bodies, [1e-7, 1e-6, 1e-5])
    with pytest.raises(ValueError, match="rise"):
        demeter.sticking(bodies, ("1 um", "0.1 um"))
    with pytest.raises(ValueError, match="at most 10000"):
        demeter.sticking(bodies, ("0.1 um", "1 um"), points=10_001)


IN_A_NEW_PROCESS = """
import signal, threading, demeter
signal.signal(signal.SIGINT, signal.default_int_handler)
bodies = {bodies!r}
threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
try:
    demeter.sticking(bodies, ("0.1 um", "1 um"), points=10_000)
except KeyboardInterrupt:
    print("interrupted")
"""


def test_ctrl_c_ends_a_search_for_sticking_speeds():
    """Where it comes before any array was made, too."""
    bodies = dict(MCC, contact={"normal": {"law": "jkr", "work_of_adhesion": "0.1 N/m"}})
    program = [sys.executable, "-c", IN_A_NEW_PROCESS.format(bodies=bodies)]
    done = subprocess.run(program, capture_output=True, text=True, timeout=100)
    assert done.stdout == "interrupted\n", done.stderr


def test_fit():
    task = {
        "material": MCC["material"],
        "a": MCC["a"],
        "b": MCC["b"],
        "fit": {
            "law": "hertz-tsuji",
            "unknown": {"restitution": "free", "material.mcc.young_modulus": ["0.1 GPa", "100 GPa"]},
        },
        "observation": [{"velocity": "1 m/s", "restitution": 0.54, "contact_time": 69.51e-6}],
    }
    report = demeter.fit(task)
    values = {parameter["name"]: parameter["value"] for parameter in report["parameters"]}
    assert values["restitution"] == pytest.approx(0.54)
    assert values["material.mcc.young_modulus"] == pytest.approx(6e9, rel=1e-2)
    with pytest.raises(TypeError, match="packing"):
        demeter.fit(task, out="runs")


def test_fit_of_a_packing(tmp_path):
    """The modulus of a squeezed packing is found again from the force at its largest compression."""
    scenario = Path(__file__).parents[2] / "demeter/src/calibrate/packing/squeeze.toml"
    series = demeter.run(demeter.Scenario.from_toml(scenario)).series()
    # as the fit does: the mean over the cycles of what is at the largest compression of each
    rows = range(len(series["stage"]))
    cycles = {stage: [k for k in rows if series["stage"][k] == stage] for stage in series["stage"] if stage.startswith("squeeze")}
    tops = [max(cycle, key=lambda k: series["strain"][k]) for cycle in cycles.values()]
    strain = sum(series["strain"][k] for k in tops) / len(tops)
    force = sum(series["wall top force z [N]"][k] for k in tops) / len(tops)
    task = {
        "packing": {
            "scenario": str(scenario),
            "unknown": {"key": "material.gel.young_modulus", "from": "30 kPa", "to": "70 kPa"},
            "match": "top",
            "unload": False,
            "measured": {"loading": [[strain, force]]},
        }
    }
    with pytest.raises(TypeError, match="`out` is missing"):
        demeter.fit(task)
    report = demeter.fit(task, out=tmp_path / "trials", threads=1)
    assert report["value"] == pytest.approx(50e3, abs=800)
    assert report["bracket"][0] <= report["value"] <= report["bracket"][1]
    assert 2 < len(report["trials"]) < 10 and len(list((tmp_path / "trials").iterdir())) >= len(report["trials"])
    task["packing"]["unknown"]["from"] = set()
    with pytest.raises(demeter.ScenarioError, match="type set"):
        demeter.fit(task, out=tmp_path / "trials")


def test_compare(bed, tmp_path):
    bed["stage"][1]["name"] = "squeeze"
    for count in (50, 55):
        bed["grains"][0]["count"] = count
        demeter.run(bed, out=tmp_path / str(count))
    told = demeter.compare(
        [tmp_path / "50"], tmp_path / "55", unload=None, force="-wall box force z"
    )
    value = told["runs"][0]["rtop"]["value"]
    assert 0.5 < value < 2 and value != 1
    assert len(told["runs"][0]["forces"]["run"]) > 3
    with pytest.raises(demeter.OutputError):
        demeter.compare(tmp_path / "none", tmp_path / "55")
    with pytest.raises(demeter.WrongType, match="`unload`.*5"):
        demeter.compare(tmp_path / "50", tmp_path / "55", unload=5)
    for threshold in ("threshold", "reference_threshold"):
        with pytest.raises(demeter.WrongValue, match=f"`{threshold}`.*finite"):
            demeter.compare(tmp_path / "50", tmp_path / "55", **{threshold: float("nan")})


def test_laws():
    names = {law["name"] for law in demeter.laws()}
    assert {"hertz-tsuji", "jkr", "coulomb"} <= names
    (law,) = demeter.laws("hertz-tsuji")
    assert "restitution" in {parameter["name"] for parameter in law["parameters"]}
    assert law["example"].startswith("normal = {")
    with pytest.raises(KeyError, match="hertz-tsuji"):
        demeter.laws("hertz")


def test_faults_of_bodies_are_those_of_the_command_line():
    with pytest.raises(demeter.ScenarioError, match="unknown key"):
        demeter.collide(dict(MCC, impcat={}))
