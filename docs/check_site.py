"""What the built site must keep to: links and pictures that are there, nothing from a network, texts of pictures, size.

``python docs/check_site.py docs/_build/html`` runs behind every build. With ``--browser`` (needs Playwright, Chromium)
every page is opened on a phone's width, too: nothing may scroll sideways, no page may take longer than a second to be
readable.
"""

from __future__ import annotations

import sys
import time
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlparse

LARGEST = 40e6  # bytes, without what Sphinx keeps for itself
SLOWEST = 1.0  # s, until a page is laid out
PHONE = {"width": 390, "height": 844}


class Page(HTMLParser):
    """Targets, links, and what is loaded, of one page."""

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
    """Every link to nowhere, load from a network, picture without a text, and a site that is too large."""
    files = [file for file in sorted(site.rglob("*")) if file.is_file() and ".doctrees" not in file.parts]
    pages = {file: Page(file.read_text(encoding="utf-8")) for file in files if file.suffix == ".html"}
    found = []
    for file, page in pages.items():
        name = file.relative_to(site).as_posix()
        found += [f"{name}: loads {load} from a network" for load in page.loads if urlparse(load).netloc]
        found += [f"{name}: picture without a text: {source}" for source in page.bare]
        for link in [*page.links, *(load for load in page.loads if not load.startswith("data:"))]:
            address = urlparse(link)
            if address.scheme or address.netloc:
                continue
            target = (file.parent / unquote(address.path)).resolve() if address.path else file
            if not target.exists():
                found.append(f"{name}: {link} leads nowhere")
            elif address.fragment and target in pages and unquote(address.fragment) not in pages[target].ids:
                found.append(f"{name}: {link}: no such place on that page")
    size = sum(file.stat().st_size for file in files)
    if size > LARGEST:
        found.append(f"the site has {1e-6 * size:.0f} MB, allowed are {1e-6 * LARGEST:.0f} MB")
    print(f"{len(pages)} pages, {1e-6 * size:.1f} MB")
    return found


def seen_on_a_phone(site: Path) -> list[str]:
    """What scrolls sideways, and what is slow."""
    import shutil

    from playwright.sync_api import sync_playwright

    found, slowest = [], (0.0, "")
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        view = browser.new_page(viewport=PHONE)
        for file in sorted(site.rglob("*.html")):
            name = file.relative_to(site).as_posix()
            begun = time.perf_counter()
            view.goto(file.as_uri(), wait_until="domcontentloaded")
            wide = view.evaluate("document.documentElement.scrollWidth - window.innerWidth")
            took = time.perf_counter() - begun
            slowest = max(slowest, (took, name))
            if wide > 1:
                found.append(f"{name}: scrolls sideways by {wide} px at {PHONE['width']} px")
            if took > SLOWEST:
                found.append(f"{name}: {took:.1f} s until it can be read")
        browser.close()
    print(f"slowest page: {slowest[1]}, {slowest[0]:.2f} s until it can be read")
    return found


if __name__ == "__main__":
    folder = Path(sys.argv[1]).resolve()
    told = problems(folder) + (seen_on_a_phone(folder) if "--browser" in sys.argv else [])
    print("\n".join(told))
    sys.exit(bool(told))
