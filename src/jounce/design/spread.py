"""Tolerance study: the effect of manufacturing tolerances on every curve, and what adjustments can recover.

Pickup points on the body, joints of the upright and the rocker, and lengths of links deviate. The corner is assembled
from these parts, which changes the position of the wheel, including camber and toe. Adjustments then bring static
camber and toe, and all curves, as close to the drawing as possible.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, JounceError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.design.kinematic_study import KinematicTarget, Spread
from jounce.design.kinematic_targets import Evaluators, Wanted, numbering_of, read_targets
from jounce.kc.sensitivities import kc_parameters
from jounce.kinematics.adjustments import SETTINGS, apply_adjustments
from jounce.kinematics.clearances import Shape
from jounce.kinematics.model import check_corner
from jounce.kinematics.refitting import Changes, has_rocker, refit, rod_lengths, rods, triple
from jounce.kinematics.sweeps import AxleLayout
from jounce.parts import Corner, Rig, as_rig
from jounce.parts.bodies import distance

_BAND = (2.5, 97.5)  # percent: the usual 95 %
_DEVIATIONS = 2.0  # standard deviations per tolerance
_ALIGNED = float(np.radians(0.05))  # accuracy of setting static camber and toe
_STEP = 1e-4  # m: step of an adjustment to measure its effect
_PUSHROD = "pushrod"
_ROCKER = ("rocker_pivot", "rocker_axis", "pushrod_inner", "pushrod_outer")


@dataclass(frozen=True)
class SpreadTarget(Plain):
    """A target over all cars: bands that contain 95 % of the cars, as built and adjusted, SI.

    ``drawn`` has the values of the drawing; ``met`` and ``met_adjusted`` are the shares of cars that meet the target
    [1]. ``causes`` is the share of each part in the variance, the largest along the curve [1].
    """

    quantity: str
    unit: str
    along: str
    at: list[float]
    drawn: list[float]
    low: list[float]
    high: list[float]
    low_adjusted: list[float]
    high_adjusted: list[float]
    wanted_low: list[float | None]
    wanted_high: list[float | None]
    met: float
    met_adjusted: float
    causes: Mapping[str, float]
    tolerance: float


@dataclass(frozen=True)
class AdjustmentNeed(Plain):
    """Range that an adjustment needs, m: 95 % of the cars need settings between ``low`` and ``high``.

    ``at_its_end`` is the share of the cars that need more than the available range [1].
    """

    low: float
    high: float
    at_its_end: float


@dataclass(frozen=True)
class KinematicSpread(Plain):
    """Effect of deviating parts on target curves.

    Attributes
    ----------
    targets : tuple of SpreadTarget
        In the order of the study.
    cars : int
        Number of cars built.
    failed : int
        Number of cars that cannot be assembled or do not reach a pose.
    met, met_adjusted : float
        Share of the cars that meet all targets, as built and adjusted [1].
    adjustments : mapping of str to AdjustmentNeed
        Range that each adjustment must cover.
    findings : tuple of Finding
        Findings.
    """

    targets: tuple[SpreadTarget, ...]
    cars: int
    failed: int
    met: float
    met_adjusted: float
    adjustments: Mapping[str, AdjustmentNeed]
    findings: tuple[Finding, ...] = ()

    def table(self) -> str:
        """Return all bands as CSV: one row per pose, SI."""
        names = ("drawn", "low", "high", "low_adjusted", "high_adjusted")
        rows = [",".join(("target", "quantity", "unit", "along", "at", *names))]
        for i, target in enumerate(self.targets):
            quantity = f'"{target.quantity}"' if "," in target.quantity else target.quantity
            for k, drawn in enumerate(target.drawn):
                at = repr(target.at[k]) if len(target.drawn) == len(target.at) else ""
                bands = (repr(getattr(target, name)[k]) for name in names[1:])
                rows.append(
                    ",".join((str(i), quantity, target.unit, target.along, at, repr(drawn), *bands))
                )
        return "\n".join([*rows, ""])


def kinematic_spread(
    rig: Rig | str | Path,
    targets: Sequence[KinematicTarget | Mapping[str, Any]],
    spread: Spread | Mapping[str, Any],
    *,
    vehicle: AxleLayout | None = None,
    shapes: Mapping[str, Shape] | None = None,
) -> KinematicSpread:
    """Build many cars from deviating parts and evaluate the targets, as built and after adjustment.

    Parameters
    ----------
    rig : Rig, str or Path
        A corner with the hardpoints of the drawing, or its name or file.
    targets : sequence of KinematicTarget or mapping
        Targets, as for :func:`jounce.design_kinematics`.
    spread : Spread or mapping
        Manufacturing tolerances, e.g. ``{"points": "0.5 mm", "links": "0.3 mm", "adjust": ["tie_rod_length"]}``.
    vehicle : AxleLayout, optional
        Vehicle data of the axle, for anti-effects and Ackermann.
    shapes : mapping of str to Solid or Rim, optional
        Bodies by name, as for :func:`jounce.design_kinematics`, m.

    Returns
    -------
    KinematicSpread
        Bands of every target, shares of cars that meet it, causes, and the ranges that adjustments need.

    Raises
    ------
    DescriptionError
        For unknown points, quantities or adjustments, or a spread without deviations.

    Examples
    --------
    >>> import jounce as jn
    >>> toe = {"quantity": "toe", "over": "-20 mm:20 mm:20 mm", "value": 0.0, "tolerance": "0.05 deg"}
    >>> made = {"points": "0.5 mm", "links": "0.5 mm", "adjust": ["tie_rod_length"], "cars": 20}
    >>> found = kinematic_spread(jn.load("formula-student-front"), [toe], made)
    >>> found.met_adjusted > found.met
    True
    """
    corner = check_corner(as_rig(rig))
    wishes = [
        item if isinstance(item, KinematicTarget) else KinematicTarget(**item) for item in targets
    ]
    if not wishes:
        raise DescriptionError(
            "there are no targets", where="targets", allowed="one target or more"
        )
    chosen = spread if isinstance(spread, Spread) else Spread(**spread)
    cars = {} if vehicle is None else {"": vehicle}
    return spread_of(corner, read_targets({"": corner}, wishes, cars, shapes), chosen, vehicle)


def spread_of(
    rig: Corner, wanted: Sequence[Wanted], spread: Spread, vehicle: AxleLayout | None
) -> KinematicSpread:
    """Build and evaluate the cars of a corner for targets in SI."""
    workshop = Workshop(rig, wanted, spread, vehicle)
    random = np.random.default_rng(spread.seed)
    drawn = workshop.values(rig)
    made, settled, settings, failed = [], [], [], 0
    for _ in range(spread.cars):
        deviations = random.standard_normal(len(workshop.sources)) * workshop.sizes
        try:
            car = workshop.build(deviations)
            values = workshop.values(car)
            lengths, better = workshop.adjust(car, values)
        except JounceError:
            failed += 1
            continue
        if not np.all(np.isfinite(values)) or not np.all(np.isfinite(better)):
            failed += 1
            continue
        made.append(values)
        settled.append(better)
        settings.append(lengths)
    if not made:
        raise DescriptionError(
            "no car of the spread can be assembled", where="spread", hint="Reduce the tolerances."
        )
    return _describe_spread(
        workshop, drawn, np.array(made), np.array(settled), np.array(settings), failed
    )


class Workshop:
    """Builds corners from deviating parts: ``sources`` of deviation with ``sizes`` (standard deviations, m).

    Deviations of stiffnesses are shares.
    """

    def __init__(
        self, rig: Corner, wanted: Sequence[Wanted], spread: Spread, vehicle: AxleLayout | None
    ) -> None:
        self.rig, self.spread = rig, spread
        alone = [Wanted(**{**vars(item), "rig": ""}) for item in wanted]
        self.wanted = alone
        numbering = numbering_of({"": rig}, alone)
        nothing = np.zeros((len(numbering.paths), 0))
        self._evaluator = Evaluators(
            numbering, alone, nothing, np.zeros(0), {} if vehicle is None else {"": vehicle}
        )
        self._numbering = numbering
        self.parts = self._evaluator.parts
        self.tolerance = np.repeat(
            [item.tolerance for item in alone], [len(item.low) for item in alone]
        )
        self._sources()
        self._adjusters()

    def _sources(self) -> None:
        """List the sources of deviations: coordinates of points by name, lengths of links by their inner points."""
        given = self.rig.hardpoints.given()
        held = [
            *(rods(self.rig) or ("arm_inner", "arm_outer")),
            *(name for name in ("strut_top", "spring_top", "damper_top") if name in given),
        ]
        joints = [name for name in dict.fromkeys(rods(self.rig).values()) if name != "wheel_centre"]
        self._inner, self._joints = held, joints
        self._rocker = [name for name in _ROCKER if has_rocker(self.rig) and name in given]
        links = [*rod_lengths(self.rig), *([_PUSHROD] if has_rocker(self.rig) else [])]
        names = [*held, *joints, *(name for name in self._rocker if name not in joints)]
        known = [*names, *(f"{name} length" for name in links)]
        for name in self.spread.exact:
            if name not in known:
                raise unknown(name, known, what="point or length", where="spread.exact")
        self.sources = [(name, i) for name in names for i in range(3)] + [
            (f"{name} length", 0) for name in links
        ]
        sizes = [
            self.spread.exact.get(
                name, self.spread.links if name.endswith(" length") else self.spread.points
            )
            for name, _ in self.sources
        ]
        self._stiff = _stiff_parts(self.rig) if self.spread.stiffnesses > 0.0 else {}
        self.sources += [(name, 0) for name in self._stiff]
        sizes += [self.spread.stiffnesses] * len(self._stiff)
        self.sizes = np.array(sizes) / _DEVIATIONS
        if not np.any(self.sizes > 0.0):
            raise DescriptionError(
                "the spread contains no deviation",
                where="spread",
                allowed="points, links or exact above 0 mm, or stiffnesses above 0",
            )

    def _adjusters(self) -> None:
        fitting = {
            name: item
            for name, item in SETTINGS.items()
            if item.unit == "m" and item.fits(self.rig)
        }
        for i, name in enumerate(self.spread.adjust):
            if name not in fitting:
                raise unknown(
                    name, fitting, what="adjustment of a length", where=f"spread.adjust[{i}]"
                )
        self._settings = [fitting[name] for name in self.spread.adjust]
        ends = [item.range_for(self.rig) for item in self._settings]
        self._low, self._high = (np.array([end[k] for end in ends]) for k in (0, 1))
        self._drawn = self._aims(self.rig, self.values(self.rig))
        columns = []
        for item, (low, high) in zip(self._settings, ends, strict=True):
            step = _STEP if high >= _STEP else -_STEP
            moved = apply_adjustments(self.rig, {item.name: float(np.clip(step, low, high))})
            columns.append((self._aims(moved, self.values(moved)) - self._drawn) / step)
        self._effects = np.array(columns).T if columns else np.zeros((len(self._drawn), 0))

    def ends(self, k: int) -> tuple[float, float]:
        """Return the range of an adjustment, m."""
        return float(self._low[k]), float(self._high[k])

    def values(self, rig: Corner) -> Array:
        """Return the values of all targets, SI."""
        return self._evaluator.together(self._numbering.values({"": rig}), slopes=False)[0]

    def _aims(self, rig: Corner, values: Array) -> Array:
        """Return the quantities to be adjusted: all values in tolerances, and static camber and toe."""
        return np.concatenate(
            [values / self.tolerance, np.array([rig.wheel.camber, rig.wheel.toe]) / _ALIGNED]
        )

    def build(self, deviations: Array) -> Corner:
        """Build the corner from parts that deviate (m)."""
        away: dict[str, Array] = {}
        for (name, i), value in zip(self.sources, deviations, strict=True):
            away.setdefault(name, np.zeros(3))[i] = value
        given = self.rig.hardpoints.given()
        base, longer = self.rig, 0.0
        if (
            self._rocker
        ):  # with the deviating parts of the rocker and the actual length of the push rod
            moved = {
                f"hardpoints.{name}[{i}]": given[name][i] + away[name][i]
                for name in self._rocker
                if name not in self._joints
                for i in range(3)
            }
            base = self.rig.with_changes(moved)
            ends = [
                [points["pushrod_outer"], points["pushrod_inner"]]
                for points in (given, base.hardpoints.given())
            ]
            longer = distance(*ends[0]) - distance(*ends[1]) + away[f"{_PUSHROD} length"][0]
        inner = {name: triple(np.array(given[name]) + away[name]) for name in self._inner}
        lengths = {
            name: length + away[f"{name} length"][0]
            for name, length in rod_lengths(self.rig).items()
        }
        shims = {name: away[name] for name in self._joints}
        if self._stiff:
            known = base.parameters()
            base = base.with_changes(
                {
                    path: known[path] * (1.0 + away[name][0])
                    for name, paths in self._stiff.items()
                    for path in paths
                }
            )
        return refit(base, Changes(inner, lengths, shims, longer))

    def adjust(self, car: Corner, values: Array) -> tuple[Array, Array]:
        """Find settings (m) that bring a car's curves as close to the drawing as possible, and the resulting values."""
        if not self._settings:
            return np.zeros(0), values
        from scipy.optimize import lsq_linear

        aims, values_then, settings = self._aims(car, values), values, np.zeros(len(self._settings))
        for _ in range(
            2
        ):  # the effects are those of the drawing: the second step removes the remaining error of the first
            left = aims - self._drawn - self._effects @ settings
            bounds = (self._low - 1e-12, self._high + 1e-12)
            settings = np.clip(
                lsq_linear(self._effects, -left, bounds=bounds).x, self._low, self._high
            )
            asked = dict(
                zip([item.name for item in self._settings], settings.tolist(), strict=True)
            )
            better = apply_adjustments(car, asked)
            values_then = self.values(better)
            aims = self._aims(better, values_then)
        return settings, values_then

    def causes(self, drawn: Array) -> dict[str, Array]:
        """Return the first-order variance of every value by the part that causes it, SI squared."""
        variances: dict[str, Array] = {}
        for k, (name, _) in enumerate(self.sources):
            if self.sizes[k] > 0.0:
                deviations = np.zeros(len(self.sources))
                deviations[k] = self.sizes[k]
                change = self.values(self.build(deviations)) - drawn
                variances[name] = variances.get(name, np.zeros_like(drawn)) + change**2
        return variances


def _stiff_parts(rig: Corner) -> dict[str, list[str]]:
    """Return the paths of the stiffnesses of each bushing and link."""
    parts: dict[str, list[str]] = {}
    for path in kc_parameters(rig):
        name, _, last = path.rpartition(".")
        if name.startswith(("bushings.", "links.")) and "stiffness" in last:
            parts.setdefault(name, []).append(path)
    if not parts:
        raise DescriptionError(
            "the rig has no stiffnesses of bushings or links",
            where="spread.stiffnesses",
            hint="Leave it out.",
        )
    return parts


def _describe_spread(
    workshop: Workshop, drawn: Array, made: Array, settled: Array, settings: Array, failed: int
) -> KinematicSpread:
    causes = workshop.causes(drawn)
    total = np.maximum(sum(causes.values(), np.zeros_like(drawn)), 1e-300)
    met: dict[str, list[Array]] = {"made": [], "settled": []}
    targets = []
    for item, part in zip(workshop.wanted, workshop.parts, strict=True):
        for name, values in (("made", made), ("settled", settled)):
            met[name].append(np.array([item.is_met_by(row) for row in values[:, part]]))
        (low, high), better = (
            np.percentile(values[:, part], _BAND, axis=0).tolist() for values in (made, settled)
        )
        wanted = [
            [None if not np.isfinite(end) else float(end) for end in ends]
            for ends in (item.low, item.high)
        ]
        worst = part.start + int(np.argmax(total[part]))
        shares = {name: float(variance[worst] / total[worst]) for name, variance in causes.items()}
        targets.append(
            SpreadTarget(
                item.label,
                item.unit,
                item.along,
                item.at.tolist(),
                drawn[part].tolist(),
                low,
                high,
                better[0],
                better[1],
                wanted[0],
                wanted[1],
                float(met["made"][-1].mean()),
                float(met["settled"][-1].mean()),
                dict(sorted(shares.items(), key=lambda share: -share[1])),
                item.tolerance,
            )
        )
    needs = {}
    findings = []
    for k, name in enumerate(workshop.spread.adjust):
        low, high = (float(np.percentile(settings[:, k], end)) for end in _BAND)
        ends = workshop.ends(k)
        beyond = float(
            np.mean((settings[:, k] <= ends[0] + 1e-9) | (settings[:, k] >= ends[1] - 1e-9))
        )
        needs[name] = AdjustmentNeed(low, high, beyond)
        if beyond > 1.0 - (_BAND[1] - _BAND[0]) / 100.0:
            findings.append(finding("design.range_too_small", name, beyond, share=beyond))
    if failed:
        findings.append(
            finding(
                "design.cars_left_out", "spread", failed, failed=failed, cars=workshop.spread.cars
            )
        )
    both = [float(np.all(met[name], axis=0).mean()) for name in ("made", "settled")]
    return KinematicSpread(
        tuple(targets), workshop.spread.cars, failed, both[0], both[1], needs, tuple(findings)
    )
