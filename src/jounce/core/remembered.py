"""Caches: of results beside the frozen object they derive from, or by a key."""

from __future__ import annotations

import os
import sys
import weakref
from collections import OrderedDict
from collections.abc import Callable, Hashable
from functools import wraps
from threading import RLock
from typing import Any, ClassVar, Generic, TypeVar

from jounce.core.interrupts import interrupt_after
from jounce.core.turns import turn

Thing = TypeVar("Thing")
Found = TypeVar("Found")
_NOTHING: Any = object()


def once_per_object(function: Callable[[Thing], Found]) -> Callable[[Thing], Found]:
    """Call a function once for each object; the result is cached beside the object, not in it.

    The object must never change, and what the function gives is shared by all who ask: it must not change either, and
    must not hold the object, which would then never be freed. Objects are compared by identity, not by equality.
    Concurrent threads get the same result: one of them calls, the others wait.

    >>> @once_per_object
    ... def size(description):
    ...     print("asked")
    ...     return len(description)
    >>> rig = frozenset("abc")
    >>> size(rig), size(rig)
    asked
    (3, 3)
    """
    known: dict[int, tuple[weakref.ref[Any], Found]] = {}

    @wraps(function)
    def recall(thing: Thing) -> Found:
        place = id(thing)
        entry = known.get(place)
        if entry is not None and entry[0]() is thing:
            return entry[1]

        def forget(gone: weakref.ref[Any]) -> None:
            if place in known and known[place][0] is gone:
                known.pop(place, None)

        with turn((recall, place)):
            entry = known.get(place)
            if entry is None or entry[0]() is not thing:
                entry = known[place] = weakref.ref(thing, forget), function(thing)
            return entry[1]

    return recall


class Recent(Generic[Found]):
    """Objects made on first request, by their keys. All are kept, or only the most recent ones.

    A command meets a few models; a server that runs for weeks meets every one that is drawn in it, and sets ``most``
    for all that is entry so. ``own`` is a bound of one of them, however many the process may keep.

    >>> squares = Recent()
    >>> squares.of(3, lambda: 9), squares.of(3, lambda: print("not asked"))
    (9, 9)
    """

    most: ClassVar[int] = sys.maxsize
    _lock: ClassVar[Any] = RLock()  # held for moments only, never while something is made

    def __init__(self, own: int = sys.maxsize) -> None:
        self._own, self._kept = own, OrderedDict[Hashable, Found]()

    def of(self, key: Hashable, make: Callable[[], Found]) -> Found:
        """Return the object of a key; among several threads the first makes it and the others wait."""
        value = self._recall(key)
        if value is _NOTHING:
            with turn((id(self), key)):
                value = self._recall(key)
                if value is _NOTHING:
                    with interrupt_after():
                        value = make()
                    self._keep(key, value)
        return value

    def _recall(self, key: Hashable) -> Found:
        with self._lock:
            value: Found = self._kept.get(key, _NOTHING)
            if value is not _NOTHING:
                self._kept.move_to_end(key)
        return value

    def _keep(self, key: Hashable, value: Found) -> None:
        with self._lock:
            self._kept[key] = value
            while len(self._kept) > min(self._own, self.most):
                self._kept.popitem(last=False)

    def clear(self) -> None:
        """Release all."""
        with self._lock:
            self._kept.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=Recent._lock._at_fork_reinit)
