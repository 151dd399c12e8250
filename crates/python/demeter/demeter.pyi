"""Demeter: discrete element method for powders and soft grains."""

from os import PathLike
from typing import Any, Callable, Literal, Mapping, Optional, Sequence, TypedDict, TypeVar, Union, final, overload

import numpy as np
import numpy.typing as npt

__version__: str

__all__ = [
    "ArgumentError",
    "CollisionError",
    "Error",
    "Fault",
    "ForceState",
    "OutOfRange",
    "OutputError",
    "RunError",
    "Scenario",
    "ScenarioError",
    "Simulation",
    "UnknownName",
    "WrongType",
    "WrongValue",
    "__version__",
    "collide",
    "compare",
    "contact_curve",
    "damped_spring",
    "fit",
    "frames",
    "laws",
    "read_frame",
    "read_series",
    "resume",
    "run",
    "si",
    "sticking",
]

_Path = Union[str, "PathLike[str]"]
_Quantity = Union[str, float]
_Source = Union[_Path, Mapping[str, Any]]
_ScenarioLike = Union["Scenario", _Source]
_Set = Optional[Mapping[str, Any]]
_Floats = npt.NDArray[np.float64]
_Columns = dict[str, Any]
_F = TypeVar("_F", bound=Callable[..., Any])
_Progress = Union[bool, Callable[[dict[str, Any]], Any], None]

class Error(Exception):
    """Everything that Demeter refuses or cannot do."""

class _Fault(TypedDict):
    path: str
    message: str
    help: Optional[str]
    source: str
    line: int
    column: int

class ScenarioError(Error):
    """A scenario or another input file is wrong; `faults` lists everything that is."""

    faults: list[_Fault]

class RunError(Error):
    """A run cannot be begun, continued or changed."""

class Fault(RunError):
    """The simulation reached a state that its model does not cover."""

    grain: int

class OutputError(Error):
    """A file or folder cannot be read or written."""

class CollisionError(Error):
    """Two bodies cannot be computed as asked."""

class ArgumentError(Error):
    """An argument of a function is wrong."""

class WrongType(ArgumentError, TypeError):
    """An argument is of a type that is not understood; also a TypeError."""

class WrongValue(ArgumentError, ValueError):
    """An argument has a value that it cannot have; also a ValueError."""

class UnknownName(ArgumentError, KeyError):
    """There is nothing of this name; also a KeyError."""

class OutOfRange(ArgumentError, IndexError):
    """There is nothing of this number; also an IndexError."""

@final
class Scenario:
    """A scenario: everything that a run is made of, read and checked."""

    @staticmethod
    def from_toml(source: _Path, *, set: _Set = None) -> Scenario:
        """Reads a scenario from a TOML file or text."""
    @staticmethod
    def from_dict(tables: Mapping[str, Any], *, set: _Set = None) -> Scenario:
        """Builds a scenario from nested dicts and lists, with the keys of the TOML file."""
    @staticmethod
    def template(name: str, *, set: _Set = None) -> Scenario:
        """One of the templates that `demeter new` writes."""
    @staticmethod
    def templates() -> list[str]:
        """Names of the templates."""
    def set(self, changes: Mapping[str, Any]) -> Scenario:
        """The same scenario with changes, checked anew."""
    def check(self) -> dict[str, Any]:
        """Makes the scenario ready to run, without running it."""
    def to_toml(self) -> str:
        """The scenario as TOML, with all changes put in."""
    @property
    def title(self) -> str:
        """Its title."""
    @property
    def stages(self) -> list[str]:
        """Names of its stages, repeats unrolled."""

@final
class ForceState:
    """The grains at the moment at which a custom force acts; arrays are copies, made when they are asked for."""

    @property
    def time(self) -> float:
        """Simulated time [s]."""
    @property
    def step(self) -> int:
        """Steps done, with the present one."""
    @property
    def dt(self) -> float:
        """Time step [s]."""
    @property
    def positions(self) -> _Floats:
        """Centres [m], (n, 3)."""
    @property
    def velocities(self) -> _Floats:
        """Velocities, as predicted for the end of the step [m/s], (n, 3)."""
    @property
    def angular_velocities(self) -> _Floats:
        """Angular velocities, as predicted for the end of the step [rad/s], (n, 3)."""
    @property
    def radii(self) -> _Floats:
        """Radii [m], (n,)."""
    @property
    def masses(self) -> _Floats:
        """Masses [kg], (n,)."""
    @property
    def ids(self) -> npt.NDArray[np.uint32]:
        """Ids, (n,)."""
    @property
    def materials(self) -> npt.NDArray[np.uint16]:
        """Indices of the materials, (n,)."""
    @property
    def forces(self) -> _Floats:
        """Forces to fill [N], (n, 3); zero at first. Used when the function returns None."""
    @property
    def torques(self) -> _Floats:
        """Torques to fill [N m], (n, 3); zero at first. Used when the function returns None or forces alone."""
    def __len__(self) -> int: ...

_ForceAnswer = Union[None, npt.ArrayLike, tuple[npt.ArrayLike, npt.ArrayLike]]

class _Wall(TypedDict):
    force: _Floats
    torque: _Floats
    position: _Floats
    displacement: _Floats
    velocity: _Floats
    angular_velocity: _Floats
    work: float
    present: bool

class _Contacts(TypedDict):
    i: npt.NDArray[np.uint32]
    j: npt.NDArray[np.uint32]
    wall: npt.NDArray[np.int32]
    overlap: _Floats
    position: _Floats
    normal: _Floats
    force: _Floats
    normal_force: _Floats
    tangential_force: _Floats
    rolling_torque: _Floats

@final
class Simulation:
    """A run, in your hands."""

    def __new__(
        cls,
        scenario: _ScenarioLike,
        *,
        out: Optional[_Path] = None,
        threads: Optional[int] = None,
        overwrite: bool = False,
    ) -> Simulation: ...
    @staticmethod
    def resume(folder: _Path, *, threads: Optional[int] = None, changed: bool = False) -> Simulation:
        """The run in a folder, from its latest checkpoint on. `changed`: also when `scenario.toml` in it was changed."""
    def run(self, *, progress: _Progress = None) -> bool:
        """Runs to the end of the protocol. Tells whether the end was reached. `progress`: True for a bar, or a function of a dict."""
    def step(self, n: int = 1) -> None:
        """Runs so many steps, also beyond the end of the protocol."""
    def run_until(
        self,
        until: Union[_Quantity, Callable[[Simulation], Any]],
        *,
        every: Union[int, _Quantity, None] = None,
        at_most: Optional[_Quantity] = None,
        progress: _Progress = None,
    ) -> bool:
        """Runs until a time [s], or until a condition holds, asked `every` so many steps (int) or so much time [s]."""
    def run_stage(self, *, progress: _Progress = None) -> bool:
        """Runs to the end of the present stage. Tells whether a stage is left."""
    def stop(self) -> None:
        """Ends the run that goes on, after the present step."""
    @overload
    def every(self, interval: Union[int, _Quantity], function: _F) -> _F:
        """Calls a function again and again while the simulation runs."""
    @overload
    def every(self, interval: Union[int, _Quantity], function: None = None) -> Callable[[_F], _F]: ...
    def cancel(self, function: Callable[..., Any]) -> None:
        """Calls a function of `every` no more."""
    def add_force(self, function: Callable[[ForceState], _ForceAnswer]) -> Callable[[ForceState], _ForceAnswer]:
        """Adds a force on the grains, asked once in every step: forces (n, 3) [N], (forces, torques (n, 3) [N m]), or None."""
    def clear_forces(self) -> None:
        """Takes all custom forces away."""
    def move_wall(
        self,
        wall: str,
        *,
        position: Optional[Callable[[float], Sequence[float]]] = None,
        velocity: Optional[Callable[[float], Sequence[float]]] = None,
        angle: Optional[Callable[[float], float]] = None,
        angular_velocity: Optional[Callable[[float], float]] = None,
        axis: Optional[Sequence[float]] = None,
        point: Optional[Sequence[_Quantity]] = None,
    ) -> None:
        """Moves a wall as one function of simulated time [s] tells: `position` [m], `velocity` [m/s], `angle` [rad], `angular_velocity` [rad/s]."""
    def close(self) -> None:
        """Lets the folder of the run go, and goes no further; the state stays to be looked at."""
    def __enter__(self) -> Simulation: ...
    def __exit__(self, *_exception: object) -> bool: ...
    def checkpoint(self, folder: Optional[_Path] = None, *, overwrite: bool = False) -> PathLike[str]:
        """Writes a checkpoint. Tells the folder."""
    @property
    def time(self) -> float:
        """Simulated time [s]."""
    @property
    def steps(self) -> int:
        """Steps done."""
    @property
    def dt(self) -> float:
        """Time step [s]."""
    @property
    def stage(self) -> Optional[str]:
        """Name of the present stage; None when the protocol is over."""
    @property
    def finished(self) -> bool:
        """Whether the protocol is over."""
    @property
    def folder(self) -> Optional[PathLike[str]]:
        """The folder of the results."""
    @property
    def messages(self) -> list[str]:
        """What the run had to say so far."""
    @property
    def summary(self) -> Optional[dict[str, Any]]:
        """The summary at the end of the protocol."""
    @property
    def positions(self) -> _Floats:
        """Centres of the grains [m], (n, 3)."""
    @positions.setter
    def positions(self, value: npt.ArrayLike) -> None: ...
    @property
    def velocities(self) -> _Floats:
        """Velocities [m/s], (n, 3)."""
    @velocities.setter
    def velocities(self, value: npt.ArrayLike) -> None: ...
    @property
    def angular_velocities(self) -> _Floats:
        """Angular velocities [rad/s], (n, 3)."""
    @angular_velocities.setter
    def angular_velocities(self, value: npt.ArrayLike) -> None: ...
    @property
    def forces(self) -> _Floats:
        """Total forces on the grains [N], (n, 3)."""
    @property
    def torques(self) -> _Floats:
        """Total torques on the grains [N m], (n, 3)."""
    @property
    def radii(self) -> _Floats:
        """Radii [m], (n,)."""
    @property
    def masses(self) -> _Floats:
        """Masses [kg], (n,)."""
    @property
    def fixed(self) -> npt.NDArray[np.bool_]:
        """Which grains forces leave where they are, (n,)."""
    @property
    def ids(self) -> npt.NDArray[np.uint32]:
        """Ids, which never change, (n,)."""
    @property
    def materials(self) -> npt.NDArray[np.uint16]:
        """Indices of the materials, (n,)."""
    @property
    def orientations(self) -> _Floats:
        """Orientations as unit quaternions x, y, z, w, (n, 4), where `simulation.orientations` is true."""
    @property
    def material_names(self) -> list[str]:
        """Names of the materials."""
    def indices(self, ids: Optional[Sequence[int]] = None) -> npt.NDArray[np.uint64]:
        """Rows of the grains with these ids, (n,); of all in the order of their ids when none are told."""
    def contacts(self) -> _Contacts:
        """All contacts that act: lengths [m], forces [N] and torques [N m], of shape (c,) or (c, 3); without copies."""
    @property
    def walls(self) -> dict[str, _Wall]:
        """The walls by name: force [N], torque [N m], position and displacement [m], velocities [m/s], [rad/s], (3,); their work on the grains [J]."""
    def energies(self) -> dict[str, float]:
        """The energy ledger [J]."""
    @property
    def residual(self) -> float:
        """Share of the energy that the ledger does not explain."""
    def measures(self) -> dict[str, Any]:
        """Everything that a row of the series tells, now."""
    def series(self) -> _Columns:
        """The series so far as a dict of columns, titled with their units."""
    def __len__(self) -> int: ...

def run(
    scenario: _ScenarioLike,
    *,
    out: Optional[_Path] = None,
    threads: Optional[int] = None,
    overwrite: bool = False,
    progress: _Progress = None,
) -> Simulation:
    """Runs a scenario to its end and hands out the simulation."""

def resume(
    folder: _Path, *, threads: Optional[int] = None, changed: bool = False, progress: _Progress = None
) -> Simulation:
    """Goes on with the run in a folder to its end, from its latest checkpoint. `changed`: also when `scenario.toml` in it was changed."""

def read_series(folder: _Path) -> _Columns:
    """The series of a run as a dict of columns."""

def frames(folder: _Path) -> list[tuple[int, float]]:
    """The frames of a run: a list of (step, time [s])."""

def read_frame(folder: _Path, frame: int = ...) -> dict[str, Any]:
    """A frame of a run, by its number: step, time [s], and tables of grains, contacts and walls, in SI, (n,) or (n, 3)."""

def collide(bodies: _Source, *, engine: bool = False, course: int = 0, set: _Set = None) -> dict[str, Any]:
    """Collides two bodies and tells what became of them, in SI."""

def contact_curve(bodies: _Source, *, set: _Set = None) -> _Columns:
    """The quasi-static curve of the normal law between two bodies: branch, overlap [m], force [N], stored [J], (n,)."""

def sticking(
    bodies: _Source, radius: Union[_Quantity, Sequence[_Quantity], _Floats], *, points: int = 20, set: _Set = None
) -> dict[str, _Floats]:
    """The speed [m/s] below which two bodies stick, against their effective radius [m], (points,)."""

def fit(
    task: _Source, *, out: Optional[_Path] = None, threads: Optional[int] = None, set: _Set = None
) -> dict[str, Any]:
    """Finds the parameters of a law from observed collisions, or a number of a scenario from a measured force curve."""

def compare(
    runs: Union[_Path, list[_Path]],
    reference: _Path,
    *,
    load: str = "squeeze",
    unload: Optional[str] = ...,
    discard: int = 0,
    force: str = "wall top force z",
    threshold: Optional[_Quantity] = None,
    reference_threshold: Optional[_Quantity] = None,
) -> dict[str, Any]:
    """Averages the cycles of runs and sets them beside another run or a measured curve."""

def laws(name: Optional[str] = None) -> list[dict[str, Any]]:
    """All contact laws, or those of a name."""

def damped_spring(
    law: Literal["linear", "hertz"],
    *,
    mass: _Quantity,
    velocity: _Quantity,
    restitution: Optional[float] = None,
    stiffness: Optional[_Quantity] = None,
    contact_time: Optional[_Quantity] = None,
    max_overlap: Optional[_Quantity] = None,
    max_force: Optional[_Quantity] = None,
    contact_end: Literal["zero-overlap", "zero-force"] = "zero-overlap",
) -> dict[str, float]:
    """Closed forms of the damped springs: from what a head-on collision shows to stiffness and damping, and back, in SI."""

def si(value: _Quantity) -> float:
    """The value of a quantity in SI."""
