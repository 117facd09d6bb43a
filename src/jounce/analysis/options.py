"""Options that name a rig to compare measurements with: a file or a shipped name, and changes."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, TypeAlias

from jounce.core.errors import DescriptionError
from jounce.core.operation import File, MadeBy, Settings
from jounce.parts.options import rig_in_python, rig_of_options
from jounce.parts.rig import Rig

ComparedRig: TypeAlias = Annotated[
    Rig | Path | str | None,
    MadeBy(
        "jounce.analysis.options:compared_rig", "jounce.analysis.options:compared_rig_in_python"
    ),
]
"""A rig whose linear model is compared with the measurement, if one is named."""


def compared_rig(
    rig: Annotated[
        str | None,
        File(
            "Rig whose linear model is compared, without dry friction.", "RIG", shipped=("parts",)
        ),
    ] = None,
    changes: Annotated[
        Mapping[str, Any] | None,
        Settings("Change a parameter of that rig.", "PATH=VALUE", 'strut.spring.rate="25 N/mm"'),
    ] = None,
) -> Rig | None:
    """Load a rig and change its values, if one is named; refuse changes without a rig."""
    if rig is None and changes:
        raise DescriptionError(
            "there is no rig to change", where="changes", hint="Name the rig with --rig."
        )
    return None if rig is None else rig_of_options(rig, changes)


def compared_rig_in_python(rig: str | None = None, changes: Mapping[str, Any] | None = None) -> str:
    """Write the compared rig as Python code."""
    return "None" if rig is None else rig_in_python(rig, changes)
