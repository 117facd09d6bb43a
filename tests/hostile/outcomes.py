"""How calls end, to be compared with each other."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import xarray as xr

import jounce as jn


def _shown(result: Any) -> Any:
    """A result to the last bit."""
    if isinstance(result, xr.Dataset):
        result = {str(name): one.values for name, one in result.variables.items()}
    if isinstance(result, np.ndarray):
        return result.shape, result.dtype.str, result.tobytes()
    if dataclasses.is_dataclass(result):
        result = {field.name: getattr(result, field.name) for field in dataclasses.fields(result)}
    if isinstance(result, Mapping):
        return [(key, _shown(value)) for key, value in result.items()]
    return (
        [_shown(value) for value in result] if isinstance(result, (list, tuple)) else repr(result)
    )


def outcome(call: Callable[..., Any], arguments: Mapping[str, Any]) -> Any:
    """What a call gives; "refused" for an error of ours."""
    try:
        return _shown(call(**arguments))
    except jn.JounceError:
        return "refused"
