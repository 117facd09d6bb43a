"""The German workbench says in German what is found, and says of what is not German that it is English."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

import pytest

import jounce as jn

pytestmark = pytest.mark.pages
TOKEN = "a-token-of-german"
LIBRARY = Path(jn.__file__).parent / "parts" / "library"


def test_findings_of_a_rig_and_of_a_recording_are_german(
    browser: Any, workbench: tuple[Path, int]
) -> None:
    folder, port = workbench
    rig = (LIBRARY / "kart-double-wishbone.toml").read_text()
    (folder / "steep.toml").write_text(rig.replace('camber = "0 deg"', 'camber = "20 deg"', 1))
    shutil.copy(LIBRARY / "kart-quarter-car.toml", folder)
    rows = "".join(f"{0.01 * i:.2f},1,{i % 7}\n" for i in range(60))
    (folder / "odd.csv").write_text(f"time [s],sprung.z [mm],temperature [K]\n{rows}")
    context = browser.new_context(viewport={"width": 1280, "height": 720}, locale="de-DE")
    context.set_default_timeout(60_000)
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}")
    page.goto(f"http://127.0.0.1:{port}/#/rig?name=steep.toml")
    page.wait_for_selector("html[data-ready=rig]")
    told = page.locator(".told")
    told.get_by_text("wheel.camber: 20 ° ist viel; wurden Grad als rad angegeben?").wait_for()
    assert told.locator("[lang=en]").count() == 0
    page.goto(f"http://127.0.0.1:{port}/#/inspection?record=odd.csv")
    page.wait_for_selector("html[data-ready=inspection]")
    page.get_by_role("button", name="Messung ansehen").click()
    reading = page.locator(".reading")
    reading.get_by_text(
        "Der Kanal ist konstant (0.001); war der Aufnehmer angeschlossen?"
    ).wait_for()
    reading.get_by_text(
        "Spalten, die kein bekannter Kanal sind, wurden weggelassen: temperature"
    ).wait_for()
    assert reading.locator("[lang=en]").count() == 0
    (folder / "few.toml").write_text(
        'schema = "jounce.rig/1"\nmodel = "quarter-car"\n[sprung]\nmass = "16 kq"\n'
    )
    page.goto(f"http://127.0.0.1:{port}/#/trial?rig=few.toml")
    page.get_by_role("alert").get_by_text(
        "few.toml, Zeile 4: sprung.mass: falsche Einheit"
    ).wait_for()
    assert (
        "tyre: der Schlüssel fehlt und hat keinen Vorgabewert."
        in page.get_by_role("alert").inner_text()
    )
    refused = {
        "error": {"text": "the wheels of this rig are of cheese"}
    }  # no words that a page could know
    page.route("**/api/rig?*", lambda route: route.fulfill(status=422, json=refused))
    page.goto(f"http://127.0.0.1:{port}/#/trial?rig=steep.toml")
    assert page.get_by_role("alert").locator("[lang=en]").inner_text() == refused["error"]["text"]
    context.close()


def test_what_is_done_on_german_pages_is_german(browser: Any, workbench: tuple[Path, int]) -> None:
    """Reasons of a grading, findings and progress of a campaign; nothing is left that is said to be English."""
    _, port = workbench
    context = browser.new_context(viewport={"width": 1280, "height": 720}, locale="de-DE")
    context.set_default_timeout(120_000)
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}")
    page.goto(f"http://127.0.0.1:{port}/#/inspection")
    page.wait_for_selector("html[data-ready=inspection]")
    page.get_by_text("Keine Messung zur Hand? Eine Prüfung simulieren").click()
    page.get_by_role("button", name="Prüfung simulieren").click()
    page.get_by_text("simulated.csv wurde gespeichert.").wait_for()
    page.get_by_role("link", name="Auswerten").click()
    page.locator("select:has(option[value='simulated.csv'])").first.wait_for()
    assert page.get_by_label("Sprache des Protokolls").input_value() == "de"
    page.get_by_role("button", name="Auswerten und bewerten").click()
    page.get_by_role("region", name="Räder").get_by_text(
        "grün, über dem Bestbereich"
    ).first.wait_for()
    why = page.locator("details", has_text="Gründe")
    why.locator("summary").click()
    told = why.get_by_text(
        re.compile(r"^links: Kleinster Phasenwinkel \(EGEA\) [\d,]+° ± [\d,]+°: ausreichend")
    )
    told.get_by_text(
        "(ab 35°), bestanden. Grenzwerte: EGEA SPECSUS2018, absolutes Kriterium"
    ).wait_for()
    why.get_by_text("Unterschied links zu rechts, relative Kraftamplitude").wait_for()
    assert why.locator("[lang=en]").all_inner_texts() == []

    page.goto(f"http://127.0.0.1:{port}/#/campaign")
    page.wait_for_selector("html[data-ready=campaign]")
    page.get_by_text("Noch keine Kampagne in diesem Projekt.").wait_for()
    page.get_by_role("button", name="In dieses Projekt kopieren").click()
    page.get_by_role("button", name="Kampagne durchführen").click()
    page.get_by_role("heading", name="Antwort").wait_for()
    page.get_by_text("1 von 2 gültig").wait_for()
    page.get_by_text(
        re.compile(r"^Versuch 4 \(zurückgehalten\), 1.97 m/s, Straße B10: teil")
    ).wait_for()
    page.get_by_role("button", name="Befunde").click()
    careful = page.locator("li:visible", has_text="kein Intervall mit Modellfehler").first
    careful.wait_for()
    assert careful.locator("[lang=en]").all_inner_texts() == [
        "stiffness, damping and friction: intervals"
    ]  # the name that the campaign's file gives its update; the sentence itself is German
    assert page.get_by_text("Prüfstandsmessungen kennzeichnen").get_attribute("lang") is None
    context.close()
