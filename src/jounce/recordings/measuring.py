"""Simulation of sensor records from a simulated motion."""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import unknown
from jounce.core.seeds import check_seed
from jounce.recordings.carried import as_recording
from jounce.recordings.conditioning import cut_to_range
from jounce.recordings.quality import check_even
from jounce.recordings.sensors import Sensor, bias_of, filter_signals, noise_of

if TYPE_CHECKING:
    import xarray as xr


def apply_sensors(
    dataset: xr.Dataset, sensors: Mapping[str, Sensor], *, seed: int | None = None
) -> xr.Dataset:
    """Simulate the records of sensors from a simulated motion.

    Parameters
    ----------
    dataset : xarray.Dataset
        A recording on uniform time (s), at rest at its first sample, which is the zero of sensors with datum "rest".
    sensors : mapping of str to Sensor
        Sensor of each channel that has one; other channels are not changed.
    seed : int, optional
        Seed of the noise; no noise without it. The noise of a channel depends only on the seed and its name.

    Returns
    -------
    xarray.Dataset
        A new recording; ``dataset`` is not changed.

    Raises
    ------
    DescriptionError
        If a sensor's channel is not in the recording, or a bias or noise has a unit of a different dimension.
    RecordingError
        If a corner frequency is not below half the sample rate, or steps of time differ by more than 1 %.

    Examples
    --------
    >>> from jounce.recordings import Sensor, recording
    >>> run = recording([0.0, 0.001, 0.002], {"sprung.az": ([0.0, 1.0, 2.0], "m/s^2", "")})
    >>> apply_sensors(run, {"sprung.az": Sensor(bias="1 g", orientation=-1)})["sprung.az"].values.round(9).tolist()
    [9.80665, 8.80665, 7.80665]
    """
    if seed is not None:
        check_seed(seed)
    dataset = as_recording(dataset)
    names = [str(name) for name in dataset.data_vars]
    time = check_even(dataset["time"].to_numpy(), where="recording")
    rate = (time.size - 1) / float(time[-1] - time[0]) if time.size > 1 else 1.0
    changed = {}
    for name, sensor in sensors.items():
        if name not in names:
            raise unknown(name, names, what="channel", where="sensors")
        variable = dataset[name].variable
        zero = variable.values[0] if sensor.datum == "rest" else 0.0
        values = filter_signals(variable.values - zero, rate, sensor, where=f"sensor of {name}")
        values = values + bias_of(sensor, variable.attrs["units"], where=f"sensor of {name}: bias")
        deviation = noise_of(sensor, variable.attrs["units"], where=f"sensor of {name}: noise")
        if seed is not None and deviation > 0.0:
            generator = np.random.default_rng([seed, zlib.crc32(name.encode())])
            values = values + deviation * generator.standard_normal(values.shape)
        values = cut_to_range(name, sensor, values)
        changed[name] = (variable.dims, values, dict(variable.attrs))
    return dataset.assign(changed)
