"""The user's choice whether foreign programs (FMUs) may run in this process."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_SAID: ContextVar[bool | None] = ContextVar("trust", default=None)


def trust_said() -> bool | None:
    """Return the user's choice; None without one, as in Python: then the description decides.

    >>> with trusting(False):
    ...     trust_said()
    False
    >>> trust_said()
    """
    return _SAID.get()


@contextmanager
def trusting(whether: bool | None) -> Iterator[None]:
    """Trust foreign programs in a block, or not, overriding their descriptions; None leaves the choice to them.

    Processes started in the block do not inherit the choice: the caller has to pass it to them (`trust_said`).
    """
    token = _SAID.set(whether)
    try:
        yield
    finally:
        _SAID.reset(token)
