"""Rows of plain numbers, parsed in bulk: the fast twin of reading a text row by row and cell by cell.

Anything but numbers, separators and line ends (quotes, units, texts, gaps, blank lines, rows of different lengths) is
left to the reader of rows, which names what is wrong. The same numbers result: both round correctly.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array

_PIECE = 1 << 20
"""Characters that are parsed at a time."""
_NUMBERS = b"0123456789+-.eE \n"
_END = ord("\n")
_FEWEST = 9  # rows: fewer do not show that the last row is cut off


@dataclass(frozen=True, eq=False)
class PlainRows:
    """Finite numbers by column.

    ``has_commas`` tells whether decimal commas were read as points, ``is_cut_off`` whether the last number of the last
    row is shorter than in all other rows.
    """

    columns: tuple[Array, ...]
    has_commas: bool
    is_cut_off: bool


def parse_plain_rows(
    text: str, width: int, separator: str, progress: Callable[[float], None]
) -> PlainRows | None:
    r"""Parse a text of rows of ``width`` numbers; None unless all of them are plain.

    ``progress`` is called with the share that is parsed, 0 to 1.

    >>> rows = parse_plain_rows("0;1,5\n2;-3e-1\n", 2, ";", lambda share: None)
    >>> [column.tolist() for column in rows.columns], rows.has_commas
    ([[0.0, 2.0], [1.5, -0.3]], True)
    >>> parse_plain_rows("0;1.5\n2;three\n", 2, ";", lambda share: None)
    """
    end = len(text.rstrip("\r\n"))
    mark = separator.encode()
    has_end_marks = mark != b" " and text[: text.find("\n")].rstrip("\r").endswith(separator)
    parts: list[list[Array]] = []
    lengths: list[NDArray[np.int64]] = []
    start, signs = 0, ""
    while start < end:
        stop = text.find("\n", min(start + _PIECE, end))
        stop = end if stop < 0 else stop
        piece = text[start:stop]
        signs += "".join(sign for sign in ",." if sign not in signs and sign in piece)
        parsed = _parse(piece, width, mark, has_end_marks)
        if parsed is None or (mark != b"," and len(signs) > 1):
            return None
        parts.append(parsed[0])
        lengths.append(parsed[1])
        start = stop + 1
        progress(min(1.0, start / end))
    if not parts:
        return None
    columns = tuple(np.concatenate(own) for own in zip(*parts, strict=True))
    behind = np.concatenate(lengths)
    is_cut_off = (
        text[-1] not in "\r\n" and behind.size > _FEWEST and bool(behind[-1] < behind[:-1].min())
    )
    return PlainRows(columns, mark != b"," and "," in signs, is_cut_off)


def _parse(
    text: str, width: int, mark: bytes, has_end_marks: bool
) -> tuple[list[Array], NDArray[np.int64]] | None:
    """Columns of complete rows, and the distance of the last separator of each row from its end."""
    if not text.isascii():
        return None
    piece = text.encode() + b"\n"
    if b"\r" in piece:
        piece = piece.replace(b"\r\n", b"\n")
    if mark != b",":
        piece = piece.replace(b",", b".")
    if piece.translate(None, _NUMBERS + mark) or b"e " in piece or b"E " in piece:
        return None
    size = len(piece)
    if has_end_marks:
        piece = piece.replace(mark + b"\n", b"\n")
    signs = np.frombuffer(piece, np.uint8)
    marks = np.flatnonzero((signs == _END) | (signs == mark[0]))
    is_end = signs[marks] == _END
    rows = int(np.count_nonzero(is_end))
    if mark == b" ":
        blank = signs <= mark[0]
        cells = np.flatnonzero(blank[1:] > blank[:-1]) + 1
        before = np.searchsorted(cells, marks[is_end], "right")
        is_even = np.array_equal(before, width * np.arange(1, rows + 1))
    else:
        is_even = marks.size == rows * width and bool(is_end[width - 1 :: width].all())
    if not is_even or size != len(piece) + (rows if has_end_marks else 0):
        return None
    try:
        frame = _load_reader()(io.BytesIO(piece), sep=r"\s+" if mark == b" " else mark.decode())
    except ValueError:
        return None
    numbers = [values.to_numpy() for _, values in frame.items()]
    if len(numbers) != width or not all(
        len(values) == rows and np.isfinite(values).all() for values in numbers
    ):
        return None
    behind = np.diff(marks, prepend=-1)[is_end]
    return numbers, np.ones_like(behind) if has_end_marks else behind


@cache
def _load_reader() -> Callable[..., Any]:
    """Return the reader of pandas for plain numbers, which is loaded for long texts only."""
    import pandas as pd

    version = tuple(map(int, pd.__version__.split(".")[:2]))
    exact = {} if version >= (3, 1) else {"float_precision": "round_trip"}
    return partial(
        pd.read_csv, header=None, dtype=np.float64, na_filter=False, quoting=csv.QUOTE_NONE,
        skip_blank_lines=False, skipinitialspace=True, low_memory=False, engine="c", **exact,
    )  # fmt: skip
