"""OpenCRG courses: measured facts, handmade geometry, damage."""

from __future__ import annotations

import shutil
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.roads import Crg, read_crg_profile, road_library
from jounce.roads.measured import _overlong_rows

FILES = Path(__file__).parents[2] / "files" / "road_crg"
ONE_INCH = road_library()["detrended_rms_course_1in"]
INCH = 0.0254


@pytest.mark.source(
    kind="measured",
    of="files of other makers",
    key="project-chrono",
    where="roads of 1 in and 3 in RMS, the roughness that their headers print",
    tolerance="the headers are of the surveys before resampling; 1.5 % is asked for",
    compares="roughness of measured roads as read from OpenCRG files",
)
@pytest.mark.parametrize(
    ("file", "recomputed", "header"),
    [
        (ONE_INCH, 0.95732, 0.96944),  # header comment "Detrended RMS = 0.96944 in"
        (
            FILES / "detrended_rms_course_3in.crg",
            2.31545,
            2.3164,
        ),  # header comment "Detrended RMS = 2.3164 in"
    ],
)
def test_the_measured_courses_have_the_roughness_their_headers_say(
    file, recomputed, header
) -> None:
    u, z = read_crg_profile(file)
    undulated = (u >= 100.0) & (u <= 404.8)  # header: starts at 100 m, 304.8 m long
    rms = np.sqrt(np.mean(z[undulated] ** 2)) / INCH
    assert rms == pytest.approx(recomputed, abs=2e-5)
    assert rms == pytest.approx(
        header, rel=0.015
    )  # the header is of the source file, before resampling
    assert not z[~undulated].any()
    assert u[-1] == pytest.approx(504.75, abs=1e-9)
    assert (
        len(u) == 10096
    )  # 504.75 m / 0.05 m + 1: the NaN that pad the last 80 bytes are no heights


def test_binary_heights_are_those_in_the_file() -> None:
    content = ONE_INCH.read_bytes()
    data = content[content.index(b"\n$$$$") + 1 :]
    data = data[data.index(b"\n") + 1 :]
    raw = np.frombuffer(data, dtype=">f4").astype(float)
    assert np.isnan(raw[10096 * 3 :]).all()
    grid = raw[: 10096 * 3].reshape(10096, 3)
    for v, column in ((-3.0, 0), (0.0, 1), (3.0, 2)):
        np.testing.assert_array_equal(read_crg_profile(ONE_INCH, v)[1], grid[:, column])
    np.testing.assert_allclose(
        read_crg_profile(ONE_INCH, 1.5)[1], 0.5 * (grid[:, 1] + grid[:, 2]), rtol=0, atol=1e-16
    )


def test_the_halfround_obstacle_is_four_inches_high() -> None:
    road = Crg(file=FILES / "halfround_4in.crg", start="-49 m")
    x = np.linspace(0.0, 5.0, 5001)
    z = road.height_at(x)
    assert z.max() == pytest.approx(
        4 * INCH, rel=2e-4
    )  # sampled at 10 mm: the crest lies between two samples
    assert x[z > 0][[0, -1]] == pytest.approx([1.0, 1.21], abs=0.01)
    assert z[0] == 0.0


@pytest.mark.parametrize(
    "name", ["handmade_straight", "handmade_straight_minimalist", "handmade_straight_double"]
)
def test_handmade_text_files(name) -> None:
    u, z = read_crg_profile(FILES / f"{name}.crg")
    np.testing.assert_array_equal(u, np.arange(23.0))
    # column "long section 4" (v = 0) of the file, in units of 1/90 m
    ninetieths = [0, 1, 1, 1, 1, 1, 0, 0, 0, 1, 2, 2, 2, 1, 0, 0, 0, 1, 2, 3, 2, 1, 0]
    np.testing.assert_allclose(z, np.array(ninetieths) / 90, rtol=0, atol=1.2e-7)
    # halfway between v = 0 and v = 0.5 (section 5: row 1 is 0, row 2 is 1/90)
    between = read_crg_profile(FILES / f"{name}.crg", 0.25)[1]
    np.testing.assert_allclose(between[1:3], [0.5 / 90, 1 / 90], rtol=0, atol=1.2e-7)


def test_slope_of_the_reference_line_is_integrated() -> None:
    _, z = read_crg_profile(FILES / "handmade_sloped.crg")
    level = read_crg_profile(FILES / "handmade_straight.crg")[1]
    slope = 0.011 * np.array([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0])
    np.testing.assert_allclose(
        z - level, np.concatenate([[0], np.cumsum(slope)]), rtol=0, atol=1e-12
    )


def test_banking_raises_the_left_and_lowers_the_right() -> None:
    file = FILES / "handmade_banked.crg"
    banking = 0.011 * np.array(
        [0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0]
    )
    level = FILES / "handmade_straight.crg"
    # the same sections 2 to 6 lie at other offsets in the two files
    for v, v_level in ((-1.25, -1.0), (-1.0, -0.5), (0.0, 0.0), (1.0, 0.5), (1.25, 1.0)):
        expected = read_crg_profile(level, v_level)[1] + banking * v
        np.testing.assert_allclose(read_crg_profile(file, v)[1], expected, rtol=0, atol=1e-12)


@pytest.mark.source(
    kind="program",
    of="files of other makers",
    key="asam-opencrg",
    where="pyopencrg on files of ASAM OpenCRG",
    tolerance="double precision",
    compares="heights along straight, banked and sloped roads",
)
@pytest.mark.parametrize(
    ("name", "v"), [("handmade_banked", 0.3), ("handmade_sloped", -1.4), ("halfround_4in", 0.7)]
)
def test_agrees_with_the_evaluation_of_pyopencrg(name, v) -> None:
    import pyopencrg

    road = pyopencrg.read(FILES / f"{name}.crg")
    u = np.linspace(0.0, road.length, 3000)[1:-1]
    np.testing.assert_allclose(
        Crg(file=FILES / f"{name}.crg", v=v).height_at(u), road.uv_to_z(u, v), rtol=0, atol=1e-9
    )


def test_modifiers_of_the_file_are_applied(tmp_path) -> None:
    text = (FILES / "handmade_straight.crg").read_text()
    file = tmp_path / "scaled.crg"
    file.write_text(f"$ROAD_CRG_MODS\nSCALE_Z_GRID = 2.0\n$\n{text}")
    np.testing.assert_allclose(
        read_crg_profile(file)[1],
        2.0 * read_crg_profile(FILES / "handmade_straight.crg")[1],
        rtol=0,
        atol=1e-12,
    )


def test_a_course_is_held_at_its_last_height_and_says_where_it_ends() -> None:
    road = Crg(file=ONE_INCH, start="2 m")
    assert road.end() == pytest.approx(506.75, abs=1e-9)
    assert road.segments(600.0).edges[-2] == pytest.approx(506.75, abs=1e-9)
    assert road.height_at(600.0) == road.height_at(506.75)
    assert road.segments(50.0).edges.tolist() == [0.0, 2.0, 50.0]  # the level run-up is one piece


@pytest.mark.parametrize(
    ("name", "v", "says"),
    [
        ("fileref.crg", 0.0, r"handmade_curved_banked_sloped\.crg"),
        ("handmade_straight.crg", 1.6, "outside the road; found '1.6 m'; allowed: -1.5 to 1.5 m"),
        ("handmade_straight.crg", -1.2, r"no height at u = 7 m for the lateral offset -1\.2 m"),
        ("none.crg", 0.0, "no such file"),
    ],
)
def test_refuses_what_it_cannot_represent(name, v, says) -> None:
    with pytest.raises(RecordingError, match=says):
        Crg(file=FILES / name, v=v)


@pytest.mark.parametrize(
    "cut",
    [1, 2, 3, 4, 79, 80, 160, 8000, 60_000, 121_000, 122_500, 122_836],
)
def test_a_truncated_binary_is_refused_in_one_message(tmp_path, cut) -> None:
    file = tmp_path / "cut.crg"
    file.write_bytes(ONE_INCH.read_bytes()[:-cut])
    with pytest.raises(RecordingError, match=r"cut\.crg: ") as caught:
        read_crg_profile(file)
    assert "\n" not in str(caught.value)


def test_damage_is_refused(tmp_path) -> None:
    content = bytearray(ONE_INCH.read_bytes())
    file = tmp_path / "damaged.crg"
    file.write_bytes(content[:60_000] + content[60_001:])  # one byte lost
    with pytest.raises(
        RecordingError, match="damaged or contradicts itself: size of the binary data"
    ):
        read_crg_profile(file)
    start = content.index(b"\n$$$$") + 1
    start = content.index(b"\n", start) + 1
    hole = start + 12 * 5000
    file.write_bytes(content[:hole] + bytes.fromhex("7fc00000") * 3 + content[hole + 12 :])
    with pytest.raises(RecordingError, match=r"damaged\.crg"):
        read_crg_profile(file)
    file.write_bytes(content[:hole] + bytes.fromhex("7f000000") * 3 + content[hole + 12 :])
    with pytest.raises(RecordingError, match="heights above 10 km"):
        read_crg_profile(file)
    file.write_text("x,z\n0,1\n")
    with pytest.raises(RecordingError, match="not a readable OpenCRG file"):
        read_crg_profile(file)
    file.write_text("")
    with pytest.raises(RecordingError, match="not a readable OpenCRG file"):
        read_crg_profile(file)


def test_contradictions_are_refused_not_guessed(tmp_path) -> None:
    text = (FILES / "handmade_sloped.crg").read_text()
    file = tmp_path / "edited.crg"
    file.write_text(
        text.replace("REFERENCE_LINE_END_U     = 22.0", "REFERENCE_LINE_END_U     = 44.0")
    )
    with pytest.raises(
        RecordingError, match="header u range gives 45 cross sections but the file has 23"
    ):
        read_crg_profile(file)
    file.write_text(
        "\n".join(
            line for line in text.splitlines() if not line.startswith("D:reference line slope")
        )
    )
    with pytest.raises(RecordingError, match="row 1 of the data holds more than the 7 channels"):
        read_crg_profile(file)
    file.write_text(text.replace("0.0111111", "0.01O1111", 1))
    with pytest.raises(RecordingError, match="unreadable"):
        read_crg_profile(file)


def test_a_replaced_file_is_read_again(tmp_path) -> None:
    file = tmp_path / "course.crg"
    shutil.copy(FILES / "handmade_straight.crg", file)
    road = Crg(file=file)
    assert road.end() == 22.0
    shutil.copy(FILES / "halfround_4in.crg", file)
    assert road.end() == pytest.approx(100.0, abs=1e-9)


def test_the_lateral_offset_chooses_the_track() -> None:
    left, right = (Crg(file=FILES / "handmade_straight.crg", v=v) for v in ("1 m", "-1 m"))
    assert left.height_at(6.0) == pytest.approx(1 / 90, abs=1e-6)  # section 6, row 7: 0.0111111
    assert right.height_at(15.0) == pytest.approx(1 / 90, abs=1e-6)  # section 2, row 16: 0.0111111
    assert left.height_at(15.0) == pytest.approx(-2 / 90, abs=1e-6)


@pytest.mark.parametrize(("channels", "longest"), [(3, 30), (8, 80), (11, 80)])
def test_rows_that_hold_more_than_the_header_says(
    tmp_path, monkeypatch, channels: int, longest: int
) -> None:
    """Ten columns a value, and eighty a row, over which the values of many channels go on."""
    import pyopencrg.io

    header = SimpleNamespace(fmt="LRFI", kd_def=["D:long section"] * channels, data_offset=0)
    monkeypatch.setattr(pyopencrg.io, "read_ipl", lambda *_, **__: header)
    file = tmp_path / "rows.crg"
    file.write_text(f"{'1' * longest}\n{'2' * longest}   \n")
    assert _overlong_rows(str(file)) == []
    file.write_text(f"{'1' * longest}\n{'2' * (longest + 1)}\n")
    assert _overlong_rows(str(file)) == [
        f"row 2 of the data holds more than the {channels} channels of the header"
    ]
