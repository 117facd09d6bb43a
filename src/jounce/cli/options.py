"""Options that several commands share, the conversion of their text to values, and early checks of files."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.reply import tell
from jounce.core.findings import not_drawn
from jounce.core.typed import pairs, positive_quantity, quantity, toml_value

if TYPE_CHECKING:
    from jounce.core.findings import Finding
    from jounce.parts import Rig
    from jounce.report import Page


AsJson = Annotated[
    bool, typer.Option("--json", help="Print exactly one JSON object (SI) instead of tables.")
]
Force = Annotated[bool, typer.Option("--force", help="Overwrite existing output.")]
Changes = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="PATH=VALUE",
        help='Change a parameter of the rig: strut.spring.rate="25 N/mm".',
    ),
]
Columns = Annotated[
    list[str] | None,
    typer.Option(
        "--columns",
        metavar="NAME=COLUMN",
        help=r'Column that holds a quantity, with its unit if the header gives none: force="F \[kN]". Repeat it.',
    ),
]
Variable = Annotated[
    str,
    typer.Option(
        help="Matrix or struct of a .mat file, group of a .tdms file, or sheet of a workbook (or rows: Run!5:300)."
    ),
]
SampleTime = Annotated[
    str | None,
    typer.Option(help='Constant sampling interval of a file without time, e.g. "10 ms".'),
]
Resample = Annotated[
    str | None,
    typer.Option(
        help='Bring irregular time, or signals at different instants, onto constant steps, e.g. "10 ms".'
    ),
]
Database = Annotated[
    Path | None,
    typer.Option(
        help="Database of bus messages (.dbc) with which the bus frames of an MDF file are decoded."
    ),
]


def names_in(*packages: str) -> Callable[[str], list[str]]:
    """Return a function that completes names of the files shipped in these packages; a shell completes files itself."""

    def complete(incomplete: str) -> list[str]:
        from jounce.core.files import shipped_files

        files = [
            shipped_files(f"jounce.{one}", "library", suffix)
            for one in packages
            for suffix in (".toml", ".crg")
        ]
        return [name for names in files for name in names if name.startswith(incomplete)]

    return complete


RigName = Annotated[
    str,
    typer.Argument(
        metavar="RIG",
        help="A rig file, or a name of `jounce library`.",
        autocompletion=names_in("parts"),
    ),
]


def optional_quantity(
    text: str | None, unit: str, option: str, *, most: float | None = None
) -> float | None:
    """Parse the value of an optional option."""
    return None if text is None else quantity(text, unit, option, most=most)


def optional_positive(
    text: str | None, unit: str, option: str, *, most: float | None = None
) -> float | None:
    """Parse the value of an optional option that must be positive."""
    return None if text is None else positive_quantity(text, unit, option, most=most)


LENGTH, STROKE, STEP, ANGLE = 10.0, 1.0, 1.0, 0.35
"""Limits of bare numbers: sizes of parts (m), strokes (m), sampling intervals (s), adjusted angles (rad)."""


def changes(texts: Sequence[str] | None) -> dict[str, Any]:
    """Parse values by path from ``--set``: text with a unit, or any single-line TOML value."""
    given = pairs(texts, "--set", 'strut.spring.rate="25 N/mm"')
    return {path: toml_value(value) for path, value in given.items()}


def columns(texts: Sequence[str] | None) -> dict[str, str] | None:
    """Parse columns by quantity from ``--columns``, one or several per text; ``None`` without a mapping."""
    split = [part for text in texts or () for part in re.split(r",\s*(?=[\w.]+\s*=)", text)]
    return pairs(split, "--columns", 'force="F [kN]"') or None


def _names_in_order(texts: Sequence[str] | None) -> str | None:
    """Return all column names for a file without header: ``time [s], force [N]``; ``None`` if columns are mapped."""
    return (
        texts[0] if texts and len(texts) == 1 and "=" not in texts[0] and "[" in texts[0] else None
    )


def reading(
    columns_: Sequence[str] | None,
    sample_time: str | None,
    variable: str,
    resample: str | None,
    database: Path | None,
) -> dict[str, Any]:
    """Return the arguments of ``read_recording`` from the shared options of commands that read recordings."""
    return {
        "columns": _names_in_order(columns_) or columns(columns_),
        "sample_time": optional_positive(sample_time, "s", "--sample-time", most=STEP),
        "variable": variable,
        "resample": optional_positive(resample, "s", "--resample", most=STEP),
        "database": database,
    }


ReportFile = Annotated[
    Path | None,
    typer.Option(
        "--report",
        help="Write a report: .html (one self-contained page with a viewer) or .pdf.",
    ),
]
FigureFile = Annotated[Path | None, typer.Option(help="Plot the result: .png, .svg or .pdf.")]
RigFile = Annotated[
    Path | None, typer.Option("--out", help="Write the design as a rig file, RIG.toml.")
]
NumbersFile = Annotated[
    Path | None, typer.Option("--out", help="Write the numbers: .csv (SI), or .json as --json.")
]


def check_numbers(out: Path | None, *, force: bool) -> None:
    """Raise an error for a file of numbers that could not be written."""
    from jounce.core.writing import check_writable

    if out is not None:
        check_writable(out, what="numbers", suffixes=(".csv", ".json"), force=force)


def write_numbers(
    plain: dict[str, Any], rows: Sequence[dict[str, Any]], out: Path | None, *, force: bool
) -> str | None:
    """Write the rows of a result as CSV, or the whole result as JSON, if requested; return the file name."""
    if out is None:
        return None
    import csv
    import io

    from jounce.core.serialise import to_json
    from jounce.core.text import guard_row
    from jounce.core.writing import write_atomically

    if out.suffix.lower() == ".json":
        text = f"{to_json(plain)}\n"
    else:
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(guard_row(rows[0] if rows else []))
        writer.writerows(guard_row(row.values()) for row in rows)
        text = stream.getvalue()
    write_atomically(out, text, force=force)
    return str(out)


def check_outputs(
    *,
    figure: Path | None = None,
    recording: Path | None = None,
    rig: Path | None = None,
    folder: Path | None = None,
    report: Path | None = None,
    force: bool,
) -> None:
    """Raise an error for unsupported suffixes, missing folders, and (without ``force``) existing output."""
    from jounce.core.writing import check_folder, check_writable

    if rig is not None:
        check_writable(rig, what="rigs", suffixes=(".toml",), force=force)
    if recording is not None:
        from jounce.recordings.writers import RECORDING_FILES

        RECORDING_FILES.check(recording, force=force)
    if folder is not None:
        check_folder(folder, force=force)
    if report is not None:
        from jounce.report.render import REPORTS

        REPORTS.check(report, force=force)
    if figure is not None:
        from jounce.plots.figures import FIGURES

        FIGURES.check(figure, force=force)


def write_picture(
    result: object, figure: Path | None, title: str = "", *, force: bool
) -> tuple[str | None, Sequence[Finding]]:
    """Draw a result, or call a drawing function, into the requested file, if any, with a title.

    Returns the file name, and what could not be drawn; results are kept in that case.
    """
    if figure is None:
        return None, ()
    try:
        from jounce.plots import figure_of
        from jounce.plots.figures import FIGURES, name_figure

        drawn = result() if callable(result) else figure_of(result)
        FIGURES.write(name_figure(drawn, title), figure, force=force)
    except Exception as error:  # noqa: BLE001 - the results are shown in any case
        return None, [not_drawn(str(figure), error)]
    return str(figure), ()


def write_report(
    page: Callable[[], Page], report: Path | None, *, force: bool
) -> tuple[str | None, Sequence[Finding]]:
    """Write the page that a function creates into the requested file, if any.

    Returns the file name, and what could not be drawn; results are kept in that case.
    """
    if report is None:
        return None, ()
    try:
        from jounce.report import REPORTS

        REPORTS.write(page(), report, force=force)
    except Exception as error:  # noqa: BLE001 - the results are shown in any case
        return None, [not_drawn(str(report), error)]
    return str(report), ()


def write_rig(rig: Rig, out: Path | None, comment: str, *, force: bool) -> None:
    """Write a rig with a comment as its first line, if a file is requested."""
    if out is not None:
        from jounce.core.writing import write_atomically
        from jounce.parts.files import rig_text

        write_atomically(out, rig_text(rig, [comment]), force=force)


def load_changed_rig(name: str, wanted: dict[str, Any]) -> Rig:
    """Load a rig and change its values; print its warnings on stderr, one per line, as ``jounce check`` does."""
    from jounce.parts.options import rig_of_options as made_rig

    rig = made_rig(name, wanted)
    warn_of(rig, name)
    return rig


def warn_of(rig: Rig, name: str) -> None:
    """Print warnings about implausible values of a rig on stderr; notes are only shown by ``jounce check``."""
    from jounce.parts import rig_findings

    warn(rig_findings(rig, name))


def warn(findings: Iterable[Finding]) -> None:
    """Print findings on stderr, except notes."""
    for found in findings:
        if found.severity != "note":
            tell(str(found), program="")


RoadName = Annotated[
    str | None,
    typer.Option(
        help="A road: TOML, OpenCRG or table file, or a name of `jounce library`.",
        autocompletion=names_in("roads"),
    ),
]
DrivenSpeed = Annotated[str | None, typer.Option(help='Speed over the road, e.g. "1.95 m/s".')]
Duration = Annotated[str | None, typer.Option(help='Length of the run, e.g. "3 s".')]
ExcitationFile = Annotated[
    Path | None,
    typer.Option(help="Instead of --road and --speed: a file with columns time and road.z."),
]
