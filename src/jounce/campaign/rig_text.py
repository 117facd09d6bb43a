"""A rig file with the values that a campaign found, its comments kept."""

from __future__ import annotations

import tomllib
from typing import Any

from jounce.parts import Rig, changed_text, rig_from_table
from jounce.parts.rig import parameters_of


def updated_text(text: str, rig: Rig) -> str:
    """Write the values of ``rig`` into the text of the rig file it came from.

    Numbers that changed are replaced in place. Where a law changed its kind (a tyre stiffness became a curve), its
    table is replaced; everything else stays as it was, comments included.

    Parameters
    ----------
    text : str
        Rig file as described.
    rig : Rig
        The rig it is to give when read again.

    Returns
    -------
    str
        Text of the new rig file.
    """
    import tomlkit

    document = tomlkit.parse(text)
    described = rig_from_table(tomllib.loads(text))
    _reshape(document, _table(rig), _table(described))
    reshaped = tomlkit.dumps(document)
    before, after = parameters_of(rig_from_table(tomllib.loads(reshaped))), parameters_of(rig)
    return changed_text(reshaped, rig, {path: value for path, value in after.items() if before.get(path) != value})


def _table(rig: Rig) -> dict[str, Any]:
    return rig.model_dump(by_alias=True, exclude_none=True)


def _reshape(here: Any, wanted: dict[str, Any], described: dict[str, Any]) -> None:
    """Give a table the keys of ``wanted``; numbers that both have are left to be replaced in place."""
    for key in [key for key in here if key not in wanted]:
        del here[key]
    for key, value in wanted.items():
        old = described.get(key)
        if isinstance(value, dict) and isinstance(old, dict):
            if key in here:
                _reshape(here[key], value, old)
            elif value:
                here[key] = _plain(value)
        elif old is None or _is_another_law(value, old):
            here[key] = _plain(value)


def _is_another_law(value: Any, old: Any) -> bool:
    """Whether a text (the kind of a law) or the number of points differs."""
    return (isinstance(value, str) and value != old) or (isinstance(value, tuple) and len(value) != len(old))


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return [_plain(item) for item in value] if isinstance(value, tuple) else value
