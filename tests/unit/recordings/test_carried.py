"""Data that carry their own time and units go in as they are: recordings, channels, tables, trials within others."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import jounce as jn

T = np.arange(0.0, 2.0, 1e-3)
X = 0.02 * np.exp(-3.0 * T) * np.cos(30.0 * T)
DECAY = jn.recording(T, {"body.z": (X, "m", ""), "body.force": (X, "N", "")})
RIG = jn.load("kart-quarter-car")
TRIAL = jn.Trial(road=jn.HalfSine(height="20 mm", length="0.3 m"), speed="3 m/s", duration="1 s")
RUN = jn.simulate(RIG, TRIAL)
TABLE = jn.to_pandas(RUN)
STRUT = [RUN[f"strut.{word}"] for word in ("deflection", "velocity", "force")]
CAR = jn.load("audi-a6-half-car-4dof")
RIDE = jn.iso_trial(CAR, "C", "20 m/s", duration="3 s")
FREE = {"strut.spring.rate": "10 %"}
VARIED = {"sprung.mass": [15.0, 16.0], "strut.spring.rate": [2e4, 21e3]}
VARIED_TABLE = pd.DataFrame(
    {"sprung.mass [kg]": [15.0, 16.0], "strut.spring.rate [N/mm]": [20.0, 21.0]}
)


def in_ms(run: Any) -> pd.DataFrame:
    """The same as a table in other units, with the time as a column."""
    table = jn.to_pandas(run).reset_index()
    table["time [s]"] *= 1e3
    return table.rename(columns={"time [s]": "time [ms]"})


def fitted(measured: Any) -> jn.FitTrial:
    return jn.FitTrial("one", RIG, TRIAL, measured)


def many(variants: Any) -> Any:
    return (
        jn.simulate_many(RIG, TRIAL, variants, metrics=["rms sprung.az"])
        .to_dataframe()
        .to_numpy()[:, 0]
        .tolist()
    )


@pytest.mark.parametrize(
    ("carried", "plain"),
    [
        (lambda: jn.fit_decay(DECAY, mass=16.0), lambda: jn.fit_decay(T, X, mass=16.0)),
        (lambda: jn.fit_decay(DECAY["body.z"], mass=16.0), lambda: jn.fit_decay(T, X, mass=16.0)),
        (lambda: jn.fit_decay(jn.to_pandas(DECAY), mass=16.0), lambda: jn.fit_decay(T, X, mass=16.0)),
        (lambda: jn.fit_damper(RUN), lambda: jn.fit_damper(*(one.values for one in STRUT), RUN["time"].values)),
        (lambda: jn.fit_damper(TABLE), lambda: jn.fit_damper(RUN)),
        (lambda: jn.fit_damper(*STRUT), lambda: jn.fit_damper(RUN)),
        (lambda: jn.damper_curve(jn.fit_damper(RUN), RUN), lambda: jn.damper_curve(jn.fit_damper(RUN), *STRUT)),
        (lambda: jn.power_spectrum(RUN["sprung.az"]), lambda: jn.power_spectrum(RUN["sprung.az"].values, 1e3)),
        (
            lambda: jn.transfer_function(RUN["road.z"], RUN["sprung.az"]),
            lambda: jn.transfer_function(RUN["road.z"].values, RUN["sprung.az"].values, 1e3),
        ),
        (lambda: jn.ride_metrics(TABLE), lambda: jn.ride_metrics(RUN)),
        (lambda: fitted(TABLE).measured, lambda: fitted(RUN).measured),
        (lambda: fitted(in_ms(RUN)).measured, lambda: fitted(RUN).measured),
        (lambda: fitted(RUN["sprung.az"]).measured, lambda: fitted(RUN[["sprung.az"]]).measured),
        (lambda: jn.recording(TABLE), lambda: RUN.drop_attrs(deep=False)),
        (lambda: jn.update_model(fitted(RUN), FREE), lambda: jn.update_model([fitted(TABLE)], FREE)),
        (lambda: jn.gradient(RIG, TRIAL, [*FREE], TABLE), lambda: jn.gradient(RIG, TRIAL, [*FREE], RUN)),
        (lambda: jn.apply_sensors(TABLE, {}), lambda: RUN.drop_attrs(deep=False)),
        (lambda: jn.simulate(CAR, RIDE), lambda: jn.simulate(CAR, RIDE.trial)),
        (lambda: jn.simulate(RIG, fitted(RUN)), lambda: RUN),
        (lambda: jn.drive(CAR, RIDE.trial).run, lambda: jn.drive(CAR, RIDE).run),
        (lambda: many(VARIED_TABLE), lambda: many(VARIED)),
    ],
)  # fmt: skip
def test_what_carries_its_own_gives_what_arrays_give(
    carried: Callable[[], Any], plain: Callable[[], Any]
) -> None:
    found, wanted = carried(), plain()
    if hasattr(found, "data_vars"):
        assert dict(found.sizes) == dict(wanted.sizes)
        for name, values in wanted.items():
            np.testing.assert_allclose(found[name].values, values.values, rtol=1e-12, atol=1e-15)
            assert found[name].attrs["units"] == values.attrs["units"]
    else:
        assert repr(found) == repr(wanted)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: jn.fit_decay(RUN, mass=16.0), r"more than one .*in m; found 'strut.deflection, .*Select a channel"),
        (lambda: jn.fit_decay(DECAY, mass=16.0, quantity="velocity"), r"has not a channel in m/s"),
        (lambda: jn.fit_decay(X, mass=16.0), r"the time is missing"),
        (lambda: jn.fit_damper(X), r"the force is missing"),
        (lambda: jn.fit_damper(RUN[["tyre.force"]]), r"has not a displacement and a force"),
        (lambda: jn.power_spectrum(X), r"signal: the time is missing"),
        (lambda: jn.power_spectrum(X, np.inf), r"insufficient data for a spectrum"),
        (lambda: jn.transfer_function(RUN["road.z"], RUN["sprung.az"][1:]), r"different times"),
        (lambda: fitted(TABLE.reset_index(drop=True)), r"one: measured: no column 'time'"),
        (lambda: fitted(TABLE.rename(columns={"tyre.force [N]": "tyre.force"})), r"no unit.*tyre.force \[N\]"),
        (lambda: fitted(TABLE.assign(note="a")), r"measured: note: text, not numbers"),
        (lambda: fitted(Path("a.csv")), r"measured: a PosixPath is not a recording.*jn.read_recording"),
        (lambda: many(VARIED_TABLE.rename(columns={"sprung.mass [kg]": "mass"})), r"variants: mass: unknown parameter"),
    ],
)  # fmt: skip
def test_what_it_cannot_mean_is_said(call: Callable[[], Any], message: str) -> None:
    with pytest.raises(jn.JounceError, match=message):
        call()


def test_a_sweep_as_a_table_has_what_was_varied_and_goes_in_again() -> None:
    sweep = jn.simulate_many(RIG, TRIAL, VARIED, metrics=["rms sprung.az"])
    table = jn.to_pandas(sweep)
    varied = ["sprung.mass [kg]", "strut.spring.rate [N/m]"]
    assert list(table)[:3] == [*varied, "rms sprung.az [m/s^2]"]
    again = jn.simulate_many(RIG, TRIAL, table[varied], metrics=["rms sprung.az"])
    assert again.identical(sweep)
