"""Draw any result with one function: ``jn.plots.show(result)``."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import singledispatch
from typing import TYPE_CHECKING, Any

from jounce.core.errors import JounceError
from jounce.core.writing import lasting_folder
from jounce.plots import (
    analysis,
    audi_a6,
    campaign,
    damper_histograms,
    dampers,
    design,
    fits,
    inspection,
    kinematic_design,
    kinematics,
    signals,
    speed_limits,
    springs,
    variants,
)
from jounce.plots.figures import write_figure
from jounce.plots.mechanisms import mechanism

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure_of(result: object, **options: Any) -> Figure:
    """Draw any result of jounce with the drawing function for its type.

    Parameters
    ----------
    result : object
        A 3-D rig, a recording or its analysis, many runs, a ride or a comparison of controllers, an Audi A6 study, a
        study over speed, a road (or several by name), a fit, an update (or several), a trial or all trials of a
        campaign, a campaign's result, a linear model, modes, an optimisation, a Pareto front, hardpoints designed for
        targets with their fronts and spreads, or hardpoints fitted to measured poses.
    **options
        Passed to that function, e.g. ``channels=`` for a recording or ``trials=`` for a stiffness.

    Returns
    -------
    matplotlib.figure.Figure
        The figure; :func:`write_figure` writes it.

    Raises
    ------
    JounceError
        For a type that has no figure.

    Examples
    --------
    >>> import jounce as jn
    >>> figure_of(jn.HalfSine(height="10 mm", length="60 mm")).axes[0].get_ylabel()
    'height [mm]'
    """
    figure: Figure = _drawing()(result, **options)
    return figure


def show(result: object, **options: Any) -> Figure:
    """Draw any result and display it in a notebook, or in the image viewer of the desktop.

    Parameters
    ----------
    result : object
        See :func:`figure_of`.
    **options
        Passed to the drawing function.

    Returns
    -------
    matplotlib.figure.Figure
        The figure, even if there is neither a notebook nor a desktop to display it.
    """
    figure = figure_of(result, **options)
    if "ipykernel" in sys.modules:
        from IPython.display import display

        display(figure)  # not shown again as the result of the cell
    elif (
        sys.platform in ("win32", "darwin")
        or os.environ.get("DISPLAY")
        or os.environ.get("WAYLAND_DISPLAY")
    ):
        import webbrowser

        webbrowser.open(write_figure(figure, lasting_folder() / "figure.png").as_uri())
    return figure


def _drawing() -> Callable[..., Figure]:
    """Build the dispatcher on first use: it needs the types of all packages, which are slow to import."""
    global _dispatcher  # noqa: PLW0603 - made once per process
    if _dispatcher is None:
        _dispatcher = _register()
    return _dispatcher


_dispatcher: Callable[..., Figure] | None = None


def _register() -> Callable[..., Figure]:
    import xarray as xr

    from jounce.analysis.integrate import Integration
    from jounce.analysis.modes import FittedModes
    from jounce.analysis.spectrum import RecordSpectra
    from jounce.analysis.statistics import RecordStatistics
    from jounce.analysis.transfer import TransferEstimate
    from jounce.campaign.bench_fits import MeasuredDamper, MeasuredDecays, MeasuredStiffness
    from jounce.campaign.result import CampaignResult
    from jounce.campaign.strategy_result import StrategyResult
    from jounce.campaign.trial_result import TrialResult
    from jounce.dampers.compared import DamperComparison
    from jounce.dampers.histograms import DamperHistograms
    from jounce.dampers.map import DamperMap
    from jounce.dampers.sheet import DamperSheet
    from jounce.design.best_design import BestDesign
    from jounce.design.clicks import ChosenClicks
    from jounce.design.goal_front import DesignFront
    from jounce.design.hardpoint_front import KinematicFront
    from jounce.design.kinematics import KinematicDesign
    from jounce.design.measured_poses import HardpointFit
    from jounce.design.model_comparison import LumpedComparison, ModelComparison
    from jounce.design.optimise import Optimisation
    from jounce.design.pareto import ParetoFront
    from jounce.design.spread import KinematicSpread
    from jounce.design.studied import StudiedDesign
    from jounce.identify.calibration import Calibration
    from jounce.identify.damper_result import DamperCurve
    from jounce.identify.decay import DecayResult
    from jounce.identify.stiffness import PressureStiffness, StiffnessResult
    from jounce.identify.update import UpdateResult
    from jounce.inspection.equivalence import Equivalence
    from jounce.inspection.grading import GradedInspection
    from jounce.inspection.result import Inspection
    from jounce.papers.audi_a6 import AudiCase
    from jounce.papers.audi_a6_exciter import EccentricExciter
    from jounce.parts.corners import Corner
    from jounce.ride.modal import ModalAnalysis
    from jounce.ride.study import Ride, RideStudy
    from jounce.roads.road import Road
    from jounce.roughness.iri import ProfileRoughness
    from jounce.simulation import LinearModel, Mode
    from jounce.simulation.trial_run import TrialRun
    from jounce.springs.map import SpringMap
    from jounce.variants.limits import SpeedLimits

    @singledispatch
    def draw(result: object, **options: Any) -> Figure:  # noqa: ARG001
        kinds = ", ".join(sorted(kind.__name__ for kind in draw.registry if kind is not object))
        raise JounceError(
            "there is no figure for this type", found=type(result).__name__, allowed=kinds
        )

    def of_dataset(result: xr.Dataset, **options: Any) -> Figure:
        if "variant" in result.dims and "reason" in result:
            has_metrics = any(
                variable.dims == ("variant",) and variable.dtype.kind == "f"
                for variable in result.data_vars.values()
            )
            return (variants.tornado if has_metrics else variants.variant_bands)(result, **options)
        if "time" in result.dims:
            return signals.time_history(result, **options)
        swept = {"wheel_travel", "rack_travel", "roll_angle"} & set(map(str, result.dims))
        return (kinematics.kinematic_curves if swept else signals.sweep)(result, **options)

    def of_mapping(result: Mapping[str, Any], **options: Any) -> Figure:
        if result and all(isinstance(item, Road) for item in result.values()):
            return signals.road_profile(result, **options)
        return draw(object(), **options)

    def of_sequence(result: Sequence[Any], **options: Any) -> Figure:
        drawings = {
            TrialResult: campaign.trial_matrix, UpdateResult: fits.objectives, Mode: signals.modes,
            Ride: design.ride_spectra,
        }  # fmt: skip
        for kind, function in drawings.items():
            if result and all(isinstance(item, kind) for item in result):
                return function(result, **options)  # type: ignore[operator,no-any-return]
        return draw(object(), **options)

    def of_damper(result: DamperCurve, law: str = "fitted", **options: Any) -> Figure:
        return fits.damper_loops(
            result.displacement, result.velocity, result.measured, {law: result.fitted}, **options
        )

    draw.register(xr.Dataset, of_dataset)
    draw.register(dict, of_mapping)
    draw.register(list, of_sequence)
    draw.register(tuple, of_sequence)
    draw.register(Road, signals.road_profile)
    draw.register(RecordStatistics, analysis.channel_statistics)
    draw.register(RecordSpectra, analysis.channel_spectra)
    draw.register(TransferEstimate, analysis.transfer_estimate)
    draw.register(FittedModes, analysis.measured_modes)
    draw.register(Integration, analysis.integrated_motion)
    draw.register(LinearModel, signals.frequency_response)
    draw.register(
        TrialRun, lambda result, **options: signals.time_history(result.recording(), **options)
    )
    draw.register(ModalAnalysis, lambda result: signals.modes(result.modes))
    draw.register(
        ProfileRoughness,
        lambda result: signals.roughness(result.roughness, result.distance, result.height),
    )
    draw.register(Corner, mechanism)
    draw.register(KinematicDesign, kinematic_design.target_curves)
    draw.register(StudiedDesign, lambda result, **options: draw(result.design, **options))
    draw.register(KinematicFront, kinematic_design.front_lines)
    draw.register(KinematicSpread, kinematic_design.spread_bands)
    draw.register(HardpointFit, kinematic_design.hardpoint_fit)
    draw.register(StiffnessResult, fits.stiffness_fit)
    draw.register(PressureStiffness, fits.tyre_pressure)
    draw.register(DecayResult, fits.decay_fit)
    draw.register(Calibration, fits.calibration_fit)
    draw.register(DamperCurve, of_damper)
    draw.register(DamperMap, dampers.damper_map_curves)
    draw.register(DamperSheet, dampers.damper_set)
    draw.register(DamperComparison, dampers.damper_comparison)
    draw.register(ChosenClicks, dampers.chosen_clicks)
    draw.register(SpeedLimits, speed_limits.speed_limit_curves)
    draw.register(DamperHistograms, damper_histograms.damper_histogram_bars)
    draw.register(SpringMap, springs.spring_map_curves)
    draw.register(
        MeasuredDamper, lambda result, **options: of_damper(result.curve, result.fit.law, **options)
    )
    draw.register(
        MeasuredDecays,
        lambda result, **options: fits.decay_fit(*next(iter(result.decays.values())), **options),
    )
    draw.register(
        MeasuredStiffness,
        lambda result, **options: fits.stiffness_fit(result.fit, result.measured.trials, **options),
    )
    draw.register(UpdateResult, fits.update)
    draw.register(StrategyResult, lambda result, **options: fits.update(result.update, **options))
    draw.register(TrialResult, campaign.measured_against_simulated)
    draw.register(
        CampaignResult, lambda result, **options: campaign.trial_matrix(result.trials, **options)
    )
    draw.register(Optimisation, design.optimisation)
    draw.register(BestDesign, lambda result, **options: draw(result.outcome, **options))
    draw.register(ParetoFront, design.pareto_front)
    draw.register(DesignFront, design.design_front)
    draw.register(RideStudy, design.trade_off)
    draw.register(LumpedComparison, lambda result, **options: draw(result.comparison, **options))
    draw.register(
        ModelComparison,
        lambda result, **options: signals.sweep(result.curves(), along="travel", **options),
    )
    draw.register(Ride, lambda result, **options: design.ride_spectra([result], **options))
    draw.register(
        AudiCase,
        lambda result, **options: audi_a6.case_overview(result, result.runs[0].moment, **options),
    )
    draw.register(EccentricExciter, audi_a6.exciter_spring)
    draw.register(Equivalence, inspection.equivalence)
    draw.register(Inspection, inspection.inspection_curves)
    draw.register(
        GradedInspection,
        lambda result, **options: inspection.inspection_curves(result.inspection, **options),
    )
    return draw
