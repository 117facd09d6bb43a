"""Obstacles, trains, tables and measured courses: height and slope against distance, and the edges in them."""

from jounce.roads.loading import load_road, read_roads, road_library
from jounce.roads.measured import Crg, Table
from jounce.roads.obstacles import (
    CircularSegment,
    Flat,
    HalfCylinder,
    HalfSine,
    Ramp,
    Rectangle,
    Step,
    Trapezoid,
    Triangle,
    Versine,
)
from jounce.roads.opencrg import read_crg_profile
from jounce.roads.road import Road
from jounce.roads.train import ROADS, AnyRoad, Train
from jounce.roads.trial import Excitation, Trial

__all__ = [
    "ROADS",
    "AnyRoad",
    "CircularSegment",
    "Crg",
    "Excitation",
    "Flat",
    "HalfCylinder",
    "HalfSine",
    "Ramp",
    "Rectangle",
    "Road",
    "Step",
    "Table",
    "Train",
    "Trapezoid",
    "Trial",
    "Triangle",
    "Versine",
    "load_road",
    "read_crg_profile",
    "read_roads",
    "road_library",
]
