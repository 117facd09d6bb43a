"""SVG figures as part of a page: no header, names that do not collide, a description for those who cannot see."""

from __future__ import annotations

import re
from html import escape

_STYLE = re.compile(r"<style type=\"text/css\">.*?</style>", re.DOTALL)
_PIXELS_PER_POINT = 1.6  # on a wide screen: text of 9 pt becomes as large as that of the page
_FULL_WIDTH = 547.0  # points
_SIZE = re.compile(r' (?:width|height)="[\d.]+pt"')


def inline_svg(svg: bytes, name: str, alternative: str) -> str:
    """Make an SVG file part of an HTML page.

    Parameters
    ----------
    svg : bytes
        The file as matplotlib writes it.
    name : str
        Unique on the page; every name inside the figure begins with it.
    alternative : str
        Text for readers who cannot see the figure.

    Returns
    -------
    str
        One ``<svg>`` element that scales with the page.
    """
    text = svg.decode()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = _STYLE.sub("", text)
    text = re.sub(r'\bid="([^"]+)"', rf'id="{name}-\1"', text)
    text = re.sub(r"url\(#([^)]+)\)", rf"url(#{name}-\1)", text)
    text = re.sub(r'xlink:href="#([^"]+)"', rf'href="#{name}-\1"', text)
    head, _, body = text.partition(">")
    width = re.search(r' width="([\d.]+)pt"', head)
    limit = ""
    if width is not None:
        points = float(width[1])
        share = min(points / _FULL_WIDTH, 1.0)
        limit = f' style="max-width: {_PIXELS_PER_POINT * points:.0f}px; --share: {share:.2f}"'
    head = _SIZE.sub("", head).replace(' version="1.1"', "")
    head = re.sub(r' xmlns:xlink="[^"]+"', "", head)
    label = f'role="img" aria-labelledby="{name}-title"'
    return f'{head} {label}{limit}><title id="{name}-title">{escape(alternative)}</title>{body}'.strip()
