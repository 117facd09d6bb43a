"""Mechanisms in motion: what the page holds, what the films show, what is refused."""

from __future__ import annotations

import base64
import json
import re
import shutil
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from PIL import Image

import jounce as jn
from jounce.core.errors import DescriptionError, OutputError, RecordingError
from jounce.core.optional import MissingPackageError
from jounce.plots.mechanisms import animation as films
from jounce.plots.mechanisms.scene import poses_of, roadway_of, scene_of
from jounce.report import animate

TRIAL = {"speed": "1.95 m/s", "duration": "0.4 s"}


@pytest.fixture(scope="module")
def kart() -> Any:
    return jn.load("kart-double-wishbone")


@pytest.fixture(scope="module")
def sweep(kart) -> xr.Dataset:
    return jn.sweep_travel(kart, np.linspace(-0.02, 0.02, 9), points=True)


@pytest.fixture(scope="module")
def page(kart, sweep, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of the sweep."""
    return animate(kart, sweep, tmp_path_factory.mktemp("motion") / "motion.html")


@pytest.fixture(scope="module")
def trial() -> jn.Trial:
    return jn.Trial(road=jn.HalfSine(height="20 mm", length="100 mm", start="0.2 m"), **TRIAL)


@pytest.fixture(scope="module")
def run(kart, trial) -> xr.Dataset:
    return jn.simulate(kart, trial, detail=True)


def data_of(page: Path) -> dict[str, Any]:
    """What the page was given."""
    text = re.search(
        r'<script type="application/json" id="jounce-data">(.*?)</script>',
        page.read_text(encoding="utf-8"),
    )
    assert text is not None

    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} is not JSON")

    found = json.loads(text[1], parse_constant=refuse)
    assert isinstance(found, dict)
    return found


def scene_in(data: dict[str, Any]) -> dict[str, Any]:
    (viewer,) = data["viewers"]
    (scene,) = viewer["scenes"]
    assert isinstance(scene, dict)
    return scene


def array(data: dict[str, Any], index: int) -> np.ndarray:
    """An array of a page, unpacked as its viewer does."""
    packed = data["arrays"][index]
    n, at = packed["n"], packed["at"]
    if "even" in packed:
        return packed["even"][0] + packed["even"][1] * np.arange(n)
    raw = np.frombuffer(zlib.decompress(base64.b64decode(data["packed"])), np.uint8).astype(
        np.int64
    )
    folded = raw[at : at + n] | raw[at + n : at + 2 * n] << 8
    whole = folded if packed["order"] == 0 else (folded >> 1) ^ -(folded & 1)
    for _ in range(packed["order"]):
        whole = np.cumsum(whole) & 65535
    return np.where(whole == 65535, np.nan, packed["low"] + packed["step"] * whole)


def test_page_holds_every_pose_to_a_thousandth_of_a_millimetre(kart, sweep, page: Path) -> None:
    data = data_of(page)
    scene, (mechanism,) = scene_in(data), data["mechanisms"]
    assert array(data, scene["x"]) == pytest.approx(np.linspace(-20.0, 20.0, 9))
    assert data["viewers"][0]["x"] == {"words": "wheel travel", "unit": "mm"}
    assert data["viewers"][0]["stage"] is True
    assert mechanism["travel"] == pytest.approx(np.linspace(-20.0, 20.0, 9))
    assert array(data, scene["motion"]["travel"]) == pytest.approx(mechanism["travel"])
    assert array(data, scene["motion"]["body"]) == pytest.approx(np.zeros(9))
    assert sorted(mechanism["names"]) == sorted(kart.hardpoints.given())
    for k in range(9):
        for name, places in zip(mechanism["names"], mechanism["points"], strict=True):
            expected = [1e3 * float(sweep[f"{name}.{letter}"][k]) for letter in "xyz"]
            assert places[k] == pytest.approx(expected, abs=0.00051)
        assert mechanism["contact"][k][1] == pytest.approx(
            1e3 * float(sweep["contact_point_y"][k]), abs=0.00051
        )
    assert scene["motion"]["road"] is None


def test_poses_that_are_given_twice_are_held_once(kart, sweep, tmp_path: Path) -> None:
    twice = sweep.isel(wheel_travel=[4, 0, 4, 8, 8])
    data = data_of(animate(kart, twice, tmp_path / "motion.html"))
    assert data["mechanisms"][0]["travel"] == pytest.approx([-20.0, 0.0, 20.0])


def test_page_of_a_rack_sweep_turns_its_wheel(kart, tmp_path: Path) -> None:
    steered = jn.sweep_rack(kart, np.linspace(-0.01, 0.01, 5), points=True)
    data = data_of(animate(kart, steered, tmp_path / "motion.html"))
    (mechanism,) = data["mechanisms"]
    assert data["viewers"][0]["x"]["words"] == "rack travel"
    inner = mechanism["points"][mechanism["names"].index("tie_rod_inner")]
    assert [place[1] - inner[2][1] for place in inner] == pytest.approx(
        [-10.0, -5.0, 0.0, 5.0, 10.0], abs=0.002
    )
    turned = np.degrees(
        np.arctan2(-np.array(mechanism["spin"])[:, 0], np.array(mechanism["spin"])[:, 1])
    )
    assert turned == pytest.approx(np.degrees(steered["steer"].to_numpy()), abs=0.01)
    assert np.ptp(turned) > 5.0


def test_page_shows_quantities_in_usual_units(sweep, page: Path) -> None:
    data = data_of(page)
    panes = {pane["name"]: pane for pane in scene_in(data)["panes"]}
    caster = panes["caster"]
    assert (caster["unit"], caster["words"]) == ("°", "caster angle")
    shown = array(data, caster["curves"][0]["y"])
    assert shown == pytest.approx(np.degrees(sweep["caster"].to_numpy()), abs=6e-5)
    camber = array(data, panes["camber"]["curves"][0]["y"])
    assert set(camber) == {0.0}  # parallel arms of one length: rounding is no curve
    assert [name for name, pane in panes.items() if pane["shown"]] == [
        "camber",
        "toe",
        "motion_ratio",
    ]
    assert not any(name.endswith(("_front.x", "_joint.z")) for name in panes)
    assert "wheel_travel" not in panes


def test_page_needs_nothing_else_and_is_always_the_same(
    kart, sweep, page: Path, tmp_path: Path
) -> None:
    first = page.read_bytes()
    assert animate(kart, sweep, tmp_path / "b.html").read_bytes() == first
    text = re.sub(
        r"<script>.*?</script>", "", first.decode(), flags=re.DOTALL
    )  # the viewer is tested in a browser
    text = re.sub(r' xmlns(:\w+)?="[^"]+"', "", text)  # names of namespaces are no addresses
    assert "default-src 'none'" in text
    assert not re.search(
        r"https?:|//cdn|@import|\bfetch\(|XMLHttpRequest|<link|\bsrc=|import\(", text
    )
    assert "{{" not in text


def test_title_is_text(kart, sweep, tmp_path: Path) -> None:
    wicked = "</title><script>alert(1)</script>" + "漢" * 300
    text = animate(kart, sweep, tmp_path / "a.html", title=wicked).read_text(encoding="utf-8")
    assert "alert(1)</script>" not in text
    assert "&lt;script&gt;alert(1)" in text
    assert "漢" * 300 in text


def test_long_names_of_signals_cannot_leave_their_place(kart, sweep, tmp_path: Path) -> None:
    named = sweep.copy()
    named["camber"].attrs["long_name"] = "</script><script>alert(1)</script>"
    data = data_of(animate(kart, named, tmp_path / "a.html"))
    words = {pane["name"]: pane["words"] for pane in scene_in(data)["panes"]}
    assert words["camber"] == "camber, </script><script>alert(1)</script>"


def test_three_hundred_poses_are_half_a_megabyte_beside_the_viewer(kart, tmp_path: Path) -> None:
    poses = jn.sweep_travel(kart, np.linspace(-0.02, 0.02, 300), points=True)
    page = animate(kart, poses, tmp_path / "a.html")
    data = data_of(page)
    assert len(data["mechanisms"][0]["travel"]) == 300
    assert 100_000 < len(json.dumps(data)) < 500_000


def test_run_lifts_off_and_its_road_passes(kart, run, trial, tmp_path: Path) -> None:
    data = data_of(animate(kart, run, tmp_path / "a.html", trial=trial))
    scene, (mechanism,) = scene_in(data), data["mechanisms"]
    load = array(data, scene["motion"]["load"])
    assert (load > 0.5).tolist() == (run["tyre.force"].to_numpy() > 0.0).tolist()
    assert 0.0 in load
    road = scene["motion"]["road"]
    assert road["speed"] == pytest.approx(1950.0)
    under = np.interp(1950.0 * run["time"].to_numpy(), road["x"], road["z"])
    assert under == pytest.approx(1e3 * run["road.z"].to_numpy(), abs=0.05)
    assert max(road["z"]) == pytest.approx(20.0, abs=0.05)
    ground = array(data, scene["motion"]["ground"])
    assert ground == pytest.approx(1e3 * run["road.z"].to_numpy(), abs=0.001)
    contact = np.array(mechanism["contact"])[:, 2]
    assert contact[load > 0.5] == pytest.approx(ground[load > 0.5], abs=0.011)
    assert (contact > ground - 0.011).all()
    names = {pane["name"] for pane in scene["panes"]}
    assert {"tyre.force", "road.z", "wheel.camber"} <= names
    assert not any(name.endswith(".fx") for name in names)


def test_part_of_a_run_and_fewer_poses(kart, run, trial, tmp_path: Path) -> None:
    data = data_of(
        animate(kart, run, tmp_path / "a.html", trial=trial, between=("0.1 s", 0.2), frames=11)
    )
    assert array(data, scene_in(data)["x"]) == pytest.approx(np.linspace(0.1, 0.2, 11))
    assert data["mechanisms"][0]["travel"] == pytest.approx(np.linspace(100.0, 200.0, 11))  # ms
    with pytest.raises(DescriptionError, match=r"between: no pose at this time.*0 s to 0\.4000 s"):
        animate(kart, run, tmp_path / "b.html", between=(0.1, 0.5))


def test_slow_motion_sets_the_speed(kart, run, page: Path, tmp_path: Path) -> None:
    assert data_of(animate(kart, run, tmp_path / "a.html", slow=7.0))["viewers"][0]["slower"] == 7.0
    assert data_of(page)["viewers"][0]["slower"] is None  # of a sweep


def test_another_trial_is_refused(kart, run, sweep, trial, tmp_path: Path) -> None:
    flat = jn.Trial(road=jn.Flat(), **TRIAL)
    with pytest.raises(DescriptionError, match="not belong to this trial"):
        animate(kart, run, tmp_path / "a.html", trial=flat)
    short = jn.Trial(road=trial.road, speed="1.95 m/s", duration="0.3 s")
    with pytest.raises(DescriptionError, match="after its end"):
        animate(kart, run, tmp_path / "a.html", trial=short)
    with pytest.raises(DescriptionError, match="a kinematic sweep has no trial"):
        animate(kart, sweep, tmp_path / "a.html", trial=trial)
    with pytest.raises(RecordingError, match="detail=True"):
        animate(kart, run[["road.z", "tyre.force"]], tmp_path / "a.html")
    assert list(tmp_path.iterdir()) == []


def test_rectangle_keeps_its_upright_edges(kart) -> None:
    trial = jn.Trial(road=jn.Rectangle(height="20 mm", length="100 mm", start="0.2 m"), **TRIAL)
    road = roadway_of(trial, np.linspace(0.0, 0.4, 5), 0.127)
    assert road is not None
    corners = np.round(np.column_stack([road.distance, road.height]), 6).tolist()
    assert corners[1:-1] == [[0.2, 0.0], [0.2, 0.02], [0.3, 0.02], [0.3, 0.0]]
    line = road.line(1, 0.3, 0.05)  # the wheel, at x = 50 mm, is at 195 mm on the road
    assert line[0] == pytest.approx([-0.25, 0.0])
    assert line[-1] == pytest.approx([0.35, 0.0])
    assert line[1:3] == pytest.approx(
        np.array([[-0.145, 0.0], [0.055, 0.0]]), abs=1e-6
    )  # its beginning, its first foot


def test_excitation_has_no_road(kart, tmp_path: Path) -> None:
    time = np.linspace(0.0, 0.3, 31)
    shaker = jn.Excitation(time=time, height=0.002 * np.sin(30.0 * time))
    trial = jn.Trial(excitation=shaker, duration="0.3 s")
    run = jn.simulate(kart, trial, detail=True)
    data = data_of(animate(kart, run, tmp_path / "a.html", trial=trial))
    motion = scene_in(data)["motion"]
    assert motion["road"] is None
    assert array(data, motion["ground"]) == pytest.approx(
        1e3 * run["road.z"].to_numpy(), abs=0.0051
    )


@pytest.mark.parametrize(
    ("name", "message"),
    [("a.avi", "format"), ("a", "format"), ("no/a.html", "folder"), ("there.html", "exists")],
)
def test_files_that_cannot_be_written_are_refused_first(
    kart, name: str, message: str, tmp_path: Path
) -> None:
    (tmp_path / "there.html").write_text("mine", encoding="utf-8")
    with pytest.raises(OutputError, match=message):
        animate(kart, xr.Dataset(), tmp_path / name)
    assert (tmp_path / "there.html").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("slow", [0.0, -1.0, float("nan")])
def test_slowness_must_be_positive(kart, sweep, slow: float, tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="slow: out of range"):
        animate(kart, sweep, tmp_path / "a.html", slow=slow)


def test_gif_goes_there_and_back(kart, sweep, tmp_path: Path) -> None:
    said: list[str] = []
    few = sweep.isel(wheel_travel=[0, 4, 8])
    file = animate(kart, few, tmp_path / "a.gif", progress=said.append)
    assert len(said) == 3
    with Image.open(file) as picture:
        assert picture.n_frames == 4  # low, middle, high, middle
        assert picture.info["duration"] == 50
        assert picture.info["loop"] == 0
        frames = []
        for k in range(4):
            picture.seek(k)
            frames.append(np.asarray(picture.convert("RGB")).astype(int))
    assert np.abs(frames[0] - frames[1]).max() > 100
    assert np.abs(frames[1] - frames[3]).max() == 0
    assert animate(kart, few, tmp_path / "b.gif").read_bytes() == file.read_bytes()


def test_gif_of_a_run_takes_its_time(kart, run, trial, tmp_path: Path) -> None:
    file = animate(kart, run, tmp_path / "a.gif", trial=trial, between=(0.1, 0.14), slow=10.0)
    with Image.open(file) as picture:
        assert picture.n_frames == 11  # 0.4 s at 25 pictures a second, both ends
        assert picture.info["duration"] == 40


def test_tyre_leaves_the_road_in_the_film(kart, run, trial) -> None:
    scene = scene_of(kart)
    poses = poses_of(kart, scene, run)
    film = films._Film(
        films.Animation(
            scene, poses, roadway_of(trial, poses.over, scene.undeformed_radius), "kart", 5.0, print
        )
    )
    flying, standing = int(np.argmin(poses.touches)), 0
    for k, words in ((standing, "time 0.000 s"), (flying, f"no contact · {poses.label(flying)}")):
        film.show(k)
        assert film.state.get_text() == words
    road = poses.ground[flying]
    lowest = poses.points["wheel_centre"][flying, 2] - scene.undeformed_radius
    assert lowest > road  # what is drawn agrees with what is said


def test_mp4_without_ffmpeg_says_what_to_install(
    kart, sweep, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def missing(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr(films, "program_on_path", lambda _: None)
    monkeypatch.setattr(films, "import_module", missing)
    with pytest.raises(MissingPackageError, match=r"apt-get install ffmpeg.*\.gif or \.html"):
        animate(kart, sweep, tmp_path / "a.mp4")
    assert list(tmp_path.iterdir()) == []


def test_complaints_of_ffmpeg_are_shown(
    kart, sweep, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = tmp_path / "ffmpeg"
    broken.write_text("#!/bin/sh\necho 'Unknown encoder' >&2\nexit 1\n", encoding="utf-8")
    broken.chmod(0o755)
    monkeypatch.setattr(films, "program_on_path", lambda _: str(broken))
    with pytest.raises(OutputError, match="Unknown encoder"):
        animate(kart, sweep.isel(wheel_travel=[0, 8]), tmp_path / "a.mp4")
    assert [file.name for file in tmp_path.iterdir()] == ["ffmpeg"]


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_mp4_is_a_film(kart, sweep, tmp_path: Path) -> None:
    file = animate(kart, sweep.isel(wheel_travel=[0, 4, 8]), tmp_path / "a.mp4")
    assert file.read_bytes()[4:8] == b"ftyp"
