"""Hardpoints from targets: the points of a corner that give wanted curves, by least squares with exact slopes.

Every free number counts in shares of how far it may go, every target in tolerances. A search is a Levenberg-Marquardt
descent within the boxes, from the rig itself and from places of the boxes; a slight pull towards the rig keeps what
the targets leave open where it is. Where the best compromise misses a target, a second search asks only that all are
within their tolerances.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.description import line_of, read_description
from jounce.core.errors import DescriptionError, JounceError
from jounce.core.findings import Finding
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import positive_si, to_si
from jounce.design.kinematic_study import SCHEMA, FreePoint, KinematicStudy, KinematicTarget, coordinate
from jounce.design.kinematic_targets import Evaluator, Wanted, read_targets
from jounce.kinematics.model import check_corner, kinematic_model
from jounce.kinematics.sweeps import AxleLayout
from jounce.parts import Corner, Rig, load
from jounce.parts.files import rig_named_in
from jounce.parts.rig import unit_of, unknown_path

_STEPS = 60
_PULL = 1e-4  # tolerances for a number moved as far as it may go
_DAMPING, _LARGEST_DAMPING = 1e-3, 1e10
_SETTLED = 1e-10  # share of the cost below which a step has gained nothing
_INSIDE = 0.95  # share of the tolerance that the second search asks for
_NOTHING = 1e-9  # tolerances that a number changes from one end of its box to the other when it does nothing
_FIGHTS = -0.3  # cosine of two targets' slopes from which meeting one costs the other
_FAR = 1.0  # m: no hardpoint moves that far
_WITHIN = 1.0 + 1e-9  # tolerances, but for rounding
_STILL = 0.5e-9  # m: what moves less stays
_AXES = "xyz"
_NO_VALUE = (
    "Ackermann needs a rack away from straight ahead, swing arms and instant centres arms that are not parallel."
)


# results --------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class TargetResult(Plain):
    """A target before and after: values (SI), one for a single pose or a slope, else one a pose of its curve.

    ``wanted`` is a value, a list of them, or the limits ``[at_least, at_most]`` (None where there is none); ``at`` is
    where the curve's values stand (m or rad), along ``along``.
    """

    quantity: str
    unit: str
    before: float | list[float]
    after: float | list[float]
    wanted: Any
    tolerance: float
    met: bool
    along: str
    at: list[float]
    weight: float = 1.0


@dataclass(frozen=True)
class Moved(Plain):
    """A number of the rig before and after, SI."""

    before: float
    after: float


@dataclass(frozen=True)
class StartResult(Plain):
    """A search and where it ended.

    ``cost`` is half the sum of squares of all targets in tolerances, ``travelled`` the mean distance from the rig in
    shares of the boxes; both are None where the start is no mechanism. ``ended`` says why it stopped.
    """

    start: int
    met: bool
    cost: float | None
    steps: int
    travelled: float | None
    ended: str


@dataclass(frozen=True)
class Fight(Plain):
    """Two targets of which one cannot come nearer without the other going away: cosine of their slopes [1]."""

    missed: int
    other: int
    cosine: float


@dataclass(frozen=True)
class KinematicDesign(Plain):
    """Hardpoints found from targets.

    Attributes
    ----------
    rig : Corner
        The rig with its points moved.
    met : bool
        Whether all targets are within their tolerances.
    targets : tuple of TargetResult
        In the order of the study.
    moved : mapping of str to Moved
        Free and tied numbers by path, SI.
    starts : tuple of StartResult
        The outcome of every search.
    evaluations : int
        Designs that were computed.
    sensitivity : mapping of str to tuple of float
        What each coordinate of every hardpoint changes of each target at the design found: SI per metre, the largest
        over the curve.
    fights : tuple of Fight
        Which targets stand against those that are missed.
    findings : tuple of Finding
        What is worth knowing.
    """

    rig: Corner
    met: bool
    targets: tuple[TargetResult, ...]
    moved: Mapping[str, Moved]
    starts: tuple[StartResult, ...]
    evaluations: int
    sensitivity: Mapping[str, tuple[float, ...]]
    fights: tuple[Fight, ...] = ()
    findings: tuple[Finding, ...] = ()

    left_out = ("rig",)

    def results(self) -> dict[str, Any]:
        """Give what ``results.json`` holds: met, targets, moved, starts, evaluations."""
        plain = self.to_dict()
        return {name: plain[name] for name in ("met", "targets", "moved", "starts", "evaluations")}

    def sensitivity_table(self) -> str:
        """Give the sensitivities as CSV: a row a coordinate, what 1 mm of it changes of each target, SI."""
        heads = [f"{target.quantity} {i} [{target.unit} per mm]" for i, target in enumerate(self.targets)]
        rows = [
            ",".join([path, *(repr(1e-3 * value) for value in values)]) for path, values in self.sensitivity.items()
        ]
        return "\n".join([",".join(["coordinate", *heads]), *rows, ""])

    def curve_table(self) -> str:
        """Give all targets as CSV: a row a pose (SI) with the value before and after, what is wanted, its tolerance."""
        rows = ["target,quantity,unit,along,at,before,after,wanted,tolerance"]
        for i, target in enumerate(self.targets):
            before, after = (value if isinstance(value, list) else [value] for value in (target.before, target.after))
            for k, (one, other) in enumerate(zip(before, after, strict=True)):
                limits = self.targets[i].wanted
                one_a_pose = isinstance(limits, list) and len(limits) == len(after) and None not in limits
                wanted = limits[k] if one_a_pose else limits
                ends = wanted if isinstance(wanted, list) else [wanted]
                text = " to ".join("" if end is None else repr(end) for end in ends)
                at = repr(target.at[k]) if len(after) > 1 or len(target.at) == 1 else ""
                head = f"{i},{target.quantity},{target.unit},{target.along},{at}"
                rows.append(f"{head},{one!r},{other!r},{text},{target.tolerance!r}")
        return "\n".join([*rows, ""])


# free numbers ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class FreeNumbers:
    """What the search moves: x (n,) in SI, the numbers of the model being ``origin + directions @ x``.

    ``owners`` says which entry of the study each belongs to, ``paths`` which numbers move at all.
    """

    origin: Array
    directions: Array
    lower: Array
    upper: Array
    owners: tuple[int, ...]
    paths: tuple[str, ...]

    @property
    def lengths(self) -> Array:
        """Half the way that each may go."""
        return 0.5 * (self.upper - self.lower)


def free_numbers(rig: Corner, free: Sequence[FreePoint]) -> FreeNumbers:
    """Read what may move; paths that do not exist, move nothing, or are given twice are refused."""
    model = kinematic_model(rig)
    origin, index = model.parameter_values(rig), {path: i for i, path in enumerate(model.parameters)}
    columns, lower, upper, owners, taken = [], [], [], [], dict[str, str]()
    for k, entry in enumerate(free):
        where = f"free[{k}]"
        groups = [_paths(rig, index, name, f"{where}.{key}") for key, name in _named(entry)]
        size = len(groups[0])
        for name, group in zip((name for _, name in _named(entry)), groups, strict=True):
            if len(group) != size:
                raise DescriptionError("is tied to something of another size", where=f"{where}.tied", found=name)
            for path in group:
                if path in taken:
                    raise DescriptionError("is free twice", where=where, found=path, allowed="each number once")
                taken[path] = where
        matrix = np.zeros((len(origin), size))
        for group in groups:
            for j, path in enumerate(group):
                matrix[index[path], j] = 1.0
        at = np.array([origin[index[path]] for path in groups[0]])
        if entry.along is not None:
            if size != 3:
                raise DescriptionError("only a point moves along a line", where=f"{where}.along", found=entry.point)
            direction = np.array(entry.along) / np.linalg.norm(entry.along)
            matrix, at, size = matrix @ direction[:, None], np.zeros(1), 1
        bounds = _bounds(rig, entry, groups[0], at, size, where)
        columns.append(matrix)
        lower.append(bounds[0] - at)
        upper.append(bounds[1] - at)
        owners += [k] * size
    return FreeNumbers(
        origin, np.hstack(columns), np.concatenate(lower), np.concatenate(upper), tuple(owners), tuple(taken)
    )


def _named(entry: FreePoint) -> list[tuple[str, str]]:
    return [("point", entry.point), *((f"tied[{i}]", name) for i, name in enumerate(entry.tied))]


def _paths(rig: Corner, index: Mapping[str, int], name: str, where: str) -> list[str]:
    """Paths of a point's coordinates, or of one number."""
    known = rig.parameters()
    paths = [name] if name in known else [f"{name}[{i}]" for i in range(3)]
    if any(path not in known for path in paths):
        raise unknown_path(where, [*known, *{path[:-3] for path in known if coordinate(path) is not None}], name=name)
    outside = [path for path in paths if path not in index]
    if outside:
        raise DescriptionError(
            "does nothing: it does not enter the kinematics", where=where, found=name, hint="Leave it out."
        )
    return paths


def _bounds(rig: Corner, entry: FreePoint, paths: list[str], at: Array, size: int, where: str) -> tuple[Array, Array]:
    unit = unit_of(rig, paths[0])
    if entry.box is None:
        given = entry.within if isinstance(entry.within, (list, tuple)) else [entry.within] * size
        if len(given) != size:
            raise DescriptionError("not one width a coordinate", where=f"{where}.within", found=len(given))
        width = np.array([positive_si(one, unit, where=f"{where}.within") for one in given])
        if unit == "m" and np.max(width) > _FAR:
            raise DescriptionError(
                "farther than a hardpoint moves",
                where=f"{where}.within",
                found=f"{np.max(width):g} m",
                allowed=f"up to {_FAR:g} m",
                hint='A bare number is in metres; write "15 mm".',
            )
        return at - width, at + width
    corners = [list(corner) if isinstance(corner, (list, tuple)) else [corner] for corner in entry.box]
    if any(len(corner) != size for corner in corners):
        raise DescriptionError(
            "not a box of this point",
            where=f"{where}.box",
            found=f"{[len(corner) for corner in corners]} numbers",
            allowed=f"lower and upper corner of {size} each",
        )
    low, high = (np.array([to_si(one, unit, where=f"{where}.box") for one in corner]) for corner in corners)
    if np.any(low >= high):
        j = int(np.argmax(low >= high))
        raise DescriptionError(
            "the box is empty",
            where=f"{where}.box",
            found=f"{low[j]:g} to {high[j]:g} {unit}" + (f" in {_AXES[j]}" if size == 3 else ""),
            allowed="a lower corner below the upper one in every coordinate",
        )
    return low, high


# the search -----------------------------------------------------------------------------------------------------------


@dataclass
class _Search:
    """Residuals of all targets in tolerances, for free numbers in shares of their boxes."""

    evaluator: Evaluator
    free: FreeNumbers
    wanted: Sequence[Wanted]
    scale: Array = field(init=False)
    lower: Array = field(init=False)
    upper: Array = field(init=False)
    low: Array = field(init=False)
    high: Array = field(init=False)
    tolerance: Array = field(init=False)
    share: Array = field(init=False)

    def __post_init__(self) -> None:
        self.low, self.high = (np.concatenate([getattr(item, end) for item in self.wanted]) for end in ("low", "high"))
        counts = [len(item.low) for item in self.wanted]
        self.tolerance = np.repeat([item.tolerance for item in self.wanted], counts)
        self.share = np.repeat([item.text.weight / np.sqrt(len(item.low)) for item in self.wanted], counts)
        self.scale = self.free.lengths
        self.lower, self.upper = self.free.lower / self.scale, self.free.upper / self.scale

    def numbers(self, x: Array) -> Array:
        return np.asarray(self.free.origin + self.free.directions @ (self.scale * x))

    def residuals(self, x: Array, inside: float, *, slopes: bool) -> tuple[Array, Array, bool]:
        """Residuals (and slopes), and whether every target is within its tolerance.

        With ``inside`` above 0 what lies within that share of the tolerance counts as nothing.
        """
        values, along = self.evaluator.together(self.numbers(x), slopes=slopes)
        off = np.where(values > self.high, values - self.high, np.minimum(values - self.low, 0.0)) / self.tolerance
        met = bool(np.all(np.abs(off) <= _WITHIN))
        over = np.sign(off) * np.maximum(np.abs(off) - inside, 0.0)
        if not slopes:
            return self.share * over, along, met
        active = (over != 0.0) | ((self.low == self.high) & (inside == 0.0))
        rows = (active * self.share / self.tolerance)[:, None] * along * self.scale
        return self.share * over, rows, met

    def descend(self, x: Array, inside: float = 0.0) -> tuple[Array, float, bool, int, str]:
        """Levenberg-Marquardt from x: the place reached, its cost, whether all is met, steps, why it ended."""
        x = np.clip(x, self.lower, self.upper)
        pull = _PULL if inside == 0.0 else 0.0
        found, jacobian, met = self.residuals(x, inside, slopes=True)
        if not np.all(np.isfinite(found)):
            return x, np.inf, False, 0, "a pose is out of reach"
        damping, why, steps = _DAMPING, "no more steps", 0

        def cost_of(residuals: Array, at: Array) -> float:
            return float(0.5 * (residuals @ residuals + pull**2 * (at @ at)))

        cost = cost_of(found, x)
        for steps in range(1, _STEPS + 1):
            if inside > 0.0 and cost == 0.0:
                return x, cost, met, steps, "all targets are met"
            gradient = jacobian.T @ found + pull**2 * x
            held = ((x <= self.lower) & (gradient > 0.0)) | ((x >= self.upper) & (gradient < 0.0))
            free = np.flatnonzero(~held)
            if not len(free) or np.max(np.abs(gradient[free])) < 1e-14:
                why = "no direction makes it better"
                break
            normal = jacobian[:, free].T @ jacobian[:, free] + pull**2 * np.eye(len(free))
            gained = 0.0
            while damping < _LARGEST_DAMPING:
                step = np.zeros_like(x)
                size = damping * np.maximum(np.diag(normal), 1e-9 * np.max(np.diag(normal)))
                step[free] = np.linalg.solve(normal + np.diag(size + 1e-300), -gradient[free])
                tried = np.clip(x + step, self.lower, self.upper)
                residuals, _, _ = self.residuals(tried, inside, slopes=False)
                other = cost_of(residuals, tried) if np.all(np.isfinite(residuals)) else np.inf
                if other < cost:
                    gained, x, cost = cost - other, tried, other
                    damping = max(damping / 5.0, 1e-12)
                    break
                damping *= 4.0
            if gained <= _SETTLED * cost:
                why = "no step makes it better"
                break
            found, jacobian, met = self.residuals(x, inside, slopes=True)
        return x, cost, met, steps, why


def design_kinematics(
    rig: Rig | str | Path,
    free: Sequence[FreePoint | Mapping[str, Any]] | Mapping[str, Any] | None = None,
    targets: Sequence[KinematicTarget | Mapping[str, Any]] | None = None,
    *,
    vehicle: AxleLayout | None = None,
    starts: int = 8,
    seed: int = 0,
) -> KinematicDesign:
    """Find the hardpoints of a corner that give wanted kinematic values and curves.

    Least squares of all targets, each in tolerances, over the free numbers within their boxes, with exact slopes of
    every row of the catalogue. Targets that contradict each other get the best compromise.

    Parameters
    ----------
    rig : Rig, str or Path
        A corner with hardpoints, the name or file of one; or a study file (schema ``jounce.design/1``) alone.
    free : sequence of FreePoint or mapping, optional
        What may move, with the keys of ``[[free]]``: ``point``, and ``within`` or ``box`` (m); or a mapping of paths
        to ``within``.
    targets : sequence of KinematicTarget or mapping, optional
        What is wanted, with the keys of ``[[target]]``: ``quantity``, ``value`` (its unit, or SI), ``tolerance``,
        ``at`` or ``over`` (m, or an angle for roll), and so on.
    vehicle : AxleLayout, optional
        The car around the axle, for anti-effects and Ackermann.
    starts : int
        How many searches begin; the first at the rig, the others at places of the boxes.
    seed : int
        Seed of those places.

    Returns
    -------
    KinematicDesign
        The rig found, every target before and after (SI), what was moved, what fights, sensitivities.

    Raises
    ------
    DescriptionError
        For unknown paths or quantities, empty boxes, numbers that do nothing, a rig or boxes that cannot reach the
        poses of the targets.

    Examples
    --------
    >>> import jounce as jn
    >>> found = jn.design_kinematics(
    ...     jn.load("formula-student-front"),
    ...     [{"point": "hardpoints.tie_rod_inner[2]", "within": "15 mm"}],
    ...     [{"quantity": "bump_steer", "value": "0 deg/m", "tolerance": "0.1 deg/m"}],
    ... )
    >>> found.met, round(1e3 * found.moved["hardpoints.tie_rod_inner[2]"].after, 1)   # mm
    (True, 148.4)
    """
    if free is None or targets is None:
        return _of_file(rig, free, targets)
    chosen = check_corner(load(rig) if isinstance(rig, (str, Path)) else rig)
    listed = [{"point": path, "within": width} for path, width in free.items()] if isinstance(free, Mapping) else free
    points = [item if isinstance(item, FreePoint) else FreePoint(**item) for item in listed]
    wishes = [item if isinstance(item, KinematicTarget) else KinematicTarget(**item) for item in targets]
    for name, items in (("free", points), ("targets", wishes)):
        if not items:
            raise DescriptionError("nothing is given", where=name, allowed="one or more")
    if starts < 1:
        raise DescriptionError("not a number of searches", where="starts", found=starts, allowed="1 or more")
    return _design(chosen, points, wishes, vehicle, starts, seed)


def _of_file(rig: Rig | str | Path, free: object, targets: object) -> KinematicDesign:
    if not isinstance(rig, (str, Path)) or free is not None or targets is not None:
        raise DescriptionError(
            "free points or targets are missing", where="design_kinematics", allowed="both, or a study file alone"
        )
    return design_study(rig)[0]


def design_study(path: Path | str, *, starts: int | None = None) -> tuple[KinematicDesign, Path]:
    """Run a study file; give the design and the file of its rig. Errors name the file and the line."""
    study, text = read_description(KinematicStudy, path, SCHEMA)
    file = rig_named_in(study.rig, Path(path))
    try:
        found = _design(
            check_corner(load(file)),
            list(study.free),
            list(study.target),
            study.vehicle,
            starts or study.starts,
            study.seed,
        )
    except DescriptionError as error:
        raise _placed(error, path, text) from None
    return found, file


def check_study(path: Path | str) -> tuple[KinematicStudy, int]:
    """Read a study file without a search; give it with how many numbers are free. Errors name the file and the line."""
    study, text = read_description(KinematicStudy, path, SCHEMA)
    rig = check_corner(load(rig_named_in(study.rig, Path(path))))
    try:
        read_targets(rig, study.target, study.vehicle)
        return study, len(free_numbers(rig, study.free).owners)
    except DescriptionError as error:
        raise _placed(error, path, text) from None


def _placed(error: DescriptionError, path: Path | str, text: str) -> DescriptionError:
    """The error with file and line, where its place is one of the study."""
    head = error.where.replace("]", "").replace("[", ".").split(".")
    if head[0] not in ("free", "target"):
        return error
    line = line_of(text, tuple(int(part) if part.isdigit() else part for part in head))
    where = f"{path}{f', line {line}' if line else ''}: {error.where}"
    return DescriptionError(error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint)


def _design(
    rig: Corner,
    free: list[FreePoint],
    targets: list[KinematicTarget],
    vehicle: AxleLayout | None,
    starts: int,
    seed: int,
) -> KinematicDesign:
    wanted = read_targets(rig, targets, vehicle)
    numbers = free_numbers(rig, free)
    evaluator = Evaluator(rig, wanted, numbers.directions, numbers.lengths, vehicle)
    search = _Search(evaluator, numbers, wanted)
    before, _ = evaluator.at(numbers.origin, slopes=False)
    missing = [item for item, value in zip(wanted, before, strict=True) if not np.all(np.isfinite(value))]
    if missing:
        ends, where = evaluator.unreached(), f"target[{wanted.index(missing[0])}]"
        if not ends and missing[0].along != "roll":
            raise DescriptionError(
                "has no value at a pose of the target", where=where, found=missing[0].quantity, hint=_NO_VALUE
            )
        raise DescriptionError(
            "the rig itself cannot reach the poses of a target",
            where=where,
            found=ends[0] if ends else missing[0].quantity,
            hint="Ask for less travel, or start from another rig.",
        )
    _refuse_idle(search, free, seed)
    outcomes = [_start(search, x) for x in _places(search, starts, seed)]
    reached = [outcome for outcome in outcomes if np.isfinite(outcome.cost)]
    if not reached:
        raise DescriptionError(
            "no mechanism within the boxes reaches the poses of the targets",
            where="free",
            found=f"{len(outcomes)} starts, all out of reach",
            hint="Widen the boxes, or let them hold the rig's own points.",
        )
    for best in sorted(reached, key=lambda one: (not one.met, one.travelled if one.met else one.cost)):
        try:
            moved = _moved_rig(rig, search, best.x)
        except JounceError:
            continue
        return _result(rig, moved, search, best.x, before, outcomes, vehicle)
    raise DescriptionError("no design found is a rig", where="free", hint="Narrow the boxes.")


@dataclass(frozen=True)
class _Outcome:
    x: Array
    cost: float
    met: bool
    steps: int
    ended: str

    @property
    def travelled(self) -> float:
        return float(np.sqrt(np.mean(self.x**2)))


def _start(search: _Search, x: Array) -> _Outcome:
    """Search from a place; where the compromise misses a target, try to bring all within their tolerances."""
    best = _Outcome(*search.descend(x))
    if best.met or not np.isfinite(best.cost):
        return best
    x, _, met, steps, _ = search.descend(best.x, _INSIDE)
    if not met:
        return best
    residuals, _, _ = search.residuals(x, 0.0, slopes=False)
    return _Outcome(x, float(0.5 * residuals @ residuals), True, best.steps + steps, "all targets are met")


def _places(search: _Search, starts: int, seed: int) -> list[Array]:
    """Where searches begin: the rig (or the nearest place of the boxes), then a Latin hypercube of the boxes."""
    random = np.random.default_rng(seed)
    size = len(search.scale)
    first = np.clip(np.zeros(size), search.lower, search.upper)
    strata = np.array([random.permutation(starts - 1) for _ in range(size)]).T if starts > 1 else np.zeros((0, size))
    shares = (strata + random.random(strata.shape)) / max(starts - 1, 1)
    return [first, *(search.lower + shares * (search.upper - search.lower))]


def _refuse_idle(search: _Search, free: list[FreePoint], seed: int) -> None:
    """Refuse entries of which no number changes any target, at the rig and at another place of the boxes."""
    random = np.random.default_rng(seed + 1)
    other = search.lower + random.random(len(search.scale)) * (search.upper - search.lower)
    effect = np.zeros(len(search.scale))
    for x in (np.zeros(len(search.scale)), other):
        values, slopes = search.evaluator.at(search.numbers(x))
        for item, value, slope in zip(search.wanted, values, slopes, strict=True):
            if np.all(np.isfinite(value)):
                effect = np.maximum(effect, np.max(np.abs(slope * search.scale), axis=0) / item.tolerance)
    for k, entry in enumerate(free):
        own = [j for j, owner in enumerate(search.free.owners) if owner == k]
        if np.max(effect[own]) < _NOTHING:
            raise DescriptionError(
                "does nothing: it changes none of the targets",
                where=f"free[{k}].point",
                found=entry.point,
                hint="Leave it out, or ask for a quantity that it changes.",
            )


# what is told ---------------------------------------------------------------------------------------------------------


def _moved_rig(rig: Corner, search: _Search, x: Array) -> Corner:
    """The rig found, its numbers as they can be written: lengths to the nanometre in mm."""
    index = {path: i for i, path in enumerate(search.evaluator.model.parameters)}
    numbers, before, changed = search.numbers(x), rig.parameters(), {}
    for path in search.free.paths:
        value, unit = float(numbers[index[path]]), unit_of(rig, path)
        if unit == "m":
            value = to_si(f"{1e3 * value:.6f} mm", unit)
        if abs(value - before[path]) > (_STILL if unit == "m" else 0.0):
            changed[path] = value
    return rig.with_changes(changed)


def _result(
    rig: Corner,
    moved: Corner,
    search: _Search,
    x: Array,
    before: list[Array],
    outcomes: list[_Outcome],
    vehicle: AxleLayout | None,
) -> KinematicDesign:
    values, slopes = search.evaluator.at(search.evaluator.model.parameter_values(moved))
    targets = tuple(_told(*one) for one in zip(search.wanted, before, values, strict=True))
    old, new = rig.parameters(), moved.parameters()
    tells = [
        StartResult(
            k,
            outcome.met,
            outcome.cost if np.isfinite(outcome.cost) else None,
            outcome.steps,
            outcome.travelled if np.isfinite(outcome.cost) else None,
            outcome.ended,
        )
        for k, outcome in enumerate(outcomes)
    ]
    evaluations = search.evaluator.evaluations
    return KinematicDesign(
        rig=moved,
        met=all(target.met for target in targets),
        targets=targets,
        moved={path: Moved(old[path], new[path]) for path in search.free.paths},
        starts=tuple(tells),
        evaluations=evaluations,
        sensitivity=_sensitivity(moved, search.wanted, vehicle),
        fights=_fights(search, x, values, slopes),
        findings=tuple(_findings(search, x, targets)),
    )


def _told(item: Wanted, before: Array, after: Array) -> TargetResult:
    text = item.text
    if text.values is not None:
        wanted: Any = item.low.tolist()
    elif text.value is not None:
        wanted = float(item.low[0])
    else:
        wanted = [None if not np.isfinite(bound[0]) else float(bound[0]) for bound in (item.low, item.high)]
    single = len(after) == 1
    return TargetResult(
        item.quantity,
        item.unit,
        float(before[0]) if single else before.tolist(),
        float(after[0]) if single else after.tolist(),
        wanted,
        item.tolerance,
        item.is_met_by(after),
        item.along,
        item.at.tolist(),
        text.weight,
    )


def _sensitivity(rig: Corner, wanted: Sequence[Wanted], vehicle: AxleLayout | None) -> dict[str, tuple[float, ...]]:
    """What each coordinate of a hardpoint changes of each target, SI per metre, the largest over its curve."""
    model = kinematic_model(rig)
    paths = [path for path in model.parameters if path.startswith("hardpoints.")]
    directions = np.zeros((len(model.parameters), len(paths)))
    for j, path in enumerate(paths):
        directions[model.parameters.index(path), j] = 1.0
    _, slopes = Evaluator(rig, wanted, directions, np.full(len(paths), 1e-2), vehicle).at(model.parameter_values(rig))
    largest = np.array([slope[np.argmax(np.abs(slope), axis=0), np.arange(len(paths))] for slope in slopes])
    return {path: tuple(largest[:, j].tolist()) for j, path in enumerate(paths)}


def _fights(search: _Search, x: Array, values: list[Array], slopes: list[Array]) -> tuple[Fight, ...]:
    """Targets that go away when one that is missed comes nearer, at what the boxes still allow."""
    room = (x > search.lower + 1e-9) & (x < search.upper - 1e-9)
    pulls = []
    for item, value, slope in zip(search.wanted, values, slopes, strict=True):
        off = item.off(value) / item.tolerance
        pulls.append((off @ slope * search.scale / item.tolerance) * room)
    sizes = [float(np.linalg.norm(pull)) for pull in pulls]
    found = []
    for i, item in enumerate(search.wanted):
        if item.is_met_by(values[i]) or sizes[i] == 0.0:
            continue
        for j, size in enumerate(sizes):
            if j != i and size > 0.0:
                cosine = float(pulls[i] @ pulls[j] / (sizes[i] * size))
                if cosine < _FIGHTS:
                    found.append(Fight(i, j, cosine))
    return tuple(found)


def _findings(search: _Search, x: Array, targets: Sequence[TargetResult]) -> list[Finding]:
    found = []
    names = list(search.evaluator.model.parameters)
    for j in np.flatnonzero((x <= search.lower + 1e-9) | (x >= search.upper - 1e-9)):
        path = names[int(np.argmax(np.abs(search.free.directions[:, j])))]
        text = "ends at the edge of its box; a wider one may bring the targets nearer."
        if not all(target.met for target in targets):
            found.append(Finding(path, "note", text))
    for i, target in enumerate(targets):
        if not target.met:
            far = float(np.max(np.abs(search.wanted[i].off(np.atleast_1d(np.array(target.after))))))
            text = f"is missed by {far / target.tolerance:.3g} tolerances at its worst."
            found.append(Finding(f"target[{i}] {target.quantity}", "warning", text, far))
    return found
