"""Python functions made callable from compiled loops."""

from __future__ import annotations

import ctypes
from collections.abc import Callable

_PROTOTYPE = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 5)


class Callback:
    """A Python function at an address; what it raises is kept, since nothing may pass through compiled code.

    The loop holds the interpreter's lock (it never lets go of it), and the call takes it again, which is free.
    ``address`` is that of ``void f(void*, void*, void*, void*, void*)``, which lives as long as this object; ``raised``
    is what the function raised, or None.

    Parameters
    ----------
    function, failed : callable
        What is called; what is called after it raised.
    """

    def __init__(self, function: Callable[[], None], failed: Callable[[], None]) -> None:
        self.raised: BaseException | None = None

        def call(*_: object) -> None:
            try:
                function()
            except BaseException as error:  # noqa: BLE001 - also an interrupt must wait for the loop to end
                self.raised = error
                failed()

        self._call = _PROTOTYPE(call)
        self.address = int(ctypes.cast(self._call, ctypes.c_void_p).value or 0)
