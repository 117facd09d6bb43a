"""Spectra of runs and recordings side by side, each at its own rate, as curves over frequency."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import JounceError

if TYPE_CHECKING:
    import xarray as xr

_HIGHEST = 60.0  # Hz: of what a car does, all is below


def spectra_of(runs: Mapping[str, xr.Dataset]) -> dict[str, xr.Dataset]:
    """Give the root of each channel's power spectral density, unit/sqrt(Hz), of one piece as long as the run."""
    return {label: _spectra(run) for label, run in runs.items()}


def _spectra(run: xr.Dataset) -> xr.Dataset:
    import xarray as xr

    from jounce.ride.spectra import power_spectrum

    time = run["time"].to_numpy()
    even = np.linspace(time[0], time[-1], len(time))
    duration = float(time[-1] - time[0])
    rate = (len(time) - 1) / duration
    found, frequency = {}, np.zeros(0)
    for name in run.data_vars:
        values = run.variables[name]
        if values.dims != ("time",) or values.dtype.kind != "f":
            continue
        signal = np.interp(even, time, values.to_numpy())
        try:
            spectrum = power_spectrum(signal, rate, segment=0.999 * duration)
        except JounceError:  # a channel with gaps has none
            continue
        kept = spectrum.frequency <= _HIGHEST
        frequency = spectrum.frequency[kept]
        unit = str(values.attrs.get("units", "1"))
        words = f"{values.attrs.get('long_name', name)}, root of the power spectral density"
        label = "1/sqrt(Hz)" if unit == "1" else f"{unit}/sqrt(Hz)"
        found[str(name)] = ("frequency", np.sqrt(spectrum.density[kept]), {"units": label, "long_name": words})
    axis = ("frequency", frequency, {"units": "Hz", "long_name": "frequency"})
    return xr.Dataset(found, coords={"frequency": axis})
