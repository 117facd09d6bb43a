"""What comes with an extra is asked for by ``require``, which names the extra that brings it; the README lists it."""

from __future__ import annotations

import ast
import re
import sys

from rules import CONFIGURATION, ROOT, SOURCE

PROJECT = CONFIGURATION["project"]


def names(requirements: list[str]) -> set[str]:
    return {re.split(r"[<>=!~\[; ]", one)[0].lower().replace("-", "_") for one in requirements}


EXTRAS = {extra: names(wanted) for extra, wanted in PROJECT["optional-dependencies"].items()}
CORE = names(PROJECT["dependencies"]) | {
    "markupsafe",
    "pandas",
    "pil",
    "pydantic_core",
}  # what some of them need
NOTEBOOK = {
    "ipython",
    "pyinstaller",
}  # only looked for, where a notebook runs, or which runs our hook itself
FILES = {
    str(file.relative_to(SOURCE)): file.read_text(encoding="utf-8")
    for file in sorted(SOURCE.rglob("*.py"))
}
_ASKED = re.compile(rf'(?<!old_argument)\("([\w.]+)", "({"|".join(EXTRAS)})"\)')


def imported(source: str) -> set[str]:
    """Packages that a module imports, wherever in it; those of Python and our own are left out."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {one.name.partition(".")[0] for one in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            found.add(node.module.partition(".")[0])
    return {name.lower() for name in found - {"jounce"} - set(sys.stdlib_module_names)}


def unasked(source: str) -> set[str]:
    """Packages of an extra that a module imports without asking for them, or for a package that brings them."""
    asked = {package.partition(".")[0].lower() for package, _ in _ASKED.findall(source)}
    brought = {"anywidget": {"traitlets"}}
    known = asked | {one for name in asked for one in brought.get(name, ())}
    return imported(source) - CORE - NOTEBOOK - known


def test_a_package_of_an_extra_is_asked_for_where_it_is_imported() -> None:
    files = {
        name: source for name, source in FILES.items() if not name.startswith("kernel/loops/")
    }  # Numba's own
    assert {name: found for name, source in files.items() if (found := unasked(source))} == {}


def test_an_import_without_asking_is_found() -> None:
    assert unasked("import numpy\nfrom sqlalchemy.engine import make_url") == {"sqlalchemy"}
    assert (
        unasked('require("sqlalchemy", "store")\nfrom sqlalchemy.engine import make_url') == set()
    )


def test_the_page_on_sizes_says_what_each_dependency_is_for() -> None:
    page = (ROOT / "docs" / "explanation" / "benchmarks.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(\w+)` \| (.+?) \| \d+ \| \d+ \|$", page, re.MULTILINE)
    assert {name for name, _ in rows} == names(PROJECT["dependencies"])
    assert len(rows) == len(PROJECT["dependencies"])


def test_nobody_is_told_to_install_jounce_by_a_name_that_no_index_has() -> None:
    by_name = re.compile(r"""pip install ['"]?jounce\b(?!-)|['"]jounce\[""")
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *ROOT.glob("docs/**/*.md")]
    texts = FILES | {
        str(file.relative_to(ROOT)): file.read_text(encoding="utf-8") for file in pages
    }
    assert {name: found for name, text in texts.items() if (found := by_name.findall(text))} == {}
    assert by_name.findall("pip install 'jounce[pdf]' or pip install jounce==1, 'jounce[io]'") == [
        "pip install 'jounce", "pip install jounce", "'jounce[",
    ]  # fmt: skip
    assert by_name.findall("pip install 'jounce-0.1.0-py3-none-any.whl[pdf]'") == []


def test_the_extra_that_is_named_brings_the_package() -> None:
    asked = {pair for source in FILES.values() for pair in _ASKED.findall(source)}
    assert len(asked) > 10
    assert {
        pair
        for pair in asked
        if pair[0].partition(".")[0].lower() not in EXTRAS[pair[1]] | {"json"}
    } == set()
    assert {extra for _, extra in asked} | {"fmu", "postgresql"} == set(
        EXTRAS
    )  # whose packages are only looked for


def test_the_readme_lists_every_extra() -> None:
    table = (
        (ROOT / "README.md")
        .read_text(encoding="utf-8")
        .partition("## Extras")[2]
        .partition("\n## ")[0]
    )
    assert set(re.findall(r"`(\w+)`", re.sub(r"(?m)^(?!\|).*$", "", table))) == set(EXTRAS)
