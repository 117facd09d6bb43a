"""Tables for the terminal: fitted to its width, with long tables truncated."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from jounce.cli.everywhere import VIEW
from jounce.core.tables import TextTable
from jounce.core.text import encodable

_LONG, _FIRST = 25, 20  # rows: longer tables are truncated to the second number


class FittedTable(TextTable):
    """A table fitted to the width of its console."""

    def __rich_console__(self, _console: Any, options: Any) -> Iterator[Any]:
        """Print the title, the table, and the number of omitted rows."""
        from rich.text import Text

        rows = [
            [encodable(cell, options.encoding) for cell in row] for row in self.rows
        ]  # before widths are measured
        fitted = replace(self, rows=rows)
        is_cut = len(self.rows) > _LONG and not VIEW.every_row and sys.stdout.isatty()
        if self.title:
            yield Text(self.title, style="bold")
        for line in fitted.lines(options.max_width, _FIRST if is_cut else None):
            yield Text(line.replace("─", "-") if options.ascii_only else line, no_wrap=True)
        if is_cut:
            yield Text(f"… and {len(self.rows) - _FIRST} more rows: --all", style="dim italic")
        yield Text()
