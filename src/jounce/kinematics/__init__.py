"""Kinematics of a corner and of an axle: poses along travel and rack, and every quantity that follows from them."""

from jounce.kinematics.axle import sweep_steering
from jounce.kinematics.both_wheels import sweep_axle
from jounce.kinematics.catalogue import CATALOGUE, Quantity
from jounce.kinematics.clearances import Rim, Solid, clearances, link_lengths
from jounce.kinematics.compliances import compliance
from jounce.kinematics.effort import steering_effort
from jounce.kinematics.load_cases import (
    LOAD_CASES,
    LoadCase,
    LoadedAxle,
    load_case_table,
    load_cases,
)
from jounce.kinematics.loads import ContactLoad, pickup_loads
from jounce.kinematics.sweeps import AxleLayout, sweep_path, sweep_rack, write_sweep
from jounce.kinematics.travel_and_roll import sweep_roll, sweep_travel
from jounce.kinematics.variants import sweep_variants

__all__ = [
    "CATALOGUE",
    "LOAD_CASES",
    "AxleLayout",
    "ContactLoad",
    "LoadCase",
    "LoadedAxle",
    "Quantity",
    "Rim",
    "Solid",
    "clearances",
    "compliance",
    "link_lengths",
    "load_case_table",
    "load_cases",
    "pickup_loads",
    "steering_effort",
    "sweep_axle",
    "sweep_path",
    "sweep_rack",
    "sweep_roll",
    "sweep_steering",
    "sweep_travel",
    "sweep_variants",
    "write_sweep",
]
