"""What goes into the record store and what comes out of it."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

_NO_TEXT = re.compile("[\0\ud800-\udfff]")


@dataclass(frozen=True)
class RecordEntry:
    """What comes in: the file as it is, and what is known of it.

    Attributes
    ----------
    name : str
        Name of the file.
    content : bytes
        The file.
    sidecar : bytes or None
        The TOML file beside it, where there is one.
    plate : str
        Number plate of the vehicle; empty where nothing says it.
    vehicle : str
        What vehicle it is.
    date : str
        Day of the inspection, ISO 8601.
    axle : str
        ``"front"``, ``"rear"`` or empty.
    tester : str
        Name of the tester.
    tester_table, vehicle_table : mapping or None
        Description of tester and vehicle as tables, for evaluating the record again.
    methods : tuple of str
        What to evaluate and what decides; empty for all.
    signals : bytes or None
        Signals as ``stored_signals.pack`` gives them.
    """

    name: str
    content: bytes = field(repr=False)
    sidecar: bytes | None = field(default=None, repr=False)
    plate: str = ""
    vehicle: str = ""
    date: str = ""
    axle: str = ""
    tester: str = ""
    tester_table: Mapping[str, Any] | None = field(default=None, repr=False)
    vehicle_table: Mapping[str, Any] | None = field(default=None, repr=False)
    methods: tuple[str, ...] = ()
    signals: bytes | None = field(default=None, repr=False)

    @property
    def digest(self) -> str:
        """SHA-256 of file and sidecar."""
        return digest_of(self.content, self.sidecar)


def digest_of(content: bytes, sidecar: bytes | None) -> str:
    """SHA-256 of a file and the one beside it: the same for the same bytes, whatever their names."""
    parts = [hashlib.sha256(part).digest() for part in (content, sidecar) if part is not None]
    return hashlib.sha256(b"".join(parts)).hexdigest()


def storable(text: str) -> str:
    r"""Text that every database takes: replacement characters stand for NUL and for bytes of names that are no text.

    Examples
    --------
    >>> storable("a\udcffb\0.csv") == "a\ufffdb\ufffd.csv"
    True
    """
    return _NO_TEXT.sub("\ufffd", text)


def plate_key(plate: str) -> str:
    """Number plate as it is compared: letters and digits in capitals.

    Examples
    --------
    >>> plate_key("b-AB 123")
    'BAB123'
    """
    return "".join(sign for sign in plate.upper() if sign.isalnum())


@dataclass(frozen=True)
class Grading:
    """One grading of a record.

    Attributes
    ----------
    verdict : str
        One word.
    limits : str
        Version of the limits.
    software : str
        Version of what graded it.
    result : mapping
        Plain values, SI.
    """

    verdict: str
    limits: str
    software: str
    result: Mapping[str, Any]


@dataclass(frozen=True)
class StoredRecord:
    """A record as it lies in the store, with its newest grading.

    Attributes
    ----------
    number : int
        Its number.
    name, plate, vehicle, date, axle, tester : str
        As it came in.
    accepted : str
        When it came in, ISO 8601, UTC.
    grading : Grading or None
        The newest one.
    """

    number: int
    name: str
    plate: str
    vehicle: str
    date: str
    axle: str
    tester: str
    accepted: str
    grading: Grading | None
