"""Check the built site: links, pictures and their alternative texts, no network requests, size.

``python docs/check_site.py docs/_build/html`` runs after every build. With ``--browser`` (``make check-docs``; needs
Playwright, Chromium) every page is opened on a phone's width, too: nothing may scroll sideways, no page may take longer
than a second to be readable; and what readers ask is searched for, without a network: the page that answers is to be
among the first three.
"""

from __future__ import annotations

import shutil
import sys
import time
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import quote, unquote, urlparse

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
LARGEST = 40e6  # bytes, without what Sphinx keeps for itself
SLOWEST = 1.0  # s, until a page is laid out
PHONE = {"width": 390, "height": 844}
QUESTIONS = {
    "sign of damper": "how-to/wrong-sign",
    "Zarr": "how-to/variants",
    "Simulink": "how-to/fmu-to-simulink",
    "own controller": "how-to/write-a-controller",
    "cluster": "how-to/run-on-our-cluster",
    "EUSAMA limits": "how-to/inspection-grading",
    "limits file": "how-to/grade-a-fleet",
    "decimal comma": "how-to/read-our-files",
    "MATLAB file": "how-to/read-our-files",
    "bump steer": "how-to/reduce-bump-steer",
    "roll centre": "how-to/kinematics",
    "motion ratio": "how-to/kinematics",
    "install": "tutorials/first-steps",
    "inches": "how-to/change-units",
    "FMU": "how-to/exchange",
    "trial does not hold": "how-to/trial-does-not-hold",
    "posterior": "tutorials/many-runs",
    "robust design": "tutorials/many-runs",
    "anti-roll bar": "how-to/vehicle-3d",
    "damper curve": "how-to/give-a-damper-curve",
    "road profile": "how-to/roads",
    "ISO 2631 comfort": "how-to/ride",
    "jupyter notebook": "how-to/notebooks",
    "hardpoints CAD": "how-to/hardpoints-from-cad",
}
"""What readers type, and the page that answers."""


class Page(HTMLParser):
    """Targets, links and loaded files of one page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.bare: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        has = {name: value or "" for name, value in attrs}
        self.ids |= {has[name] for name in ("id", "name") if has.get(name)}
        if tag == "a" and has.get("href"):
            self.links.append(has["href"])
        if tag in {"script", "img", "iframe", "source"} and has.get("src"):
            self.loads.append(has["src"])
        if tag == "link" and has.get("rel") in {"stylesheet", "icon", "preload"}:
            self.loads.append(has["href"])
        if tag == "img" and not has.get("alt"):
            self.bare.append(has.get("src", "?"))


def problems(site: Path) -> list[str]:
    """List broken links, network requests, pictures without alternative text, and an excessive size."""
    files = [
        file for file in sorted(site.rglob("*")) if file.is_file() and ".doctrees" not in file.parts
    ]
    pages = {
        file: Page(file.read_text(encoding="utf-8")) for file in files if file.suffix == ".html"
    }
    found = []
    for file, page in pages.items():
        name = file.relative_to(site).as_posix()
        found += [
            f"{name}: loads {load} from a network" for load in page.loads if urlparse(load).netloc
        ]
        found += [f"{name}: picture without a text: {source}" for source in page.bare]
        for link in [*page.links, *(load for load in page.loads if not load.startswith("data:"))]:
            address = urlparse(link)
            if address.scheme or address.netloc:
                continue
            target = (file.parent / unquote(address.path)).resolve() if address.path else file
            if not target.exists():
                found.append(f"{name}: {link} leads nowhere")
            elif (
                address.fragment
                and target in pages
                and unquote(address.fragment) not in pages[target].ids
            ):
                found.append(f"{name}: {link}: no such place on that page")
    size = sum(file.stat().st_size for file in files)
    if size > LARGEST:
        found.append(f"the site has {1e-6 * size:.0f} MB, allowed are {1e-6 * LARGEST:.0f} MB")
    print(f"{len(pages)} pages, {1e-6 * size:.1f} MB")
    return found


def seen_on_a_phone(site: Path) -> list[str]:
    """List pages that scroll sideways or load slowly."""
    from playwright.sync_api import sync_playwright

    found, slowest = [], (0.0, "")
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        view = browser.new_page(viewport=PHONE)
        for file in sorted(site.rglob("*.html")):
            name = file.relative_to(site).as_posix()
            took = wide = float("inf")
            for attempt in range(
                5
            ):  # where the machine was busy with something else, again, a little later
                time.sleep(1.0 if attempt else 0.0)
                begun = time.perf_counter()
                view.goto(file.as_uri(), wait_until="domcontentloaded")
                wide = view.evaluate("document.documentElement.scrollWidth - window.innerWidth")
                took = min(took, time.perf_counter() - begun)
                if took < SLOWEST:
                    break
            slowest = max(slowest, (took, name))
            if wide > 1:
                found.append(f"{name}: scrolls sideways by {wide} px at {PHONE['width']} px")
            if took > SLOWEST:
                found.append(f"{name}: {took:.1f} s until it can be read")
        browser.close()
    print(f"slowest page: {slowest[1]}, {slowest[0]:.2f} s until it can be read")
    return found


def not_found(site: Path) -> list[str]:
    """List questions whose page is not among the first three results of the offline search."""
    from playwright.sync_api import sync_playwright

    found = []
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        view = browser.new_context(offline=True).new_page()
        for question, page in QUESTIONS.items():
            view.goto(f"{(site / 'search.html').as_uri()}?q={quote(question)}")
            view.wait_for_function(
                "/finished|did not match/.test(document.querySelector('#search-results').innerText)"
            )
            links = view.eval_on_selector_all(
                "#search-results li > a",
                "links => links.slice(0, 3).map(link => link.getAttribute('href'))",
            )
            if page not in {link.partition(".html")[0] for link in links}:
                found.append(
                    f"search for {question!r}: {page} is not among the first three, which are {links}"
                )
        browser.close()
    print(
        f"{len(QUESTIONS) - len(found)} of {len(QUESTIONS)} questions find their page among the first three"
    )
    return found


if __name__ == "__main__":
    folder = Path(sys.argv[1]).resolve()
    told = problems(folder)
    if "--browser" in sys.argv and CHROMIUM:
        told += seen_on_a_phone(folder) + not_found(folder)
    elif "--browser" in sys.argv:
        print("Chromium is not installed: no page of the documentation was opened")
    print("\n".join(told))
    sys.exit(bool(told))
