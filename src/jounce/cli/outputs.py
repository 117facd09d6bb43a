"""Files that several commands write: refused before the work where they could not be written after it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

FigureFile = Annotated[Path | None, typer.Option(help="Draw the result: .png, .svg or .pdf.")]


def check_outputs(
    *,
    figure: Path | None = None,
    recording: Path | None = None,
    rig: Path | None = None,
    folder: Path | None = None,
    force: bool,
) -> None:
    """Refuse files of another suffix, in a missing folder, or (without ``force``) that exist; folders not empty."""
    from jounce.core.serialise import check_writable

    if rig is not None:
        check_writable(rig, what="rigs", suffixes=(".toml",), force=force)
    if recording is not None:
        from jounce.recordings.files import check_recording_file

        check_recording_file(recording, force=force)
    if folder is not None:
        from jounce.report.folder import check_folder

        check_folder(folder, force=force)
    if figure is not None:
        from jounce.plots.style import check_figure

        check_figure(figure, force=force)


def write_picture(result: object, figure: Path | None, *, force: bool) -> None:
    """Draw a result into the file, if one is asked for."""
    if figure is not None:
        from jounce.plots import figure_of
        from jounce.plots.style import write_figure

        write_figure(figure_of(result), figure, force=force)
