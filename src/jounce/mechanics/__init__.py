"""Symbolic authoring of mechanical systems: bodies, joints, loops, force elements -> equations of motion."""

from jounce.mechanics.assembly import Assembly, Moved, assemble, orientation
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
from jounce.mechanics.mass import box, combined, cylinder, mesh, sphere, tube
from jounce.mechanics.mechanism import Mechanism
from jounce.mechanics.model import Facts, Model, Output
from jounce.mechanics.motions import harmonic, held, steady, step, through
from jounce.mechanics.reactions import Reaction
from jounce.mechanics.system import System, Track

__all__ = [
    "Assembly",
    "Body",
    "Facts",
    "Mechanism",
    "Model",
    "Moved",
    "Output",
    "Reaction",
    "System",
    "Track",
    "add_bushing",
    "add_elastic_rod",
    "assemble",
    "box",
    "bump_stop_force",
    "combined",
    "curve_force",
    "cylinder",
    "damper_force",
    "damper_map_force",
    "friction_force",
    "harmonic",
    "held",
    "mesh",
    "orientation",
    "sphere",
    "spring_force",
    "steady",
    "step",
    "through",
    "tube",
    "tyre_force",
]
