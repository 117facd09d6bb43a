"""Signals of a record as the store keeps them beside the file: packed without losing a bit, read in milliseconds."""

from __future__ import annotations

import json
import struct
import zlib
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding
from jounce.core.serialise import to_json
from jounce.core.types import Array
from jounce.inspection.remarks import of_plain

if TYPE_CHECKING:
    import xarray as xr

_FORMAT = "signals/1"
_FACTORS = (1.0, 1e-3, 1e3)  # from the unit of the column to SI: none, mm or ms, kN
_DECIMALS = range(7)
_LARGEST = 2**31 - 1


def pack(record: xr.Dataset, findings: Iterable[Finding] = ()) -> bytes:
    """Pack a recording with what its reader found.

    Parameters
    ----------
    record : xarray.Dataset
        Channels on ``time``, in SI, with plain attributes.
    findings : iterable of Finding
        Of its reader.

    Returns
    -------
    bytes
        For ``unpack``, which gives the very same numbers: decimal columns as integers, others as they are.

    Examples
    --------
    >>> from jounce.recordings.schema import recording
    >>> run = recording([0.0, 0.001], {"left.plate.z": ([0.0, 2.9991e-3], "m", "")})
    >>> again, findings = unpack(pack(run))
    >>> again.identical(run), findings
    (True, [])
    """
    channels, blocks = [], []
    for name in ("time", *map(str, record.data_vars)):
        variable = record[name]
        coding, block = _packed(np.asarray(variable.values, dtype=float))
        channels.append(
            {"name": name, "units": variable.attrs["units"], "long_name": variable.attrs["long_name"], **coding}
        )
        blocks.append(block)
    head = {
        "format": _FORMAT, "attributes": dict(record.attrs), "findings": list(findings), "channels": channels,
        "samples": record.sizes["time"],
    }  # fmt: skip
    text = to_json(head, indent=None).encode()
    return zlib.compress(struct.pack("<I", len(text)) + text + b"".join(blocks), 4)


def unpack(packed: bytes) -> tuple[xr.Dataset, list[Finding]]:
    """Give back what was packed.

    Raises
    ------
    RecordingError
        For bytes that are damaged or of another version.
    """
    from jounce.recordings.schema import recording

    try:
        content = zlib.decompress(packed)
        start = 4 + struct.unpack_from("<I", content)[0]
        head = json.loads(content[4:start])
    except (zlib.error, struct.error, ValueError) as error:
        raise RecordingError(f"the packed signals are damaged: {error}") from None
    if head.get("format") != _FORMAT:
        raise RecordingError("packed signals of another version", found=str(head.get("format")), allowed=_FORMAT)
    arrays: dict[str, tuple[Array, str, str]] = {}
    for channel in head["channels"]:
        width = 8 if channel["decimals"] is None else 4
        kind = "<f8" if width == 8 else "<i4"
        values = _unpacked(np.frombuffer(content, kind, head["samples"], start), channel)
        start += width * head["samples"]
        arrays[channel["name"]] = (values, channel["units"], channel["long_name"])
    time = arrays.pop("time")[0]
    return recording(time, arrays, attributes=head["attributes"]), [of_plain(one) for one in head["findings"]]


def _packed(values: Array) -> tuple[dict[str, Any], bytes]:
    for factor in _FACTORS:
        for decimals in _DECIMALS:
            scaled = np.rint(values / factor * 10.0**decimals)
            if not np.all(np.abs(scaled) < _LARGEST):  # also for NaN
                break
            if np.array_equal(scaled / 10.0**decimals * factor, values):
                steps = np.diff(scaled.astype(np.int64), prepend=0)
                if np.abs(steps).max(initial=0) < _LARGEST and not np.signbit(values[values == 0.0]).any():
                    return {"factor": factor, "decimals": decimals}, steps.astype("<i4").tobytes()
    return {"factor": 1.0, "decimals": None}, values.astype("<f8").tobytes()


def _unpacked(stored: NDArray[Any], channel: dict[str, Any]) -> Array:
    if channel["decimals"] is None:
        return stored.astype(np.float64)
    found: Array = np.cumsum(stored, dtype=np.int64) / 10.0 ** channel["decimals"] * channel["factor"]
    return found
