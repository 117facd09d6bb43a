"""Error classes. Every message states the location, the value found, the allowed values and the next step."""

from __future__ import annotations

import copyreg
import difflib
import errno
import math
import os
from collections.abc import Iterable, Sequence
from typing import Any

from jounce.core.phrases import Phrase, Phrases, german_of, in_german
from jounce.core.text import shorten

_LONGEST, _LONGEST_PLACE, _LONGEST_VALUE = 4000, 1000, 300
"""Maximum length of a quoted value in characters: file contents may be long, messages must not."""


class JounceError(Exception):
    """An error in the user's input, or an outcome the user must know about.

    Parameters
    ----------
    what : str
        Description of the problem, one sentence without a full stop.
    where : str
        File and line, path inside a description, or channel.
    found : object
        The offending value with its unit; omitted from the text if None.
    allowed : str
        Accepted values.
    hint : str
        The next step for the reader.

    Notes
    -----
    Parts that are a `Phrase` keep the fields of their templates: `message` can be translated to German,
    ``str(error)`` is plain English text.
    """

    path: tuple[str | int, ...] = ()
    """Keys of the offending value in a description."""
    line: int | None = None
    """Line of that value in a file."""
    problems: Sequence[JounceError] = ()
    """Individual errors, if this one lists several."""

    def __init__(
        self, what: str, *, where: str = "", found: object = None, allowed: str = "", hint: str = ""
    ) -> None:
        self.what, self.where, self.found, self.allowed, self.hint = (
            what,
            where,
            found,
            allowed,
            hint,
        )
        super().__init__(str(self.message()))

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle as text and attributes, independently of the constructor's arguments in a subclass."""
        plain = (
            self.found
            if isinstance(self.found, (str, int, float, type(None)))
            else show_value(self.found)
        )
        return copyreg.__newobj__, (type(self), *self.args), {**vars(self), "found": plain}  # type: ignore[attr-defined]

    def message(self, *, placed: bool = True, within: str = "") -> Phrase:
        """Return its parts as one sentence, with the location if ``placed``; omit the prefix ``within`` from that."""
        found = None if self.found is None else show_value(self.found)
        where = self.where if placed and self.where != within else ""
        if within and where.startswith(f"{within}: "):
            where = where.removeprefix(f"{within}: ")
        return Message(self.what, where=where, found=found, allowed=self.allowed, hint=self.hint)


class Message(Phrase):
    """Text of an error: its parts in one sentence, in English and German."""

    __slots__ = ("_parts",)
    _parts: tuple[str, str, str | None, str, str]
    _ENGLISH = ("; found ", "; allowed: ")
    _GERMAN = ("; gefunden ", "; zulässig: ")

    def __new__(
        cls,
        what: str,
        /,
        *,
        where: str = "",
        found: str | None = None,
        allowed: str = "",
        hint: str = "",
    ) -> Message:
        """Join the parts; ``found`` is the text of the value."""
        text = shorten(what, _LONGEST)
        parts = (shorten(where, _LONGEST_PLACE), text, found, shorten(allowed, _LONGEST), hint)
        message = str.__new__(cls, cls._join(cls._ENGLISH, *parts))
        message._parts = parts
        return message

    def __reduce__(self) -> tuple[Any, ...]:
        return _message, self._parts

    def german(self) -> str | None:
        """German text; None if there is no translation."""
        where, what, value, allowed, hint = self._parts
        wrong = german_of(what)
        if wrong is None:
            return None
        rest = german_of(allowed) or allowed, german_of(hint) or hint
        return self._join(self._GERMAN, in_german(where), wrong, in_german(value), *rest)

    @staticmethod
    def _join(
        words: tuple[str, str], where: str, what: str, value: str | None, allowed: str, hint: str
    ) -> str:
        text = f"{where}: {what}" if where else what
        if value is not None:
            text += f"{words[0]}{value}"
        if allowed:
            text += f"{words[1]}{allowed}"
        if hint:
            return f"{text if text.endswith(('.', '?')) else f'{text}.'} {hint}"
        return text if text.endswith((".", "?")) else f"{text}."


class Clause(Phrase):
    """A message without its full stop, as a part of another sentence.

    Examples
    --------
    >>> Clause(DescriptionError("out of range").message()), Clause("no value.")
    ('out of range', 'no value')
    """

    __slots__ = ("_whole",)
    _whole: str

    def __new__(cls, message: str, /) -> Clause:
        """Remove the full stop."""
        clause = str.__new__(cls, message.removesuffix("."))
        clause._whole = message
        return clause

    def __reduce__(self) -> tuple[Any, ...]:
        return Clause, (self._whole,)

    def german(self) -> str | None:
        """German text; None if the message has no translation."""
        german = german_of(self._whole)
        return None if german is None else german.removesuffix(".")


def _message(where: str, what: str, value: str | None, allowed: str, hint: str) -> Message:
    return Message(what, where=where, found=value, allowed=allowed, hint=hint)


class DescriptionError(JounceError):
    """A description (rig, road, trial, campaign) that is invalid."""


class RecordingError(JounceError):
    """A measured file that cannot be read or trusted."""


class AssemblyError(JounceError):
    """A model that cannot be assembled."""


class SimulationError(JounceError):
    """A run that did not reach its end."""


class FitError(JounceError):
    """An estimate that cannot be computed from the given data."""


class OutputError(JounceError):
    """A file that cannot be written, or not without losing data."""


class ResourceError(JounceError):
    """A resource that is missing or fails, such as memory, independently of the processed file."""


class DiskError(ResourceError, OutputError):
    """A disk that is full or fails."""


NO_THREAD = "can't start new thread"
"""Python's message if the system does not allow more threads."""
_MEMORY = ("out of memory", "Close other programs, or raise the memory limit (ulimit -v).")
_PROCESSES = (
    "no more processes or threads can be started",
    "End other programs, or raise the limit of processes and threads (ulimit -u).",
)
_FILES = (
    "too many open files",
    "End other programs, or raise the limit of open files (ulimit -n).",
)
_SIZE = (
    "the file exceeds the size limit of this process",
    "Raise the limit of the size of files (ulimit -f).",
)
_LIBRARY = (
    "a library cannot be loaded",
    "Is the installation complete, and is there enough memory for it (ulimit -v)?",
)
WHERE_WRITTEN = "Check the path, the permissions and the free disk space."
"""Advice if the system refuses to write."""
_DISK = ("the disk is full or faulty", WHERE_WRITTEN)
_LACKING = {
    "ENOMEM": _MEMORY,
    "EAGAIN": _PROCESSES,
    "EMFILE": _FILES,
    "ENFILE": _FILES,
    "EFBIG": _SIZE,
    **dict.fromkeys(("ENOSPC", "EDQUOT", "EIO", "EROFS", "ESTALE"), _DISK),
}
"""Missing resource and advice, by the name of the system error."""
_BY_NUMBER = {getattr(errno, name, -1): told for name, told in _LACKING.items()}


def is_of_system(error: BaseException) -> bool:
    """Whether an error comes from the system or the disk, not from a file or its content.

    >>> is_of_system(OSError(errno.ENOSPC, "")), is_of_system(OSError(errno.ENOENT, "")), is_of_system(MemoryError())
    (True, False, True)
    """
    return isinstance(error, ResourceError) or _lacking(error) is not None


def _lacking(error: BaseException) -> tuple[str, str] | None:
    """Missing resource and advice; None for other errors."""
    if isinstance(error, OSError) and error.errno in _BY_NUMBER:
        return _BY_NUMBER[error.errno]
    if isinstance(error, MemoryError):
        return None if _is_larger_than_memory(error) else _MEMORY
    if isinstance(error, RuntimeError) and str(error) == NO_THREAD:
        return _PROCESSES
    if isinstance(error, ImportError) or (
        isinstance(error, OSError) and "shared object" in str(error)
    ):  # raised by llvmlite
        return _LIBRARY
    return None


def _is_larger_than_memory(error: MemoryError) -> bool:
    """Whether a single array exceeds this machine's memory, according to NumPy's message."""
    try:
        asked = error.dtype.itemsize * math.prod(error.shape)  # type: ignore[attr-defined]
        return bool(asked > os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"))
    except (AttributeError, ValueError, OSError):
        return False


def resource_error(error: BaseException, where: str = "") -> ResourceError:
    """Return the error for a missing resource, with advice.

    >>> str(resource_error(OSError(errno.EMFILE, "Too many open files")))
    'too many open files. End other programs, or raise the limit of open files (ulimit -n).'
    """
    if isinstance(error, ResourceError):
        return error
    what, hint = _lacking(error) or _MEMORY
    if what == _DISK[0]:
        return DiskError(getattr(error, "strerror", None) or what, where=where, hint=hint)
    return ResourceError(
        what, where=where, found=str(error) if what == _LIBRARY[0] else None, hint=hint
    )


def reason(error: Exception, within: str = "") -> str:
    """Return the reason why a file, trial or variant is skipped; the prefix ``within`` is omitted from its location.

    Raises
    ------
    ResourceError
        If a resource is missing: this affects all other items as well, and does not justify skipping one of them.
    """
    if is_of_system(error):
        raise resource_error(error) from error
    return unforeseen(error).message(within=within)


def unforeseen(
    error: Exception, where: str = "", kind: type[JounceError] = JounceError
) -> JounceError:
    """Return an error of jounce unchanged; otherwise wrap it to report an unexpected error of a skipped file.

    >>> str(unforeseen(KeyError("x"), "a.mat"))
    "a.mat: this cannot be used, for an unexpected reason (KeyError: 'x'). Please report it with the file."
    """
    if isinstance(error, JounceError):
        return error
    if is_of_system(error):
        return resource_error(error, where)
    if isinstance(error, MemoryError):
        message = " ".join(str(error).split())
        return kind("not enough memory for this", where=where, found=message or None)
    text = shorten(
        f"{type(error).__name__}: {' '.join(str(error).split())}".removesuffix(": "), _LONGEST_VALUE
    )
    hint = "Please report it with the file."
    return kind(f"this cannot be used, for an unexpected reason ({text})", where=where, hint=hint)


def show_value(value: object) -> str:
    """Write a value for messages: text in quotes, and all values shortened to a readable length.

    >>> show_value("5 mm"), show_value([0.1, 0.2])
    ("'5 mm'", '[0.1, 0.2]')
    """
    if isinstance(value, Phrase):  # text of jounce, not of the user
        return value
    try:
        text = repr(value) if isinstance(value, str) else str(value)
    except ValueError:  # Python does not convert integers of more than a few thousand digits
        text = "an integer of thousands of digits"
    return shorten(text, _LONGEST_VALUE)


def as_found(value: object) -> str:
    """Convert a value of a file for storage in errors: its text, quoted in messages if the value was text.

    >>> as_found("5 mm"), show_value(as_found("5 mm")), show_value(as_found(5))
    ('5 mm', "'5 mm'", '5')
    """
    return (
        shorten(value, _LONGEST_VALUE)
        if isinstance(value, str)
        else Phrase("{value}", value=show_value(value))
    )


def value_or_kind(value: object) -> str:
    """Describe a value in messages: plain values as they are, others by their type.

    >>> value_or_kind("5 mm"), value_or_kind(3), value_or_kind([1, 2]), value_or_kind(KeyError())
    ("'5 mm'", '3', 'a list', 'a KeyError')
    """
    if value is None or isinstance(value, (str, bool, int, float)):
        return show_value(value)
    name = type(value).__name__
    return f"{'an' if name[0] in 'AEIOUaeiou' else 'a'} {name}"


def nearest(name: str, options: Iterable[str]) -> str:
    """Return the sentence ``did you mean 'x'?``, or an empty text without a similar option."""
    match = nearest_name(name, options)
    return Phrase("Did you mean {name}?", name=show_value(match)) if match else ""


def nearest_name(name: str, options: Iterable[str]) -> str:
    """Return the option most similar to a name, or an empty text without a similar option."""
    match = difflib.get_close_matches(name[:_LONGEST_VALUE], list(options), n=1, cutoff=0.6)
    return match[0] if match else ""


def unknown(name: str, options: Iterable[str], *, what: str, where: str = "") -> DescriptionError:
    """Build the error for a name that is not among ``options``."""
    choices = sorted(options)
    phrase = Phrase("unknown {kind} {name}", kind=Phrase(what), name=show_value(name))
    return DescriptionError(
        phrase, where=where, allowed=", ".join(choices), hint=nearest(name, choices)
    )


def at_line(file: object, line: int | None) -> str:
    """Write a location in a file: the file, and the line if it is known.

    >>> at_line("rig.toml", 3), at_line("rig.toml", None)
    ('rig.toml, line 3', 'rig.toml')
    """
    return Phrase("{file}, line {line}", file=str(file), line=line) if line else str(file)


def below(where: str, place: str) -> str:
    """Join a location and a location within it; either may be empty.

    >>> below("rig.toml", "tyre.rate")
    'rig.toml: tyre.rate'
    """
    return Phrases(": ", [where, place]) if where and place else where or place
