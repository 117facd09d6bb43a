"""What an evaluation finds, as data: a place, a code and its numbers, said in English and German."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from jounce.core.catalogue import Severity
from jounce.core.findings import Finding
from jounce.inspection.quantities import Language, Sentence

SENTENCES: dict[str, Sentence] = {
    # the record as a whole
    "samples_missing": Sentence(
        "{count} sample{plural} not a number, the first at {time:.4g} s: the record has gaps; repeat the test.",
        "{count} Messwerte fehlen, der erste bei {time:.4g} s: Die Messung hat Lücken; Prüfung wiederholen.",
    ),
    "too_short": Sentence(
        "the record is too short: {length:.3g} s, without a sweep.",
        "Die Messung ist zu kurz: {length:.3g} s, ohne Auslauf.",
    ),
    "clock": Sentence("{text}", "Die Zeitachse der Messung ist nicht brauchbar (englisch): {text}"),
    "unknown_key": Sentence(
        "the header entry {key!r} is not known and was not used.{hint}",
        "Die Angabe {key!r} im Kopf ist nicht bekannt und wurde nicht verwendet.",
    ),
    "not_a_date": Sentence(
        "{date!r} is not a date such as 2026-11-21: the record cannot be placed in the vehicle's history.",
        "{date!r} ist kein Datum wie 2026-11-21: Die Messung lässt sich nicht in den Verlauf des Fahrzeugs einordnen.",
    ),
    "overruled": Sentence(
        "the header gives {key} {header!r}; {given!r} was told instead and is used.",
        "Der Kopf nennt {key} {header!r}; angegeben und verwendet wurde {given!r}.",
    ),
    "line_left_out": Sentence(
        "the header line {line!r} was ignored: it is not 'key = value' with text in quotes",
        "Die Kopfzeile {line!r} wurde übergangen: Sie hat nicht die Form 'name = wert' mit Text in Anführungszeichen.",
    ),
    "other_tester": Sentence(
        "the header names the tester {name!r}; the record is evaluated as one from {tester!r}.",
        "Der Kopf nennt den Prüfstand {name!r}; ausgewertet wird die Messung wie eine vom Prüfstand {tester!r}.",
    ),
    "other_kind": Sentence(
        "the header names the tester {name!r} ({kind}); the record cannot be evaluated as one from {tester!r} ({own}).",
        "Der Kopf nennt den Prüfstand {name!r} ({kind}); die Messung kann nicht wie eine vom Prüfstand {tester!r} "
        "({own}) ausgewertet werden.",
    ),
    "not_rigid": Sentence(
        "the stroke of the plate varies with frequency from {low:.3g} to {high:.3g} mm: it stands on a spring; choose "
        "the tester that made this record.",
        "Der Hub der Platte ändert sich mit der Frequenz von {low:.3g} bis {high:.3g} mm: Sie ist gefedert; den "
        "Prüfstand dieser Messung wählen.",
    ),
    "not_sprung": Sentence(
        "the stroke of the plate is {stroke:.3g} mm at every frequency, and the forces would compress the tester's "
        "plate spring by {compressed:.3g} mm, though its exciter moves by {exciter:.3g} mm: the plate stands on no "
        "such spring; choose the tester that made this record.",
        "Der Hub der Platte ist bei jeder Frequenz {stroke:.3g} mm, und die Kräfte würden die Plattenfeder des "
        "Prüfstands um {compressed:.3g} mm zusammendrücken, obwohl sein Erreger sich nur um {exciter:.3g} mm bewegt: "
        "Die Platte steht auf keiner solchen Feder; den Prüfstand dieser Messung wählen.",
    ),
    # what the reader of the file found; its sentence is the English one
    "reading_constant": Sentence("{text}", "Der Kanal ist unverändert ({value:g}); war der Aufnehmer angeschlossen?"),
    "reading_clipped": Sentence(
        "{text}",
        "Der Kanal scheint abgeschnitten: {percent:.2g} % seiner Messwerte liegen an seinen Grenzen.",
    ),
    "reading_held": Sentence(
        "{text}",
        "Jeder Wert des Kanals steht {value:.0f} Abtastungen lang: Er wurde langsamer aufgezeichnet und ist verspätet.",
    ),
    "reading_frozen": Sentence(
        "{text}",
        "Der Kanal bleibt stehen, obwohl er sich davor und danach bewegt: {percent:.2g} % seiner Messwerte sind "
        "Ausfall des Aufnehmers oder der Aufzeichnung.",
    ),
    "reading_resampled": Sentence(
        "{text}",
        "Die Zeitschritte schwanken um {percent:.2g} % (zulässig: 1 %); auf gleiche Schritte umgerechnet.",
    ),
    "reading_columns": Sentence("{text}", "Nicht alle Spalten der Datei wurden verwendet (englisch): {text}"),
    "reading_commas": Sentence("{text}", "Die Datei hat Dezimalkommas."),
    "reading_units": Sentence("{text}", "Die Einheiten wurden der Zeile unter den Namen entnommen."),
    "reading_preamble": Sentence("{text}", "Der Text vor der Kopfzeile der Datei wurde übergangen."),
    "reading_steps": Sentence(
        "{text}", "Auf gleiche Zeitschritte umgerechnet; die größte Lücke der aufgezeichneten Zeit ist {value:.4g} s."
    ),
    "reading_sample_time": Sentence(
        "{text}",
        "Die angegebene Schrittweite wurde verwendet; nach der aufgezeichneten Zeit dauert die Messung {value:.4g} s.",
    ),
    "reading_cut_off": Sentence(
        "{text}", "Die Datei wurde abgeschnitten; gelesen wurde, was sie enthält (englisch): {text}"
    ),
    "reading_implausible": Sentence("{text}", "Die Größe der Werte ist zweifelhaft, Einheit prüfen (englisch): {text}"),
    # plates and units
    "columns_swapped": Sentence(
        "the plate would move {stroke:.4g} mm and the force would reach only {force:.3g} N: the columns of plate and "
        "force are swapped.",
        "Die Platte bewegte sich um {stroke:.4g} mm, und die Kraft erreichte nur {force:.3g} N: Die Spalten von "
        "Platte und Kraft sind vertauscht.",
    ),
    "plate_still": Sentence(
        "the plate never moves; was its sensor connected?",
        "Die Platte bewegt sich nie; war ihr Wegaufnehmer angeschlossen?",
    ),
    "plate_never_moves": Sentence("the plate never moves: no sweep.", "Die Platte bewegt sich nie: kein Auslauf."),
    "stroke_unit": Sentence(
        "the plate moves {stroke:.4g} mm on an eccentric exciter with a stroke of {expected:.4g} mm: check the unit.",
        "Die Platte bewegt sich um {stroke:.4g} mm bei einem Exzenterhub von {expected:.4g} mm: Einheit prüfen.",
    ),
    "height_unit": Sentence(
        "the plate moves {stroke:.4g} mm, but the tester's stroke is {expected:.4g} mm: the heights seem to be in "
        "{unit}; correct the unit in the header.",
        "Die Platte bewegt sich um {stroke:.4g} mm, der Hub des Prüfstands ist {expected:.4g} mm: Die Höhen scheinen "
        "in {unit} zu sein; Einheit im Kopf berichtigen.",
    ),
    "stroke_wrong": Sentence(
        "the plate moves {stroke:.4g} mm, but the tester's stroke is {expected:.4g} mm: wrong unit, wrong tester, or "
        "a defective plate.",
        "Die Platte bewegt sich um {stroke:.4g} mm, der Hub des Prüfstands ist {expected:.4g} mm: falsche Einheit, "
        "falscher Prüfstand oder defekte Platte.",
    ),
    "stroke_off": Sentence(
        "the plate moves {stroke:.4g} mm, but the tester's stroke is {expected:.4g} mm; they may differ by "
        "{allowed:.2g} mm.",
        "Die Platte bewegt sich um {stroke:.4g} mm, der Hub des Prüfstands ist {expected:.4g} mm; zulässig sind "
        "{allowed:.2g} mm Abweichung.",
    ),
    "stroke_falls": Sentence(
        "the stroke of the plate falls to {stroke:.3g} mm above 20 Hz, from {middle:.3g} mm at 8 to 14 Hz: is the "
        "record behind a low pass? Then forces are too small, and adhesion comes out too good; record without it.",
        "Der Hub der Platte fällt oberhalb von 20 Hz auf {stroke:.3g} mm, von {middle:.3g} mm bei 8 bis 14 Hz: Ist die "
        "Messung tiefpassgefiltert? Dann sind Kräfte zu klein, die Bodenhaftung zu gut; ohne Filter aufzeichnen.",
    ),
    "stroke_rises": Sentence(
        "the stroke of the plate is only {stroke:.3g} mm at its slowest turns, but {middle:.3g} mm at 8 to 14 Hz: is "
        "its height behind a high pass (AC coupling)? Then phase angles are wrong; record it with direct coupling.",
        "Der Hub der Platte ist bei den langsamsten Hüben nur {stroke:.3g} mm, bei 8 bis 14 Hz {middle:.3g} mm: Ist "
        "ihre Höhe hochpassgefiltert (AC-Kopplung)? Dann sind Phasenwinkel falsch; ohne Hochpass aufzeichnen.",
    ),
    "exciter_off": Sentence(
        "height of the plate and force of its spring would mean an exciter stroke of {stroke:.3g} mm, but the tester's "
        "is {expected:.3g} mm: check the gain of the height, and stroke and plate spring of the tester; damping ratios "
        "depend on them.",
        "Höhe der Platte und Kraft ihrer Feder ergäben einen Hub des Erregers von {stroke:.3g} mm, der des Prüfstands "
        "ist {expected:.3g} mm: Verstärkung der Höhe sowie Hub und Plattenfeder des Prüfstands prüfen; "
        "Dämpfungsgrade hängen davon ab.",
    ),
    "upside_down": Sentence(
        "the plate height has the wrong sign: upwards must be positive.",
        "Die Höhe der Platte hat das falsche Vorzeichen: Aufwärts muss positiv sein.",
    ),
    "no_frequency": Sentence(
        "the record has neither {height} nor {tacho}: the frequency is not known.",
        "Die Messung enthält weder {height} noch {tacho}: Die Frequenz ist nicht bekannt.",
    ),
    "height_missing": Sentence(
        "a sprung plate is evaluated from its height, which is missing.",
        "Eine gefederte Platte wird über ihre Höhe ausgewertet; diese fehlt.",
    ),
    "other_together": Sentence(
        "the other plate runs for {time:.1f} s of this test, as the wheel order says; it excites this wheel as well.",
        "Die andere Platte läuft während {time:.1f} s dieser Prüfung, wie angegeben; sie regt auch dieses Rad an.",
    ),
    "other_running": Sentence(
        "the other plate runs for {time:.1f} s of this test and excites this wheel as well; test one wheel after the "
        "other.",
        "Die andere Platte läuft während {time:.1f} s dieser Prüfung und regt auch dieses Rad an; die Räder "
        "nacheinander prüfen.",
    ),
    # static loads and forces
    "no_wheel_load": Sentence(
        "the plate carries {measured:.4g} N on average, which is no wheel load: check the unit of the force.",
        "Die Platte trägt im Mittel {measured:.4g} N, das ist keine Radlast: Einheit der Kraft prüfen.",
    ),
    "load_from_signal": Sentence(
        "the header gives no static load; {measured:.0f} N was taken from the force signal.",
        "Der Kopf nennt keine statische Radlast; {measured:.0f} N wurden dem Kraftsignal entnommen.",
    ),
    "force_unit": Sentence(
        "the header gives {load:.0f} N, but the plate carries {measured:.4g} N on average: the forces seem to be in "
        "{unit}; correct the unit in the header.",
        "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: Die Kräfte scheinen in {unit} zu "
        "sein; Einheit im Kopf berichtigen.",
    ),
    "force_sign": Sentence(
        "the header gives {load:.0f} N, and the plate carries {measured:.4g} N on average: the force has the wrong "
        "sign: upwards on the tyre must be positive.",
        "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: Die Kraft hat das falsche "
        "Vorzeichen: Aufwärts auf den Reifen muss positiv sein.",
    ),
    "load_unit": Sentence(
        "the header gives {load:.0f} N, but the plate carries {measured:.4g} N on average: the static load seems to "
        "be in another unit; correct the unit in the header.",
        "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: Die statische Radlast scheint in "
        "einer anderen Einheit zu sein; Einheit im Kopf berichtigen.",
    ),
    "load_contradicts": Sentence(
        "the header gives {load:.0f} N, but the plate carries {measured:.4g} N on average: the static weight "
        "contradicts the signal (it is wrong, or the force has an offset of {offset:+.0f} N).",
        "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: Die statische Radlast widerspricht "
        "dem Signal (sie ist falsch, oder die Kraft hat einen Nullpunktfehler von {offset:+.0f} N).",
    ),
    "load_off": Sentence(
        "the header gives {load:.0f} N, but the plate carries {measured:.4g} N on average: {percent:+.1f} %, where 2 "
        "% is allowed.",
        "Der Kopf nennt {load:.0f} N, die Platte trägt im Mittel {measured:.4g} N: {percent:+.1f} %, zulässig sind 2 "
        "%.",
    ),
    "load_out_of_range": Sentence(
        "{load:.0f} N is outside the wheel loads this tester is made for, {low:.0f} to {high:.0f} N.",
        "{load:.0f} N liegen außerhalb der Radlasten dieses Prüfstands, {low:.0f} bis {high:.0f} N.",
    ),
    "sides_swapped": Sentence(
        "the plates carry {left:.0f} N (left) and {right:.0f} N (right), but the header gives {left_load:.0f} N and "
        "{right_load:.0f} N: left and right are swapped.",
        "Die Platten tragen {left:.0f} N (links) und {right:.0f} N (rechts), der Kopf nennt {left_load:.0f} N und "
        "{right_load:.0f} N: Links und rechts sind vertauscht.",
    ),
    "order_missing": Sentence(
        "the header does not state the wheel order: exchanged sides would not be noticed. By the columns it was "
        '{order}; if so, add wheel_order = "{order}".',
        "Der Kopf nennt die Reihenfolge der Räder nicht: Vertauschte Seiten fielen nicht auf. Nach den Spalten war sie "
        "{order}; wenn das stimmt, wheel_order ergänzen.",
    ),
    "order_contradicts": Sentence(
        "the header gives the wheel order {order}, but the {first} plate runs first: left and right are swapped, or "
        "the order is wrong.",
        "Der Kopf nennt die Reihenfolge {order}, aber zuerst läuft die Platte {first}: Links und rechts sind "
        "vertauscht, oder die Reihenfolge ist falsch.",
    ),
    "force_missing": Sentence(
        "{found} is in the record, but {force} is not: check the column names.",
        "{found} ist in der Messung, aber {force} fehlt: Spaltennamen prüfen.",
    ),
    "both_offset": Sentence(
        "both forces are {offset:+.0f} N off the static loads: the force cells have an offset; tare them.",
        "Beide Kräfte weichen um {offset:+.0f} N von den statischen Radlasten ab: Kraftaufnehmer nullen.",
    ),
    "other_vehicle": Sentence(
        "the static load of {load:.0f} N is not that of the vehicle file, {expected:.0f} N.",
        "Die statische Radlast {load:.0f} N passt nicht zur Fahrzeugdatei ({expected:.0f} N).",
    ),
    "samples_too_few": Sentence(
        "{rate:.4g} samples per second are too few; {wanted:.0f} are required.",
        "{rate:.4g} Messwerte je Sekunde sind zu wenig; verlangt sind {wanted:.0f}.",
    ),
    "samples_few": Sentence(
        "{rate:.4g} samples per second; {wanted:.0f} are required.",
        "{rate:.4g} Messwerte je Sekunde; verlangt sind {wanted:.0f}.",
    ),
    "saturated": Sentence(
        "the force is clipped at {limit:.4g} N ({percent:.2g} % of the samples): saturated; widen the range of the "
        "force cell.",
        "Die Kraft ist bei {limit:.4g} N abgeschnitten ({percent:.2g} % der Messwerte): übersteuert; Messbereich "
        "erweitern.",
    ),
    "clipped": Sentence(
        "the force is clipped at {limit:.4g} N ({percent:.2g} % of the samples); amplitudes come out too small.",
        "Die Kraft ist bei {limit:.4g} N abgeschnitten ({percent:.2g} % der Messwerte): zu kleine Amplituden.",
    ),
    "dropout": Sentence(
        "the force stays at exactly {force:.4g} N for {time:.0f} ms, which a cell under a moving plate never shows: a "
        "dropout of the signal, or the force is the contact force itself (force_cell).",
        "Die Kraft bleibt {time:.0f} ms lang genau bei {force:.4g} N, was ein Aufnehmer unter einer bewegten Platte "
        "nie zeigt: Signalausfall, oder es ist die Aufstandskraft selbst (force_cell).",
    ),
    "force_coarse": Sentence(
        "the force is recorded in steps of {step:.4g} N, over 5 % of the static load: too coarse for its amplitudes "
        "and phase angles; choose a smaller range of the force cell or logger.",
        "Die Kraft ist in Stufen von {step:.4g} N aufgezeichnet, über 5 % der statischen Radlast: zu grob für "
        "Amplituden und Phasenwinkel; kleineren Messbereich wählen.",
    ),
    "height_coarse": Sentence(
        "the height is recorded in steps of {step:.3g} mm, over 5 % of the stroke: too coarse for phase angles; choose "
        "a smaller range of the sensor or logger.",
        "Die Höhe ist in Stufen von {step:.3g} mm aufgezeichnet, über 5 % des Hubs: zu grob für Phasenwinkel; "
        "kleineren Messbereich wählen.",
    ),
    "force_elsewhere": Sentence(
        "the force moves while the plate stands still ({moves:.0f} N r.m.s.), and hardly while it moves ({still:.0f} N "
        "r.m.s.): heights or forces of left and right are swapped.",
        "Die Kraft schwankt, während die Platte steht (Standardabweichung {moves:.0f} N), und kaum, während sie sich "
        "bewegt ({still:.0f} N): Höhen oder Kräfte von links und rechts sind vertauscht.",
    ),
    "slips": Sentence(
        "the mean force drifts from the static load by {percent:+.0f} % during the test: the wheel slips or rolls.",
        "Die mittlere Kraft weicht während der Prüfung um {percent:+.0f} % von der statischen Radlast ab: Das Rad "
        "rutscht oder rollt.",
    ),
    "vibrates": Sentence(
        "the force vibrates at {frequency:.1f} Hz with {force:.0f} N, which this plate does not cause: is the other "
        "plate or another machine running?",
        "Die Kraft schwingt bei {frequency:.1f} Hz um {force:.0f} N, die diese Platte nicht erzeugt: Läuft die andere "
        "Platte oder eine andere Maschine?",
    ),
    "swings_on": Sentence(
        "the force swings at {frequency:.1f} Hz with {force:.0f} N, which this plate does not cause: so lightly damped "
        "a wheel swings on by itself, and its body with it; or does another machine shake it?",
        "Die Kraft schwingt bei {frequency:.1f} Hz um {force:.0f} N, die diese Platte nicht erzeugt: Ein so schwach "
        "gedämpftes Rad schwingt von selbst nach und der Aufbau mit ihm; oder rüttelt eine andere Maschine daran?",
    ),
    # the sweep
    "few_turns": Sentence(
        "the plate makes fewer than {fewest} turns: no sweep.",
        "Die Platte macht weniger als {fewest} Hübe: kein Auslauf.",
    ),
    "never_high": Sentence(
        "the plate turns at {low:.3g} to {top:.3g} Hz and never reaches {high:g} Hz: the sweep is missing.",
        "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz und erreicht {high:g} Hz nie: Der Auslauf fehlt.",
    ),
    "no_sweep": Sentence(
        "the plate turns at {low:.3g} to {top:.3g} Hz: the sweep is missing.",
        "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz: Der Auslauf fehlt.",
    ),
    "sweep_cut_off": Sentence(
        "the plate turns at {low:.3g} to {top:.3g} Hz: the record is too short, the sweep is cut off.",
        "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz: Die Messung ist zu kurz, der Auslauf abgeschnitten.",
    ),
    "sweep_up": Sentence(
        "the plate turns at {low:.3g} to {top:.3g} Hz, but the frequency rises: a sweep up instead of down.",
        "Die Platte läuft mit {low:.3g} bis {top:.3g} Hz, aber aufwärts: ein Hochlauf statt des Auslaufs.",
    ),
    "several_sweeps": Sentence(
        "{count} sweeps in one record: evaluate them separately.",
        "{count} Ausläufe in einer Messung: getrennt auswerten.",
    ),
    "rows_missing": Sentence(
        "at {time:.4g} s the plate's turn takes {turn:.0f} ms, between turns of {usual:.0f} ms: rows are missing there "
        "though the time goes on, or the clock jumped; repeat the test.",
        "Bei {time:.4g} s dauert der Hub der Platte {turn:.0f} ms, zwischen Hüben von {usual:.0f} ms: Dort fehlen "
        "Messwerte, obwohl die Zeit weiterläuft, oder die Uhr ist gesprungen; Prüfung wiederholen.",
    ),
    "frequency_off": Sentence(
        "the exciter turns at up to {frequency:.3g} Hz, but {expected:.3g} Hz is the tester's programme: is the clock "
        "of the record right? Damping ratios depend on it.",
        "Der Erreger läuft mit bis zu {frequency:.3g} Hz, nach dem Programm des Prüfstands mit {expected:.3g} Hz: "
        "Stimmt die Zeit der Messung? Dämpfungsgrade hängen davon ab.",
    ),
    "sweep_fast": Sentence(
        "the sweep is too fast: {rate:.2g} Hz/s, where {most:g} Hz/s is allowed; adhesion comes out too high and the "
        "phase angle blurred.",
        "Der Auslauf ist zu schnell: {rate:.2g} Hz/s, zulässig sind {most:g} Hz/s; die Bodenhaftung wird zu gut und "
        "der Phasenwinkel ungenau.",
    ),
    "sweep_short": Sentence(
        "the sweep takes {length:.1f} s; at least {least:g} s is required.",
        "Der Auslauf dauert {length:.1f} s; verlangt sind mindestens {least:g} s.",
    ),
    # values of every method
    "no_turn": Sentence("no turn of the plate could be evaluated.", "Kein Hub der Platte konnte ausgewertet werden."),
    "lift_off": Sentence(
        "the tyre leaves the plate: adhesion counts as 0.",
        "Der Reifen hebt von der Platte ab: Die Bodenhaftung zählt als 0.",
    ),
    "lift_off_left_out": Sentence(
        "the tyre leaves the plate; these parts do not count.",
        "Der Reifen hebt von der Platte ab; diese Abschnitte zählen nicht.",
    ),
    "not_periodic": Sentence(
        "from {low:g} to {high:g} Hz the motion does not repeat every turn: values are the least of several turns.",
        "Von {low:g} bis {high:g} Hz wiederholt sich die Bewegung nicht mit jedem Hub: Die Werte sind die kleinsten "
        "aus mehreren Hüben.",
    ),
    "not_fitted": Sentence(
        "{text}: the values come from the single turns alone.",
        "Kein Viertelfahrzeug ließ sich anpassen: Die Werte stammen nur aus den einzelnen Hüben.",
    ),
    "no_wheel": Sentence(
        "no wheel on a plate explains this record: height and force would mean a tyre of {stiffness:.4g} N/mm; check "
        "channels and units.",
        "Kein Rad auf einer Platte erklärt diese Messung: Höhe und Kraft ergäben einen Reifen von {stiffness:.4g} "
        "N/mm; Kanäle und Einheiten prüfen.",
    ),
    "poor_fit": Sentence(
        "a linear quarter car explains only {percent:.0f} % of the force: dry friction, a nonlinear damper, or "
        "another vibration; damping ratios are means over the amplitudes met, their intervals of the noise only.",
        "Ein lineares Viertelfahrzeug erklärt nur {percent:.0f} % der Kraft: trockene Reibung, ein nichtlinearer "
        "Dämpfer oder fremde Schwingungen; Dämpfungsgrade sind Mittel über die Amplituden, ihre Intervalle zählen nur "
        "das Rauschen.",
    ),
}
"""What each code says, those of the methods beside these; German numbers get a comma."""

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
    place, severity, message, value, numbers
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
    'the header gives 4000 N, but the plate carries 4120 N on average: +3.0 %, where 2 % is allowed.'
    >>> sentence_of(found, "de")
    'Der Kopf nennt 4000 N, die Platte trägt im Mittel 4120 N: +3,0 %, zulässig sind 2 %.'
    """
    return Remark(place, severity, _sentence(code, words, "en"), value, code, words)


def problem(place: str, code: str, value: float | None = None, /, **words: Any) -> Finding:
    """Make the finding of what makes a record unfit; ``code`` and ``words`` as of `remark`."""
    return remark(place, "problem", code, value, **words)


def warning(place: str, code: str, value: float | None = None, /, **words: Any) -> Finding:
    """Make the finding of what weakens a value; ``code`` and ``words`` as of `remark`."""
    return remark(place, "warning", code, value, **words)


_OF_READER = {
    "the channel is constant": "reading_constant",
    "the channel looks clipped": "reading_clipped",
    "each value is held for": "reading_held",
    "the channel stays at exactly": "reading_frozen",
    "the time step varies": "reading_resampled",
    "columns that are no known channel": "reading_columns",
    "signals of another length": "reading_columns",
    "channels without a single number": "reading_columns",
    "decimal commas": "reading_commas",
    **dict.fromkeys(("the units were read from the line", "the units were read from the row"), "reading_units"),
    **dict.fromkeys(("the header is line", "the header is row"), "reading_preamble"),
    "resampled to": "reading_steps",
    "with the given sample time": "reading_sample_time",
    "the file announces": "reading_cut_off",
    "the last data set has no end": "reading_cut_off",
    **dict.fromkeys(("the mean is", "the r.m.s. is", "the peak is", "the range is"), "reading_implausible"),
    **dict.fromkeys(("it changes by", "the samples are", "the force does", "it is "), "reading_implausible"),
}
"""Begins of what the reader of files says, and the code that each gets."""


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


def sentence_of(finding: Finding, language: Language = "en") -> str:
    """Give a finding's sentence in a language; the English one where it has no code."""
    if language == "en" or not isinstance(finding, Remark):
        return finding.message
    return _sentence(finding.code, finding.words, language)


def _sentence(code: str, words: Mapping[str, Any], language: Language) -> str:
    shown = {name: _german(value) for name, value in words.items()} if language == "de" else words
    return SENTENCES[code].said(language).format(**shown)


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
