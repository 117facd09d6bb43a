"""Inspection limits as data: bands of methods, conditions and differences."""

from __future__ import annotations

import hashlib
import json
import math
from pathlib import Path
from typing import Any, Literal, Self

from pydantic import Field, model_validator

from jounce.core.description import Description, read_description
from jounce.core.errors import DescriptionError, nearest, show_value
from jounce.core.misplaced import error_at, misplaced_value
from jounce.core.phrases import Phrase
from jounce.core.units import Number, to_si
from jounce.inspection.methods import METHODS, QUANTITIES
from jounce.inspection.quantities import Language, WheelQuantity
from jounce.inspection.shipped import SHIPPED, shipped_limits

SCHEMA = "jounce.limits/1"
Verdict = Literal["pass", "advise", "fail"]
Colour = Literal["green", "yellow", "orange", "red"]
VERDICTS: tuple[Verdict, ...] = ("pass", "advise", "fail")
"""Colours from good to bad."""


class VerdictBand(Description):
    """One class of a quantity, half-open.

    Attributes
    ----------
    start, end : float
        ``from`` and ``to`` in the file, in the unit of the quantity; without them the band is unbounded.
    end_included : bool
        ``to_included``: the end belongs to this band and not to the next one.
    label, label_de : str
        Class name, in English and German.
    colour : {"green", "yellow", "orange", "red"}
        Colour in reports.
    verdict : {"pass", "advise", "fail"}
        Verdict for values in this band.
    note : str
        Keyword included in results, e.g. ``over_range``.
    """

    start: Number = Field(default=-math.inf, alias="from")
    end: Number = Field(default=math.inf, alias="to")
    end_included: bool = Field(default=False, alias="to_included")
    label: str = Field(min_length=1)
    label_de: str = ""
    colour: Colour
    verdict: Verdict
    note: str = ""

    def words(self, language: Language = "en") -> str:
        """Return the label in a language, or in English if no translation exists."""
        return self.label_de if language == "de" and self.label_de else self.label


class Criterion(Description):
    """Bands of one quantity.

    Attributes
    ----------
    quantity : str
        Key of the value in results, e.g. ``"theta_road"``.
    bands : tuple of VerdictBand
        Bands in ascending order, without gaps or overlaps.
    source, source_de : str
        Source of the limits, in English and German.
    date : str
        Date of the source.
    verified : bool
        Whether the limits affect verdicts. Classes by unverified limits are for information only.
    """

    quantity: str
    bands: tuple[VerdictBand, ...] = Field(min_length=1)
    source: str = Field(min_length=1)
    source_de: str = ""
    date: str = ""
    verified: bool = True

    def citation(self, language: Language = "en") -> str:
        """Return the source in a language, or in English if no translation exists."""
        return self.source_de if language == "de" and self.source_de else self.source

    @property
    def kind(self) -> WheelQuantity:
        """Unit and name of the quantity."""
        return QUANTITIES[self.quantity]

    @classmethod
    def _unit(cls, table: dict[str, Any]) -> str:
        return QUANTITIES[table["quantity"]].si

    @model_validator(mode="before")
    @classmethod
    def _read_units(cls, table: Any) -> Any:
        if not isinstance(table, dict) or not isinstance(table.get("quantity"), str):
            return table
        name = table["quantity"]
        if name not in QUANTITIES:
            hint = nearest(name, QUANTITIES)
            what = Phrase("unknown {kind} {name}", kind="quantity", name=show_value(name))
            raise error_at(("quantity",), what, allowed=", ".join(QUANTITIES), hint=hint)
        if not isinstance(table.get("bands"), (list, tuple)):
            return table
        unit = cls._unit(table)
        return {**table, "bands": [_in_si(band, i, unit) for i, band in enumerate(table["bands"])]}

    @model_validator(mode="after")
    def _without_gaps(self) -> Self:
        for i, band in enumerate(self.bands):
            if not band.start < band.end:
                raise error_at(
                    ("bands", i),
                    Phrase(
                        "empty: from {limit_text} to {second_limit_text}",
                        limit_text=self._limit_text(band.start),
                        second_limit_text=self._limit_text(band.end),
                    ),
                )
        for i, (low, high) in enumerate(zip(self.bands[:-1], self.bands[1:], strict=True), 1):
            if math.isclose(low.end, high.start, rel_tol=1e-9):
                continue
            what, ends = (
                ("a gap", (low.end, high.start))
                if low.end < high.start
                else ("an overlap", (high.start, low.end))
            )
            names = f"{low.label!r} and {high.label!r}"
            text = Phrase(
                "{what} from {limit_text} to {second_limit_text}, between {names}",
                what=what,
                limit_text=self._limit_text(ends[0]),
                second_limit_text=self._limit_text(ends[1]),
                names=names,
            )
            raise error_at(
                ("bands", i),
                Phrase("{text}; each band must begin where the previous one ends", text=text),
            )
        return self

    def _limit_text(self, value: float) -> str:
        return self.kind.limit_text(value) if math.isfinite(value) else "no limit"

    def band_of(self, value: float) -> VerdictBand | None:
        """Return the band of a value in the quantity's unit; None if no band contains it.

        Examples
        --------
        >>> theta = load_limits().methods["theta"]
        >>> [theta.band_of(value).label for value in (0.0999, 0.1, 0.13, 0.3)]
        ['red', 'yellow', 'green', 'green']
        >>> theta.band_of(0.3001).note
        'over_range'
        """
        ends = [band.start for band in self.bands[1:]] + [self.bands[-1].end]
        for band, end in zip(self.bands, ends, strict=True):
            if band.start <= value < end or (band.end_included and value in (band.end, end)):
                return band
        return None

    def edges(self) -> tuple[float, ...]:
        """Limits between bands, ascending."""
        return tuple(band.end for band in self.bands[:-1])

    def passing_from(self) -> float | None:
        """Return the lowest passing limit if higher values are better; None if there is none."""
        for low, high in zip(self.bands[:-1], self.bands[1:], strict=True):
            if low.verdict != "pass" and high.verdict == "pass":
                return high.start
        return None

    def failing_below(self) -> float | None:
        """Return the limit below which a value fails if higher values are better; None if there is none."""
        starts = [band.start for band in self.bands]
        fails = [band.end for band in self.bands if band.verdict == "fail"]
        least = self.passing_from()
        below = [end for end in fails if least is not None and end <= least and end in starts]
        return below[-1] if below else None


def _in_si(band: Any, i: int, unit: str) -> Any:
    if not isinstance(band, dict):
        return band
    converted = dict(band)
    for key in ("from", "to"):
        if key in converted:
            try:
                converted[key] = to_si(converted[key], unit)
            except DescriptionError as error:
                raise misplaced_value(("bands", i, key), error) from None
    return converted


class Condition(Criterion):
    """Bands of a condition that ``methods`` require."""

    methods: tuple[str, ...] = Field(min_length=1)


_SHARE = WheelQuantity("difference", "1", "%", 100.0, 1, "difference", "Unterschied")


class DifferenceCriterion(Condition):
    """Bands of a difference between two wheels.

    Attributes
    ----------
    across : {"wheels", "axles"}
        Left and right of an axle, or front and rear of a side.
    definition : {"relative", "absolute"}
        100 |a - b| / max(a, b), or |a - b| in the unit of the quantity.
    """

    across: Literal["wheels", "axles"] = "wheels"
    definition: Literal["relative", "absolute"] = "relative"

    @property
    def kind(self) -> WheelQuantity:
        """Unit of the difference and name of the quantity."""
        return _SHARE if self.definition == "relative" else QUANTITIES[self.quantity]

    @classmethod
    def _unit(cls, table: dict[str, Any]) -> str:
        return (
            "1"
            if table.get("definition", "relative") == "relative"
            else QUANTITIES[table["quantity"]].si
        )


class Limits(Description):
    """All limits of a lane.

    Attributes
    ----------
    name, version, date, source : str
        Identification in results and reports.
    methods : dict
        Criterion by method: ``eusama``, ``egea``, ``theta``, ``boge``.
    conditions : dict
        Criteria of required conditions, by name.
    differences : dict
        Criteria of differences, by name.
    """

    schema_: Literal["jounce.limits/1"] = Field(default="jounce.limits/1", alias="schema")
    name: str = ""
    version: str = Field(min_length=1)
    date: str = Field(min_length=1)
    source: str = Field(min_length=1)
    methods: dict[str, Criterion] = Field(min_length=1)
    conditions: dict[str, Condition] = {}
    differences: dict[str, DifferenceCriterion] = {}

    @model_validator(mode="after")
    def _methods_are_known(self) -> Self:
        for name in self.methods:
            if name not in METHODS:
                hint = nearest(name, METHODS)
                raise error_at(
                    ("methods", name), "unknown method", allowed=", ".join(METHODS), hint=hint
                )
        for group in ("conditions", "differences"):
            for name, criterion in getattr(self, group).items():
                for i, method in enumerate(criterion.methods):
                    if method not in self.methods:
                        what = Phrase(
                            "no limits of a method {name} in this file", name=show_value(method)
                        )
                        raise error_at(
                            (group, name, "methods", i), what, allowed=", ".join(self.methods)
                        )
        return self

    @property
    def digest(self) -> str:
        """Eight-character digest that changes with any number or word in the limits."""
        table = self.model_dump(mode="python", by_alias=True)
        return hashlib.sha256(json.dumps(table, sort_keys=True).encode()).hexdigest()[:8]

    @property
    def label(self) -> str:
        """Name, version and digest, e.g. ``jounce 1 (0a1b2c3d)``; as included in results and stores."""
        return f"{self.name} {self.version} ({self.digest})".strip()


def load_limits(name: str | Path | None = None) -> Limits:
    """Load limits from a TOML file, or the shipped ones.

    Parameters
    ----------
    name : str or Path, optional
        Path to a file; by default, or for ``"jounce"``, the shipped limits.

    Returns
    -------
    Limits
        Frozen limits; values in the units of their quantities (SI, degrees for angles).

    Raises
    ------
    DescriptionError
        With file, line and path: if the file is missing, or has gaps, overlaps, wrong units or unknown names.

    Examples
    --------
    >>> limits = load_limits()
    >>> limits.version, sorted(limits.methods)
    ('1', ['boge', 'egea', 'eusama', 'theta'])
    >>> [limits.methods["eusama"].band_of(share).label for share in (0.0, 0.2, 0.399, 0.6, 1.0)]
    ['bad', 'insufficient', 'insufficient', 'good', 'good']
    """
    path = (
        shipped_limits()
        if name is None or (str(name) == SHIPPED and not Path(name).exists())
        else Path(name)
    )
    limits, _ = read_description(Limits, path, SCHEMA)
    return limits if limits.name else limits.model_copy(update={"name": path.stem})
