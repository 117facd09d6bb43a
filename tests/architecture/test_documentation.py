"""What the documentation says is true: its blocks run, every command is described, the schemas are up to date."""

from __future__ import annotations

import contextlib
import inspect
import io
import re
import shlex
import tomllib
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path
from types import ModuleType

import pytest
import yaml

import jounce
from jounce.cli import main
from jounce.core.kinds import Rows
from jounce.web.command import serve  # noqa: F401 - its import adds `jounce serve`, as in the program
from rules.schemas import schema_problems

ROOT = Path(__file__).parents[2]
PAGES = {
    str(page.relative_to(ROOT)): page
    for page in (ROOT / "README.md", *sorted((ROOT / "docs").glob("**/*.md")))
    if page.parent.name
    not in {"_generated", "api", "keys"}  # written when the documentation is built
}
BLOCK = re.compile(
    r"^```(python|toml|console|\{code-cell\} ipython3)\n(.*?)^```$", re.MULTILINE | re.DOTALL
)
OPTIONS = re.compile(r"---\n.*?^---\n|(?::[^\n]*\n)+", re.MULTILINE | re.DOTALL)  # of a cell
FILE = re.compile(r"# file: (\S+)\n")
ELSEWHERE = ("jounce demo",)  # takes half a minute; tests/recovery runs the same


def blocks(page: Path) -> list[tuple[str, str]]:
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def is_run_elsewhere(name: str) -> bool:
    """Whether CI runs a page anyhow: building the documentation runs notebooks, and one has this page's campaign."""
    kinds = {kind for kind, _ in blocks(PAGES[name])}
    return kinds == {"{code-cell} ipython3"} or name == "docs/how-to/campaign.md"


def expanded(word: str) -> list[str]:
    return sorted(str(path) for path in Path().glob(word)) if "*" in word else [word]


def answer(command: str) -> tuple[int, str]:
    """Exit code and everything that a command prints."""
    words = [name for word in shlex.split(command)[1:] for name in expanded(word)]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        code = main(words)
    return code, printed.getvalue()


def squeezed(text: str) -> str:
    return " ".join(text.split())


def run_console(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run the commands of a block; a line under a command must be in what it prints, spaces apart; ... is anything."""
    printed = ""
    for line in text.splitlines():
        if not line.startswith("$ "):
            shown = ".*?".join(re.escape(squeezed(part)) for part in line.split("..."))
            assert re.search(shown, printed), f"{line}\nnot in\n{printed}"
            continue
        command, _, code = line[2:].partition("  # exit code ")
        if command.startswith(ELSEWHERE):
            continue
        if command.startswith("cd "):
            monkeypatch.chdir(command[3:])
            continue
        assert command.startswith("jounce "), command
        found, output = answer(command)
        printed = squeezed(output)
        assert found == int(code or 0), output


def run_page(page: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    """Run all blocks of a page in order, in the current folder; give how many there were."""
    names: dict[str, object] = {}
    count = 0
    for kind, text in blocks(page):
        file = FILE.match(text)
        if kind not in {"console", "toml"}:
            options = OPTIONS.match(text) if kind != "python" else None
            code = compile(
                text[options.end() if options else 0 :], str(page), "exec", dont_inherit=True
            )
            with contextlib.redirect_stdout(io.StringIO()):
                exec(code, names)  # noqa: S102 - our own pages
        elif kind == "console":
            run_console(text, monkeypatch)
        elif file:
            Path(file[1]).write_text(text, encoding="utf-8")
        count += 1
    return count


@pytest.fixture
def _shipped_rows_after(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """What a page adds to registries is no other test's: they compare these with what is written."""
    added, add = [], Rows.add
    monkeypatch.setattr(
        Rows, "add", lambda self, name, row: added.append((self, name)) or add(self, name, row)
    )
    yield
    for rows, name in added:
        if not rows._rows[name].__module__.startswith("jounce"):
            del rows._rows[name]


@pytest.mark.pages
@pytest.mark.usefixtures("_shipped_rows_after")
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] if is_run_elsewhere(name) else [])
        for name, page in PAGES.items()
        if blocks(page)
    ],
)
def test_blocks_run(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    monkeypatch.setattr("webbrowser.open", lambda _: True)  # no window for `jn.plots.show`
    assert run_page(PAGES[name], monkeypatch) > 0


@pytest.mark.parametrize(
    "text",
    [
        "```python\nassert 1 == 2\n```\n",
        "```{code-cell} ipython3\nassert 1 == 2\n```\n",
        "```{code-cell} ipython3\n:tags: [hide-input]\nassert 1 == 2\n```\n",
        "```{code-cell} ipython3\n---\nmystnb:\n  image:\n    alt: a line\n---\nassert 1 == 2\n```\n",
        "```console\n$ jounce version\n python 2.7\n```\n",
        "```console\n$ jounce bench spede\n```\n",
        "```console\n$ jounce version  # exit code 1\n```\n",
        "```console\n$ rm -r somewhere\n```\n",
    ],
)
def test_untrue_blocks_are_rejected(text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    page = tmp_path / "page.md"
    page.write_text(text, encoding="utf-8")
    with pytest.raises(AssertionError):
        run_page(page, monkeypatch)


DRAWS = re.compile(
    r"^(figure|jn\.plots\.\w+\(.*\)|inspection_curves\(.*\)|sensitivity_bars\(.*\)|Image\(.*\))$"
)


def cell_problems(text: str) -> list[str]:
    """What is wrong with the options of a notebook's cell, which are YAML, and with the words for its picture."""
    options = OPTIONS.match(text)
    head = options[0] if options else ""
    try:
        table = yaml.safe_load(head.strip("-\n").replace("\n:", "\n").removeprefix(":")) or {}
        words = table.get("mystnb", {}).get("image", {}).get("alt", "")
    except (yaml.YAMLError, AttributeError) as error:
        return [f"options: {error}"]
    draws = DRAWS.match(text.rstrip().splitlines()[-1])
    return (
        ["a picture without words for those who do not see it"] if draws and len(words) < 20 else []
    )


@pytest.mark.parametrize(
    "name", [name for name, page in PAGES.items() if "{code-cell}" in page.read_text("utf-8")]
)
def test_pictures_of_notebooks_have_words(name: str):
    cells = [text for kind, text in blocks(PAGES[name]) if kind.startswith("{")]
    assert len(cells) > 3
    assert [problem for text in cells for problem in cell_problems(text)] == []


def test_pictures_without_words_are_found():
    assert cell_problems("jn.plots.show(run)\n") == [
        "a picture without words for those who do not see it"
    ]
    assert cell_problems(":tags: [wrap]\n\nfigure\n") == [
        "a picture without words for those who do not see it"
    ]
    (problem,) = cell_problems("---\nmystnb:\n  image:\n    alt: One: two\n---\nfigure\n")
    assert problem.startswith("options")
    assert (
        cell_problems(
            "---\nmystnb:\n  image:\n    alt: A curve that falls, and one that rises.\n---\nfigure\n"
        )
        == []
    )
    assert cell_problems(":tags: [wrap]\n\nprint(1)\n") == []


def test_readme_and_the_pages_about_use_hold_blocks():
    for name in (
        "README.md",
        *(f"docs/how-to/{page}.md" for page in ("campaign", "roads", "bench")),
        *(f"docs/reference/{page}.md" for page in ("rig", "vehicle", "command-line")),
    ):
        assert blocks(PAGES[name]), name


def test_every_page_is_in_the_table_of_contents():
    pages = {
        name.removeprefix("docs/").removesuffix(".md") for name in PAGES if name.startswith("docs/")
    }
    listed = {"index"}
    for index in (ROOT / "docs").glob("**/index.md"):
        folder = index.parent.relative_to(ROOT / "docs")
        trees = re.findall(
            r"^```{toctree}\n(.*?)^```$", index.read_text(encoding="utf-8"), re.M | re.S
        )
        listed |= {
            (folder / line).as_posix()
            for tree in trees
            for line in tree.split()
            if not line.startswith(":")
        }
    assert pages - listed == set()


def test_every_picture_is_in_the_gallery():
    text = PAGES["docs/reference/gallery.md"].read_text(encoding="utf-8")
    blank = {
        "new_figure",
        "figure_of",
        "show",
    }  # nothing on it, and those that choose one of the others
    draw = {
        name
        for name in jounce.plots.__all__
        if inspect.isfunction(one := getattr(jounce.plots, name))
        and str(inspect.signature(one).return_annotation) in {"Figure", "dict[str, Figure]"}
    }
    assert len(draw) > 20
    for name in draw - blank:
        block = text.partition(f"jn.plots.{name}(")[2].partition("```{drawn} gallery-")[2]
        assert block.split("\n")[0] == name, name


def test_pictures_say_what_they_show():
    """Those who do not see a picture read its text."""
    for name, page in PAGES.items():
        text = page.read_text(encoding="utf-8")
        for alt in re.findall(r"^!\[([^\]]*)\]\(", text, re.MULTILINE):
            assert len(alt) > 10, (name, alt)
        for block in re.findall(
            r"^```\{(?:drawn|image|figure)\} [^\n]*\n(.*?)^```$", text, re.MULTILINE | re.DOTALL
        ):
            alt = re.search(r"^:alt: (.+)$", block, re.MULTILINE)
            assert alt is not None, (name, block)
            assert len(alt[1]) > 10, (name, block)


def test_files_that_pages_name_exist():
    """What holds a part of the theory is a test of today."""
    for name, page in PAGES.items():
        if name == "docs/reference/changelog.md":
            continue
        for file in re.findall(
            r"`((?:tests|docs)/[\w/-]+\.(?:py|md|json))", page.read_text(encoding="utf-8")
        ):
            assert (ROOT / file).is_file(), (name, file)


@pytest.mark.parametrize("name", jounce.__all__)
def test_docstrings_have_no_bars_outside_code(name: str):
    """Sphinx takes ``|v|`` for the name of a substitution."""
    text = re.sub(
        r"``.*?``|^ *>>>.*$", "", inspect.getdoc(getattr(jounce, name)) or "", flags=re.M | re.S
    )
    assert not re.findall(r"(?<![\w|])\|\w[^|\n]*\|", text)


@pytest.fixture(scope="module")
def faces() -> ModuleType:
    """The script that writes what the registries say."""
    import make_faces

    return make_faces


def test_every_command_has_its_reference_and_examples(faces: ModuleType):
    text = PAGES["docs/reference/command-line.md"].read_text(encoding="utf-8")
    for command, reference in faces.commands().items():
        assert reference.strip(), command
        section = text.split(f"## `{command}`\n")[1].split("\n## ")[0]
        assert f"```{{include}} /_generated/{command.replace(' ', '-')}.md\n```" in section
        assert f"$ {command}" in section
    assert text.count("\n## ") == len(faces.commands())


def test_help_shows_every_command_with_an_example(faces: ModuleType):
    for command in faces.commands():
        *group, word = command.split()
        code, shown = answer(" ".join([*group, "--help"]))
        assert code == 0
        assert re.search(rf"^\W*{word}\b", shown, re.MULTILINE)
        code, shown = answer(f"{command} --help")
        assert code == 0
        assert f"Example: {command}" in squeezed(shown)


def test_written_faces_are_what_the_registries_say(faces: ModuleType):
    pinned = re.search(
        r"^pydantic==(\S+)", (ROOT / "requirements" / "runtime.txt").read_text(), re.MULTILINE
    )
    if pinned is None or metadata.version("pydantic") != pinned[1]:
        pytest.skip("other versions of pydantic write schemas in other words")
    for file, text in faces.committed().items():
        assert file.read_text(encoding="utf-8") == text, (
            f"{file.name} is out of date: run `make faces`"
        )


def test_tables_have_rows_and_a_page(faces: ModuleType):
    pages = "".join(page.read_text(encoding="utf-8") for page in PAGES.values())
    for name, text in faces.tables().items():
        assert text.count("\n") > 3
        assert len({line.count("|") - line.count("\\|") for line in text.splitlines()}) == 1
        assert f"```{{include}} /_generated/{name}\n```" in pages


FILES = {
    "rig": "jounce.rig/",
    "vehicle": "jounce.vehicle/",
    "campaign": "jounce.campaign/",
    "control": "jounce.control/",
    "tester": "jounce.tester/",
    "limits": "jounce.limits/",
}
SHIPPED = [
    file for folder in ("src", "tests", "docs") for file in sorted((ROOT / folder).rglob("*.toml"))
]


def schema_of(file: Path) -> str | None:
    """Name of the schema that a shipped file follows; none for files that are wrong on purpose or of another kind."""
    try:
        table = tomllib.loads(file.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError):
        return None
    return next(
        (name for name, start in FILES.items() if str(table.get("schema", "")).startswith(start)),
        None,
    )


@pytest.mark.parametrize(
    "file", [file for file in SHIPPED if schema_of(file)], ids=lambda file: file.stem
)
def test_shipped_files_follow_their_schemas(faces: ModuleType, file: Path):
    table = tomllib.loads(file.read_text(encoding="utf-8"))
    assert schema_problems(table, faces.SCHEMAS / f"{schema_of(file)}.schema.json") == []


@pytest.mark.parametrize(
    ("table", "problem"),
    [
        (
            {
                "schema": "jounce.campaign/1",
                "rig": "x",
                "trial": [],
                "roads": {"A": {"kind": "half-sin"}},
            },
            "roads.A",
        ),
        ({"schema": "jounce.campaign/1", "rig": "x", "trials": []}, "trial"),
        ({"schema": "jounce.campaign/2", "rig": "x", "trial": []}, "schema"),
    ],
)
def test_mistakes_are_seen_by_the_schemas(
    faces: ModuleType, table: dict[str, object], problem: str
):
    found = schema_problems(table, faces.SCHEMAS / "campaign.schema.json")
    assert any(line.startswith(problem) for line in found), found
