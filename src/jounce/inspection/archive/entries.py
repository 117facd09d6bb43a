"""Entries of the record store, with losslessly packed signals."""

from __future__ import annotations

import hashlib
import json
import re
import struct
import zlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.serialise import to_json
from jounce.core.types import Array
from jounce.inspection.findings import of_plain

if TYPE_CHECKING:
    import xarray as xr

_NO_TEXT = re.compile("[\0\ud800-\udfff]")


@dataclass(frozen=True)
class RecordEntry:
    """A record to store: original file and known metadata."""

    name: str
    content: bytes = field(repr=False)
    sidecar: bytes | None = field(default=None, repr=False)  # accompanying TOML file, if any
    plate: str = ""  # number plate of the vehicle; empty if unknown
    vehicle: str = ""
    date: str = ""  # day of the inspection, ISO 8601
    axle: str = ""  # ``"front"``, ``"rear"`` or empty
    tester: str = ""
    # descriptions of tester and vehicle as tables, for re-evaluation
    tester_table: Mapping[str, Any] | None = field(default=None, repr=False)
    vehicle_table: Mapping[str, Any] | None = field(default=None, repr=False)
    methods: tuple[str, ...] = ()  # methods to evaluate, which decide; empty for all
    signals: bytes | None = field(default=None, repr=False)  # signals as returned by ``pack``

    @property
    def digest(self) -> str:
        """SHA-256 digest of file and sidecar."""
        return digest_of(self.content, self.sidecar)


def digest_of(content: bytes, sidecar: bytes | None) -> str:
    """Return the SHA-256 digest of the bytes of a file and its sidecar, independent of their names."""
    parts = [hashlib.sha256(part).digest() for part in (content, sidecar) if part is not None]
    return hashlib.sha256(b"".join(parts)).hexdigest()


def storable(text: str) -> str:
    r"""Make a text acceptable to every database: NUL and undecodable bytes become replacement characters.

    Examples
    --------
    >>> storable("a\udcffb\0.csv") == "a\ufffdb\ufffd.csv"
    True
    """
    return _NO_TEXT.sub("\ufffd", text)


def plate_key(plate: str) -> str:
    """Normalise a number plate for comparison: capital letters and digits.

    Examples
    --------
    >>> plate_key("b-AB 123")
    'BAB123'
    """
    return "".join(sign for sign in plate.upper() if sign.isalnum())


@dataclass(frozen=True)
class Grading:
    """One grading of a record."""

    verdict: str
    limits: str  # version of the limits
    software: str  # version of the software that graded it
    result: Mapping[str, Any]  # plain values, SI


@dataclass(frozen=True)
class StoredRecord:
    """A stored record with its newest grading."""

    number: int
    name: str
    plate: str
    vehicle: str
    date: str
    axle: str
    tester: str
    accepted: str  # time of import, ISO 8601, UTC
    grading: Grading | None  # newest grading


_FORMAT = "signals/1"
_FACTORS = (1.0, 1e-3, 1e3)  # factors from the column's unit to SI: none, mm or ms, kN
_DECIMALS = range(7)
_LARGEST = 2**31 - 1  # largest 32-bit integer in which values are stored


def pack(record: xr.Dataset, findings: Iterable[Finding] = ()) -> bytes:
    """Pack a recording, in SI and with plain attributes, with the findings of its reader.

    ``unpack`` restores identical numbers: decimal columns are stored as integers, others unchanged.

    Examples
    --------
    >>> from jounce.recordings import recording
    >>> run = recording([0.0, 0.001], {"left.plate.z": ([0.0, 2.9991e-3], "m", "")})
    >>> again, findings = unpack(pack(run))
    >>> again.identical(run), findings
    (True, [])
    """
    channels, blocks = [], []
    for name in ("time", *map(str, record.data_vars)):
        variable = record[name]
        coding, block = _pack_values(np.asarray(variable.values, dtype=float))
        channels.append(
            {
                "name": name,
                "units": variable.attrs["units"],
                "long_name": variable.attrs["long_name"],
                **coding,
            }
        )
        blocks.append(block)
    head = {
        "format": _FORMAT, "attributes": dict(record.attrs), "findings": list(findings), "channels": channels,
        "samples": record.sizes["time"],
    }  # fmt: skip
    text = to_json(head, indent=None).encode()
    return zlib.compress(struct.pack("<I", len(text)) + text + b"".join(blocks), 4)


def unpack(packed: bytes) -> tuple[xr.Dataset, list[Finding]]:
    """Unpack a recording and its findings; raises RecordingError for damaged bytes or a different version."""
    from jounce.recordings.schema import recording_of

    try:
        content = zlib.decompress(packed)
        start = 4 + struct.unpack_from("<I", content)[0]
        head = json.loads(content[4:start])
    except (zlib.error, struct.error, ValueError) as error:
        raise RecordingError(
            Phrase("the packed signals are damaged: {error}", error=str(error))
        ) from None
    if head.get("format") != _FORMAT:
        raise RecordingError(
            "packed signals of a different version", found=str(head.get("format")), allowed=_FORMAT
        )
    arrays: dict[str, tuple[Array, str, str]] = {}
    for channel in head["channels"]:
        width = 8 if channel["decimals"] is None else 4
        kind = "<f8" if width == 8 else "<i4"
        values = _unpack_values(np.frombuffer(content, kind, head["samples"], start), channel)
        start += width * head["samples"]
        arrays[channel["name"]] = (values, channel["units"], channel["long_name"])
    time = arrays.pop("time")[0]
    return recording_of(time, arrays, attributes=head["attributes"]), [
        of_plain(item) for item in head["findings"]
    ]


def _pack_values(values: Array) -> tuple[dict[str, Any], bytes]:
    for factor in _FACTORS:
        for decimals in _DECIMALS:
            scaled = np.rint(values / factor * 10.0**decimals)
            if not np.all(np.abs(scaled) < _LARGEST):  # also true for NaN
                break
            if np.array_equal(scaled / 10.0**decimals * factor, values):
                steps = np.diff(scaled.astype(np.int64), prepend=0)
                if (
                    np.abs(steps).max(initial=0) < _LARGEST
                    and not np.signbit(values[values == 0.0]).any()
                ):
                    return {"factor": factor, "decimals": decimals}, steps.astype("<i4").tobytes()
    return {"factor": 1.0, "decimals": None}, values.astype("<f8").tobytes()


def _unpack_values(stored: NDArray[Any], channel: dict[str, Any]) -> Array:
    if channel["decimals"] is None:
        return stored.astype(np.float64)
    values: Array = (
        np.cumsum(stored, dtype=np.int64) / 10.0 ** channel["decimals"] * channel["factor"]
    )
    return values
