"""Pictures of the gallery: run the blocks of its page and draw the ``figure`` of each."""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import re
import shlex
import tempfile
from pathlib import Path
from typing import Any

import drawn

PAGE = Path(__file__).parent / "reference" / "gallery.md"
BLOCK = re.compile(
    r"^```(?:(python|console)|\{drawn\} gallery-(\w+))\n(.*?)^```$", re.MULTILINE | re.DOTALL
)


def write() -> None:
    """Run the page if a picture is missing, or if the page or the drawing code has changed."""
    text = PAGE.read_text(encoding="utf-8")
    made_from = hashlib.sha256(text.encode())
    import jounce.plots

    for file in sorted(Path(jounce.plots.__file__).parent.rglob("*.py")):
        made_from.update(file.read_bytes())
    mark = made_from.hexdigest()
    names = [name for _, name, _ in BLOCK.findall(text) if name]
    if all(drawn.is_made(f"gallery-{name}", mark) for name in names):
        return
    here, scope = Path.cwd(), {}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for kind, name, block in BLOCK.findall(text):
                run(kind, name, block, scope, mark)
        finally:
            os.chdir(here)


def run(kind: str, name: str, block: str, scope: dict[str, Any], mark: str) -> None:
    """Run a block of Python or commands, or draw the figure of the previous blocks."""
    if kind == "python":
        exec(compile(block, str(PAGE), "exec", dont_inherit=True), scope)  # noqa: S102 - our own page
    elif kind == "console":
        from jounce.cli import main

        for line in block.splitlines():
            if line.startswith("$ "):
                with contextlib.redirect_stdout(io.StringIO()):
                    assert main(shlex.split(line)[2:]) == 0, line
    else:
        drawn.write(f"gallery-{name}", lambda: scope.pop("figure"), mark)
        scope.pop("figure", None)
