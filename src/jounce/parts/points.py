"""Named hardpoints, and the rules that they keep: given together, different, beside their axes, in metres."""

from __future__ import annotations

from itertools import combinations
from typing import ClassVar, Self

from pydantic import model_validator

from jounce.core.description import Description
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.parts.bodies import Triple, distance, distance_to_line

LARGE = 10.0
"""Upper bound in m of the coordinates of a suspension's points."""
SAME_POINT = 1e-6
"""Distance in m below which two points coincide."""
ON_ONE_LINE = 1e-3
"""Minimum distance of a point from its axis of rotation, as a fraction of the size of their triangle."""
Groups = tuple[tuple[str, ...], ...]
Axes = tuple[tuple[str, str, str], ...]


class NamedPoints(Description):
    """Base of all sets of hardpoints, m. Each class states rules, which add to those of its bases."""

    different: ClassVar[Groups] = ()
    """Groups in which no two points may be the same."""
    turning: ClassVar[Axes] = ()
    """Triples: two points on an axis, and a point that rotates about it."""
    together: ClassVar[Groups] = ()
    """Groups whose points must be given all together or not at all."""

    @model_validator(mode="after")
    def _can_move(self) -> Self:
        self._refuse_lost_points()
        kinds = [kind for kind in reversed(type(self).__mro__) if issubclass(kind, NamedPoints)]
        for kind in kinds:  # each class adds rules to those of its bases
            for group in vars(kind).get("together", ()):
                self._refuse_half(group)
        for kind in kinds:
            for group in vars(kind).get("different", ()):
                for first, second in combinations(group, 2):
                    self._refuse_equal(first, second)
        for kind in kinds:
            for first, second, turned in vars(kind).get("turning", ()):
                self._refuse_one_line(first, second, turned)
        return self

    def at(self, name: str) -> Triple | None:
        """Position of a point in m, shape (3,); spring and damper ends default to those of the strut."""
        value: Triple | None = getattr(self, name)
        element, _, end = name.partition("_")
        return (
            self.at(f"strut_{end}") if value is None and element in ("spring", "damper") else value
        )

    def given(self) -> dict[str, Triple]:
        """Points that the description contains: name to position in m, shape (3,)."""
        points = {name: getattr(self, name) for name in type(self).model_fields}
        return {name: point for name, point in points.items() if point is not None}

    def length(self, element: str) -> float:
        """Design length of ``"spring"``, ``"damper"`` or ``"strut"`` in m."""
        bottom, top = self.at(f"{element}_bottom"), self.at(f"{element}_top")
        assert bottom is not None
        assert top is not None
        return distance(bottom, top)

    def _refuse_lost_points(self) -> None:
        """Refuse points that seem to be in a different unit from the others; if all are large, a finding reports it."""
        sizes = {name: max(abs(value) for value in point) for name, point in self.given().items()}
        for name, size in sizes.items():
            if size > LARGE and min(sizes.values()) < LARGE:
                raise error_at(
                    (name,),
                    "is far from the other points",
                    found=Phrase("{point} m", point=list(getattr(self, name))),
                    hint='Were millimetres given as metres? A number without a unit is in m; write "150 mm".',
                )

    def _refuse_half(self, group: tuple[str, ...]) -> None:
        missing = [name for name in group if getattr(self, name) is None]
        if 0 < len(missing) < len(group):
            raise ValueError(
                Phrase(
                    "{missing} is missing; give all of {group}, or none of them",
                    missing=" and ".join(missing),
                    group=", ".join(group),
                )
            )

    def _refuse_equal(self, first: str, second: str) -> None:
        a, b = self.at(first), self.at(second)
        if a is None or b is None or distance(a, b) >= SAME_POINT:
            return
        first, second = (first, second) if getattr(self, second) is not None else (second, first)
        raise error_at(
            (second,),
            Phrase("coincides with {name}", name=first),
            found=Phrase("{point} for both", point=write_point(b)),
            allowed="two points that differ",
            hint="Was a line copied but not edited?",
        )

    def _refuse_one_line(self, start: str, end: str, turned: str) -> None:
        a, b, c = self.at(start), self.at(end), self.at(turned)
        if a is None or b is None or c is None:
            return
        if distance_to_line(c, a, b) < ON_ONE_LINE * max(distance(a, b), distance(a, c)):
            raise error_at(
                (turned,),
                Phrase("is on the line through {start} and {end}", start=start, end=end),
                found=Phrase(write_point(c)),
                allowed="a point away from it, because it could not rotate about that axis",
            )


def write_point(point: Triple) -> str:
    """Write a point as files do, in mm."""
    return "[" + ", ".join(f'"{1e3 * value:g} mm"' for value in point) + "]"
