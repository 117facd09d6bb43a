"""Recordings on one axis: what is drawn keeps every peak, what is measured is of every sample."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import JounceError

pytest.importorskip("fastapi")
from jounce.analysis.layouts import Layout, layout_of, layout_text
from jounce.web import overlays
from jounce.web.jobs import Jobs
from jounce.web.project import Project
from jounce.web.records import Records

DENSE = np.arange(50_000) / 1000.0
SPARSE = np.arange(500) / 10.0 + 0.003


def write(file: Path, time: np.ndarray, **columns: np.ndarray) -> None:
    heads = ",".join(f"{name.replace('_IN_', ' [')}]" for name in ("time_IN_s", *columns))
    table = np.column_stack([time, *columns.values()])
    np.savetxt(file, table, delimiter=",", header=heads, comments="", fmt="%.9g")


@pytest.fixture(scope="module")
def records(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Records]:
    folder = tmp_path_factory.mktemp("recordings")
    peak = np.where(np.arange(DENSE.size) == 33_333, 9.0, np.sin(DENSE))
    write(folder / "dense.csv", DENSE, az_IN_g=peak, distance_IN_m=20.0 * DENSE)
    spike = np.where(np.arange(SPARSE.size) == 77, -50.0, 9.80665 * np.sin(SPARSE - 0.5))
    write(folder / "sparse.csv", SPARSE, **{"az_IN_m/s^2": spike, "distance_IN_km": 0.02 * SPARSE})
    project = Project(folder)
    jobs = Jobs(project)
    found = Records(project, jobs)
    yield found
    found.end()
    jobs.end()


def layout(**fields: Any) -> Layout:
    usual = {
        "recordings": [{"path": "dense.csv"}, {"path": "sparse.csv", "shifts": {"time": -0.5}}],
        "graphs": [{"channels": ["az"]}],
    }
    return Layout(**{**usual, **fields})


def drawn(records: Records, shown: Layout, columns: int = 200) -> tuple[Any, dict[str, Any]]:
    tracks = overlays.tracks_of(records, shown)
    viewer, beside = overlays.curves(shown, tracks, *overlays.whole_range(tracks, shown), columns)
    return viewer.scenes[0], beside


def test_no_peak_is_lost_between_recordings_of_different_rates(records: Records) -> None:
    scene, beside = drawn(records, layout(), 400)
    first, second = (curve.values for curve in scene.panes[0].curves)
    assert scene.panes[0].unit == "g"
    assert np.nanmax(first) == pytest.approx(9.0)
    assert np.nanmin(second) == pytest.approx(-50.0 / 9.80665, rel=1e-6)  # in the unit of the graph
    assert scene.x[np.nanargmin(second)] == pytest.approx(7.703 - 0.5)
    assert beside["problems"] == []
    ends = scene.x[np.isfinite(second)][[0, -1]]
    assert ends == pytest.approx([0.003 - 0.5, 49.903 - 0.5])
    np.testing.assert_allclose(np.diff(scene.x) > 0, True)


def test_a_window_has_the_statistics_of_every_sample(records: Records) -> None:
    shown = layout()
    tracks = overlays.tracks_of(records, shown)
    first, second = overlays.window_rows(shown, tracks, 30.0, 36.0)
    peak = np.where(np.arange(DENSE.size) == 33_333, 9.0, np.sin(DENSE))[30_000:36_001]
    assert first["statistics"]["samples"] == 6001
    assert first["statistics"]["maximum"] == pytest.approx(9.0)
    assert first["statistics"]["mean"] == pytest.approx(peak.mean(), rel=1e-6)
    assert first["statistics"]["rms"] == pytest.approx(np.sqrt(np.mean(peak**2)), rel=1e-6)
    assert first["a"] == pytest.approx(np.sin(30.0), rel=1e-6)
    assert first["difference"] == pytest.approx(np.sin(36.0) - np.sin(30.0), abs=1e-6)
    inside = (SPARSE - 0.5 >= 30.0) & (SPARSE - 0.5 <= 36.0)
    assert second["statistics"]["samples"] == inside.sum()
    assert second["statistics"]["mean"] == pytest.approx(
        np.sin(SPARSE - 0.5)[inside].mean(), abs=1e-6
    )
    (outside, _) = overlays.window_rows(shown, tracks, 60.0, 70.0)
    assert outside["statistics"] is None
    assert outside["a"] is None


def test_a_distance_is_an_axis_in_the_unit_of_the_first_recording(records: Records) -> None:
    shown = layout(axis="distance")
    tracks = overlays.tracks_of(records, shown)
    assert overlays.whole_range(tracks, shown) == pytest.approx((0.0, 20.0 * DENSE[-1]), rel=1e-6)
    first, second = overlays.window_rows(shown, tracks, 100.0, 200.0)
    assert first["statistics"]["samples"] == 5001
    assert second["statistics"]["samples"] == 50
    refused = overlays.tracks_of(records, layout(axis="az"))
    assert "it descends or has gaps" in str(refused[0].problem)


def test_what_is_missing_is_named_and_the_rest_is_shown(records: Records) -> None:
    shown = layout(
        recordings=[{"path": "dense.csv"}, {"path": "gone.csv"}],
        graphs=[{"channels": ["az", "brake"]}],
    )
    scene, beside = drawn(records, shown)
    assert len(scene.panes[0].curves) == 1
    assert [one["text"] for one in beside["problems"]] == [
        "dense.csv: no recording has the channel 'brake'."
    ]
    tracks = overlays.tracks_of(records, shown)
    assert "gone.csv: no such file" in overlays.about_tracks(tracks)[1]["problem"]["text"]
    mixed = layout(graphs=[{"channels": ["az", "distance"]}])
    assert "gone" not in str(drawn(records, mixed)[1]["problems"])


def test_a_changed_file_has_another_digest(records: Records) -> None:
    file = records.project.root / "changing.csv"
    write(file, SPARSE, az_IN_g=np.sin(SPARSE))
    before = records.digest("changing.csv")
    assert (
        overlays.tracks_of(records, layout(recordings=[{"path": "changing.csv"}]))[0].digest
        == before
    )
    write(file, SPARSE, az_IN_g=np.cos(SPARSE))
    assert records.digest("changing.csv") != before
    assert records.digest("gone.csv") == ""


def test_a_layout_is_a_file_like_others() -> None:
    shown = layout(cursors=(1.0, 2.0), formulas=[{"name": "v", "formula": "integral(az)"}])
    text = layout_text(shown)
    assert text.startswith('schema = "jounce.layout/1"\n')
    assert Layout(**layout_of(text, "a.toml")) == shown
    for wrong, words in (
        (text.replace("layout/1", "rig/1"), "the schema line is missing or wrong"),
        (text + "colour = 1\n", "colour"),
        (text.replace("integral(az)", "x" * 2000), "formula"),
        (text.replace('"sparse.csv"', '"dense.csv"'), "given twice"),
        ("=", "a.toml"),
    ):
        with pytest.raises(JounceError, match=words):
            layout_of(wrong, "a.toml")
    with pytest.raises(JounceError, match="not a name for a computed channel"):
        layout(formulas=[{"name": "a b", "formula": "az"}])


def test_formulas_are_computed_once_for_each_recording(records: Records) -> None:
    formulas = [
        {"name": "speed", "formula": "derivative(distance)", "unit": "km/h"},
        {"name": "twice", "formula": "speed * 2"},
        {"name": "wrong", "formula": "speed + az"},
        {"name": "split", "formula": "az / max(distance - '100 m', 0)"},
    ]
    shown = layout(formulas=formulas, graphs=[{"channels": ["speed", "twice"]}])
    tracks = overlays.tracks_of(records, shown)
    first, second = (track["formulas"] for track in overlays.about_tracks(tracks))
    assert [state["unit"] for state in first] == ["km/h", "m/s", "", "1/s^2"]
    assert "units do not fit; found 'm/s and m/s^2'" in first[2]["problem"]["text"]
    assert "die Einheiten passen nicht zueinander" in second[2]["problem"]["german"]
    assert "is zero at" in first[3]["notes"][0]["text"]
    rows = overlays.window_rows(shown, tracks, 10.0, 20.0)
    for row in rows:
        assert row["unit"] == "km/h"
        factor = 1.0 if row["channel"] == "speed" else 2.0
        assert row["statistics"]["mean"] == pytest.approx(72.0 * factor, rel=1e-3)
    stored = sorted(file.name for file in tracks[0].clock.levels.folder.glob("f-*.json"))
    changed = layout(formulas=[formulas[0], {"name": "twice", "formula": "speed * 3"}])
    overlays.tracks_of(records, changed)
    now = {file.name for file in tracks[0].clock.levels.folder.glob("f-*.json")}
    assert len(now) == len(stored) + 1  # what did not change is not computed again
    taken = overlays.tracks_of(records, layout(formulas=[{"name": "az", "formula": "distance"}]))
    assert "has a channel of this name" in taken[0].formulas[0]["problem"]["text"]


def test_formulas_of_all_recordings_are_computed_in_one_process(
    records: Records, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = []
    ask = records._ask

    def counted(title: str, question: dict[str, Any]) -> None:
        asked.append(sorted(question["records"]))
        if len(question["records"]) > 1 and len(asked) > 1:
            raise JounceError("more memory than allowed")
        ask(title, question)

    for path in ("dense.csv", "sparse.csv"):
        records.open(path)
    monkeypatch.setattr(records, "_ask", counted)
    for factor in (3, 5):  # together; then, as that fails, each alone
        shown = layout(formulas=[{"name": "more", "formula": f"{factor} * distance"}])
        tracks = overlays.tracks_of(records, shown)
        assert [track.formulas[0]["problem"] for track in tracks] == [None, None]
    both = ["dense.csv", "sparse.csv"]
    assert asked == [both, both, *([path] for path in both)]


def test_a_faulty_formula_is_named_once(records: Records) -> None:
    shown = layout(
        formulas=[{"name": "more", "formula": "nothing + 1"}], graphs=[{"channels": ["more"]}]
    )
    tracks = overlays.tracks_of(records, shown)
    _, problems = overlays.traces_of(shown, tracks)
    assert problems == []
    assert "no channel 'nothing'" in tracks[0].formulas[0]["problem"]["text"]


def test_recordings_are_aligned_onto_shifted_ones(records: Records) -> None:
    rng = np.random.default_rng(8)
    bumps = np.interp(np.arange(0.0, 60.0, 0.01), np.arange(0.0, 61.0, 0.5), rng.normal(size=122))
    t = np.arange(0.0, 30.0, 0.01)
    write(records.project.root / "one.csv", t, az_IN_g=bumps[: t.size])
    later = bumps[500 : 500 + t.size : 2]
    write(records.project.root / "two.csv", t[::2], **{"az_IN_m/s^2": 9.80665 * later})
    shown = layout(recordings=[{"path": "one.csv", "shifts": {"time": 2.0}}, {"path": "two.csv"}])
    tracks = overlays.tracks_of(records, shown)
    found = overlays.aligned(shown, tracks, 0, 1, "az", by="correlation")
    assert found["shift"] == pytest.approx(7.0, abs=2e-3)
    assert found["correlation"] > 0.99
    assert found["rate"] == pytest.approx(50.0, rel=1e-3)
    level = float(bumps[600:610].mean())
    event = overlays.aligned(shown, tracks, 0, 1, "az", by="maximum", level=level)
    assert np.isfinite(event["shift"])
    with pytest.raises(JounceError, match="these are not two recordings"):
        overlays.aligned(shown, tracks, 0, 0, "az", by="start")


def test_recordings_are_aligned_along_a_distance(records: Records) -> None:
    rng = np.random.default_rng(9)
    places = np.arange(0.0, 400.0, 5.0)
    road = np.interp(np.arange(0.0, 390.0, 0.05), places, rng.normal(size=places.size))

    def height(x: np.ndarray) -> np.ndarray:
        return np.interp(x, np.arange(0.0, 390.0, 0.05), road)

    t = np.arange(0.0, 12.0, 0.005)
    slow = np.maximum(0.0, 20.0 * t + 0.4 * t**2 - 20.0)  # it stands still at first
    fast = 22.0 * t + 2.0 * np.sin(t)
    write(records.project.root / "slow.csv", t, az_IN_g=height(slow + 30.0), way_IN_m=slow)
    write(records.project.root / "fast.csv", t, az_IN_g=height(fast + 55.0), way_IN_km=1e-3 * fast)
    shown = layout(
        axis="way", recordings=[{"path": "slow.csv", "shifts": {"way": 3.0}}, {"path": "fast.csv"}]
    )
    tracks = overlays.tracks_of(records, shown)
    found = overlays.aligned(shown, tracks, 0, 1, "az", by="correlation")
    assert found["shift"] == pytest.approx(3.0 + 25.0, abs=0.1)
    assert found["correlation"] > 0.98
    assert found["unit"] == "m"
    start = overlays.aligned(shown, tracks, 0, 1, "az", by="start")
    assert start["shift"] == pytest.approx(3.0)
    with pytest.raises(JounceError, match="the recordings are not alike"):
        overlays.aligned(shown, tracks, 0, 1, "az", by="correlation", maximum_shift=1.0)


def charted(records: Records, **chart: Any) -> tuple[Any, dict[str, Any]]:
    from jounce.web.window_charts import window_chart

    shown = layout(chart=chart)
    viewer, notes = window_chart(shown, overlays.tracks_of(records, shown), 10.0, 20.0)
    return viewer.scenes[0], notes


def test_the_charts_are_those_of_the_window(records: Records) -> None:
    scene, notes = charted(records, kind="spectrum", channel="az")
    first, second = (curve.values for curve in scene.panes[0].curves)
    assert scene.x[np.nanargmax(first)] == pytest.approx(1.0 / (2.0 * np.pi), abs=1.0)
    assert scene.x[np.isfinite(second)][-1] == pytest.approx(5.0, rel=0.01)  # half of 10 Hz
    assert notes["figures"][0]["resolution"] > 0.5
    scene, _ = charted(records, kind="histogram", channel="az", bins=20)
    for curve in scene.panes[0].curves:
        assert curve.values[1:-1:2].sum() == pytest.approx(100.0)
    scene, notes = charted(records, kind="scatter", channel="az", across="distance")
    figure = notes["figures"][0]
    inside = (DENSE >= 10.0) & (DENSE <= 20.0)
    slope, offset = np.polyfit(20.0 * DENSE[inside], np.sin(DENSE[inside]), 1)
    assert (figure["slope"], figure["offset"]) == pytest.approx((slope, offset), rel=1e-4)
    assert (figure["samples"], figure["every"]) == (10_001, 4)
    assert np.all(np.diff(scene.x) >= 0.0)
    shifted = 20.0 * SPARSE[SPARSE <= 20.5].max()  # m: the sparse one is drawn 0.5 s earlier
    assert scene.x.max() == pytest.approx(shifted, rel=1e-6)
    with pytest.raises(JounceError, match="no chart is chosen"):
        charted(records)
    _, notes = charted(records, kind="scatter", channel="az", across="brake")
    assert "brake" in notes["notes"][0]["text"]
