"""What `contacts()` costs: the first call in a state, which puts the table together, and further ones, which show it again.

    pip install .
    python benches/contacts.py [--grains 100000] [--threads 2] [--rounds 10]
"""

import argparse
import math
import statistics
import time

import demeter


def pressed(grains):
    """Grains on a lattice that is a little closer than they are wide: all touch their neighbours from the first step on."""
    side = (math.ceil(grains ** (1 / 3)) + 2) * 1.9e-3
    return demeter.Scenario.from_dict(
        {
            "simulation": {"max_overlap": 0.3},
            "material": {"bead": {"young_modulus": "1 MPa", "poisson_ratio": 0.25, "density": 2500.0}},
            "contact": {
                "normal": {"law": "hertz-tsuji", "restitution": 0.5},
                "tangential": {"law": "mindlin-history", "friction": 0.5},
            },
            "grains": [
                {
                    "material": "bead",
                    "source": "lattice",
                    "lattice": "simple-cubic",
                    "spacing": "1.9 mm",
                    "diameter": "2 mm",
                    "region": {"shape": "box", "lower": [0, 0, 0], "upper": [side, side, side]},
                    "count": grains,
                }
            ],
            "wall": [{"name": "floor", "material": "bead", "shape": "plane", "point": [0, 0, 0], "normal": [0, 0, 1]}],
            "stage": [{"duration": 1.0}],
        }
    )


def milliseconds(call):
    start = time.perf_counter()
    call()
    return 1e3 * (time.perf_counter() - start)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grains", type=int, default=100_000)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--rounds", type=int, default=10)
    arguments = parser.parse_args()
    sim = demeter.Simulation(pressed(arguments.grains), threads=arguments.threads)
    first, again = [], []
    for _ in range(arguments.rounds):
        sim.step()
        first.append(milliseconds(sim.contacts))
        again.append(milliseconds(sim.contacts))
    count = len(sim.contacts()["i"])
    print(f"{len(sim)} grains, {count} contacts, {arguments.threads} threads")
    for name, times in (("first call in a state", first), ("second call", again)):
        print(f"{name:>22}: {statistics.median(times):8.3f} ms (median of {len(times)}; {min(times):.3f} to {max(times):.3f})")


if __name__ == "__main__":
    main()
