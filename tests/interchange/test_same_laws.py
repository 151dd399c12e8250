"""Laws of other codes beside those that the book names for them: two equal beads meet, once there and once here.

Each test runs where its program is installed. Beads are stiff, so that what depends on their overlap weighs little: LAMMPS takes
another arm for the velocity of a surface than for its torque.
"""

import json
import subprocess
from datetime import datetime
from math import cos, log, pi, radians, sin, sqrt

import pytest
from programs import DEMETER, call, date_of_lammps, lammps_since, program

RADIUS, DENSITY, YOUNG, POISSON = 2.5e-3, 2500, 5e9, 0.3
MODULUS = YOUNG / (2 * (1 - POISSON**2))
EFFECTIVE_MASS = DENSITY * 4 / 3 * pi * RADIUS**3 / 2
SHEAR_MODULUS = YOUNG / (4 * (1 + POISSON) * (2 - POISSON))
STEPS = 50_000

GROUPS = """
group first id 1
group second id 2
"""
MEASURED = f"""
compute w first property/atom omegaz
compute spin_of_first first reduce sum c_w
variable speed equal vcm(first,x)-vcm(second,x)
variable spin equal c_spin_of_first
variable gap equal xcm(second,x)-xcm(first,x)-{2 * RADIUS}
thermo {STEPS}
thermo_style custom step c_spin_of_first
run {STEPS}
print "told ${{speed}} ${{spin}} ${{gap}}"
"""


def told(text, velocity):
    """What LAMMPS or LIGGGHTS print: normal velocity after over that before, 0 where they stick, and the spin [1/s]."""
    line = next(line for line in text.splitlines() if line.startswith("told "))
    speed, spin, gap = map(float, line.split()[1:])
    return 0.0 if gap < 1e-4 * RADIUS else -speed / velocity, abs(spin)


def beta(e):
    """`-ln e/sqrt(ln^2 e + pi^2)`, the damping ratio of a linear spring with this restitution."""
    return -log(e) / sqrt(log(e) ** 2 + pi**2)


def tsuji(e):
    """The coefficient of Tsuji's dashpot with this restitution, where contacts end at zero overlap."""
    return sqrt(5) * beta(e)


def rubs(friction, damping_ratio, law="mindlin-history", **more):
    others = "".join(f", {key} = \"{value}\"" for key, value in more.items())
    return f'tangential = {{ law = "{law}", friction = {friction}, damping_ratio = {damping_ratio}{others} }}'


def of_lammps(restitution, tangential, damping="coeff_restitution", young=YOUNG):
    return f"hertz/material {young} {restitution} {POISSON} tangential {tangential} damping {damping}"


def agree(one, other, relative):
    assert one == pytest.approx(other, rel=relative), f"{one} and {other}"


def lammps(tmp_path, style, coefficients="", speed=1.0, angle=0.0, step=2e-9):
    """What the first of two beads does in LAMMPS, which another one of the same kind meets at rest."""
    normal, along = speed * cos(radians(angle)), speed * sin(radians(angle))
    script = f"""units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1
create_box 1 box
create_atoms 1 single {-RADIUS * (1 + 1e-9):.17g} 0 0
create_atoms 1 single {RADIUS:.17g} 0 0
set group all diameter {2 * RADIUS} density {DENSITY}
{GROUPS}
velocity first set {normal} {along} 0
pair_style {style}
pair_coeff * * {coefficients}
fix move all nve/sphere
timestep {step}
{MEASURED}"""
    (tmp_path / "in.lammps").write_text(script)
    return told(call(tmp_path, ["lmp", "-in", "in.lammps", "-log", "none"], script), normal)


def demeter(tmp_path, normal, other="", speed=1.0, angle=0.0, young=YOUNG):
    """The same here, told the laws."""
    (tmp_path / "pair.toml").write_text(f"""
[material.m]
young_modulus = "{young} Pa"
poisson_ratio = {POISSON}
density = "{DENSITY} kg/m^3"
[a]
material = "m"
radius = "{RADIUS} m"
[b]
material = "m"
radius = "{RADIUS} m"
[contact]
normal = {{ {normal} }}
{other}
[impact]
velocity = "{speed} m/s"
angle = "{angle} deg"
""")
    done = subprocess.run([DEMETER, "collide", "pair.toml", "--json"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    between = found["velocity"]["a"][2] - found["velocity"]["b"][2]
    return between / (speed * cos(radians(angle))), abs(found["spin"]["a"][1])


def liggghts(tmp_path, model, restitution=0.5, properties=(), angle=0.0, young=YOUNG, step=2e-9):
    """The same in LIGGGHTS, told the model and what it needs beside moduli, restitution and a friction of 0.3."""
    normal, along = cos(radians(angle)), sin(radians(angle))
    known = {
        "youngsModulus peratomtype": young,
        "poissonsRatio peratomtype": POISSON,
        "coefficientRestitution peratomtypepair 1": restitution,
        "coefficientFriction peratomtypepair 1": 0.3,
        "characteristicVelocity scalar": 1.0,
        **dict(properties),
    }
    fixes = "\n".join(f"fix m{k} all property/global {name} {value}" for k, (name, value) in enumerate(known.items()))
    script = f"""atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
hard_particles yes
units si
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 1 box
neighbor 0.001 bin
{fixes}
pair_style gran model {model}
pair_coeff * *
create_atoms 1 single {-RADIUS * (1 + 1e-9):.17g} 0 0 units box
create_atoms 1 single {RADIUS:.17g} 0 0 units box
set group all diameter {2 * RADIUS} density {DENSITY}
{GROUPS}
velocity first set {normal} {along} 0 units box
fix move all nve/sphere
timestep {step}
{MEASURED}"""
    (tmp_path / "in.liggghts").write_text(script)
    return told(call(tmp_path, ["liggghts", "-in", "in.liggghts", "-log", "none"], script), normal)


# the table in from-lammps.md
@program("lmp")
@pytest.mark.parametrize("asked, alpha, had", [(0.3, 0.5659, 0.440), (0.5, 0.3407, 0.616), (0.7, 0.1784, 0.778), (0.9, 0.0529, 0.928)])
def test_the_restitution_of_tsujis_polynomial_in_lammps(tmp_path, asked, alpha, had):
    there, _ = lammps(tmp_path, "granular", of_lammps(asked, "linear_nohistory 0 0", "tsuji"))
    if date_of_lammps() < datetime(2026, 7, 1):
        agree(there, had, 1e-3)
    here, _ = demeter(tmp_path, f'law = "hertz-tsuji", alpha = {alpha}, contact_end = "zero-overlap"')
    agree(here, had, 1e-3)


@program("lmp")
def test_coefficients_of_dashpots_in_lammps(tmp_path):
    k, gamma, gamma_t = 1e7, 6e4, 3e4
    other = rubs(10, gamma_t * sqrt(7 * EFFECTIVE_MASS / (8 * 2 / 7 * k)), "linear-history", stiffness=f"{2 / 7 * k} N/m")
    there = lammps(tmp_path, f"gran/hooke/history {k} {2 / 7 * k} {gamma} {gamma_t} 10 1", angle=20)
    linear = f'law = "linear", contact_end = "zero-overlap", stiffness = "{k} N/m", damping_rate'
    agree(there, demeter(tmp_path, f'{linear} = "{gamma / 2} 1/s"', other, angle=20), 1e-2)
    per_mass = gamma * EFFECTIVE_MASS
    for damping, coefficient in [("mass_velocity", gamma), ("velocity", per_mass)]:
        there = lammps(tmp_path, "granular", f"hooke {k} {coefficient} tangential linear_nohistory 0 0 damping {damping}")
        agree(there, demeter(tmp_path, f'{linear} = "{gamma / 2} 1/s"'), 1e-3)
    gamma = 1e8
    here = demeter(
        tmp_path,
        f'law = "viscoelastic", dissipation_time = "{gamma * EFFECTIVE_MASS / (2 * MODULUS)} s", contact_end = "zero-overlap"',
    )
    assert here[0] < 0.9
    agree(lammps(tmp_path, "granular", of_lammps(gamma, "linear_nohistory 0 0", "viscoelastic")), here, 1e-3)
    agree(lammps(tmp_path, f"gran/hertz/history {4 / 3 * MODULUS} {8 * SHEAR_MODULUS} {gamma} 0 0 0"), here, 1e-3)


@lammps_since("17 Apr 2024")
def test_tangential_damping_of_lammps(tmp_path):
    hertz = f'law = "hertz-tsuji", alpha = {tsuji(0.5)}, contact_end = "zero-force"'
    x, angle = 1.0, 20
    ratio = x * tsuji(0.5) / 2 * sqrt(7 * (2 - POISSON) / (6 * (1 - POISSON)))
    there = lammps(tmp_path, "granular", of_lammps(0.5, f"mindlin_rescale/force NULL {x} 10") + " limit_damping", angle=angle)
    agree(there, demeter(tmp_path, hertz, rubs(10, ratio), angle=angle), 3e-3)
    k = 1e6
    coefficients = f"hooke {k} 0.5 tangential linear_history {k / 3} {x} 10 damping coeff_restitution limit_damping"
    rate = beta(0.5) * sqrt(k / EFFECTIVE_MASS)
    linear = f'law = "linear", stiffness = "{k} N/m", damping_rate = "{rate} 1/s", contact_end = "zero-force"'
    other = rubs(10, x * beta(0.5) * sqrt(7 * k / (2 * k / 3)), "linear-history", stiffness=f"{k / 3} N/m")
    agree(lammps(tmp_path, "granular", coefficients, angle=angle), demeter(tmp_path, linear, other, angle=angle), 3e-3)


# figures of "What bites" in coming-from.md and of from-lammps.md
@lammps_since("17 Apr 2024")
def test_where_friction_of_lammps_is_another(tmp_path):
    spin = lambda outcome: outcome[1]
    there = of_lammps(0.5, "mindlin_rescale/force NULL 0 0.5")
    agree(spin(lammps(tmp_path, "granular", there, angle=30)), 88.6, 1e-3)
    agree(spin(demeter(tmp_path, 'law = "hertz-tsuji", restitution = 0.5', rubs(0.5, 0), angle=30)), 95.1, 1e-3)
    cut = f'law = "hertz-tsuji", alpha = {tsuji(0.5)}, contact_end = "zero-force"'
    agree(lammps(tmp_path, "granular", there + " limit_damping", angle=30), demeter(tmp_path, cut, rubs(0.5, 0), angle=30), 4e-3)

    agree(spin(lammps(tmp_path, "granular", of_lammps(1, "mindlin NULL 0 10"), angle=30)), 3.44, 2e-3)
    agree(spin(lammps(tmp_path, "granular", of_lammps(1, "mindlin_rescale/force NULL 0 10"), angle=30)), 34.6, 2e-3)
    agree(spin(demeter(tmp_path, 'law = "hertz-tsuji", restitution = 1', rubs(10, 0), angle=30)), 34.8, 2e-3)

    for e, there, here in [(0.5, 118, 115.4), (0.95, 35.6, 123.7)]:
        agree(spin(lammps(tmp_path, "granular", of_lammps(e, "linear_nohistory 1.0 0.3"), angle=60)), there, 2e-3)
        coulomb = 'tangential = { law = "coulomb", friction = 0.3 }'
        agree(spin(demeter(tmp_path, f'law = "hertz-tsuji", restitution = {e}', coulomb, angle=60)), here, 2e-3)

    soft = of_lammps(0.5, "mindlin_rescale/force NULL 0 0.5", young=5e6) + " limit_damping"
    agree(spin(lammps(tmp_path, "granular", soft, angle=30, step=1e-7)), 100.4, 1e-3)
    agree(spin(demeter(tmp_path, cut, rubs(0.5, 0), angle=30, young=5e6)), 104.8, 1e-3)


@lammps_since("17 Apr 2024")
def test_up_to_which_speed_jkr_sticks(tmp_path):
    jkr = f"jkr 500e9 0 {POISSON} 1500 tangential linear_nohistory 0 0 damping viscoelastic"
    for speed, sticks in [(0.40, True), (0.42, False)]:
        assert (lammps(tmp_path, "granular", jkr, speed=speed, step=1e-9)[0] == 0) == sticks
    for speed, sticks in [(0.586, True), (0.588, False)]:
        here = demeter(tmp_path, 'law = "jkr", work_of_adhesion = "3000 J/m^2"', speed=speed, young=500e9)
        assert (here[0] == 0) == sticks


@program("liggghts")
def test_the_normal_laws_of_liggghts(tmp_path):
    agree(liggghts(tmp_path, "hertz tangential history"), (0.5, 0.0), 1e-3)
    agree(liggghts(tmp_path, "hooke tangential history"), (0.5, 0.0), 1e-3)
    agree(demeter(tmp_path, f'law = "hertz-tsuji", alpha = {tsuji(0.5)}'), (0.5, 0.0), 1e-3)
    cohesive = {"cohesionEnergyDensity peratomtypepair 1": 1e7}
    for cohesion, area in [("sjkr", "lens"), ("sjkr2", "double-lens")]:
        here = demeter(tmp_path, f'law = "sjkr", area = "{area}", cohesion_energy_density = "1e7 J/m^3", alpha = {tsuji(0.5)}')
        assert here[0] < 0.499
        agree(liggghts(tmp_path, f"hertz tangential history cohesion {cohesion}", properties=cohesive), here, 1e-3)


@program("liggghts")
def test_friction_of_liggghts(tmp_path):
    root = sqrt(RADIUS / 2)
    stiffness = 16 / 15 * root * MODULUS * (15 * EFFECTIVE_MASS / (16 * root * MODULUS)) ** 0.2
    rate = beta(0.5) * sqrt(stiffness / EFFECTIVE_MASS)
    other = rubs(10, sqrt(7 / 2) * beta(0.5), "linear-history", stiffness=f"{stiffness} N/m")
    linear = f'law = "linear", stiffness = "{stiffness} N/m", damping_rate = "{rate} 1/s", contact_end = "zero-force"'
    rough = {"coefficientFriction peratomtypepair 1": 10}
    there = liggghts(tmp_path, "hooke tangential history limitForce on", properties=rough, angle=20)
    agree(there, demeter(tmp_path, linear, other, angle=20), 1e-3)
    # figures of from-liggghts.md and coming-from.md
    _, spin = liggghts(tmp_path, "hertz tangential history limitForce on", angle=60)
    agree(spin, 125.8, 1e-3)
    hertz = f'law = "hertz-tsuji", alpha = {tsuji(0.5)}, contact_end = "zero-force"'
    agree(demeter(tmp_path, hertz, rubs(0.3, sqrt(35 / 12) * beta(0.5)), angle=60)[1], 115.4, 1e-3)
    model = "hertz tangential history tangential_damping off"
    _, spin = liggghts(tmp_path, model, 1 - 1e-9, properties=rough, angle=30)
    agree(spin, 3.6, 1e-2)


@program("liggghts")
def test_thornton_and_ning_in_liggghts(tmp_path):
    ratio, young = 0.02, 5e8
    pressure = 2 * ratio * MODULUS * young / YOUNG * RADIUS / (pi * RADIUS / 2)
    law = f'law = "thornton-ning", yield_pressure = "{pressure} Pa"'
    agree(demeter(tmp_path, law, young=young)[0], 0.478, 1e-3)
    needs = {"coefficientYieldRatio peratomtype": ratio, "surfaceEnergy peratomtypepair 1": 0}
    there, _ = liggghts(tmp_path, "thornton_ning tangential history", properties=needs, young=young, step=5e-9)
    agree(there, 0.444, 2e-3)
