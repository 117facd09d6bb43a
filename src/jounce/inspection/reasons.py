"""Reasons of a grading as data, written as sentences in English and German."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from jounce.inspection.findings import sentence_of
from jounce.inspection.limits import Criterion, VerdictBand
from jounce.inspection.methods import METHODS, QUANTITIES, method_names
from jounce.inspection.quantities import Language, Sentence
from jounce.inspection.result import NOT_GRADED

VERDICT_WORDS = {
    "pass": Sentence("pass", "bestanden"),
    "advise": Sentence("advise", "Hinweis"),
    "fail": Sentence("fail", "nicht bestanden"),
    NOT_GRADED: Sentence("not graded", "nicht bewertet"),
}
_SENTENCES = {
    "band": Sentence(
        "{quantity} {value} is {label} ({range}): {verdict}.{limits}",
        "{quantity} {value}: {label} ({range}), {verdict}.{limits}",
    ),
    "condition": Sentence(
        "{quantity} {value} is {label} ({range}): {verdict}.{limits}",
        "{quantity} {value}: {label} ({range}), {verdict}.{limits}",
    ),
    "difference": Sentence(
        "difference {across} of {quantity} {value}, {definition}, is {label} ({range}): {verdict}.{limits}",
        "Unterschied {across}, {quantity}: {value}, {definition}, {label} ({range}), {verdict}.{limits}",
    ),
    "may_be": Sentence(
        "difference {across} of {quantity} {value}, {definition}, may be {label} within its uncertainty ({range}): "
        "{verdict}.{limits}",
        "Unterschied {across}, {quantity}: {value}, {definition}, kann im Rahmen der Unsicherheit {label} sein "
        "({range}), {verdict}.{limits}",
    ),
    "counts": Sentence(
        "the deciding methods have no verified limits; a failure by {methods} still counts.",
        "Was entscheidet, hat keine belegten Grenzwerte; dass das Rad nach {methods} nicht besteht, zählt trotzdem.",
    ),
    "over_range": Sentence(
        "{quantity} {value} is above the optimal band, which ends at {limit}; the source says nothing about such "
        "values.",
        "{quantity} {value} liegt über dem Bestbereich, der bei {limit} endet; die Quelle sagt darüber nichts.",
    ),
    "near": Sentence(
        "the 95 % interval of {quantity}, {low} to {high}, includes the limit of {limit}: the class is uncertain.",
        "Das 95-%-Intervall, {quantity} {low} bis {high}, schließt den Grenzwert {limit} ein: Die Einstufung ist "
        "unsicher.",
    ),
    "unreliable": Sentence(
        "{quantity} is unreliable after lift-off: the class is uncertain.",
        "{quantity}: nach dem Abheben unzuverlässig, die Einstufung ist unsicher.",
    ),
    "unreliable_difference": Sentence(
        "difference {across} of {quantity} is not graded: the value is unreliable where the tyre leaves the plate "
        "({places}).",
        "Unterschied {across}, {quantity}: nicht bewertet; wo der Reifen abhebt, ist der Wert unzuverlässig "
        "({places}).",
    ),
    "unverified": Sentence(
        "{quantity} {value} would be {label} ({range}), but the limits of {method} are unverified and decide nothing. "
        "Use the manufacturer's limits.{limits}",
        "{quantity} {value} wäre {label} ({range}), aber die Grenzwerte für {method} sind nicht belegt: Das "
        "entscheidet nichts. Grenzwerte des Herstellers angeben.{limits}",
    ),
    "missing": Sentence(
        "{quantity} is not known: no grade by {method}.",
        "{quantity} ist nicht bekannt: keine Bewertung nach {method}.",
    ),
    "outside": Sentence(
        "{quantity} {value} is in no band: no grade by {method}.{limits}",
        "{quantity} {value} liegt in keiner Klasse: keine Bewertung nach {method}.{limits}",
    ),
    "unlimited": Sentence(
        "there are no limits for {method}: no grade by it.",
        "Es gibt keine Grenzwerte für {method}: keine Bewertung danach.",
    ),
    "deciding": Sentence(
        "{methods} decides; other grades are for information.",
        "{methods} entscheidet; weitere Einstufungen dienen der Information.",
    ),
    "disagree": Sentence(
        "the methods disagree: {grades}.", "Die Verfahren widersprechen sich: {grades}."
    ),
    "mass": Sentence(
        "adhesion depends on the load: the force varies by {force} N about {load} N; with the same damper a wheel "
        "that carries {needed} N would reach the limit of {limit}. Phase angle and damping ratio hardly depend on the "
        "load.",
        "Die Bodenhaftung hängt von der Last ab: Die Kraft schwankt um {force} N bei {load} N; mit demselben Dämpfer "
        "läge ein Rad mit {needed} N am Grenzwert {limit}. Phasenwinkel und Dämpfungsgrad hängen kaum davon ab.",
    ),
    "lifted": Sentence(
        "the tyre leaves the plate: light wheels and stiff tyres do so even with sound dampers.",
        "Der Reifen hebt von der Platte ab: Das tun leichte Räder und steife Reifen auch mit guten Dämpfern.",
    ),
    "tyre": Sentence(
        "adhesion depends on the tyre: with a tyre of {usual} N/mm instead of {stiffness} N/mm it would be "
        "{adhesion}, and the least phase angle {phase} (linear model of this record).",
        "Die Bodenhaftung hängt vom Reifen ab: Mit {usual} N/mm statt {stiffness} N/mm wäre sie {adhesion}, der "
        "kleinste Phasenwinkel {phase} (lineares Modell dieser Messung).",
    ),
    "rigidity": Sentence(
        "adhesion falls as the tyre becomes stiffer (here {rigidity} N/mm); the other values fall less.",
        "Die Bodenhaftung sinkt mit der Reifensteifigkeit (hier {rigidity} N/mm), andere Werte weniger.",
    ),
    "limits_differ": Sentence(
        "the limits of EGEA and THETA do not correspond to the same damping: on a car of usual size a phase angle "
        "of 35° is a damping ratio of about 0.10, and a fast sweep or a soft tyre shifts it.",
        "Die Grenzwerte von EGEA und THETA meinen nicht dieselbe Dämpfung: Bei einem üblichen Wagen entsprechen 35° "
        "einem Dämpfungsgrad von etwa 0,10; ein schneller Auslauf oder ein weicher Reifen verschieben das.",
    ),
    "one_wheel": Sentence(
        "the {missing} wheel was not tested: the verdict holds for the other wheel alone.",
        "Das Rad {missing} wurde nicht geprüft: Das Urteil gilt nur für das andere Rad.",
    ),
    "wheel": Sentence("{wheel} wheel: {verdict}.", "Rad {wheel}: {verdict}."),
    "axle": Sentence("{axle} axle: {verdict}.", "{axle}: {verdict}."),
    "no_difference": Sentence(
        "the difference of {quantity} is not known.",
        "Der Unterschied ist nicht bekannt: {quantity}.",
    ),
    "finding": Sentence("{finding}", "{finding}"),
}
SIDES = {"left": Sentence("left", "links"), "right": Sentence("right", "rechts")}
AXLES = {
    "front": Sentence("front", "Vorderachse"),
    "rear": Sentence("rear", "Hinterachse"),
    "": Sentence("only", "Achse"),
}
_ACROSS = {
    "wheels": Sentence("left to right", "links zu rechts"),
    "axles": Sentence("front to rear", "vorn zu hinten"),
}
_DEFINITIONS = {
    "relative": Sentence("relative to the greater value", "bezogen auf den größeren Wert"),
    "absolute": Sentence("absolute", "absolut"),
}


@dataclass(frozen=True)
class Reason:
    """One reason of a verdict."""

    kind: str  # kind of reason, e.g. ``"band"``, ``"near"``, ``"disagree"``
    verdict: str = ""  # verdict that it implies by itself; empty if it only explains
    # supporting numbers in SI (angles in degrees), names and bands
    values: Mapping[str, Any] = field(default_factory=dict)

    def text(self, language: Language = "en", *, with_source: bool = True) -> str:
        """Format the reason as one sentence, with or without the source of the limits.

        Examples
        --------
        >>> Reason("unlimited", values={"method": "boge"}).text("de")
        'Es gibt keine Grenzwerte für BOGE: keine Bewertung danach.'
        """
        words = {name: _word(name, value, language) for name, value in self.values.items()}
        criterion = self.values.get("criterion")
        if isinstance(criterion, Criterion):
            words |= _criterion_words(criterion, self.values, language)
            before = "Grenzwerte" if language == "de" else "Limits"
            words["limits"] = f" {before}: {criterion.citation(language)}." if with_source else ""
        sentence = _SENTENCES[self.kind].in_language(language).format(**words)
        return sentence[0].upper() + sentence[1:] if language == "de" else sentence


def _word(name: str, value: Any, language: Language) -> str:
    if name in _WRITTEN:
        return _WRITTEN[name](value, language)
    tables = {
        "wheel": SIDES,
        "missing": SIDES,
        "axle": AXLES,
        "across": _ACROSS,
        "definition": _DEFINITIONS,
    }
    if name in tables:
        return tables[name][value].in_language(language) if value in tables[name] else str(value)
    return f"{value:.0f}" if isinstance(value, float) else str(value)


def _methods(value: Any, _: Language) -> str:
    return method_names((value,) if isinstance(value, str) else tuple(value))


def _grades(value: Any, language: Language) -> str:
    shown = (
        f"{METHODS[m].name} {band.words(language)} ({verdict_words(band.verdict, language)})"
        for m, band in value
    )
    return "; ".join(shown)


def _criterion_words(
    criterion: Criterion, values: Mapping[str, Any], language: Language
) -> dict[str, str]:
    kind = criterion.kind
    words = {"quantity": QUANTITIES[criterion.quantity].words(language)}
    for name in ("low", "high"):
        if name in values:
            words[name] = kind.text(values[name], language, apart_from=[values["limit"]])
    if "limit" in values:
        words["limit"] = kind.limit_text(values["limit"], language)
    if "value" in values:
        words["value"] = with_uncertainty(criterion, values["value"], values.get("half"), language)
    band = values.get("band")
    if isinstance(band, VerdictBand):
        words |= {"label": band.words(language), "range": range_words(criterion, band, language)}
    return words


def with_uncertainty(
    criterion: Criterion, value: float, half: float | None, language: Language = "en"
) -> str:
    """Format a value with the half width of its 95 % interval, ``34.1 % ± 0.8 %``; both in the criterion's unit."""
    kind = criterion.kind
    text = kind.text(value, language, apart_from=criterion.edges())
    return text if half is None else f"{text} ± {kind.rounded_up(half, language)}"


def range_words(criterion: Criterion, band: VerdictBand, language: Language = "en") -> str:
    """Describe the range of a band: ``from 20 % to below 40 %``."""
    kind, place = criterion.kind, 0 if language == "en" else 1
    parts = []
    if band.start > float("-inf"):
        before = next(
            (lower for lower in criterion.bands if lower.end_included and lower.end == band.start),
            None,
        )
        first = ("above", "über") if before is not None else ("from", "ab")
        parts.append(f"{first[place]} {kind.limit_text(band.start, language)}")
    if band.end < float("inf"):
        last = ("up to", "bis einschließlich") if band.end_included else ("below", "unter")
        parts.append(f"{last[place]} {kind.limit_text(band.end, language)}")
    return ", ".join(parts) or ("any value", "jeder Wert")[place]


def verdict_words(verdict: str, language: Language = "en") -> str:
    """Translate ``pass``, ``advise``, ``fail`` or ``not graded``; other text is returned unchanged."""
    return VERDICT_WORDS[verdict].in_language(language) if verdict in VERDICT_WORDS else verdict


def _places(value: Any, language: Language) -> str:
    return ", ".join((SIDES | AXLES)[place].in_language(language) for place in value)


_WRITTEN: Mapping[str, Callable[[Any, Language], str]] = {
    "method": _methods,
    "methods": _methods,
    "grades": _grades,
    "places": _places,
    "finding": sentence_of,
    "verdict": verdict_words,
    "quantity": lambda value, language: QUANTITIES[value].words(language),
    "adhesion": QUANTITIES["adhesion"].text,
    "phase": QUANTITIES["phase_angle_min_deg"].text,
}
"""Formatters for names and values that are neither in a table nor plain numbers."""
