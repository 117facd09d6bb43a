"""Comments in TOML documents: written on the lines of values, and removed together with them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import tomlkit
from tomlkit.container import Container
from tomlkit.items import Comment, InlineTable, Null, Table

from jounce.core.text import in_one_line


def annotate(document: tomlkit.TOMLDocument, path: Sequence[str | int], words: str) -> None:
    """Write a comment on the line of the value at a path, replacing an existing one and those directly above.

    A line with several values keeps its comment. A value that is not in the file gets no comment.
    """
    way = _way_to(document, path)
    if not way:
        return
    item: Any = way[-1][0].body[way[-1][1]][1]
    if not isinstance(item, Table):
        for container, place in reversed(
            way
        ):  # the comments above `strut.angle = ...` are stored above `strut`
            key = container.body[place][0]
            if (container, place) != way[-1] and not (key is not None and key.is_dotted()):
                break
            _drop_comments_above(container, place)
    comment = ""
    if isinstance(item, InlineTable):
        comment, words = item.trivia.comment.removeprefix("#").strip(), f"{path[-1]} {words}"
    gap = item.trivia.comment_ws or "  "
    item.comment(in_one_line(f"{comment}; {words}" if comment else words))
    item.trivia.comment_ws = gap  # the comment reduced it to one blank


def _way_to(container: Container, parts: Sequence[str | int]) -> list[tuple[Container, int]]:
    """Return the container of each part of a path and the index in it, as far as the file contains the path.

    A table written with dotted keys (`strut.angle = ...`) occurs several times; the longest match is used.
    """
    ways: list[list[tuple[Container, int]]] = []
    for place, (key, item) in enumerate(container.body):
        if key is not None and key.key == parts[0]:
            below = _way_to(item.value, parts[1:]) if isinstance(item, Table) and parts[1:] else []
            ways.append([(container, place), *below])
    return max(ways, key=len, default=[])


def _drop_comments_above(container: Container, place: int) -> None:
    while place and isinstance(container.body[place - 1][1], Comment):
        place -= 1
        container.body[place] = (None, Null())


def without_head(text: str) -> str:
    """Remove the comments at the beginning of a file."""
    lines = text.split("\n")
    first = next(
        (i for i, line in enumerate(lines) if line.strip() and not line.startswith("#")), 0
    )
    return "\n".join(lines[first:])
