"""Memory that the server gives back to the system: freed blocks, and pages of program files."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from mmap import PAGESIZE
from typing import Any

_ARENAS, _LARGE, _TRIMMED = (
    (-8, 1),
    (-3, 1 << 16),
    (-1, 1 << 20),
)  # M_ARENA_MAX, M_MMAP_THRESHOLD, M_TRIM_THRESHOLD
_LOADED, _WRITABLE, _DROP = 1, 2, 4  # PT_LOAD, PF_W, MADV_DONTNEED


class _Segment(ctypes.Structure):
    """Part of a program file in memory (Elf64_Phdr)."""

    _fields_ = (
        ("kind", ctypes.c_uint32), ("flags", ctypes.c_uint32), ("offset", ctypes.c_uint64),
        ("address", ctypes.c_uint64), ("physical", ctypes.c_uint64), ("in_file", ctypes.c_uint64),
        ("in_memory", ctypes.c_uint64), ("alignment", ctypes.c_uint64),
    )  # fmt: skip


class _ProgramFile(ctypes.Structure):
    """Program file in memory: the start of dl_phdr_info."""

    _fields_ = (
        ("base", ctypes.c_uint64),
        ("name", ctypes.c_char_p),
        ("segments", ctypes.POINTER(_Segment)),
        ("count", ctypes.c_uint16),
    )


_VISIT = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.POINTER(_ProgramFile), ctypes.c_size_t, ctypes.c_void_p
)


def give_memory_back() -> Callable[[], object]:
    """Configure glibc to return freed memory to the system; return a function that returns what is not needed now.

    Otherwise each worker thread keeps its own heap, as large as its largest run, and free fragments between used
    blocks remain in the process: a few megabytes per hour. Code and constants of libraries, most of which ran once
    while they were loaded, are read again from the system's cache of files when they are needed.
    """
    library = ctypes.CDLL(None) if sys.platform == "linux" else None
    if library is None or not hasattr(library, "malloc_trim"):
        return lambda: None
    for option, value in (_ARENAS, _LARGE, _TRIMMED):
        library.mallopt(option, value)

    def give() -> None:
        library.malloc_trim(0)
        drop_program_pages()

    return give


def drop_program_pages() -> None:
    """Drop the pages of code and constants; they were never written, since only writable segments are relocated."""
    if sys.platform != "linux" or ctypes.sizeof(ctypes.c_void_p) != 8:
        return
    library = ctypes.CDLL(None)
    library.madvise.argtypes = (ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int)
    spans: list[tuple[int, int]] = []

    def visit(found: Any, _size: int, _data: Any) -> int:
        file = found.contents
        for segment in file.segments[: file.count]:
            if segment.kind == _LOADED and not segment.flags & _WRITABLE:
                begin = file.base + segment.address  # whole pages only: others may border on data
                start = -(-begin // PAGESIZE) * PAGESIZE
                size = (begin + segment.in_memory) // PAGESIZE * PAGESIZE - start
                if size > 0:
                    spans.append((start, size))
        return 0

    library.dl_iterate_phdr(_VISIT(visit), None)
    for start, size in spans:
        library.madvise(start, size, _DROP)
