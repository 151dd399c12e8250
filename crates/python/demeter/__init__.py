"""Demeter: discrete element method for powders and soft grains.

>>> import demeter
>>> sim = demeter.run("drum.toml", out="runs/drum")     # as `demeter run`
>>> sim = demeter.Simulation(scenario); sim.step(1000)  # in your hands
>>> demeter.collide("two_bodies.toml")["restitution"]   # two bodies

Quantities are texts with units ("2 mm"), or in dicts plain numbers in SI; everything that comes out is SI.
"""

from .demeter import ArgumentError as ArgumentError
from .demeter import CollisionError as CollisionError
from .demeter import Error as Error
from .demeter import Fault as Fault
from .demeter import ForceState as ForceState
from .demeter import OutOfRange as OutOfRange
from .demeter import OutputError as OutputError
from .demeter import RunError as RunError
from .demeter import Scenario as Scenario
from .demeter import ScenarioError as ScenarioError
from .demeter import Simulation as Simulation
from .demeter import UnknownName as UnknownName
from .demeter import WrongType as WrongType
from .demeter import WrongValue as WrongValue
from .demeter import __version__ as __version__
from .demeter import collide as collide
from .demeter import compare as compare
from .demeter import contact_curve as contact_curve
from .demeter import damped_spring as damped_spring
from .demeter import fit as fit
from .demeter import frames as frames
from .demeter import laws as laws
from .demeter import read_frame as read_frame
from .demeter import read_series as read_series
from .demeter import resume as resume
from .demeter import run as run
from .demeter import si as si
from .demeter import sticking as sticking
