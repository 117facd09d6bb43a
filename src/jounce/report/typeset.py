"""Typesetting with typst: reproducible output, using the fonts of matplotlib wherever they suffice."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from jounce.core.optional import require
from jounce.plots.figures import library

TYPESETTER = ("typst", "pdf")
"""Package that typesets documents and renders SVG, and the extra that installs it."""
_LONGEST_WORD, _PIECE = 24, 12


def typeset(files: Mapping[str, bytes], form: str, **options: Any) -> Any:
    """Typeset a document with typst: PDF as bytes, images as a list of pages.

    System fonts are used only for characters missing in those of matplotlib, such as Chinese ones.
    """
    typst = require(*TYPESETTER)
    texts = (
        content.decode(errors="replace")
        for name, content in files.items()
        if name.endswith((".json", ".svg"))
    )
    is_covered = not any(missing_letters(text) for text in texts)
    compile_files: Any = typst.compile  # its type stubs lack files by name
    fonts = {"font_paths": [str(_fonts())], "ignore_system_fonts": is_covered}
    made = compile_files(dict(files), format=form, **fonts, **options)
    return [made] if form == "png" and isinstance(made, bytes) else made


def missing_letters(text: str) -> str:
    """Return the distinct characters of a text that are missing in the fonts of matplotlib.

    Examples
    --------
    >>> missing_letters("Größe ω² ≤ 漢字漢")
    '字漢'
    """
    return "".join(
        sorted(
            letter
            for letter in set(text) - _letters()
            if letter.isprintable() and ord(letter) > _ASCII
        )
    )


_ASCII = 0x7F


@cache
def _letters() -> frozenset[str]:
    fonts = _fonts()
    from matplotlib.ft2font import FT2Font

    return frozenset(map(chr, FT2Font(str(fonts / "DejaVuSans.ttf")).get_charmap()))


def _fonts() -> Path:
    return Path(library().get_data_path()) / "fonts" / "ttf"


def breakable(value: Any) -> Any:
    """Allow breaks in words that are longer than any column."""
    if isinstance(value, Mapping):
        return {key: item if key == "figure" else breakable(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [breakable(item) for item in value]
    if not isinstance(value, str):
        return value
    return " ".join(
        "\u200b".join(word[i : i + _PIECE] for i in range(0, len(word), _PIECE))
        if len(word) > _LONGEST_WORD
        else word
        for word in value.split(" ")
    )
