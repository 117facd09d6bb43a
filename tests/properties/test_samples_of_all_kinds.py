"""Whatever Python users hand over as samples gives the numbers of plain floats, or one clear refusal."""

from __future__ import annotations

import datetime
import decimal
import fractions
import warnings
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

import numpy as np
import pytest
import xarray as xr
from outcomes import outcome

import jounce as jn
from jounce.core.units import _registry, conversion_factor
from jounce.identify.comparison import compare, iso18571
from jounce.identify.hysteresis_path import bouc_wen_path
from jounce.identify.stiffness import FittedCurve, fit_stiffness
from jounce.kinematics.sweeps import path_values
from jounce.recordings import (
    Sensor,
    cfc_filter,
    derivative,
    estimate_lag,
    filter_signals,
    resample,
    shift_signals,
    shift_with_derivative,
)
from jounce.ride.comfort import advice, crest_factor, evdv, msdv, mtvv, rms, running_rms, vdv
from jounce.ride.weighting import weight, weighting_response
from jounce.variants.many import _column

pd = pytest.importorskip("pandas")
Signals = Mapping[str, tuple[np.ndarray, str]]

# what takes samples --------------------------------------------------------------------------------------------------

RATE = 250.0
T = np.arange(512) / RATE
MOVED = 0.02 * np.sin(6.0 * T + 0.1)
RATED = 0.12 * np.cos(6.0 * T + 0.1)
SWING = 0.02 * np.exp(-1.5 * T) * np.cos(25.0 * T)
PUSHED = np.linspace(0.0, 0.01, 512)
X = np.arange(512) * 0.25
ROUGH = 0.003 * np.sin(1.3 * X) + 0.002 * np.sin(0.41 * X + 1.0)
SHAKEN = np.sin(40.0 * T) + 0.3 * np.sin(90.0 * T)
LATE = np.sin(40.0 * (T - 0.02)) + 0.3 * np.sin(90.0 * (T - 0.02))
DAMPED = jn.fit_damper(MOVED, RATED, 300.0 * RATED, T)
STIFF = FittedCurve("polynomial", (1e5, 2e6))

CALLS: dict[str, tuple[Callable[..., Any], Signals]] = {
    "recording": (
        lambda time, az: jn.recording(time, {"sprung.az": (az, "m/s^2", "")}).to_array().to_dict(),
        {"time": (T, "s"), "az": (SHAKEN, "m/s^2")},
    ),
    "fit_damper": (
        jn.fit_damper,
        {
            "displacement": (MOVED, "m"),
            "velocity": (RATED, "m/s"),
            "force": (300.0 * RATED, "N"),
            "time": (T, "s"),
        },
    ),
    "damper_curve": (
        lambda **signals: vars(jn.damper_curve(DAMPED, **signals)),
        {
            "displacement": (MOVED, "m"),
            "velocity": (RATED, "m/s"),
            "force": (300.0 * RATED, "N"),
            "time": (T, "s"),
        },
    ),
    "fit_decay": (
        lambda time, displacement: jn.fit_decay(time, displacement, mass=10.0),
        {"time": (T, "s"), "displacement": (SWING, "m")},
    ),
    "fit_stiffness": (
        lambda deflection, force: fit_stiffness([jn.ForceDeflectionTrial(deflection, force)]),
        {"deflection": (PUSHED, "m"), "force": (1e5 * PUSHED, "N")},
    ),
    "FittedCurve": (STIFF, {"deflection": (PUSHED, "m")}),
    "iri": (jn.iri, {"distance": (X, "m"), "height": (ROUGH, "m")}),
    "estimate_roughness": (
        lambda **s: vars(jn.estimate_roughness(**s)),
        {"x": (X, "m"), "height": (ROUGH, "m")},
    ),
    "road_psd": (lambda n: jn.road_psd("B", n), {"n": (1.0 + X, "1/m")}),
    "height_at": (jn.HalfSine(height="10 mm", length="60 m").height_at, {"x": (X, "m")}),
    "slope_at": (jn.HalfSine(height="10 mm", length="60 m").slope_at, {"x": (X, "m")}),
    "power_spectrum": (
        lambda values: vars(jn.power_spectrum(values, RATE)),
        {"values": (SHAKEN, "")},
    ),
    "transfer_function": (
        lambda **signals: vars(jn.transfer_function(**signals, sample_rate=RATE)),
        {"given": (SHAKEN, ""), "answer": (LATE, "")},
    ),
    "weighted": (lambda values: weight(values, RATE, "Wk"), {"values": (SHAKEN, "")}),
    "weighting_response": (
        lambda frequency: weighting_response("Wk", frequency),
        {"frequency": (1.0 + X, "Hz")},
    ),
    **{
        one.__name__: (lambda values, one=one: one(values, RATE), {"values": (SHAKEN, "")})
        for one in (rms, running_rms, mtvv, vdv, evdv, msdv, crest_factor, derivative)
    },
    "advice": (lambda values: advice(values, RATE, place="seat"), {"values": (SHAKEN, "")}),
    "cfc_filter": (lambda values: cfc_filter(values, RATE * 16, 60.0), {"values": (SHAKEN, "")}),
    "resample": (
        lambda **signals: resample(**signals, sample_rate=100.0),
        {"time": (T, "s"), "values": (SHAKEN, "")},
    ),
    "shift_signals": (lambda values: shift_signals(values, RATE, 0.01), {"values": (SHAKEN, "")}),
    "shift_with_derivative": (
        lambda values: shift_with_derivative(values, RATE, 0.01),
        {"values": (SHAKEN, "")},
    ),
    "estimate_lag": (
        lambda **signals: estimate_lag(**signals, sample_rate=RATE),
        {"reference": (SHAKEN, ""), "compared": (LATE, "")},
    ),
    "filter_signals": (
        lambda values: filter_signals(values, RATE, Sensor(low_pass="40 Hz")),
        {"values": (SHAKEN, "")},
    ),
    "compare": (compare, {"reference": (SHAKEN, ""), "compared": (LATE, ""), "time": (T, "s")}),
    "iso18571": (
        lambda **signals: iso18571(**signals, sample_rate=RATE),
        {"reference": (SHAKEN, ""), "compared": (LATE, "")},
    ),
    "bouc_wen_path": (
        lambda displacement: bouc_wen_path(displacement, 1e3, 1.0, 1.5, 0.0),
        {"displacement": (MOVED, "m")},
    ),
    "interpolated": (
        lambda **signals: vars(jn.mechanics.interpolated(**signals)),
        {"time": (T, "s"), "value": (MOVED, "m")},
    ),
    "Table": (
        lambda **signals: jn.Table(**signals).model_dump(),
        {"x": (X, "m"), "height": (ROUGH, "m")},
    ),
    "sweep": (
        lambda values: jn.grid({"sprung.mass": values}).values(lambda _: (1.0, "kg")),
        {"values": (1.0 + X, "kg")},
    ),
    "simulate_many": (
        lambda values: _column(values, "kg", "sprung.mass"),
        {"values": (1.0 + X, "kg")},
    ),
    "sweep_travel": (
        lambda values: path_values(values, "wheel travel"),
        {"values": (1e-4 * X, "m")},
    ),
}


# kinds of arrays -----------------------------------------------------------------------------------------------------


class Foreign:
    """Stands for the arrays of JAX, Polars and Torch: all that NumPy sees of them."""

    def __init__(self, values: Any) -> None:
        self.values = values

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.array(self.values, dtype=dtype)

    def __len__(self) -> int:
        return len(self.values)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.values)


class Unwilling:
    """Stands for a tensor on a graphics card, or one with a gradient."""

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        raise RuntimeError("call detach first")


def _marked(values: np.ndarray) -> np.ndarray:
    return np.arange(values.size) == 7


def _ticks(values: np.ndarray) -> np.ndarray:
    return np.round(values * 1e9).astype("m8[ns]")


def _rows(values: np.ndarray) -> np.ndarray:
    rows = np.zeros(values.size, [("a", float), ("b", float)])
    rows["a"] = values
    return rows


AS_PLAIN: dict[str, Callable[[np.ndarray], Any]] = {
    "list": lambda v: v.tolist(),
    "tuple of NumPy's numbers": tuple,
    "integers": lambda v: np.arange(v.size),
    "counts of 8 bits": lambda v: (np.arange(v.size) % 256).astype(np.uint8),
    "float32": lambda v: v.astype(np.float32),
    "float16": lambda v: v.astype(np.float16),
    "longdouble": lambda v: v.astype(np.longdouble),
    "the other order of bytes": lambda v: v.astype(v.dtype.newbyteorder()),
    "read only": lambda v: np.frombuffer(v.tobytes()),
    "every second": lambda v: np.repeat(v, 2)[::2],
    "backwards": lambda v: v[::-1].copy()[::-1],
    "column of Fortran's": lambda v: np.asfortranarray(np.column_stack([v, v]))[:, 1],
    "Decimals": lambda v: [decimal.Decimal(x) for x in v.tolist()],
    "Fractions as objects": lambda v: np.array([fractions.Fraction(x) for x in v.tolist()]),
    "mixed numbers": lambda v: [decimal.Decimal(v[0]), *v[1:].tolist()],
    "complex without imaginary parts": lambda v: v + 0j,
    "masked without a mask": np.ma.array,
    "nothing masked": lambda v: np.ma.array(v, mask=False),
    "Series": lambda v: pd.Series(v, index=range(len(v), 0, -1)),
    "Series of objects": lambda v: pd.Series(v, dtype=object),
    "Index": pd.Index,
    "Float64 of pandas": lambda v: pd.Series(v, dtype="Float64"),
    "sparse": pd.arrays.SparseArray,
    "DataArray": lambda v: xr.DataArray(v, dims="time"),
    "Variable": lambda v: xr.Variable("time", v),
    "of another library": Foreign,
    "DataArray of masked": lambda v: xr.DataArray(np.ma.array(v, mask=_marked(v)), dims="time"),
    "Float64 with a gap": lambda v: pd.Series(v, dtype="Float64").mask(_marked(v)),
    "matrix": np.asmatrix,
    "frame": lambda v: pd.DataFrame({"a": v, "b": v}),
    "empty": lambda _: [],
}
HELD: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "integers": lambda v: np.arange(v.size),
    "counts of 8 bits": lambda v: np.arange(v.size) % 256,
    "float32": lambda v: v.astype(np.float32),
    "float16": lambda v: v.astype(np.float16),
    "DataArray of masked": lambda v: np.where(_marked(v), np.nan, v),  # xarray makes it NaN
    "Float64 with a gap": lambda v: np.where(_marked(v), np.nan, v),
    "matrix": lambda v: v[None, :],
    "frame": lambda v: np.column_stack([v, v]),
    "empty": lambda v: v[:0],
    "milliseconds": lambda v: np.round(v * 1e3) / 1e3,
    "timedeltas": lambda v: np.round(v * 1e6) / 1e6,
}
"""What of the values is there in arrays of these kinds."""
REFUSED: dict[str, Callable[[np.ndarray], Any]] = {
    "masked": lambda v: np.ma.array(v, mask=_marked(v)),
    "list with a masked one": lambda v: [*v[:-1].tolist(), np.ma.masked],
    "None in a list": lambda v: [*v[:-1].tolist(), None],
    "complex": lambda v: v + 1j * v,
    "complex in a list": lambda v: [complex(x, x) for x in v.tolist()],
    "texts": lambda v: [str(x) for x in v.tolist()],
    "array of texts": lambda v: v.astype(str),
    "Series of texts": lambda v: pd.Series(v.astype(str)),
    "bytes": lambda v: v.astype("S"),
    "one text": lambda _: "0 1 2 3",
    "rows of a record": _rows,
    "ragged": lambda _: [[1.0, 2.0], [3.0]],
    "mapping": lambda v: dict(enumerate(v.tolist())),
    "None": lambda _: None,
    "unwilling": lambda _: Unwilling(),
    "gone": lambda v: pd.Series([*_ticks(v)[:-1], pd.NaT]),
    "periods": lambda v: pd.period_range("2026-01-01", periods=v.size, freq="s"),
    "durations without a unit": lambda v: np.arange(v.size).astype("m8"),
    "months": lambda v: np.arange(v.size).astype("m8[M]"),
    "unknown unit": lambda v: xr.DataArray(v, dims="time", attrs={"units": "furlong-ish"}),
    "another quantity": lambda v: _registry().Quantity(v, "K"),
    "quantities masked": lambda v: _registry().Quantity(np.ma.array(v, mask=_marked(v)), "mm"),
}
TIMES: dict[str, Callable[[np.ndarray], Any]] = {
    "timedelta64": _ticks,
    "milliseconds": lambda v: np.round(v * 1e3).astype("m8[ms]"),
    "Series of Timedelta": lambda v: pd.Series(_ticks(v)),
    "TimedeltaIndex": lambda v: pd.to_timedelta(_ticks(v)),
    "DataArray of timedelta": lambda v: xr.DataArray(_ticks(v), dims="time"),
    "list of timedelta64": lambda v: list(_ticks(v)),
    "timedeltas": lambda v: [datetime.timedelta(microseconds=round(x * 1e6)) for x in v.tolist()],
    "Timedelta as objects": lambda v: np.array([pd.Timedelta(x) for x in _ticks(v)], dtype=object),
    "Duration of another library": lambda v: Foreign(_ticks(v)),
    "datetime64": lambda v: np.datetime64("2026-03-29T00:59:59", "ns") + _ticks(v),
    "DatetimeIndex": lambda v: pd.Timestamp("2026-03-29T00:59:59") + pd.to_timedelta(_ticks(v)),
    "with a zone": lambda v: pd.Series(
        pd.Timestamp("2026-03-29T00:59:59", tz="UTC") + pd.to_timedelta(_ticks(v))
    ),
    "datetimes": lambda v: [
        datetime.datetime.fromisoformat("2026-03-29")
        + datetime.timedelta(microseconds=round(x * 1e6))
        for x in v.tolist()
    ],
}
OTHER = {
    "m": "mm",
    "s": "ms",
    "N": "kN",
    "m/s": "mm/s",
    "Hz": "kHz",
    "kg": "g",
    "1/m": "1/mm",
    "m/s^2": "mm/s^2",
}
WITH_UNITS: dict[str, Callable[[np.ndarray, str], Any]] = {
    "quantity of Pint": lambda v, unit: _registry().Quantity(v, unit),
    "list of quantities": lambda v, unit: [_registry().Quantity(x, unit) for x in v.tolist()],
    "DataArray with units": lambda v, unit: xr.DataArray(v, dims="time", attrs={"units": unit}),
    "DataArray with units in bytes": lambda v, unit: xr.DataArray(
        v, dims="time", attrs={"units": unit.encode()}
    ),
    "DataArray of a quantity": lambda v, unit: xr.DataArray(
        _registry().Quantity(v, unit), dims="time"
    ),
}


# what comes out ------------------------------------------------------------------------------------------------------


def _cases() -> Iterator[tuple[str, str, str, Callable[[], Any], np.ndarray | None]]:
    """Function, argument, kind of array, that array, the plain values in SI it must count as (None: refused)."""
    for name, (_, signals) in CALLS.items():
        for argument, (values, si) in signals.items():
            for kind, make in AS_PLAIN.items():
                yield (
                    name,
                    argument,
                    kind,
                    partial(make, values),
                    HELD.get(kind, np.array)(values).astype(float),
                )
            for kind, make in REFUSED.items():
                if not (kind == "None" and argument == "velocity") and not (
                    kind in ANY_UNIT and not si
                ):
                    yield name, argument, kind, partial(make, values), None
            for kind, make in TIMES.items() if si else ():
                held = HELD.get(kind, np.array)(values).astype(float) if si == "s" else None
                yield name, argument, kind, partial(make, values), held
            for kind, make_in in WITH_UNITS.items() if si else ():
                factor = conversion_factor(OTHER[si], si)
                yield (
                    name,
                    argument,
                    kind,
                    partial(make_in, values / factor, OTHER[si]),
                    values / factor * factor,
                )


ANY_UNIT = ("unknown unit", "another quantity")
CASES = list(_cases())


@pytest.mark.some(4)
@pytest.mark.parametrize(("name", "argument"), dict.fromkeys(case[:2] for case in CASES))
def test_samples_count_as_plain_floats_or_are_refused(name: str, argument: str) -> None:
    call, signals = CALLS[name]
    others = {key: values for key, (values, _) in signals.items() if key != argument}
    wrong = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of NaN, and of kinds that go out of use
        for kind, make, plain in [case[2:] for case in CASES if case[:2] == (name, argument)]:
            expected = "refused" if plain is None else outcome(call, {**others, argument: plain})
            wrong += [kind] * (outcome(call, {**others, argument: make()}) != expected)
    assert wrong == []
