"""Whatever Python users hand over as a number counts as the plain float, or is one clear refusal."""

from __future__ import annotations

import datetime
import decimal
import fractions
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
import pytest
import xarray as xr
from outcomes import outcome

import jounce as jn
from jounce.core.units import _registry, conversion_factor
from jounce.recordings import (
    Sensor,
    cfc_filter,
    derivative,
    filter_signals,
    resample,
    shift_signals,
)
from jounce.ride.comfort import running_rms, vdv
from jounce.ride.surface import surface
from jounce.ride.weighting import weight
from jounce.simulation.settings import RunSettings

pd = pytest.importorskip("pandas")
T = np.arange(512) / 250.0
SWING = 0.02 * np.exp(-1.5 * T) * np.cos(25.0 * T)
X = np.arange(512) * 0.25
ROUGH = 0.003 * np.sin(1.3 * X) + 0.002 * np.sin(0.41 * X + 1.0)
RIG = jn.load("kart-quarter-car")
STRUT = jn.ForceDeflectionTrial(0.01 * T, 1e3 * T + 5.0 * T**2)

CALLS: dict[str, tuple[Callable[[Any], Any], float, str]] = {
    "with_changes": (lambda v: RIG.with_changes({"strut.spring.rate": v}), 25000.0, "N/m"),
    "RunSettings": (lambda v: RunSettings(output_step=v), 0.002, "s"),
    "Trial, speed": (lambda v: jn.Trial(road=jn.Flat(), speed=v, duration=1.0), 7.0, "m/s"),
    "Trial, duration": (lambda v: jn.Trial(road=jn.Flat(), speed=1.0, duration=v), 7.0, "s"),
    "HalfSine": (lambda v: jn.HalfSine(height=v, length=1.0), 0.01, "m"),
    "Iso8608, roughness": (lambda v: jn.Iso8608(roughness=v, length=100.0), 64e-6, ""),
    "Sensor": (lambda v: Sensor(low_pass=v), 30.0, "Hz"),
    "segments": (lambda v: vars(jn.HalfSine(height=0.01, length=1.0).segments(v)), 5.0, "m"),
    "fit_decay, mass": (lambda v: jn.fit_decay(T, SWING, mass=v), 16.0, "kg"),
    "fit_decay, stiffness": (lambda v: jn.fit_decay(T, SWING, mass=16.0, stiffness=v), 1e4, "N/m"),
    "fit_decay, begin": (lambda v: jn.fit_decay(T, SWING, mass=16.0, begin=v), 0.1, "s"),
    "fit_stiffness, discard": (lambda v: jn.fit_stiffness([STRUT], discard_below=v), 0.002, "m"),
    "fit_stiffness, force": (lambda v: jn.fit_stiffness([STRUT], operating_force=v), 300.0, "N"),
    "iri, segment": (lambda v: jn.iri(X, ROUGH, segment=v), 50.0, "m"),
    "iri, run_up": (lambda v: jn.iri(X, ROUGH, run_up=v), 10.0, "m"),
    "estimate_roughness, waviness": (
        lambda v: vars(jn.estimate_roughness(X, ROUGH, waviness=v)),
        2.0,
        "1",
    ),
    "estimate_roughness, band": (
        lambda v: vars(jn.estimate_roughness(X, ROUGH, band=(v, 2.0))),
        0.02,
        "1/m",
    ),
    "road_psd, road": (lambda v: jn.road_psd(v, X + 1.0), 64e-6, ""),
    "road_psd, waviness": (lambda v: jn.road_psd("A", X + 1.0, waviness=v), 2.1, "1"),
    "white_noise_intensity": (lambda v: jn.white_noise_intensity("A", v), 20.0, "m/s"),
    "power_spectrum, rate": (lambda v: vars(jn.power_spectrum(SWING, v)), 250.0, "Hz"),
    "power_spectrum, segment": (
        lambda v: vars(jn.power_spectrum(SWING, 250.0, segment=v)),
        0.5,
        "s",
    ),
    "transfer_function, rate": (lambda v: vars(jn.transfer_function(SWING, T, v)), 250.0, "Hz"),
    "weighted": (lambda v: weight(SWING, v, "Wk"), 250.0, "Hz"),
    "running_rms": (lambda v: running_rms(SWING, v), 250.0, "Hz"),
    "vdv": (lambda v: vdv(SWING, v), 250.0, "Hz"),
    "cfc_filter": (lambda v: cfc_filter(SWING, v, 60.0), 4000.0, "Hz"),
    "derivative": (lambda v: derivative(SWING, v), 250.0, "Hz"),
    "resample": (lambda v: resample(T, SWING, v), 100.0, "Hz"),
    "shift_signals, rate": (lambda v: shift_signals(SWING, v, 0.01), 250.0, "Hz"),
    "shift_signals, lag": (lambda v: shift_signals(SWING, 250.0, v), 0.01, "s"),
    "filter_signals": (lambda v: filter_signals(SWING, v, Sensor(low_pass=30.0)), 250.0, "Hz"),
    "spring_and_damper, mass": (lambda v: jn.spring_and_damper(v, 1.4, 0.3), 300.0, "kg"),
    "spring_and_damper, frequency": (lambda v: jn.spring_and_damper(300.0, v, 0.3), 1.4, "Hz"),
    "spring_and_damper, ratio": (lambda v: jn.spring_and_damper(300.0, 1.4, v), 0.3, "1"),
    "spring_and_damper, motion ratio": (
        lambda v: jn.spring_and_damper(300.0, 1.4, 0.3, motion_ratio=v),
        0.7,
        "1",
    ),
    "spring_and_damper, gravity": (
        lambda v: jn.spring_and_damper(300.0, 1.4, 0.3, gravity=v),
        9.8,
        "m/s^2",
    ),
    "swept_sine": (lambda v: jn.swept_sine(v, 1.0, 20.0, 2.0), 0.01, "m"),
    "iso_trial": (lambda v: jn.iso_trial(RIG, "A", v, duration=5.0), 20.0, "m/s"),
    "iso_trial, step": (lambda v: jn.iso_trial(RIG, "A", 20.0, duration=5.0, step=v), 0.05, "m"),
    "with_strut_angle": (lambda v: jn.with_strut_angle(RIG, v), 0.2, "rad"),
    "bouc_wen_path": (lambda v: jn.bouc_wen_path(SWING, v, 1.0, 1.5, 0.0), 1e3, "1/m"),
    "cylinder": (
        lambda v: vars(jn.mechanics.cylinder(v, 0.02, (0, 0, 0), (0, 0, 1.0))),
        7800.0,
        "",
    ),
    "harmonic": (lambda v: vars(jn.mechanics.harmonic(v, 2.0)), 0.01, "m"),
    "step": (lambda v: vars(jn.mechanics.step(0.0, v, begin=1.0, stop=2.0)), 0.01, "rad"),
    "step, begin": (lambda v: vars(jn.mechanics.step(0.0, 0.1, begin=v, stop=2.0)), 0.5, "s"),
    "constant_rate": (lambda v: vars(jn.mechanics.constant_rate(v)), 0.5, "m/s"),
    "surface, cut_off": (lambda v: surface("A", 20.0, cut_off=v), 0.01, "1/m"),
    "surface, waviness": (lambda v: surface("A", 20.0, band="iso", waviness=v), 2.1, "1"),
    "surface, band": (lambda v: surface("A", 20.0, band=(v, 2.0)), 0.02, "1/m"),
    "sobol": (
        lambda v: jn.sobol({"a": [v, 3.0]}, 4).values(lambda _: (2.0, "kg")),
        1.0,
        "kg",
    ),
    "sobol, sd": (lambda v: jn.sobol({"a": {"sd": v}}, 4).values(lambda _: (2.0, "kg")), 1.0, "kg"),
    "grid": (lambda v: jn.grid({"a": [v, 3.0]}).values(lambda _: (2.0, "kg")), 1.0, "kg"),
}


class Foreign:
    """Stands for a scalar of JAX: an array without dimensions, and a float where one is asked for."""

    ndim, shape = 0, ()

    def __init__(self, value: float) -> None:
        self.value = value

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.array(self.value, dtype=dtype)

    def __float__(self) -> float:
        return float(self.value)


TAKEN: dict[str, Callable[[float], Any]] = {
    "float64": np.float64,
    "longdouble": np.longdouble,
    "without dimensions": np.array,
    "DataArray": xr.DataArray,
    "Variable": lambda v: xr.Variable((), v),
    "Decimal": decimal.Decimal,
    "Fraction": fractions.Fraction,
    "of another library": Foreign,
    "complex without imaginary part": np.complex128,
    "masked without a mask": np.ma.array,
}
REFUSED: dict[str, Callable[[float], Any]] = {
    "masked": lambda _: np.ma.masked,
    "complex": lambda v: complex(v, v),
    "list": lambda v: [v],
    "array of one": lambda v: np.array([v]),
    "bytes": lambda v: str(v).encode(),
    "True": lambda _: True,
    "NumPy's True": lambda _: np.bool_(True),
    "NaT": lambda _: np.timedelta64("NaT"),
    "day": lambda _: datetime.date(2026, 3, 29),
    "instant": lambda _: np.datetime64("2026-03-29"),
    "object": lambda _: object(),
    "of another unit": lambda v: _registry().Quantity(v, "K"),
    "of an unknown unit": lambda v: xr.DataArray(v, attrs={"units": "furlong-ish"}),
}
WITH_UNITS: dict[str, Callable[[float, str], Any]] = {
    "quantity": lambda v, unit: _registry().Quantity(v, unit),
    "DataArray with units": lambda v, unit: xr.DataArray(v, attrs={"units": unit}),
}
OTHER = {
    "m": "mm", "s": "ms", "N": "kN", "m/s": "mm/s", "Hz": "kHz", "kg": "g", "1/m": "1/mm", "m/s^2": "mm/s^2",
    "N/m": "N/mm", "1": "%", "rad": "mrad",
}  # fmt: skip
DURATIONS: dict[str, Any] = {
    "timedelta": datetime.timedelta(seconds=0.5),
    "timedelta64": np.timedelta64(500, "ms"),
    "Timedelta": pd.Timedelta("0.5 s"),
}


def cases_of(name: str) -> Iterator[tuple[str, Any, float | None]]:
    """Kind of number, that number, and the plain one in SI it must count as (None: refused)."""
    _, value, si = CALLS[name]
    yield from ((kind, make(value), value) for kind, make in TAKEN.items())
    yield from ((kind, make(value), None) for kind, make in REFUSED.items())
    yield from ((kind, made, 0.5 if si == "s" else None) for kind, made in DURATIONS.items())
    if si in OTHER:
        unit, factor = OTHER[si], conversion_factor(OTHER[si], si)
        yield from (
            (kind, make(value / factor, unit), value / factor * factor)
            for kind, make in WITH_UNITS.items()
        )


@pytest.mark.parametrize("name", CALLS)
def test_numbers_count_as_plain_floats_or_are_refused(name: str) -> None:
    call, *_ = CALLS[name]
    wrong = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # NumPy says that it drops imaginary parts
        for kind, given, plain in cases_of(name):
            expected = "refused" if plain is None else outcome(partial(call, plain), {})
            wrong += [kind] * (outcome(partial(call, given), {}) != expected)
    assert wrong == []


def test_a_table_of_ours_gives_numbers_for_a_rig() -> None:
    """What a variant's number is, with its unit, is an array without dimensions."""
    many = xr.Dataset(coords={"strut.spring.rate": ("variant", [25e3, 26e3], {"units": "N/m"})})
    assert (
        RIG.with_changes({"strut.spring.rate": many["strut.spring.rate"][0]}).strut.spring.rate
        == 25e3
    )
