"""Findings of an evaluation as data: each code says the same in both languages, and every code is used."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce.inspection
from jounce.core.findings import Finding
from jounce.inspection import Inspection, WheelResult, evaluate, read_record
from jounce.inspection.archive.entries import pack, unpack
from jounce.inspection.findings import Remark, remark, sentence_of
from jounce.inspection.grading import grade, grade_vehicle
from jounce.inspection.record import read_facts
from jounce.parts import load
from jounce.parts.testers import load_tester
from jounce.parts.variants import wear_dampers
from jounce.recordings import read_recording
from jounce.recordings.hdf5 import announcement
from jounce.report.protocol import protocol_html
from jounce.testers.testing import simulate_test

FOLDER = Path(jounce.inspection.__file__).parent


def test_a_phase_angle_below_zero_is_said_to_be_no_steady_state() -> None:
    car = load("audi-a6-quarter-car").with_changes(
        {"sprung.mass": 350.0, "tyre.damping_coefficient": 0.0}
    )
    tester = load_tester("egea-specsus2018")
    wheel = evaluate(simulate_test(wear_dampers(car, 0.9), tester, truth=False), tester).wheels[0]
    codes = [one.code for one in wheel.findings]
    assert (wheel.phase_angle_min_deg < 0.0) == ("phase_below_zero" in codes)
    assert "phase_below_zero" in codes
    sound = evaluate(simulate_test(car, tester, truth=False), tester).wheels[0]
    assert "phase_below_zero" not in [one.code for one in sound.findings]


def test_german_numbers_have_commas_and_german_words() -> None:
    found = remark(
        "left.plate.z", "problem", "height_unit", 0.04, stroke=0.2362, expected=6.0, unit="inches"
    )
    assert found.message.endswith(
        "the heights seem to be in inches; correct the unit in the header."
    )
    assert sentence_of(found, "de").startswith(
        "Die Platte bewegt sich um 0,2362 mm, der Hub des Prüfstands ist 6 mm"
    )
    assert "in Zoll" in sentence_of(found, "de")
    assert sentence_of(Finding("file", "note", "only English"), "de") == "only English"


def test_findings_and_reasons_are_german_on_a_german_page() -> None:
    weak = remark("left.plate.force", "warning", "poor_fit", 0.9, percent=90.0)
    unfit = remark("right.plate.force", "problem", "saturated", 0.05, limit=5600.0, percent=5.0)
    wheels = (
        WheelResult("left", static_load=4e3, phase_angle_min_deg=50.0, findings=(weak,)),
        WheelResult("right", static_load=4e3, findings=(unfit,)),
    )
    graded = grade_vehicle([grade(Inspection(wheels, {"axle": "front"}, methods=("egea",)))])
    english, german = (protocol_html(graded, language=language) for language in ("en", "de"))
    for text in (weak.message, unfit.message):
        assert text[1:] in english
        assert text[1:] not in german
    assert "erklärt nur 90 % der Kraft" in german
    assert "Die Kraft ist bei 5600 N abgeschnitten (5 % der Messwerte): übersteuert" in german
    assert "absolutes Kriterium (aus zweiter Hand)" in german
    assert "second-hand" not in german


def test_codes_and_words_are_in_the_plain_result(twin, left_record, eusama) -> None:
    time, height, force, _ = twin.rigid_record(
        twin.Car(), twin.Programme(before=0.5), mp=20.0, fine=4
    )
    found = evaluate(
        left_record(time, height, np.minimum(force, 5400.0), twin.Car().static_load), eusama
    )
    finding = found.to_dict()["wheels"][0]["findings"][0]
    assert isinstance(found.wheel("left").findings[0], Remark)
    assert finding["code"] == "saturated"
    assert finding["words"]["limit"] == 5400.0
    assert finding["message"] == found.wheel("left").reasons[0]


def test_findings_of_the_reader_are_german_too(tmp_path: Path) -> None:
    rows = "".join(f"{i / 1000}, 0.5, {4000 + i % 5}, {min(i % 9, 5)}\n" for i in range(400))
    text = f"time [s], left.plate.z [mm], left.plate.force [N], nonsense [V]\n{rows}"
    (tmp_path / "lane.csv").write_text(text, encoding="utf-8")
    _, findings = read_record(tmp_path / "lane.csv")
    assert len(findings) == 2
    german = [sentence_of(one, "de") for one in findings]
    assert german[0].startswith(
        "Spalten, die kein bekannter Kanal sind, wurden weggelassen: nonsense"
    )
    assert german[1].startswith("Der Kanal ist konstant (0,0005)")
    assert [sentence_of(one) for one in findings] == [one.message for one in findings]


_LANE = "time [s]; left.plate.z [{0}]; left.plate.force [{1}]; right.plate.z [mm]\n"
_ALWAYS = [
    "Dezimalkommas wurden als Dezimalpunkte gelesen",
    "Kanäle ohne eine einzige Zahl wurden weggelassen",
]
_UNITS = "Die Einheiten wurden der Zeile unter den Namen entnommen"
READ = [  # header, step (s), what the reader is told, and what a German page says of it
    (_LANE.format("mm", "N"), 0.01, {}, _ALWAYS),
    ("time; left.plate.z; left.plate.force; note\ns; mm; N; -\n", 0.01, {}, [_ALWAYS[0], _UNITS, "Spalten, die kein"]),
    (_LANE.format("mm", "N"), 0.01, {"resample": 0.02}, [*_ALWAYS, "Auf 50 Zeitpunkte in Schritten von 0,02 s"]),
    (_LANE.format("mm", "N"), 0.01, {"sample_time": 0.02}, [*_ALWAYS, "Mit der angegebenen Abtastzeit von 0,02 s"]),
    (_LANE.format("mm", "N"), 0.5, {}, [*_ALWAYS, "Die Werte liegen 0,5 s auseinander"]),
    (_LANE.format("mm", "mN"), 0.01, {}, [*_ALWAYS, "Spitzenwert: nur 4,"]),
    (_LANE.format("mm", "kN"), 0.01, {}, [*_ALWAYS, "Spitzenwert: 4,9e+06 N, aber kein Fahrwerk"]),
    (_LANE.format("m", "N"), 0.01, {}, [*_ALWAYS, "ändert sich um"]),
]  # fmt: skip


@pytest.mark.parametrize(("header", "step", "told", "german"), READ)
def test_whatever_the_reader_finds_is_german(
    tmp_path: Path, header: str, step: float, told: dict[str, float], german: list[str]
) -> None:
    file = tmp_path / "lane.csv"
    rows = (
        f"{i * step:.6g}; {3.0 * np.sin(i):.6f}; {4000.0 + 900.0 * np.cos(i):.3f};"
        for i in range(100)
    )
    file.write_text(header + "\n".join(rows).replace(".", ","), encoding="utf-8")
    found = read_recording(file, **told)[1]
    said = [sentence_of(one, "de") for one in found]
    assert len(said) == len(german), said
    assert all(one.startswith(begin) for one, begin in zip(said, german, strict=True)), said
    assert [sentence_of(one) for one in found] == [one.message for one in found]


def test_a_file_that_was_cut_off_is_german() -> None:
    (cut,) = announcement("left.plate.z", 100, 40, "a.tdms")
    assert sentence_of(cut, "de").startswith(
        "Die Datei kündigt 100 Werte an und enthält 40: Sie wurde abgeschnitten"
    )


@pytest.mark.parametrize(
    ("date", "codes"), [("2026-11-21", []), ("21.11.2026", []), ("soon", ["not_a_date"]), ("", [])]
)
def test_a_date_that_is_no_day_is_said(date: str, codes: list[str]) -> None:
    facts, findings = read_facts({"date": date})
    assert facts["date"] == date
    assert [one.code for one in findings] == codes


def test_codes_outlive_the_store(tmp_path: Path) -> None:
    text = "# foo = 3\ntime [s], left.plate.z [mm], left.plate.force [N]\n" + "".join(
        f"{i / 1000}, {i % 7}, {4000 + i % 5}\n" for i in range(20)
    )
    (tmp_path / "lane.csv").write_text(text, encoding="utf-8")
    record, findings = read_record(tmp_path / "lane.csv")
    again = unpack(pack(record, findings))[1]
    assert again == findings
    assert "ist nicht bekannt" in sentence_of(again[0], "de")
