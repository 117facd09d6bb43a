"""Obstacles with a closed form, and trains of them.

Heights are in m, positive upwards; a negative height is a hole of the same shape.
"""

from __future__ import annotations

import math
from typing import Literal

from pydantic import Field

from jounce.core.description import Whole
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE
from jounce.core.units import Height, NonNegativeLength, PositiveHeight, PositiveLength
from jounce.roads.profile import Piece, Profile, profile, repeat
from jounce.roads.road import Road, RoadOf


def _line(length: float, height: float, slope: float) -> Piece:
    return length, POLYNOMIAL, (height, slope, 0.0, 0.0)


class Flat(Road):
    """A level road.

    Examples
    --------
    >>> float(Flat().height_at(3.0))
    0.0
    """

    kind: Literal["flat"] = "flat"

    def profile(self) -> Profile:
        """Return an empty profile: level throughout."""
        return profile()


class HalfSine(Road):
    """Half wave ``h sin(pi x / l)`` with a kink at each foot.

    Attributes
    ----------
    height, length : float
        Crest height and foot-to-foot length in m.

    Examples
    --------
    >>> obstacle = HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    >>> float(obstacle.height_at(0.23)), obstacle.end()
    (0.01, 0.26)
    """

    kind: Literal["half-sine"] = "half-sine"
    height: Height
    length: PositiveLength

    def profile(self) -> Profile:
        """Return one sine piece."""
        return profile((self.length, SINE, (0.0, self.height, math.pi / self.length, 0.0)))


class Versine(Road):
    """Full wave ``h/2 (1 - cos(2 pi x / l))`` without kinks.

    Attributes
    ----------
    height, length : float
        Crest height and foot-to-foot length in m.

    Examples
    --------
    >>> float(Versine(height="10 mm", length="60 mm").height_at(0.015).round(12))
    0.005
    """

    kind: Literal["versine"] = "versine"
    height: Height
    length: PositiveLength

    def profile(self) -> Profile:
        """Return one sine piece about half the height."""
        half = 0.5 * self.height
        return profile(
            (self.length, SINE, (half, half, 2.0 * math.pi / self.length, -0.5 * math.pi))
        )


class Rectangle(Road):
    """Cleat: the height jumps up, stays, and jumps down.

    At the jump, the damper of a tyre gives the wheel an impulse (N s): its coefficient times the height.

    Attributes
    ----------
    height, length : float
        Height and length in m. A wheel that starts on it (``start`` 0) starts at its height.

    Examples
    --------
    >>> Rectangle(height="10 mm", length="60 mm", start="1 m").height_at([0.999, 1.0, 1.06]).tolist()
    [0.0, 0.01, 0.0]
    """

    kind: Literal["rectangle"] = "rectangle"
    height: Height
    length: PositiveLength

    def profile(self) -> Profile:
        """Return one raised piece between two jumps."""
        return profile(_line(self.length, self.height, 0.0))


class Trapezoid(Road):
    """Ramp up, plateau and ramp down, with straight or half-cosine ramps.

    Attributes
    ----------
    height, length, ramp : float
        Plateau height, total length and length of each ramp, in m; the ramp is at most half the length.
    shape : {"linear", "cosine"}
        Straight ramps, or half cosine waves ``h/2 (1 - cos(pi x / ramp))`` without kinks.

    Examples
    --------
    >>> Trapezoid(height="10 mm", length="0.3 m", ramp="0.1 m").height_at([0.05, 0.15]).round(12).tolist()
    [0.005, 0.01]
    """

    kind: Literal["trapezoid"] = "trapezoid"
    height: Height
    length: PositiveLength
    ramp: PositiveLength
    shape: Literal["linear", "cosine"] = "linear"

    def check(self) -> None:
        """Reject ramps longer than half the length."""
        if 2.0 * self.ramp > self.length * (1.0 + 1e-9):
            text = "two ramps of {ramp:g} m do not fit into the length {length:g} m"
            most = Phrase("a ramp up to {most:g} m", most=0.5 * self.length)
            raise error_at((), Phrase(text, ramp=self.ramp, length=self.length), allowed=most)

    def profile(self) -> Profile:
        """Return ramp, plateau, ramp; without a plateau if the ramps meet."""
        plateau = _line(max(self.length - 2.0 * self.ramp, 0.0), self.height, 0.0)
        if self.shape == "cosine":
            up, down = (_half_wave(self.ramp, self.height, side) for side in (-0.5, 0.5))
            return profile(up, plateau, down)
        slope = self.height / self.ramp
        return profile(_line(self.ramp, 0.0, slope), plateau, _line(self.ramp, self.height, -slope))


class Triangle(Road):
    """Ramp up to the middle and down again.

    Attributes
    ----------
    height, length : float
        Crest height and foot-to-foot length in m.

    Examples
    --------
    >>> Triangle(height="10 mm", length="0.2 m").slope_at([0.05, 0.15]).round(12).tolist()
    [0.1, -0.1]
    """

    kind: Literal["triangle"] = "triangle"
    height: Height
    length: PositiveLength

    def profile(self) -> Profile:
        """Return two lines."""
        half = 0.5 * self.length
        slope = self.height / half
        return profile(_line(half, 0.0, slope), _line(half, self.height, -slope))


class HalfCylinder(Road):
    """Half-round bar ``sqrt(r^2 - (x - r)^2)`` across the road, with vertical feet.

    Attributes
    ----------
    radius : float
        Radius in m, equal to the height and half the length.

    Examples
    --------
    >>> float(HalfCylinder(radius="50 mm").height_at(0.01).round(12))
    0.03
    """

    kind: Literal["half-cylinder"] = "half-cylinder"
    radius: PositiveLength

    def profile(self) -> Profile:
        """Return one semicircular arc."""
        return profile((2.0 * self.radius, CIRCLE, (0.0, self.radius, self.radius, 1.0)))


class CircularSegment(Road):
    """Cylinder arc through both feet and the crest, e.g. a round-top speed hump.

    Attributes
    ----------
    height, length : float
        Crest height and foot-to-foot length in m; the height is at most half the length (a half-cylinder).

    Examples
    --------
    >>> hump = CircularSegment(height="0.1 m", length="3.7 m")
    >>> hump.height_at([0.0, 1.85]).round(12).tolist()
    [0.0, 0.1]
    """

    kind: Literal["circular-segment"] = "circular-segment"
    height: Height
    length: PositiveLength

    def check(self) -> None:
        """Reject heights above half the length."""
        if abs(self.height) > 0.5 * self.length * (1.0 + 1e-9):
            text = "the height {height:g} m exceeds that of a half-cylinder of length {length:g} m"
            most = Phrase("up to {most:g} m", most=0.5 * self.length)
            raise error_at((), Phrase(text, height=self.height, length=self.length), allowed=most)

    def profile(self) -> Profile:
        """Return one arc through both feet and the crest."""
        half, rise = 0.5 * self.length, abs(self.height)
        if rise == 0.0:
            return profile(_line(self.length, 0.0, 0.0))
        radius = max(0.5 * (half**2 / rise + rise), half)
        side = math.copysign(1.0, self.height)
        return profile((self.length, CIRCLE, (side * (rise - radius), radius, half, side)))


class Step(Road):
    """The height jumps to h and stays.

    At the jump, the damper of a tyre gives the wheel an impulse (N s): its coefficient times the height.

    Attributes
    ----------
    height : float
        Height after the step in m.

    Examples
    --------
    >>> Step(height="-20 mm", start="1 m").height_at([0.5, 1.0, 9.0]).tolist()
    [0.0, -0.02, -0.02]
    """

    kind: Literal["step"] = "step"
    height: Height

    def profile(self) -> Profile:
        """Return one jump without pieces."""
        return profile(after=self.height)


class Ramp(Road):
    """Rise to a new level h: ``h x / l``, or half a cosine wave ``h/2 (1 - cos(pi x / l))``.

    Attributes
    ----------
    height, length : float
        Level after the ramp and length of the rise in m.
    shape : {"linear", "cosine"}
        ``h x / l``, or ``h/2 (1 - cos(pi x / l))`` without kinks.

    Examples
    --------
    >>> Ramp(height="0.1 m", length="2 m", shape="cosine").height_at([1.0, 5.0]).round(12).tolist()
    [0.05, 0.1]
    """

    kind: Literal["ramp"] = "ramp"
    height: Height
    length: PositiveLength
    shape: Literal["linear", "cosine"] = "linear"

    def profile(self) -> Profile:
        """Return one line or one sine piece."""
        if self.shape == "linear":
            return profile(_line(self.length, 0.0, self.height / self.length), after=self.height)
        return profile(_half_wave(self.length, self.height, -0.5), after=self.height)


class Kerb(Road):
    """Step with a quarter-circle upper edge, up to a new level or, with a negative height, down to one.

    Attributes
    ----------
    height : float
        Level after the kerb in m.
    edge_radius : float
        Radius in m of the rounded upper edge, at most the kerb's height; 0 for a `Step`.

    Examples
    --------
    >>> Kerb(height="120 mm", edge_radius="20 mm").height_at([0.0, 0.02, 3.0]).round(12).tolist()
    [0.1, 0.12, 0.12]
    """

    kind: Literal["kerb"] = "kerb"
    height: Height
    edge_radius: NonNegativeLength = 0.0

    def check(self) -> None:
        """Reject an edge radius larger than the kerb's height."""
        _check_edge(self.edge_radius, self.height, "height")

    def profile(self) -> Profile:
        """Return a quarter circle, and the remaining height as a jump."""
        upper = max(self.height, 0.0)
        return profile(_edge(self.edge_radius, upper, down=self.height < 0.0), after=self.height)


class Pothole(Road):
    """Hole with vertical walls and optionally rounded upper edges.

    Attributes
    ----------
    depth, length : float
        Depth and length at the road's surface, in m, above 0.
    edge_radius : float
        Radius in m of the upper edges, at most the depth and half the length; 0 for sharp edges.

    Examples
    --------
    >>> Pothole(depth="50 mm", length="0.4 m", edge_radius="10 mm").height_at([0.0, 0.2, 0.4]).round(12).tolist()
    [0.0, -0.05, 0.0]
    """

    kind: Literal["pothole"] = "pothole"
    depth: PositiveHeight
    length: PositiveLength
    edge_radius: NonNegativeLength = 0.0

    def check(self) -> None:
        """Reject edge radii above the depth or above half the length."""
        _check_edge(self.edge_radius, self.depth, "depth")
        if 2.0 * self.edge_radius > self.length * (1.0 + 1e-9):
            text = "two edges of radius {radius:g} m do not fit into the length {length:g} m"
            most = Phrase("an edge_radius up to {most:g} m", most=0.5 * self.length)
            raise error_at(
                (), Phrase(text, radius=self.edge_radius, length=self.length), allowed=most
            )

    def profile(self) -> Profile:
        """Return edge, bottom, edge."""
        bottom = _line(max(self.length - 2.0 * self.edge_radius, 0.0), -self.depth, 0.0)
        radius = self.edge_radius
        return profile(_edge(radius, 0.0, down=True), bottom, _edge(radius, 0.0, down=False))


class Train(RoadOf):
    """Repetition of the obstacle ``of``, ``count`` times, with a ``pitch`` from start to start.

    Steps and ramps accumulate: each starts at the end level of the previous one. ``start`` and ``recurrence`` default
    to those of ``of`` and do not affect the positions within the train.

    Attributes
    ----------
    of : Road
        Obstacle, which may itself be a train.
    count : int
        Number of obstacles.
    pitch : float
        Distance in m between the starts of successive obstacles, at least the obstacle's length.

    Examples
    --------
    >>> train = Train(of=HalfSine(height="10 mm", length="60 mm", start="0.2 m"), count=5, pitch="0.10 m")
    >>> train.start, round(train.end() - train.start, 12)
    (0.2, 0.46)
    """

    kind: Literal["train"] = "train"
    count: Whole = Field(ge=1, le=1_000_000)
    pitch: PositiveLength

    def check(self) -> None:
        """Reject overlaps; copy ``start`` and ``recurrence`` from the obstacle."""
        for name in ("start", "recurrence"):
            if name not in self.model_fields_set:
                object.__setattr__(self, name, getattr(self.of, name))
        length = self.of.profile().span
        if self.count > 1 and self.pitch < length * (1.0 - 1e-9):
            what = Phrase(
                (
                    "the obstacles overlap: the pitch {pitch:g} m (start to start) is shorter than the "
                    "obstacle length {length:g} m"
                ),
                pitch=self.pitch,
                length=length,
            )
            raise error_at(
                (), what, allowed=Phrase("a pitch of at least {length:g} m", length=length)
            )

    def profile(self) -> Profile:
        """Return the pieces of the whole train."""
        return repeat(self.of.profile(), self.count, self.pitch)

    def known_length(self) -> float:
        """Return the distance in m up to which the train is known; infinite if the obstacle's is."""
        return (
            math.inf
            if self.recurrence is not None or math.isinf(self.of.known_length())
            else self.end()
        )


def _half_wave(length: float, height: float, quarter: float) -> Piece:
    """Return half a cosine wave: up from 0 to ``height`` (quarter -0.5) or down to 0 (0.5)."""
    half = 0.5 * height
    return length, SINE, (half, half, math.pi / length, quarter * math.pi)


def _edge(radius: float, upper: float, *, down: bool) -> Piece:
    """Return a quarter circle below the level ``upper``, either down from it or up to it."""
    return radius, CIRCLE, (upper - radius, radius, 0.0 if down else radius, 1.0)


def _check_edge(radius: float, height: float, name: str) -> None:
    if radius > abs(height) * (1.0 + 1e-9):
        text = "an edge radius of {radius:g} m exceeds the {name} {height:g} m"
        most = Phrase("an edge_radius up to {most:g} m", most=abs(height))
        raise error_at(
            (), Phrase(text, radius=radius, name=Phrase(name), height=abs(height)), allowed=most
        )
