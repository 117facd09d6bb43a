"""Schema of a recording: channels on a common time axis, each with unit, label and place (part of the rig)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.datasets import dataset
from jounce.core.errors import DescriptionError, RecordingError, nearest
from jounce.core.phrases import Phrase
from jounce.core.remembered import once_per_object
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import conversion_factor

if TYPE_CHECKING:
    import xarray as xr

QUANTITIES: dict[str, tuple[str, str]] = {
    "x": ("m", "longitudinal position"),
    "y": ("m", "lateral position"),
    "z": ("m", "vertical position"),
    "vx": ("m/s", "longitudinal velocity"),
    "vy": ("m/s", "lateral velocity"),
    "vz": ("m/s", "vertical velocity"),
    "ax": ("m/s^2", "longitudinal acceleration"),
    "ay": ("m/s^2", "lateral acceleration"),
    "az": ("m/s^2", "vertical acceleration"),
    "acceleration": ("m/s^2", "acceleration"),
    "adhesion": ("1", "minimum over static contact force"),
    "angle": ("rad", "angle"),
    "angular_acceleration": ("rad/s^2", "angular acceleration"),
    "angular_velocity": ("rad/s", "angular velocity"),
    "camber": ("rad", "camber angle"),
    "command": ("1", "controller command"),
    "counts": ("1", "counts of a converter"),
    "current": ("A", "electric current"),
    "deflection": ("m", "deflection"),
    "deflection_velocity": ("m/s", "deflection velocity"),
    "displacement": ("m", "displacement"),
    "distance": ("m", "distance"),
    "energy": ("J", "energy"),
    "force": ("N", "force"),
    "frequency": ("Hz", "frequency"),
    "height": ("m", "height"),
    "length": ("m", "length"),
    "load": ("N", "load"),
    "moment": ("N*m", "moment"),
    "phase_angle": ("rad", "phase angle"),
    "pitch": ("rad", "pitch angle"),
    "pitch_acceleration": ("rad/s^2", "pitch acceleration"),
    "pitch_rate": ("rad/s", "pitch rate"),
    "position": ("m", "position"),
    "power": ("W", "power"),
    "pressure": ("Pa", "pressure"),
    "roll": ("rad", "roll angle"),
    "roll_acceleration": ("rad/s^2", "roll acceleration"),
    "roll_rate": ("rad/s", "roll rate"),
    "slope": ("1", "slope"),
    "speed": ("m/s", "speed"),
    "steer": ("rad", "steer angle"),
    "stroke": ("m", "stroke"),
    "time": ("s", "time"),
    "toe": ("rad", "toe angle"),
    "torque": ("N*m", "torque"),
    "travel": ("m", "travel"),
    "velocity": ("m/s", "velocity"),
    "residual": ("1", "constraint residual"),
    "voltage": ("V", "voltage"),
    "yaw": ("rad", "yaw angle"),
    "yaw_rate": ("rad/s", "yaw rate"),
}
"""SI unit and label of every known quantity, by the last word of a channel's name."""


def place_of(name: str) -> str:
    """Return the place of a channel: its name without the last word (``sprung`` for ``sprung.az``)."""
    return name.rpartition(".")[0]


def is_channel(channel: str, name: str) -> bool:
    """Whether a channel has that name, or ends with it after a corner.

    >>> is_channel("front_left.tyre.force", "tyre.force"), is_channel("front_tyre.force", "tyre.force")
    (True, False)
    """
    return channel == name or channel.endswith(f".{name}")


def channels_of(name: str, names: Sequence[str]) -> list[str]:
    """Return the channels of a name: the channel itself, otherwise the matching channel of every corner."""
    return [name] if name in names else [channel for channel in names if is_channel(channel, name)]


def extremes(
    time: Array, channels: Mapping[str, tuple[Array, str, str]]
) -> dict[str, dict[str, str | float]]:
    """Return the first value, minimum and maximum of every channel in its unit, with the times (s) of the extremes.

    ``channels`` has the form that :func:`recording` accepts.
    """
    table: dict[str, dict[str, str | float]] = {}
    for name, (values, unit, _) in channels.items():
        low, high = int(values.argmin()), int(values.argmax())
        table[name] = {
            "unit": unit,
            "static": float(values[0]),
            "minimum": float(values[low]),
            "time_of_minimum": float(time[low]),
            "maximum": float(values[high]),
            "time_of_maximum": float(time[high]),
        }
    return table


_OF_BALL_JOINTS = dict.fromkeys(("e0", "e1", "e2", "e3"), "1") | dict.fromkeys(
    ("wx", "wy", "wz"), "rad/s"
)


def quantity_of(name: str) -> str:
    """Return the known quantity of a channel, or an empty string.

    Examples
    --------
    >>> quantity_of("front_left.wheel.az"), quantity_of("suspension_deflection"), quantity_of("sprung.colour")
    ('az', 'deflection', '')
    """
    last = name.rpartition(".")[2]
    while last and last not in QUANTITIES:
        last = last.partition("_")[2]
    return last


def state_unit(name: str) -> str:
    """Return the SI unit of a channel, or of a joint's coordinate or speed, by its name.

    Parameters
    ----------
    name : str
        A channel, or ``<joint>.angle``, ``<joint>.distance rate``, ``<joint>.e0``, ``<joint>.wx`` and so on.

    Returns
    -------
    str
        SI unit; ``"SI"`` if the name does not determine it.

    Examples
    --------
    >>> [state_unit(name) for name in ("sprung.z", "rocker.angle rate", "lower_ball_joint.e0", "sprung.distance")]
    ['m', 'rad/s', '1', 'm']
    """
    whole, rate, _ = name.partition(" rate")
    if quantity_of(whole):
        return channel_unit(whole) + ("/s" if rate else "")
    return _OF_BALL_JOINTS.get(name.rpartition(".")[2], "SI")


def channel_unit(name: str) -> str:
    """Return the SI unit that a channel must have according to the last word of its name.

    Parameters
    ----------
    name : str
        ``<place>.<part>.<quantity>``, e.g. ``"sprung.az"``.

    Returns
    -------
    str
        SI unit; ``"1"`` for a dimensionless quantity.

    Raises
    ------
    RecordingError
        If the last word is not a known quantity.

    Examples
    --------
    >>> channel_unit("sprung.az"), channel_unit("tyre.force"), channel_unit("pitch_rate")
    ('m/s^2', 'N', 'rad/s')
    """
    quantity = quantity_of(name)
    if not quantity:
        last = name.rpartition(".")[2]
        raise RecordingError(
            "the last word of the channel's name is not a known quantity",
            where=name or "channel",
            found=last,
            allowed=", ".join(QUANTITIES),
            hint=nearest(last, QUANTITIES),
        )
    return QUANTITIES[quantity][0]


def describe(name: str) -> str:
    """Return a channel's label, e.g. ``"vertical acceleration, sprung"``."""
    quantity = quantity_of(name)
    words = QUANTITIES[quantity][1] if quantity else name.rpartition(".")[2].replace("_", " ")
    place = place_of(name).replace("_", " ").replace(".", " ")
    return f"{words}, {place}" if place else words


def recording_of(
    time: ArrayLike,
    channels: Mapping[str, tuple[ArrayLike, str, str]],
    attributes: Mapping[str, object] | None = None,
) -> xr.Dataset:
    """Create a recording from arrays; arguments as for :func:`jounce.recording`."""
    import xarray as xr

    instants = as_samples(time, "s", where="time")
    variables = {}
    for name, (values, unit, long_name) in channels.items():
        samples = as_samples(values, unit, where=name)
        if samples.shape != instants.shape:
            raise RecordingError(
                "the channel and time have different numbers of samples",
                where=name,
                found=f"shape {samples.shape}",
                allowed=Phrase("shape {shape}", shape=instants.shape),
            )
        attrs = _attributes(name, unit, long_name).copy()
        variables[name] = xr.Variable(("time",), samples, attrs, fastpath=True)
    clock = _time_axis if instants.flags.writeable else _lasting_time_axis
    return dataset(variables, clock(instants), attributes)


@lru_cache(4096)
def _attributes(name: str, unit: str, long_name: str) -> dict[str, str]:
    return {"units": unit, "long_name": long_name or describe(name), "place": place_of(name)}


def _time_axis(instants: Array) -> xr.Dataset:
    import xarray as xr

    return xr.Dataset(
        coords={"time": xr.Variable(("time",), instants, {"units": "s", "long_name": "time"})}
    )


_lasting_time_axis = once_per_object(_time_axis)
"""Cached time axis for read-only instants: all runs on them share one index."""


def is_spelling(unit: object, si: str) -> bool:
    """Whether a unit is the SI unit in a different spelling.

    >>> is_spelling("m/s**2", "m/s^2"), is_spelling("m s-2", "m/s^2"), is_spelling("mm/s^2", "m/s^2")
    (True, True, False)
    """
    try:
        return unit == si or (isinstance(unit, str) and conversion_factor(unit, si) == 1.0)
    except DescriptionError:
        return False


def check_recording(dataset: xr.Dataset, *, where: str = "recording") -> None:
    """Refuse a Dataset that is not a recording.

    Parameters
    ----------
    dataset : xarray.Dataset
        Any Dataset; it is not changed.
    where : str
        Location named in errors.

    Raises
    ------
    RecordingError
        If ``time`` in s is missing or not increasing; if a channel is on a different axis, has no unit or a unit other
        than the SI unit of its quantity, or has values that are not finite.

    Examples
    --------
    >>> check_recording(recording_of([0.0, 0.001], {"tyre.force": ([200.0, 201.0], "N", "")}))
    """
    check_units(dataset, where=where)
    time = np.asarray(dataset["time"].values)
    if not bool(np.all(np.diff(time) > 0.0)):
        raise RecordingError("time does not increase strictly", where=where)
    for name, variable in dataset.data_vars.items():
        finite = np.isfinite(variable.values)
        if not finite.all():
            sample = int(np.argmin(finite))
            value = float(variable.values[sample])
            raise RecordingError(
                Phrase("sample {sample} is not a finite number", sample=sample + 1),
                where=f"{where}: {name}",
                found=value,
            )


def check_units(dataset: xr.Dataset, *, where: str = "recording") -> None:
    """Refuse a Dataset with channels that are not real numbers over ``time`` (s) in the SI unit of their quantity."""
    if "time" not in dataset.coords or dataset["time"].dims != ("time",):
        raise RecordingError("no time coordinate", where=where, allowed="a coordinate 'time' in s")
    unit = dataset["time"].attrs.get("units")
    if not is_spelling(unit, "s"):
        what = "time has no unit" if unit is None else "time has the wrong unit"
        raise RecordingError(what, where=where, found=unit, allowed="an attribute 'units' of 's'")
    for name, variable in dataset.data_vars.items():
        _check_channel(str(name), variable, where)


def _check_channel(name: str, variable: xr.DataArray, where: str) -> None:
    at = f"{where}: {name}"
    if variable.dims != ("time",):
        raise RecordingError(
            "the channel is not a signal over time", where=at, found=f"dimensions {variable.dims}"
        )
    unit = variable.attrs.get("units")
    if unit is None:
        hint = "Arithmetic with older xarray drops it: xarray.set_options(keep_attrs=True), or assign_attrs(units=...)."
        raise RecordingError(
            "the channel has no unit", where=at, allowed="an attribute 'units'", hint=hint
        )
    quantity = quantity_of(name)
    if quantity not in ("", "command") and not is_spelling(
        unit, channel_unit(name)
    ):  # a command has the unit of its actuator
        raise RecordingError(
            "the channel has a different unit", where=at, found=unit, allowed=channel_unit(name)
        )
    if variable.dtype.kind not in "fiu":
        raise RecordingError(
            "the samples are not real numbers", where=at, found=str(variable.dtype)
        )
