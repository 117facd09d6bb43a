"""Options of a trial: road with speed and duration, or excitation, and loads on the vehicle."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, TypeAlias

from jounce.core.errors import DescriptionError
from jounce.core.operation import File, MadeBy, Mark, Number
from jounce.core.phrases import Phrase
from jounce.core.typed import quantity
from jounce.roads.loading import load_road
from jounce.roads.road import ROADS
from jounce.roads.trial import Trial

AnyTrial: TypeAlias = Annotated[
    Trial, MadeBy("jounce.roads.options:trial_of_options", "jounce.roads.options:trial_in_python")
]
"""A trial; faces ask for its road, speed and duration, or for an excitation."""
ROAD = File(
    "A road: TOML, OpenCRG or table file, or a name of `jounce library`.", shipped=("roads",)
)
SPEED = Number('Speed over the road, e.g. "1.95 m/s".', "SPEED", "m/s")
DURATION = Number('Length of the run, e.g. "3 s".', "TIME", "s", is_positive=True)
EXCITATION = File("Instead of --road and --speed: a file with columns time and road.z.")


def trial_of_options(
    road: Annotated[str | None, ROAD] = None,
    speed: Annotated[float | None, SPEED] = None,
    duration: Annotated[float | None, DURATION] = None,
    excitation: Annotated[str | None, EXCITATION] = None,
    right_road: Annotated[
        str | None,
        File(
            "Full cars: road under the right wheels; by default that of the left.",
            shipped=("roads",),
        ),
    ] = None,
    pitch_moment: Annotated[
        str | None,
        Mark('Vehicles: moment on the body, nose-down positive, "100 N*m@3 s".', "VALUE[@TIME]"),
    ] = None,
    deceleration: Annotated[
        str | None, Mark('Vehicles: braking deceleration, "3 m/s^2@1 s".', "VALUE[@TIME]")
    ] = None,
    lateral_acceleration: Annotated[
        str | None,
        Mark('Full cars: lateral acceleration to the left, "4 m/s^2@1 s".', "VALUE[@TIME]"),
    ] = None,
) -> Trial:
    """Build a trial from options.

    Raises
    ------
    DescriptionError
        If road and excitation are both given or both missing, speed or duration is missing, or a value is out of range.
    """
    given = _check_options(road, speed, duration, excitation, right_road)
    loads = {
        "pitch_moment": pitch_moment,
        "deceleration": deceleration,
        "lateral_acceleration": lateral_acceleration,
    }
    given |= {name: _load(name, text) for name, text in loads.items() if text is not None}
    if excitation is not None:
        return Trial(excitation=excitation, **given)
    driven = given["speed"] * given["duration"]
    roads = {"road": road, "right": right_road}
    return Trial(
        **{
            name: load_road(text, length=driven) for name, text in roads.items() if text is not None
        },
        **given,
    )


def _check_options(
    road: str | None,
    speed: float | None,
    duration: float | None,
    excitation: str | None,
    right_road: str | None,
) -> dict[str, Any]:
    """Check the consistency of the options; return speed and duration if given."""
    if (road is None) == (excitation is None):
        raise DescriptionError(
            "either a road or an excitation is needed"
            if road is None
            else "both a road and an excitation are given",
            where="--road, --excitation",
            allowed='--road ROAD --speed "1.95 m/s" --duration "3 s", or --excitation base.csv',
        )
    if excitation is not None:
        for option, value, what in (
            ("--speed", speed, "speed"),
            ("--right-road", right_road, "road"),
        ):
            if value is not None:
                hint = Phrase("Leave out the {what}.", what=what)
                raise DescriptionError(
                    "an excitation is already a function of time", where=option, hint=hint
                )
        return {} if duration is None else {"duration": duration}
    for option, value, example in (("--speed", speed, "1.95 m/s"), ("--duration", duration, "3 s")):
        if value is None:
            raise DescriptionError(
                Phrase("{option} is missing; every road requires it", option=option),
                allowed=f'{option} "{example}"',
            )
    if speed is not None and speed <= 0.0:
        raise DescriptionError(
            "out of range", where="--speed", found=f"{speed:g} m/s", allowed="above 0 m/s"
        )
    return {"speed": speed, "duration": duration}


def _load(name: str, text: str) -> dict[str, float]:
    """Parse ``VALUE`` or ``VALUE@TIME``, a load from the start of the run or from a given time."""
    option = f"--{name.replace('_', '-')}"
    value, at, start = text.partition("@")
    load = {"value": quantity(value.strip(), "N*m" if name == "pitch_moment" else "m/s^2", option)}
    if at:
        load["start"] = quantity(start.strip(), "s", option)
        if load["start"] < 0.0:
            raise DescriptionError(
                "out of range", where=option, found=start.strip(), allowed="a time of at least 0 s"
            )
    return load


def trial_in_python(**options: Any) -> str:
    """Return Python code that builds the trial.

    >>> trial_in_python(road="bump.toml", speed=1.95, duration=3.0)
    "jn.Trial(road=jn.load_road('bump.toml', length=5.85), speed=1.95, duration=3.0)"
    >>> trial_in_python(road={"kind": "half-sine", "height": "10 mm", "length": "1 m"}, speed=1.95, duration=3.0)
    "jn.Trial(road=jn.HalfSine(height='10 mm', length='1 m'), speed=1.95, duration=3.0)"
    """
    known = ("road", "speed", "duration", "excitation", "right_road")
    given = _check_options(*(options.get(name) for name in known))
    written = []
    for name, key in (("road", "road"), ("right_road", "right")):
        if name in options:
            written.append(
                f"{key}={_road_in_python(options[name], given['speed'] * given['duration'])}"
            )
    given |= {name: _load(name, text) for name, text in options.items() if name not in known}
    given |= {name: options[name] for name in ("excitation",) if name in options}
    return f"jn.Trial({', '.join([*written, *(f'{name}={value!r}' for name, value in given.items())])})"


def _road_in_python(road: str | Mapping[str, Any], length: float) -> str:
    """Return Python code of a road from its file, name or obstacle keys."""
    if isinstance(road, str):
        return f"jn.load_road({road!r}, length={length:.10g})"
    keys = ", ".join(f"{key}={value!r}" for key, value in road.items() if key != "kind")
    return f"jn.{ROADS[road['kind']].__name__}({keys})"
