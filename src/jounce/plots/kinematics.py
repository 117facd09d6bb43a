"""Kinematic quantities against travel, rack or roll: sheets of curves, grouped by subject."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import display_unit
from jounce.core.errors import RecordingError, nearest
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.writing import write_files
from jounce.plots.display import FAR_AWAY, PARALLEL, settle
from jounce.plots.figures import (
    MUTED,
    PALETTE,
    columns_of,
    in_legend,
    in_style,
    legend_outside,
    new_figure,
    render_figure,
)

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.kinematics.clearance_study import ClearanceStudy
    from jounce.kinematics.swept import Swept

_GRADIENTS = (
    "roll_steer",
    "roll_camber",
    "roll_caster",
    "kingpin_inclination_gain",
    "camber_per_steer",
)
_HANDWHEEL = ("steering_ratio", "c_factor", "handwheel_angle", "rack_force", "handwheel_torque")
_ROCKER = ("rocker_angle", "pushrod_angle", "rocker_spring_angle")
_FURTHER_SPRINGS = (
    "torsion_bar_angle",
    "torsion_bar_motion_ratio",
    "torsion_bar_torque",
    "third_spring_length",
    "third_spring_motion_ratio",
    "third_spring_force",
    "third_wheel_rate",
    "heave_rate",
    "anti_roll_bar_angle",
    "anti_roll_bar_arm_angle",
    "anti_roll_bar_twist",
    "anti_roll_bar_torque",
    "anti_roll_bar_rate",
    "roll_stiffness_total",
    "axle_force",
)
SHEETS: dict[str, tuple[str, ...]] = {
    "wheel": (
        "camber",
        "toe",
        "camber_to_ground",
        "inclination",
        "steer",
        "half_track_change",
        "track",
        "axle_steer",
        "axle_roll",
        "lateral_shift",
        "longitudinal_shift",
        "wheelbase_change",
    ),
    "gradients": (
        "camber_gain",
        "bump_steer",
        "caster_gain",
        "half_track_gradient",
        *_GRADIENTS,
    ),
    "steering": (
        "caster",
        "kingpin_inclination",
        "caster_trail",
        "scrub_radius",
        "spindle_offset",
        "wheel_centre_caster_offset",
        "caster_trail_wheel",
        "scrub_radius_wheel",
        "steer_gain",
        "ackermann",
        "ackermann_error",
        "turn_diameter_kerbs",
        *_HANDWHEEL,
    ),
    "centres": (
        "roll_centre_height",
        "roll_centre_y",
        "roll_axis_inclination",
        "jacking",
        "instant_centre_y",
        "instant_centre_z",
        "side_instant_centre_x",
        "side_instant_centre_z",
        "front_view_swing_arm_length",
        "side_view_swing_arm_length",
        "front_view_swing_arm_angle",
        "side_view_swing_arm_angle",
        "contact_patch_recession",
        "wheel_centre_longitudinal_slope",
        "wheel_centre_recession",
        "anti_dive",
        "anti_lift",
        "anti_squat",
        "dive_per_g",
        "lift_per_g",
        "squat_per_g",
    ),
    "springs": (
        "spring_length",
        "motion_ratio",
        "motion_ratio_roll",
        "motion_ratio_gradient",
        "damper_motion_ratio",
        "spring_force",
        "stop_force",
        "damper_force",
        "wheel_force",
        "wheel_rate",
        "wheel_rate_roll",
        "wheel_rate_spring",
        "wheel_damping_coefficient",
        "ride_rate",
        "roll_moment",
        "roll_stiffness",
        *_ROCKER,
        *_FURTHER_SPRINGS,
    ),
}
"""Quantities of each sheet; quantities not listed are drawn on the last sheet."""
_OTHERS = "others"
_COLUMNS = 3
_TO_INFINITY = (
    "instant_centre",
    "swing_arm",
    "turning_radius",
    "turn_diameter",
    "roll_centre_y",
    "ackermann",
)
_ASYMPTOTE = (
    8.0  # curves that exceed their middle half by this multiple of its width are taken to diverge
)
_MOST_LINES = 5


@in_style
def kinematic_curves(
    sweep: xr.Dataset | Mapping[str, xr.Dataset], quantities: Sequence[str] | None = None
) -> Figure:
    """Draw quantities of a kinematic sweep, or of several sweeps together, each in its own axes.

    Left and right wheel of an axle share axes. For sweeps over travel and rack, up to five rack positions are drawn as
    lines. Curves that diverge (instant centres) are cut off.

    Parameters
    ----------
    sweep : xarray.Dataset, or mapping of str to xarray.Dataset
        Result of :func:`jounce.sweep_travel` or a similar function; SI, shown in usual units (mm, °, N/mm). A mapping
        of sweeps over the same travel, rack or roll compares variants by name.
    quantities : sequence of str, optional
        Quantities to draw; by default camber, toe, half-track change, caster, roll-centre height and motion ratio.

    Returns
    -------
    matplotlib.figure.Figure
        Sheet of curves.

    Raises
    ------
    RecordingError
        For a quantity missing in a sweep, a dataset that is not a sweep, or sweeps over different quantities.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> sweep = jn.sweep_travel(jn.load("reference-double-wishbone"), np.linspace(-0.08, 0.08, 41))
    >>> [axes.get_title("left") for axes in kinematic_curves(sweep, ["camber", "toe"]).axes]
    ['camber [°]', 'toe [°]']
    """
    default = ("camber", "toe", "half_track_change", "caster", "roll_centre_height", "motion_ratio")
    import xarray as xr

    sweeps: dict[str, xr.Dataset] = {"": sweep} if isinstance(sweep, xr.Dataset) else dict(sweep)
    if not sweeps:
        raise RecordingError("no sweeps to draw", allowed="one or more")
    known = [name for name in _quantities(next(iter(sweeps.values()))) if _all_have(sweeps, name)]
    over = {_along(data) for data in sweeps.values()}
    if len(over) > 1:
        raise RecordingError(
            "sweeps over different quantities", found=", ".join(sorted(over)), allowed="one of them"
        )
    for name in quantities or ():
        if name not in known:
            raise RecordingError(
                Phrase("no quantity {name!r}", name=name),
                allowed=", ".join(known),
                hint=nearest(name, known),
            )
    names = list(quantities) if quantities else [name for name in default if name in known]
    if not names:
        raise RecordingError(
            "no kinematic quantities",
            found=", ".join(map(str, next(iter(sweeps.values())))) or "none",
        )
    columns = columns_of(len(names), _COLUMNS)
    rows = -(-len(names) // columns)
    figure = new_figure(0.5 + 1.9 * rows, 3.3 * columns if columns < _COLUMNS else 9.6)
    grid = figure.subplots(rows, columns, sharex=True, squeeze=False)
    for axes, name in zip(grid.flat, names, strict=False):
        _draw(axes, sweeps, name)
    _finish(figure, grid, next(iter(sweeps.values())), len(names))
    return figure


def steering_effort(sweep: Swept, *, title: str) -> Figure:  # noqa: ARG001 - written above the figure
    """Draw the rack force and the steering column torques over a sweep, as far as they are known."""
    names = ("rack_force", "pinion_torque", "handwheel_torque")
    return kinematic_curves(sweep.data, [name for name in names if name in sweep.data])


def clearances(study: ClearanceStudy, *, title: str) -> Figure:  # noqa: ARG001 - written above the figure
    """Draw all distances over travel and rack."""
    assert study.data is not None
    return kinematic_curves(study.data, list(map(str, study.data.data_vars)))


def write_swept(sweep: Swept, folder: Path | str, *, force: bool = False) -> list[Path]:
    """Draw all quantities of a sweep to files in a folder, as :func:`write_kinematics` does."""
    return write_kinematics(sweep.data, folder, force=force)


def write_kinematics(sweep: xr.Dataset, folder: Path | str, *, force: bool = False) -> list[Path]:
    """Draw all quantities of a sweep to files in a folder, one PNG per subject.

    Parameters
    ----------
    sweep : xarray.Dataset
        A kinematic sweep, SI.
    folder : Path or str
        Destination, created if missing.
    force : bool
        Overwrite existing files.

    Returns
    -------
    list of Path
        The files: ``wheel.png``, ``gradients.png``, ``steering.png``, ``centres.png``, ``springs.png``, ``others.png``.

    Raises
    ------
    OutputError
        For existing files without ``force``.
    """
    known = _quantities(sweep)
    sheets = {sheet: [name for name in names if name in known] for sheet, names in SHEETS.items()}
    drawn = {name for names in sheets.values() for name in names}
    sheets[_OTHERS] = [name for name in known if name not in drawn]
    contents: dict[str, bytes | str] = {
        f"{sheet}.png": render_figure(kinematic_curves(sweep, names), [".png"])[".png"]
        for sheet, names in sheets.items()
        if names
    }
    return write_files(folder, contents, force=force)


def _quantities(sweep: xr.Dataset) -> list[str]:
    """Names of the quantities without the side of an axle; positions of points are omitted."""
    names = [
        str(name) for name in sweep.data_vars if sweep[name].dims and "sign" in sweep[name].attrs
    ]
    bare = [name.removeprefix("left.").removeprefix("right.") for name in names]
    return [name for name in dict.fromkeys(bare) if name[-2:] not in (".x", ".y", ".z")]


def _all_have(sweeps: Mapping[str, xr.Dataset], name: str) -> bool:
    return all(name in _quantities(data) for data in sweeps.values())


def _along(sweep: xr.Dataset) -> str:
    return str(next(iter(sweep.dims)))


def _draw(axes: Axes, sweeps: Mapping[str, xr.Dataset], name: str) -> None:
    first = next(iter(sweeps.values()))
    along = _along(first)
    lines, places = [], []
    for label, sweep in sweeps.items():
        own = _lines(sweep, name, along)
        lines += [
            (", ".join(filter(None, (in_legend(label), words))), values, which)
            for words, values, which in own
        ]
        places += [sweep[along].to_numpy()] * len(own)
    si = str(first[lines[0][2]].attrs.get("units", "1"))
    if si == "m" and any(word in name for word in FAR_AWAY):
        lines = [
            (label, np.where(np.abs(values) < PARALLEL, values, np.nan), variable)
            for label, values, variable in lines
        ]
    lines = [(label, settle(values, si), variable) for label, values, variable in lines]
    if any(word in name for word in _TO_INFINITY):
        lines = [(label, _cut(values), variable) for label, values, variable in lines]
    everything = np.concatenate([values for _, values, _ in lines])
    finite = everything[np.isfinite(everything)]
    largest = float(np.max(np.abs(finite), initial=0.0))
    unit = display_unit(si, largest)
    across = display_unit(str(first[along].attrs.get("units", "1")))
    for k, ((label, values, _), place) in enumerate(zip(lines, places, strict=True)):
        x = place * across.factor
        mark = "." if len(x) < 12 else None
        axes.plot(
            x, values * unit.factor, color=PALETTE[k % len(PALETTE)], label=label, marker=mark
        )
    axes.set_title(unit.label(name.replace("_", " ")), loc="left")
    axes.axvline(0.0, color=MUTED, linewidth=0.6, zorder=0.5)
    if not finite.size and any(word in name for word in FAR_AWAY):
        axes.text(
            0.5, 0.5, "parallel", ha="center", va="center", color=MUTED, transform=axes.transAxes
        )
    _steady(axes, finite * unit.factor)


def _lines(sweep: xr.Dataset, name: str, along: str) -> list[tuple[str, Array, str]]:
    """Label, values and variable of each line."""
    sides = [side for side in ("left", "right") if f"{side}.{name}" in sweep]
    if name not in sweep:
        return [(side, sweep[f"{side}.{name}"].to_numpy(), f"{side}.{name}") for side in sides]
    variable = sweep[name]
    others = [str(dimension) for dimension in variable.dims if dimension != along]
    if not others:
        return [("", variable.to_numpy(), name)]
    other = others[0]
    unit = display_unit(str(sweep[other].attrs.get("units", "1")))
    count = sweep.sizes[other]
    at = np.unique(np.linspace(0, count - 1, min(count, _MOST_LINES)).round().astype(int))
    words = other.split("_", maxsplit=1)[0]
    return [
        (
            f"{words} {float(sweep[other][k]) * unit.factor:.4g} {unit.name}".replace("-", "−"),
            variable.isel({other: k}).to_numpy(),
            name,
        )
        for k in at
    ]


def _cut(values: Array) -> Array:
    """Replace diverging values by gaps to keep the rest visible."""
    finite = values[np.isfinite(values)]
    if len(finite) < 4:
        return np.where(np.isfinite(values), values, np.nan)
    low, middle, high = np.quantile(finite, [0.25, 0.5, 0.75])
    width = max(high - low, 1e-3 * abs(middle))
    near = np.abs(values - middle) <= _ASYMPTOTE * width if width > 0.0 else np.isfinite(values)
    return np.where(near & np.isfinite(values), values, np.nan)


def _steady(axes: Axes, values: Array) -> None:
    """Set limits above and below a constant curve, to keep rounding errors from being drawn as a wave."""
    if not len(values):
        return
    middle = float(np.mean(values))
    if np.ptp(values) <= 1e-9 * max(abs(middle), 1e-6):
        room = 0.1 * abs(middle) or 1.0
        axes.set_ylim(middle - room, middle + room)


def _finish(figure: Figure, grid: Any, sweep: xr.Dataset, count: int) -> None:
    """Label the lowest axes of each column, hide empty axes, and add one legend."""
    columns = grid.shape[1]
    along = _along(sweep)
    unit = display_unit(str(sweep[along].attrs.get("units", "1")))
    for i, axes in enumerate(grid.flat):
        if i >= count:
            axes.set_visible(False)
        elif i + columns >= count:
            axes.set_xlabel(unit.label(along.replace("_", " ")))
            axes.tick_params(labelbottom=True)
    handles, labels = grid.flat[0].get_legend_handles_labels()
    if any(labels):
        legend_outside(figure, handles, labels, 2 * columns)
