"""Tables that fit into the lines of a terminal: no number is broken; columns without room stand below."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from jounce.cli.everywhere import VIEW

if TYPE_CHECKING:
    from rich.table import Table

_LONG, _FIRST = 25, 20  # rows: longer tables are cut, to so many
_BETWEEN = 3  # characters between two columns


@dataclass(frozen=True)
class FittedTable:
    """A table whose columns are fitted to the width that it is printed in.

    Attributes
    ----------
    title : str
        Line above it; empty without one.
    header : sequence of str
        Name of each column.
    rows : sequence of sequence of str
        Cells; the first column names the row and is repeated where columns stand below.
    texts : sequence of int
        Columns that hold text: they stand to the left, and their lines break between words.
    """

    title: str
    header: Sequence[str]
    rows: Sequence[Sequence[str]]
    texts: Sequence[int] = (0,)

    def __rich_console__(self, _console: Any, options: Any) -> Iterator[Any]:
        """Print the title, then the columns that fit beside each other, then the others."""
        from rich.text import Text

        is_cut = len(self.rows) > _LONG and not VIEW.every_row and sys.stdout.isatty()
        rows = self.rows[:_FIRST] if is_cut else self.rows
        if self.title:
            yield Text(self.title, style="bold")
        for part in self.parts(options.max_width):
            yield self._drawn(part, rows)
        if is_cut:
            yield Text(f"… and {len(self.rows) - _FIRST} more rows: --all", style="dim italic")

    def parts(self, width: int) -> list[dict[int, int]]:
        """Choose columns and their widths for each part.

        >>> table = FittedTable("", ("name", "first", "second"), [("a b", "1.5", "100.25")])
        >>> table.parts(80), table.parts(14)
        ([{0: 3, 1: 5, 2: 6}], [{0: 3, 1: 5}, {0: 3, 2: 6}])
        """
        least = [self._width(k, is_least=True) for k in range(len(self.header))]
        parts: list[list[int]] = [[0]] if self.header else []
        for k in range(1, len(self.header)):
            beside = [*parts[-1], k]
            if len(beside) > 2 and sum(least[j] + _BETWEEN for j in beside) > width + 1:
                beside = [0, k]
                parts.append(beside)
            parts[-1] = beside
        return [self._widened(part, least, width + 1) for part in parts]

    def _widened(self, columns: Sequence[int], least: Sequence[int], width: int) -> dict[int, int]:
        """Share the remaining width among the columns that can use it; where there is none, cut the names of rows."""
        wanted = [self._width(k, is_least=False) - least[k] for k in columns]
        left = width - sum(least[k] + _BETWEEN for k in columns)
        share = min(1.0, max(0, left) / max(1, sum(wanted)))
        widths = {k: least[k] + int(share * more) for k, more in zip(columns, wanted, strict=True)}
        return widths | {columns[0]: max(1, widths[columns[0]] + min(0, left))}

    def _width(self, column: int, *, is_least: bool) -> int:
        """Width of a column: that of its longest cell, or the least that breaks no word and no number."""
        from rich.cells import cell_len

        cells = [row[column] for row in self.rows]
        if is_least and column in self.texts:
            cells = [word for text in cells for word in text.split()]
        head = self.header[column].split() if is_least else [self.header[column]]
        return max((cell_len(text) for cell in (*head, *cells) for text in cell.splitlines()), default=1)

    def _drawn(self, widths: dict[int, int], rows: Sequence[Sequence[str]]) -> Table:
        from rich import box
        from rich.table import Table

        drawn = Table(box=box.SIMPLE_HEAD, pad_edge=False)
        for column, width in widths.items():
            side: Any = "left" if column in self.texts else "right"
            drawn.add_column(self.header[column], justify=side, overflow="fold", width=width)
        for row in rows:
            drawn.add_row(*(row[column] for column in widths))
        return drawn
