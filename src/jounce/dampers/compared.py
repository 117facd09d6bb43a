"""Two dampers of an axle compared: the difference of their forces against a tolerance, with intervals."""

from __future__ import annotations

import csv
import io
import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Number, Texts, operation
from jounce.core.serialise import Plain
from jounce.core.units import positive_si
from jounce.dampers.adjusters import LEVEL, adjusters_over, words_of
from jounce.dampers.curves import DamperSetting
from jounce.dampers.map import CurveAt, DamperMap, shared_velocity
from jounce.dampers.map_files import as_damper_map
from jounce.dampers.sheet import force_at, names_for
from jounce.identify.estimate import Estimate

Verdict = Literal["within", "outside", "cannot be told"]
_QUANTITIES = {"gas_force": "N", "gas_stiffness": "N/m", "friction": "N", "lag": "s"}


@dataclass(frozen=True)
class ComparedForce(Plain):
    """Forces of two dampers at the same clicks and velocity.

    Attributes
    ----------
    clicks : dict of str to float
        Clicks of each adjuster [1].
    velocity : float
        Velocity, m/s, bump positive.
    first, second : float
        Forces without gas, N.
    difference : Estimate
        Second minus first, N, with its interval.
    tolerance : float
        Allowed difference, N.
    verdict : {"within", "outside", "cannot be told"}
        Whether the whole interval of the difference lies within the tolerance, or outside; else it cannot be told.
    """

    clicks: dict[str, float]
    velocity: float
    first: float
    second: float
    difference: Estimate
    tolerance: float
    verdict: Verdict

    @property
    def share(self) -> float:
        """Difference as a share of the tolerance [1]."""
        away = abs(self.difference.value)
        return away / self.tolerance if self.tolerance else math.inf if away else 0.0


@dataclass(frozen=True)
class DamperComparison(Plain):
    """Two dampers beside each other.

    Attributes
    ----------
    names : (str, str)
        Names of the dampers.
    forces : tuple of ComparedForce
        Forces at common clicks and velocities.
    others : dict of str to Estimate
        Second minus first of gas force (N), gas stiffness (N/m), friction (N) and lag (s), of their means over the
        settings.
    tolerance, tolerance_force : float
        Allowed difference: share of the mean of both forces [1], and a force (N); they add.
    findings : tuple of Finding
        Settings that only one damper has, missing intervals, the worst place.
    """

    names: tuple[str, str]
    forces: tuple[ComparedForce, ...]
    others: dict[str, Estimate]
    tolerance: float
    tolerance_force: float
    findings: tuple[Finding, ...]

    @property
    def verdict(self) -> Verdict:
        """Outside if a force is; else "cannot be told" if that is so for a force; else within."""
        counts = self.counts
        if counts["outside"]:
            return "outside"
        return "cannot be told" if counts["cannot be told"] else "within"

    @property
    def counts(self) -> dict[Verdict, int]:
        """Number of forces of each verdict."""
        counted = Counter(item.verdict for item in self.forces)
        return {name: counted[name] for name in ("within", "outside", "cannot be told")}

    @property
    def worst(self) -> ComparedForce:
        """The force whose difference is the largest share of its tolerance."""
        return max(self.forces, key=lambda item: item.share)

    @property
    def is_met(self) -> bool:
        """Whether no force is outside the tolerance."""
        return self.verdict != "outside"

    def cells(self) -> list[list[str | float]]:
        """Return a header and a row for each force, SI."""
        names = list(self.forces[0].clicks)
        rows: list[list[str | float]] = [
            [
                *(words_of(name) for name in names), "velocity [m/s]", "first [N]", "second [N]",
                "difference [N]", "low [N]", "high [N]", "tolerance [N]", "verdict",
            ]
        ]  # fmt: skip
        for item in self.forces:
            ends = item.difference.interval or ("", "")
            rows.append(
                [
                    *(item.clicks[name] for name in names), item.velocity, item.first, item.second,
                    item.difference.value, *ends, item.tolerance, item.verdict,
                ]
            )  # fmt: skip
        return rows

    def table(self) -> str:
        """Write the forces, their differences and verdicts as CSV, SI."""
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        for row in self.cells():
            writer.writerow([f"{x:.9g}" if isinstance(x, float) else x for x in row])
        return stream.getvalue()

    def sheets(self) -> dict[str, list[list[str | float]]]:
        """Return the sheets of a workbook."""
        others: list[list[str | float]] = [
            ["quantity", "second minus first", "low", "high", "unit"]
        ]
        for name, value in self.others.items():
            known = [] if math.isnan(value.value) else [value.value, *(value.interval or ())]
            cells: list[str | float] = [*known, *[""] * (3 - len(known))]
            others.append([name.replace("_", " "), *cells, _QUANTITIES[name]])
        return {"forces": self.cells(), "others": others}

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI, with the verdict and the worst place."""
        own = super().to_dict()
        return {
            "verdict": self.verdict,
            "counts": self.counts,
            "worst": self.worst.to_dict(),
            **own,
        }


@operation(
    "damper compare",
    arguments=2,
    named={"names": "name"},
    offers=("tables", "figure", "report"),
    page="jounce.report.damper_sheets:comparison_page",
    title="Comparison of two dampers",
    doing="comparing",
    example='jounce damper compare left.csv right.csv --tolerance "5 %" --report pair.html',
)
def compare_dampers(
    first: Annotated[
        DamperMap | str | Path, File("Map of a damper: a table, or a folder of records.", "MAP_A")
    ],
    second: Annotated[DamperMap | str | Path, File("Map of the other damper.", "MAP_B")],
    *,
    tolerance: Annotated[
        float | str, Number("Allowed difference as a share of the mean force, e.g. 5 %.", "SHARE")
    ] = 0.05,
    tolerance_force: Annotated[
        float | str, Number("Allowed force beside it; they add.", "FORCE", "N")
    ] = 10.0,
    names: Annotated[
        Sequence[str] | None, Texts("Name of a damper, in order; repeat it.", "NAME")
    ] = None,
) -> DamperComparison:
    r"""Compare two dampers of an axle, force by force, against a tolerance; intervals of both count.

    Parameters
    ----------
    first, second : DamperMap, str or Path
        Maps of the dampers, or their files (see :func:`jounce.read_damper_map`).
    tolerance : float or str
        Allowed difference as a share of the mean of both forces [1].
    tolerance_force : float or str
        Allowed force (N) that is added, because shares of small forces are smaller than a test rig can read.
    names : sequence of str, optional
        Names of both dampers; by default those of their files.

    Returns
    -------
    DamperComparison
        The difference at each velocity that both reached, at the clicks that one of them was measured at and the other
        includes; between its measured clicks the other is interpolated. A force is ``within`` or ``outside`` only if
        the whole 95 % interval of the difference is. ``verdict`` is that of the pair, ``worst`` the largest difference.

    Raises
    ------
    DescriptionError
        If the dampers have no clicks or velocities in common, or a tolerance is not positive.
    RecordingError, FitError
        If a map cannot be read.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> for name, coefficient in (("left", 1000.0), ("right", 1100.0)):
    ...     forces = [(v, coefficient * v) for v in (-0.2, -0.1, 0.1, 0.2)]
    ...     rows = [f"{v},{force},{force - 1.0},{force + 1.0}" for v, force in forces]
    ...     _ = (folder / f"{name}.csv").write_text("\n".join(["velocity,force,low,high", *rows]))
    >>> pair = jn.compare_dampers(folder / "left.csv", folder / "right.csv", tolerance="5 %", tolerance_force=5.0)
    >>> pair.verdict, [item.verdict for item in pair.forces], round(pair.worst.difference.value)
    ('outside', ['outside', 'cannot be told', 'cannot be told', 'outside'], -20)
    """
    given = (first, second)
    maps = (as_damper_map(first), as_damper_map(second))
    share = positive_si(tolerance, "1", where="tolerance", zero=True)
    extra = positive_si(tolerance_force, "N", where="tolerance_force", zero=True)
    if share + extra <= 0.0:
        raise DescriptionError(
            "a tolerance is required", where="tolerance", found=0, allowed="above 0"
        )
    findings: list[Finding] = []
    forces: list[ComparedForce] = []
    for clicks, curves in _pairs(maps, findings):
        for at in shared_velocity(curves):
            loads = [force_at(curve, float(at)) for curve in curves]
            if loads[0] is not None and loads[1] is not None:
                forces.append(_compared(clicks, float(at), loads[0], loads[1], share, extra))
    if not forces:
        raise DescriptionError("the dampers have no velocities in common", where="second")
    called = names_for(names, "names", 2) or [
        Path(item).stem if isinstance(item, str | Path) else word
        for item, word in zip(given, ("first", "second"), strict=True)
    ]
    if any(item.difference.interval is None for item in forces):
        findings.append(finding("dampers.compared_without_interval", "forces"))
    others = {name: _difference([_mean(m, name) for m in maps]) for name in _QUANTITIES}
    return DamperComparison(
        (called[0], called[1]), tuple(forces), others, share, extra, tuple(findings)
    )


Curves = tuple[DamperSetting | CurveAt, DamperSetting | CurveAt]


def _pairs(
    maps: tuple[DamperMap, DamperMap], findings: list[Finding]
) -> list[tuple[dict[str, float], Curves]]:
    """Return the curves of both dampers at the clicks that they have in common."""
    moved = [made.adjusters for made in maps]
    if all(len(made.settings) == 1 for made in maps):
        return [({}, (maps[0].settings[0], maps[1].settings[0]))]
    if moved[0] != moved[1] or not moved[0]:
        raise DescriptionError(
            "the dampers have no clicks in common", where="second",
            found="; ".join(", ".join(words_of(n) for n in names) or "no clicks" for names in moved),
            hint="State the settings of each file in a table: file, clicks.",
        )  # fmt: skip
    overs = [adjusters_over(made.settings, made.velocity) for made in maps]
    places = np.unique(np.concatenate([over.places for over in overs]), axis=0)
    pairs = []
    beyond = 0
    for place in places:
        if not all(
            low <= value <= high
            for over in overs
            for value, (low, high) in zip(place, over.reach, strict=True)
        ):
            beyond += 1
            continue
        clicks = dict(zip(moved[0], map(float, place), strict=True))
        pairs.append((clicks, (_curve(maps[0], clicks), _curve(maps[1], clicks))))
    if beyond:
        findings.append(finding("dampers.clicks_of_one_only", "clicks", beyond, count=beyond))
    if not pairs:
        raise DescriptionError("the dampers have no clicks in common", where="second")
    return pairs


def _curve(made: DamperMap, clicks: dict[str, float]) -> DamperSetting | CurveAt:
    """Return a measured curve if there is one, else one between measured ones."""
    for item in made.settings:
        if all(item.settings[name] == value for name, value in clicks.items()):
            return item
    return made.at(clicks)


def _compared(
    clicks: dict[str, float], velocity: float, first: Estimate, second: Estimate, share: float, extra: float
) -> ComparedForce:  # fmt: skip
    difference = _difference([first, second])
    band = share * 0.5 * (abs(first.value) + abs(second.value)) + extra
    verdict: Verdict = "cannot be told"
    if difference.interval is not None:
        low, high = difference.interval
        if -band <= low and high <= band:
            verdict = "within"
        elif low > band or high < -band:
            verdict = "outside"
    return ComparedForce(clicks, velocity, first.value, second.value, difference, band, verdict)


def _difference(pair: Sequence[Estimate]) -> Estimate:
    """Return second minus first, as independent estimates."""
    first, second = pair
    value = second.value - first.value
    if first.interval is None or second.interval is None:
        return Estimate(value)
    halves = [0.5 * (item.interval[1] - item.interval[0]) for item in pair if item.interval]
    half = math.hypot(*halves)
    return Estimate(value, half / LEVEL, (value - half, value + half))


def _mean(made: DamperMap, name: str) -> Estimate:
    """Return the mean of a quantity over the settings that tell it."""
    known = [getattr(item, name) for item in made.settings]
    known = [item for item in known if not math.isnan(item.value)]
    if not known:
        return Estimate(math.nan)
    value = float(np.mean([item.value for item in known]))
    if any(item.interval is None for item in known):
        return Estimate(value)
    half = math.hypot(*(0.5 * (i.interval[1] - i.interval[0]) for i in known)) / len(known)
    return Estimate(value, half / LEVEL, (value - half, value + half))
