"""Facts about a model without its equations: names, counts and units that a compiled run needs."""

from __future__ import annotations

from dataclasses import dataclass

ROAD = "road.z"
"""Last words of the name of a track that is the road under a wheel."""


def is_road(track: str) -> bool:
    """Whether a track is the road under a wheel, m; others are loads and commands."""
    return track == ROAD or track.endswith(f".{ROAD}")


def speed_of(coordinate: str) -> str:
    """Name of a coordinate's speed, as channels are called.

    Examples
    --------
    >>> speed_of("body.z"), speed_of("body.pitch")
    ('body.vz', 'body.pitch_rate')
    """
    place, dot, word = coordinate.rpartition(".")
    return f"{place}{dot}{f'v{word}' if word in ('x', 'y', 'z') else f'{word}_rate'}"


def motion_of_speed(speed: str) -> str:
    """Name of the motion that has a speed: the coordinate, where the speed is its rate.

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
"""Parameters of a reduced corner: middle and half width (m) of the travel that its polynomials are for; and how many
half widths a wheel of a car may be off the middle, beyond which its mass is no number: there a run ends."""


def of_travel(quantity: str, degree: int) -> list[str]:
    """Parameters of the polynomial of a quantity, constant first.

    Examples
    --------
    >>> of_travel("momentum", 1)
    ['of_travel.momentum[0]', 'of_travel.momentum[1]']
    """
    return [f"of_travel.{quantity}[{k}]" for k in range(degree + 1)]


@dataclass(frozen=True)
class Output:
    """One signal a model can give: its channel name, SI unit and label."""

    name: str
    unit: str
    long_name: str


@dataclass(frozen=True)
class Equation:
    """One equation that closes a loop: its name, the joint it belongs to, and the unit of its value.

    ``m`` is a distance, ``rad`` the sine of an angle; half the square of a length is in ``m^2``, and a condition of
    coordinates, which may mix units, in ``""``.
    """

    name: str
    joint: str
    unit: str


@dataclass(frozen=True)
class ModelFacts:
    """Names and counts of a model, without its equations (see :class:`Model`).

    ``start`` holds the coordinates in the design pose (m, rad, 1 for quaternions); ``linear_without`` the parameters
    that must be zero for the model to be piecewise linear, None where that does not make it so.
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
"""Directions that the function ``slopes`` differentiates along at once."""
SLOPES = ("rate", "output", "switch", "constraint")
"""Parts of its result, one after another."""
