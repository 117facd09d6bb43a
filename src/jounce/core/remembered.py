"""Caches of results, by the frozen object they are derived from, or by a key."""

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
    """Decorate a function to be called once for each object; results are cached outside the object.

    The object must never change. The result is shared by all callers: it must not change either, and must not refer to
    the object, which would then never be freed. Objects are compared by identity, not by equality. Concurrent threads
    get the same result: one of them calls the function, the others wait.

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
    """Cache of objects by key, created on first request. All are kept, or only the most recently used ones.

    A command uses only a few models, but a server that runs for weeks uses many. It sets ``most``, the limit of every
    such cache. ``own`` is the limit of this cache alone; the smaller of both applies.

    >>> squares = Recent()
    >>> squares.of(3, lambda: 9), squares.of(3, lambda: print("not asked"))
    (9, 9)
    """

    most: ClassVar[int] = sys.maxsize
    _lock: ClassVar[Any] = RLock()  # held briefly, never while an object is created

    def __init__(self, own: int = sys.maxsize) -> None:
        self._own, self._kept = own, OrderedDict[Hashable, Found]()

    def of(self, key: Hashable, make: Callable[[], Found]) -> Found:
        """Return the object of a key; the first of several threads creates it, the others wait."""
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
        """Remove all objects."""
        with self._lock:
            self._kept.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=Recent._lock._at_fork_reinit)
