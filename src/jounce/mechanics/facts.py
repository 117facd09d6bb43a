"""Facts about a model without its equations: names, counts and units that a compiled run needs."""

from __future__ import annotations

from dataclasses import dataclass

ROAD = "road.z"
"""Last words of the names of tracks for the road under a wheel."""


def is_road(track: str) -> bool:
    """Whether a track is the road under a wheel (m); other tracks are loads and commands."""
    return track == ROAD or track.endswith(f".{ROAD}")


def speed_of(coordinate: str) -> str:
    """Return the channel name of a coordinate's speed.

    Examples
    --------
    >>> speed_of("body.z"), speed_of("body.pitch")
    ('body.vz', 'body.pitch_rate')
    """
    place, dot, word = coordinate.rpartition(".")
    return f"{place}{dot}{f'v{word}' if word in ('x', 'y', 'z') else f'{word}_rate'}"


def motion_of_speed(speed: str) -> str:
    """Return the name of the motion to which a speed belongs: its coordinate if the speed is the coordinate's rate.

    Examples
    --------
    >>> [motion_of_speed(name) for name in ("body.vz", "body.pitch_rate", "lower_arm.angle rate", "ball_joint.wx")]
    ['body.z', 'body.pitch', 'lower_arm.angle', 'ball_joint.wx']
    """
    place, dot, word = speed.rpartition(".")
    if word in ("vx", "vy", "vz"):
        return f"{place}{dot}{word[1:]}"
    return speed.removesuffix(" rate").removesuffix("_rate")


MIDDLE, HALF, REACH = "travel.middle", "travel.half", "travel.reach"
"""Parameters of a reduced corner: centre and half width (m) of the travel range of its polynomials, and the distance
from the centre, in half widths, beyond which the mass of a car's wheel is NaN and a run ends."""


def of_travel(quantity: str, degree: int) -> list[str]:
    """Return the parameter names of a quantity's polynomial, constant term first.

    Examples
    --------
    >>> of_travel("momentum", 1)
    ['of_travel.momentum[0]', 'of_travel.momentum[1]']
    """
    return [f"of_travel.{quantity}[{k}]" for k in range(degree + 1)]


@dataclass(frozen=True)
class Output:
    """An output signal of a model: channel name, SI unit and label."""

    name: str
    unit: str
    long_name: str


@dataclass(frozen=True)
class Equation:
    """An equation that closes a loop: its name, its joint, and the unit of its residual.

    The unit is ``m`` for a distance, ``rad`` for the sine of an angle, ``m^2`` for half the square of a length, and
    ``""`` for a condition on coordinates, which may mix units.
    """

    name: str
    joint: str
    unit: str


@dataclass(frozen=True)
class ModelFacts:
    """Names and counts of a model, without its equations (see :class:`Model`).

    ``start`` holds the coordinates in the design pose (m, rad, 1 for quaternions); ``linear_without`` the parameters
    that must be zero for the model to be piecewise linear, or None if it is nonlinear even then.
    """

    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]
    internal: tuple[str, ...]
    constraints: tuple[str, ...]
    tracks: tuple[str, ...]
    track_order: int
    parameters: tuple[str, ...]
    switches: tuple[str, ...]
    outputs: tuple[Output, ...]
    start: tuple[float, ...]
    projects: bool
    linear_without: tuple[str, ...] | None

    @property
    def states(self) -> tuple[str, ...]:
        """Names of all states: coordinates, speeds, internal states."""
        return (*self.coordinates, *self.speeds, *self.internal)

    @property
    def counts(self) -> tuple[int, int]:
        """Numbers of coordinates and of speeds."""
        return len(self.coordinates), len(self.speeds)


SLOPE_LANES = 8
"""Number of directions that the function ``slopes`` differentiates along in one call."""
SLOPES = ("rate", "output", "switch", "constraint")
"""Parts of its result, in order."""
