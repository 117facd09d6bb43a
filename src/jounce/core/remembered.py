"""What is made once and found again: beside the frozen object that it follows from, or by a key."""

from __future__ import annotations

import contextlib
import sys
import weakref
from collections import OrderedDict
from collections.abc import Callable, Hashable
from functools import wraps
from typing import Any, ClassVar, Generic, TypeVar

Thing = TypeVar("Thing")
Found = TypeVar("Found")
_NOTHING: Any = object()


def remembered(function: Callable[[Thing], Found]) -> Callable[[Thing], Found]:
    """Call a function once for each object it is given: what it gave is kept beside the object, not in it.

    The object must never change, and what the function gives is shared by all who ask: it must not change either, and
    must not hold the object, which would then live for ever. Objects count by identity, not by what they are equal to.

    >>> @remembered
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
        kept = known.get(place)
        if kept is not None and kept[0]() is thing:
            return kept[1]
        found = function(thing)

        def forget(gone: weakref.ref[Any]) -> None:
            if place in known and known[place][0] is gone:
                del known[place]

        known[place] = weakref.ref(thing, forget), found
        return found

    return recall


class Recent(Generic[Found]):
    """Things made when they are first asked for, by their keys. All are kept, or as many as were asked for last.

    A command meets a few models; a server that runs for weeks meets every one that is drawn in it, and sets ``most``
    for all that is kept so. ``own`` is a bound of one of them, however many the process may keep.

    >>> squares = Recent()
    >>> squares.of(3, lambda: 9), squares.of(3, lambda: print("not asked"))
    (9, 9)
    """

    most: ClassVar[int] = sys.maxsize

    def __init__(self, own: int = sys.maxsize) -> None:
        self._own, self._kept = own, OrderedDict[Hashable, Found]()

    def of(self, key: Hashable, make: Callable[[], Found]) -> Found:
        """Give what belongs to a key; two threads that ask for it at once may both make it, and get the same."""
        found: Found = self._kept.get(key, _NOTHING)
        if found is _NOTHING:
            found = self._kept.setdefault(key, make())
            while len(self._kept) > min(self._own, self.most):
                self._kept.popitem(last=False)
        else:
            with contextlib.suppress(KeyError):  # let go by another thread
                self._kept.move_to_end(key)
        return found

    def clear(self) -> None:
        """Let go of all."""
        self._kept.clear()
