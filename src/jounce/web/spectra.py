"""Spectra of several runs and recordings, each at its own sampling rate, as curves over frequency."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.errors import JounceError

if TYPE_CHECKING:
    import xarray as xr

_HIGHEST = 60.0  # Hz: vehicle motion is below this frequency


def spectra_of(
    runs: Mapping[str, xr.Dataset], *, shortest: float | None = None
) -> dict[str, xr.Dataset]:
    """Return the square root of each channel's power spectral density, unit/√Hz in display units.

    By default one segment covers the whole run. With ``shortest`` (s), segments are an eighth of the run, but at
    least ``shortest`` and at most half of the run.
    """
    return {label: _spectra(run, shortest) for label, run in runs.items()}


def _spectra(run: xr.Dataset, shortest: float | None) -> xr.Dataset:
    import xarray as xr

    from jounce.ride.spectra import power_spectrum

    time = run["time"].to_numpy()
    even = np.linspace(time[0], time[-1], len(time))
    duration = float(time[-1] - time[0])
    rate = (len(time) - 1) / duration
    segment = (
        0.999 * duration if shortest is None else min(max(duration / 8.0, shortest), duration / 2.0)
    )
    spectra, frequency = {}, np.zeros(0)
    for name in run.data_vars:
        values = run.variables[name]
        if values.dims != ("time",) or values.dtype.kind != "f":
            continue
        signal = np.interp(even, time, values.to_numpy())
        try:
            spectrum = power_spectrum(signal, rate, segment=segment)
        except JounceError:  # a channel with gaps has no spectrum
            continue
        inside = spectrum.frequency <= _HIGHEST
        frequency = spectrum.frequency[inside]
        unit = display_unit(str(values.attrs.get("units", "1")))
        words = f"{values.attrs.get('long_name', name)}, root of the power spectral density"
        label = f"{unit.name or 1}/√Hz"
        spectra[str(name)] = (
            "frequency",
            unit.factor * np.sqrt(spectrum.density[inside]),
            {"units": label, "long_name": words},
        )
    axis = ("frequency", frequency, {"units": "Hz", "long_name": "frequency"})
    return xr.Dataset(spectra, coords={"frequency": axis})
