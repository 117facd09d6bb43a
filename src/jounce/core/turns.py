"""Concurrent requests for one object: the first thread creates it, the others wait and share it."""

from __future__ import annotations

import os
from collections.abc import Hashable, Iterator
from contextlib import contextmanager
from functools import cached_property
from threading import RLock
from typing import Any, Self, TypeVar, overload

from jounce.core.interrupts import interrupt_after

Value = TypeVar("Value")
_MISSING: Any = object()


class _Turns:
    """One lock for each object, kept while a thread creates the object or waits for it."""

    def __init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        self._lock = RLock()
        self._turns: dict[
            Hashable, list[Any]
        ] = {}  # lock, number of threads that hold it or wait for it

    @contextmanager
    def of(self, key: Hashable) -> Iterator[None]:
        with self._lock:
            entry = self._turns.setdefault(key, [RLock(), 0])
            entry[1] += 1
        try:
            with entry[0]:
                yield
        finally:
            with self._lock:
                entry[1] -= 1
                if not entry[1]:
                    self._turns.pop(key, None)


_turns = _Turns()
turn = _turns.of
"""Lock by key: ``with turn(key):`` runs for one thread at a time, and may be nested in the same thread."""

if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        after_in_child=_turns.forget
    )  # the threads that held them are not in the child


class once(cached_property[Value]):  # noqa: N801 - used as a decorator, like `cached_property`
    """A ``cached_property`` that one thread computes while others wait (since Python 3.12, that has no lock).

    Use it for expensive properties, or if all threads need the same object.

    >>> class Rig:
    ...     @once
    ...     def mass(self):
    ...         print("weighed")
    ...         return 28.0
    >>> rig = Rig()
    >>> rig.mass, rig.mass
    weighed
    (28.0, 28.0)
    """

    @overload
    def __get__(self, thing: None, owner: type[Any] | None = None) -> Self: ...

    @overload
    def __get__(self, thing: object, owner: type[Any] | None = None) -> Value: ...

    def __get__(self, thing: object, owner: type[Any] | None = None) -> Any:
        """Compute the value at the first access; later accesses find it in the object's ``__dict__``."""
        if thing is None:
            return self
        name = str(self.attrname)
        with turn((id(thing), name)):
            value = thing.__dict__.get(name, _MISSING)
            if value is _MISSING:
                with interrupt_after():
                    value = self.func(thing)
                thing.__dict__[name] = value
            return value
