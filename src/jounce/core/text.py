"""Write tables as text, and make text of unknown origin safe for a terminal."""

from __future__ import annotations

import codecs
import contextlib
import re
from collections.abc import Iterable, Sequence
from json import dumps as json_text
from typing import Any
from unicodedata import category, combining, normalize

# Control characters except tab and new line, those of 8-bit terminals, line separators, and direction marks.
_UNSEEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"
)


def visible(text: str, *, json: bool = False) -> str:
    r"""Escape characters that control a terminal, to keep those in files from reaching it.

    They are escaped as in Python, or as in JSON if the text is ``json``.

    >>> visible("spring\x1b[2J 22 N/mm")
    'spring\\x1b[2J 22 N/mm'
    """
    return _UNSEEN.sub(
        lambda match: f"\\u{ord(match[0]):04x}" if json else repr(match[0])[1:-1], text
    )


ESCAPES = "jounce-escapes"
"""Name of the error handler for characters that a non-Unicode stream cannot encode."""


def _escape(error: UnicodeError) -> tuple[str, int]:
    """Escape letters and digits as in Python, because they distinguish names of files; replace signs by ``?``."""
    assert isinstance(error, UnicodeEncodeError)
    text = error.object[error.start : error.end]
    written = (letter.encode("ascii", "backslashreplace").decode() for letter in text)
    return "".join(
        "?" if category(old)[0] in "SPZ" else new for old, new in zip(text, written, strict=True)
    ), error.end


codecs.register_error(ESCAPES, _escape)


def encodable(text: str, encoding: str) -> str:
    """Return a text as a stream with an encoding shows it; undecodable bytes of file names are taken as UTF-8."""
    if text.isascii():
        return text
    with contextlib.suppress(UnicodeError):
        text = text.encode("utf-8", "surrogateescape").decode()
    return text if encoding.startswith("utf") else text.encode(encoding, ESCAPES).decode(encoding)


def quote(text: str) -> str:
    r"""Write any text as a string literal valid in TOML and JSON; lone surrogates become ``\ufffd``.

    >>> quote('2" spring\x7f'), quote("µ \ud800")
    ('"2\\" spring\\u007f"', '"µ \ufffd"')
    """
    whole = re.sub("[\ud800-\udfff]", "\ufffd", text)
    return visible(json_text(whole, ensure_ascii=False), json=True)


def in_one_line(text: str) -> str:
    r"""Convert a text to a single line, e.g. a TOML comment: white space becomes one blank, control characters escapes.

    >>> in_one_line("2 springs\n  of\x7f steel")
    '2 springs of\\x7f steel'
    """
    return visible(" ".join(text.split()))


def shorten(text: str, most: int) -> str:
    """Return the text, or if it has more than ``most`` characters, its beginning and their number.

    >>> shorten("x" * 9, 9), shorten("x" * 5000, 3)
    ('xxxxxxxxx', 'xxx... (5000 characters)')
    """
    return text if len(text) <= most else f"{text[:most]}... ({len(text)} characters)"


_FORMULA = re.compile(r"'*[=+\-@\t\r\n]")


def qualify(place: str, name: str) -> str:
    """Prefix a name with its place, ``front_left.wheel.az``; return the name alone without a place."""
    return f"{place}.{name}" if place else name


def place_in(where: str, place: str) -> str:
    """Prefix the location of an error or finding with its file, ``run.csv: time``, if the file is known."""
    return f"{where}: {place}" if where else place


def guard_formula(text: str) -> str:
    """Return a text as a CSV cell, with a leading ``'`` if a spreadsheet would evaluate it as a formula.

    >>> guard_formula("=1+1"), guard_formula("-5 kg"), guard_formula("'=1+1"), guard_formula("front")
    ("'=1+1", "'-5 kg", "''=1+1", 'front')
    """
    return f"'{text}" if _FORMULA.match(text) else text


def unguard_formula(text: str) -> str:
    """Undo `guard_formula`; return other texts unchanged.

    >>> unguard_formula(guard_formula("'=1+1"))
    "'=1+1"
    """
    return text[1:] if text.startswith("'") and _FORMULA.match(text) else text


def guard_row(row: Iterable[Any]) -> list[Any]:
    r"""Return the cells of a CSV row with texts guarded; an unquoted ``\r`` would end the row."""
    return [
        guard_formula(cell).replace("\r", "\n") if isinstance(cell, str) else cell for cell in row
    ]


def align_columns(rows: Sequence[Sequence[str]], left: int = 1) -> list[str]:
    """Return the lines of a table: the first ``left`` columns are left-aligned, the others right-aligned.

    >>> align_columns([["", "N/m"], ["spring", "22730"], ["tyre", "9.1"]])
    ['          N/m', 'spring  22730', 'tyre      9.1']
    """
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(
            cell.rjust(w) if i >= left else cell.ljust(w)
            for i, (cell, w) in enumerate(zip(row, widths, strict=True))
        )
        for row in rows
    ]


def without_accents(text: str) -> str:
    """Convert text to lower case without accents, for comparisons across keyboards.

    >>> without_accents("Prędkość, Ângulo, koło")
    'predkosc, angulo, kolo'
    """
    folded = normalize("NFKD", text.casefold()).translate({ord("ł"): "l", ord("ø"): "o"})
    return "".join(letter for letter in folded if not combining(letter))


def slug(text: str) -> str:
    """Convert a name to a file name of at most 80 ASCII letters, digits and hyphens.

    Examples
    --------
    >>> slug("Strategy 2: Größe/all"), slug("?!")
    ('strategy-2-grosse-all', 'unnamed')
    """
    plain = normalize("NFKD", text.replace("ß", "ss")).encode("ascii", "ignore").decode()
    return re.sub(r"[^a-z0-9]+", "-", plain.lower()).strip("-")[:80].rstrip("-") or "unnamed"


_MOST_PLACES = 6


def listed_places(places: list[str]) -> str:
    """List the places that a sentence refers to; if there are very many, only the first ones.

    >>> listed_places(["trial 1", "trial 2"]), listed_places([f"trial {n}" for n in range(1, 17)])
    ('trial 1, trial 2', 'trial 1, trial 2, trial 3, trial 4, trial 5, trial 6 and 10 more')
    """
    more = f" and {len(places) - _MOST_PLACES} more" if len(places) > _MOST_PLACES else ""
    mark = "; " if any(", " in place for place in places) else ", "
    return mark.join(places[:_MOST_PLACES]) + more


def is_number(text: str) -> bool:
    """Whether a text is a number with a decimal point; Python's underscores are damage in a file.

    >>> [is_number(text) for text in ("-1.5e3", "nan", "1,5", "1_0", "")]
    [True, True, False, False, False]
    """
    try:
        float(text)
    except ValueError:
        return False
    return "_" not in text
