"""Errors of the validators of descriptions: their parts are data, not a text."""

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
    """Build the error of a validator about the value at ``path`` below the description that is validated.

    The parts are those of an error (`JounceError`); ``found`` are words, or text of the user's.
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
    """Build the error of a validator of what is wrong with the value at ``path``."""
    value = None if error.found is None else as_found(error.found)
    what = below(error.where, Phrase(error.what)) if error.where else error.what
    return error_at(path, what, found=value, allowed=error.allowed, hint=error.hint)
