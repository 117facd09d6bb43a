"""Obstacles, trains, rough roads, tables and measured courses: height and slope against distance, and their edges."""

from jounce.roads.coverage import check_covered, covered, point_spacing
from jounce.roads.enveloping import Enveloped, contact_length
from jounce.roads.iso8608 import Iso8608, SineSum
from jounce.roads.loading import load_road, read_roads, road_library, source_of_course
from jounce.roads.measured import Crg, Table
from jounce.roads.obstacles import (
    CircularSegment,
    Flat,
    HalfCylinder,
    HalfSine,
    Kerb,
    Pothole,
    Ramp,
    Rectangle,
    Step,
    Trapezoid,
    Triangle,
    Versine,
)
from jounce.roads.opencrg import read_crg_profile
from jounce.roads.road import Road
from jounce.roads.roughness import (
    class_roughness,
    filtered_noise,
    road_psd,
    roughness_class,
    track_coherence,
    white_noise_intensity,
)
from jounce.roads.sweeps import Sine, SineSweep, swept_sine
from jounce.roads.train import ROADS, AnyRoad, Train
from jounce.roads.trial import Excitation, Trial

__all__ = [
    "ROADS",
    "AnyRoad",
    "CircularSegment",
    "Crg",
    "Enveloped",
    "Excitation",
    "Flat",
    "HalfCylinder",
    "HalfSine",
    "Iso8608",
    "Kerb",
    "Pothole",
    "Ramp",
    "Rectangle",
    "Road",
    "Sine",
    "SineSum",
    "SineSweep",
    "Step",
    "Table",
    "Train",
    "Trapezoid",
    "Trial",
    "Triangle",
    "Versine",
    "check_covered",
    "class_roughness",
    "contact_length",
    "covered",
    "filtered_noise",
    "load_road",
    "point_spacing",
    "read_crg_profile",
    "read_roads",
    "road_library",
    "road_psd",
    "roughness_class",
    "source_of_course",
    "swept_sine",
    "track_coherence",
    "white_noise_intensity",
]
