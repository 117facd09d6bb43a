"""Symbolic authoring of mechanical systems: bodies, joints, loops, force elements -> equations of motion."""

from jounce.mechanics.assembly import Assembly, Moved, assemble
from jounce.mechanics.bodies import Body
from jounce.mechanics.mass import box, combined, cylinder, mesh, sphere, tube
from jounce.mechanics.mechanism import Mechanism
from jounce.mechanics.model import Facts, Model, Output
from jounce.mechanics.motions import harmonic, held, steady, through
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
    "assemble",
    "box",
    "combined",
    "cylinder",
    "harmonic",
    "held",
    "mesh",
    "sphere",
    "steady",
    "through",
    "tube",
]
