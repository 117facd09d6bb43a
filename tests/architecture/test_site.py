"""The checks of the built documentation notice what they are for, and pages are written in British spelling."""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from types import ModuleType

import pytest

import jounce
from rules import ROOT

GOOD = '<html><body><h1 id="top">a</h1><a href="#top">b</a><a href="other.html#x">c</a><img src="p.svg" alt="p"></body>'


@pytest.fixture(scope="module")
def check() -> ModuleType:
    import check_site

    return check_site


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "index.html").write_text(GOOD, encoding="utf-8")
    (tmp_path / "other.html").write_text(
        '<p id="x">d</p><script src="index.html"></script>', encoding="utf-8"
    )
    (tmp_path / "p.svg").write_text("<svg/>", encoding="utf-8")
    return tmp_path


def test_a_sound_site_has_no_problems(check: ModuleType, site: Path) -> None:
    assert check.problems(site) == []


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("#top", "#bottom", "no such place"),
        ("other.html#x", "gone.html", "leads nowhere"),
        ('src="p.svg"', 'src="gone.svg"', "leads nowhere"),
        ('alt="p"', 'alt=""', "picture without a text"),
        ('src="p.svg"', 'src="https://example.org/p.svg"', "from a network"),
    ],
)
def test_what_is_wrong_is_told(
    check: ModuleType, site: Path, old: str, new: str, said: str
) -> None:
    (site / "index.html").write_text(GOOD.replace(old, new), encoding="utf-8")
    assert any(said in problem for problem in check.problems(site))


def test_a_site_that_is_too_large_is_told(
    check: ModuleType, site: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(check, "LARGEST", 10.0)
    assert any("MB, allowed are" in problem for problem in check.problems(site))


ADDRESS = re.compile(r"https?://[^\s)>}\"'`\]]+")
DOI = re.compile(r"10\.\d{4,9}/[-._;()/:A-Za-z0-9]*[A-Za-z0-9)]")


def address_problems(text: str) -> list[str]:
    """Addresses and DOIs that cannot be right, whatever answers there."""
    found = [
        f"DOI {doi!r}"
        for doi in re.findall(r"^ *doi *= *\{(.*?)\}", text, re.MULTILINE)
        if not DOI.fullmatch(doi)
    ]
    for address in ADDRESS.findall(text):
        host = address.partition("://")[2].partition("/")[0]
        is_own = host.partition(":")[0] in {"127.0.0.1", "localhost"}
        if not is_own and (
            not address.startswith("https://") or not re.fullmatch(r"[\w-]+(\.[\w-]+)+", host)
        ):
            found.append(address)
        if re.search(
            r"example\.|todo|xxx|your[-_]|placeholder|web\.archive", address, re.IGNORECASE
        ):
            found.append(address)
    return found


@pytest.mark.parametrize(
    "name",
    ["references.bib", "README.md", "CONTRIBUTING.md", "SECURITY.md", "CITATION.cff", "docs"],
)
def test_addresses_have_their_form(name: str) -> None:
    """Whether they answer is asked by `make links`, where there is a network."""
    files = [ROOT / name] if (ROOT / name).is_file() else sorted((ROOT / name).glob("*/*.md"))
    assert [
        (file.name, one)
        for file in files
        for one in address_problems(file.read_text(encoding="utf-8"))
    ] == []


@pytest.mark.parametrize(
    "text",
    [
        "  doi = {https://doi.org/10.1/2}",
        "  doi = {10.1038/}",
        "http://github.com/a",
        "https://example.org/x",
        "https://host/x",
    ],
)
def test_addresses_without_their_form_are_noticed(text: str) -> None:
    assert len(address_problems(text)) >= 1


AMERICAN = re.compile(
    r"\b((?:un)?(?:color\w*|center\w*|centering|fiber\w*|gray\w*|meter|meters|millimeters?|kilometers?|liters?"
    r"|tires?|behavior\w*|neighbor\w*|favor\w*|honor\w*|labor|rigor\b|catalog\b|dialog\b"
    r"|(?:analy|paraly|cataly)z\w+|(?:optimi|normali|linear|minimi|maximi|characteri|organi|recogni|visuali|initiali"
    r"|summari|generali|standardi|synchroni|parametri|regulari|discreti|reali|utili|penali|seriali|factori|locali|speciali)"
    r"z(?:e[sd]?|ing|ations?|er)|modeling|modeled|labeled|labeling|traveled|traveling|canceled|canceling|signaled|leveled"
    r"|maneuver\w*|defense|offense|artifacts?|skeptic\w*|aluminum|mold\w*|plow\w*|sulfur))\b",
    re.IGNORECASE,
)
MISSPELT = re.compile(
    r"\b(teh|recieve\w*|seperat\w*|occured|occurence\w*|accomodat\w*|definately|untill|wich|thier|adress\w*|succesful\w*"
    r"|begining|dependan\w+|existant|independan\w+|neccess\w+|publically|refered|refering|transfered|wether|lenght\w*|heigth"
    r"|widht|paramter\w*|stiffnes\b|dampling|suspention\w*|frequncy|measurment\w*|calcuat\w*|simulat(?:oin|tion)\w*"
    r"|the the|a a|is is|of of|to to|and and)\b"
)
PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "ARCHITECTURE.md",
    *sorted((ROOT / "docs").glob("**/*.md")),
]


def prose(text: str) -> str:
    """A page without code, addresses and the raw parts of directives."""
    text = re.sub(r"^(```+|:::+).*?^\1\s*$", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"`[^`\n]*`|\]\([^)]*\)|https?://\S+|<!--.*?-->", " ", text, flags=re.DOTALL)
    return re.sub(r"^\s*\$ .*$", "", text, flags=re.MULTILINE)


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_pages_are_in_british_spelling(page: Path) -> None:
    text = prose(page.read_text(encoding="utf-8"))
    found = [match[0] for pattern in (AMERICAN, MISSPELT) for match in pattern.finditer(text)]
    assert found == [], page


@pytest.mark.parametrize("name", jounce.__all__)
def test_docstrings_are_in_british_spelling(name: str) -> None:
    """What the pages of Python names are made of."""
    text = re.sub(
        r"^>>> .*?(?=\n\n|\Z)",
        " ",
        prose(inspect.getdoc(getattr(jounce, name)) or ""),
        flags=re.M | re.S,
    )
    assert [match[0] for pattern in (AMERICAN, MISSPELT) for match in pattern.finditer(text)] == []


@pytest.mark.parametrize(
    "text",
    [
        "The color of it.",
        "We optimize the tire.",
        "a modeled Behavior",
        "the center",
        "They recieve it.",
        "It is is so.",
    ],
)
def test_other_spelling_is_noticed(text: str) -> None:
    assert AMERICAN.search(text) or MISSPELT.search(text)


def test_the_changelog_has_every_heading_once_and_words_under_it() -> None:
    """Merges doubled them."""
    for version in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8").split("\n## ")[1:]:
        parts = version.split("\n### ")[1:]
        headings = [part.partition("\n")[0] for part in parts]
        assert sorted(set(headings)) == sorted(headings)
        assert [part for part in parts if not part.partition("\n")[2].strip()] == []
