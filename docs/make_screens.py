"""Pictures of the workbench for the documentation: ``make screens``, with an installed Chromium.

They are committed, so a build of the pages needs no browser.
"""

from __future__ import annotations

import io
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import jounce as jn

FIGURES = Path(__file__).parent / "figures"
LIBRARY = Path(jn.__file__).parent / "parts" / "library"
SIZE = {"width": 1280, "height": 760}
FIRST_ANSWER = 120_000  # ms; a model may have to be compiled
STILL = 1500  # ms, in which what moves comes to rest
PAGES = ("kinematics", "trial")


def write() -> None:
    """Open each page in both colour schemes, perform the shown steps, and save the picture."""
    from PIL import Image
    from playwright.sync_api import sync_playwright

    browser_file = shutil.which("chromium") or shutil.which("google-chrome")
    with tempfile.TemporaryDirectory() as place, sync_playwright() as playwright:
        folder = Path(place) / "race-car"
        folder.mkdir()
        shutil.copy(LIBRARY / "formula-student-front.toml", folder / "front.toml")
        command = [sys.executable, "-m", "jounce", "serve", str(folder), "--no-open", "--json"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
            assert server.stdout is not None
            address = json.loads(server.stdout.readline())["url"]
            browser = playwright.chromium.launch(
                executable_path=browser_file, args=["--no-sandbox"]
            )
            for scheme in ("light", "dark"):
                context = browser.new_context(viewport=SIZE, color_scheme=scheme, locale="en-GB")
                page = context.new_page()
                page.goto(address)
                page.wait_for_selector("html[data-ready]")
                for name in PAGES:
                    for there in (
                        "project",
                        f"{name}?rig=front.toml",
                    ) * 2:  # the first time compiles, and says how long
                        page.goto(f"{address.partition('?')[0]}#/{there}")
                        if there != "project":
                            page.get_by_text("computed and drawn in").wait_for(timeout=FIRST_ANSWER)
                    SHOWN[name](page)
                    page.wait_for_timeout(STILL)
                    with Image.open(
                        io.BytesIO(page.screenshot())
                    ) as picture:  # 256 colours: a third of the bytes
                        few = (
                            Image.Quantize.MAXCOVERAGE
                        )  # which keeps the colours of thin rods apart
                        picture.convert("RGB").quantize(
                            method=few, kmeans=3, dither=Image.Dither.NONE
                        ).save(FIGURES / f"workbench-{name}-{scheme}.png", optimize=True)
                context.close()
            browser.close()
            server.terminate()


def _in_bump(page: Any) -> None:
    page.get_by_label("Wheel travel, bump positive [mm], typed").fill("25")


def _softer(page: Any) -> None:
    page.get_by_label("Height").fill("30 mm")
    page.get_by_label("Length").fill("300 mm")
    page.get_by_label("strut.damper.rebound_coefficient [N·s/m], typed").fill("900")
    page.wait_for_timeout(STILL)
    page.locator(".u-over").first.hover(position={"x": 16, "y": 40})


SHOWN = {"kinematics": _in_bump, "trial": _softer}

if __name__ == "__main__":
    write()
