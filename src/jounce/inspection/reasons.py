"""Reasons of a grading as data that can be said in English and German."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from jounce.inspection.findings import said
from jounce.inspection.limits import Band, Criterion
from jounce.inspection.quantities import QUANTITIES, Language
from jounce.inspection.result import NOT_GRADED

METHOD_NAMES = {"eusama": "EUSAMA", "egea": "EGEA", "theta": "THETA", "boge": "BOGE"}
VERDICT_WORDS: dict[str, dict[Language, str]] = {
    "pass": {"en": "pass", "de": "bestanden"},
    "advise": {"en": "advise", "de": "Hinweis"},
    "fail": {"en": "fail", "de": "nicht bestanden"},
    NOT_GRADED: {"en": "not graded", "de": "nicht bewertet"},
}
_SENTENCES: dict[str, dict[Language, str]] = {
    "band": {
        "en": "{quantity} {value} is {label} ({range}): {verdict}.{limits}",
        "de": "{quantity} {value}: {label} ({range}), {verdict}.{limits}",
    },
    "condition": {
        "en": "{quantity} {value} is {label} ({range}): {verdict}.{limits}",
        "de": "{quantity} {value}: {label} ({range}), {verdict}.{limits}",
    },
    "difference": {
        "en": ("difference {across} of {quantity} {value}, {definition}, is {label} ({range}): {verdict}.{limits}"),
        "de": ("Unterschied {across}, {quantity}: {value}, {definition}, {label} ({range}), {verdict}.{limits}"),
    },
    "over_range": {
        "en": "{quantity} {value} is above the optimal band, which ends at {limit}; the source says nothing about it.",
        "de": "{quantity} {value} liegt über dem Bestbereich, der bei {limit} endet; die Quelle sagt darüber nichts.",
    },
    "near": {
        "en": (
            "the 95 % interval of {quantity}, {low} to {high}, reaches over the limit of {limit}: "
            "the class is uncertain."
        ),
        "de": (
            "Das 95-%-Intervall, {quantity} {low} bis {high}, reicht über den Grenzwert {limit}: "
            "Die Einstufung ist unsicher."
        ),
    },
    "unverified": {
        "en": (
            "{quantity} {value} would be {label} ({range}), but nobody has verified the limits of {method}: it decides "
            "nothing. Give the maker's limits.{limits}"
        ),
        "de": (
            "{quantity} {value} wäre {label} ({range}), aber die Grenzwerte für {method} sind nicht belegt: Das "
            "entscheidet nichts. Grenzwerte des Herstellers angeben.{limits}"
        ),
    },
    "missing": {
        "en": "{quantity} is not known: no grade by {method}.",
        "de": "{quantity} ist nicht bekannt: keine Bewertung nach {method}.",
    },
    "outside": {
        "en": "{quantity} {value} lies in no band: no grade by {method}.{limits}",
        "de": "{quantity} {value} liegt in keiner Klasse: keine Bewertung nach {method}.{limits}",
    },
    "unlimited": {
        "en": "the limits say nothing about {method}: no grade by it.",
        "de": "Die Grenzwerte sagen nichts über {method}: keine Bewertung danach.",
    },
    "deciding": {
        "en": "{methods} decides; other grades are for information.",
        "de": "{methods} entscheidet; weitere Einstufungen dienen der Information.",
    },
    "disagree": {"en": "the methods disagree: {grades}.", "de": "Die Verfahren widersprechen sich: {grades}."},
    "mass": {
        "en": (
            "adhesion depends on the load: the force varies by {force} N about {load} N; with the same damper a "
            "wheel that carries {needed} N would reach the limit of {limit}. Phase angle and damping ratio hardly "
            "depend on the load."
        ),
        "de": (
            "Die Bodenhaftung hängt von der Last ab: Die Kraft schwankt um {force} N bei {load} N; mit demselben "
            "Dämpfer läge ein Rad mit {needed} N am Grenzwert {limit}. Phasenwinkel und Dämpfungsgrad hängen kaum "
            "davon ab."
        ),
    },
    "lifted": {
        "en": "the tyre leaves the plate: light wheels and stiff tyres do so with sound dampers, too.",
        "de": "Der Reifen hebt von der Platte ab: Das tun leichte Räder und steife Reifen auch mit guten Dämpfern.",
    },
    "tyre": {
        "en": (
            "adhesion depends on the tyre: with a tyre of {usual} N/mm instead of {stiffness} N/mm it would be "
            "{adhesion}, the least phase angle {phase} (linear model of this record)."
        ),
        "de": (
            "Die Bodenhaftung hängt vom Reifen ab: Mit {usual} N/mm statt {stiffness} N/mm wäre sie {adhesion}, "
            "der kleinste Phasenwinkel {phase} (lineares Modell dieser Messung)."
        ),
    },
    "rigidity": {
        "en": "adhesion falls with the tyre's rigidity (here {rigidity} N/mm); the other values fall less.",
        "de": "Die Bodenhaftung sinkt mit der Reifensteifigkeit (hier {rigidity} N/mm), andere Werte weniger.",
    },
    "limits_differ": {
        "en": (
            "the limits of EGEA and THETA are not the same damping: on a car of usual size a phase angle of 35° is a "
            "damping ratio of about 0.10, and a fast sweep or a soft tyre shifts it."
        ),
        "de": (
            "Die Grenzwerte von EGEA und THETA meinen nicht dieselbe Dämpfung: Bei einem üblichen Wagen sind 35° ein "
            "Dämpfungsgrad von etwa 0,10; schneller Durchlauf oder weicher Reifen verschieben das."
        ),
    },
    "one_wheel": {
        "en": "the {missing} wheel was not tested: the verdict is of the other wheel alone.",
        "de": "Das Rad {missing} wurde nicht geprüft: Das Urteil gilt nur für das andere Rad.",
    },
    "wheel_unfit": {
        "en": "the {wheel} wheel is not graded.",
        "de": "Das Rad {wheel} ist nicht bewertet.",
    },
    "wheel": {"en": "{wheel} wheel: {verdict}.", "de": "Rad {wheel}: {verdict}."},
    "axle": {"en": "{axle} axle: {verdict}.", "de": "{axle}: {verdict}."},
    "no_difference": {
        "en": "the difference of {quantity} is not known.",
        "de": "Der Unterschied ist nicht bekannt: {quantity}.",
    },
    "finding": {"en": "{finding}", "de": "{finding}"},
}
SIDES: dict[str, dict[Language, str]] = {
    "left": {"en": "left", "de": "links"},
    "right": {"en": "right", "de": "rechts"},
}
AXLES: dict[str, dict[Language, str]] = {
    "front": {"en": "front", "de": "Vorderachse"},
    "rear": {"en": "rear", "de": "Hinterachse"},
    "": {"en": "only", "de": "Achse"},
}
_ACROSS: dict[str, dict[Language, str]] = {
    "wheels": {"en": "left to right", "de": "links zu rechts"},
    "axles": {"en": "front to rear", "de": "vorn zu hinten"},
}
_DEFINITIONS: dict[str, dict[Language, str]] = {
    "relative": {"en": "relative to the greater", "de": "bezogen auf den größeren Wert"},
    "absolute": {"en": "absolute", "de": "absolut"},
}


@dataclass(frozen=True)
class Reason:
    """One reason of a verdict.

    Attributes
    ----------
    kind : str
        What it says, e.g. ``"band"``, ``"near"``, ``"disagree"``.
    verdict : str
        What it asks for by itself; empty where it only explains.
    values : mapping
        Numbers in SI (angles in degrees), names and bands behind it.
    """

    kind: str
    verdict: str = ""
    values: Mapping[str, Any] = field(default_factory=dict)

    def text(self, language: Language = "en", *, with_source: bool = True) -> str:
        """Say it as one sentence, with the source of the limits or without.

        Examples
        --------
        >>> Reason("unlimited", values={"method": "boge"}).text("de")
        'Die Grenzwerte sagen nichts über BOGE: keine Bewertung danach.'
        """
        words = {name: _word(name, value, language) for name, value in self.values.items()}
        criterion = self.values.get("criterion")
        if isinstance(criterion, Criterion):
            words |= _criterion_words(criterion, self.values, language)
            before = "Grenzwerte" if language == "de" else "Limits"
            words["limits"] = f" {before}: {criterion.cited(language)}." if with_source else ""
        sentence = _SENTENCES[self.kind][language].format(**words)
        return sentence[0].upper() + sentence[1:] if language == "de" else sentence


def _word(name: str, value: Any, language: Language) -> str:
    if name in _WRITTEN:
        return _WRITTEN[name](value, language)
    tables = {"wheel": SIDES, "missing": SIDES, "axle": AXLES, "across": _ACROSS, "definition": _DEFINITIONS}
    if name in tables:
        return tables[name].get(value, {}).get(language, str(value))
    return f"{value:.0f}" if isinstance(value, float) else str(value)


def _methods(value: Any, _: Language) -> str:
    return ", ".join(METHOD_NAMES.get(one, one) for one in ([value] if isinstance(value, str) else value))


def _grades(value: Any, language: Language) -> str:
    shown = (f"{METHOD_NAMES[m]} {band.words(language)} ({verdict_words(band.verdict, language)})" for m, band in value)
    return "; ".join(shown)


def _criterion_words(criterion: Criterion, values: Mapping[str, Any], language: Language) -> dict[str, str]:
    kind = criterion.kind
    found = {"quantity": QUANTITIES[criterion.quantity].words(language)}
    for name in ("low", "high"):
        if name in values:
            found[name] = kind.text(values[name], language, apart_from=[values["limit"]])
    if "limit" in values:
        found["limit"] = kind.limit_text(values["limit"], language)
    if "value" in values:
        found["value"] = with_uncertainty(criterion, values["value"], values.get("half"), language)
    band = values.get("band")
    if isinstance(band, Band):
        found |= {"label": band.words(language), "range": range_words(criterion, band, language)}
    return found


def with_uncertainty(criterion: Criterion, value: float, half: float | None, language: Language = "en") -> str:
    """Write a value with the half width of its 95 % interval, ``34.1 % ± 0.8 %``; both in the criterion's unit."""
    kind = criterion.kind
    text = kind.text(value, language, apart_from=criterion.edges())
    return text if half is None else f"{text} ± {kind.rounded_up(half, language)}"


def range_words(criterion: Criterion, band: Band, language: Language = "en") -> str:
    """Say where a band lies: ``from 20 % to below 40 %``."""
    kind, english = criterion.kind, language == "en"
    parts = []
    if band.start > float("-inf"):
        before = next((one for one in criterion.bands if one.end_included and one.end == band.start), None)
        first = ("above", "über") if before is not None else ("from", "ab")
        parts.append(f"{first[0 if english else 1]} {kind.limit_text(band.start, language)}")
    if band.end < float("inf"):
        last = ("up to", "bis einschließlich") if band.end_included else ("below", "unter")
        parts.append(f"{last[0 if english else 1]} {kind.limit_text(band.end, language)}")
    return ", ".join(parts) if parts else ("any value" if english else "jeder Wert")


def verdict_words(verdict: str, language: Language = "en") -> str:
    """Say ``pass``, ``advise``, ``fail`` or ``not graded`` in a language; another text is given as it is."""
    return VERDICT_WORDS.get(verdict, {}).get(language, verdict)


_WRITTEN: Mapping[str, Callable[[Any, Language], str]] = {
    "method": _methods,
    "methods": _methods,
    "grades": _grades,
    "finding": said,
    "verdict": verdict_words,
    "quantity": lambda value, language: QUANTITIES[value].words(language),
    "adhesion": QUANTITIES["adhesion"].text,
    "phase": QUANTITIES["phase_angle_min_deg"].text,
}
"""How words and values are written that are neither in a table nor a plain number."""
