"""jounce: from bench measurements to a validated suspension model, and from the model to decisions.

Everything public is an attribute of this package and is loaded when it is first used, so ``import jounce`` is fast.

>>> import jounce as jn
>>> "JounceError" in dir(jn)
True
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # what type checkers and editors see; a test keeps it equal to _PUBLIC
    from jounce import mechanics as mechanics
    from jounce import plots as plots
    from jounce.campaign import run_campaign as run_campaign
    from jounce.campaign.speed_sweep import speed_sweep as speed_sweep
    from jounce.control import ADD as ADD
    from jounce.control import LQG as LQG
    from jounce.control import LQR as LQR
    from jounce.control import PID as PID
    from jounce.control import SHADD as SHADD
    from jounce.control import ActiveActuator as ActiveActuator
    from jounce.control import Controller as Controller
    from jounce.control import Groundhook as Groundhook
    from jounce.control import HInfinity as HInfinity
    from jounce.control import Hybrid as Hybrid
    from jounce.control import MagnetorheologicalDamper as MagnetorheologicalDamper
    from jounce.control import Passive as Passive
    from jounce.control import PreviewMPC as PreviewMPC
    from jounce.control import PythonControl as PythonControl
    from jounce.control import SemiActiveDamper as SemiActiveDamper
    from jounce.control import Skyhook as Skyhook
    from jounce.control import TwoStateGroundhook as TwoStateGroundhook
    from jounce.control import TwoStateSkyhook as TwoStateSkyhook
    from jounce.control import controller as controller
    from jounce.core.errors import AssemblyError as AssemblyError
    from jounce.core.errors import DescriptionError as DescriptionError
    from jounce.core.errors import FitError as FitError
    from jounce.core.errors import JounceError as JounceError
    from jounce.core.errors import OutputError as OutputError
    from jounce.core.errors import RecordingError as RecordingError
    from jounce.core.errors import SimulationError as SimulationError
    from jounce.core.findings import Finding as Finding
    from jounce.design.adjustment_effects import adjust_report as adjust_report
    from jounce.design.adjustment_effects import lengths_for as lengths_for
    from jounce.design.adjustments import adjusted as adjusted
    from jounce.design.first_designs import best_dampers as best_dampers
    from jounce.design.first_designs import design_springs as design_springs
    from jounce.design.lumping import lumped_from as lumped_from
    from jounce.design.model_comparison import compare_models as compare_models
    from jounce.design.optimise import optimise as optimise
    from jounce.design.pareto import pareto as pareto
    from jounce.identify.damper_fit import fit_damper as fit_damper
    from jounce.identify.decay import fit_decay as fit_decay
    from jounce.identify.force_deflection import ForceDeflectionTrial as ForceDeflectionTrial
    from jounce.identify.stiffness import fit_stiffness as fit_stiffness
    from jounce.identify.update import FitTrial as FitTrial
    from jounce.identify.update import UpdatedParameter as UpdatedParameter
    from jounce.identify.update import UpdateResult as UpdateResult
    from jounce.identify.update import update_model as update_model
    from jounce.inspection.equivalence import compare_tests as compare_tests
    from jounce.inspection.evaluation import evaluate as evaluate
    from jounce.inspection.record import read_record as read_record
    from jounce.inspection.simulated import simulate_axle as simulate_axle
    from jounce.inspection.simulated import simulate_inspection as simulate_inspection
    from jounce.inspection.verdicts.grading import grade as grade
    from jounce.inspection.verdicts.limits import load_limits as load_limits
    from jounce.kinematics import AxleLayout as AxleLayout
    from jounce.kinematics import ContactLoad as ContactLoad
    from jounce.kinematics import compliance as compliance
    from jounce.kinematics import pickup_loads as pickup_loads
    from jounce.kinematics import sweep_rack as sweep_rack
    from jounce.kinematics import sweep_roll as sweep_roll
    from jounce.kinematics import sweep_steering as sweep_steering
    from jounce.kinematics import sweep_travel as sweep_travel
    from jounce.kinematics import sweep_variants as sweep_variants
    from jounce.kinematics import write_sweep as write_sweep
    from jounce.papers.audi_a6 import run_audi_a6 as run_audi_a6
    from jounce.papers.audi_a6_exciter import run_eccentric_exciter as run_eccentric_exciter
    from jounce.parts import FullCar as FullCar
    from jounce.parts import FullCar3D as FullCar3D
    from jounce.parts import HalfCar as HalfCar
    from jounce.parts import HalfCar4DOF as HalfCar4DOF
    from jounce.parts import QuarterCar as QuarterCar
    from jounce.parts import Rig as Rig
    from jounce.parts import Vehicle as Vehicle
    from jounce.parts import load as load
    from jounce.parts.front_view import axle_of as axle_of
    from jounce.parts.importers import read_tir as read_tir
    from jounce.parts.importers import tyre_from_tir as tyre_from_tir
    from jounce.parts.strut_angle import with_strut_angle as with_strut_angle
    from jounce.parts.testers import Tester as Tester
    from jounce.parts.testers import load_tester as load_tester
    from jounce.recordings import Sensor as Sensor
    from jounce.recordings import apply_sensors as apply_sensors
    from jounce.recordings import read_recording as read_recording
    from jounce.recordings import write_recording as write_recording
    from jounce.report.protocol import write_protocol as write_protocol
    from jounce.ride.closed_forms import spring_and_damper as spring_and_damper
    from jounce.ride.comparison import compare_rides as compare_rides
    from jounce.ride.comparison import drive as drive
    from jounce.ride.metrics import RideMetrics as RideMetrics
    from jounce.ride.metrics import ride_metrics as ride_metrics
    from jounce.ride.spectra import power_spectrum as power_spectrum
    from jounce.ride.spectra import transfer_function as transfer_function
    from jounce.ride.stationary import stationary as stationary
    from jounce.ride.trials import iso_trial as iso_trial
    from jounce.ride.trials import road_trial as road_trial
    from jounce.roads import CircularSegment as CircularSegment
    from jounce.roads import Crg as Crg
    from jounce.roads import Enveloped as Enveloped
    from jounce.roads import Excitation as Excitation
    from jounce.roads import Flat as Flat
    from jounce.roads import HalfCylinder as HalfCylinder
    from jounce.roads import HalfSine as HalfSine
    from jounce.roads import Iso8608 as Iso8608
    from jounce.roads import Kerb as Kerb
    from jounce.roads import Pothole as Pothole
    from jounce.roads import Ramp as Ramp
    from jounce.roads import Rectangle as Rectangle
    from jounce.roads import Sine as Sine
    from jounce.roads import SineSum as SineSum
    from jounce.roads import SineSweep as SineSweep
    from jounce.roads import Step as Step
    from jounce.roads import Table as Table
    from jounce.roads import Train as Train
    from jounce.roads import Trapezoid as Trapezoid
    from jounce.roads import Trial as Trial
    from jounce.roads import Triangle as Triangle
    from jounce.roads import Versine as Versine
    from jounce.roads import load_road as load_road
    from jounce.roads import road_psd as road_psd
    from jounce.roads import swept_sine as swept_sine
    from jounce.roads import white_noise_intensity as white_noise_intensity
    from jounce.roughness.iri import Roughness as Roughness
    from jounce.roughness.iri import iri as iri
    from jounce.roughness.spectra import estimate_roughness as estimate_roughness
    from jounce.simulation import Gradient as Gradient
    from jounce.simulation import LinearModel as LinearModel
    from jounce.simulation import Mode as Mode
    from jounce.simulation import equilibrium as equilibrium
    from jounce.simulation import gradient as gradient
    from jounce.simulation import linearise as linearise
    from jounce.simulation import modes as modes
    from jounce.simulation import sensitivities as sensitivities
    from jounce.simulation import simulate as simulate
    from jounce.simulation import simulate_mechanism as simulate_mechanism
    from jounce.simulation.corner_models import corner_models as corner_models
    from jounce.simulation.environment import ride_environment as ride_environment
    from jounce.simulation.stability import closed_loop_poles as closed_loop_poles
    from jounce.testers.plate_response import steady_response as steady_response
    from jounce.testers.testing import simulate_test as simulate_test

    __version__: str

_PUBLIC = {  # public name -> module that defines it; a module itself is its own value
    "ADD": "jounce.control",
    "ActiveActuator": "jounce.control",
    "AssemblyError": "jounce.core.errors",
    "AxleLayout": "jounce.kinematics",
    "CircularSegment": "jounce.roads",
    "ContactLoad": "jounce.kinematics",
    "Controller": "jounce.control",
    "Crg": "jounce.roads",
    "DescriptionError": "jounce.core.errors",
    "Enveloped": "jounce.roads",
    "Excitation": "jounce.roads",
    "Finding": "jounce.core.findings",
    "FitError": "jounce.core.errors",
    "FitTrial": "jounce.identify.update",
    "Flat": "jounce.roads",
    "ForceDeflectionTrial": "jounce.identify.force_deflection",
    "FullCar": "jounce.parts",
    "FullCar3D": "jounce.parts",
    "Gradient": "jounce.simulation",
    "Groundhook": "jounce.control",
    "HInfinity": "jounce.control",
    "HalfCar": "jounce.parts",
    "HalfCar4DOF": "jounce.parts",
    "HalfCylinder": "jounce.roads",
    "HalfSine": "jounce.roads",
    "Hybrid": "jounce.control",
    "Iso8608": "jounce.roads",
    "JounceError": "jounce.core.errors",
    "Kerb": "jounce.roads",
    "LQG": "jounce.control",
    "LQR": "jounce.control",
    "LinearModel": "jounce.simulation",
    "MagnetorheologicalDamper": "jounce.control",
    "Mode": "jounce.simulation",
    "OutputError": "jounce.core.errors",
    "PID": "jounce.control",
    "Passive": "jounce.control",
    "Pothole": "jounce.roads",
    "PreviewMPC": "jounce.control",
    "PythonControl": "jounce.control",
    "QuarterCar": "jounce.parts",
    "Ramp": "jounce.roads",
    "RecordingError": "jounce.core.errors",
    "Rectangle": "jounce.roads",
    "RideMetrics": "jounce.ride.metrics",
    "Rig": "jounce.parts",
    "Roughness": "jounce.roughness.iri",
    "SHADD": "jounce.control",
    "SemiActiveDamper": "jounce.control",
    "Sensor": "jounce.recordings",
    "SimulationError": "jounce.core.errors",
    "Sine": "jounce.roads",
    "SineSum": "jounce.roads",
    "SineSweep": "jounce.roads",
    "Skyhook": "jounce.control",
    "Step": "jounce.roads",
    "Table": "jounce.roads",
    "Tester": "jounce.parts.testers",
    "Train": "jounce.roads",
    "Trapezoid": "jounce.roads",
    "Trial": "jounce.roads",
    "Triangle": "jounce.roads",
    "TwoStateGroundhook": "jounce.control",
    "TwoStateSkyhook": "jounce.control",
    "UpdateResult": "jounce.identify.update",
    "UpdatedParameter": "jounce.identify.update",
    "Vehicle": "jounce.parts",
    "Versine": "jounce.roads",
    "adjust_report": "jounce.design.adjustment_effects",
    "adjusted": "jounce.design.adjustments",
    "apply_sensors": "jounce.recordings",
    "axle_of": "jounce.parts.front_view",
    "best_dampers": "jounce.design.first_designs",
    "closed_loop_poles": "jounce.simulation.stability",
    "compare_models": "jounce.design.model_comparison",
    "compare_rides": "jounce.ride.comparison",
    "compare_tests": "jounce.inspection.equivalence",
    "compliance": "jounce.kinematics",
    "controller": "jounce.control",
    "corner_models": "jounce.simulation.corner_models",
    "design_springs": "jounce.design.first_designs",
    "drive": "jounce.ride.comparison",
    "equilibrium": "jounce.simulation",
    "estimate_roughness": "jounce.roughness.spectra",
    "evaluate": "jounce.inspection.evaluation",
    "fit_damper": "jounce.identify.damper_fit",
    "fit_decay": "jounce.identify.decay",
    "fit_stiffness": "jounce.identify.stiffness",
    "grade": "jounce.inspection.verdicts.grading",
    "gradient": "jounce.simulation",
    "iri": "jounce.roughness.iri",
    "iso_trial": "jounce.ride.trials",
    "lengths_for": "jounce.design.adjustment_effects",
    "linearise": "jounce.simulation",
    "load": "jounce.parts",
    "load_limits": "jounce.inspection.verdicts.limits",
    "load_road": "jounce.roads",
    "load_tester": "jounce.parts.testers",
    "lumped_from": "jounce.design.lumping",
    "mechanics": "jounce.mechanics",
    "modes": "jounce.simulation",
    "optimise": "jounce.design.optimise",
    "pareto": "jounce.design.pareto",
    "pickup_loads": "jounce.kinematics",
    "plots": "jounce.plots",
    "power_spectrum": "jounce.ride.spectra",
    "read_record": "jounce.inspection.record",
    "read_recording": "jounce.recordings",
    "read_tir": "jounce.parts.importers",
    "ride_environment": "jounce.simulation.environment",
    "ride_metrics": "jounce.ride.metrics",
    "road_psd": "jounce.roads",
    "road_trial": "jounce.ride.trials",
    "run_audi_a6": "jounce.papers.audi_a6",
    "run_campaign": "jounce.campaign",
    "run_eccentric_exciter": "jounce.papers.audi_a6_exciter",
    "sensitivities": "jounce.simulation",
    "simulate": "jounce.simulation",
    "simulate_axle": "jounce.inspection.simulated",
    "simulate_inspection": "jounce.inspection.simulated",
    "simulate_mechanism": "jounce.simulation",
    "simulate_test": "jounce.testers.testing",
    "speed_sweep": "jounce.campaign.speed_sweep",
    "spring_and_damper": "jounce.ride.closed_forms",
    "stationary": "jounce.ride.stationary",
    "steady_response": "jounce.testers.plate_response",
    "sweep_rack": "jounce.kinematics",
    "sweep_roll": "jounce.kinematics",
    "sweep_steering": "jounce.kinematics",
    "sweep_travel": "jounce.kinematics",
    "sweep_variants": "jounce.kinematics",
    "swept_sine": "jounce.roads",
    "transfer_function": "jounce.ride.spectra",
    "tyre_from_tir": "jounce.parts.importers",
    "update_model": "jounce.identify.update",
    "white_noise_intensity": "jounce.roads",
    "with_strut_angle": "jounce.parts.strut_angle",
    "write_protocol": "jounce.report.protocol",
    "write_recording": "jounce.recordings",
    "write_sweep": "jounce.kinematics",
}


def __getattr__(name: str) -> object:
    from importlib import import_module, metadata

    if name == "__version__":
        value: object = metadata.version("jounce")
    elif name in _PUBLIC:
        module = import_module(_PUBLIC[name])
        value = module if _PUBLIC[name] == f"jounce.{name}" else getattr(module, name)
    else:
        from jounce.core.errors import nearest

        raise AttributeError(f"module 'jounce' has no attribute {name!r}. {nearest(name, _PUBLIC)}".rstrip())
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*_PUBLIC, "__version__", "__doc__", "__name__"})
