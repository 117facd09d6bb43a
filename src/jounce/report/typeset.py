"""Documents set by typst: the same bytes for the same content, with the fonts of matplotlib and nothing else."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

_LONGEST_WORD, _PIECE = 24, 12


def compiled(files: Mapping[str, bytes], form: str, **options: Any) -> Any:
    """Let typst set a document: PDF as bytes, pictures as a list of pages."""
    import matplotlib as mpl
    import typst

    fonts = Path(mpl.get_data_path()) / "fonts" / "ttf"
    compile_files: Any = typst.compile  # its types do not know files by name
    made = compile_files(dict(files), format=form, font_paths=[str(fonts)], ignore_system_fonts=True, **options)
    return [made] if form == "png" and isinstance(made, bytes) else made


def breakable(value: Any) -> Any:
    """Let words that are longer than any column be broken."""
    if isinstance(value, Mapping):
        return {key: item if key == "figure" else breakable(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [breakable(item) for item in value]
    if not isinstance(value, str):
        return value
    return " ".join(
        "\u200b".join(word[i : i + _PIECE] for i in range(0, len(word), _PIECE)) if len(word) > _LONGEST_WORD else word
        for word in value.split(" ")
    )
