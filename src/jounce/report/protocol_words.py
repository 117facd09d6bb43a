"""Words of the test protocol in English and German."""

from __future__ import annotations

from collections.abc import Mapping

from jounce.inspection.quantities import Language

_ENGLISH = {
    "title": "Shock-absorber test protocol",
    "vehicle": "Vehicle",
    "plate_number": "Number plate",
    "date": "Date",
    "tester": "Tester",
    "place": "Place",
    "operator": "Inspector",
    "deciding": "Method that decides",
    "record": "Record",
    "result": "Result",
    "front": "Front axle",
    "rear": "Rear axle",
    "axle": "Axle",
    "left": "Left",
    "right": "Right",
    "front_left": "Front left",
    "front_right": "Front right",
    "rear_left": "Rear left",
    "rear_right": "Rear right",
    "value": "Value",
    "difference": "Difference",
    "limit": "Passes",
    "static_load": "static wheel load",
    "verdict": "Verdict",
    "reasons": "Reasons",
    "findings": "Remarks on the measurement",
    "information": "for information: ",
    "fine": "All values that decide are within their limits.",
    "more": "… and {count} more, see the data file beside this protocol.",
    "limits": "Limits",
    "signature": "Inspector's signature",
    "place_date": "Place, date",
    "at": "at",
    "front_rear": "Front to rear",
    "differences_note": (
        "Difference: absolute (pp: percentage points), and relative to the greater value. "
        "±: half width of the 95 % interval, rounded up."
    ),
    "not_tested": "not tested",
    "lift_off": "tyre leaves the plate",
    "curves": "Curves of both wheels: force amplitude and phase angle over frequency, plate force over time",
    "page": "Page",
}
_GERMAN = {
    "title": "Prüfprotokoll Stoßdämpfer",
    "vehicle": "Fahrzeug",
    "plate_number": "Kennzeichen",
    "date": "Datum",
    "tester": "Prüfstand",
    "place": "Ort",
    "operator": "Prüfer",
    "deciding": "Maßgebliches Verfahren",
    "record": "Messdatei",
    "result": "Ergebnis",
    "front": "Vorderachse",
    "rear": "Hinterachse",
    "axle": "Achse",
    "left": "Links",
    "right": "Rechts",
    "front_left": "Vorn links",
    "front_right": "Vorn rechts",
    "rear_left": "Hinten links",
    "rear_right": "Hinten rechts",
    "value": "Größe",
    "difference": "Unterschied",
    "limit": "Bestanden",
    "static_load": "statische Radlast",
    "verdict": "Urteil",
    "reasons": "Begründung",
    "findings": "Hinweise zur Messung (englisch)",
    "information": "zur Information: ",
    "fine": "Alle maßgeblichen Werte liegen innerhalb ihrer Grenzwerte.",
    "more": "… und {count} weitere, siehe die Datendatei neben diesem Protokoll.",
    "limits": "Grenzwerte",
    "signature": "Unterschrift des Prüfers",
    "place_date": "Ort, Datum",
    "at": "bei",
    "front_rear": "Vorn zu hinten",
    "differences_note": (
        "Unterschied: absolut (%-P.: Prozentpunkte) und bezogen auf den größeren Wert. "
        "±: halbe Breite des 95-%-Intervalls, aufgerundet."
    ),
    "not_tested": "nicht geprüft",
    "lift_off": "Reifen hebt ab",
    "curves": "Kurven beider Räder: Kraftamplitude und Phasenwinkel über der Frequenz, Plattenkraft über der Zeit",
    "page": "Seite",
}
WORDS: Mapping[Language, Mapping[str, str]] = {"en": _ENGLISH, "de": _GERMAN}
