"""Base class of all rigs: sources of values, parameters by path, and modified copies."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping
from copy import deepcopy
from pathlib import Path
from typing import Any, ClassVar, Self

from pydantic import BaseModel, model_validator
from pydantic.fields import FieldInfo

from jounce.core.description import Description
from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.remembered import once_per_object
from jounce.core.units import Unit

_FEW = 10
"""Maximum number of paths listed in a message."""


def parameters_of(description: BaseModel, prefix: str = "") -> dict[str, float]:
    """Return all floats of a description by path, e.g. ``{"tyre.curve.coefficients[1]": 3.0e6}``, SI."""
    numbers: dict[str, float] = {}
    for name in type(description).model_fields:
        _collect(getattr(description, name), f"{prefix}{name}", numbers)
    return numbers


def _collect(value: Any, path: str, numbers: dict[str, float]) -> None:
    if isinstance(value, BaseModel):
        numbers.update(parameters_of(value, f"{path}."))
    elif isinstance(value, tuple):
        for i, item in enumerate(value):
            _collect(item, f"{path}[{i}]", numbers)
    elif isinstance(value, float):
        numbers[path] = value


@once_per_object
def structure_of(description: BaseModel) -> str:
    """Return a text that is equal for descriptions that differ only in numbers: they share one compiled model."""
    return re.sub(
        r"-?\d+(\.\d+)?([eE][+-]?\d+)?(?=[,\]}])",
        "#",
        description.model_dump_json(exclude={"source", "estimated"}),
    )


def split_path(path: str) -> list[str | int]:
    """Split ``tyre.curve.coefficients[1]`` into its keys and indices."""
    parts: list[str | int] = []
    for piece in path.split("."):
        match = re.fullmatch(r"([\w-]+)((?:\[\d+\])*)", piece)
        if match is None:
            raise DescriptionError(
                "invalid path", where=path, allowed="names joined by dots, e.g. strut.spring.rate"
            )
        parts.append(match[1])
        parts.extend(int(index) for index in re.findall(r"\[(\d+)\]", match[2]))
    return parts


def change_table(description: BaseModel, changes: object) -> dict[str, Any]:
    """Return the description as a table in which the values at some paths are replaced."""
    if not isinstance(changes, Mapping) or not all(isinstance(path, str) for path in changes):
        allowed = 'values by path, e.g. {"strut.spring.rate": "25 N/mm"}'
        raise DescriptionError(
            "no changes are given", where="changes", found=changes, allowed=allowed
        )
    table: dict[str, Any] = description.model_dump(by_alias=True, exclude_none=True)
    for path, value in changes.items():
        parts, own = split_path(path), deepcopy(value)  # a later path may change it
        try:
            _set(table, parts, own)
        except (KeyError, IndexError, TypeError):
            raise unknown_path(path, parameters_of(description)) from None
    return table


def _set(table: Any, parts: list[str | int], value: Any) -> None:
    """Set a value by its path; raises KeyError, IndexError or TypeError for an invalid path."""
    *parents, last = parts
    here = table
    for i, part in enumerate(parents):
        if isinstance(here, dict) and part not in here and isinstance(parts[i + 1], str):
            here[part] = {}
        elif isinstance(here[part], tuple):
            here[part] = list(here[part])
        here = here[part]
    if isinstance(here, list) and not (isinstance(last, int) and last < len(here)):
        raise IndexError(last)
    if not isinstance(here, (dict, list)):
        raise TypeError(last)
    here[last] = value  # type: ignore[index]


_numbers = once_per_object(parameters_of)


def unknown_path(where: str, known: Iterable[str], *, name: str = "") -> DescriptionError:
    """Build the error for a path that the description lacks; ``name`` is the path if ``where`` contains more."""
    paths = sorted(known)
    near = nearest_paths(name or where, paths)
    every = f"All {len(paths)}: jounce check FILE --parameters." if len(paths) > _FEW else ""
    if near:
        names = " or ".join(filter(None, (", ".join(map(repr, near[:-1])), repr(near[-1]))))
        hint = f"Did you mean {names}? {every}".rstrip()
        return DescriptionError("unknown parameter", where=where, hint=hint)
    begins = dict.fromkeys(re.split(r"[.[]", path)[0] for path in paths)
    allowed = (
        Phrase("paths that begin with {begins}", begins=", ".join(begins))
        if every
        else ", ".join(paths)
    )
    return DescriptionError("unknown parameter", where=where, allowed=allowed, hint=every)


def nearest_paths(name: str, known: Iterable[str]) -> list[str]:
    """Return up to three similar paths, the most likely first.

    Examples
    --------
    >>> nearest_paths("spring.rate", ["strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness"])
    ['strut.spring.rate']
    >>> nearest_paths("upper_ball_joint", [f"hardpoints.upper_ball_joint[{i}]" for i in range(3)])
    ['hardpoints.upper_ball_joint[0]', 'hardpoints.upper_ball_joint[1]', 'hardpoints.upper_ball_joint[2]']
    """
    paths = sorted(known)
    inside = re.compile(rf"(?:^|\.){re.escape(name)}(?:$|[.[])")
    return [path for path in paths if inside.search(path)][:3] or difflib.get_close_matches(
        name, paths, n=3, cutoff=0.7
    )


def quantity_at(kind: BaseModel, path: str) -> Unit:
    """Unit and range of the number at ``path``; dimensionless if it has none, as coefficients of curves."""
    here: Any = kind
    quantity = Unit("1")
    for part in split_path(path):
        if isinstance(part, int):
            here = here[part]
            continue
        quantity = unit_of_field(type(here).model_fields[part])
        here = getattr(here, part)
    return quantity


def unit_of_field(field: FieldInfo) -> Unit:
    """Unit and range of a field of a description; dimensionless if it has none."""
    units = [item for item in field.metadata if isinstance(item, Unit)] or _units_in(
        field.annotation
    )
    return units[0] if units else Unit("1")


def unit_of(kind: BaseModel, path: str) -> str:
    """SI unit of the number at ``path``, e.g. ``N/m``; ``1`` if it has none, as coefficients of curves."""
    return quantity_at(kind, path).si


def result_unit_of(kind: BaseModel, path: str) -> str:
    """SI unit of the number at ``path`` in results; unlike files, they show units of curve coefficients.

    The i-th coefficient multiplies the power i + 1 of the deflection, so its unit depends on its index.

    Examples
    --------
    >>> import jounce as jn
    >>> cubic = {"kind": "polynomial", "coefficients": [1.4e5, 0.0, 3.0e6]}
    >>> rig = jn.load("kart-quarter-car").with_changes({"tyre": {"curve": cubic}})
    >>> [result_unit_of(rig, f"tyre.curve.coefficients[{i}]") for i in (0, 2)]
    ['N/m', 'N/m^3']
    """
    order = re.search(r"curve(?:s\.(r?)[xyz])?\.coefficients\[(\d+)\]$", path)
    if order is None:
        return unit_of(kind, path)
    unit = "N*m/rad" if order[1] else "N/m"
    return unit if order[2] == "0" else f"{unit}^{int(order[2]) + 1}"


def unit_question(place: str, unit: Unit, value: float) -> list[Finding]:
    """Return a finding if a value (SI) was probably meant in a different unit, else an empty list."""
    meant = unit.mistaken_for(value)
    return (
        [finding("parts.unit_meant", place, value, value=value, unit=unit.si, meant=meant)]
        if meant
        else []
    )


def questions(description: BaseModel) -> list[Finding]:
    """Report implausible values, each at its path."""
    return [
        question
        for path, value in parameters_of(description).items()
        for question in unit_question(path, quantity_at(description, path), value)
    ]


def _units_in(annotation: Any) -> list[Unit]:
    own = [item for item in getattr(annotation, "__metadata__", ()) if isinstance(item, Unit)]
    return own or [unit for part in getattr(annotation, "__args__", ()) for unit in _units_in(part)]


def check_rig(given: object) -> Rig:
    """Refuse anything but a rig or a vehicle."""
    if isinstance(given, Rig):
        return given
    hint = f"Load it: jn.load({str(given)!r})." if isinstance(given, str | Path) else ""
    raise DescriptionError(
        "not a rig", where="rig", found=given, allowed="a rig or a vehicle", hint=hint
    )


MODELS: dict[str, dict[str, type[Rig]]] = {"jounce.rig/1": {}, "jounce.vehicle/1": {}}
"""Models by schema and by their name in a file."""


class Rig(Description):
    """Description of a rig or a whole vehicle; its subclasses are the models.

    A subclass with fields ``schema_`` and ``model`` can be read from files as soon as it is defined.
    """

    source: str = ""
    estimated: tuple[str, ...] = ()

    has_file: ClassVar[bool] = True
    """Whether it can be read from a file."""

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        if cls.has_file and {"schema_", "model"} <= cls.model_fields.keys():
            schema, model = (cls.model_fields[name].default for name in ("schema_", "model"))
            MODELS.setdefault(schema, {})[model] = cls

    @model_validator(mode="before")
    @classmethod
    def _stop_belongs_to_the_strut(cls, table: Any) -> Any:
        """Move a ``bump_stop`` from the top level of a file to the strut."""
        if (
            isinstance(table, dict)
            and "bump_stop" in table
            and isinstance(table.get("strut"), dict)
        ):
            table = dict(table)
            table["strut"] = {"bump_stop": table.pop("bump_stop"), **table["strut"]}
        return table

    def parameters(self) -> dict[str, float]:
        """Return all numbers of the rig by path, SI: ``{"strut.spring.rate": 22730.0, ...}``."""
        return _numbers(self).copy()

    def is_estimated(self, path: str) -> bool:
        """Whether the rig's ``estimated`` list contains the path or a part that includes it."""
        return any(path == name or path.startswith(f"{name}.") for name in self.estimated)

    def with_changes(self, changes: dict[str, Any]) -> Self:
        """Return a copy with changed values; the original is never modified.

        Parameters
        ----------
        changes : dict
            Values by path, text with unit or SI number: ``{"strut.spring.rate": "25 N/mm"}``.

        Raises
        ------
        DescriptionError
            For an unknown path (with the nearest one) or a value out of range.
        """
        return type(self).from_table(change_table(self, changes))
