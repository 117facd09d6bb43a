# The names of the package; `lazy_loader` loads what is used.

from .enveloping import contact_length as contact_length
from .loading import load_road as load_road
from .loading import read_roads as read_roads
from .loading import road_library as road_library
from .loading import source_of_course as source_of_course
from .measured import read_crg_profile as read_crg_profile
from .road import ROADS as ROADS
from .road import Road as Road
from .road import SampledRoad as SampledRoad
from .rough import class_roughness as class_roughness
from .rough import track_coherence as track_coherence
from .trial import Excitation as Excitation
from .trial import HoldsTrial as HoldsTrial
from .trial import Trial as Trial
from .trial import as_trial as as_trial
from .trial import trial_findings as trial_findings
from .waves import swept_sine as swept_sine

# isort: split
# Written by `make faces`: members of the registries.
from .enveloping import Enveloped as Enveloped
from .measured import Crg as Crg
from .measured import Table as Table
from .obstacles import CircularSegment as CircularSegment
from .obstacles import Flat as Flat
from .obstacles import HalfCylinder as HalfCylinder
from .obstacles import HalfSine as HalfSine
from .obstacles import Kerb as Kerb
from .obstacles import Pothole as Pothole
from .obstacles import Ramp as Ramp
from .obstacles import Rectangle as Rectangle
from .obstacles import Step as Step
from .obstacles import Train as Train
from .obstacles import Trapezoid as Trapezoid
from .obstacles import Triangle as Triangle
from .obstacles import Versine as Versine
from .rough import Iso8608 as Iso8608
from .rough import SineSum as SineSum
from .waves import Sine as Sine
from .waves import SineSweep as SineSweep
