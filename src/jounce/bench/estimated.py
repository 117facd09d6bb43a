"""Estimated values without a source: marked in the description and reported wherever they are used."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from jounce.core.description import Description
from jounce.core.findings import Finding, finding


def estimated_default(default: Any, why: str) -> Any:
    """Make a field default that is an estimate; ``why`` is its basis."""
    return Field(
        default=default, description=f"estimated: {why}", json_schema_extra={"estimated": True}
    )


def estimates_used(
    description: Description, place: str, names: tuple[str, ...] | None = None
) -> list[Finding]:
    """Report the estimated defaults that a result depends on, among the fields in ``names`` or all."""
    fields = type(description).model_fields
    left = [
        f"{name} = {getattr(description, name):g}"
        for name, field in fields.items()
        if isinstance(field.json_schema_extra, dict)
        and field.json_schema_extra.get("estimated")
        and name not in description.model_fields_set
        and getattr(description, name) is not None
        and (names is None or name in names)
    ]
    if not left:
        return []
    return [finding("bench.estimates_used", place, names=", ".join(left))]
