"""Hardpoints from measured curves: fits the points of a corner to a table of measured poses.

Least squares over poses and quantities, each quantity weighted by its noise, either given or estimated from its
residuals. Derivatives are exact. Intervals follow from the derivatives at the solution; for correlated residuals (from
play, friction or compliance) the effective number of readings is reduced.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from jounce.core.columns import read_columns_csv
from jounce.core.errors import DescriptionError, FitError, JounceError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, File, Pairs, Texts, operation
from jounce.core.results import Shows, own_unit
from jounce.core.samples import as_samples
from jounce.core.seeds import check_seed
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import positive_si
from jounce.design.free_points import FreeNumbers, Numbering, free_numbers
from jounce.design.kinematic_study import FreePoint
from jounce.identify.estimate import Estimate, correlation_time, estimate
from jounce.kernel.poses import REACHED
from jounce.kinematics.catalogue import require_parts
from jounce.kinematics.model import check_corner, has_rack, kinematic_model
from jounce.kinematics.sweeps import path_sweep, path_values
from jounce.kinematics.tangents import Tangents
from jounce.parts import Corner, Rig, as_rig

if TYPE_CHECKING:
    import xarray as xr

_ROUNDS = 4  # of noise estimation
_CLEAR = 1e-8  # share of the largest singular value below which variables are not distinguishable
_LOST = (
    1e-6  # squared share of a variable in undetermined directions from which it is not determined
)
_FARTHEST = 3.0  # standard deviations of the given noise from which residuals are too large
_AXES = ("wheel_travel", "rack_travel")


@dataclass(frozen=True)
class MeasuredQuantity(Plain):
    """A measured quantity, SI: readings, their noise, root mean square residuals before and after.

    ``measured``, ``before`` and ``after`` have one value per pose; the model's values include the estimated offset. A
    missing reading is NaN.
    """

    unit: str
    noise: Annotated[float, Shows("noise", own_unit)]
    rms_before: Annotated[float, Shows("before", own_unit)]
    rms_after: Annotated[float, Shows("after", own_unit)]
    measured: list[float]
    before: list[float]
    after: list[float]


@dataclass(frozen=True)
class HardpointFit(Plain):
    """Hardpoints fitted to measured poses.

    Attributes
    ----------
    rig : Corner
        The rig with its points updated.
    numbers : mapping of str to Estimate
        Free parameters with their 95 % intervals, SI; without an interval if the measurements do not determine them.
    before : mapping of str to float
        Their values in the initial rig, SI.
    offsets : mapping of str to Estimate
        Estimated zero offsets of the measurement, in the SI unit of the quantity: reading minus model.
    quantities : mapping of str to MeasuredQuantity
        Measured quantities by name.
    wheel_travel, rack_travel : list of float
        Poses, m.
    starts : int
        Number of searches.
    agreed : int
        Number of searches that ended at the best result.
    findings : tuple of Finding
        Findings.
    """

    rig: Corner
    numbers: Mapping[str, Estimate]
    before: Mapping[str, float]
    offsets: Mapping[str, Estimate]
    quantities: Mapping[str, MeasuredQuantity]
    wheel_travel: list[float]
    rack_travel: list[float]
    starts: int
    agreed: int
    findings: tuple[Finding, ...] = ()

    left_out = ("rig",)


@operation(
    "fit hardpoints",
    named={"offsets": "offset"},
    faces={"offset": None},
    python_only=("seed",),
    arguments=2,
    echo={"rig": "rig"},
    offers=("changed_rig", "figure"),
    page="jounce.report.fits:hardpoints_page",
    title="{rig} against {measured}",
    doing="searching",
    example="jounce fit hardpoints formula-student-front poses.csv "
    '--free hardpoints.tie_rod_inner="10 mm" --offset toe',
)
def fit_hardpoints(
    rig: Annotated[
        Rig | str | Path, File("A corner with hardpoints: name or file.", "RIG", ("parts",))
    ],
    measured: Annotated[
        xr.Dataset | Mapping[str, Any] | str | Path,
        File(
            "Columns wheel_travel [mm], rack_travel [mm], toe [deg], camber [deg] ...", "POSES.csv"
        ),
    ],
    free: Annotated[
        Sequence[FreePoint | Mapping[str, Any]] | Mapping[str, Any],
        Pairs(
            'hardpoints.tie_rod_inner="15 mm". Repeat it.',
            "POINT=WITHIN",
            example='hardpoints.tie_rod_inner="15 mm"',
        ),
    ],
    *,
    noise: Annotated[
        Mapping[str, float | str] | None,
        Pairs(
            'Standard deviation: toe="0.02 deg". Repeat it.',
            "QUANTITY=SIZE",
            example='toe="0.02 deg"',
        ),
    ] = None,
    offsets: Annotated[
        Sequence[str], Texts("A quantity whose zero is not known. Repeat it.", "QUANTITY")
    ] = (),
    starts: Annotated[
        int, Count("Number of searches; the first starts from the rig.", least=1)
    ] = 3,
    seed: int = 0,
) -> HardpointFit:
    """Fit hardpoints to a table of measured poses, with 95 % intervals.

    Parameters
    ----------
    rig : Rig, str or Path
        A corner with its nominal hardpoints, or its name or file.
    measured : xarray.Dataset, mapping of str to array_like, shape (n,), str or Path
        A file of columns with their units, or ``wheel_travel`` (m, bump positive), ``rack_travel`` (m, positive to the
        left; 0 where it is missing), and rows of the catalogue relative to the body, one value per pose, SI: ``toe``
        (rad), ``camber`` (rad), ``wheel_centre_x`` (m), ``spring_length`` (m) and so on. NaN marks a missing reading.
    free : sequence of FreePoint or mapping
        Points that may move, with the keys of ``[[free]]`` of a design study (m), or a mapping of paths to ``within``.
    noise : mapping of str to float or str, optional
        Standard deviation of a reading (SI or with its unit); by default that of the residuals of each quantity.
    offsets : sequence of str
        Quantities with an unknown zero: a constant offset is estimated along with the points.
    starts : int
        Number of searches; the first starts from the rig, the others from points within the boxes.
    seed : int
        Seed of those points.

    Returns
    -------
    HardpointFit
        The updated rig, parameters and offsets with 95 % intervals (SI), and the residuals of each quantity.

    Raises
    ------
    DescriptionError
        For unknown quantities or paths, or poses that the rig does not reach.
    FitError
        For fewer readings than free parameters.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> rig = jn.load("formula-student-front")
    >>> truth = rig.with_changes({"hardpoints.tie_rod_inner[2]": "151 mm"})
    >>> travel = np.linspace(-0.03, 0.03, 25)
    >>> toe = jn.sweep_travel(truth, travel)["toe"].to_numpy()
    >>> toe = toe + np.random.default_rng(1).normal(0.0, 1e-4, len(toe))     # synthetic: a truth and its noise
    >>> found = fit_hardpoints(rig, {"wheel_travel": travel, "toe": toe}, {"hardpoints.tie_rod_inner[2]": "10 mm"})
    >>> found.numbers["hardpoints.tie_rod_inner[2]"].has(0.151)
    True
    """
    from scipy.optimize import least_squares

    corner = check_corner(as_rig(rig))
    if isinstance(measured, str | Path):
        measured = _read_poses(Path(measured), corner)
    listed = (
        [{"point": path, "within": width} for path, width in free.items()]
        if isinstance(free, Mapping)
        else free
    )
    points = [item if isinstance(item, FreePoint) else FreePoint(**item) for item in listed]
    numbering = Numbering.of({"": corner})
    numbers = free_numbers(numbering, points)
    table = _Table(corner, numbering.paths, measured, numbers, offsets)
    given = {
        name: positive_si(value, table.unit(name), where=f"noise: {name}")
        for name, value in (noise or {}).items()
    }
    count = numbers.directions.shape[1] + len(table.offsets)
    if int(table.known.sum()) <= count:
        raise FitError(
            "fewer readings than free parameters",
            found=f"{int(table.known.sum())} readings, {count} numbers",
        )
    before = table.misfit(np.zeros(count))
    if not np.all(np.isfinite(before[table.known])):
        raise DescriptionError(
            "the rig does not reach the measured poses",
            where="measured",
            found=table.ends(),
            hint="Leave them out.",
        )
    spread = table.spread_of(before, given, count)
    idle = np.linalg.norm(table.slopes(np.zeros(count))[0], axis=0)
    for k in np.flatnonzero(idle == 0.0):
        raise DescriptionError(
            "has no effect on any measured quantity", where="free", found=table.labels[k]
        )
    ended: list[tuple[float, Array]] = []
    for begin in _starting_points(numbers, len(table.offsets), starts, seed):
        x, weights = begin, spread
        for _ in range(1 if len(given) == len(table.names) else _ROUNDS):
            sought = least_squares(
                lambda x, weights: table.weigh(x, weights)[0],
                x,
                jac=lambda x, weights: table.weigh(x, weights)[1],
                args=(weights,),
                bounds=table.bounds,
                x_scale=table.scale,
                xtol=1e-12,
                ftol=1e-12,
                gtol=1e-12,
            )
            x = np.asarray(sought.x, dtype=float)
            weights = table.spread_of(table.misfit(x), given, count)
        ended.append((float(np.sum(table.weigh(x, spread)[0] ** 2)), x))
    costs = np.array([cost for cost, _ in ended])
    best = ended[int(np.argmin(costs))][1]
    agreed = int(np.sum([np.max(np.abs(x - best) / table.scale) < 1e-3 for _, x in ended]))
    return _describe_fit(table, best, given, before, starts, agreed)


def _read_poses(file: Path, corner: Corner) -> dict[str, Array]:
    """Read a table of measured poses, SI."""
    units = {row.name: row.unit for row in kinematic_model(corner).rows} | dict.fromkeys(_AXES, "m")
    table = read_columns_csv(file)
    for name in table.names:
        if name not in units:
            require_parts(corner, name)
            raise unknown(name, units, what="quantity", where=str(file))
    return {name: table[name].in_si(units[name]) for name in table.names}


def _starting_points(numbers: FreeNumbers, offsets: int, starts: int, seed: int) -> list[Array]:
    if starts < 1:
        raise DescriptionError(
            "invalid number of searches", where="starts", found=starts, allowed="1 or more"
        )
    check_seed(seed)
    random = np.random.default_rng(seed)
    width = numbers.upper - numbers.lower
    first = np.clip(
        np.zeros(len(width)), numbers.lower + 1e-6 * width, numbers.upper - 1e-6 * width
    )
    others = [
        numbers.lower + (0.05 + 0.9 * random.random(len(width))) * width for _ in range(starts - 1)
    ]
    return [np.concatenate([x, np.zeros(offsets)]) for x in (first, *others)]


class _Table:
    """Readings and the model's values at their poses, for x: the free variables followed by the offsets."""

    def __init__(
        self,
        rig: Corner,
        paths: tuple[str, ...],
        measured: Any,
        numbers: FreeNumbers,
        offsets: Sequence[str],
    ) -> None:
        self.rig, self.paths, self.numbers = rig, paths, numbers
        given = {str(name): measured[name] for name in _list_names(measured)}
        if "wheel_travel" not in given:
            columns = ", ".join(given) or "nothing"
            raise DescriptionError(
                "no poses", where="measured", found=columns, allowed="wheel_travel"
            )
        self.travel = path_values(given.pop("wheel_travel"), "wheel_travel")
        self.rack = np.zeros_like(self.travel)
        if "rack_travel" in given:
            self.rack = path_values(given.pop("rack_travel"), "rack_travel")
            if np.any(self.rack != 0.0) and not has_rack(rig):
                raise DescriptionError(
                    "this wheel has no steering rack", where="measured: rack_travel"
                )
        sweep, _ = path_sweep(rig, self.travel, np.broadcast_to(self.rack, self.travel.shape))
        self._sweep, self._model = sweep, sweep.model
        rows = {row.name: i for i, row in enumerate(sweep.model.rows)}
        if not given:
            raise DescriptionError(
                "nothing was measured",
                where="measured",
                allowed="quantities of the catalogue, e.g. toe",
            )
        values = {}
        for name, readings in given.items():
            if name not in rows:
                require_parts(rig, name)
                raise unknown(name, rows, what="quantity", where="measured")
            unit, where = sweep.model.rows[rows[name]].unit, f"measured: {name}"
            samples = as_samples(readings, unit, where=where, error=DescriptionError).ravel()
            values[name] = samples
            if samples.shape != self.travel.shape:
                raise DescriptionError(
                    "there must be one reading per pose",
                    where=f"measured: {name}",
                    found=len(samples),
                    allowed=str(len(self.travel)),
                )
        self.names = tuple(values)
        for name in offsets:
            if name not in values:
                raise unknown(name, values, what="measured quantity", where="offsets")
        self.offsets = tuple(dict.fromkeys(offsets))
        self._rows = [rows[name] for name in self.names]
        self._units = {name: sweep.model.rows[rows[name]].unit for name in self.names}
        self.readings = np.concatenate([values[name] for name in self.names])
        self.known = np.isfinite(self.readings)
        padded = np.vstack(
            [np.zeros((len(sweep.model.tracks), numbers.directions.shape[1])), numbers.directions]
        )
        self._tangents = Tangents(sweep, padded)
        size = len(self.travel)
        self._shift = np.zeros((len(self.readings), len(self.offsets)))
        for k, name in enumerate(self.offsets):
            i = self.names.index(name)
            self._shift[i * size : (i + 1) * size, k] = 1.0

    def unit(self, name: str) -> str:
        if name not in self._units:
            raise unknown(name, self._units, what="measured quantity", where="noise")
        return self._units[name]

    def part(self, name: str) -> slice:
        """Return the slice of a quantity's readings among all."""
        i, size = self.names.index(name), len(self.travel)
        return slice(i * size, (i + 1) * size)

    @property
    def labels(self) -> tuple[str, ...]:
        return (*self.numbers.labels, *(f"offset of {name}" for name in self.offsets))

    @property
    def bounds(self) -> tuple[Array, Array]:
        far = np.full(len(self.offsets), np.inf)
        return np.concatenate([self.numbers.lower, -far]), np.concatenate([self.numbers.upper, far])

    @property
    def scale(self) -> Array:
        """Return the scale of each variable: its range, or for an offset the scatter of its readings."""
        reach = [
            max(float(np.nanstd(self.readings[self.part(name)])), 1e-9) for name in self.offsets
        ]
        return np.concatenate([self.numbers.lengths, reach])

    def ends(self) -> str:
        """Return a description of where poses ended."""
        return next((str(end) for end in self._sweep.ends()), "no value")

    def model(self, x: Array) -> Array:
        """Return the model's values including offsets, NaN where a pose is out of reach."""
        size = self.numbers.directions.shape[1]
        self._sweep.walk.p[:] = self.numbers.origin + self.numbers.directions @ x[:size]
        self._sweep.run()
        poses = self._sweep.found
        rows = np.where(poses.outcome == REACHED, poses.outputs, np.nan)[self._rows]
        return rows.ravel() + self._shift @ x[size:]

    def misfit(self, x: Array) -> Array:
        """Return model minus reading."""
        return np.asarray(self.model(x) - self.readings)

    def slopes(self, x: Array) -> tuple[Array, Array]:
        """Return the slopes of the model's values along all variables, and the residuals."""
        left = self.misfit(x)
        moved = self._tangents.run()[self._rows]  # (quantities, directions, poses)
        return np.hstack([moved.transpose(0, 2, 1).reshape(len(left), -1), self._shift]), left

    def weigh(self, x: Array, spread: Array) -> tuple[Array, Array]:
        """Return residuals and slopes in standard deviations, 1e3 where a pose is out of reach."""
        slopes, left = self.slopes(x)
        good = np.isfinite(left) & self.known
        residuals = np.where(good, left, 1e3 * spread)[self.known] / spread[self.known]
        return residuals, np.where(good[:, None], slopes, 0.0)[self.known] / spread[
            self.known, None
        ]

    def spread_of(self, left: Array, given: Mapping[str, float], count: int) -> Array:
        """Return the standard deviation of every reading: as given, or that of the residuals of its quantity."""
        used = 1.0 - count / max(int(self.known.sum()), count + 1)
        spread = np.empty_like(self.readings)
        for name in self.names:
            part = self.part(name)
            residuals = left[part][self.known[part]]
            own = (
                float(np.sqrt(np.mean(residuals[np.isfinite(residuals)] ** 2) / used))
                if residuals.size
                else 1.0
            )
            least = 1e-9 * max(float(np.nanmax(np.abs(self.readings[part]), initial=0.0)), 1e-6)
            spread[part] = given.get(name, max(own, least))
        return spread


def _list_names(measured: Any) -> list[str]:
    if isinstance(measured, Mapping) and not hasattr(measured, "data_vars"):
        return [str(name) for name in measured]
    axes = [name for name in _AXES if name in measured.coords]
    return [*axes, *(str(name) for name in measured.data_vars if str(name) not in axes)]


def _describe_fit(
    table: _Table, x: Array, given: Mapping[str, float], before: Array, starts: int, agreed: int
) -> HardpointFit:
    count = len(x)
    slopes, left = table.slopes(x)
    spread = table.spread_of(left, given, count)
    findings: list[Finding] = []
    widened = spread.copy()
    for name in table.names:
        part = table.part(name)
        residuals = left[part][table.known[part]]
        widened[part] *= np.sqrt(correlation_time(residuals)) if residuals.size else 1.0
        share = (
            float(np.sqrt(np.mean((residuals / spread[part][table.known[part]]) ** 2)))
            if residuals.size
            else 0.0
        )
        if name in given and share > _FARTHEST:
            findings.append(finding("design.pose_unexplained", name, share, times=share))
            widened[part] *= share
    rows = (slopes / widened[:, None])[table.known] * table.scale
    _, seen, directions = np.linalg.svd(rows, full_matrices=False)
    clear = seen > _CLEAR * seen[0]
    variance = ((directions[clear] / seen[clear, None]) ** 2).sum(axis=0) * table.scale**2
    lost = (directions[~clear] ** 2).sum(axis=0) > _LOST
    freedom = (
        float("inf")
        if len(given) == len(table.names)
        else max(float(table.known.sum()) - count, 1.0)
    )
    size = len(table.numbers.labels)
    numbers, offsets = {}, {}
    low, high = table.bounds
    for k, label in enumerate(table.labels):
        error = None if lost[k] else float(np.sqrt(variance[k]))
        if lost[k]:
            findings.append(finding("design.undetermined", label))
        if k < size:
            value = float(table.numbers.values[k] + x[k])
            numbers[label] = estimate(value, error, freedom)
            if min(x[k] - low[k], high[k] - x[k]) <= 1e-6 * (high[k] - low[k]):
                findings.append(finding("design.edge_of_box", label, value))
        else:
            offsets[table.offsets[k - size]] = estimate(float(x[k]), error, freedom)
    quantities = {}
    for name in table.names:
        part = table.part(name)
        was, now = (deviations[part][table.known[part]] for deviations in (before, left))
        quantities[name] = MeasuredQuantity(
            table.unit(name),
            float(spread[part][0]),
            float(np.sqrt(np.mean(was**2))),
            float(np.sqrt(np.mean(now**2))),
            table.readings[part].tolist(),
            (before + table.readings)[part].tolist(),
            (left + table.readings)[part].tolist(),
        )
    index = {path: i for i, path in enumerate(table.paths)}
    parameters = table.numbers.origin + table.numbers.directions @ x[:size]
    try:
        rig = table.rig.with_changes(
            {path: float(parameters[index[path]]) for path in table.numbers.paths}
        )
    except JounceError as error:
        raise FitError(
            "the points found do not form a valid rig",
            found=error.message(),
            hint="Narrow the boxes.",
        ) from None
    return HardpointFit(
        rig,
        numbers,
        dict(zip(table.numbers.labels, table.numbers.values.tolist(), strict=True)),
        offsets,
        quantities,
        table.travel.tolist(),
        np.broadcast_to(table.rack, table.travel.shape).tolist(),
        starts,
        agreed,
        tuple(findings),
    )
