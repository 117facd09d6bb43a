"""Which clicks of a damper come closest to a target, and what is left over."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations, product
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

import numpy as np

from jounce.core.errors import DescriptionError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, File, Mark, Number, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, plain_table
from jounce.core.types import Array
from jounce.dampers.adjusters import LEVEL, Adjusters, adjusters_over, words_of
from jounce.dampers.curves import with_rest
from jounce.dampers.map import DamperMap
from jounce.dampers.map_files import AnyDamperMap, as_damper_map
from jounce.design.damper_targets import (
    AnyDamperTarget,
    DampedWheel,
    WheelDamping,
    damper_in,
    law_and_rig,
    steady_force,
    wheel_of,
)
from jounce.design.speed_shares import shares_over
from jounce.parts import Rig, as_rig
from jounce.parts.files import rig_path, rig_text, updated_text

Compared = Literal["force", "ratio"]

_ALL = 400_000  # combinations up to which each is tried
_CHUNK = 20_000
_STARTS = 5  # best combinations of measured clicks from which a search among more begins
_CLEAR = 0.02  # share of the target from which it is out of reach
_NEAR = 0.02  # misfit up to which the best is not blamed on the end of the clicks
_SAME = 1e-9


@dataclass(frozen=True)
class ClickChoice(Plain):
    """A combination of clicks and how far it is from the target.

    Attributes
    ----------
    clicks : dict of str to float
        Clicks of each adjuster [1].
    misfit : float
        Root mean square of what is left over, as a share of that of the target [1].
    misfit_interval : (float, float) or None
        The same if all forces were at those ends of their 95 % intervals that are closest to, and furthest from, the
        target; None where intervals are unknown.
    rms_force : float
        Root mean square of the residual force, N.
    rms_ratio : float or None
        Root mean square of the residual damping ratio at the wheel [1]; None if the wheel is unknown.
    is_measured : bool
        Whether the setting was measured; else it is interpolated between measured ones.
    is_as_good : bool or None
        Whether it cannot be told from the best; None where intervals are unknown.
    force, low, high : array (n,)
        Force without gas and friction (N) at the velocities of the target, and its 95 % interval; NaN if unknown.
    """

    clicks: dict[str, float]
    misfit: float
    misfit_interval: tuple[float, float] | None
    rms_force: float
    rms_ratio: float | None
    is_measured: bool
    is_as_good: bool | None
    force: Array
    low: Array
    high: Array


@dataclass(frozen=True)
class ChosenClicks(Plain):
    """Clicks for a target, the best first, with what is left over. SI, bump and compression positive.

    Attributes
    ----------
    choices : tuple of ClickChoice
        The best combinations.
    velocity, target, weight : array (n,)
        Damper velocities that are compared (m/s), the force of the target there (N), and the share of each [1].
    compared : {"force", "ratio"}
        What is compared: forces, or forces over velocity, so that low speeds count as much as high ones.
    wheel : DampedWheel or None
        What the damper works on, for damping ratios.
    combinations : int
        Number of combinations of whole clicks.
    are_all_tried : bool
        Whether each of them was tried; else they were searched two adjusters at a time.
    damper : dict
        Table to write under ``strut.damper``, set to the best: over clicks if one adjuster was moved.
    rig : Rig or None
        The rig with this damper.
    source : str
        Text of the rig's file, whose comments are kept; empty if the rig was not a file.
    findings : tuple of Finding
        Targets out of reach, settings that are interpolated, choices at the end of what was measured.
    """

    choices: tuple[ClickChoice, ...]
    velocity: Array
    target: Array
    weight: Array
    compared: Compared
    wheel: DampedWheel | None
    combinations: int
    are_all_tried: bool
    damper: dict[str, Any]
    rig: Rig | None
    findings: tuple[Finding, ...]
    source: str = ""

    @property
    def best(self) -> ClickChoice:
        """The combination that is closest to the target."""
        return self.choices[0]

    @property
    def residual(self) -> Array:
        """Force of the best combination minus that of the target, N."""
        return np.asarray(self.best.force - self.target)

    @property
    def ratios(self) -> dict[str, Array] | None:
        """Damping ratios at the wheel: of the target, and of the best with its interval; None without a wheel."""
        if self.wheel is None:
            return None
        forces = {"target": self.target, "force": self.best.force}
        made = {name: self.wheel.ratio(self.velocity, force) for name, force in forces.items()}
        ends = [self.wheel.ratio(self.velocity, end) for end in (self.best.low, self.best.high)]
        return {
            "target": made["target"], "ratio": made["force"],
            "low": np.minimum(*ends), "high": np.maximum(*ends),
        }  # fmt: skip

    @property
    def rig_text(self) -> str:
        """Text of the rig file with the chosen clicks.

        Raises
        ------
        DescriptionError
            If no rig was given.
        """
        if self.rig is None:
            raise DescriptionError(
                "no rig is given to write the damper into", where="rig",
                hint="Give --rig, or print the table: it is on the page and in --json.",
            )  # fmt: skip
        return updated_text(self.source, self.rig) if self.source else rig_text(self.rig)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI; without the rig."""
        names = (
            "choices", "velocity", "target", "weight", "compared", "wheel", "combinations",
            "are_all_tried", "damper", "residual", "ratios", "findings",
        )  # fmt: skip
        return plain_table({name: getattr(self, name) for name in names})


@operation(
    "damper clicks",
    offers=("rig_text", "figure", "report"),
    page="jounce.report.damper_sheets:clicks_page",
    title="Clicks of a damper",
    doing="comparing",
    example="jounce damper clicks damper.csv --target updated.toml --out set.toml",
)
def choose_clicks(  # noqa: PLR0913 - each is a choice of its own
    damper_map: AnyDamperMap,
    target: AnyDamperTarget,
    *,
    rig: Annotated[
        Rig | str | Path | None,
        File(
            "Rig into which the damper is written, with the masses for damping ratios; default: the target.",
            "RIG.toml",
            shipped=("parts",),
        ),
    ] = None,
    place: Annotated[
        str, Mark("Beginning of the damper's path in a car: front, rear.", "PLACE")
    ] = "",
    motion_ratio: Annotated[
        float | None, Number("Damper travel over wheel travel.", "RATIO")
    ] = None,
    sprung_mass: Annotated[
        float | str | None, Number("Sprung mass on the wheel.", "MASS", "kg")
    ] = None,
    wheel_rate: Annotated[
        float | str | None, Number("Spring rate at the wheel.", "RATE", "N/m")
    ] = None,
    shares: Annotated[
        Any,
        File(
            r"Histogram of the damper, by which speeds count: the table of `jounce damper histogram --out`, or one "
            r"with velocity \[m/s] and share."
        ),
    ] = None,
    corner: Annotated[
        str, Mark("Corner or axle of the histogram: front_left, front.", "CORNER")
    ] = "",
    compare: Annotated[
        Compared | None,
        Mark(
            "What is compared: forces, or damping ratios, where low speeds count as much as high ones. Default: what "
            "the target states.",
            "force|ratio",
        ),
    ] = None,
    best: Annotated[int, Count("Number of combinations to return.", least=1, most=100)] = 5,
) -> ChosenClicks:
    r"""Find the whole clicks of each adjuster with which a damper comes closest to a target, and what is left over.

    Parameters
    ----------
    damper_map : DamperMap, str or Path
        Map of the damper over its clicks, or its file (see :func:`jounce.read_damper_map`).
    target : WheelDamping, DamperLaw, mapping, Rig, str, Path or result
        Damping ratios at the wheel over its speed; or a damper law, its table, a rig with this damper, its file or
        name, the JSON of ``jounce fit damper``, or a result with such a law or rig (of a fit, a campaign, a design). A
        law's force at rest and friction beside it are left out, as are gas and friction of the damper.
    rig : Rig, str or Path, optional
        Rig into which the damper is written. A quarter car or corner also states motion ratio, sprung mass and wheel
        rate. By default that of the target.
    place : str
        Beginning of the damper's path, for cars with several.
    motion_ratio : float, optional
        Damper travel over wheel travel [1]; by default that of the rig.
    sprung_mass, wheel_rate : float or str, optional
        Sprung mass on the wheel (kg) and spring rate at the wheel (N/m); by default those of the rig. With the motion
        ratio they are required for damping ratios.
    shares : DamperHistograms, mapping of float to float, str or Path, optional
        Histogram of the damper's velocity, by which residuals count: a result of :func:`jounce.damper_histograms` or
        its table; or time share [1] over velocity (m/s, bump positive), or a table with ``velocity`` and ``share``. By
        default each measured velocity counts the same.
    corner : str
        Corner of the histogram, or the beginning of its name: the mean of these corners counts.
    compare : {"force", "ratio"}, optional
        Compare forces, or damping ratios; by default ratios if the target states them.
    best : int
        Number of combinations to return.

    Returns
    -------
    ChosenClicks
        The best combinations, the residual force and damping ratio over velocity with intervals, the table for a rig.
        Between measured clicks forces are interpolated linearly, and their interval says what is known of the error.

    Raises
    ------
    DescriptionError
        If the map has no clicks, the target no law, or both no velocity in common; if damping ratios lack motion
        ratio, sprung mass or wheel rate.

    Examples
    --------
    >>> import jounce as jn
    >>> sheet = [(clicks, v, v * (1000.0 - 50.0 * clicks)) for clicks in (0, 8, 16) for v in (-0.2, -0.1, 0.1, 0.2)]
    >>> text = "clicks,velocity,force" + "".join("\n%g,%g,%g" % row for row in sheet)
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "sheet.csv"
    >>> _ = file.write_text(text)
    >>> chosen = jn.choose_clicks(file, {"coefficient": 730.0})
    >>> chosen.best.clicks, chosen.residual.round(6).tolist()                  # 5 clicks have 750 N s/m
    ({'clicks': 5.0}, [-4.0, -2.0, 2.0, 4.0])
    """
    made = as_damper_map(damper_map)
    if compare not in (None, *get_args(Compared)):
        raise unknown(str(compare), get_args(Compared), what="comparison", where="compare")
    if best < 1:
        raise DescriptionError("out of range", where="best", found=best, allowed="1 or more")
    given = {"motion_ratio": motion_ratio, "sprung_mass": sprung_mass, "wheel_rate": wheel_rate}
    law, own_rig, path = (None, None, "")
    if not isinstance(target, WheelDamping):
        law, own_rig, path = law_and_rig(target, place)
    into, source = _rig_and_text(rig, target, own_rig)
    if into is not None and rig is not None:
        path, _ = damper_in(into, place)
    wheel = wheel_of(into if into is not None else own_rig, given)
    compared = compare or ("ratio" if isinstance(target, WheelDamping) else "force")
    if wheel is None and (compared == "ratio" or isinstance(target, WheelDamping)):
        raise DescriptionError(
            "damping ratios need motion ratio, sprung mass and wheel rate", where="wheel",
            hint="State them, or give a quarter car or a corner as rig.",
        )  # fmt: skip

    def wanted(velocity: Array) -> Array:
        if isinstance(target, WheelDamping):
            assert wheel is not None
            return target.force(velocity, wheel)
        assert law is not None
        return steady_force(law, own_rig, velocity)

    findings: list[Finding] = [*_conditions(made)]
    ratio = None if wheel is None else wheel.motion_ratio
    if corner and shares is None:
        raise DescriptionError(
            "there is no histogram with this corner", where="corner", found=corner,
            hint="Give --shares with it.",
        )  # fmt: skip
    counted = None if shares is None else shares_over(shares, corner, ratio)
    velocity, weight = _speeds(made, counted, findings)
    force = wanted(velocity)
    known = np.isfinite(force)
    if not known.any():
        raise DescriptionError(
            "target and map have no velocity in common", where="target",
            found=Phrase("a map from {low:g} to {high:g} m/s", low=velocity[0], high=velocity[-1]),
        )  # fmt: skip
    velocity, force, weight = velocity[known], force[known], weight[known] / weight[known].sum()
    over = _adjusters(made, velocity)
    search = _Search(over, force, weight / (velocity**2 if compared == "ratio" else 1.0))
    places, are_all = search.best(best)
    choices = _choices(search, places, wheel, weight)
    findings += _about(search, choices)
    damper = _table_at(made, choices[0].clicks)
    changed = None
    if into is not None and path:
        changed = into.with_changes({path: damper})
    return ChosenClicks(
        choices, velocity, force, weight, compared, wheel, search.count, are_all, damper, changed,
        tuple(findings), source,
    )  # fmt: skip


def _rig_and_text(rig: Any, target: Any, own: Rig | None) -> tuple[Rig | None, str]:
    """Return the rig into which the damper is written, by default that of the target, and the text of its file."""
    given = rig if rig is not None else target if own is not None else None
    text = rig_path(given).read_text(encoding="utf-8") if isinstance(given, str | Path) else ""
    return (as_rig(rig) if rig is not None else own), text


def _conditions(made: DamperMap) -> Iterator[Finding]:
    if not made.adjusters:
        raise DescriptionError(
            "the map has no clicks", where="damper_map",
            found=Phrase("{count} settings", count=len(made.settings)),
            hint="State the settings of each file in a table: file, clicks. Map one temperature and gas pressure.",
        )  # fmt: skip
    yield from (item for item in made.findings if item.code == "dampers.conditions_differ")


def _speeds(
    made: DamperMap, shares: tuple[Array, Array] | None, findings: list[Finding]
) -> tuple[Array, Array]:
    """Return the damper velocities to compare (m/s) and their weights: those of the map, or of a histogram."""
    measured = made.velocity
    if shares is None:
        velocity = measured[measured != 0.0]
        return velocity, np.full(len(velocity), 1.0 / len(velocity))
    velocity, share = shares
    inside = (velocity >= measured[0]) & (velocity <= measured[-1])
    beyond = float(share[~inside].sum())
    if beyond > _SAME:
        findings.append(
            finding("design.histogram_beyond_map", "shares", beyond, share=beyond,
                    low=float(measured[0]), high=float(measured[-1]))
        )  # fmt: skip
    used = inside & (share > 0.0) & (velocity != 0.0)
    if not used.any():
        raise DescriptionError(
            "no velocity of the histogram is in the map", where="shares",
            found=Phrase("{low:g} to {high:g} m/s", low=velocity.min(), high=velocity.max()),
            allowed=Phrase("{low:g} to {high:g} m/s", low=measured[0], high=measured[-1]),
        )  # fmt: skip
    return velocity[used], share[used] / share[used].sum()


def _adjusters(made: DamperMap, velocity: Array) -> Adjusters:
    """Put the tables for a rig, without gas and friction, over velocities and adjusters."""
    over = adjusters_over(made.settings, velocity)
    tables = [item.damper for item in made.settings]
    force = np.stack([np.interp(velocity, t["velocity"], t["force"]) for t in tables])
    seals = np.array([[item.friction.standard_error or 0.0] for item in made.settings])
    return replace(over, force=force, error=np.hypot(over.error, seals))


@dataclass(frozen=True)
class _Search:
    """Combinations of whole clicks, and their distance from a target (N) with weights."""

    over: Adjusters
    target: Array
    weight: Array

    @property
    def values(self) -> list[Array]:
        """Whole clicks of each adjuster.

        Raises
        ------
        DescriptionError
            If there are none between the measured clicks.
        """
        values = []
        for name, (low, high) in zip(self.over.names, self.over.reach, strict=True):
            whole = np.arange(math.ceil(low - _SAME), math.floor(high + _SAME) + 1.0)
            if not len(whole):
                raise DescriptionError(
                    "no whole clicks between those that were measured", where=name,
                    found=Phrase("{low:g} to {high:g}", low=low, high=high),
                )  # fmt: skip
            values.append(whole)
        return values

    @property
    def count(self) -> int:
        """Number of combinations."""
        return math.prod(len(values) for values in self.values)

    def misfits(self, places: Array) -> Array:
        """Return the misfit of each place [1]."""
        force = self.over.weights(places) @ self.over.force
        return self.size((force - self.target) ** 2) / self.size(self.target**2)

    def size(self, squares: Array) -> Array:
        """Return the weighted root of mean squares."""
        return np.asarray(np.sqrt(squares @ self.weight / self.weight.sum()))

    def best(self, number: int) -> tuple[Array, bool]:
        """Return the best places, and whether all were tried."""
        values = self.values
        if self.count <= _ALL:
            every = np.stack([axis.ravel() for axis in np.meshgrid(*values, indexing="ij")], axis=1)
            return self._best_of(every, number), True
        nodes = [
            v[np.unique(np.searchsorted(v, np.clip(m, v[0], v[-1])))]
            for v, m in zip(values, self.over.measured, strict=True)
        ]
        place = self._best_of(np.array(list(product(*nodes)), dtype=float), _STARTS)
        before = np.full(len(place), math.inf)
        while (now := self.misfits(place)).min() < before.min() * (1.0 - _SAME):
            before = now
            for first, second in combinations(range(len(values)), 2):
                tries = [
                    self._moved(start, first, second) for start in place[: max(1, _STARTS // 2)]
                ]
                place = self._best_of(np.concatenate([place, *tries]), max(number, _STARTS))
        return place[:number], False

    def _moved(self, start: Array, first: int, second: int) -> Array:
        pairs = np.meshgrid(self.values[first], self.values[second], indexing="ij")
        tries = np.repeat(start[np.newaxis], pairs[0].size, axis=0)
        tries[:, first], tries[:, second] = (values.ravel() for values in pairs)
        return tries

    def _best_of(self, places: Array, number: int) -> Array:
        places = np.unique(places, axis=0)
        misfits = np.concatenate(
            [self.misfits(places[k : k + _CHUNK]) for k in range(0, len(places), _CHUNK)]
        )
        best: Array = places[np.argsort(misfits, kind="stable")[:number]]
        return best


def _choices(
    search: _Search, places: Array, wheel: DampedWheel | None, weight: Array
) -> tuple[ClickChoice, ...]:
    """Describe the best places; a choice is as good as the best if their intervals overlap."""
    forces, errors = search.over.at(places)
    whole = search.size(search.target**2)
    choices: list[ClickChoice] = []
    plain = replace(search, weight=weight)
    for place, force, error in zip(places, forces, errors, strict=True):
        half, away = LEVEL * error, np.abs(force - search.target)
        interval = None
        if np.isfinite(half).all():
            ends = np.maximum(away - half, 0.0), away + half
            near, far = (float(search.size(end**2) / whole) for end in ends)
            interval = near, far
        first = choices[0].misfit_interval if choices else interval
        as_good = None if interval is None or first is None else interval[0] <= first[1]
        rms_ratio = None
        if wheel is not None:
            left = wheel.ratio(search.over.velocity, force - search.target)
            rms_ratio = float(plain.size(left**2))
        same = np.abs(search.over.places - place).max(axis=1) < _SAME
        choices.append(
            ClickChoice(
                dict(zip(search.over.names, map(float, place), strict=True)),
                float(search.size(away**2) / whole), interval, float(plain.size(away**2)), rms_ratio,
                bool(same.any()), as_good if choices else True, force, force - half, force + half,
            )
        )  # fmt: skip
    return tuple(choices)


def _about(search: _Search, choices: tuple[ClickChoice, ...]) -> Iterator[Finding]:
    """Say where the target is out of reach, what is interpolated, and which choices are as good."""
    over, best = search.over, choices[0]
    yield from _out_of_reach(search)
    moved = over.places.shape[1] > 1 and not over.is_whole_grid
    if not best.is_measured:
        code = "design.clicks_added" if moved else "design.clicks_between"
        yield finding(code, _words(best.clicks))
    for k, name in enumerate(over.names):
        ends = over.reach[k]
        if best.misfit > _NEAR and best.clicks[name] in (ends[0], ends[1]):
            yield finding(
                "design.clicks_at_end", words_of(name), best.clicks[name], clicks=best.clicks[name]
            )
    if best.misfit_interval is None:
        yield finding("design.clicks_without_interval", _words(best.clicks))
    others = sum(item.is_as_good is True for item in choices[1:])
    if others:
        yield finding("design.clicks_as_good", _words(best.clicks), others, count=others)


def _words(clicks: Mapping[str, float]) -> str:
    return ", ".join(f"{value:g} {words_of(name)}" for name, value in clicks.items())


def _out_of_reach(search: _Search) -> Iterator[Finding]:
    """Say on each side at which velocities no clicks give the force of the target.

    Between measured clicks forces are linear: their extremes are at combinations of measured clicks.
    """
    over = search.over
    nodes = np.concatenate([np.array(list(product(*over.known))), over.places])
    low, high = np.array(over.reach).T
    inside = ((nodes >= low) & (nodes <= high)).all(axis=1)
    force = over.weights(nodes[inside]) @ over.force
    size = np.abs(search.target)
    for side, sign in (("bump", 1.0), ("rebound", -1.0)):
        on_side = sign * over.velocity > 0.0
        strength = sign * force
        lacks = sign * search.target - strength.max(axis=0)
        exceeds = strength.min(axis=0) - sign * search.target
        for code, gap in (("design.target_too_hard", lacks), ("design.target_too_soft", exceeds)):
            at = np.flatnonzero(on_side & (gap > _CLEAR * size) & (gap > _SAME))
            if len(at):
                speeds = np.abs(over.velocity[at])
                most = float(gap[at].max())
                yield finding(
                    code, side, most, side=side, gap=most,
                    low=float(speeds.min()), high=float(speeds.max()),
                )  # fmt: skip


def _table_at(made: DamperMap, clicks: Mapping[str, float]) -> dict[str, Any]:
    """Return the table for a rig at chosen clicks: over clicks if one adjuster was moved, else over velocity."""
    if len(clicks) == 1:
        return {**made.damper, "clicks": next(iter(clicks.values()))}
    velocity, _ = with_rest(made.velocity, made.velocity)
    over = _adjusters(made, velocity)
    (force,) = over.weights(np.array([list(clicks.values())])) @ over.force
    return {"kind": "table", "velocity": velocity.tolist(), "force": force.tolist()}
