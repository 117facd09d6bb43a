"""``jounce plot``: channels of a recording as a figure."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jounce.cli.options import AsJson, Columns, Force, columns
from jounce.cli.reply import Reply
from jounce.cli.tables import show_findings

if TYPE_CHECKING:
    from rich.console import Console


def plot(
    run: Annotated[Path, typer.Argument(metavar="RUN", help="A recording: .nc of `jounce simulate`, .csv, .mat ...")],
    out: Annotated[Path, typer.Option(help="Figure to write: .png, .svg or .pdf.")],
    channels: Annotated[
        list[str] | None,
        typer.Argument(metavar="CHANNEL", help="What to draw, from top to bottom.", show_default=False),
    ] = None,
    columns_: Columns = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Draw channels of a recording against time.

    Example: jounce plot run.nc sprung.az unsprung.az --out accelerations.png
    """
    from jounce.core.serialise import to_plain
    from jounce.plots.style import check_figure, write_figure

    check_figure(out, force=force)
    from jounce.plots.signals import time_history
    from jounce.recordings import read_recording

    data, findings = read_recording(run, columns=columns(columns_))
    figure = time_history(data, channels or None)
    write_figure(figure, out, force=force)
    drawn = channels or [axes.get_title("left") for axes in figure.axes]
    plain = {"run": str(run), "channels": drawn, "out": str(out), "findings": to_plain(findings)}

    def draw(console: Console) -> None:
        console.print(f"{', '.join(drawn)}\nwritten: {out}")
        show_findings(console, findings)

    return Reply(plain, draw, as_json)
