"""Scenarios from dicts and texts, and what is said of wrong ones."""

import pickle

import numpy as np
import pytest

import demeter


def test_a_dict_and_its_toml_are_the_same_scenario(bed):
    scenario = demeter.Scenario.from_dict(bed)
    again = demeter.Scenario.from_toml(scenario.to_toml())
    assert scenario.check() == again.check()
    assert scenario.title == "A small bed" and scenario.stages == ["settle", "press"]
    assert pickle.loads(pickle.dumps(scenario)).to_toml() == scenario.to_toml()


def test_numpy_and_tuples_serve(bed):
    bed["wall"][1]["point"] = np.array([0, 0, 0.07])
    bed["simulation"]["gravity"] = (0.0, np.float64(0.0), -9.81)
    bed["grains"][0]["count"] = np.int32(5)
    assert demeter.Scenario.from_dict(bed).check()["grains"] == 5


def test_all_faults_come_at_once_with_their_paths(bed):
    bed["stage"][0]["duration"] = "20 mm"
    bed["wall"][1]["normel"] = "z"
    bed["material"]["glass"]["density"] = -1
    with pytest.raises(demeter.ScenarioError) as caught:
        demeter.Scenario.from_dict(bed)
    paths = {fault["path"] for fault in caught.value.faults}
    assert paths >= {"stage[0].duration", "wall[1].normel", "material.glass.density"}
    assert "did you mean `normal`?" in str(caught.value)
    assert isinstance(caught.value, demeter.Error)


def test_every_wrong_type_is_told_with_its_key_and_all_other_faults(bed):
    bed["grains"][0]["diameter"] = None
    bed["grains"][0]["region"]["lower"] = {0, 1, 2}
    bed["wall"][0]["upper"] = [0.02, 0.02, 2j]
    bed["stage"][1]["motion"]["plate"][3] = "a key that is no text"
    bed["seed"] = 2**70
    bed["stage"][0]["duration"] = "20 mm"
    with pytest.raises(demeter.ScenarioError) as caught:
        demeter.Scenario.from_dict(bed)
    faults = {fault["path"]: fault for fault in caught.value.faults}
    assert set(faults) == {
        "grains[0].diameter",
        "grains[0].region.lower",
        "wall[0].upper[2]",
        "stage[1].motion.plate",
        "seed",
        "stage[0].duration",
    }
    assert "is None; a scenario holds texts" in faults["grains[0].diameter"]["message"]
    assert "type set" in faults["grains[0].region.lower"]["message"]
    assert "type complex" in faults["wall[0].upper[2]"]["message"]
    assert "64 bits" in faults["seed"]["message"] and "keys are texts" in faults["stage[1].motion.plate"]["message"]
    assert all(fault["source"] == "dict" and fault["line"] > 0 for fault in faults.values())
    assert 'diameter = "None"' in str(caught.value)  # drawn with its line, as by the command line


def test_wrong_types_elsewhere(bed):
    with pytest.raises(demeter.ScenarioError) as caught:
        demeter.Scenario.from_dict(bed).set({"grains[0].count": None, "stage[0].duration": {1}})
    assert [fault["path"] for fault in caught.value.faults] == ["grains[0].count", "stage[0].duration"]
    with pytest.raises(demeter.ScenarioError, match="type object"):
        demeter.collide({"impact": {"velocity": object()}})
    with pytest.raises(TypeError, match="from_dict"):
        demeter.Scenario.from_toml(bed)
    with pytest.raises(TypeError, match="a path, a TOML text or a dict"):
        demeter.Simulation(3)


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(demeter.ScenarioError, match="no such file"):
        demeter.Scenario.from_toml(tmp_path / "none.toml")


def test_changes_are_put_in(bed):
    scenario = demeter.Scenario.from_dict(bed).set({"grains[0].count": 7, "stage[0].duration": "1 ms"})
    assert scenario.check()["grains"] == 7
    with pytest.raises(demeter.ScenarioError):
        scenario.set({"grains[0].cuont": 7})


def test_templates():
    assert "drum" in demeter.Scenario.templates()
    told = demeter.Scenario.template("settle", set={"grains[0].count": 20}).check()
    assert told["grains"] == 20 and told["fastest_impact"] > 0.1
    with pytest.raises(KeyError):
        demeter.Scenario.template("dram")


def test_quantities():
    assert demeter.si("23.3 kPa") == 23300.0
    assert demeter.si(2) == 2.0
    with pytest.raises(ValueError):
        demeter.si("2 mmm")


def test_a_scenario_stays_what_was_read(bed, tmp_path, monkeypatch):
    text = demeter.Scenario.from_dict(bed).to_toml()
    (tmp_path / "grains.csv").write_text("x y z diameter\n0.01 0.01 0.05 0.002\n")
    (tmp_path / "bed.toml").write_text(text + '\n[[grains]]\nmaterial = "glass"\nsource = "file"\nfile = "grains.csv"\n')
    monkeypatch.chdir(tmp_path)
    scenario = demeter.Scenario.from_toml("bed.toml")
    (tmp_path / "bed.toml").write_text("nothing of it is left")
    monkeypatch.chdir("/")
    changed = scenario.set({"seed": 2})
    assert changed.check()["grains"] == scenario.check()["grains"] == 51
    assert len(demeter.Simulation(changed).ids) == 51
