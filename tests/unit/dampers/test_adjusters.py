"""Maps over one and several adjusters: between measured settings, from tables, and what is refused."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from tests.unit.dampers.shim_stack import ShimDamper, record

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError
from jounce.dampers.files import settings_in_name

SPEEDS = (-0.4, -0.2, -0.1, 0.1, 0.2, 0.4)


def added(bump: float, rebound: float, v: float) -> float:
    """A damper whose adjusters change one side each."""
    return (800.0 - 30.0 * bump if v > 0.0 else 1500.0 - 60.0 * rebound) * v


def multiplied(bump: float, rebound: float, v: float) -> float:
    """A damper whose adjusters both change both sides."""
    return 1500.0 * (1.0 - 0.03 * bump) * (1.0 - 0.02 * rebound) * v


def table(folder: Path, law, settings, half: float | None = 2.0) -> Path:
    file = folder / "map.csv"
    rows = ["bump clicks,rebound clicks,velocity [m/s],force [N],low [N],high [N]"]
    for bump, rebound in settings:
        for v in SPEEDS:
            force = law(bump, rebound, v)
            ends = ["", ""] if half is None else [force - half, force + half]
            rows.append(",".join(map(str, [bump, rebound, v, force, *ends])))
    file.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return file


GRID = [(b, r) for b in (0, 8, 16) for r in (0, 10, 20)]
STAR = [(8, 10), (0, 10), (16, 10), (8, 0), (8, 20)]


@pytest.mark.parametrize("settings", [GRID, STAR], ids=["grid", "star"])
def test_effects_on_one_side_each_are_exact_at_any_clicks(tmp_path: Path, settings):
    made = jn.read_damper_map(table(tmp_path, added, settings))
    assert made.adjusters == ("bump_clicks", "rebound_clicks")
    curve = made.at({"bump_clicks": 3.0, "rebound_clicks": 13.0})
    truth = [added(3, 13, v) for v in curve.velocity]
    assert curve.force == pytest.approx(truth)
    assert np.all((curve.low < truth) & (truth < curve.high))


def test_a_whole_grid_includes_what_multiplies_and_a_star_says_how_wrong_a_sum_is(tmp_path: Path):
    place = {"bump_clicks": 12.0, "rebound_clicks": 15.0}
    truth = np.array([multiplied(12, 15, v) for v in SPEEDS])
    grid = jn.read_damper_map(table(tmp_path, multiplied, GRID)).at(place)
    assert grid.force == pytest.approx(truth)
    star = jn.read_damper_map(table(tmp_path, multiplied, STAR)).at(place)
    assert np.abs(star.force - truth).max() > 5.0
    assert np.all((star.low < truth) & (truth < star.high))
    more = jn.read_damper_map(table(tmp_path, multiplied, [*STAR, (16, 20)]))
    measured = more.at({"bump_clicks": 16.0, "rebound_clicks": 20.0})
    assert measured.force == pytest.approx([multiplied(16, 20, v) for v in SPEEDS])
    assert (measured.high - measured.low) == pytest.approx(4.0)


def test_measured_settings_keep_their_interval_where_nothing_tells_the_interpolation(
    tmp_path: Path,
):
    made = jn.read_damper_map(table(tmp_path, added, [(0, 0), (16, 0)]))
    assert made.adjusters == ("bump_clicks",)
    assert made.clicks == (0.0, 16.0)
    assert (made.at(16.0).high - made.at(16.0).low) == pytest.approx(4.0)
    assert np.isnan(made.at(8.0).high).all()


def test_a_table_is_written_and_read_again(tmp_path: Path):
    rng = np.random.default_rng(1)
    given = [
        jn.RecordFile(f"{c}clicks_{v}.csv", record(ShimDamper().with_clicks(c), v, rng))
        for c in (0, 4)
        for v in (0.1, 0.2, 0.4)
    ]
    made = jn.damper_map(given)
    file = tmp_path / "map.csv"
    file.write_text(made.table(), encoding="utf-8")
    again = jn.read_damper_map(file)
    for item, other in zip(made.settings, again.settings, strict=True):
        assert other.settings == item.settings
        assert other.force == pytest.approx(item.force)
        assert other.low == pytest.approx(item.low)
        assert other.friction.value == pytest.approx(item.friction.value)
        assert other.gas_force.interval == pytest.approx(item.gas_force.interval)
    assert again.damper["force"][0] == pytest.approx(made.damper["force"][0])


def test_a_folder_of_records_with_its_settings_is_a_map(tmp_path: Path):
    rng = np.random.default_rng(1)
    for name in ("a", "b"):
        for v in (0.1, 0.2, 0.4):
            jn.write_recording(
                record(ShimDamper(), v, rng, seconds=4.0), tmp_path / f"{name}{v}.csv"
            )
    rows = [f"{n}{v},{c}" for n, c in (("a", 3), ("b", 9)) for v in (0.1, 0.2, 0.4)]
    (tmp_path / "settings.csv").write_text("file,low-speed rebound clicks\n" + "\n".join(rows))
    made = jn.read_damper_map(tmp_path)
    assert (made.adjusters, made.clicks) == (("low_speed_rebound_clicks",), (3.0, 9.0))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("clicks,velocity,force\n0,0.1,x\n", "row 2, force"),
        ("clicks,velocity,force\n0,0.1,5\n0,0.1,6\n", "each of them once"),
        ("clicks,velocity,force\n0,0.1,5\n", "at least two velocities"),
        ("clicks,velocity,force\n", "no rows"),
        ("clicks,velocity,force\n0,0.1\n", "no number"),
        ("velocity [mm],force\n1,2\n3,4\n", "velocity"),
        ("velocity,velocity,force\n1,2,3\n", "one column velocity"),
    ],
)
def test_a_wrong_table_is_refused(tmp_path: Path, text: str, message: str):
    file = tmp_path / "map.csv"
    file.write_text(text)
    with pytest.raises((RecordingError, DescriptionError), match=message):
        jn.read_damper_map(file)


def test_clicks_are_refused_beyond_the_measured_ones_and_without_their_names(tmp_path: Path):
    made = jn.read_damper_map(table(tmp_path, added, GRID))
    with pytest.raises(DescriptionError, match=r"not among the clicks.*0 to 16"):
        made.at({"bump_clicks": 17.0, "rebound_clicks": 3.0})
    with pytest.raises(DescriptionError, match="clicks of each adjuster"):
        made.at(3.0)
    both = jn.read_damper_map(table(tmp_path, added, [(0, 0), (8, 10)]))
    with pytest.raises(DescriptionError, match="no records move bump clicks alone"):
        both.at({"bump_clicks": 3.0, "rebound_clicks": 3.0})


def test_adjusters_in_names():
    assert settings_in_name("hsc3_lsr12.csv") == {
        "high_speed_bump_clicks": 3.0,
        "low_speed_rebound_clicks": 12.0,
    }
    assert settings_in_name("bump4 rebound6 40degC.csv")["rebound_clicks"] == 6.0
    assert settings_in_name("bump_100mms.csv") == {}
    assert settings_in_name("rebound_2 Hz.csv") == {}
    assert not math.isnan(settings_in_name("rear_8clicks.csv")["clicks"])
