"""Forces that Python functions tell."""

import numpy as np
import pytest

import demeter
from conftest import same


def test_a_custom_force_acts_and_is_booked(bed):
    sim = demeter.Simulation(bed, threads=1)

    @sim.add_force
    def trap(state):
        away = state.positions - [0.01, 0.01, 0.01]
        return -0.05 * away - 1e-4 * state.velocities

    sim.run()
    assert abs(sim.residual) < 1e-3 and sim.energies()["custom_work"] != 0
    other = demeter.Simulation(bed, threads=2)

    def fills(state):
        state.forces[:] = trap(state)

    other.add_force(fills)
    other.run()
    assert same(sim, other)
    assert not same(sim, demeter.run(bed))


def test_what_a_force_was_shown_can_be_kept(bed):
    sim = demeter.Simulation(bed, threads=1)
    kept, moments = [], []

    @sim.add_force
    def watch(state):
        positions, velocities = state.positions, state.velocities
        assert state.positions is positions and positions.flags.writeable
        assert state.radii.shape == state.masses.shape == state.ids.shape == (len(state),)
        assert not state.forces.any() and not state.torques.any()
        state.forces[:, 2] = 1e-9
        if state.step % 10 == 0:
            kept.append((positions, positions.copy(), velocities[:, 2], velocities[:, 2].copy()))
        moments.append(state)

    sim.step(50)
    assert len(kept) == 6  # once before the first step
    for positions, copy, speeds, speeds_then in kept:
        assert np.array_equal(positions, copy) and np.array_equal(speeds, speeds_then)
    assert not np.array_equal(kept[0][0], kept[-1][0])
    last = moments[-1]
    assert last.positions.shape == (50, 3) and last.time == pytest.approx(sim.time)
    with pytest.raises(demeter.RunError, match="which is over"):
        last.angular_velocities


def test_a_force_answers_with_any_array(bed):
    runs = []
    for answer in (
        lambda state: np.full((len(state), 3), 1e-5),
        lambda state: np.full((len(state), 3), 1e-5, dtype=np.float32).astype(float),
        lambda state: np.full((3, len(state)), 1e-5).T,
        lambda state: [[1e-5] * 3] * len(state),
        lambda state: (np.full((len(state), 3), 1e-5), np.zeros((len(state), 3))),
    ):
        sim = demeter.Simulation(bed, threads=1)
        sim.add_force(answer)
        sim.step(20)
        runs.append(sim.velocities)
    assert np.allclose(runs[0], runs[1], rtol=1e-6)
    assert all(np.array_equal(runs[0], run) for run in runs[2:])


def test_a_torque_turns(bed):
    bed["simulation"]["gravity"] = [0, 0, 0]
    sim = demeter.Simulation(bed)
    sim.add_force(lambda state: (np.zeros((len(state), 3)), np.tile([0, 0, 1e-9], (len(state), 1))))
    sim.step(100)
    inertia = 0.4 * sim.masses * sim.radii**2
    expected = 1e-9 * sim.time / inertia
    free = np.isin(sim.ids, sim.contacts()["i"], invert=True)
    assert np.allclose(sim.angular_velocities[free, 2], expected[free], rtol=0.02)
    assert sim.clear_forces() is None


@pytest.mark.parametrize(
    "answer, error",
    [
        (lambda state: 1 / 0, ZeroDivisionError),
        (lambda state: np.zeros((3, 3)), ValueError),
        (lambda state: "strong", TypeError),
        (lambda state: np.full((len(state), 3), np.nan), demeter.Fault),
    ],
)
def test_a_force_that_fails_leaves_a_whole_step(bed, answer, error):
    sim = demeter.Simulation(bed)
    sim.step(50)
    sim.add_force(answer)
    with pytest.raises(error):
        sim.step(10)
    assert sim.steps == 51 and np.isfinite(sim.positions).all()
    sim.clear_forces()
    sim.step(10)
    assert abs(sim.residual) < 1e-3
