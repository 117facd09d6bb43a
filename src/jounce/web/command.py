"""``jounce serve``: the workbench in the browser. It runs the other commands, so it registers its own from here."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Annotated, TextIO

import typer

from jounce.cli.added import add_command
from jounce.cli.reply import Reply


@add_command
def serve(
    folder: Annotated[
        Path,
        typer.Argument(metavar="DIR", help="The project: a folder of rigs, roads and records."),
    ],
    port: Annotated[
        int, typer.Option(help="Port on 127.0.0.1; 0 takes the folder's own, or else a free one.")
    ] = 0,
    no_open: Annotated[bool, typer.Option("--no-open", help="Open no browser.")] = False,
    as_json: Annotated[
        bool,
        typer.Option(
            "--json", help='Print one line {"url": ..., "token": ...} when it answers, and no text.'
        ),
    ] = False,
) -> Reply:
    """Open the workbench of a folder in the browser, until Ctrl-C. Only this machine reaches it.

    Example: jounce serve my-car --port 8123 --no-open
    """

    def ready(url: str, token: str) -> None:
        text = (
            json.dumps({"url": url, "token": token})
            if as_json
            else f"The workbench of {folder} is open: {url}"
        )
        _write(sys.__stdout__, text)  # stdout, where other commands print only at their end
        if not as_json:
            _write(sys.stderr, "Ctrl-C ends it.")
        if not no_open:
            import webbrowser

            webbrowser.open(url)

    from jounce.web.serving import serve as open_workbench

    open_workbench(folder, port=port, ready=ready)
    return Reply({}, lambda _: None)


def _write(stream: TextIO | None, text: str) -> None:
    if stream is not None:
        stream.write(f"{text}\n")
        stream.flush()
