"""The page on validation: tables and pictures of comparisons with external sources.

``make validation`` runs those tests and keeps what they found in ``explanation/validation.json``; everything else is
read from the tests as they stand: their marks, and the first lines of the files that hold no outside source.
"""

from __future__ import annotations

import ast
import importlib.util
import json
import re
import sys
import textwrap
from pathlib import Path
from typing import Any

import drawn

ROOT = Path(__file__).resolve().parents[1]
FILE = Path(__file__).parent / "explanation" / "validation.json"
KINDS = {
    "measured": "recordings made by others",
    "published": "numbers that a publication or standard prints, and closed forms of it",
    "program": "another program, not ours",
    "computed": "the source's equations, solved beside jounce by other means for this comparison",
}
COLOURS = {
    "measured": "#d55e00",
    "published": "#0067a8",
    "program": "#00896b",
    "computed": "#9aa1a9",
}
APART = {
    "physics": "Laws and closed forms",
    "agreement": "Models and programs against each other, by our own hand",
    "recovery": "Known truths that must come back",
    "properties": "What must hold for any input",
    "unit": "Parts by themselves",
    "golden": "Golden",
}


def rows() -> list[dict[str, Any]]:
    """Stored comparisons by test."""
    found: list[dict[str, Any]] = json.loads(FILE.read_text(encoding="utf-8"))["tests"]
    return found


def capabilities() -> list[str]:
    """Those that have evidence, in the order of the rules."""
    sys.path.insert(0, str(ROOT / "tests" / "architecture"))
    from rules.evidence import CAPABILITIES

    return [one for one in CAPABILITIES if any(row["of"] == one for row in rows())]


def overview() -> str:
    """Count the tests of each kind for each capability."""
    lines = [f"| | {' | '.join(KINDS)} |", "|---|" + "---:|" * len(KINDS)]
    for name in capabilities():
        counts = [
            sum(row["of"] == name and row["kind"] == kind for row in rows()) for kind in KINDS
        ]
        lines.append(
            f"| [{name}](#{name.replace(' ', '-')}) | {' | '.join(_count(one) for one in counts)} |"
        )
    return "\n".join(lines) + "\n"


def _count(number: int) -> str:
    return "–" if number == 0 else f"{number:,}".replace(",", " ")


def tables() -> str:
    """Write one section per capability: its picture and its tests, the strongest kind first."""
    parts = []
    for name in capabilities():
        word = name.replace(" ", "-")
        alt = f"How much of what is allowed each comparison of {name} takes; the numbers are in the table below"
        parts += [
            f"### {name[0].upper()}{name[1:]}",
            "",
            f"```{{drawn}} validation-{word}",
            f":alt: {alt}",
            "```",
            "",
        ]
        for kind, label in KINDS.items():
            found = [row for row in rows() if row["of"] == name and row["kind"] == kind]
            if found:
                parts += [f"**{kind.capitalize()}**: {label}.", "", _table(found), ""]
    return "\n".join(parts) + "\n"


def _table(found: list[dict[str, Any]]) -> str:
    """The tests of one kind: those of one source and file together."""
    groups: dict[tuple[str, ...], list[dict[str, Any]]] = {}
    for row in sorted(found, key=lambda row: (row["key"], row["test"])):
        file = row["test"].removeprefix("tests/").partition("::")[0]
        groups.setdefault((row["key"], row["where"], row["tolerance"], file), []).append(row)
    parts = []
    for (key, where, tolerance, file), members in groups.items():
        source = f"{{cite}}`{key}`: {where}" if key else where[0].upper() + where[1:]
        parts += [f"{source}. Its tolerance: {tolerance}. `{file}`", ""]
        parts += [
            "| compared | numbers | ours | theirs | of the allowed | s |",
            "|---|---:|---:|---:|---:|---:|",
        ]
        for row in members:
            theirs = (
                "difference"
                if row["theirs"] == 0.0 and row["allowed"] < 0.1
                else _number(row["theirs"])
            )
            values = (
                row["compares"],
                _count(row["values"]),
                _number(row["ours"]),
                theirs,
                _share(row["share"]),
            )
            parts.append(f"| {' | '.join(values)} | {_number(row['seconds'], 1)} |")
        parts.append("")
    return "\n".join(parts)


def _number(value: float, digits: int = 6) -> str:
    """Format a number, with powers of ten if it is very small or large."""
    mantissa, _, power = f"{value:.{digits}g}".partition("e")
    return f"{mantissa} · 10{str(int(power)).translate(_RAISED)}" if power else mantissa


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def _share(share: float) -> str:
    """Share of the tolerance; values below the differences between machines are not distinguished."""
    return "< 2 %" if share < 0.02 else f"{100.0 * share:.0f} %"


def apart() -> str:
    """List the files of tests without an external source, with their first lines and the number of such tests."""
    parts = []
    for folder, label in APART.items():
        parts += [f"### {label}", ""]
        if folder == "unit":
            parts += [
                "Worked out by hand, by brute force, or refused with a reason; `tests/unit`:",
                "",
                *units(),
                "",
            ]
            continue
        lines = ["| file | what it holds | tests |", "|---|---|---:|"]
        for file in sorted((ROOT / "tests" / folder).glob("test_*.py")):
            tree, count = ast.parse(file.read_text(encoding="utf-8")), without_source(file)
            first = (
                (ast.get_docstring(tree) or "")
                .partition("\n\n")[0]
                .replace("\n", " ")
                .replace("|", "\\|")
            )
            lines += [f"| {_named(file)} | {first} | {count} |"] if count else []
        lines += golden_elsewhere() if folder == "golden" else []
        parts += [f"Files `tests/{folder}/test_….py`:", "", *lines, ""]
    return "\n".join(parts) + "\n"


def _named(file: Path) -> str:
    """Name of a test file in separate words, which can wrap on a phone."""
    return file.stem.removeprefix("test_").replace("_", " ")


def without_source(file: Path) -> int:
    """Count the tests of a file that name no external source."""
    outside, path = {row["test"] for row in rows()}, file.relative_to(ROOT).as_posix()
    body = ast.parse(file.read_text(encoding="utf-8")).body
    tests = [
        one.name
        for one in body
        if isinstance(one, ast.FunctionDef) and one.name.startswith("test_")
    ]
    return sum(f"{path}::{name}" not in outside for name in tests)


def golden_elsewhere() -> list[str]:
    """Rows for golden numbers in other folders: the text or comment that starts with *Golden*."""
    found = []
    for file in sorted((ROOT / "tests").rglob("test_*.py")):
        texts = (
            _GOLDEN.findall(file.read_text(encoding="utf-8"))
            if file.parent.name != "golden"
            else []
        )
        folder = file.parent.relative_to(ROOT / "tests").as_posix()
        found += [
            f"| {_named(file)} (in `{folder}`) | {text[0].upper()}{text[1:]} | 1 |"
            for text in texts
        ]
    return found


_GOLDEN = re.compile(r'^\s*(?:"""|# )Golden: ([^\n"]+?)(?:"""|$)', re.MULTILINE)


def units() -> list[str]:
    """One row per package: the number of unit tests without an external source."""
    folders = sorted(
        one for one in (ROOT / "tests" / "unit").iterdir() if any(one.glob("test_*.py"))
    )
    counts = [sum(without_source(file) for file in folder.glob("test_*.py")) for folder in folders]
    rows = [f"| `{folder.name}` | {count} |" for folder, count in zip(folders, counts, strict=True)]
    return ["| package | tests |", "|---|---:|", *rows]


def shares(name: str) -> Any:
    """Draw the share of the tolerance that each comparison of a capability uses."""
    from jounce.plots import new_figure, style

    found = [row for row in rows() if row["of"] == name]
    found.sort(key=lambda row: (-list(KINDS).index(row["kind"]), row["share"]))
    with style():
        figure = new_figure(0.75 + 0.21 * len(found))
        axes = figure.subplots()
        for place, row in enumerate(found):
            axes.plot(
                [0.0, row["share"]],
                [place, place],
                color=COLOURS[row["kind"]],
                linewidth=1.0,
                alpha=0.6,
            )
            axes.plot(row["share"], place, "o", color=COLOURS[row["kind"]], markersize=5)
        axes.set_yticks(range(len(found)), [_short(row, found) for row in found])
        axes.set_xlim(-0.02, 1.05)
        axes.axvline(1.0, color="#b5472a", linewidth=1.0)
        axes.set_xlabel("difference, as share of what is allowed (1: the test fails)")
        for kind in KINDS:
            if any(row["kind"] == kind for row in found):
                axes.plot([], [], "o", color=COLOURS[kind], label=kind)
        figure.legend(loc="outside upper right", ncols=4)
        axes.grid(visible=False, axis="y")
    return figure


def _short(row: dict[str, Any], others: list[dict[str, Any]]) -> str:
    """Short description of a comparison, with its file if the description is not unique."""
    words = row["compares"]
    if sum(one["compares"] == words for one in others) > 1:
        words += f" ({row['test'].partition('test_')[2].partition('.')[0].replace('_', ' ')})"
    return textwrap.shorten(words, 46, placeholder=" …")


def adams() -> Any:
    """Draw the largest difference from ADAMS: the position of the body, and jounce's difference."""
    from jounce import simulate_mechanism
    from jounce.plots import new_figure, style

    path = ROOT / "tests" / "reference" / "test_adams_joints.py"
    spec = importlib.util.spec_from_file_location("adams_joints", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    case = module.Recorded("Spherical_Case01")
    made, _ = module.built(case)
    run = simulate_mechanism(made, "5 s", output_step=0.01, tolerance=1e-8)
    with style():
        figure = new_figure(3.6)
        above, below = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
        for axis, colour in zip("xyz", ("#0067a8", "#d55e00", "#00896b"), strict=True):
            theirs = case["Pos"][:, "xyz".index(axis)]
            above.plot(case["time"], theirs, color="#30353b", linewidth=3.0, alpha=0.35)
            above.plot(run["time"], run[f"bob.{axis}"], color=colour, label=axis)
            below.plot(case["time"], 1e3 * (run[f"bob.{axis}"].values - theirs), color=colour)
        above.plot([], [], color="#30353b", linewidth=3.0, alpha=0.35, label="ADAMS")
        above.set_ylabel("place [m]")
        below.set_ylabel("difference [mm]")
        below.set_xlabel("time [s]")
        figure.legend(loc="outside upper right", ncols=4)
    return figure


def damper() -> Any:
    """Draw the loops of a measured damper and the fitted law."""
    import numpy as np

    from jounce.identify.damper import damper_curve, fit_damper
    from jounce.plots import damper_loops

    path = (
        ROOT
        / "src"
        / "jounce"
        / "library"
        / "measurements"
        / "mr_damper"
        / "shaking_table_088v.csv"
    )
    time, displacement, velocity, force = np.loadtxt(path, delimiter=",", skiprows=1).T
    record = (1e-3 * displacement, 1e-3 * velocity, force, time)
    curves = {
        law: damper_curve(fit_damper(*record, law=law), *record) for law in ("linear", "bouc-wen")
    }
    seen = curves["linear"]  # the record as it is fitted: without samples at rest
    laws = {law: one.fitted for law, one in curves.items()}
    return damper_loops(seen.displacement, seen.velocity, seen.measured, laws)


def write() -> None:
    """Write tables and pictures beside the pages."""
    folder = Path(__file__).with_name("_generated")
    folder.mkdir(exist_ok=True)
    texts = {
        "validation.md": tables(),
        "validation-overview.md": overview(),
        "validation-apart.md": apart(),
    }
    for name, text in texts.items():
        if not (folder / name).is_file() or (folder / name).read_text(encoding="utf-8") != text:
            (folder / name).write_text(text, encoding="utf-8")
    own = Path(__file__).read_text(encoding="utf-8")
    for name in capabilities():
        kept = json.dumps([row for row in rows() if row["of"] == name])
        drawn.write(
            f"validation-{name.replace(' ', '-')}", lambda name=name: shares(name), own + kept
        )
    drawn.write("validation-adams", adams, own)
    drawn.write("validation-damper", damper, own)
