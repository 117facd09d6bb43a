"""Hardpoints and stiffnesses updated to measured K&C sheets, with intervals that count what the model cannot follow.

Mean curves of both branches are fitted at a few inputs each, as changes from their own mean unless totals count. What
differs has two parts: noise of the readings, and model error. The latter is a smooth curve over the input, so that it
also tilts the whole curve, and its size is a share of the curve's range, the same for all curves of a family of tests.
The shares are those that make the differences most likely (restricted maximum likelihood [harville1977]). Curves that
measure the same compliance twice (left and right, braking and driving by hub motors) share their model error and count
once. Quantities of a family share its causes, too, a wrong bushing or friction: together they count as the root of
their number.

Dry friction is simulated beside the smooth model that is fitted. What it adds to each curve is computed anew in each
round, until it no longer moves the numbers; how it changes with them follows from the rounds before [broyden1965].
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np

from jounce.core.errors import DescriptionError, FitError, JounceError, SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.identify.estimate import Estimate, estimate
from jounce.identify.kc_friction import (
    FrictionCurve,
    FrictionEffects,
    mean_square_opening,
    strut_friction,
)
from jounce.identify.update import Identifiability, identifiability
from jounce.kc.laboratory import Handwheel, Held, Laboratory, axle_of
from jounce.kc.loops import lines_of, noise_of
from jounce.kc.quantities import Poses, is_of_element, quantities
from jounce.kc.sensitivities import check_parameters, is_of_bushing, kc_parameters
from jounce.kc.tangents import SETTLED, Tangents
from jounce.kc.tests import TESTS
from jounce.kc.vocabulary import QUANTITIES, quantity_name
from jounce.kernel import equilibrium as eq
from jounce.parts import Corner, DependentAxle, Rig
from jounce.parts.rig import unit_of

if TYPE_CHECKING:
    import xarray as xr

_NODES = 11  # inputs at which a curve with many samples is compared
_MANY = 60  # different inputs above which the curve is averaged between those
_ROUNDS, _STEPS = 12, 8  # of friction and shares of model error, and of the search within each
_SETTLED = 0.1  # of a standard error: a renewed friction that moves numbers by less has settled
_NEAR, _TIGHT = (
    0.05,
    1e-3,
)  # of a standard error: a step that ends the search, until all is settled and then
_START, _LEAST, _MOST = 0.02, 0.01, 1.0  # shares of model error: first guess and limits
_USUAL, _SPREAD = (
    0.02,
    1.5,
)  # share of model error that is likely before the fit, and its standard deviation (log)
_REACH = 0.5  # of the input's range: length over which model error changes
_TIP = 0.12  # of the range, at the ends of a loop where friction sticks
_STUCK, _ROUGH = (
    0.15,
    0.1,
)  # of a loop's opening: error of its mean curve by friction that sticks, smooth and rough
_RUBBED = 0.1
"""Error of what friction adds to a curve, as a share: of its force, and of slopes that the smooth model has instead."""
_CLEAR, _UNEXPLAINED = 3.0, 2.0
"""Opening of a loop that is no noise, in variances of the readings; one that is reported, over the simulated."""
_TOLD = 0.7  # of the standard deviation before the fit, above which the data do not determine a parameter
_WIDER = 1.2  # intervals over those of the linear theory: what virtual rigs with friction and a wrong curve needed
_LARGE = 0.10  # share of model error that is reported
_READING = {"rad": 5e-5, "m": 2e-5, "N": 2.0, "N*m": 0.2}
"""Least noise and range of a curve, SI."""
_FAMILIES = {
    "heights": "bounce",
    "roll": "roll",
    "rack": "steer",
    "lateral": "lateral",
    "aligning": "aligning",
}
_INDEPENDENT = {"lateral": 2, "aligning": 2}
"""Curves of each quantity in a family that are independent: own wheel and other wheel loaded; else one."""

Bounds = str | float | Sequence[str | float]


@dataclass(frozen=True)
class KcUpdate(Plain):
    """Outcome of an update to a measured K&C sheet.

    Attributes
    ----------
    rig : Rig
        The axle with the fitted numbers; those that the sheet cannot tell keep their start values.
    parameters : mapping of str to Estimate
        Fitted numbers by path, SI, with 95 % intervals that include model error.
    before : mapping of str to float
        Start values of all free numbers, SI.
    undetermined : tuple of str
        Free numbers that the sheet cannot tell. They have no estimate; the intervals of the others count that they may
        be anywhere within their bounds.
    identifiability : Identifiability
        What the sheet can tell at the start values, in units of the bounds' half widths.
    model_error : mapping of str to float
        Model error of each family of tests, as a share of the curves' ranges (1).
    curves : tuple of mapping
        For each curve its ``test``, ``quantity``, ``unit``, and root mean square differences ``before`` and ``after``,
        and the ``noise``, SI.
    units : mapping of str to str
        SI unit of each free number.
    findings : tuple of Finding
        Limits of the result.
    """

    rig: Rig
    parameters: Annotated[Mapping[str, Estimate], Shows("", lambda r: r.units)]
    before: Mapping[str, float]
    undetermined: tuple[str, ...]
    identifiability: Identifiability
    model_error: Mapping[str, float]
    curves: tuple[Mapping[str, Any], ...]
    units: Mapping[str, str]
    findings: tuple[Finding, ...] = ()

    left_out = ("rig", "identifiability")


@dataclass(frozen=True)
class _Curve:
    """A measured mean curve at inputs (k,).

    ``reading`` is the standard deviation of the mean reading at each. ``basis`` (k, j) has its shapes, ``friction``
    (j,) their variances by friction, ``shares`` (j,) those by model error as large as the curve's range; ``copies`` is
    the number of curves with the same model error. ``sweep`` has the inputs as measured, ``is_open`` whether friction
    opens the loop, ``opening`` by how much (root mean square), 0 if that could be noise.
    """

    test: str
    quantity: str
    unit: str
    family: str
    inputs: Array
    values: Array
    reading: float
    friction: Array
    basis: Array
    shares: Array
    copies: float
    is_open: bool
    opening: float
    sweep: Array


def update_kc(
    axle: Rig,
    measured: Mapping[str, xr.Dataset] | xr.Dataset,
    parameters: Mapping[str, Bounds],
    *,
    noise: Mapping[str, float | str] | None = None,
    quantities: Sequence[str] | None = None,
    totals: Sequence[str] = (),
    travel: float | str = 0.0,
    held: Held = "load",
    handwheel: Handwheel = "locked",
    on: Literal["front", "rear"] | None = None,
) -> KcUpdate:
    """Update hardpoints and stiffnesses of an axle to measured K&C tests.

    What the given tests can tell is examined first: numbers that they cannot tell get no estimate. Intervals include
    model error, whose size follows from what the best fit leaves over; it is at least 1 % of a curve's range.

    Parameters
    ----------
    axle : Rig
        The axle with the numbers known so far, or a 3-D car.
    measured : mapping of str to xarray.Dataset, or xarray.Dataset
        Measured tests by name, as `read_kc` gives them, or one test.
    parameters : mapping of str to bounds
        Path of each free number, or of a point or bushing for all its numbers, with its bounds: ``"20 %"`` of the
        start value to either side, ``"3 mm"`` to either side, or ``["5 kN/mm", "9 kN/mm"]``. The truth is expected
        within these bounds, anywhere.
    noise : mapping of str to float or str, optional
        Standard deviation of a reading by quantity (``"toe"`` or ``"left.toe"``), SI or with its unit. By default that
        of the sheet, else estimated from the scatter of successive readings.
    quantities : sequence of str, optional
        Quantities to fit, with or without the wheel; by default all angles, movements and vertical forces.
    totals : sequence of str
        Quantities whose totals count, such as ``"camber"``; of all others only changes over the test are fitted.
    travel : float or str
        Height of the pads above the design position before the tests, m.
    held, handwheel : str
        As in `kc_test`.
    on : {"front", "rear"}, optional
        Axle of a car.

    Returns
    -------
    KcUpdate
        The updated rig, estimates with intervals (SI), what is not determined, and the model error found.

    Raises
    ------
    DescriptionError
        For unknown tests, parameters or quantities, or invalid bounds.
    FitError
        If nothing was measured that the model has, or no number can be told.

    References
    ----------
    Harville (1977), Journal of the American Statistical Association 72, 320-338; Broyden (1965), Mathematics of
    Computation 19, 577-593.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("generic-mcpherson")
    >>> truth = rig.with_changes({"hardpoints.tie_rod_inner[2]": rig.hardpoints.tie_rod_inner[2] + 0.002})
    >>> sheet = jn.kc_test(truth, "bounce", points=21)                        # a virtual rig
    >>> fit = jn.update_kc(rig, sheet, {"hardpoints.tie_rod_inner[2]": "5 mm"})
    >>> round(1e3 * (fit.parameters["hardpoints.tie_rod_inner[2]"].value - rig.hardpoints.tie_rod_inner[2]), 1)
    2.0
    """
    rig = axle_of(axle, on)
    low, high = _bounds(rig, parameters)
    paths = tuple(low)
    tests = _tests(measured)
    options = (to_si(travel, "m", where="travel"), held, handwheel)
    findings: list[Finding] = []
    rubbed, force = rig, strut_friction(rig, tests, options[0])
    if force > 0.0:
        rubbed = axle_of(rig.with_changes({"strut.friction": {"force": force}}), None)
        findings.append(
            finding("identify.kc_friction_estimated", "strut.friction.force", force, force=force)
        )
    smooth = _without_friction(rig)
    model = _Model(smooth, paths, options, rubbed)
    curves = _curves(tests, model, noise or {}, quantities, totals, findings)
    problem = _Problem(curves, model, np.array([[low[p], high[p]] for p in paths]))
    return problem.solve(rig, findings)


def _bounds(
    rig: Rig, parameters: Mapping[str, Bounds]
) -> tuple[dict[str, float], dict[str, float]]:
    if not parameters:
        raise DescriptionError(
            "no free parameters", where="parameters", allowed="paths with bounds"
        )
    low: dict[str, float] = {}
    high: dict[str, float] = {}
    values, known = rig.parameters(), kc_parameters(rig)
    for given, bounds in parameters.items():
        for path in check_parameters(rig, [given], known):
            unit, value, where = unit_of(rig, path), values[path], f"parameters: {given}"
            if isinstance(bounds, str | int | float):
                share = isinstance(bounds, str) and bounds.strip().endswith("%")
                half = to_si(bounds, "1" if share else unit, where=where)
                half = half * abs(value) if share else half
                ends = value - half, value + half
            elif len(bounds) == 2:
                ends = to_si(bounds[0], unit, where=where), to_si(bounds[1], unit, where=where)
            else:
                ends = 0.0, 0.0
            if not ends[0] < ends[1] or not ends[0] <= value <= ends[1]:
                raise DescriptionError(
                    "invalid bounds",
                    where=where,
                    found=bounds,
                    allowed='"20 %" of a start value that is not zero, "3 mm", or two bounds around the start value',
                )
            low[path], high[path] = ends
    return low, high


def _tests(measured: Mapping[str, xr.Dataset] | xr.Dataset) -> dict[str, xr.Dataset]:
    import xarray as xr

    tests = (
        {str(measured.attrs.get("test")): measured}
        if isinstance(measured, xr.Dataset)
        else dict(measured)
    )
    for name, data in tests.items():
        if name not in TESTS or "input" not in data.coords:
            raise DescriptionError(
                "no K&C test", where="measured", found=name, allowed=", ".join(TESTS)
            )
    return tests


def _without_friction(rig: Corner | DependentAxle) -> Corner | DependentAxle:
    """Return the axle without dry friction: mean curves of both branches are nearly those without it."""
    changes: dict[str, Any] = {}
    strut = getattr(rig, "strut", None)
    if strut is not None and getattr(strut, "friction", None) is not None:
        changes["strut.friction"] = None
    bushings = getattr(rig, "bushings", None)
    for name in type(bushings).model_fields if bushings is not None else ():
        bushing = getattr(bushings, name)
        if bushing is not None and np.any(bushing.slip_loads > 0.0):
            changes[f"bushings.{name}.friction"] = None
            changes[f"bushings.{name}.rotational_friction"] = None
    return rig.with_changes(changes) if changes else rig


class _Model:
    """The axle at values of the free numbers: its curves at the nodes of each test, and their slopes."""

    def __init__(
        self,
        rig: Corner | DependentAxle,
        paths: tuple[str, ...],
        options: tuple[float, Held, Handwheel],
        rubbed: Corner | DependentAxle,
    ) -> None:
        self.rig, self.paths, self.options = rig, paths, options
        self.effects = None if rubbed == rig else FrictionEffects(rubbed, rig, options[0])
        self.start = np.array([rig.parameters()[path] for path in paths])

    def at(self, values: Array) -> Tangents:
        """Return the laboratory of the axle with these numbers."""
        changed = self.changes(values)
        rig = axle_of(self.rig.with_changes(changed) if changed else self.rig, None)
        return Tangents(Laboratory(rig, self.options[0]), self.paths)

    def changes(self, values: Array) -> dict[str, float]:
        """Return the numbers that differ from the start."""
        both = zip(self.paths, values, self.start, strict=True)
        return {path: float(value) for path, value, start in both if value != start}

    def friction(self, values: Array, curves: Sequence[_Curve]) -> list[Array]:
        """Return what friction adds to each curve, at these numbers."""
        if self.effects is None:
            return [np.zeros(len(curve.inputs)) for curve in curves]
        rows = [
            FrictionCurve(c.test, c.quantity, c.inputs, is_open=c.is_open, sweep=c.sweep)
            for c in curves
        ]
        return self.effects.of(self.changes(values), rows, *self.options[1:])

    def curves(
        self, tangents: Tangents, test: str, inputs: Array, wanted: Sequence[str]
    ) -> tuple[dict[str, Array], dict[str, Array]]:
        """Return values (k,) and slopes (k, m) of quantities of a test."""
        kind, (_, held, handwheel) = TESTS[test], self.options
        laboratory = tangents.laboratory
        tangent, place = tangents.run(kind, inputs, held, handwheel, kind.trail)
        if np.any(tangent.settled.outcome != eq.SETTLED):
            raise SimulationError("the model does not reach the measured range", where=test)
        path = laboratory.path(kind, inputs, held, handwheel, kind.trail)
        own = laboratory.multipliers + len(laboratory.controls)
        settled = tangent.settled._replace(multipliers=tangent.settled.multipliers[:, :own])
        settled = settled._replace(**{part: getattr(settled, part)[place] for part in SETTLED})
        elements = any(map(is_of_element, wanted))
        values = quantities_of(Poses(laboratory.axle, settled, path), elements=elements)
        slopes = tangents.slopes(tangent, wanted)
        return {name: values[name] for name in wanted}, {
            n: rows[place] for n, rows in slopes.items()
        }


def quantities_of(poses: Poses, *, elements: bool = True) -> dict[str, Array]:
    """Return the quantities of a test as arrays, SI."""
    every = quantities(poses, elements=elements)
    return {name: variable.values for name, variable in every.items()}


# curves ---------------------------------------------------------------------------------------------------------------


def _curves(
    tests: Mapping[str, xr.Dataset],
    model: _Model,
    noise: Mapping[str, float | str],
    wanted: Sequence[str] | None,
    totals: Sequence[str],
    findings: list[Finding],
) -> list[_Curve]:
    tangents = model.at(model.start)
    laboratory = tangents.laboratory
    rows: list[tuple[str, str, Any]] = []
    known = _known(tangents)
    for test, data in tests.items():
        if TESTS[test].kind == "rack" and not laboratory.axle.steered:
            continue
        names = [str(n) for n in data.data_vars if n in known and data[n].dims == ("sample",)]
        rows += [(test, name, data) for name in names if _is_fitted(name, names, wanted)]
    for key in (*(wanted or ()), *totals, *noise):
        if all(key not in (name, quantity_name(name)) for _, name, _ in rows):
            raise DescriptionError(
                "not measured, or not computed", where="quantities", found=key,
                allowed=", ".join(sorted({name for _, name, _ in rows})),
            )  # fmt: skip
    if not rows:
        raise FitError("no measured quantity that the model has", where="measured")
    families: dict[tuple[str, str], int] = {}
    for test, name, _ in rows:
        own = _family(test), quantity_name(name)
        families[own] = families.get(own, 0) + 1
    out = []
    for test, name, data in rows:
        family = _family(test)
        count = families[family, quantity_name(name)]
        together = sum(1 for other, _ in families if other == family)
        copies = max(1.0, count / _INDEPENDENT.get(family, 1)) * np.sqrt(together)
        curve = _curve(test, name, data, family, copies, noise, totals)
        if curve is None:
            findings.append(finding("identify.kc_not_fitted", f"{test}.{name}"))
        else:
            out.append(curve)
    return out


def _known(tangents: Tangents) -> list[str]:
    """Return the names of the quantities that have slopes."""
    kind = TESTS["bounce"]
    path = tangents.run(kind, np.zeros(1), "height", "locked", 0.0)[0]
    own = tangents.slopes(path)
    settled = path.settled
    count = tangents.laboratory.multipliers + len(tangents.laboratory.controls)
    settled = settled._replace(multipliers=settled.multipliers[:, :count])
    where = tangents.laboratory.path(kind, np.zeros(1), "height", "locked", 0.0)
    return [
        name
        for name in quantities_of(Poses(tangents.laboratory.axle, settled, where))
        if name in own
    ]


_NOT_FITTED = (
    "lateral_force", "longitudinal_force", "aligning_moment", "handwheel_angle", "handwheel_torque",
)  # fmt: skip
"""Loads of the tests, and readings that friction of the steering falsifies: fitted only if they are asked for."""


def _is_fitted(name: str, names: Sequence[str], wanted: Sequence[str] | None) -> bool:
    quantity = quantity_name(name)
    if wanted is not None:
        return name in wanted or quantity in wanted
    if quantity not in QUANTITIES or quantity in _NOT_FITTED or is_of_bushing(name):
        return False
    return not (
        quantity == "steer" and name.replace("steer", "toe") in names
    )  # toe is the same reading


def _family(test: str) -> str:
    kind = TESTS[test]
    if kind.kind == "longitudinal":
        return "longitudinal" if kind.through == "contact_point" else "longitudinal at the centre"
    return _FAMILIES[kind.kind]


def _curve(
    test: str,
    name: str,
    data: xr.Dataset,
    family: str,
    copies: float,
    noise: Mapping[str, float | str],
    totals: Sequence[str],
) -> _Curve | None:
    sweep = _abscissa(test, data)
    values = np.asarray(data[name].values, dtype=float)
    known = np.isfinite(values) & np.isfinite(sweep)
    sweep, values = sweep[known], values[known]
    if values.size < 3 or np.ptp(sweep) == 0.0:
        return None
    unit = str(data[name].attrs.get("units", "1"))
    one, nodes = _nodes(sweep)
    lines = lines_of(sweep, values, nodes)
    mean = lines.mean
    is_loop = lines.opening > 0.02 * max(float(np.ptp(values)), _READING.get(unit, 0.0))
    if is_loop:
        mean = lines.elastic
    if is_loop and len(nodes) > 6:  # friction sticks at the ends of a loop
        inner = (nodes > nodes[0] + _TIP * np.ptp(nodes)) & (
            nodes < nodes[-1] - _TIP * np.ptp(nodes)
        )
        nodes, mean = nodes[inner], mean[inner]
    good = np.isfinite(mean)
    nodes, mean = nodes[good], mean[good]
    if nodes.size < 3:
        return None
    least = _READING.get(unit, 1e-6)
    given = next((noise[key] for key in (name, quantity_name(name)) if key in noise), None)
    sigma = (
        data[name].attrs.get("noise") or noise_of(values)
        if given is None
        else to_si(given, unit, where=f"noise: {quantity_name(name)}")
    )
    each = max(float(sigma), 0.2 * least) / np.sqrt(
        max(1.0, len(values) / (len(one) if len(one) <= _MANY else _NODES))
    )
    size = max(float(np.ptp(mean)), least)
    is_total = name in totals or quantity_name(name) in totals
    basis, shares = _shapes(nodes.tobytes(), is_total=is_total)
    opening = max(mean_square_opening(lines) - 2.0 * float(sigma) ** 2, 0.0)
    is_clear = is_loop and opening > _CLEAR * float(sigma) ** 2
    friction = opening * (_STUCK**2 * shares + _ROUGH**2)
    return _Curve(
        test,
        name,
        unit,
        family,
        nodes,
        mean,
        each,
        friction,
        basis,
        shares * size**2,
        copies,
        bool(is_loop),
        float(np.sqrt(opening)) if is_clear else 0.0,
        sweep,
    )


@lru_cache(64)  # curves of a test share their nodes
def _shapes(inputs: bytes, *, is_total: bool) -> tuple[Array, Array]:
    """Return the shapes (k, j) of model error at k nodes and the variance of each: j is k, or k - 1 with mean zero."""
    nodes = np.frombuffer(inputs)
    count, reach = len(nodes), _REACH * float(np.ptp(nodes))
    smooth = np.exp(-0.5 * ((nodes[:, None] - nodes) / reach) ** 2)
    constant = np.full(count, 1.0 / np.sqrt(count))
    whole = np.linalg.qr(np.column_stack([constant, np.eye(count)[:, : count - 1]]))[0]
    whole = whole if is_total else whole[:, 1:]
    shares, turned = np.linalg.eigh(whole.T @ smooth @ whole)
    return np.asarray(whole @ turned), np.maximum(shares, 0.0)


def _abscissa(test: str, data: xr.Dataset) -> Array:
    """Return the input; in bounce and roll from the movements of the wheel centres, as the model's tyres are rigid."""
    given = np.asarray(data["input"].values, dtype=float)
    kind, names = TESTS[test].kind, [f"{side}.wheel_centre_z" for side in ("left", "right")]
    if (
        kind == "heights"
        and all(name in data for name in names)
        and "left.contact_point_z" not in data
    ):
        return np.asarray(0.5 * (data[names[0]].values + data[names[1]].values))
    return given


def _nodes(sweep: Array) -> tuple[Array, Array]:
    """Return the different inputs, and those at which the curve is compared."""
    digits = 6 - int(np.floor(np.log10(np.ptp(sweep))))
    one = np.unique(np.round(sweep, digits))
    if len(one) <= _MANY:
        return one, one[np.unique(np.round(np.linspace(0, len(one) - 1, _NODES)).astype(int))]
    return one, np.linspace(sweep.min(), sweep.max(), _NODES)


# the problem ----------------------------------------------------------------------------------------------------------


class _Problem:
    """Differences of all curves in their smooth shapes, scaled numbers, and the shares of model error."""

    def __init__(self, curves: list[_Curve], model: _Model, box: Array) -> None:
        self.curves, self.model, self.box = curves, model, box
        self.half = 0.5 * (box[:, 1] - box[:, 0])
        self.prior = 1.0 / np.sqrt(
            3.0
        )  # standard deviation of a number anywhere within its bounds, in half widths
        self.families = tuple(dict.fromkeys(curve.family for curve in curves))
        self.noise = np.concatenate([np.full(len(c.shares), c.reading**2) for c in curves])
        self.friction = np.concatenate([c.friction for c in curves])
        self.copies = np.concatenate([np.full(len(c.shares), c.copies) for c in curves])
        self.spread = np.concatenate([c.shares for c in curves])
        self.family = np.concatenate(
            [np.full(c.basis.shape[1], self.families.index(c.family)) for c in curves]
        )
        self.rubbed, self.rubbed_at = model.friction(model.start, curves), np.zeros(len(box))
        self.rubbing = [np.zeros((len(curve.inputs), len(box))) for curve in curves]
        self.wanted: dict[str, list[str]] = {}
        self.inputs: dict[str, Array] = {}
        for curve in curves:
            self.wanted.setdefault(curve.test, []).append(curve.quantity)
            before = self.inputs.get(curve.test, curve.inputs)
            self.inputs[curve.test] = np.union1d(before, curve.inputs)
        self.places = [np.searchsorted(self.inputs[c.test], c.inputs) for c in curves]
        self.smooth: tuple[Array, list[tuple[Array, Array]]] | None = None

    def evaluate(self, x: Array) -> tuple[Array, Array, list[float]]:
        """Return differences measured minus model, slopes by scaled numbers, and root mean squares of each curve."""
        if self.smooth is None or not np.array_equal(x, self.smooth[0]):
            self.smooth = x, self._without_friction(x)
        parts, slopes, sizes = [], [], []
        moved = x - self.rubbed_at
        for k, (curve, (values, changes)) in enumerate(
            zip(self.curves, self.smooth[1], strict=True)
        ):
            rubbed = self.rubbed[k] + self.rubbing[k] @ moved
            off = curve.basis.T @ (curve.values - rubbed - values)
            parts.append(off)
            slopes.append(curve.basis.T @ (changes + self.rubbing[k]))
            sizes.append(float(np.sqrt(off @ off / len(curve.inputs))))
        return np.concatenate(parts), np.concatenate(slopes), sizes

    def _without_friction(self, x: Array) -> list[tuple[Array, Array]]:
        """Return values of the smooth model at the nodes of each curve, and their slopes by scaled numbers."""
        tangents = self.model.at(self.model.start + x * self.half)
        runs = {
            test: self.model.curves(tangents, test, self.inputs[test], names)
            for test, names in self.wanted.items()
        }
        out = []
        for curve, places in zip(self.curves, self.places, strict=True):
            values, changes = (part[curve.quantity][places] for part in runs[curve.test])
            out.append((values, changes * self.half))
        return out

    def renew_friction(self, x: Array) -> Array:
        """Simulate friction at these numbers; return by how much the differences grow beyond what was expected."""
        moved = x - self.rubbed_at
        length = float(moved @ moved)
        new = self.model.friction(self.model.start + x * self.half, self.curves)
        more = []
        for k, curve in enumerate(self.curves):
            beyond = new[k] - self.rubbed[k] - self.rubbing[k] @ moved
            if length > 0.0:
                self.rubbing[k] += np.outer(beyond, moved) / length
            more.append(curve.basis.T @ beyond)
        self.rubbed, self.rubbed_at = new, x
        return np.concatenate(more)

    def covariance(self, shares: Array, slopes: Array) -> tuple[Array, Array]:
        """Return the weights of the differences and the covariance of the scaled numbers."""
        weight = 1.0 / self.variance(shares)
        told = slopes.T @ (weight[:, None] * slopes)
        return weight, np.asarray(np.linalg.inv(told + np.eye(len(self.half)) / self.prior**2))

    def variance(self, shares: Array, *, alone: bool = False) -> Array:
        """Return the variance of each component; not ``alone``, curves with the same model error share their weight."""
        error = self.friction + shares[self.family] ** 2 * self.spread
        error = error + np.concatenate(
            [
                (_RUBBED * (curve.basis.T @ rubbed)) ** 2
                for curve, rubbed in zip(self.curves, self.rubbed, strict=True)
            ]
        )
        return np.asarray(self.noise + error * (1.0 if alone else self.copies))

    def likely(self, off: Array, slopes: Array) -> Array:
        """Return the shares of model error that make the differences most likely, the numbers being fitted."""
        from scipy.optimize import minimize

        prior, log_usual = np.eye(len(self.half)) / self.prior**2, np.log(_USUAL)
        own = self.family == np.arange(len(self.families))[:, None]

        def unlikeliness(log: Array) -> tuple[float, Array]:
            """Return it with its slopes."""
            shares = np.exp(log)
            weight = 1.0 / self.variance(shares, alone=True)
            normal = slopes.T @ (weight[:, None] * slopes) + prior
            fitted = np.linalg.solve(normal, slopes.T)
            left = off - slopes @ (fitted @ (weight * off))
            usual = (log - log_usual) / _SPREAD
            value = weight @ (off * left) + np.linalg.slogdet(normal)[1] - np.log(weight).sum()
            each = weight - weight**2 * ((slopes * fitted.T).sum(axis=1) + left**2)
            slope = own @ (each * self.spread) * 2.0 * shares**2 + 2.0 * usual / _SPREAD
            return float(value + usual @ usual), slope

        begin = np.full(len(self.families), np.log(_START))
        limits = [(np.log(_LEAST), np.log(_MOST))] * len(begin)
        best = minimize(unlikeliness, begin, jac=True, method="L-BFGS-B", bounds=limits)
        return np.asarray(np.exp(best.x))

    def search(
        self, x: Array, shares: Array, tight: float
    ) -> tuple[Array, tuple[Array, Array, list[float]]]:
        """Minimise the weighted differences within the bounds by Gauss and Newton, each step halved if need be."""
        from scipy.optimize import lsq_linear

        root = 1.0 / np.sqrt(self.variance(shares))
        own = np.eye(len(x)) / self.prior
        low, high = ((self.box[:, i] - self.model.start) / self.half for i in (0, 1))
        middle = 0.5 * (low + high)

        def cost(off: Array, at: Array) -> float:
            return float(((root * off) ** 2).sum() + ((at - middle) ** 2).sum() / self.prior**2)

        now = self.evaluate(x)
        for _ in range(_STEPS):
            matrix = np.concatenate([root[:, None] * now[1], own])
            right = np.concatenate([root * now[0], own @ (middle - x)])
            q, r = np.linalg.qr(matrix)
            step = lsq_linear(r, q.T @ right, (low - x - 1e-12, high - x + 1e-12)).x
            spread = np.sqrt(np.diag(np.linalg.inv(r.T @ r)))
            best = cost(now[0], x)
            for _ in range(6):
                try:
                    new = self.evaluate(np.clip(x + step, low, high))
                except JounceError:
                    step = 0.5 * step
                    continue
                if cost(new[0], x + step) <= best * (1.0 + 1e-9):
                    break
                step = 0.5 * step
            else:
                break
            x, now = np.clip(x + step, low, high), new
            if np.all(np.abs(step) < tight * spread):
                break
        return x, now

    def solve(self, rig: Rig, findings: list[Finding]) -> KcUpdate:
        """Return the update of a rig."""
        paths, x = self.model.paths, np.zeros(len(self.half))
        shares = np.full(len(self.families), _START)
        first = self.evaluate(x)
        root = 1.0 / np.sqrt(self.variance(shares))
        seen = identifiability(root[:, None] * first[1], paths)
        if not np.any(first[1]):
            raise FitError(
                "the measured tests do not depend on the free parameters", where="parameters"
            )
        for _ in range(_ROUNDS):
            before = shares
            x, last = self.search(x, shares, _NEAR)
            more = self.renew_friction(x)
            shares = self.likely(last[0] + last[1] @ x, last[1])
            weight, covariance = self.covariance(shares, last[1])
            unsettled = np.abs(covariance @ (last[1].T @ (weight * more)))
            is_settled = bool(np.all(unsettled < _SETTLED * np.sqrt(np.diag(covariance))))
            if is_settled and np.all(np.abs(np.log(shares / before)) < 0.05):
                break
        x, last = self.search(x, shares, _TIGHT)
        weight, covariance = self.covariance(shares, last[1])
        if not is_settled:
            findings.append(
                finding("identify.kc_friction_unsettled", "friction", _ROUNDS, rounds=_ROUNDS)
            )
        covariance += np.diag(unsettled**2)
        error = _WIDER * np.sqrt(np.diag(covariance))
        is_told = error < _TOLD * self.prior
        freedom = self._freedom(weight, last[1], covariance)
        values = self.model.start + x * self.half
        estimates: dict[str, Estimate] = {}
        for k, path in enumerate(paths):
            if not is_told[k]:
                findings.append(finding("identify.kc_undetermined", path))
                continue
            estimates[path] = estimate(float(values[k]), float(error[k] * self.half[k]), freedom)
            if min(values[k] - self.box[k, 0], self.box[k, 1] - values[k]) < 1e-6 * self.half[k]:
                findings.append(finding("identify.kc_at_bound", path, float(values[k])))
        findings += [
            finding("identify.kc_model_error", family, float(share), share=float(share))
            for family, share in zip(self.families, shares, strict=True)
            if share > _LARGE
        ]
        findings += [item for item in seen.findings if item.place in estimates]
        findings += self._open_loops()
        curves = tuple(
            {
                "test": c.test,
                "quantity": c.quantity,
                "unit": c.unit,
                "before": b,
                "after": a,
                "noise": c.reading,
            }
            for c, b, a in zip(self.curves, first[2], last[2], strict=True)
        )
        return KcUpdate(
            rig.with_changes({path: item.value for path, item in estimates.items()}),
            estimates,
            dict(zip(paths, (float(v) for v in self.model.start), strict=True)),
            tuple(path for path, own in zip(paths, is_told, strict=True) if not own),
            seen,
            {f: float(s) for f, s in zip(self.families, shares, strict=True)},
            curves,
            {path: unit_of(rig, path) for path in paths},
            tuple(findings),
        )

    def _open_loops(self) -> list[Finding]:
        """Report tests whose loops are more open than friction of the description, and of the strut, makes them."""
        effects = self.model.effects
        simulated = [0.0] * len(self.curves) if effects is None else effects.openings
        pairs = zip(self.curves, simulated, strict=True)
        open_ = [c.test for c, own in pairs if c.opening > _UNEXPLAINED * own]
        tests = sorted(set(open_), key=list(TESTS).index)
        if not tests:
            return []
        return [
            finding("identify.kc_loops_open", "friction", len(open_), count=len(open_), tests=tests)
        ]

    def _freedom(self, weight: Array, slopes: Array, covariance: Array) -> float:
        """Return the number of differences that tell the size of model error, less the numbers that were fitted."""
        share = 1.0 - weight * self.noise  # of model error in each component
        fitted = float(np.trace(covariance @ (slopes.T @ (weight[:, None] * slopes))))
        return max(float(share.sum()) - fitted, 4.0)
