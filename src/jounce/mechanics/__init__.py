"""Symbolic authoring of mechanical systems: bodies, joints, loops, force elements -> equations of motion."""

from jounce.mechanics.assembly import Assembly, Displacement, assemble, orientation
from jounce.mechanics.bodies import Body
from jounce.mechanics.bushings import add_bushing, add_elastic_rod
from jounce.mechanics.elements import (
    bump_stop_force,
    curve_force,
    damper_force,
    damper_map_force,
    friction_force,
    spring_force,
    tyre_force,
)
from jounce.mechanics.equations import Track
from jounce.mechanics.joints import (
    Cylindrical,
    Driven,
    Fixed,
    Free,
    Joint,
    Link,
    Parallel,
    Perpendicular,
    PointOnLine,
    PointToPoint,
    Prismatic,
    Revolute,
    Rod,
    Screw,
    Spherical,
    Universal,
)
from jounce.mechanics.mass import box, combined, cylinder, mesh, sphere, tube
from jounce.mechanics.mechanism import Mechanism
from jounce.mechanics.model import Facts, Model, Output
from jounce.mechanics.motions import constant, constant_rate, harmonic, interpolated, step
from jounce.mechanics.reactions import Reaction
from jounce.mechanics.system import System

__all__ = [
    "Assembly",
    "Body",
    "Cylindrical",
    "Displacement",
    "Driven",
    "Facts",
    "Fixed",
    "Free",
    "Joint",
    "Link",
    "Mechanism",
    "Model",
    "Output",
    "Parallel",
    "Perpendicular",
    "PointOnLine",
    "PointToPoint",
    "Prismatic",
    "Reaction",
    "Revolute",
    "Rod",
    "Screw",
    "Spherical",
    "System",
    "Track",
    "Universal",
    "add_bushing",
    "add_elastic_rod",
    "assemble",
    "box",
    "bump_stop_force",
    "combined",
    "constant",
    "constant_rate",
    "curve_force",
    "cylinder",
    "damper_force",
    "damper_map_force",
    "friction_force",
    "harmonic",
    "interpolated",
    "mesh",
    "orientation",
    "sphere",
    "spring_force",
    "step",
    "tube",
    "tyre_force",
]
