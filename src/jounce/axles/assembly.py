"""Bodies and elements of an axle on its rig, collected by name and packed into the arrays of `kernel.equilibrium`.

Numbers are arrays of shape (m,), points and directions of shape (3, m): one column for the values themselves, or one
per parameter with a complex step, so that the same lines give the numbers of all elements and their slopes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.kernel import equilibrium as eq

GROUND = -1
STEP = 1e-30
"""Complex step of a parameter: its square is below rounding, so the imaginary part is the exact slope."""
Numbers = NDArray[Any]


def cross(a: Numbers, b: Numbers) -> Numbers:
    """Return the cross products of columns."""
    return np.stack(
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    )


def length(a: Numbers) -> Numbers:
    """Return the lengths of columns."""
    return np.asarray(np.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]))


def unit(a: Numbers) -> Numbers:
    """Return the directions of columns."""
    return a / length(a)


def across(a: Numbers) -> tuple[Numbers, Numbers]:
    """Return two directions perpendicular to the directions in columns and to each other."""
    smallest = np.zeros(3)
    smallest[int(np.argmin(np.abs(a[:, 0].real)))] = 1.0
    first = unit(cross(a, smallest[:, None] + 0.0 * a))
    return first, cross(unit(a), first)


@dataclass(frozen=True)
class Law:
    """Force over deflection other than a constant stiffness: its kind, and its numbers, shape (k,)."""

    kind: int
    numbers: tuple[float, ...]
    count: int


@dataclass(frozen=True)
class Element:
    """An element between two bodies (numbers; -1 is the ground), with its numbers, shape (WIDTH, m)."""

    name: str
    kind: int
    first: int
    second: int
    data: Numbers
    laws: tuple[Law | None, ...] = (None,) * 6
    is_control: bool = False


@dataclass(frozen=True)
class Wheel:
    """A wheel on a body: its centre and axis (pointing outboard) at design and its radius, m."""

    body: int
    centre: Numbers
    axis: Numbers
    radius: Numbers


@dataclass
class Assembly:
    """Bodies, elements, wheels and controls under construction."""

    columns: int
    bodies: list[str] = field(default_factory=list)
    elements: list[Element] = field(default_factory=list)
    wheels: list[Wheel] = field(default_factory=list)
    controls: list[tuple[str, int, int]] = field(default_factory=list)

    # bodies and elements -----------------------------------------------------------------------------------------

    def body(self, name: str) -> int:
        """Add a body and return its number."""
        self.bodies.append(name)
        return len(self.bodies) - 1

    def bushing(
        self,
        name: str,
        first: int,
        second: int,
        point: Numbers,
        *,
        stiffness: Any,
        axes: Any = None,
        preload: Any = 0.0,
        slip: Any = 0.0,
        hold: Any = 0.0,
        laws: tuple[Law | None, ...] = (None,) * 6,
    ) -> None:
        """Add a bushing; ``axes`` has its directions in rows, shape (3, 3, m), and six numbers a shape (6, m)."""
        axes = np.eye(3)[:, :, None] if axes is None else axes
        groups = ((eq.P, 3, point), (eq.A, 9, axes), (eq.K, 6, stiffness), (eq.F, 6, preload))
        self._add(
            name,
            eq.BUSHING,
            first,
            second,
            *groups,
            (eq.S, 6, slip),
            (eq.B, 6, hold),
            (eq.C, 6, 1.0),
            laws=laws,
        )

    def line(  # noqa: PLR0913 - numbers of one law
        self,
        name: str,
        first: int,
        second: int,
        points: tuple[Numbers, Numbers],
        *,
        rate: Any = 0.0,
        zero: Any = None,
        sign: float = 1.0,
        preload: Any = 0.0,
        slip: Any = 0.0,
        hold: Any = 0.0,
        law: Law | None = None,
    ) -> None:
        """Add an element that pushes two points apart by ``preload + sign * law(sign * (zero - length))``."""
        zero = length(points[1] - points[0]) if zero is None else zero
        groups = ((eq.P, 3, points[0]), (eq.Q, 3, points[1]), (eq.LENGTH, 1, zero))
        self._add(
            name,
            eq.LINE,
            first,
            second,
            *groups,
            (eq.SIGN, 1, sign),
            (eq.PRELOAD, 1, preload),
            (eq.SLIP, 1, slip),
            (eq.HOLD, 1, hold),
            (eq.RATE, 1, rate),
            (eq.FACTOR, 1, 1.0),
            laws=(law, *(None,) * 5),
        )

    def twist(
        self, name: str, first: int, second: int, axis: Numbers, rate: Any, preload: Any = 0.0
    ) -> None:
        """Add a torsion spring about an axis that two bodies share; its torque is ``preload - rate * angle``."""
        mark, _ = across(axis)
        groups = ((eq.P, 3, unit(axis)), (eq.Q, 3, mark), (eq.PRELOAD, 1, preload))
        self._add(name, eq.TWIST, first, second, *groups, (eq.RATE, 1, rate))

    def ball(
        self, name: str, first: int, second: int, point: Numbers, other: Numbers | None = None
    ) -> None:
        """Let two bodies share a point."""
        groups = ((eq.P, 3, point), (eq.Q, 3, point if other is None else other))
        self._add(name, eq.POINT, first, second, *groups)

    def along(
        self,
        name: str,
        first: int,
        second: int,
        points: tuple[Numbers, Numbers],
        direction: Numbers,
        *,
        is_control: bool = False,
    ) -> None:
        """Keep the distance of two points along a direction of the first body, or let a control prescribe it."""
        apart = points[1] - points[0]
        value = direction[0] * apart[0] + direction[1] * apart[1] + direction[2] * apart[2]
        groups = ((eq.P, 3, points[0]), (eq.Q, 3, points[1]), (eq.ALONG, 3, direction))
        if is_control:
            self.controls.append((name, 1, len(self.elements)))
        self._add(
            name, eq.DOT, first, second, *groups, (eq.LENGTH, 1, value), is_control=is_control
        )

    def align(self, name: str, first: int, second: int, one: Numbers, other: Numbers) -> None:
        """Keep the angle between a direction of one body and one of another."""
        cosine = one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
        self._add(
            name, eq.ALIGN, first, second, (eq.A, 3, one), (eq.P, 3, other), (eq.LENGTH, 1, cosine)
        )

    def distance(self, name: str, first: int, second: int, points: tuple[Numbers, Numbers]) -> None:
        """Keep the distance of two points: a rigid rod with a ball joint at each end."""
        groups = ((eq.P, 3, points[0]), (eq.Q, 3, points[1]))
        self._add(
            name,
            eq.DISTANCE,
            first,
            second,
            *groups,
            (eq.LENGTH, 1, length(points[1] - points[0])),
        )

    # joints of several rows ------------------------------------------------------------------------------------------

    def hinge(
        self, name: str, firsts: tuple[int, int], second: int, points: tuple[Numbers, Numbers]
    ) -> None:
        """Let a body turn about the line through two points, each on a body of its own."""
        self.ball(name, firsts[0], second, points[0])
        for direction in across(points[1] - points[0]):
            self.along(f"{name}.axis", firsts[1], second, (points[1], points[1]), direction)

    def slide(self, name: str, first: int, second: int, point: Numbers, axis: Numbers) -> None:
        """Let a body slide along an axis of another without turning."""
        for direction in across(axis):
            self.along(name, first, second, (point, point), direction)
        self.parallel(name, first, second, axis)

    def parallel(self, name: str, first: int, second: int, axis: Numbers | None = None) -> None:
        """Keep the orientation of one body in another."""
        x = np.array([[1.0], [0.0], [0.0]]) if axis is None else unit(axis)
        y, z = across(x)
        for one, other in ((x, y), (y, z), (z, x)):
            self.align(f"{name}.orientation", first, second, one, other)

    # packing ---------------------------------------------------------------------------------------------------------

    def wheel(self, name: str, body: int, centre: Numbers, axis: Numbers, radius: Numbers) -> None:
        """Add a wheel, whose lowest point is a control."""
        self.controls.append((name, 0, len(self.wheels)))
        self.wheels.append(Wheel(body, centre, axis, radius))

    def _add(
        self,
        name: str,
        kind: int,
        first: int,
        second: int,
        *groups: tuple[int, int, Any],
        laws: tuple[Law | None, ...] = (None,) * 6,
        is_control: bool = False,
    ) -> None:
        data = np.zeros((eq.WIDTH, self.columns), dtype=complex)
        for place, count, values in groups:
            numbers = np.asarray(values)
            data[place : place + count] = numbers.reshape(9, -1) if count == 9 else numbers
        self.elements.append(Element(name, kind, first, second, data, laws, is_control))

    def order(self) -> tuple[int, ...]:
        """Return the first row of multipliers of each element, -1 for none, and their number at the end."""
        rows, total = [], 0
        for element in self.elements:
            count = 0 if element.is_control else eq.ROWS[element.kind]
            rows.append(total if count else -1)
            total += count
        return (*rows, total)

    def arrays(self) -> tuple[eq.Assembly, int]:
        """Return the arrays of its values, and the number of multipliers."""
        kinds: list[list[int]] = []
        laws: list[list[int]] = []
        numbers: list[float] = []
        *rows, total = self.order()
        for element, row in zip(self.elements, rows, strict=True):
            own = []
            for law in element.laws:
                if law is None:
                    own.append(-1)
                    continue
                own.append(len(laws))
                laws.append([law.kind, len(numbers), law.count])
                numbers.extend(law.numbers)
            kinds.append([element.kind, element.first, element.second, row, *own])
        wheels = np.zeros((len(self.wheels), eq.WHEEL))
        for k, wheel in enumerate(self.wheels):
            wheels[k] = self._numbers_of(wheel)[:, 0].real
        return eq.Assembly(
            np.array(kinds, dtype=np.int64).reshape(-1, 10),
            np.array([element.data[:, 0].real for element in self.elements]),
            np.array(laws, dtype=np.int64).reshape(-1, 3),
            np.array(numbers, dtype=float),
            np.array([wheel.body for wheel in self.wheels], dtype=np.int64),
            wheels,
            np.array([control[1:] for control in self.controls], dtype=np.int64).reshape(-1, 2),
        ), total

    def seeds(self) -> eq.Seeds:
        """Return how the numbers of elements and wheels change with the parameters of the columns."""
        places: list[tuple[int, int]] = []
        changes: list[Array] = []
        rows = [(place, element.data) for place, element in enumerate(self.elements)]
        rows += [(-1 - k, self._numbers_of(wheel)) for k, wheel in enumerate(self.wheels)]
        for place, data in rows:
            slopes = data.imag / STEP
            for column in np.flatnonzero(np.any(slopes != 0.0, axis=0)):
                change = np.zeros(eq.WIDTH)
                change[: len(slopes)] = slopes[:, column]
                places.append((place, int(column)))
                changes.append(change)
        return eq.Seeds(
            np.array(places, dtype=np.int64).reshape(-1, 2),
            np.array(changes, dtype=float).reshape(-1, eq.WIDTH),
        )

    def _numbers_of(self, wheel: Wheel) -> Numbers:
        data = np.zeros((eq.WHEEL, self.columns), dtype=complex)
        data[:3], data[3:6], data[6] = wheel.centre, wheel.axis, wheel.radius
        return data

    def names(self) -> Sequence[str]:
        """Return the names of all unknowns, six of each body and one of each multiplier and control."""
        motions = ("x", "y", "z", "turn about x", "turn about y", "turn about z")
        unknowns = [f"{body}: {motion}" for body in self.bodies for motion in motions]
        for element in self.elements:
            count = 0 if element.is_control else eq.ROWS[element.kind]
            unknowns += [element.name] * count
        return [*unknowns, *(name for name, *_ in self.controls)]
