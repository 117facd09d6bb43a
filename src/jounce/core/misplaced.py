"""Errors raised by validators of descriptions; their parts are kept as data, not joined to a text."""

from __future__ import annotations

from pydantic_core import PydanticCustomError

from jounce.core.errors import JounceError, Message, as_found, below, show_value
from jounce.core.phrases import Phrase


def error_at(
    path: tuple[str | int, ...],
    what: str,
    *,
    found: str | None = None,
    allowed: str = "",
    hint: str = "",
) -> PydanticCustomError:
    """Build a validator's error for the value at ``path`` below the description being validated.

    The parts are those of a `JounceError`; ``found`` is a phrase, or text from the user.
    """
    parts = {"what": what, "found": found, "allowed": allowed, "hint": hint}
    text = Message(
        what, found=None if found is None else show_value(found), allowed=allowed, hint=hint
    )
    template = (
        text.removesuffix(".").replace("{", "(").replace("}", ")").encode(errors="replace").decode()
    )
    return PydanticCustomError("misplaced", template, {"path": list(path), "parts": parts})


def misplaced_value(path: tuple[str | int, ...], error: JounceError) -> PydanticCustomError:
    """Build a validator's error for the value at ``path`` from an error of jounce."""
    value = None if error.found is None else as_found(error.found)
    what = below(error.where, Phrase(error.what)) if error.where else error.what
    return error_at(path, what, found=value, allowed=error.allowed, hint=error.hint)
