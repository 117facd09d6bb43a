"""Free variables of a hardpoint search: for one or several rigs, tied, on lines, within boxes."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from jounce.core.errors import DescriptionError, unknown
from jounce.core.phrases import Phrase
from jounce.core.text import qualify
from jounce.core.types import Array
from jounce.core.units import positive_si, to_si
from jounce.design.kinematic_study import FreePoint, coordinate
from jounce.kc.sensitivities import kc_parameters
from jounce.kinematics.model import kinematic_model
from jounce.parts import Corner, DependentAxle
from jounce.parts.advice import LONGEST
from jounce.parts.rig import unit_of, unknown_path

Rigs = Mapping[str, Corner | DependentAxle]
"""Rigs of a study by name; a single rig has the name ''."""
_FAR = 1.0  # m: largest movement of a hardpoint
_AXES = "xyz"
_LATERAL = 1  # of x, y, z


def full_path(name: str, path: str) -> str:
    """Return the path of a parameter of a named rig in a study of several."""
    return qualify(name, path)


@dataclass(frozen=True)
class Numbering:
    """Parameters that affect the targets of the rigs of a study, concatenated: ``paths`` in this order.

    ``parts`` has those of each rig, ``kinematic`` the first of them, which enter its kinematics; the others enter only
    its K&C tests.
    """

    rigs: Rigs
    kinematic: Mapping[str, slice]
    parts: Mapping[str, slice]
    paths: tuple[str, ...]

    @staticmethod
    def of(rigs: Rigs, tested: Collection[str] = ()) -> Numbering:
        """Index the parameters of the rigs of a study; those in ``tested`` have targets of K&C tests."""
        kinematic, parts, paths = dict[str, slice](), dict[str, slice](), list[str]()
        for name, rig in rigs.items():
            own = [] if isinstance(rig, DependentAxle) else [*kinematic_model(rig).parameters]
            further = (
                [path for path in kc_parameters(rig) if path not in own] if name in tested else []
            )
            start = len(paths)
            kinematic[name] = slice(start, start + len(own))
            parts[name] = slice(start, start + len(own) + len(further))
            paths += [full_path(name, path) for path in (*own, *further)]
        return Numbering(rigs, kinematic, parts, tuple(paths))

    def values(self, rigs: Rigs | None = None) -> Array:
        """Return the parameters of rigs of the same structure, by default of the study's own rigs."""
        chosen = self.rigs if rigs is None else rigs
        values = []
        for name, rig in chosen.items():
            known = rig.parameters()
            values += [known[self.owner(path, path)[1]] for path in self.paths[self.parts[name]]]
        return np.array(values, dtype=float)

    def owner(self, path: str, where: str) -> tuple[str, str]:
        """Return the name of the rig that a path of the study belongs to, and the path within that rig."""
        if "" in self.rigs:
            return "", path
        name, _, rest = path.partition(".")
        if name not in self.rigs:
            raise unknown(name, self.rigs, what="rig", where=where)
        return name, rest

    def unit(self, path: str) -> str:
        """Return the SI unit of a parameter of the study."""
        name, own = self.owner(path, path)
        return unit_of(self.rigs[name], own)


@dataclass(frozen=True)
class FreeNumbers:
    """Variables x (n,) of the search, SI: the parameters of the models are ``origin + directions @ x``.

    ``owners`` has the index of the study entry of each variable; ``paths`` are the parameters that move. ``firsts`` has
    the path of each variable (the first one of tied parameters), ``labels`` its name, and ``values`` its parameter
    value at x = 0 (0 along a line).
    """

    origin: Array
    directions: Array
    lower: Array
    upper: Array
    owners: tuple[int, ...]
    paths: tuple[str, ...]
    firsts: tuple[str, ...]
    labels: tuple[str, ...]
    values: Array

    @property
    def lengths(self) -> Array:
        """Half the range of each variable."""
        return 0.5 * (self.upper - self.lower)


def free_numbers(numbering: Numbering, free: Sequence[FreePoint], key: str = "free") -> FreeNumbers:
    """Read the free points; reject paths that do not exist, have no effect, or are given twice."""
    origin, index = numbering.values(), {path: i for i, path in enumerate(numbering.paths)}
    columns, lower, upper, values, owners, taken = [], [], [], [], [], dict[str, str]()
    firsts, labels = list[str](), list[str]()
    for k, entry in enumerate(free):
        where = f"{key}[{k}]"
        groups = [
            (_paths(numbering, index, name, f"{where}.{part}"), name, sign)
            for part, name, sign in _list_tied(entry)
        ]
        first = groups[0][0]
        size = len(first)
        matrix = np.zeros((len(origin), size))
        for paths, name, sign in groups:
            if len(paths) != size:
                raise DescriptionError(
                    "is coupled to an entry of a different dimension",
                    where=f"{where}.tied",
                    found=name,
                )
            for j, path in enumerate(paths):
                if path in taken:
                    raise DescriptionError(
                        "is listed twice", where=where, found=path, allowed="each parameter once"
                    )
                taken[path] = where
                matrix[index[path], j] = sign * _mirror_sign(numbering, first[j], path)
        at = np.array([origin[index[path]] for path in first])
        if entry.along is not None:
            if size != 3:
                raise DescriptionError(
                    "only a point moves along a line", where=f"{where}.along", found=entry.point
                )
            direction = _direction(numbering, entry, at, f"{where}.along")
            matrix, at, size = matrix @ direction[:, None], np.zeros(1), 1
        bounds = _bounds(numbering, entry, first, at, size, where)
        columns.append(matrix)
        values.append(at)
        lower.append(bounds[0] - at)
        upper.append(bounds[1] - at)
        owners += [k] * size
        firsts += first[:size]
        labels += first if entry.along is None else [f"{entry.point} along {_line(entry.along)}"]
    if not columns:
        raise DescriptionError(
            "there are no free points",
            where="free",
            allowed='e.g. {"hardpoints.tie_rod_inner[2]": "10 mm"}',
        )
    return FreeNumbers(
        origin,
        np.hstack(columns),
        np.concatenate(lower),
        np.concatenate(upper),
        tuple(owners),
        tuple(taken),
        tuple(firsts),
        tuple(labels),
        np.concatenate(values),
    )


def _line(along: str | tuple[float, ...]) -> str:
    return along if isinstance(along, str) else " ".join(f"{component:g}" for component in along)


def _list_tied(entry: FreePoint) -> list[tuple[str, str, float]]:
    """List keys and paths of an entry, with sign 1 if it moves with the first point, -1 if against it."""
    tied = [
        (f"tied[{i}]", name.removeprefix("-"), -1.0 if name[:1] == "-" else 1.0)
        for i, name in enumerate(entry.tied)
    ]
    return [("point", entry.point, 1.0), *tied]


def _paths(numbering: Numbering, index: Mapping[str, int], name: str, where: str) -> list[str]:
    """Return the paths of a point's coordinates, or of a single parameter."""
    owner, own = numbering.owner(name, where)
    known = numbering.rigs[owner].parameters()
    paths = [own] if own in known else [f"{own}[{i}]" for i in range(3)]
    if any(path not in known for path in paths):
        raise unknown_path(
            where,
            [*known, *{path[:-3] for path in known if coordinate(path) is not None}],
            name=own,
        )
    paths = [full_path(owner, path) for path in paths]
    if any(path not in index for path in paths):
        raise DescriptionError(
            "has no effect: it does not enter the targets",
            where=where,
            found=name,
            hint="Leave it out.",
        )
    return paths


def _mirror_sign(numbering: Numbering, first: str, second: str) -> float:
    """Return -1 for a lateral coordinate on the opposite side of the car, otherwise 1."""
    rigs = [numbering.rigs[numbering.owner(path, path)[0]] for path in (first, second)]
    sides = [
        getattr(rig, "sign", 1.0) for rig in rigs
    ]  # a dependent axle is described by its left half
    return sides[0] * sides[1] if coordinate(second) == _LATERAL else 1.0


def _direction(numbering: Numbering, entry: FreePoint, at: Array, where: str) -> Array:
    """Return the unit vector of the line on which a point moves."""
    along = entry.along
    if isinstance(along, str):
        rig = numbering.rigs[numbering.owner(entry.point, where)[0]]
        points = rig.hardpoints.given()
        name = along.removeprefix("hardpoints.")
        if name not in points:
            raise unknown(name, points, what="hardpoint", where=where)
        towards = np.array(points[name]) - at
    else:
        towards = np.array(along, dtype=float)
    length = float(np.linalg.norm(towards))
    if length == 0.0:
        raise DescriptionError(
            "invalid direction", where=where, found=str(along), allowed="another point"
        )
    return np.asarray(towards / length)


def _bounds(
    numbering: Numbering, entry: FreePoint, paths: list[str], at: Array, size: int, where: str
) -> tuple[Array, Array]:
    unit = numbering.unit(paths[0])
    if entry.box is None:
        given = entry.within if isinstance(entry.within, (list, tuple)) else [entry.within] * size
        if len(given) != size:
            raise DescriptionError(
                "there must be one width per coordinate", where=f"{where}.within", found=len(given)
            )
        width = np.array(
            [positive_si(width_text, unit, where=f"{where}.within") for width_text in given]
        )
        if unit == "m" and np.max(width) > _FAR:
            raise DescriptionError(
                "too wide a range for a hardpoint",
                where=f"{where}.within",
                found=f"{np.max(width):g} m",
                allowed=Phrase("up to {far:g} m", far=_FAR),
                hint='A bare number is in metres; write "15 mm".',
            )
        return at - width, at + width
    corners = [
        list(corner) if isinstance(corner, (list, tuple)) else [corner] for corner in entry.box
    ]
    if any(len(corner) != size for corner in corners):
        raise DescriptionError(
            "invalid box for this point",
            where=f"{where}.box",
            found=f"{[len(corner) for corner in corners]} numbers",
            allowed=Phrase("lower and upper corner with {size} coordinates each", size=size),
        )
    low, high = (
        np.array([to_si(bound, unit, where=f"{where}.box") for bound in corner])
        for corner in corners
    )
    farthest = float(max(np.max(np.abs(low)), np.max(np.abs(high))))
    if unit == "m" and farthest > LONGEST:
        raise DescriptionError(
            "too far away for a hardpoint",
            where=f"{where}.box",
            found=f"{farthest:g} m",
            allowed=Phrase("up to {longest:g} m", longest=LONGEST),
            hint='A bare number is in metres; write "40 mm".',
        )
    if np.any(low >= high):
        j = int(np.argmax(low >= high))
        raise DescriptionError(
            "the box is empty",
            where=f"{where}.box",
            found=f"{low[j]:g} to {high[j]:g} {unit}" + (f" in {_AXES[j]}" if size == 3 else ""),
            allowed="a lower corner below the upper one in every coordinate",
        )
    return low, high
