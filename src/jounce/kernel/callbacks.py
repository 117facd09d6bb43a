"""Python functions made callable from compiled loops."""

from __future__ import annotations

import ctypes
from collections.abc import Callable

_PROTOTYPE = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 5)


class Callback:
    """A Python function at an address; what it raises is kept, since nothing may pass through compiled code.

    The loop holds the interpreter's lock (it never lets go of it), and the call takes it again, which is free.

    Attributes
    ----------
    address : int
        Of ``void f(void*, void*, void*, void*, void*)``; it lives as long as this object.
    raised : BaseException or None
        What the function raised.
    """

    def __init__(self, function: Callable[[], None], failed: Callable[[], None]) -> None:
        """Make ``function`` callable; ``failed`` is called after it raised."""
        self.raised: BaseException | None = None

        def call(*_: object) -> None:
            try:
                function()
            except BaseException as error:  # noqa: BLE001 - also an interrupt must wait for the loop to end
                self.raised = error
                failed()

        self._call = _PROTOTYPE(call)
        self.address = int(ctypes.cast(self._call, ctypes.c_void_p).value or 0)
