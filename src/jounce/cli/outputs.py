"""Output files of commands: how each is requested, checked in advance, and written."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    FigureFile,
    NumbersFile,
    ReportFile,
    RigFile,
    check_numbers,
    check_outputs,
    write_numbers,
    write_picture,
    write_report,
    write_rig,
)
from jounce.cli.reply import drawing
from jounce.core.findings import not_drawn
from jounce.operations.index import Operation, resolve

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.core.findings import Finding
    from jounce.report import Page


@dataclass(frozen=True)
class Answered:
    """A result of an operation with the context for its files: argument, output, title, comment."""

    operation: Operation
    subject: str
    result: Any
    plain: dict[str, Any]
    title: str
    comment: str

    def page(self) -> Page:
        """Create a page of the result."""
        page: Page = resolve(self.operation.page)(self.result, title=self.title)
        return page

    def summary(self) -> Page:
        """Create a page with the content shown in the terminal."""
        if not self.operation.terminal:
            return self.page()
        page: Page = resolve(self.operation.terminal)(self.result, title=self.title)
        return page

    def figure(self) -> Figure:
        """Draw the result with the function of the operation, or with that of the result's type."""
        from jounce.plots import figure_of

        if not self.operation.figure:
            return figure_of(self.result)
        figure: Figure = resolve(self.operation.figure)(self.result, title=self.title)
        return figure


Missing = Sequence["Finding"]
"""Figures that could not be drawn; the results are kept."""


@dataclass(frozen=True)
class OutputKind:
    """An output format of a result: its option with type and help, a check of the file, and a writer."""

    option: str
    kind: Any
    check: Callable[[Path, bool], object]
    write: Callable[[Answered, Path, bool], Missing]
    key: str = ""  # key of the file in the output, if it differs from the option

    @property
    def name(self) -> str:
        """Return the key of the file in the output."""
        return self.key or self.option


def _out(text: str, metavar: str | None = None) -> Any:
    return Annotated[Path | None, typer.Option("--out", metavar=metavar, help=text)]


def _rig(answered: Answered, file: Path, force: bool) -> Missing:
    write_rig(answered.result.rig, file, answered.comment, force=force)
    return ()


def _changed_rig(answered: Answered, file: Path, force: bool) -> Missing:
    from jounce.core.writing import write_atomically
    from jounce.parts import rig_path
    from jounce.parts.files import updated_text

    text = rig_path(answered.subject).read_text(encoding="utf-8")
    write_atomically(file, updated_text(text, answered.result.rig), force=force)
    return ()


def _rig_text(answered: Answered, file: Path, force: bool) -> Missing:
    from jounce.core.writing import write_atomically

    write_atomically(file, answered.result.rig_text, force=force)
    return ()


def _imported_rig(answered: Answered, file: Path, force: bool) -> Missing:
    from jounce.core.writing import write_atomically

    write_atomically(file, answered.result.text, force=force)
    answered.plain.update(answered.result.to_dict(str(file)))
    return ()


def _recording(answered: Answered, file: Path, force: bool) -> Missing:
    from jounce.recordings import write_recording

    write_recording(answered.result.recording(), file, force=force)
    return ()


def _test_record(answered: Answered, file: Path, force: bool) -> Missing:
    from jounce.testers.testing import write_test

    write_test(answered.result.record, file, force=force)
    return ()


def _numbers(answered: Answered, file: Path, force: bool) -> Missing:
    write_numbers(answered.plain, answered.result.rows(), file, force=force)
    return ()


def _check_sweep(file: Path, force: bool) -> None:
    from jounce.kinematics.sweeps import SWEEP_FILES

    SWEEP_FILES.check(file, force=force)


def _sweep(answered: Answered, file: Path, force: bool) -> Missing:
    from jounce.kinematics.sweeps import SWEEP_FILES

    SWEEP_FILES.write(answered.result.data, file, force=force)
    return ()


def _check_table(file: Path, force: bool) -> None:
    from jounce.core.writing import check_writable

    check_writable(file, what="tables", suffixes=(".csv",), force=force)


def _table(answered: Answered, file: Path, force: bool) -> Missing:
    from jounce.core.writing import write_atomically

    write_atomically(file, answered.result.table(), force=force)
    return ()


def _check_tables(file: Path, force: bool) -> None:
    from jounce.core.optional import require
    from jounce.core.writing import check_writable

    check_writable(file, what="tables", suffixes=(".csv", ".xlsx"), force=force)
    if file.suffix.lower() == ".xlsx":
        require("openpyxl", "io")


def _tables(answered: Answered, file: Path, force: bool) -> Missing:
    if file.suffix.lower() == ".csv":
        return _table(answered, file, force)
    from jounce.core.workbooks import workbook_of
    from jounce.core.writing import write_atomically

    write_atomically(file, workbook_of(answered.result.sheets()), force=force)
    return ()


def _figure(answered: Answered, file: Path, force: bool) -> Missing:
    return write_picture(answered.figure, file, answered.title, force=force)[1]


def _figures(answered: Answered, folder: Path, force: bool) -> Missing:
    try:
        resolve(answered.operation.figure)(answered.result, folder, force=force)
    except Exception as error:  # noqa: BLE001 - the result is returned in any case
        return [not_drawn(str(folder), error)]
    return ()


def _folder(answered: Answered, folder: Path, force: bool) -> Missing:
    """Write the results, then the page with its figures."""
    from jounce.report import Picture, write_page

    def page() -> Page:
        whole = answered.page()
        pictures = [picture for picture in whole.pictures() if isinstance(picture, Picture)]
        formats, note = (".svg", ".png"), whole.figure_note  # both from a layout: the page has SVG
        drawn = {f"{picture.name}.png": picture.draw(formats, note)[".png"] for picture in pictures}
        return replace(whole, files=tuple(drawn.items()))

    with drawing() as missing:
        pdf = getattr(answered.result, "with_pdf", False)
        write_page(page, folder, files=answered.result.files(), force=force, pdf=pdf)
    return missing


def _report(answered: Answered, file: Path, force: bool) -> Missing:
    return write_report(answered.page, file, force=force)[1]


OUTPUTS: Mapping[str, OutputKind] = {
    "rig": OutputKind(
        "out", RigFile, lambda file, force: check_outputs(rig=file, force=force), _rig
    ),
    "changed_rig": OutputKind(
        "out",
        _out("Write the changed rig, with its comments: RIG.toml."),
        lambda file, force: check_outputs(rig=file, force=force),
        _changed_rig,
    ),
    "rig_text": OutputKind(
        "out",
        _out("Write the rig with what was measured, RIG.toml."),
        lambda file, force: check_outputs(rig=file, force=force),
        _rig_text,
    ),
    "imported_rig": OutputKind(
        "out",
        _out("Rig file to write; stdout by default."),
        lambda file, force: check_outputs(rig=file, force=force),
        _imported_rig,
    ),
    "recording": OutputKind(
        "out",
        _out("Write the recording: .nc, .csv, .mat, .mf4, .parquet, .xlsx or .rsp."),
        lambda file, force: check_outputs(recording=file, force=force),
        _recording,
    ),
    "test_record": OutputKind(
        "out",
        _out("Write the record: RECORD.csv or RECORD.nc."),
        lambda file, force: check_outputs(recording=file, force=force),
        _test_record,
        "record",
    ),
    "numbers": OutputKind(
        "out", NumbersFile, lambda file, force: check_numbers(file, force=force), _numbers
    ),
    "sweep": OutputKind(
        "out", _out("Write every quantity: .nc or .csv (SI)."), _check_sweep, _sweep
    ),
    "table": OutputKind("out", _out("Write every number: .csv (SI)."), _check_table, _table),
    "tables": OutputKind(
        "out", _out("Write every number: .csv or .xlsx (SI)."), _check_tables, _tables
    ),
    "figure": OutputKind(
        "figure", FigureFile, lambda file, force: check_outputs(figure=file, force=force), _figure
    ),
    "figures": OutputKind(
        "figure",
        Annotated[
            Path | None, typer.Option(metavar="DIR", help="Draw all figures into this folder.")
        ],
        lambda file, force: check_outputs(folder=file, force=force),
        _figures,
    ),
    "folder": OutputKind(
        "out",
        _out("Write the report, rigs, results, tables and figures into this folder.", "DIR"),
        lambda file, force: check_outputs(folder=file, force=force),
        _folder,
    ),
    "report": OutputKind(
        "report", ReportFile, lambda file, force: check_outputs(report=file, force=force), _report
    ),
}
"""Outputs that an operation may offer (`jounce.core.operation.Offer`)."""


@dataclass(frozen=True)
class Files:
    """Output files requested on the command line, by offer; ``None`` if not requested.

    A folder that the function writes itself (``own``) is also checked by the function.
    """

    asked: Mapping[str, Path | str | None]
    force: bool
    own: Collection[str] = ()

    def check(self) -> None:
        """Raise an error for files that could not be written."""
        for offer, file in self.asked.items():
            if file is not None and offer not in self.own:
                OUTPUTS[offer].check(Path(file), self.force)

    def write(self, answered: Answered) -> Missing:
        """Write the files, add their names to the plain output, and return what could not be drawn."""
        missing: list[Finding] = []
        for offer, file in self.asked.items():
            force = self.force or offer in self.own
            lost = () if file is None else OUTPUTS[offer].write(answered, Path(file), force)
            answered.plain[OUTPUTS[offer].name] = None if file is None or lost else str(file)
            missing += lost
        return missing
