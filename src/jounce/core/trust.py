"""Whether foreign programs (FMUs) may run in this process, by the user's choice."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_SAID: ContextVar[bool | None] = ContextVar("trust", default=None)


def trust_said() -> bool | None:
    """The user's choice; None without one, as in Python: then the description decides.

    >>> with trusting(False):
    ...     trust_said()
    False
    >>> trust_said()
    """
    return _SAID.get()


@contextmanager
def trusting(whether: bool | None) -> Iterator[None]:
    """Trust foreign programs in a block, or not, whatever their descriptions say; None leaves it to the descriptions.

    Processes that are begun within do not know of it: who begins them tells them (`trust_said`).
    """
    token = _SAID.set(whether)
    try:
        yield
    finally:
        _SAID.reset(token)
