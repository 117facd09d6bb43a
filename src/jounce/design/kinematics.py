"""Hardpoints from targets: the points of a corner, or of several, that give wanted curves.

The result also reports what shaped it: which targets conflict, what each point changes, and which points the
curves determine.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from jounce.core.description import line_of, read_description
from jounce.core.display import display_unit
from jounce.core.errors import DescriptionError, JounceError, at_line, below
from jounce.core.findings import Finding, finding
from jounce.core.serialise import Plain
from jounce.core.text import qualify
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.free_points import FreeNumbers, Numbering, Rigs, free_numbers
from jounce.design.hardpoint_search import (
    UNSETTLED,
    HardpointSearch,
    Outcome,
    places,
    refuse_idle,
    search_from,
)
from jounce.design.kinematic_study import (
    NAME,
    SCHEMA,
    FreePoint,
    KinematicStudy,
    KinematicTarget,
    Spread,
)
from jounce.design.kinematic_targets import Evaluators, Wanted, numbering_of, read_targets
from jounce.design.spread import KinematicSpread, Workshop, spread_of
from jounce.kc.tests import TESTS
from jounce.kinematics.clearances import Shape
from jounce.kinematics.model import check_corner
from jounce.kinematics.sweeps import AxleLayout
from jounce.parts import Corner, DependentAxle, Rig, as_rig, load
from jounce.parts.files import rig_named_in

_FIGHTS = -0.3  # cosine between the gradients of two targets below which they conflict
_STILL = 0.5e-9  # m: smaller movements are ignored
_EDGE = 0.02  # half boxes: a variable this close to the edge is reported as being on it
_GENTLE = 0.03  # tolerances: smallest effect of half a box that counts as influence
_AT_LIMIT = 1e-3  # tolerances
_SEEN = 1.0  # tolerances: change of the curves from which points are distinguishable
_NOISE = 1e-9  # share of the largest change below which a change is noise
_LOST = (
    1e-6  # share of a variable in undetermined directions from which the variable is undetermined
)
_PART = 0.1  # share of a combination from which a variable is listed
_MOST_OPEN = 5  # combinations listed at most
_NO_VALUE = "Ackermann needs a steered wheel; swing-arm lengths and instant centres need arms that are not parallel."


# results --------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class TargetResult(Plain):
    """A target before and after the search: one value (SI) for a single pose or a slope, otherwise one per pose.

    ``wanted`` is a value, a list of values, or the limits ``[at_least, at_most]`` (None for an open side). ``at`` has
    the poses of the values (m or rad) along ``along``. ``must`` is True for a constraint. ``rig`` is the name of the
    target's rig in a study of several. ``right`` is the right corner of the axle if it is not the mirror image of the
    left one. ``limits`` is True if ``wanted`` are limits. ``test`` is True for a row of a K&C sheet: ``along`` is the
    name of its test.
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
    must: bool = False
    rig: str = ""
    limits: bool = False
    right: str = ""
    test: bool = False

    def bounds(self) -> tuple[Array, Array]:
        """Return the lower and upper limit at each pose, SI; infinite where there is no limit."""
        low, high = self.wanted if self.limits else (self.wanted, self.wanted)
        ends = (-np.inf if low is None else low, np.inf if high is None else high)
        count = np.size(self.after)
        return tuple(np.broadcast_to(np.array(end, dtype=float), (count,)) for end in ends)  # type: ignore[return-value]

    def off(self, values: Array) -> Array:
        """Return the deviation of values from the target, in tolerances [1]; positive above, negative below."""
        low, high = self.bounds()
        return np.asarray(
            np.where(values > high, values - high, np.minimum(values - low, 0.0)) / self.tolerance
        )

    def worst(self, values: float | list[float]) -> tuple[int, float]:
        """Return the index of the value farthest from the target, and its deviation, SI (positive above the target)."""
        each = np.atleast_1d(np.array(values, dtype=float))
        low, high = self.bounds()
        k = int(np.argmax(np.maximum(low - each, each - high)))
        return k, float(self.off(each)[k] * self.tolerance)

    def pose(self, k: int) -> str:
        """Return the pose of a value as text in display units, e.g. ``-30 mm``; for a slope, the whole range."""
        unit = display_unit(_unit_along(self.along, is_test=self.test))
        ends = [self.at[k]] if len(self.at) == np.size(self.after) else [self.at[0], self.at[-1]]
        text = " … ".join(f"{0.0 + round(end * unit.factor, 6):g}" for end in ends)
        return f"{text} {unit.name}{' of rack' if self.along == 'rack' else ''}"

    @property
    def has_curve(self) -> bool:
        """Whether the target has a separate value for each pose."""
        return isinstance(self.wanted, list) and not self.limits

    @property
    def label(self) -> str:
        """Return the quantity in words, preceded by its rig in a study of several, and by its K&C test."""
        test = f"{self.along}:" if self.test else ""
        return " ".join(part for part in (self.rig, test, self.quantity) if part).replace("_", " ")


@dataclass(frozen=True)
class Moved(Plain):
    """A parameter of the rig before and after the search, SI."""

    before: float
    after: float


@dataclass(frozen=True)
class StartResult(Plain):
    """The end of one search.

    ``cost`` is half the sum of squared deviations of all targets, in tolerances; ``travelled`` is the mean distance
    from the rig as a share of the boxes. Both are None if the linkage cannot be assembled at the start. ``ended`` is
    the reason why the search stopped; ``holds`` is True if the constraints are met. ``numbers`` are the free variables
    at the end by path (SI), which allows choosing a design other than the best; it is empty if they do not form a valid
    rig.
    """

    start: int
    met: bool
    cost: float | None
    steps: int
    travelled: float | None
    ended: str
    holds: bool = True
    numbers: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Fight(Plain):
    """Two conflicting targets: improving one worsens the other. The cosine is that between their gradients [1]."""

    missed: int
    other: int
    cosine: float


@dataclass(frozen=True)
class Identified(Plain):
    """Standard deviations of a free parameter, in its SI ``unit``, if the curves are known to within their tolerances.

    ``alone`` applies if all other parameters are known, ``together`` if all are estimated at once. A value is None
    where it exceeds half the box: the parameter has no influence on the curves, or others can compensate for it.
    """

    number: str
    unit: str
    alone: float | None
    together: float | None


@dataclass(frozen=True)
class OpenCombination(Plain):
    """Parameters that the curves cannot distinguish: moving them by ``shares`` of their boxes has hardly any effect.

    ``change`` is the root of the sum of squared changes of all values, in tolerances.
    """

    change: float
    shares: Mapping[str, float]


@dataclass(frozen=True)
class KinematicDesign(Plain):
    """Hardpoints found from targets.

    Attributes
    ----------
    rigs : mapping of str to Corner or DependentAxle
        The rigs with their points moved, by name; a single rig has the name "".
    met : bool
        Whether all targets are within their tolerances.
    targets : tuple of TargetResult
        In the order of the study.
    moved : mapping of str to Moved
        Free and tied parameters by path, SI.
    starts : tuple of StartResult
        The outcome of every search.
    evaluations : int
        Number of designs evaluated.
    sensitivity : mapping of str to tuple of float
        Change of each target per coordinate of every hardpoint at the design found: SI per metre, the largest along the
        curve.
    fights : tuple of Fight
        Targets that conflict with the missed ones.
    tradeoffs : tuple of tuple of float
        Response of the column's target, in tolerances (the largest along its curve), when the row's target is shifted
        by one tolerance and the compromise is recomputed. A diagonal element of 1 means that the shift is met in full;
        a smaller one, that it is met only in part.
    identified : tuple of Identified
        How well the curves determine each free parameter.
    open : tuple of OpenCombination
        Combinations that the curves do not determine, the one with the smallest change first.
    spread : mapping of str to KinematicSpread
        Effect of the tolerances of the parts on the curves, by the name of the rig; empty if no spread is given.
    findings : tuple of Finding
        Findings.
    """

    rigs: Rigs
    met: bool
    targets: tuple[TargetResult, ...]
    moved: Mapping[str, Moved]
    starts: tuple[StartResult, ...]
    evaluations: int
    sensitivity: Mapping[str, tuple[float, ...]]
    fights: tuple[Fight, ...] = ()
    tradeoffs: tuple[tuple[float, ...], ...] = ()
    identified: tuple[Identified, ...] = ()
    open: tuple[OpenCombination, ...] = ()
    spread: Mapping[str, KinematicSpread] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()

    left_out = ("rigs",)

    @property
    def rig(self) -> Corner | DependentAxle:
        """The rig with its points moved; only for a study of a single rig."""
        if len(self.rigs) != 1:
            raise DescriptionError(
                "the study has several rigs",
                where="rig",
                allowed="rigs[...]",
                found=list(self.rigs),
            )
        return next(iter(self.rigs.values()))

    def before(self) -> dict[str, Corner | DependentAxle]:
        """Return the rigs from which the search started."""
        rigs: dict[str, Corner | DependentAxle] = {}
        for name, rig in self.rigs.items():
            head = f"{name}." if name else ""
            mine = {
                path.removeprefix(head): number.before
                for path, number in self.moved.items()
                if path.startswith(head)
            }
            rigs[name] = rig.with_changes(mine)
        return rigs

    def fighting(self) -> tuple[Fight, ...]:
        """Return each pair of conflicting targets once; ``fights`` lists a pair of missed targets twice."""
        pairs = {frozenset((fight.missed, fight.other)): fight for fight in reversed(self.fights)}
        return tuple(
            fight for fight in self.fights if pairs[frozenset((fight.missed, fight.other))] is fight
        )

    def results(self) -> dict[str, Any]:
        """Return the content of ``results.json``: met, targets, moved, starts, evaluations."""
        plain = self.to_dict()
        return {name: plain[name] for name in ("met", "targets", "moved", "starts", "evaluations")}

    def sensitivity_table(self) -> str:
        """Return the sensitivities as CSV: one row per coordinate, the change of each target per millimetre, SI."""
        heads = [
            _head(target, i, f" [{target.unit} per mm]") for i, target in enumerate(self.targets)
        ]
        rows = [
            ",".join([path, *(repr(1e-3 * value) for value in values)])
            for path, values in self.sensitivity.items()
        ]
        return "\n".join([",".join(["coordinate", *heads]), *rows, ""])

    def tradeoff_table(self) -> str:
        """Return the trade-offs as CSV: one row per shifted target, the responses of all targets, in tolerances [1]."""
        heads = [_head(target, i) for i, target in enumerate(self.targets)]
        rows = [
            ",".join([head, *map(repr, row)])
            for head, row in zip(heads, self.tradeoffs, strict=True)
        ]
        return "\n".join([",".join(["one tolerance more of", *heads]), *rows, ""])

    def identified_table(self) -> str:
        """Return the standard deviations of the free parameters as CSV, SI; empty where undetermined."""
        rows = [
            ",".join(
                [
                    row.number,
                    row.unit,
                    *("" if x is None else repr(x) for x in (row.alone, row.together)),
                ]
            )
            for row in self.identified
        ]
        return "\n".join(["number,unit,alone,together", *rows, ""])

    def curve_table(self) -> str:
        """Return all targets as CSV: one row per pose (SI) with value before and after, target and tolerance."""
        rows = ["target,quantity,unit,along,at,before,after,wanted,tolerance"]
        for i, target in enumerate(self.targets):
            before, after = (
                value if isinstance(value, list) else [value]
                for value in (target.before, target.after)
            )
            for k, (value_before, value_after) in enumerate(zip(before, after, strict=True)):
                wanted = (
                    target.wanted
                    if target.limits or not isinstance(target.wanted, list)
                    else target.wanted[k]
                )
                ends = wanted if isinstance(wanted, list) else [wanted]
                text = " to ".join("" if end is None else repr(end) for end in ends)
                at = repr(target.at[k]) if len(after) > 1 or len(target.at) == 1 else ""
                head = f"{i},{_head(target)},{target.unit},{target.along},{at}"
                rows.append(f"{head},{value_before!r},{value_after!r},{text},{target.tolerance!r}")
        return "\n".join([*rows, ""])


def _unit_along(along: str, *, is_test: bool) -> str:
    return TESTS[along].unit if is_test else "rad" if along == "roll" else "m"


def _head(target: TargetResult, i: int | None = None, unit: str = "") -> str:
    """Return the name of a target in a CSV table; its index distinguishes targets of the same quantity."""
    name = qualify(target.rig, target.quantity)
    text = name if i is None else f"{name} {i}{unit}"
    return f'"{text}"' if "," in text else text


# the search -----------------------------------------------------------------------------------------------------------


def design_kinematics(
    rig: Rig | str | Path | Mapping[str, Rig],
    free: Sequence[FreePoint | Mapping[str, Any]] | Mapping[str, Any] | None = None,
    targets: Sequence[KinematicTarget | Mapping[str, Any]] | None = None,
    *,
    vehicle: AxleLayout | Mapping[str, AxleLayout] | None = None,
    starts: int = 8,
    seed: int = 0,
    spread: Spread | Mapping[str, Any] | None = None,
    shapes: Mapping[str, Shape] | None = None,
) -> KinematicDesign:
    """Find hardpoints of one or more corners that meet kinematic targets.

    Minimises the sum of squared deviations of all targets, each in tolerances, over the free variables within their
    boxes. The gradients of every row of the catalogue are exact. For conflicting targets the result is the best
    compromise that meets the targets marked ``must``.

    Parameters
    ----------
    rig : Rig, str or Path, or mapping of str to Rig
        A corner with hardpoints, or its name or file; several rigs by name (both axles, or both sides of one) whose
        points may be tied; or a study file (schema ``jounce.design/1``) without further arguments.
    free : sequence of FreePoint or mapping, optional
        Points that may move, with the keys of ``[[free]]``: ``point``, and ``within`` or ``box`` (m); or a mapping of
        paths to ``within``. With several rigs, a path begins with the name of a rig.
    targets : sequence of KinematicTarget or mapping, optional
        Targets, with the keys of ``[[target]]``: ``quantity``, ``value`` (with a unit, or SI), ``tolerance``,
        ``at`` or ``over`` (m, or an angle for roll), ``must``, ``rig`` and so on; with ``test``, rows of a K&C sheet.
    vehicle : AxleLayout or mapping of str to AxleLayout, optional
        Vehicle data of the axle, needed for anti-effects and Ackermann; with several rigs, one entry per rig name.
    starts : int
        Number of searches; the first starts from the rig, the others from points within the boxes.
    seed : int
        Seed of those points.
    spread : Spread or mapping, optional
        Manufacturing tolerances; if given, their effect on the design found is reported (see :func:`kinematic_spread`).
    shapes : mapping of str to Solid or Rim, optional
        Bodies by name for targets of the quantity ``clearance(one, other)``, m.

    Returns
    -------
    KinematicDesign
        The rigs found, every target before and after (SI), the moved points, conflicting targets, sensitivities, and
        how well the curves determine the free parameters.

    Raises
    ------
    DescriptionError
        For unknown paths or quantities, empty boxes, parameters without effect, or if the rig or no point within the
        boxes can reach the poses of the targets.

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
        return _design_from_file(rig, free, targets)
    if starts < 1:
        raise DescriptionError(
            "invalid number of searches", where="starts", found=starts, allowed="1 or more"
        )
    made = Spread(**spread) if isinstance(spread, Mapping) else spread
    task = replace(read_task(rig, free, targets, vehicle, shapes), spread=made)
    return design(task, starts, seed)


def _design_from_file(rig: object, free: object, targets: object) -> KinematicDesign:
    if not isinstance(rig, (str, Path)) or free is not None or targets is not None:
        raise DescriptionError(
            "free points or targets are missing",
            where="design_kinematics",
            allowed="both of them, or only a study file",
        )
    return run_study(rig, lambda study, task: design(task, study.starts, study.seed))[0]


@dataclass(frozen=True)
class KinematicTask:
    """Task of a search: rigs by name, free points and targets as in a study, and the vehicle data of the rigs."""

    rigs: Rigs
    free: tuple[FreePoint, ...]
    targets: tuple[KinematicTarget, ...]
    vehicles: Mapping[str, AxleLayout]
    spread: Spread | None = None
    shapes: Mapping[str, Shape] = field(default_factory=dict)

    def read(self) -> tuple[Numbering, FreeNumbers, list[Wanted]]:
        """Convert the task to variables and targets in SI; reject impossible targets."""
        wanted = read_targets(self.rigs, self.targets, self.vehicles, self.shapes)
        numbering = numbering_of(self.rigs, wanted)
        return numbering, free_numbers(numbering, self.free), wanted

    def check_spread(self, wanted: Sequence[Wanted]) -> None:
        """Reject a spread that does not apply to these rigs."""
        for name, rig in self.rigs.items() if self.spread is not None else ():
            assert self.spread is not None
            own = wanted_of(wanted, name)
            if own and isinstance(rig, Corner):
                Workshop(rig, own, self.spread, self.vehicles.get(name))

    def search(self) -> HardpointSearch:
        """Prepare a search."""
        numbering, numbers, wanted = self.read()
        evaluator = Evaluators(
            numbering, wanted, numbers.directions, numbers.lengths, self.vehicles
        )
        return HardpointSearch(evaluator, numbers, wanted)


def read_task(
    rig: Rig | str | Path | Mapping[str, Rig],
    free: Sequence[FreePoint | Mapping[str, Any]] | Mapping[str, Any],
    targets: Sequence[KinematicTarget | Mapping[str, Any]],
    vehicle: AxleLayout | Mapping[str, AxleLayout] | None = None,
    shapes: Mapping[str, Shape] | None = None,
) -> KinematicTask:
    """Read the arguments of :func:`design_kinematics` and related functions."""
    rigs = rig if isinstance(rig, Mapping) else {"": as_rig(rig)}
    cars = (
        dict(vehicle) if isinstance(vehicle, Mapping) else {} if vehicle is None else {"": vehicle}
    )
    listed = (
        [{"point": path, "within": width} for path, width in free.items()]
        if isinstance(free, Mapping)
        else free
    )
    points = [item if isinstance(item, FreePoint) else FreePoint(**item) for item in listed]
    wishes = [
        item if isinstance(item, KinematicTarget) else KinematicTarget(**item) for item in targets
    ]
    for name, items in (("rig", rigs), ("free", points), ("targets", wishes)):
        if not items:
            raise DescriptionError("nothing is given", where=name, allowed="one or more")
    for name in rigs if isinstance(rig, Mapping) else ():
        if not re.fullmatch(NAME, str(name)):
            raise DescriptionError(
                "invalid rig name",
                where="rig",
                found=str(name),
                allowed="letters, digits, _ and -",
            )
    return KinematicTask(
        {name: _check_rig(corner) for name, corner in rigs.items()},
        tuple(points),
        tuple(wishes),
        cars,
        shapes=dict(shapes or {}),
    )


def _check_rig(rig: Rig) -> Corner | DependentAxle:
    """Return a rig that has hardpoints to move: a corner, or a dependent axle for targets of K&C tests."""
    return rig if isinstance(rig, DependentAxle) else check_corner(rig)


Found = TypeVar("Found")


def run_study(
    path: Path | str, run: Callable[[KinematicStudy, KinematicTask], Found]
) -> tuple[Found, dict[str, Path]]:
    """Read a study file and run it; return the design and the file of each rig. Errors name file and line."""
    study, text = read_description(KinematicStudy, path, SCHEMA)
    files = {name: rig_named_in(file, Path(path)) for name, file in study.files_by_rig().items()}
    try:
        rigs = {name: _check_rig(load(file)) for name, file in files.items()}
        return run(
            study,
            KinematicTask(
                rigs, study.free, study.target, study.around(), study.spread, study.shapes or {}
            ),
        ), files
    except DescriptionError as error:
        raise _place_error(error, path, text) from None


def check_study(path: Path | str) -> tuple[KinematicStudy, int]:
    """Read a study file without a search; return it and the number of free numbers. Errors name file and line."""

    def read(study: KinematicStudy, task: KinematicTask) -> tuple[KinematicStudy, int]:
        _, numbers, wanted = task.read()
        task.check_spread(wanted)
        return study, len(numbers.owners)

    return run_study(path, read)[0]


def _place_error(error: DescriptionError, path: Path | str, text: str) -> DescriptionError:
    """Return the error with file and line if it refers to a key of the study."""
    head = error.where.replace("]", "").replace("[", ".").split(".")
    if head[0] not in ("free", "target", "spread", "vehicles"):
        return error
    line = line_of(text, tuple(int(part) if part.isdigit() else part for part in head))
    where = below(at_line(path, line), error.where)
    return DescriptionError(
        error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
    )


def design(task: KinematicTask, starts: int, seed: int) -> KinematicDesign:
    """Search for the hardpoints of a task."""
    search = task.search()
    before = values_before(search)
    task.check_spread(search.wanted)
    refuse_idle(search, task.free, seed)
    outcomes = [search_from(search, x) for x in places(search, starts, seed)]
    first = min(range(len(outcomes)), key=lambda i: outcomes[i].rank)
    outcomes[first] = outcomes[first].move_back(
        search
    )  # only for the proposed design: moving back takes longer than a search
    reached = [outcome for outcome in outcomes if np.isfinite(outcome.cost)]
    if not reached:
        raise DescriptionError(
            "no mechanism within the boxes reaches the poses of the targets",
            where="free",
            found=f"{len(outcomes)} starts, all out of reach",
            hint="Widen the boxes, or include the rig's own points in them.",
        )
    for best in sorted(reached, key=lambda outcome: outcome.rank):
        try:
            moved = rigs_of(search, best.x)
        except JounceError:
            continue
        return _result(task, moved, search, best.x, before, outcomes)
    raise DescriptionError(
        "none of the designs found is a valid rig", where="free", hint="Narrow the boxes."
    )


def wanted_of(wanted: Sequence[Wanted], name: str) -> list[Wanted]:
    """Return the targets of one rig, without those of K&C tests and of a whole axle with its own right corner."""
    return [item for item in wanted if item.rig == name and not item.right and item.sheet is None]


def values_before(search: HardpointSearch) -> list[Array]:
    """Return the target values of the initial rigs; reject targets without a value there."""
    wanted = search.wanted
    before, _ = search.evaluator.at(search.free.origin, slopes=False)
    missing = [i for i, value in enumerate(before) if not np.all(np.isfinite(value))]
    if missing:
        ends, where, item = (
            search.evaluator.ends_in_words(),
            f"target[{missing[0]}]",
            wanted[missing[0]],
        )
        if not ends and item.along != "roll":
            raise DescriptionError(
                "has no value at a pose of the target",
                where=where,
                found=item.quantity,
                hint=_NO_VALUE,
            )
        raise DescriptionError(
            "even the initial rig cannot reach the poses of a target",
            where=where,
            found=ends[0] if ends else item.quantity,
            hint="Reduce the travel, or start from a different rig.",
        )
    return before


# results of a search --------------------------------------------------------------------------------------------------


def rigs_of(search: HardpointSearch, x: Array) -> dict[str, Corner | DependentAxle]:
    """Return the rigs of a result with parameters rounded as in files: lengths to the nanometre."""
    numbering = search.evaluator.numbering
    index = {path: i for i, path in enumerate(numbering.paths)}
    numbers = search.numbers(x)
    changed: dict[str, dict[str, float]] = {name: {} for name in numbering.rigs}
    before = {name: rig.parameters() for name, rig in numbering.rigs.items()}
    for path in search.free.paths:
        (name, own), unit = numbering.owner(path, path), numbering.unit(path)
        value = float(numbers[index[path]])
        if unit == "m":
            value = to_si(f"{1e3 * value:.6f} mm", unit)
        if abs(value - before[name][own]) > (_STILL if unit == "m" else 0.0):
            changed[name][own] = value
    return {name: rig.with_changes(changed[name]) for name, rig in numbering.rigs.items()}


def _numbers_at(search: HardpointSearch, outcome: Outcome) -> dict[str, float]:
    """Return the free parameters at the end of a search, rounded as in files; empty if they do not form a valid rig."""
    if not np.isfinite(outcome.cost):
        return {}
    numbering = search.evaluator.numbering
    try:
        values = numbering.values(rigs_of(search, outcome.x))
    except JounceError:
        return {}
    known = dict(zip(numbering.paths, values, strict=True))
    return {path: float(known[path]) for path in search.free.paths}


def _result(
    task: KinematicTask,
    moved: Rigs,
    search: HardpointSearch,
    x: Array,
    before: list[Array],
    outcomes: list[Outcome],
) -> KinematicDesign:
    numbering = search.evaluator.numbering
    values, slopes = search.evaluator.at(numbering.values(moved))
    targets = tuple(
        target_result(*triple) for triple in zip(search.wanted, before, values, strict=True)
    )
    known = dict(
        zip(
            numbering.paths,
            zip(numbering.values(), numbering.values(moved), strict=True),
            strict=True,
        )
    )
    tells = [
        StartResult(
            k,
            outcome.met,
            outcome.cost if np.isfinite(outcome.cost) else None,
            outcome.steps,
            outcome.mean_displacement if np.isfinite(outcome.cost) else None,
            outcome.ended,
            outcome.holds,
            _numbers_at(search, outcome),
        )
        for k, outcome in enumerate(outcomes)
    ]
    evaluations = search.evaluator.evaluations
    identified, still_open = identifiability(search, slopes)
    return KinematicDesign(
        rigs=moved,
        met=all(target.met for target in targets),
        targets=targets,
        moved={
            path: Moved(float(known[path][0]), float(known[path][1])) for path in search.free.paths
        },
        starts=tuple(tells),
        evaluations=evaluations,
        sensitivity=_sensitivity(task, moved, search.wanted),
        fights=_fights(search, x, values, slopes),
        tradeoffs=_tradeoffs(search, x, values, slopes),
        identified=identified,
        open=still_open,
        spread={
            name: spread_of(
                check_corner(rig),
                wanted_of(search.wanted, name),
                task.spread,
                task.vehicles.get(name),
            )
            for name, rig in moved.items()
            if task.spread is not None
            and isinstance(rig, Corner)
            and wanted_of(search.wanted, name)
        },
        findings=(
            *_findings(search, x, targets),
            *_count_unsettled(outcomes),
            *_list_unspread(task, search.wanted),
        ),
    )


def target_result(item: Wanted, before: Array, after: Array) -> TargetResult:
    """Return a target with its values before and after."""
    text = item.text
    limits = text.values is None and text.value is None
    if limits:
        wanted: Any = [
            None if not np.isfinite(bound[0]) else float(bound[0])
            for bound in (item.low, item.high)
        ]
    else:
        wanted = item.low.tolist() if text.values is not None else float(item.low[0])
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
        text.must,
        item.rig,
        limits,
        item.right,
        item.sheet is not None,
    )


def _sensitivity(
    task: KinematicTask, rigs: Rigs, wanted: Sequence[Wanted]
) -> dict[str, tuple[float, ...]]:
    """Return the change of each target per hardpoint coordinate, SI per metre, the largest along its curve."""
    numbering = numbering_of(rigs, wanted)
    paths = [
        path for path in numbering.paths if numbering.owner(path, path)[1].startswith("hardpoints.")
    ]
    directions = np.zeros((len(numbering.paths), len(paths)))
    for j, path in enumerate(paths):
        directions[numbering.paths.index(path), j] = 1.0
    evaluator = Evaluators(numbering, wanted, directions, np.full(len(paths), 1e-2), task.vehicles)
    _, slopes = evaluator.at(numbering.values())
    largest = np.array([_largest(slope) for slope in slopes])
    return {path: tuple(largest[:, j].tolist()) for j, path in enumerate(paths)}


def _largest(values: Array) -> Array:
    """Return the value of largest magnitude in each column (n, m), shape (m,)."""
    return np.asarray(values[np.argmax(np.abs(values), axis=0), np.arange(values.shape[1])])


def _room(search: HardpointSearch, x: Array) -> NDArray[np.bool_]:
    """Return a mask of the variables that are not at the edge of their boxes."""
    return np.asarray((x > search.lower + 1e-9) & (x < search.upper - 1e-9))


def _fights(
    search: HardpointSearch, x: Array, values: list[Array], slopes: list[Array]
) -> tuple[Fight, ...]:
    """Return targets that worsen when a missed one improves, along directions that the boxes still allow."""
    room = _room(search, x)
    pulls = []
    for item, value, slope in zip(search.wanted, values, slopes, strict=True):
        off = item.off(value) / item.tolerance
        pulls.append((off @ slope * search.scale / item.tolerance) * room)
    sizes = [float(np.linalg.norm(pull)) for pull in pulls]
    fights = []
    for i, item in enumerate(search.wanted):
        if item.is_met_by(values[i]) or sizes[i] == 0.0:
            continue
        for j, size in enumerate(sizes):
            if j != i and size > 0.0:
                cosine = float(pulls[i] @ pulls[j] / (sizes[i] * size))
                if cosine < _FIGHTS:
                    fights.append(Fight(i, j, cosine))
    return tuple(fights)


def _tradeoffs(
    search: HardpointSearch, x: Array, values: list[Array], slopes: list[Array]
) -> tuple[tuple[float, ...], ...]:
    """Return the first-order response of the compromise when one target is shifted by one tolerance."""
    room = _room(search, x)
    moves = [
        slope * search.scale / item.tolerance * room
        for item, slope in zip(search.wanted, slopes, strict=True)
    ]
    # limits matter only where they are active
    asks = [
        item.text.weight
        / np.sqrt(len(item.low))
        * ((item.low == item.high) | (_room_within(item, value) < _AT_LIMIT))
        for item, value in zip(search.wanted, values, strict=True)
    ]
    rows = np.vstack([ask[:, None] * move for ask, move in zip(asks, moves, strict=True)])
    normal = rows.T @ rows + _GENTLE**2 * np.eye(rows.shape[1])
    tradeoffs = []
    for ask, move in zip(asks, moves, strict=True):
        step = np.linalg.solve(normal, (ask[:, None] ** 2 * move).sum(axis=0))
        tradeoffs.append(
            tuple(float(_largest((target_move @ step)[:, None])[0]) for target_move in moves)
        )
    return tuple(tradeoffs)


def _room_within(item: Wanted, value: Array) -> Array:
    """Return the margin of values to their limits, in tolerances."""
    return np.asarray(np.minimum(value - item.low, item.high - value) / item.tolerance)


def identifiability(
    search: HardpointSearch, slopes: list[Array]
) -> tuple[tuple[Identified, ...], tuple[OpenCombination, ...]]:
    """Return how well values known to tolerance determine the free variables, and undetermined combinations."""
    rows = np.vstack(
        [
            slope * search.scale / item.tolerance * (item.low == item.high)[:, None]
            for item, slope in zip(search.wanted, slopes, strict=True)
        ]
    )
    labels, units = (
        search.free.labels,
        [search.evaluator.numbering.unit(path) for path in search.free.firsts],
    )
    size = len(labels)
    _, singular_values, directions = np.linalg.svd(
        np.vstack([rows, np.zeros((size, size))]), full_matrices=False
    )
    is_determined = singular_values > _NOISE * max(float(singular_values[0]), _SEEN)
    alone = np.linalg.norm(rows, axis=0)
    spread = np.sqrt(
        ((directions[is_determined] / singular_values[is_determined, None]) ** 2).sum(axis=0)
    )
    lost = ((directions[~is_determined] ** 2).sum(axis=0) > _LOST) | (spread > 1.0)
    numbers = tuple(
        Identified(
            label,
            unit,
            float(search.scale[j] / alone[j]) if alone[j] > 1.0 else None,
            None if lost[j] else float(search.scale[j] * spread[j]),
        )
        for j, (label, unit) in enumerate(zip(labels, units, strict=True))
    )
    weak = [k for k in range(size - 1, -1, -1) if singular_values[k] < _SEEN][:_MOST_OPEN]
    combinations = []
    for k in weak:
        shares = directions[k] * np.sign(directions[k][np.argmax(np.abs(directions[k]))])
        weights = {
            label: float(share)
            for label, share in zip(labels, shares, strict=True)
            if abs(share) > _PART
        }
        combinations.append(
            OpenCombination(float(singular_values[k]) if is_determined[k] else 0.0, weights)
        )
    return numbers, tuple(combinations)


def _list_unspread(task: KinematicTask, wanted: Sequence[Wanted]) -> list[Finding]:
    """List targets that the spread does not cover."""
    several = [
        i
        for i, item in enumerate(wanted)
        if task.spread is not None and (item.right or not isinstance(task.rigs[item.rig], Corner))
    ]
    return [finding("design.not_in_spread", f"target[{i}] {wanted[i].label}") for i in several]


def _count_unsettled(outcomes: Sequence[Outcome]) -> list[Finding]:
    """Count searches that ended before they converged."""
    count = sum(outcome.ended == UNSETTLED for outcome in outcomes)
    return (
        [
            finding(
                "design.searches_unsettled",
                "starts",
                count,
                count=count,
                all=len(outcomes),
                ended=UNSETTLED,
            )
        ]
        if count
        else []
    )


def _findings(search: HardpointSearch, x: Array, targets: Sequence[TargetResult]) -> list[Finding]:
    findings = []
    met = all(target.met for target in targets)
    for j in np.flatnonzero((x < search.lower + _EDGE) | (x > search.upper - _EDGE)):
        code = "design.box_edge_met" if met else "design.box_edge_missed"
        if not met or abs(x[j]) > _EDGE:
            findings.append(finding(code, search.free.labels[j], search.scale[j] * x[j]))
    for i, target in enumerate(targets):
        if not target.met:
            far = float(np.max(np.abs(search.wanted[i].off(np.atleast_1d(np.array(target.after))))))
            code = "design.must_missed" if target.must else "design.target_missed"
            place = f"target[{i}] {search.wanted[i].label}"
            findings.append(finding(code, place, far, tolerances=far / target.tolerance))
    return findings
