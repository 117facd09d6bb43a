"""What an evaluation finds, as data: a place, a code and its numbers, said in English and German."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from jounce.core.findings import Finding, Severity
from jounce.inspection.quantities import Language

SENTENCES: dict[str, dict[Language, str]] = {
    # the record as a whole
    "samples_missing": {
        "en": "{count} sample{plural} no number, the first at {time:.4g} s: the record has gaps; repeat the test.",
        "de": "{count} Messwerte fehlen, der erste bei {time:.4g} s: Die Messung hat Lücken; Prüfung wiederholen.",
    },
    "too_short": {
        "en": "the record is too short: {length:.3g} s, without a run-down.",
        "de": "Die Messung ist zu kurz: {length:.3g} s, ohne Auslauf.",
    },
    "clock": {"en": "{text}", "de": "Der Uhr der Messung ist nicht zu trauen (englisch): {text}"},
    "unknown_key": {
        "en": "the header's {key!r} is not known and was not used.{hint}",
        "de": "Die Angabe {key!r} im Kopf ist nicht bekannt und wurde nicht verwendet.",
    },
    "no_day": {
        "en": "the date {date!r} is no day, e.g. 2026-11-21: the record has no place in a vehicle's history.",
        "de": "Das Datum {date!r} ist kein Tag, z. B. 2026-11-21: Die Messung hat keinen Platz im Verlauf.",
    },
    "line_left_out": {
        "en": "the header line {line!r} was left out: it is not 'key = value' with text in quotes",
        "de": "Die Kopfzeile {line!r} wurde ausgelassen: Sie ist nicht 'name = wert' mit Text in Anführungszeichen.",
    },
    "other_tester": {
        "en": "the header names the tester {name!r}; the record is evaluated as one of {tester!r}.",
        "de": "Der Kopf nennt den Prüfstand {name!r}; ausgewertet wird die Messung als eine von {tester!r}.",
    },
    "other_kind": {
        "en": (
            "the header names the tester {name!r} ({kind}); the record cannot be evaluated as one of {tester!r} "
            "({own})."
        ),
        "de": (
            "Der Kopf nennt den Prüfstand {name!r} ({kind}); die Messung kann nicht als eine von {tester!r} ({own}) "
            "ausgewertet werden."
        ),
    },
    "not_rigid": {
        "en": (
            "the plate moves {low:.3g} to {high:.3g} mm, by its frequency: it stands on a spring; choose the tester "
            "that made this record."
        ),
        "de": (
            "Die Platte bewegt sich je nach Frequenz um {low:.3g} bis {high:.3g} mm: Sie ist gefedert; den Prüfstand "
            "dieser Messung wählen."
        ),
    },
    # what the reader of the file found; its sentence is the English one
    "reading_constant": {
        "en": "{text}",
        "de": "Der Kanal ist unverändert ({value:g}); war der Aufnehmer angeschlossen?",
    },
    "reading_clipped": {
        "en": "{text}",
        "de": "Der Kanal scheint abgeschnitten: {percent:.2g} % seiner Messwerte liegen an seinen Grenzen.",
    },
    "reading_resampled": {
        "en": "{text}",
        "de": "Die Zeitschritte schwanken um {percent:.2g} % (zulässig: 1 %); auf gleiche Schritte umgerechnet.",
    },
    "reading_columns": {"en": "{text}", "de": "Nicht alle Spalten der Datei wurden verwendet (englisch): {text}"},
    # plates and units
    "columns_swapped": {
        "en": (
            "the plate would move {stroke:.4g} mm and the force reach {force:.3g} N only: the columns of plate "
            "and force are swapped."
        ),
        "de": (
            "Die Platte bewegte sich um {stroke:.4g} mm, und die Kraft erreichte nur {force:.3g} N: Die Spalten von "
            "Platte und Kraft sind vertauscht."
        ),
    },
    "plate_still": {
        "en": "the plate never moves; was its sensor connected?",
        "de": "Die Platte bewegt sich nie; war ihr Wegaufnehmer angeschlossen?",
    },
    "plate_never_moves": {
        "en": "the plate never moves: no run-down.",
        "de": "Die Platte bewegt sich nie: kein Auslauf.",
    },
    "stroke_unit": {
        "en": "the plate moves {stroke:.4g} mm on an eccentric exciter of {expected:.4g} mm: check its unit.",
        "de": "Die Platte bewegt sich um {stroke:.4g} mm bei einem Exzenterhub von {expected:.4g} mm: Einheit prüfen.",
    },
    "height_unit": {
        "en": (
            "the plate moves {stroke:.4g} mm, the tester's stroke is {expected:.4g} mm: the heights seem to be in "
            "{unit}; correct the unit in the header."
        ),
        "de": (
            "Die Platte bewegt sich um {stroke:.4g} mm, der Hub des Prüfstands ist {expected:.4g} mm: Die Höhen "
            "scheinen in {unit} zu sein; Einheit im Kopf berichtigen."
        ),
    },
    "stroke_wrong": {
        "en": (
            "the plate moves {stroke:.4g} mm, the tester's stroke is {expected:.4g} mm: wrong unit, wrong tester, or "
            "a defect of the plate."
        ),
        "de": (
            "Die Platte bewegt sich um {stroke:.4g} mm, der Hub des Prüfstands ist {expected:.4g} mm: falsche Einheit, "
            "falscher Prüfstand oder Schaden an der Platte."
        ),
    },
    "stroke_off": {
        "en": (
            "the plate moves {stroke:.4g} mm, the tester's stroke is {expected:.4g} mm; allowed are {allowed:.2g} mm "
            "of difference."
        ),
        "de": (
            "Die Platte bewegt sich um {stroke:.4g} mm, der Hub des Prüfstands ist {expected:.4g} mm; zulässig sind "
            "{allowed:.2g} mm Unterschied."
        ),
    },
    "upside_down": {
        "en": "the plate's height has the wrong sign: upwards must be positive.",
        "de": "Die Höhe der Platte hat das falsche Vorzeichen: Aufwärts muss positiv sein.",
    },
    "no_frequency": {
        "en": "neither {height} nor {tacho} is in the record: its frequency is not known.",
        "de": "Weder {height} noch {tacho} ist in der Messung: Die Frequenz ist nicht bekannt.",
    },
    "height_missing": {
        "en": "a sprung plate is evaluated by its height, which is missing.",
        "de": "Eine gefederte Platte wird nach ihrer Höhe ausgewertet, und die fehlt.",
    },
    "other_together": {
        "en": (
            "the other plate runs for {time:.1f} s of this test, as the wheel order says; it shakes this wheel as well."
        ),
        "de": "Die andere Platte läuft {time:.1f} s dieser Prüfung lang, wie angegeben; sie erregt auch dieses Rad.",
    },
    "other_running": {
        "en": (
            "the other plate runs for {time:.1f} s of this test: it shakes this wheel as well; test one wheel after "
            "the other."
        ),
        "de": (
            "Die andere Platte läuft {time:.1f} s dieser Prüfung lang: Sie erregt auch dieses Rad; die Räder "
            "nacheinander prüfen."
        ),
    },
    # static loads and forces
    "no_wheel_load": {
        "en": "the plate carries {measured:.4g} N on average, which is no wheel load: check the unit of the force.",
        "de": "Die Platte trägt im Mittel {measured:.4g} N, das ist keine Radlast: Einheit der Kraft prüfen.",
    },
    "load_from_signal": {
        "en": "the header does not give the static load; {measured:.0f} N were taken from the force itself.",
        "de": "Der Kopf nennt keine statische Radlast; {measured:.0f} N wurden der Kraft selbst entnommen.",
    },
    "force_unit": {
        "en": (
            "the header gives {load:.0f} N, the plate carries {measured:.4g} N on average: the forces seem to be in "
            "{unit}; correct the unit in the header."
        ),
        "de": (
            "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: Die Kräfte scheinen in {unit} "
            "zu sein; Einheit im Kopf berichtigen."
        ),
    },
    "load_unit": {
        "en": (
            "the header gives {load:.0f} N, the plate carries {measured:.4g} N on average: the static load seems to "
            "be in another unit; correct the unit in the header."
        ),
        "de": (
            "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: Die statische Radlast scheint "
            "in einer anderen Einheit zu sein; Einheit im Kopf berichtigen."
        ),
    },
    "load_contradicts": {
        "en": (
            "the header gives {load:.0f} N, the plate carries {measured:.4g} N on average: the static weight "
            "contradicts the signal (wrong, or a force offset of {offset:+.0f} N)."
        ),
        "de": (
            "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: Die statische Radlast "
            "widerspricht dem Signal (falsch, oder ein Nullpunktfehler der Kraft von {offset:+.0f} N)."
        ),
    },
    "load_off": {
        "en": (
            "the header gives {load:.0f} N, the plate carries {measured:.4g} N on average: {percent:+.1f} %, allowed "
            "are 2 %."
        ),
        "de": (
            "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: {percent:+.1f} %, zulässig "
            "sind 2 %."
        ),
    },
    "load_out_of_range": {
        "en": "{load:.0f} N is outside the weights this tester is made for, {low:.0f} to {high:.0f} N.",
        "de": "{load:.0f} N liegen außerhalb der Radlasten dieses Prüfstands, {low:.0f} bis {high:.0f} N.",
    },
    "sides_swapped": {
        "en": (
            "the plates carry {left:.0f} N (left) and {right:.0f} N (right), the header says {left_load:.0f} N and "
            "{right_load:.0f} N: left and right are swapped."
        ),
        "de": (
            "Die Platten tragen {left:.0f} N (links) und {right:.0f} N (rechts), der Kopf nennt {left_load:.0f} N und "
            "{right_load:.0f} N: Links und rechts sind vertauscht."
        ),
    },
    "order_contradicts": {
        "en": (
            "the header gives the wheel order {order}, but the {first} plate runs first: left and right are swapped, "
            "or the order is wrong."
        ),
        "de": (
            "Der Kopf nennt die Reihenfolge {order}, aber zuerst läuft die Platte {first}: Links und rechts sind "
            "vertauscht, oder die Reihenfolge ist falsch."
        ),
    },
    "force_missing": {
        "en": "{found} is in the record, but {force} is not: check the names of the columns.",
        "de": "{found} ist in der Messung, aber {force} fehlt: Spaltennamen prüfen.",
    },
    "both_offset": {
        "en": "both forces are {offset:+.0f} N off the static loads: an offset of the force; tare the cells.",
        "de": "Beide Kräfte liegen um {offset:+.0f} N neben den statischen Radlasten: Kraftaufnehmer nullen.",
    },
    "other_vehicle": {
        "en": "the static load of {load:.0f} N is not that of the vehicle file, {expected:.0f} N.",
        "de": "Die statische Radlast {load:.0f} N ist nicht die der Fahrzeugdatei, {expected:.0f} N.",
    },
    "samples_too_few": {
        "en": "{rate:.4g} samples per second are too few; {wanted:.0f} are asked for.",
        "de": "{rate:.4g} Messwerte in der Sekunde sind zu wenig; verlangt sind {wanted:.0f}.",
    },
    "samples_few": {
        "en": "{rate:.4g} samples per second; {wanted:.0f} are asked for.",
        "de": "{rate:.4g} Messwerte in der Sekunde; verlangt sind {wanted:.0f}.",
    },
    "saturated": {
        "en": (
            "the force is clipped at {limit:.4g} N ({percent:.2g} % of the samples): saturated; widen the range of "
            "the force cell."
        ),
        "de": (
            "Die Kraft ist bei {limit:.4g} N abgeschnitten ({percent:.2g} % der Messwerte): übersteuert; "
            "Messbereich erweitern."
        ),
    },
    "clipped": {
        "en": "the force is clipped at {limit:.4g} N ({percent:.2g} % of the samples); amplitudes come out too small.",
        "de": "Die Kraft ist bei {limit:.4g} N abgeschnitten ({percent:.2g} % der Messwerte): zu kleine Amplituden.",
    },
    "dropout": {
        "en": (
            "the force stays at exactly {force:.4g} N for {time:.0f} ms, which a cell under a moving plate never "
            "shows: a dropout of the signal, or the force is that of the contact (force_cell)."
        ),
        "de": (
            "Die Kraft bleibt {time:.0f} ms lang genau bei {force:.4g} N, was ein Aufnehmer unter einer bewegten "
            "Platte nie zeigt: Signalausfall, oder es ist die Aufstandskraft selbst (force_cell)."
        ),
    },
    "slips": {
        "en": ("the mean force leaves the static load by {percent:+.0f} % during the test: the wheel slips or rolls."),
        "de": (
            "Die mittlere Kraft verlässt während der Prüfung die statische Radlast um {percent:+.0f} %: Das Rad "
            "rutscht oder rollt."
        ),
    },
    "vibrates": {
        "en": (
            "the force vibrates at {frequency:.1f} Hz by {force:.0f} N that this plate does not make: is the other "
            "plate or another machine running?"
        ),
        "de": (
            "Die Kraft schwingt bei {frequency:.1f} Hz um {force:.0f} N, die diese Platte nicht erzeugt: Läuft die "
            "andere Platte oder eine andere Maschine?"
        ),
    },
    # the course of the test
    "few_turns": {
        "en": "the plate makes fewer than {fewest} turns: no run-down.",
        "de": "Die Platte macht weniger als {fewest} Hübe: kein Auslauf.",
    },
    "never_high": {
        "en": ("the plate turns at {low:.3g} to {top:.3g} Hz: it never reaches {high:g} Hz, the run-down is missing."),
        "de": "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz: Sie erreicht {high:g} Hz nie, der Auslauf fehlt.",
    },
    "no_run_down": {
        "en": "the plate turns at {low:.3g} to {top:.3g} Hz: the run-down is missing.",
        "de": "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz: Der Auslauf fehlt.",
    },
    "run_down_cut": {
        "en": "the plate turns at {low:.3g} to {top:.3g} Hz: the record is too short: the run-down is cut off.",
        "de": "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz: Die Messung ist zu kurz, der Auslauf abgeschnitten.",
    },
    "run_up": {
        "en": "the plate turns at {low:.3g} to {top:.3g} Hz, but upwards: a run-up in place of the run-down.",
        "de": "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz, aber aufwärts: ein Hochlauf statt des Auslaufs.",
    },
    "several": {
        "en": "{count} run-downs in one record: cut them apart.",
        "de": "{count} Ausläufe in einer Messung: getrennt auswerten.",
    },
    "sweep_fast": {
        "en": (
            "the sweep is too fast: {rate:.2g} Hz/s, allowed are {most:g}; adhesion comes out too good and the phase "
            "angle is blurred."
        ),
        "de": (
            "Der Durchlauf ist zu schnell: {rate:.2g} Hz/s, zulässig sind {most:g}; die Bodenhaftung wird zu gut und "
            "der Phasenwinkel ungenau."
        ),
    },
    "run_down_short": {
        "en": "the run-down takes {length:.1f} s, at least {least:g} are asked for.",
        "de": "Der Auslauf dauert {length:.1f} s, mindestens {least:g} sind verlangt.",
    },
    # values
    "no_turn": {
        "en": "no turn of the plate could be evaluated.",
        "de": "Kein Hub der Platte konnte ausgewertet werden.",
    },
    "lift_off": {
        "en": "the tyre leaves the plate: adhesion counts as 0.",
        "de": "Der Reifen hebt von der Platte ab: Die Bodenhaftung zählt als 0.",
    },
    "lift_off_left_out": {
        "en": "the tyre leaves the plate; these parts do not count.",
        "de": "Der Reifen hebt von der Platte ab; diese Abschnitte zählen nicht.",
    },
    "no_height_no_phase": {
        "en": "without the plate's height the phase angle is not known.",
        "de": "Ohne die Höhe der Platte ist der Phasenwinkel nicht bekannt.",
    },
    "phase_not_covered": {
        "en": "the turns do not reach over {low:g} to {high:g} Hz: no least phase angle.",
        "de": "Die Hübe reichen nicht über {low:g} bis {high:g} Hz: kein kleinster Phasenwinkel.",
    },
    "phase_in_lift_off": {
        "en": ("the tyre leaves the plate where the phase angle is least: it is that of the fitted quarter car there."),
        "de": (
            "Der Reifen hebt dort ab, wo der Phasenwinkel am kleinsten ist: Er ist dort der des angepassten "
            "Viertelfahrzeugs."
        ),
    },
    "phase_below_zero": {
        "en": (
            "a phase angle below 0 belongs to no steady state: the wheel still swings from lift-off, or the sweep is "
            "fast for so little damping."
        ),
        "de": (
            "Ein Phasenwinkel unter 0 gehört zu keinem eingeschwungenen Zustand: Das Rad schwingt noch vom Abheben, "
            "oder der Durchlauf ist für so wenig Dämpfung schnell."
        ),
    },
    "phase_at_end": {
        "en": "the least phase angle lies at the end of the band, {frequency:.3g} Hz: outside it may be less.",
        "de": (
            "Der kleinste Phasenwinkel liegt am Rand des Bereichs, {frequency:.3g} Hz: Außerhalb kann er kleiner sein."
        ),
    },
    "no_rigidity_height": {
        "en": "without the plate's height the tyre's rigidity is not known.",
        "de": "Ohne die Höhe der Platte ist die Reifensteifigkeit nicht bekannt.",
    },
    "no_rigidity_hold": {
        "en": "the plate is not held at 25 Hz ({count} turns at {frequency:.3g} Hz): no tyre rigidity.",
        "de": (
            "Die Platte wird nicht bei 25 Hz gehalten ({count} Hübe bei {frequency:.3g} Hz): keine Reifensteifigkeit."
        ),
    },
    "tyre_soft": {
        "en": (
            "the tyre's rigidity of {rigidity:.0f} N/mm is below {limit:.0f} N/mm: inflate the tyre and repeat the "
            "test."
        ),
        "de": "Die Reifensteifigkeit {rigidity:.0f} N/mm liegt unter {limit:.0f} N/mm: aufpumpen, Prüfung wiederholen.",
    },
    "tyre_stiff": {
        "en": (
            "the tyre's rigidity of {rigidity:.0f} N/mm is above {limit:.0f} N/mm: too much pressure; correct it and "
            "repeat."
        ),
        "de": (
            "Die Reifensteifigkeit {rigidity:.0f} N/mm liegt über {limit:.0f} N/mm: zu viel Druck; berichtigen und "
            "wiederholen."
        ),
    },
    "not_fitted": {
        "en": "{text}: the values come from the single turns alone.",
        "de": "Kein Viertelfahrzeug ließ sich anpassen: Die Werte stammen nur aus den einzelnen Hüben.",
    },
    "no_wheel": {
        "en": (
            "no wheel on a plate explains this record: height and force would mean a tyre of {stiffness:.4g} N/mm; "
            "check channels and units."
        ),
        "de": (
            "Kein Rad auf einer Platte erklärt diese Messung: Höhe und Kraft ergäben einen Reifen von "
            "{stiffness:.4g} N/mm; Kanäle und Einheiten prüfen."
        ),
    },
    "poor_fit": {
        "en": (
            "a linear quarter car explains {percent:.0f} % of the force only: dry friction, a damper that is not "
            "linear, or another vibration; damping ratios are means over the amplitudes met."
        ),
        "de": (
            "Ein lineares Viertelfahrzeug erklärt nur {percent:.0f} % der Kraft: trockene Reibung, ein nichtlinearer "
            "Dämpfer oder fremde Schwingungen; Dämpfungsgrade sind Mittel über die Amplituden."
        ),
    },
    "overdamped": {
        "en": (
            "the wheel does not oscillate: its damping ratio is 1 or more; is the damper stuck, or the suspension "
            "locked?"
        ),
        "de": (
            "Das Rad schwingt nicht: Sein Dämpfungsgrad ist 1 oder mehr; sitzt der Dämpfer fest, oder ist die "
            "Federung blockiert?"
        ),
    },
    "plate_estimated": {
        "en": (
            "the tester's {names} are estimated: the damping ratio on the tester depends on them, the one on the road "
            "(graded) does not."
        ),
        "de": (
            "Geschätzt sind am Prüfstand: {names}. Der Dämpfungsgrad auf dem Prüfstand hängt davon ab, der bewertete "
            "auf der Straße nicht."
        ),
    },
}
"""What each code says; numbers are formatted as English ones, German ones get a comma."""

GERMAN_WORDS = {
    "left": "links",
    "right": "rechts",
    "pounds (lbf)": "Pfund (lbf)",
    "kilograms (kgf)": "Kilogramm (kgf)",
    "inches": "Zoll",
    "metres": "Metern",
    "centimetres": "Zentimetern",
    "micrometres": "Mikrometern",
    "plate mass": "Masse der Platte",
    "plate spring rate": "Federrate der Platte",
    "rigid-plate": "starre Platte",
    "sprung-plate": "gefederte Platte",
    "plate damping coefficient": "Dämpfung der Platte",
}
"""Words within the sentences, by the English ones."""


@dataclass(frozen=True)
class Remark(Finding):
    """A finding whose sentence is known in both languages.

    Attributes
    ----------
    place, severity, message, value
        As of every `Finding`; the message is English.
    code : str
        Which sentence of ``SENTENCES``.
    words : mapping
        What stands in it: numbers in the unit that the sentence names, and names.
    """

    code: str = ""
    words: Mapping[str, Any] = field(default_factory=dict)


def remark(place: str, severity: Severity, code: str, value: float | None = None, /, **words: Any) -> Remark:
    """Make a finding of a code; its message is English.

    Examples
    --------
    >>> found = remark("left.tyre", "warning", "load_off", 1.03, load=4e3, measured=4120.5, percent=3.01)
    >>> found.message
    'the header gives 4000 N, the plate carries 4120 N on average: +3.0 %, allowed are 2 %.'
    >>> said(found, "de")
    'Der Kopf nennt 4000 N, die Platte trägt im Mittel 4120 N: +3,0 %, zulässig sind 2 %.'
    """
    return Remark(place, severity, _sentence(code, words, "en"), value, code, words)


_OF_READER = {
    "the channel is constant": "reading_constant",
    "the channel looks clipped": "reading_clipped",
    "the time step varies": "reading_resampled",
    "columns that are no known channel": "reading_columns",
    "signals of another length": "reading_columns",
}


def of_reader(finding: Finding) -> Finding:
    """Give a finding of the file's reader its code; one that has a code, or that is not known, is given as it is."""
    code = next((code for begin, code in _OF_READER.items() if finding.message.startswith(begin)), None)
    if code is None or isinstance(finding, Remark):
        return finding
    value = finding.value if finding.value is not None else 0.0
    words = {"text": finding.message, "value": value, "percent": 100.0 * value}
    return Remark(finding.place, finding.severity, finding.message, finding.value, code, words)


def of_plain(table: Mapping[str, Any]) -> Finding:
    """Give a finding back from its plain table, with its code where it has one that is known.

    Examples
    --------
    >>> found = remark("left", "note", "plate_still")
    >>> of_plain(found.__dict__) == found, of_plain({"place": "a", "severity": "note", "message": "b", "value": None})
    (True, Finding(place='a', severity='note', message='b', value=None))
    """
    known = {name: table[name] for name in ("place", "severity", "message", "value")}
    if table.get("code") not in SENTENCES:
        return Finding(**known)
    return Remark(**known, code=str(table["code"]), words=dict(table.get("words", {})))


def said(finding: Finding, language: Language = "en") -> str:
    """Give a finding's sentence in a language; the English one where it has no code."""
    if language == "en" or not isinstance(finding, Remark):
        return finding.message
    return _sentence(finding.code, finding.words, language)


def _sentence(code: str, words: Mapping[str, Any], language: Language) -> str:
    shown = {name: _german(value) for name, value in words.items()} if language == "de" else words
    return SENTENCES[code][language].format(**shown)


def _german(value: Any) -> Any:
    if isinstance(value, float):
        return _German(value)
    if isinstance(value, str):
        return ", ".join(GERMAN_WORDS.get(part, part) for part in value.split(", "))
    return value


class _German(float):
    """A number that is written with a comma."""

    def __format__(self, spec: str) -> str:
        return super().__format__(spec).replace(".", ",")
