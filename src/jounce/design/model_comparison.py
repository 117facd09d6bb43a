"""Differences between a lumped model and the corner that it represents, with their reasons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.operation import File, Number, Texts, operation
from jounce.core.serialise import Plain, to_plain
from jounce.core.shown import Shown
from jounce.core.typed import positive_quantity
from jounce.core.types import Array
from jounce.design.lumping import Lumping, lump, lumped_from
from jounce.kinematics import sweep_travel
from jounce.parts import Corner, QuarterCar, Rig, as_rig
from jounce.roads import HalfSine, Trial, load_road
from jounce.simulation import Mode, linearise, modes, simulate

if TYPE_CHECKING:
    import xarray as xr

R = TypeVar("R", bound=Rig)
CHANNELS = ("sprung.az", "unsprung.az", "tyre.force")
"""Channels whose peak absolute values are compared."""
_REACH = 0.15
"""Travel to either side of the curves, as a share of the wheel's radius."""
_POINTS = 13  # of a curve over travel
_SAME_LINE = 1e-6  # of a motion ratio: differences below are rounding


@dataclass(frozen=True)
class ModelDifference:
    """A quantity in both models, SI, and the reason for the difference; None if a model does not have it."""

    quantity: str
    unit: str
    spatial: float | None
    lumped: float | None
    why: str


@dataclass(frozen=True)
class PeakDifference:
    """Peak absolute value of a channel in one trial in both models, SI."""

    trial: str
    channel: str
    unit: str
    spatial: float
    lumped: float

    @property
    def relative(self) -> float:
        """Relative difference: lumped over 3-D, minus 1."""
        return self.lumped / self.spatial - 1.0


@dataclass(frozen=True)
class ModelComparison(Shown):
    """A corner and a lumped model of it, side by side.

    Attributes
    ----------
    lumping : Lumping
        Properties of the corner referred to the wheel, with the share of each body.
    lumped : QuarterCar
        The lumped model.
    rows : tuple of Difference
        Quantities about rest.
    travel : ndarray, shape (n,)
        Wheel travel from design, m.
    motion_ratio, wheel_rate : ndarray, shape (n,)
        Corner over travel: shortening of the spring per rise of the wheel [1]; wheel rate with the preload term, N/m.
    lumped_motion_ratio, lumped_wheel_rate : float
        Constant values of the lumped model [1], N/m.
    peaks : tuple of PeakDifference
        Peaks of every trial.
    """

    lumping: Lumping
    lumped: QuarterCar
    rows: tuple[ModelDifference, ...]
    travel: Array
    motion_ratio: Array
    wheel_rate: Array
    lumped_motion_ratio: float
    lumped_wheel_rate: float
    peaks: tuple[PeakDifference, ...]

    def curves(self) -> xr.Dataset:
        """Return motion ratio and wheel rate of both models over travel."""
        import xarray as xr

        level = np.ones_like(self.travel)
        dimensions = ("travel", "model")
        return xr.Dataset(
            {
                "motion_ratio": (
                    dimensions,
                    np.column_stack([self.motion_ratio, self.lumped_motion_ratio * level]),
                    {"units": "1", "long_name": "motion ratio"},
                ),
                "wheel_rate": (
                    dimensions,
                    np.column_stack([self.wheel_rate, self.lumped_wheel_rate * level]),
                    {"units": "N/m", "long_name": "wheel rate"},
                ),
            },
            {
                "travel": (
                    "travel",
                    self.travel,
                    {"units": "m", "long_name": "wheel travel from design"},
                ),
                "model": ("model", ["3-D", "lumped"]),
            },
        )

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI."""
        masses = {
            "static_masses": self.lumping.static_masses,
            "effective_masses": self.lumping.effective_masses,
        }
        plain: dict[str, Any] = to_plain(
            {
                "rows": self.rows,
                "travel": self.travel,
                "motion_ratio": self.motion_ratio,
                "wheel_rate": self.wheel_rate,
                "lumped_motion_ratio": self.lumped_motion_ratio,
                "lumped_wheel_rate": self.lumped_wheel_rate,
                "peaks": [{**to_plain(peak), "relative": peak.relative} for peak in self.peaks],
                "lumping": {
                    **to_plain(self.lumping),
                    **masses,
                    "inertance": self.lumping.inertance,
                },
                "lumped": self.lumped.parameters(),
            }
        )
        return plain


def compare_models(
    spatial: Rig, lumped: Rig | None = None, trials: Mapping[str, Trial] | Sequence[Trial] = ()
) -> ModelComparison:
    """Compare a lumped model with the corner that it represents.

    Parameters
    ----------
    spatial : Rig
        A 3-D rig whose body is free along z.
    lumped : Rig, optional
        A quarter car; by default the equivalent of the corner at equilibrium.
    trials : dict or sequence of Trial
        Trials to simulate with both models, by name.

    Returns
    -------
    ModelComparison
        Quantities about rest with the reason for every difference, curves over travel, peaks of every trial. Modes are
        computed without dry friction, which would block small motions.

    Raises
    ------
    DescriptionError
        If the rigs are not a 3-D and a lumped one.
    SimulationError
        If there is no equilibrium, or a trial diverges.

    Examples
    --------
    >>> import jounce as jn
    >>> found = compare_models(jn.load("kart-double-wishbone"), jn.load("kart-quarter-car"))
    >>> [row.quantity for row in found.rows][:3]
    ['motion ratio at rest', 'change of the motion ratio with travel', 'wheel rate']
    >>> round(found.lumped_wheel_rate, 1), round(found.lumping.wheel_rate_preload, 1)   # N/m
    (18362.0, 162.5)
    """
    if not isinstance(spatial, Corner):
        raise DescriptionError(
            "not a corner with hardpoints",
            where="spatial",
            found=getattr(spatial, "model", "a rig"),
        )
    own = lumped_from(spatial) if lumped is None else lumped
    if not isinstance(own, QuarterCar):
        raise DescriptionError(
            "not a quarter car", where="lumped", found=getattr(own, "model", "a rig")
        )
    named = (
        trials
        if isinstance(trials, Mapping)
        else {f"trial {i}": trial for i, trial in enumerate(trials, 1)}
    )
    peaks = [
        peak for name, trial in named.items() for peak in compare_peaks(name, spatial, own, trial)
    ]
    reach = _REACH * spatial.wheel.radius
    sweep = sweep_travel(spatial, np.linspace(-reach, reach, _POINTS))
    lumping, angle = lump(spatial), own.strut.angle
    rate, damping = _at_wheel(own)
    return ModelComparison(
        lumping,
        own,
        _rows(spatial, lumping, own, rate, damping),
        sweep["wheel_travel"].to_numpy(),
        sweep["motion_ratio"].to_numpy(),
        sweep["wheel_rate"].to_numpy(),
        float(np.cos(angle)),
        rate,
        tuple(peaks),
    )


def compare_peaks(
    name: str, spatial: Corner, lumped: QuarterCar, trial: Trial
) -> list[PeakDifference]:
    """Simulate both models; return the largest absolute values of accelerations (m/s^2) and tyre force (N)."""
    spatial_run, lumped_run = simulate(spatial, trial), simulate(lumped, trial)
    return [
        PeakDifference(
            name,
            channel,
            str(spatial_run[channel].attrs["units"]),
            float(np.abs(spatial_run[channel]).max()),
            float(np.abs(lumped_run[channel]).max()),
        )
        for channel in CHANNELS
    ]


def without_friction(rig: R) -> R:
    """Return the rig without dry friction."""
    table = rig.model_dump(by_alias=True, exclude_none=True)
    table["strut"].pop("friction", None)
    table.pop("guide_friction", None)
    if "guide" in table and isinstance(table["guide"], dict):
        table["guide"].pop("friction", None)
    return type(rig).from_table(table)


def _at_wheel(lumped: QuarterCar) -> tuple[float, float]:
    """Return rate (N/m) and damping coefficient (N s/m) of the strut at the wheel, about rest, without friction."""
    model = linearise(without_friction(lumped))
    row, mass = model.states.index("sprung.vz"), lumped.sprung.mass
    return tuple(
        -mass * float(model.A[row, model.states.index(name)]) for name in ("sprung.z", "sprung.vz")
    )  # type: ignore[return-value]


def _rows(
    spatial: Corner, lumping: Lumping, lumped: QuarterCar, rate: float, damping: float
) -> tuple[ModelDifference, ...]:
    sprung, unsprung = lumping.static_masses
    shares = ", ".join(
        f"{name} {1e3 * part.unsprung_mass:.0f} g" for name, part in lumping.shares.items()
    )
    turning = ", ".join(
        f"{name} {1e3 * part.inertance:+.0f} g" for name, part in lumping.shares.items()
    )
    ratio = float(np.cos(lumped.strut.angle))
    across = (
        f", {lumping.wheel_rate_across:+.4g} from third spring and Z-bar"
        if lumping.wheel_rate_across
        else ""
    )
    rows = [
        ModelDifference(
            "motion ratio at rest",
            "1",
            lumping.motion_ratio,
            ratio,
            "3-D: shortening of the spring over rise of the wheel centre, from the joints. Lumped: cosine of the "
            "strut's angle, as if it stood at the wheel.",
        ),
        *_damper_row(lumping, ratio),
        ModelDifference(
            "change of the motion ratio with travel",
            "1/m",
            lumping.motion_ratio_gradient,
            0.0,
            "The arm turns and the strut with it; a lumped strut keeps its angle.",
        ),
        ModelDifference(
            "wheel rate",
            "N/m",
            lumping.wheel_rate,
            rate,
            f"3-D: {1e-3 * lumping.wheel_rate_spring:.4g} N/mm from the spring's rate, "
            f"{1e-3 * lumping.wheel_rate_preload:+.3g} from its force of {lumping.spring_force:.4g} N where the motion "
            f"ratio changes, {1e-3 * lumping.wheel_rate_weight:+.2g} from weights{across}.",
        ),
        ModelDifference(
            "damping at the wheel",
            "N*s/m",
            lumping.wheel_damping,
            damping,
            "Damper's coefficient times its motion ratio squared.",
        ),
        ModelDifference(
            "sprung mass",
            "kg",
            sprung,
            lumped.sprung.mass,
            f"Body of {lumping.body_mass:.4g} kg and, by the law of the lever, the inner part of each arm.",
        ),
        ModelDifference(
            "unsprung mass",
            "kg",
            unsprung,
            lumped.unsprung.mass,
            f"Share that rises with the wheel: {shares}.",
        ),
        ModelDifference(
            "inertance between body and wheel",
            "kg",
            lumping.inertance,
            0.0,
            f"What turning and sideways motion take beyond those shares: {turning}. Two masses cannot have it.",
        ),
    ]
    return (*rows, *_mode_rows(modes(without_friction(spatial)), modes(without_friction(lumped))))


def _damper_row(lumping: Lumping, ratio: float) -> list[ModelDifference]:
    """Return the row for a damper that is not on the spring's line of action."""
    if abs(lumping.damper_ratio - lumping.motion_ratio) < _SAME_LINE:
        return []
    why = "Spring and damper have different lines of action; a lumped strut has one angle for both."
    return [
        ModelDifference("motion ratio of the damper at rest", "1", lumping.damper_ratio, ratio, why)
    ]


def _mode_rows(spatial: tuple[Mode, ...], lumped: tuple[Mode, ...]) -> list[ModelDifference]:
    """Return the oscillating modes of both models, the slower one first."""
    why = "Follows from the rates, damping, masses and inertance above."
    rows = []
    for name in ("body bounce", "wheel hop"):
        spatial_mode, lumped_mode = _find_mode(name, spatial), _find_mode(name, lumped)
        if spatial_mode is None and lumped_mode is None:
            continue
        frequencies = (
            None if spatial_mode is None else spatial_mode.frequency_hz,
            None if lumped_mode is None else lumped_mode.frequency_hz,
        )
        ratios = (
            None if spatial_mode is None else spatial_mode.damping_ratio,
            None if lumped_mode is None else lumped_mode.damping_ratio,
        )
        rows.append(ModelDifference(f"{name}, natural frequency", "Hz", *frequencies, why))
        rows.append(ModelDifference(f"{name}, damping ratio", "1", *ratios, why))
    return rows


def _find_mode(name: str, modes: tuple[Mode, ...]) -> Mode | None:
    """Find the mode in which the body (bounce) or the wheel (hop) moves most."""
    moving = {"body bounce": "sprung.z", "wheel hop": "unsprung.z"}[name]
    # The largest coordinate of a shape is 1 by definition.
    return next(
        (mode for mode in modes if abs(complex(*mode.shape.get(moving, (0.0, 0.0)))) > 0.999), None
    )


@dataclass(frozen=True)
class LumpedComparison(Plain):
    """A 3-D rig and its lumped model side by side, with their names.

    Attributes
    ----------
    comparison : ModelComparison
        Differences and their reasons.
    rig : Rig
        The 3-D rig.
    title : str
        Names of the two models.
    """

    comparison: ModelComparison
    rig: Rig
    title: str

    def rows(self) -> list[dict[str, Any]]:
        """Return quantities about rest, one row each."""
        rows: list[dict[str, Any]] = self.to_dict()["rows"]
        return rows

    def to_dict(self) -> dict[str, Any]:
        """Return the comparison as plain values, SI."""
        return self.comparison.to_dict()


@operation(
    "study lumped-vs-spatial",
    named={"speeds": "speed"},
    echo={"rig": "rig", "lumped_rig": "lumped"},
    offers=("numbers", "figure", "report"),
    page="jounce.report.models:lumped_comparison_page",
    title="{result.title}",
    doing="comparing",
    example="jounce study lumped-vs-spatial kart-double-wishbone --lumped kart-quarter-car",
)
def compare_with_lumped(
    rig: Annotated[
        Rig | str | Path, File("A rig file, or a name of `jounce library`.", "RIG", ("parts",))
    ],
    lumped: Annotated[
        Rig | str | Path | None,
        File(
            "Quarter car to compare; by default the equivalent of the rig at equilibrium.",
            "RIG",
            ("parts",),
        ),
    ] = None,
    *,
    road: Annotated[
        str | None, File("A road: file, or a name of `jounce library`.", "ROAD", ("roads",))
    ] = None,
    speeds: Annotated[
        Sequence[float | str] | None,
        Texts('Speed over the road, e.g. "1.95 m/s". Repeat it.', "SPEED"),
    ] = None,
    duration: Annotated[
        float | str, Number("Length of each run.", "TIME", "s", is_positive=True)
    ] = "2 s",
) -> LumpedComparison:
    """Show where a lumped quarter car differs from a 3-D rig, and why.

    Parameters
    ----------
    rig : Rig, str or Path
        A 3-D rig whose body is free along z, its file or its name.
    lumped : Rig, str or Path, optional
        Quarter car to compare; by default the equivalent of the rig at equilibrium.
    road : str, optional
        A road, its file or its name; by default a test-bench obstacle, 10 mm high and 60 mm long (estimated).
    speeds : sequence of float or str, optional
        Speeds over the road, m/s; by default 1.95, 2.86 and 3.79 m/s.
    duration : float or str
        Length of each run, s.

    Returns
    -------
    LumpedComparison
        The result of :func:`jounce.compare_models`, with the names.

    Examples
    --------
    >>> found = compare_with_lumped("kart-double-wishbone", "kart-quarter-car", speeds=["2 m/s"], duration="0.5 s")
    >>> found.title, len(found.comparison.peaks) > 0
    ('kart-double-wishbone and kart-quarter-car', True)
    """
    course = HalfSine(height=0.010, length=0.060, start=0.2) if road is None else load_road(road)
    length = positive_quantity(str(duration), "s", "duration")
    trials = {
        str(speed): Trial(
            road=course, speed=positive_quantity(str(speed), "m/s", "speeds"), duration=length
        )
        for speed in speeds or _SPEEDS
    }
    spatial, equivalent = as_rig(rig), None if lumped is None else as_rig(lumped)
    names = _name(rig), "its equivalent quarter car" if lumped is None else _name(lumped)
    return LumpedComparison(
        compare_models(spatial, equivalent, trials), spatial, " and ".join(names)
    )


_SPEEDS = ("1.95 m/s", "2.86 m/s", "3.79 m/s")


def _name(rig: Rig | str | Path) -> str:
    return Path(rig).stem if isinstance(rig, str | Path) else "the rig"
