"""The protocol of an inspection leaves the page as PDF, and opens again from the store."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.pages
TOKEN = "a-token-of-protocols"


def saved(page: Any) -> bytes:
    """Save the last protocol of the page as PDF."""
    with page.expect_download() as download:
        page.get_by_role("button", name="Export as PDF").last.click()
    return Path(download.value.path()).read_bytes()


def test_a_protocol_is_saved_stored_and_opened_again(
    browser: Any, workbench: tuple[Path, int]
) -> None:
    pytest.importorskip("typst")
    folder, port = workbench
    (folder / "spring.csv").write_text("displacement [mm],force [N]\n1,2\n")
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    context.set_default_timeout(120_000)
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}#/inspection")
    page.get_by_text("Records that are not of a tester (").click()
    page.get_by_text("no plate force in its first line: displacement [mm],force [N]").wait_for()
    page.get_by_role("button", name="offer: spring.csv").click()
    assert page.get_by_label("Record of one axle").input_value() == "spring.csv"
    page.get_by_text("No record available? Simulate a test").click()
    page.get_by_role("button", name="Simulate the test").click()
    page.get_by_role("link", name="Evaluate").click()
    page.locator("select:has(option[value='simulated.csv'])").first.wait_for()
    page.get_by_label("Number plate").first.fill("B-AB 123")
    page.get_by_label("Save in the store").fill("lane.sqlite")
    page.get_by_role("button", name="Evaluate and grade").click()
    page.get_by_role("heading", name="Test report").wait_for()
    assert saved(page).startswith(b"%PDF")
    page.get_by_role("button", name="Search", exact=True).click()
    page.get_by_role("button", name="protocol of record 1").click()
    page.get_by_role("heading", name="Protocol of record 1").wait_for()
    assert saved(page).startswith(b"%PDF")
    page.get_by_role("button", name="history of B-AB 123").click()
    page.get_by_role("heading", name="History of B-AB 123").wait_for()
    assert page.get_by_role("button", name="protocol of record 1").count() == 2
    context.close()
