"""What a custom force costs in a step: time per step without one, with one that does nothing, and with a drag in NumPy.

    pip install .
    python benches/custom_force.py [--grains 1000 10000] [--steps 500] [--threads 1]
"""

import argparse
import time

import numpy as np

import demeter


def bed(grains):
    """Grains that have settled in a box, deep as it is wide."""
    side = (grains * 0.85e-9 * 1.3) ** (1 / 3)
    return demeter.Scenario.from_dict(
        {
            "simulation": {"gravity": [0, 0, -9.81], "max_overlap": 0.3},
            "material": {"glass": {"young_modulus": "1 MPa", "poisson_ratio": 0.25, "density": 2500.0}},
            "contact": {
                "normal": {"law": "hertz-tsuji", "restitution": 0.5},
                "tangential": {"law": "mindlin-history", "friction": 0.5},
            },
            "grains": [
                {
                    "material": "glass",
                    "source": "random",
                    "count": grains,
                    "diameter": "1 mm",
                    "region": {"shape": "box", "lower": [0, 0, 0], "upper": [side, side, 1.8 * side]},
                }
            ],
            "wall": [{"name": "box", "material": "glass", "shape": "box", "lower": [0, 0, 0], "upper": [side, side, 2 * side]}],
            "stage": [{"duration": 1.0}],
        }
    )


def nothing(state):
    return None


def drag(state):
    return -1e-7 * state.velocities


def drag_filled(state):
    np.multiply(state.velocities, -1e-7, out=state.forces)


def trap(state):
    return -1e-3 * (state.positions - 0.005) - 1e-7 * state.velocities * state.radii[:, None]


def time_per_step(sim, steps):
    start = time.perf_counter()
    sim.step(steps)
    return (time.perf_counter() - start) / steps


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grains", type=int, nargs="+", default=[100, 1000, 10000])
    parser.add_argument("--steps", type=int, default=500)
    parser.add_argument("--threads", type=int, default=1)
    arguments = parser.parse_args()
    print(f"{'grains':>8} {'force':>12} {'step [us]':>10} {'force [us]':>10}")
    for grains in arguments.grains:
        sim = demeter.Simulation(bed(grains), threads=arguments.threads)
        sim.run_until("0.05 s")
        for force in (nothing, drag, drag_filled, trap):
            # without and with in turns, so that a machine that slows down slows both
            without, told = [], []
            for _ in range(3):
                without.append(time_per_step(sim, arguments.steps))
                sim.add_force(force)
                told.append(time_per_step(sim, arguments.steps))
                sim.clear_forces()
            cost = min(told) - min(without)
            print(f"{grains:8} {force.__name__:>12} {1e6 * min(told):10.1f} {1e6 * cost:10.1f}")


if __name__ == "__main__":
    main()
