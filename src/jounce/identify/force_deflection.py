"""Force-deflection trials: zero, loading and unloading branches, hysteresis."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.identify.estimate import linear_least_squares
from jounce.identify.motion import MOTIONS, MeasuredMotion, MotionName, unit_in_words
from jounce.identify.signals import zigzag
from jounce.identify.signs import ForcePositive, StrokePositive, sign_of

Branch = Literal["loading", "unloading", "both"]
Zero = Literal["first-contact", "none"]

_FREE_TRAVEL_SHARE = (
    0.03  # free travel shorter than this share of the stroke is taken as curvature, not as a gap
)
_FORCE_THRESHOLD = (
    0.002  # share of the largest force that indicates contact, if the noise is smaller
)
_TENSION = 0.1  # share of the compression above which the opposite deflection is intended tension
_CYCLE = 0.1  # share of the stroke: a deflection that returns so far and grows again starts a new load cycle


@dataclass(frozen=True)
class ForceDeflectionTrial(Shown):
    """One trial on a test machine, in the order of measurement.

    Attributes
    ----------
    deflection : array (n,)
        Imposed deflection, compression positive [m]; for a rotation the angle [rad].
    force : array (n,)
        Measured force, compression positive [N]; for a rotation the torque [N m].
    name : str
        File or number of the trial, used in results and messages.
    stroke_positive : {"compression", "extension"} or None
        Positive direction of the deflection; None: compression, unless the trial shows the opposite.
    force_positive : {"compression", "tension"} or None
        Positive direction of the force, likewise: a spring resists compression.
    motion : {"translation", "rotation"}
        Force over deflection, or torque over angle.
    """

    deflection: ArrayLike
    force: ArrayLike
    name: str = "trial"
    stroke_positive: StrokePositive | None = None
    force_positive: ForcePositive | None = None
    motion: MotionName = "translation"

    def arrays(self) -> tuple[Array, Array]:
        """Return deflection [m or rad] and force [N or N m] as checked float arrays of shape (n,)."""
        if self.motion not in MOTIONS:
            raise unknown(str(self.motion), MOTIONS, what="motion", where=self.name)
        motion = MOTIONS[self.motion]
        at = f"{self.name}: {motion.deflection_word}", f"{self.name}: {motion.force_word}"
        deflection = as_samples(self.deflection, motion.deflection, where=at[0], error=FitError)
        force = as_samples(self.force, motion.force, where=at[1], error=FitError)
        if deflection.ndim != 1 or deflection.shape != force.shape:
            raise FitError(
                Phrase(
                    "{deflection_word} and {force_word} are not two columns of the same length",
                    deflection_word=Phrase(motion.deflection_word),
                    force_word=Phrase(motion.force_word),
                ),
                where=self.name,
                found=f"shapes {deflection.shape} and {force.shape}",
            )
        bad = np.flatnonzero(~(np.isfinite(deflection) & np.isfinite(force)))
        if len(bad):
            raise FitError(
                "a value is missing or not finite",
                where=self.name,
                found=f"point {bad[0] + 1}",
                allowed="finite numbers",
                hint="Remove the incomplete rows.",
            )
        if len(deflection) < 3:
            raise FitError(
                "too few points", where=self.name, found=len(deflection), allowed="at least 3"
            )
        if np.ptp(deflection) == 0.0:
            raise FitError(
                Phrase(
                    "the {deflection_word} never changes",
                    deflection_word=Phrase(motion.deflection_word),
                ),
                where=self.name,
                found=f"{deflection[0]:g} {motion.deflection} throughout",
                hint=Phrase(
                    "Is the column the imposed {deflection_word}?",
                    deflection_word=Phrase(motion.deflection_word),
                ),
            )
        return deflection, force


@dataclass(frozen=True)
class SeatedTrial:
    """A trial with compression positive and its zero at first contact.

    Index ``turn``, the largest deflection, ends the loading branch and begins the unloading branch. ``zero`` contains
    the values subtracted from deflection [m or rad] and force [N or N m].
    """

    name: str
    deflection: Array
    force: Array
    turn: int
    zero: tuple[float, float]
    motion: MeasuredMotion

    def branch(self, which: Branch) -> tuple[Array, Array]:
        """Return deflection [m or rad] and force [N or N m] of the loading, unloading or both branches."""
        back = int(np.flatnonzero(self.deflection == self.deflection[self.turn])[-1])
        part = {
            "loading": slice(0, self.turn + 1),
            "unloading": slice(back, None),
            "both": slice(None),
        }[which]
        return self.deflection[part], self.force[part]

    def is_two_sided(self) -> bool:
        """Whether the trial reaches well into both tension and compression, about its zero."""
        return all(
            -_TENSION * column.max() > column.min() for column in (self.deflection, self.force)
        )

    def has_unloading(self) -> bool:
        """Whether the trial returns to less than half of its largest deflection."""
        return float(self.deflection[self.turn :].min()) < 0.5 * float(self.deflection[self.turn])


def seat(trial: ForceDeflectionTrial, *, zero: Zero) -> tuple[SeatedTrial, list[Finding]]:
    """Make compression positive and set the zero of a trial to first contact; findings report the changes.

    A record with negative deflections is reversed, and so is a force that falls while the deflection grows. With
    ``zero="first-contact"`` free travel at the start is cut off: at least eight points over more than 3 % of the
    stroke, with a slope significantly below a tenth of the mean stiffness. Its mean force is the zero of the force. The
    zero of the deflection is the intersection of that force with the line through the first points after it. Without
    free travel the first deflection becomes zero if the trial starts unloaded (force below 2 % of the largest); a trial
    that starts under load is unchanged. ``zero="none"`` only determines the signs. Of several load cycles only the one
    with the largest deflection is used, measured from the zero of the first.
    """
    deflection, force = trial.arrays()
    findings: list[Finding] = []
    deflection, force = _compression_positive(trial, deflection, force, findings)
    shift, offset, start = 0.0, 0.0, 0
    motion = MOTIONS[trial.motion]
    begin, end, first = _farthest_cycle(deflection, trial.name, findings)
    if zero == "first-contact":
        shift, offset, start = _first_contact(
            deflection[:first], force[:first], motion, trial.name, findings
        )
    part = slice(max(begin, start), end)
    deflection, force = deflection[part] - shift, force[part] - offset
    seated = SeatedTrial(
        trial.name, deflection, force, int(np.argmax(deflection)), (shift, offset), motion
    )
    if deflection[seated.turn] > _FARTHEST[motion.name]:
        findings.append(
            finding(
                "identify.deflection_unit",
                trial.name,
                deflection[seated.turn],
                word=motion.deflection_word,
                deflection=motion.say(float(deflection[seated.turn])),
            )
        )
    findings += _slip(seated) or _falls(seated)
    back = float(
        (np.maximum.accumulate(deflection[: seated.turn + 1]) - deflection[: seated.turn + 1]).max()
    )
    if back > 0.02 * float(
        np.ptp(deflection)
    ):  # a chosen limit: a lower one reports noise, a higher one hides a return
        findings.append(
            finding(
                "identify.deflection_reverses",
                trial.name,
                back,
                word=motion.deflection_word,
                back=motion.say(back),
            )
        )
    findings += [*_out_of_range(seated), *_drift(seated)]
    return seated, findings


_FARTHEST: dict[MotionName, float] = {"translation": 1.0, "rotation": math.pi}
"""Limits of a plausible deflection: no vehicle spring deflects by a metre, and no part twists by half a turn."""


def _compression_positive(
    trial: ForceDeflectionTrial, deflection: Array, force: Array, findings: list[Finding]
) -> tuple[Array, Array]:
    motion = MOTIONS[trial.motion]

    def note_reversal(word: str, stated: str | None, key: str, code: str) -> None:
        if stated is None:
            code = (
                "identify.sign_reversed"
                if motion.name == "translation"
                else "identify.sign_of_loading_reversed"
            )
        findings.append(finding(code, trial.name, word=word, key=key, stated=stated))

    deflection = sign_of(trial.stroke_positive, "stroke", where=trial.name) * deflection
    force = sign_of(trial.force_positive, "force", where=trial.name) * force
    away = deflection - deflection[0]
    if -away.min() > away.max():
        deflection = -deflection
        note_reversal(
            motion.deflection_word,
            trial.stroke_positive,
            "stroke_positive",
            "identify.stated_stroke_reversed",
        )
    turn = int(np.argmax(deflection))
    loading = slice(0, max(turn, 1) + 1)
    if np.polyfit(deflection[loading] - deflection[0], force[loading], 1)[0] < 0.0:
        force = -force
        note_reversal(
            motion.force_word,
            trial.force_positive,
            "force_positive",
            "identify.stated_force_reversed",
        )
    return deflection, force


def _farthest_cycle(deflection: Array, name: str, findings: list[Finding]) -> tuple[int, int, int]:
    """Return start and end of the load cycle with the largest deflection, and the end of the first cycle."""
    turns, top = zigzag(deflection, _CYCLE * float(np.ptp(deflection))), int(np.argmax(deflection))
    if len(turns) < 3:
        return 0, len(deflection), len(deflection)
    begin = max(turn for turn in turns if turn < max(top, 1))
    begin += int(np.flatnonzero(deflection[begin : top + 1] == deflection[begin])[-1])
    end = min((turn + 1 for turn in turns if turn > top), default=len(deflection))
    findings.append(
        finding(
            "identify.several_cycles",
            name,
            len(turns) - 1,
            turns=len(turns) - 1,
            begin=begin + 1,
            end=end,
        )
    )
    return begin, end, turns[2] + 1


def _first_contact(
    deflection: Array, force: Array, motion: MeasuredMotion, name: str, findings: list[Finding]
) -> tuple[float, float, int]:
    turn = int(np.argmax(deflection))
    largest = float(np.abs(force).max())
    head = max(3, int(0.01 * turn))
    base = float(force[:head].mean())
    threshold = max(_FORCE_THRESHOLD * (float(force.max()) - base), 4.0 * float(force[:head].std()))
    below = np.flatnonzero(force[: turn + 1] <= base + threshold)
    last = int(below[-1]) if len(below) else 0
    if _is_free_travel(deflection, force, last, turn):
        offset = float(force[: last + 1].mean())
        near = slice(last + 1, last + 1 + max(3, (turn - last) // 10))
        slope, level = np.polyfit(deflection[near], force[near], 1)
        met = (offset - level) / slope if slope > 0.0 else deflection[last]
        contact = float(np.clip(met, deflection[last - 1], deflection[last + 1]))
        travel = contact - float(deflection[0])
        findings.append(
            finding(
                "identify.free_travel_removed",
                name,
                travel,
                travel=motion.say(travel),
                offset=offset,
                unit=unit_in_words(motion.force),
            )
        )
        return contact, offset, last + 1
    if (
        force[0] < 0.0
        and force.min() < -_TENSION * force.max()
        and deflection.min() < -_TENSION * deflection.max()
    ):
        findings.append(
            finding(
                "identify.zeros_recorded",
                name,
                force[0],
                pulled=motion.pulled,
                pushed=motion.pushed,
            )
        )
        return 0.0, 0.0, 0
    if (
        abs(force[0]) > 0.02 * largest
    ):  # a chosen limit: noise of the tests reaches a third of it, and a higher one hides a preload
        findings.append(
            finding(
                "identify.starts_loaded",
                name,
                force[0],
                force=force[0],
                unit=unit_in_words(motion.force),
                word=motion.deflection_word,
            )
        )
        return 0.0, 0.0, 0
    return float(deflection[0]), 0.0, 0


def _is_free_travel(deflection: Array, force: Array, last: int, turn: int) -> bool:
    """Whether the points up to ``last`` are significantly flat: a soft start must not be mistaken for a gap."""
    stroke = float(deflection[turn] - deflection[0])
    travel = float(deflection[last] - deflection[0])
    if last < 7 or turn - last < 3 or travel <= _FREE_TRAVEL_SHARE * stroke:
        return False
    flat = slice(0, last + 1)
    regressors = np.column_stack([deflection[flat], np.ones(last + 1)])
    coefficients, _, spread = linear_least_squares(regressors, force[flat])
    upper = float(coefficients[0]) + 2.0 * float(np.sqrt(spread.covariance[0, 0]))
    # A tenth of the mean stiffness: a soft start of a spring is stiffer.
    return upper < 0.1 * float(np.ptp(force[: turn + 1])) / stroke


def _falls(trial: SeatedTrial) -> list[Finding]:
    """Report a force that falls while the deflection grows."""
    deflection, force = trial.branch("loading")
    below = force[
        deflection < (1.0 - _TOP) * deflection.max()
    ]  # nearer to the top noise mixes both branches
    drop = float((np.maximum.accumulate(below) - below).max(initial=0.0))
    if drop <= 0.03 * float(np.ptp(force)):  # a choice: noise of the tests reaches a third of it
        return []
    motion = trial.motion
    return [
        finding(
            "identify.force_falls",
            trial.name,
            drop,
            force_name=motion.force_word,
            drop=drop,
            unit=unit_in_words(motion.force),
            word=motion.deflection_word,
        )
    ]


def _slip(trial: SeatedTrial) -> list[Finding]:
    """Report a slipped grip: the force drops and continues parallel to the previous line, which no bend explains."""
    deflection, force = trial.branch("loading")
    if len(deflection) < _FEWEST_SLIP:
        return []
    thin = max(1, len(deflection) // 400)
    x = (deflection[::thin] - deflection[0]) / float(np.ptp(deflection))
    f = force[::thin]

    def misfit(*columns: Array) -> tuple[float, Array]:
        matrix = np.column_stack([np.ones_like(x), x, *columns])
        factors = np.linalg.lstsq(matrix, f, rcond=None)[0]
        return float(np.sum((f - matrix @ factors) ** 2)), factors

    places = np.linspace(0.1, 0.9, 81)
    bent = min(
        [misfit(x**2, x**3)[0], *(misfit(np.maximum(x - place, 0.0))[0] for place in places)]
    )
    tried = [
        (*misfit(np.clip((x - place) / width, 0.0, 1.0)), place)
        for place in places
        for width in _SLIDES
    ]
    # A step must exceed three standard deviations of the noise, and a share of the range.
    slid, (_, slope, step), place = min(tried, key=lambda attempt: attempt[0])
    lost, noise = -float(step), math.sqrt(slid / len(x))
    if (
        slid > _SLIPPED * bent
        or lost < max(_LEAST_SLIP * float(np.ptp(f)), 3.0 * noise)
        or slope <= 0.0
    ):
        return []
    stroke, motion = float(np.ptp(deflection)), trial.motion
    rate, begin = float(slope) / stroke, float(deflection[0]) + place * stroke
    return [
        finding(
            "identify.slip",
            trial.name,
            lost,
            force_name=motion.force_word,
            lost=lost,
            unit=unit_in_words(motion.force),
            begin=motion.say(begin),
            slip=motion.say(lost / rate, 2),
            rate=rate,
            rate_unit=unit_in_words(motion.stiffness),
        )
    ]


_FEWEST_SLIP, _SLIDES = (
    15,
    (0.01, 0.03, 0.08),
)  # points; shares of the stroke over which a grip slides
_SLIPPED, _LEAST_SLIP = (
    0.4,
    0.01,
)  # relative to the residual of a cubic or a kink, and to the range of the force
_TOP = 0.02  # share of the largest deflection within which a point counts as at the top or at the start
_FLAT = 0.05  # of the stroke over which the force may stay at its largest value
_ON_THE_WAY = 0.75  # share of the force lost at the end that hysteresis would take in mid-stroke
_NO_DRIFT = 0.02  # of the largest force by which it may differ where a trial ends as it began


def _out_of_range(trial: SeatedTrial) -> list[Finding]:
    """Report a clipped force, which stays at its maximum while the deflection continues."""
    deflection, force = trial.deflection, trial.force
    top = np.flatnonzero(force == force.max())
    over = float(np.ptp(deflection[top]))
    if len(top) < _FEWEST_FLAT or over < _FLAT * float(np.ptp(deflection)):
        return []
    motion = trial.motion
    return [
        finding(
            "identify.deflection_out_of_range",
            trial.name,
            over,
            force_name=motion.force_word,
            top=force.max(),
            unit=unit_in_words(motion.force),
            over=motion.say(over),
            begin=motion.say(float(deflection[top].min())),
        )
    ]


_FEWEST_FLAT = 6  # samples; a choice: fewer may be noise at the top


def _drift(trial: SeatedTrial) -> list[Finding]:
    """Report a force difference at the end of a trial that hysteresis cannot explain, such as a drift."""
    deflection, force, stroke = trial.deflection, trial.force, float(np.ptp(trial.deflection))
    end = deflection[trial.turn :]
    back = trial.turn + int(np.argmin(np.abs(end - deflection[0])))
    if (
        abs(float(deflection[back] - deflection[0])) > _TOP * stroke
        or len(force) - trial.turn < _FEWEST_FLAT
    ):
        return []
    slope = float(np.ptp(force)) / stroke
    unit, rate = unit_in_words(trial.motion.force), unit_in_words(trial.motion.stiffness)
    less = force - slope * (deflection - deflection[0])
    gained = float(np.median(less[max(back - 2, trial.turn + 1) : back + 3]) - np.median(less[:5]))
    if abs(gained) < _NO_DRIFT * float(force.max()):
        return []
    if gained < 0.0:  # hysteresis is widest on the way, a drift at the end
        up, down = (
            _sort_by_deflection(*trial.branch("loading")),
            _sort_by_deflection(*trial.branch("unloading")),
        )
        middle = 0.5 * float(deflection.min() + deflection.max())
        if float(np.interp(middle, *up) - np.interp(middle, *down)) > -_ON_THE_WAY * gained:
            return []
        return [
            finding(
                "identify.zero_drifts_down",
                trial.name,
                gained,
                lost=-gained,
                unit=unit,
                word=trial.motion.deflection_word,
                slope=0.5 * gained / stroke,
                rate_unit=rate,
            )
        ]
    return [
        finding(
            "identify.zero_drifts_up",
            trial.name,
            gained,
            gained=gained,
            unit=unit,
            word=trial.motion.deflection_word,
            slope=0.5 * gained / stroke,
            rate_unit=rate,
        )
    ]


def hysteresis(trial: SeatedTrial) -> tuple[float | None, float | None]:
    """Compute the energy lost in a load cycle [J] and the loss factor [1]; None without an unloading branch.

    The energy is the area between the loading and unloading branches over their common range of deflections. The loss
    factor is ``energy / (2 pi W_max)`` with the work W_max of the loading branch over the same range.
    """
    if not trial.has_unloading():
        return None, None
    up, down = (
        _sort_by_deflection(*trial.branch("loading")),
        _sort_by_deflection(*trial.branch("unloading")),
    )
    low, high = max(up[0][0], down[0][0]), min(up[0][-1], down[0][-1])
    grid = np.union1d(np.union1d(up[0], down[0]), [low, high])
    grid = grid[(grid >= low) & (grid <= high)]
    energy = float(np.trapezoid(np.interp(grid, *up) - np.interp(grid, *down), grid))
    work = float(np.trapezoid(np.abs(np.interp(grid, *up)), grid))
    return energy, energy / (2.0 * math.pi * work) if work > 0.0 else None


def _sort_by_deflection(deflection: Array, force: Array) -> tuple[Array, Array]:
    """Sort by deflection, averaging points at the same deflection."""
    values, inverse = np.unique(deflection, return_inverse=True)
    return values, np.bincount(inverse, force) / np.bincount(inverse)


def number_namesakes(trials: list[ForceDeflectionTrial]) -> list[ForceDeflectionTrial]:
    """Append numbers to the names of trials that share a name, to distinguish them in messages."""
    names = [trial.name for trial in trials]
    return [
        replace(trial, name=f"{trial.name} {index}") if names.count(trial.name) > 1 else trial
        for index, trial in enumerate(trials, 1)
    ]
