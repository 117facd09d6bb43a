"""Rigs as command options: a file or the name of a shipped rig, and parameter changes."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, TypeAlias

from jounce.core.operation import File, MadeBy, Settings
from jounce.core.typed import LONGEST
from jounce.parts.files import load
from jounce.parts.rig import Rig, unit_of

AnyRig: TypeAlias = Annotated[
    Rig | str | Path,
    MadeBy("jounce.parts.options:rig_of_options", "jounce.parts.options:rig_in_python"),
]
"""A rig, its file or its name in the library; interfaces offer file or name, and changes."""
RigAlone: TypeAlias = Annotated[
    Rig | str | Path, MadeBy("jounce.parts.options:rig_alone", "jounce.parts.options:rig_in_python")
]
"""A rig, its file or its name in the library, without changes."""
MaybeRig: TypeAlias = Annotated[
    Rig | str | Path | None,
    MadeBy("jounce.parts.options:vehicle_of_options", "jounce.parts.options:vehicle_in_python"),
]
"""An optional rig of a command, given by an option."""

CHANGES = Settings(
    'Change a parameter of the rig: strut.spring.rate="25 N/mm".',
    "PATH=VALUE",
    'strut.spring.rate="25 N/mm"',
)


def rig_of_options(
    rig: Annotated[
        str, File("A vehicle or rig file, or a name of `jounce library`.", shipped=("parts",))
    ],
    changes: Annotated[Mapping[str, Any] | None, CHANGES] = None,
) -> Rig:
    """Load a rig and change its values.

    Raises
    ------
    DescriptionError
        For unknown names, unknown parameters, and bare numbers that are implausible in SI.
    """
    loaded, wanted = load(rig), dict(changes or {})
    refuse_implausible(loaded, wanted)
    return loaded.with_changes(wanted) if wanted else loaded


def rig_alone(
    rig: Annotated[str, File("A rig file, or a name of `jounce library`.", shipped=("parts",))],
) -> Rig:
    """Load a rig."""
    return load(rig)


def vehicle_of_options(
    vehicle: Annotated[
        str | None,
        File(
            "Rig or vehicle, for the gaps of its bump and rebound stops.",
            "VEHICLE",
            shipped=("parts",),
        ),
    ] = None,
) -> Rig | None:
    """Load a rig, if one is given."""
    return None if vehicle is None else load(vehicle)


def vehicle_in_python(vehicle: str | None = None) -> str:
    """Format the option as Python code."""
    return "None" if vehicle is None else rig_in_python(vehicle)


def rig_in_python(rig: str, changes: Mapping[str, Any] | None = None) -> str:
    """Format the rig as Python code.

    >>> rig_in_python("kart-quarter-car", {"sprung.mass": "17 kg"})
    "jn.load('kart-quarter-car').with_changes({'sprung.mass': '17 kg'})"
    """
    return f"jn.load({rig!r})" + (f".with_changes({dict(changes)!r})" if changes else "")


def refuse_implausible(rig: Rig, changes: Mapping[str, Any]) -> None:
    """Refuse bare numbers that are implausible in SI."""
    from jounce.core.units import bare_si

    known = rig.parameters()
    for path, value in changes.items():
        if path in known and isinstance(value, float):
            unit = unit_of(rig, path)
            bare_si(value, unit, where=f"--set {path}", most=LONGEST if unit == "m" else None)
