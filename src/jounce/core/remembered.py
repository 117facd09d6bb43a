"""What follows from a frozen object alone, computed once while that object lives."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar

Thing = TypeVar("Thing")
Found = TypeVar("Found")


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
