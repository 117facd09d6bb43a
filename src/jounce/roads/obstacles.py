"""Obstacles with a closed form. Heights are in m, up positive; a negative height is a hole of the same shape."""

from __future__ import annotations

import math
from typing import Literal

from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE
from jounce.core.units import Length, PositiveLength
from jounce.roads.profile import Piece, Profile, profile
from jounce.roads.road import Road


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
        """No piece at all: nothing but level."""
        return profile()


class HalfSine(Road):
    """Half wave ``h sin(pi x / l)``, with a kink at either foot.

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
    height: Length
    length: PositiveLength

    def profile(self) -> Profile:
        """One sine piece."""
        return profile((self.length, SINE, (0.0, self.height, math.pi / self.length, 0.0)))


class Versine(Road):
    """Full wave ``h/2 (1 - cos(2 pi x / l))``, with no kink at all.

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
    height: Length
    length: PositiveLength

    def profile(self) -> Profile:
        """One sine piece around half the height."""
        half = 0.5 * self.height
        return profile((self.length, SINE, (half, half, 2.0 * math.pi / self.length, -0.5 * math.pi)))


class Rectangle(Road):
    """Cleat: the height jumps up, stays, and jumps down.

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
    height: Length
    length: PositiveLength

    def profile(self) -> Profile:
        """One raised piece between two jumps."""
        return profile(_line(self.length, self.height, 0.0))


class Trapezoid(Road):
    """Ramp up, plateau, ramp down.

    Attributes
    ----------
    height, length, ramp : float
        Plateau height, total length and the length of each ramp, in m; twice the ramp fits into the length.

    Examples
    --------
    >>> Trapezoid(height="10 mm", length="0.3 m", ramp="0.1 m").height_at([0.05, 0.15]).round(12).tolist()
    [0.005, 0.01]
    """

    kind: Literal["trapezoid"] = "trapezoid"
    height: Length
    length: PositiveLength
    ramp: PositiveLength

    def check(self) -> None:
        """Refuse ramps that do not fit."""
        if 2.0 * self.ramp > self.length * (1.0 + 1e-9):
            raise ValueError(
                f"two ramps of {self.ramp:g} m do not fit into the length {self.length:g} m; "
                f"allowed: a ramp up to {0.5 * self.length:g} m"
            )

    def profile(self) -> Profile:
        """Three lines; no plateau when the ramps meet."""
        slope = self.height / self.ramp
        plateau = _line(max(self.length - 2.0 * self.ramp, 0.0), self.height, 0.0)
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
    height: Length
    length: PositiveLength

    def profile(self) -> Profile:
        """Two lines."""
        half = 0.5 * self.length
        slope = self.height / half
        return profile(_line(half, 0.0, slope), _line(half, self.height, -slope))


class HalfCylinder(Road):
    """Half-round bar lying across the road; its feet are vertical.

    Attributes
    ----------
    radius : float
        Radius in m: the height, and half the length.

    Examples
    --------
    >>> float(HalfCylinder(radius="50 mm").height_at(0.01).round(12))
    0.03
    """

    kind: Literal["half-cylinder"] = "half-cylinder"
    radius: PositiveLength

    def profile(self) -> Profile:
        """One arc of half a turn."""
        return profile((2.0 * self.radius, CIRCLE, (0.0, self.radius, self.radius, 1.0)))


class CircularSegment(Road):
    """Part of a cylinder above the road, as a round-top speed hump.

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
    height: Length
    length: PositiveLength

    def check(self) -> None:
        """Refuse what is more than half a cylinder."""
        if abs(self.height) > 0.5 * self.length * (1.0 + 1e-9):
            raise ValueError(
                f"height {self.height:g} m is more than a half-cylinder of length {self.length:g} m has; "
                f"allowed: up to {0.5 * self.length:g} m"
            )

    def profile(self) -> Profile:
        """One arc through both feet and the crest."""
        half, rise = 0.5 * self.length, abs(self.height)
        if rise == 0.0:
            return profile(_line(self.length, 0.0, 0.0))
        radius = max(0.5 * (half**2 / rise + rise), half)
        side = math.copysign(1.0, self.height)
        return profile((self.length, CIRCLE, (side * (rise - radius), radius, half, side)))


class Step(Road):
    """Kerb: the height jumps and stays.

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
    height: Length

    def profile(self) -> Profile:
        """One jump, no piece."""
        return profile(after=self.height)


class Ramp(Road):
    """Rise to a new level, straight or as half a cosine wave.

    Attributes
    ----------
    height, length : float
        Level after the ramp and length of the rise in m.
    shape : {"linear", "cosine"}
        ``h x / l``, or ``h/2 (1 - cos(pi x / l))`` which has no kink.

    Examples
    --------
    >>> Ramp(height="0.1 m", length="2 m", shape="cosine").height_at([1.0, 5.0]).round(12).tolist()
    [0.05, 0.1]
    """

    kind: Literal["ramp"] = "ramp"
    height: Length
    length: PositiveLength
    shape: Literal["linear", "cosine"] = "linear"

    def profile(self) -> Profile:
        """One line or one sine piece."""
        if self.shape == "linear":
            return profile(_line(self.length, 0.0, self.height / self.length), after=self.height)
        half = 0.5 * self.height
        wave = (self.length, SINE, (half, half, math.pi / self.length, -0.5 * math.pi))
        return profile(wave, after=self.height)
