"""Kinematics of a corner and of an axle: poses along travel and rack, and every quantity that follows from them."""

from jounce.kinematics.axle import sweep_roll
from jounce.kinematics.catalogue import CATALOGUE, Quantity
from jounce.kinematics.compliances import compliance
from jounce.kinematics.files import write_sweep
from jounce.kinematics.layout import AxleLayout
from jounce.kinematics.loads import ContactLoad, pickup_loads
from jounce.kinematics.steering import sweep_steering
from jounce.kinematics.sweeps import sweep_rack, sweep_travel
from jounce.kinematics.variants import sweep_variants

__all__ = [
    "CATALOGUE",
    "AxleLayout",
    "ContactLoad",
    "Quantity",
    "compliance",
    "pickup_loads",
    "sweep_rack",
    "sweep_roll",
    "sweep_steering",
    "sweep_travel",
    "sweep_variants",
    "write_sweep",
]
