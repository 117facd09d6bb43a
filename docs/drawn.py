"""Pictures of these pages, drawn when the documentation is built: one drawing, in light and in dark.

``write`` draws missing and outdated pictures. The dark version is the light one with different colours.
"""

from __future__ import annotations

import base64
import hashlib
import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).with_name("_generated") / "figures"
DARK = {  # ink, grey, grid, background and the colours of lines, each as bright on dark as it is dark on bright
    "#22262b": "#e6e9ec", "#666d75": "#a9b0b8", "#e3e6ea": "#33383e", "#ffffff": "#131416", "#9aa1a9": "#737a82",
    "#30353b": "#d5d9dd", "#000000": "#e6e9ec", "#0067a8": "#4da3dd", "#d55e00": "#ef8432", "#00896b": "#2fb795",
    "#a64d8f": "#d07fbd", "#b8860b": "#d6ab3c", "#3fa0d8": "#7cc4ee", "#d98a1f": "#eda74c", "#b5472a": "#e67a5c",
    "#b7791f": "#dba24a", "#dbe4ec": "#25384a", "#ebebeb": "#2a2d31", "#2b6ea3": "#5b9fd6", "#f3f4f6": "#1d2024",
}  # fmt: skip
_ROUNDED = 12  # of 255: colours of pale pixels are rounded


def write(name: str, make: Callable[[], Any], made_from: str) -> None:
    """Write ``name-light.svg`` and ``name-dark.svg`` unless both exist and are up to date."""
    if is_made(name, made_from):
        return
    from jounce.plots import render_figure

    light, dark, stamp = _files(name)
    FOLDER.mkdir(parents=True, exist_ok=True)
    text = render_figure(make(), [".svg"])[".svg"].decode()
    light.write_text(text, encoding="utf-8")
    dark.write_text(in_the_dark(text), encoding="utf-8")
    stamp.write_text(_mark(made_from), encoding="utf-8")


def is_made(name: str, made_from: str) -> bool:
    """Whether both pictures exist and come from this source."""
    light, dark, stamp = _files(name)
    is_there = light.is_file() and dark.is_file() and stamp.is_file()
    return is_there and stamp.read_text(encoding="utf-8") == _mark(made_from)


def _files(name: str) -> list[Path]:
    return [FOLDER / f"{name}{end}" for end in ("-light.svg", "-dark.svg", ".stamp")]


def _mark(made_from: str) -> str:
    return hashlib.sha256(
        (made_from + Path(__file__).read_text(encoding="utf-8")).encode()
    ).hexdigest()


def in_the_dark(text: str) -> str:
    """Convert the colours of a picture for a dark page; unlisted colours keep their hue and change brightness."""
    text = re.sub(
        r"(?<![\w-])(white|black)(?=[;\"'])",
        lambda m: {"white": "#ffffff", "black": "#000000"}[m[1]],
        text,
    )
    text = re.sub(r"#[0-9a-fA-F]{6}\b", lambda m: DARK.get(m[0].lower()) or _turned(m[0]), text)
    return re.sub(
        r"(?<=data:image/png;base64,)[\w+/=\s]+", lambda m: _points_in_the_dark(m[0]), text
    )


def _points_in_the_dark(encoded: str) -> str:
    """Convert embedded images of point clouds: pixels of listed colours change, colour maps stay."""
    import numpy as np
    from PIL import Image

    pixels = np.array(Image.open(io.BytesIO(base64.b64decode(encoded))).convert("RGBA"))
    colour = pixels[..., :3].astype(int)
    for bright, dark in DARK.items():
        here, there = (
            np.array([int(one[i : i + 2], 16) for i in (1, 3, 5)]) for one in (bright, dark)
        )
        meant = (np.abs(colour - here).max(axis=-1) <= _ROUNDED) & (pixels[..., 3] > 0)
        pixels[meant, :3] = there
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, format="png")
    return base64.b64encode(stream.getvalue()).decode()


def _turned(colour: str) -> str:
    """Invert the brightness of a colour: light fills become dark."""
    import colorsys

    red, green, blue = (int(colour[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    hue, light, full = colorsys.rgb_to_hls(red, green, blue)
    turned = colorsys.hls_to_rgb(hue, 0.07 + 0.86 * (1.0 - light), full)
    return "#" + "".join(f"{round(255 * one):02x}" for one in turned)
