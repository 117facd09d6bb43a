"""Columns of a file that are channels known to jounce, so that they are read without being mapped."""

from __future__ import annotations

from jounce.core.errors import JounceError


def is_known_channel(name: str, unit: str) -> bool:
    """Whether a column is read under its name: a known channel, in a unit of its quantity."""
    return is_known(name) and is_of_its_unit(name, unit) and " #" not in name


def is_known(name: str) -> bool:
    """Whether a column has the name of a known channel."""
    from jounce.recordings.schema import quantity_of

    return bool(quantity_of(name))


def is_of_its_unit(name: str, unit: str) -> bool:
    """Whether a unit is compatible with the known channel of that name."""
    from jounce.core.units import conversion_factor
    from jounce.recordings.schema import channel_unit

    try:
        return conversion_factor(unit or "1", channel_unit(name)) != 0.0
    except JounceError:
        return False
