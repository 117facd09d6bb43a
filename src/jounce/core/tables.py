"""Write tables as text of a given width: numbers are never broken; columns that do not fit follow below."""

from __future__ import annotations

import textwrap
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from jounce.core.text import visible

_GAP = "  "


@dataclass(frozen=True)
class TextTable:
    """A text table that is fitted to a width.

    Attributes
    ----------
    title : str
        Line above it; empty without one.
    header : sequence of str
        Name of each column.
    rows : sequence of sequence of str
        Cells; the first column names the row and is repeated with columns that follow below, as is the column "unit".
    texts : sequence of int
        Columns of text: flush left, with line breaks between words.

    Examples
    --------
    >>> print(TextTable("Rates", ("wheel", "rate [N/mm]"), [("front left", "22.73"), ("rear", "9.80")]))
    Rates
    wheel       rate [N/mm]
    ──────────  ───────────
    front left        22.73
    rear               9.80
    """

    title: str
    header: Sequence[str]
    rows: Sequence[Sequence[str]]
    texts: Sequence[int] = (0,)

    def __str__(self) -> str:
        return "\n".join([*([self.title] if self.title else ()), *self.lines(80)])

    def lines(self, width: int, most: int | None = None) -> Iterator[str]:
        """Write header and rows, the first ``most`` of them, in lines of at most ``width`` characters."""
        for number, widths in enumerate(self.parts(width)):
            if number:
                yield ""
            yield from self._row_lines(self.header, widths, is_head=True)
            yield _GAP.join("─" * wide for wide in widths.values())
            for row in self.rows[:most]:
                if any(row[k] for k in widths):
                    yield from self._row_lines(row, widths)

    def parts(self, width: int) -> list[dict[int, int]]:
        """Choose the columns of each part, and their widths.

        >>> table = TextTable("", ("name", "first", "second"), [("a b", "1.5", "100.25")])
        >>> table.parts(80), table.parts(14)
        ([{0: 4, 1: 5, 2: 6}], [{0: 4, 1: 5}, {0: 4, 2: 6}])
        """
        every = range(len(self.header))
        least = [self._width(k, is_least=True) for k in every]
        if not self.header or _sum(least) <= width:
            return [self._share_width(every, least, width)] if self.header else []
        names = [0, *(k for k in every[1:] if self.header[k] == "unit")]
        parts = [list(names)]
        for k in every:
            if (
                k not in names
                and len(parts[-1]) > len(names)
                and _sum([least[j] for j in (*parts[-1], k)]) > width
            ):
                parts.append(list(names))
            parts[-1] += [k] if k not in names else []
        return [self._share_width(part, least, width) for part in parts]

    def _share_width(
        self, columns: Sequence[int], least: Sequence[int], width: int
    ) -> dict[int, int]:
        """Distribute the remaining width among the columns that can use it; if none remains, shorten the row names."""
        wanted = [self._width(k, is_least=False) - least[k] for k in columns]
        left = width - _sum([least[k] for k in columns])
        share = min(1.0, max(0, left) / max(1, sum(wanted)))
        widths = {k: least[k] + int(share * more) for k, more in zip(columns, wanted, strict=True)}
        return widths | {columns[0]: max(1, widths[columns[0]] + min(0, left))}

    def _width(self, column: int, *, is_least: bool) -> int:
        """Width of a column: that of its longest cell, or the minimum that breaks no word and no number."""
        cells = [row[column] for row in self.rows]
        if is_least and column in self.texts:
            cells = [word for text in cells for word in text.split()]
        head = self.header[column].split() if is_least else [self.header[column]]
        return max(
            (width_of(text) for cell in (*head, *cells) for text in cell.splitlines()), default=1
        )

    def _row_lines(
        self, cells: Sequence[str], widths: dict[int, int], *, is_head: bool = False
    ) -> Iterator[str]:
        """Write one row; cells of the header are aligned at the bottom, those of other rows at the top."""
        columns = {k: _wrap(cells[k], wide) for k, wide in widths.items()}
        height = max(map(len, columns.values()))
        for k, lines in columns.items():
            empty = [""] * (height - len(lines))
            columns[k] = [*empty, *lines] if is_head else [*lines, *empty]
        for at in range(height):
            aligned = [self._align(columns[k][at], k, wide) for k, wide in widths.items()]
            yield _GAP.join(aligned).rstrip()

    def _align(self, text: str, column: int, width: int) -> str:
        room = " " * (width - width_of(text))
        return text + room if column in self.texts else room + text


def width_of(text: str) -> int:
    """Return the number of terminal columns that a text occupies.

    >>> width_of("22.7 N/mm"), width_of("車輪")
    (9, 4)
    """
    if text.isascii():
        return len(text)
    return sum(
        2 if unicodedata.east_asian_width(sign) in "FW" else not unicodedata.combining(sign)
        for sign in text
    )


def _wrap(text: str, width: int) -> list[str]:
    lines = visible(text).splitlines() or [""]
    return [
        part
        for line in lines
        for part in textwrap.wrap(line, width, break_on_hyphens=False) or [""]
    ]


def _sum(widths: Sequence[int]) -> int:
    """Width of columns side by side."""
    return sum(widths) + len(_GAP) * (len(widths) - 1)
