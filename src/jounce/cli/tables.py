"""Tables and sentences for people."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from jounce.core.findings import Finding
    from jounce.identify.estimate import Estimate

ROUNDING = 1e-12  # SI values of this size are what is left of zero
SEVERITY_STYLES = {"note": "dim", "warning": "yellow", "problem": "bold red"}


def table(title: str, columns: Sequence[str], rows: Iterable[Sequence[object]], *, text: Sequence[int] = (0,)) -> Table:
    """Build a table; columns are numbers and stand to the right but those listed in ``text``."""
    from rich import box
    from rich.table import Table

    built = Table(title=title or None, title_justify="left", title_style="bold", box=box.SIMPLE_HEAD, pad_edge=False)
    for index, column in enumerate(columns):
        built.add_column(column, justify="left" if index in text else "right", overflow="fold")
    for row in rows:
        built.add_row(*(cell(item) for item in row))
    return built


def cell(value: object) -> str:
    """Text of one cell: numbers with five digits, None as a dash."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return number(value) if isinstance(value, float) else str(value)


def number(value: float) -> str:
    """Write a number with five significant digits, without an exponent from 0.0001 up to ten million.

    Examples
    --------
    >>> number(138891.4), number(22730.0), number(-1.5), number(1e-15), number(2.5e9)
    ('138891', '22730', '-1.5', '0', '2.5e+09')
    """
    if abs(value) < ROUNDING:
        return "0"
    return f"{value:.0f}" if 1e5 <= abs(value) < 1e7 else f"{value:.5g}"


def estimate_row(name: str, found: Estimate | None, unit: str) -> tuple[object, ...]:
    """Name, value, standard error, 95 % interval and unit of an estimate."""
    if found is None:
        return name, None, None, None, unit
    interval = None if found.interval is None else f"{number(found.interval[0])} … {number(found.interval[1])}"
    return name, found.value, found.standard_error, interval, unit


def estimates(title: str, rows: Iterable[tuple[str, Estimate | None, str]]) -> Table:
    """Table of estimates: name, estimate and unit in each row."""
    header = ("quantity", "value", "standard error", "95 % interval", "unit")
    return table(title, header, (estimate_row(*row) for row in rows), text=(0, 4))


def show_written(out: Console, plain: Mapping[str, Any]) -> None:
    """Name the files that were written."""
    for key in ("out", "record", "figure"):
        if plain.get(key) is not None:
            out.print(f"written: {plain[key]}")


def show_findings(out: Console, findings: Iterable[Finding]) -> None:
    """Print what the reader must know, one sentence each; what is piped keeps one line for each."""
    from rich.text import Text

    for finding in findings:
        line = Text(f"{finding.severity}: ", style=SEVERITY_STYLES[finding.severity])
        line.append(f"{finding.place}: {finding.message}", style="default")
        out.print(line, soft_wrap=not out.is_terminal)
