"""What tests share: a small bed, and whether two runs of it are the same."""

import copy

import numpy as np
import pytest

BED = {
    "title": "A small bed",
    "simulation": {"gravity": [0, 0, -50.0], "max_overlap": 0.3},
    "material": {"glass": {"young_modulus": "1 MPa", "poisson_ratio": 0.25, "density": 2500.0}},
    "contact": {
        "normal": {"law": "hertz-tsuji", "restitution": 0.7},
        "tangential": {"law": "mindlin-history", "friction": 0.4},
    },
    "grains": [
        {
            "material": "glass",
            "source": "random",
            "count": 50,
            "diameter": "4 mm",
            "region": {"shape": "box", "lower": [0, 0, 0], "upper": [0.02, 0.02, 0.02]},
        }
    ],
    "wall": [
        {
            "name": "box",
            "material": "glass",
            "shape": "box",
            "lower": [0, 0, 0],
            "upper": [0.02, 0.02, 0.08],
        },
        {
            "name": "plate",
            "material": "glass",
            "shape": "plane",
            "point": [0, 0, 0.07],
            "normal": "-z",
        },
    ],
    "stage": [
        {"name": "settle", "duration": 0.02},
        {"name": "press", "duration": "10 ms", "motion": {"plate": {"velocity": [0, 0, -0.2]}}},
    ],
    "output": {"series": "1 ms", "frames": "5 ms"},
}


@pytest.fixture
def bed():
    return copy.deepcopy(BED)


def same(one, other):
    return np.array_equal(one.positions, other.positions) and np.array_equal(one.ids, other.ids)
