"""What all rigs share: where their values come from, and how to vary them."""

from __future__ import annotations

from typing import Any, Self

from jounce.core.description import Description
from jounce.parts.parameters import change_table, parameters_of


class Rig(Description):
    """Description of what is tested, a rig or a whole vehicle; its subclasses are the models."""

    source: str = ""
    estimated: tuple[str, ...] = ()

    def parameters(self) -> dict[str, float]:
        """Give every number of the rig by its path, SI: ``{"strut.spring.rate": 22730.0, ...}``."""
        return parameters_of(self)

    def with_changes(self, changes: dict[str, Any]) -> Self:
        """Give a copy with other values; nothing is ever mutated.

        Parameters
        ----------
        changes : dict
            Path to value, text with unit or SI number: ``{"strut.spring.rate": "25 N/mm"}``.

        Raises
        ------
        DescriptionError
            For an unknown path (with the nearest one) or a value out of range.
        """
        return type(self).from_table(change_table(self, changes))


def stop_to_strut(table: Any) -> Any:
    """Give a rig's table with a ``bump_stop`` of its top level moved into ``strut``, where it belongs."""
    if isinstance(table, dict) and "bump_stop" in table and isinstance(table.get("strut"), dict):
        table = dict(table)
        table["strut"] = {"bump_stop": table.pop("bump_stop"), **table["strut"]}
    return table
