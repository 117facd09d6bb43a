"""Recordings written in every format are read back whole: names, units, long names, attributes, every bit."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import OutputError
from jounce.recordings.writers import RECORDING_FILES

PLAIN = (".csv", ".rsp")
"""Formats of names, units and numbers alone."""


@pytest.fixture(scope="module")
def run():
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.2 s"
    )
    return jn.simulate(jn.load("kart-quarter-car"), trial).assign_attrs(
        note="ümlaut ✓ {}", numbers=[1, 2.5]
    )


@pytest.mark.parametrize("suffix", RECORDING_FILES.writers)
def test_round_trip(run, tmp_path, suffix):
    file = jn.write_recording(run, tmp_path / f"run{suffix}")
    again, findings = jn.read_recording(file)
    assert [finding for finding in findings if finding.severity != "note"] == []
    assert set(again.data_vars) == set(run.data_vars)
    for name in run.data_vars:
        truth = run[name].to_numpy()
        stored = truth.astype("f4").astype(float) if suffix == ".rsp" else truth  # single precision
        assert np.array_equal(again[name], stored)
        assert again[name].attrs["units"] == run[name].attrs["units"]
        if suffix not in PLAIN:
            assert again[name].attrs["long_name"] == run[name].attrs["long_name"]
    np.testing.assert_allclose(
        again["time"], run["time"], rtol=0.0, atol=1e-15 if suffix == ".rsp" else 0.0
    )
    if suffix not in PLAIN:
        assert again.attrs["status"] == "completed"
        assert again.attrs["steps"] == run.attrs["steps"]
        assert again.attrs["note"] == run.attrs["note"]


@pytest.mark.parametrize("suffix", [".mat", ".parquet", ".csv", ".xlsx", ".rsp"])
def test_the_same_recording_gives_the_same_bytes(run, tmp_path, suffix):
    """Not so for MDF, whose library notes when it wrote, nor within MATLAB's header, which has the date."""
    first, second = (
        jn.write_recording(run, tmp_path / f"{name}{suffix}").read_bytes() for name in "ab"
    )
    head = 128 if suffix == ".mat" else 0
    assert first[head:] == second[head:]


def test_long_names_of_cars_in_matlab(tmp_path):
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="0.5 m"), speed="5 m/s", duration="0.05 s"
    )
    car = jn.simulate(jn.load("audi-a6-full-car"), trial)
    again, _ = jn.read_recording(jn.write_recording(car, tmp_path / "car.mat"))
    assert set(again.data_vars) == set(car.data_vars)


def test_names_that_collide_in_matlab_are_refused(run, tmp_path):
    twice = run.assign({"sprung_az": run["sprung.az"]})
    with pytest.raises(OutputError, match="same name in MATLAB"):
        jn.write_recording(twice, tmp_path / "run.mat")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "suffix", [suffix for suffix in RECORDING_FILES.writers if suffix != ".nc"]
)
def test_what_a_format_would_lose_is_refused(tmp_path, suffix) -> None:
    """A table, a single number and texts were left out without a word, or ended in a traceback."""
    time = {"time": ("time", np.arange(10) * 0.01, {"units": "s"})}
    channel = ("time", np.arange(10.0), {"units": "N"})
    for other in (
        ("time", ["a"] * 10),
        ("time", np.ones(10) * 1j),
        (("time", "k"), np.ones((10, 3))),
        3.0,
    ):
        whole = xr.Dataset({"tyre.force": channel, "more": other}, coords=time)
        with pytest.raises(
            OutputError, match=r"more: not a numeric channel over time; found .* Leave it out"
        ):
            jn.write_recording(whole, tmp_path / f"run{suffix}")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("suffix", "name"),
    [
        (".csv", "a,b.az"),
        (".csv", "a;b.az"),
        (".csv", "a\tb.az"),
        (".nc", "a/b.az"),
        (".mf4", ""),
        (".xlsx", "a\x07.az"),
    ],
)
def test_names_that_a_format_cannot_hold(tmp_path, suffix, name) -> None:
    time = {"time": ("time", np.arange(10) * 0.01, {"units": "s"})}
    run = xr.Dataset({name: ("time", np.arange(10.0), {"units": "m/s^2"})}, coords=time)
    with pytest.raises(OutputError, match=r"a name that the file cannot store.*Rename the channel"):
        jn.write_recording(run, tmp_path / f"run{suffix}")
