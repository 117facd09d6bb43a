"""OpenCRG courses with bends, options and modifiers; damage of all kinds."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.segments import Segments
from jounce.roads import Crg, read_crg_profile, road_library
from jounce.roads.measured import _add_mirror
from jounce.roads.profile import hermite_profile

FILES = Path(__file__).parents[2] / "files" / "road_crg"
ONE_INCH = road_library()["detrended_rms_course_1in"]


def with_block(folder: Path, name: str, block: str, **lines: float) -> Path:
    """Copy of a shipped text file with a block of options or modifiers."""
    text = (FILES / f"{name}.crg").read_text()
    place = text.index("$KD_Definition")
    body = "\n".join(f"{key.upper()} = {value}" for key, value in lines.items())
    file = folder / "edited.crg"
    file.write_text(f"{text[:place]}${block}\n{body}\n$!***\n{text[place:]}")
    return file


@pytest.mark.source(
    kind="program",
    of="files of other makers",
    key="asam-opencrg",
    where="crgEvaluv2z of its C library 2.0.1 on files that come with it",
    tolerance="single precision of the files",
    compares="heights beside a curved reference line",
)
@pytest.mark.parametrize(
    ("name", "v", "s", "z"),
    [  # path length and height by the C library of ASAM OpenCRG 2.0.1 (crgEvaluv2xy, crgEvaluv2z)
        ("handmade_curved", -1.25, 3.048567849, 0.010955545),
        ("handmade_curved", -1.25, 11.574476356, 0.006222216),
        ("handmade_curved", -1.25, 18.977172855, 0.010466656),
        ("handmade_curved", 0.4, 3.002938288, 0.011111100),
        ("handmade_curved", 0.4, 11.396967566, 0.020266647),
        ("handmade_curved", 0.4, 18.930744687, 0.028244417),
        ("handmade_curved_minimalist", 0.4, 11.396967566, 0.020266647),
        ("handmade_arc", -1.25, 12.449324775, 0.010955545),
        ("handmade_arc", -1.25, 48.891244648, 0.006222216),
        ("handmade_arc", -1.25, 79.847354487, 0.010466656),
        ("handmade_arc", 0.4, 11.930136072, 0.011111100),
        ("handmade_arc", 0.4, 44.758001713, 0.020266647),
        ("handmade_arc", 0.4, 74.462606564, 0.028244417),
        ("handmade_circle", -1.25, 33.755816302, 0.007911103),
        ("handmade_circle", 0.4, 32.599738783, 0.011111100),
        ("handmade_circle", 0.4, 123.585721458, 0.012444432),
        ("handmade_circle", 0.4, 204.599518736, 0.010399990),
    ],
)
def test_distance_and_height_beside_a_curved_line(name, v, s, z) -> None:
    assert Crg(file=FILES / f"{name}.crg", v=v).height_at(s) == pytest.approx(z, abs=2e-8)


@pytest.mark.parametrize("v", [-1.5, -0.3, 0.0, 0.8, 1.5])
@pytest.mark.parametrize("name", ["handmade_arc", "handmade_circle", "handmade_curved"])
def test_the_inner_side_of_a_bend_is_shorter(name, v) -> None:
    # corners lie on the bisectors: every turn by d between two pieces takes v tan(d/2) from each of them
    rows = [
        line
        for line in (FILES / f"{name}.crg").read_text().splitlines()
        if len(line) == 80 and line[0] != "$"
    ]
    heading = np.array([float(row[:10]) for row in rows if not row.startswith("*")])
    half = np.tan(0.5 * np.angle(np.exp(1j * np.diff(heading))))
    step = {"handmade_arc": 4.0, "handmade_circle": 10.0, "handmade_curved": 1.0}[name]
    lengths = step - v * (np.append(half, 0.0) + np.append(0.0, half))
    s, _ = read_crg_profile(FILES / f"{name}.crg", v)
    np.testing.assert_allclose(np.diff(s), lengths, rtol=0, atol=1e-9)


def test_a_fine_arc_has_the_length_of_an_arc(tmp_path) -> None:
    import pyopencrg

    angle = np.linspace(0.0, 1.2, 601)
    heading = 0.5 * (angle[:-1] + angle[1:])
    road = pyopencrg.CrgRoad(
        np.zeros((601, 3)), u_inc=30.0 * 1.2 / 600, v=[-2.0, 0.0, 2.0], heading=heading
    )
    road.save(tmp_path / "arc.crg", fmt="KDBI")
    for v in (-2.0, -1.0, 0.5, 2.0):  # radius 30 m to the left: ds = (1 - v / R) du
        assert Crg(file=tmp_path / "arc.crg", v=v).end() == pytest.approx(
            1.2 * (30.0 - v), rel=2e-4
        )


def test_an_offset_beyond_the_centre_of_a_bend_is_refused(tmp_path) -> None:
    file = with_block(tmp_path, "handmade_arc", "ROAD_CRG_OPTS", border_mode_v=2)
    assert Crg(file=file, v=3.0).end() == pytest.approx(78.2095, abs=1e-3)
    with pytest.raises(
        RecordingError, match=r"beyond the centre of a bend; found '8 m at u = \d+ m'"
    ):
        Crg(file=file, v=8.0)


def test_options_say_what_lies_beyond_the_ends(tmp_path) -> None:
    # the heights at v = 0: the reference line rises by 1.21 m; grid 0 at both ends
    x = np.array([-1.5, 23.5])
    cases = [
        ({}, [0.0, 1.21]),
        ({"border_mode_u": 1}, [0.0, 0.0]),
        ({"border_mode_u": 2, "border_offset_u": 0.3}, [0.3, 1.51]),
        ({"border_mode_u": 1, "border_offset_u": 0.3}, [0.3, 0.3]),
        ({"border_mode_u": 3}, None),
        ({"border_mode_u": 4}, None),
    ]
    inner = Crg(file=FILES / "handmade_sloped.crg")
    for options, expected in cases:
        road = Crg(file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", **options))
        assert road.end() == 22.0
        beyond = expected
        if beyond is None:
            mirrored = options["border_mode_u"] == 4
            beyond = inner.height_at([1.5, 20.5] if mirrored else [20.5, 1.5])
            at = np.linspace(0.1, 21.9, 219)
            np.testing.assert_allclose(
                road.height_at(44 + at), inner.height_at(at), rtol=0, atol=1e-12
            )
        np.testing.assert_allclose(road.height_at(x), beyond, rtol=0, atol=1e-9)
        np.testing.assert_allclose(
            road.height_at([3.3, 21.0]), inner.height_at([3.3, 21.0]), rtol=0, atol=1e-12
        )
    with pytest.raises(
        DescriptionError, match="the course repeats according to the file's options"
    ):
        Crg(
            file=with_block(tmp_path, "handmade_straight", "ROAD_CRG_OPTS", border_mode_u=3),
            recurrence=30.0,
        )


def test_a_course_that_ends_in_nothing(tmp_path) -> None:
    road = Crg(
        file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", border_mode_u=0), start="-2 m"
    )
    assert road.segments(20.0).edges[-1] == 20.0
    assert road.segments(20.0, behind=2.0).edges[-1] == 20.0  # from where the course begins
    with pytest.raises(
        DescriptionError,
        match=r"BORDER_MODE_U = 0 states that there is no road beyond its ends; found '0 to 21 m'",
    ):
        road.segments(21.0)
    with pytest.raises(DescriptionError, match="leaves the course"):
        road.segments(20.0, behind=2.5)


def test_options_say_what_lies_beside_the_grid(tmp_path) -> None:
    edge = Crg(file=FILES / "handmade_sloped.crg", v=1.5)
    x = np.linspace(0.0, 21.9, 100)
    for options, v, same in [
        ({"border_mode_v": 2}, 1.8, 1.5),
        ({"border_mode_v": 3}, 1.8, -1.2),
        ({"border_mode_v": 4}, 1.8, 1.2),
    ]:
        road = Crg(file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", **options), v=v)
        expected = Crg(file=FILES / "handmade_sloped.crg", v=same)
        np.testing.assert_allclose(road.height_at(x), expected.height_at(x), rtol=0, atol=1e-12)
    road = Crg(
        file=with_block(
            tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", border_mode_v=2, border_offset_v=0.1
        ),
        v=2,
    )
    np.testing.assert_allclose(road.height_at(x), edge.height_at(x) + 0.1, rtol=0, atol=1e-12)
    assert Crg(file=FILES / "handmade_sloped_opts.crg", v=2).height_at(5.5) == pytest.approx(
        edge.height_at(5.5)
    )
    with pytest.raises(RecordingError, match="outside the road"):
        Crg(file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", border_mode_v=0), v=1.8)
    with pytest.raises(RecordingError, match=r"outside the road.*Programs differ"):
        Crg(file=with_block(tmp_path, "handmade_banked", "ROAD_CRG_OPTS", border_mode_v=3), v=1.8)


def test_smoothed_ends_go_over_into_the_reference_line(tmp_path) -> None:
    rough = Crg(file=FILES / "handmade_sloped.crg", v=0.4)
    options = {"border_smooth_ubeg": 5.5, "border_smooth_uend": 2.3}
    road = Crg(file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", **options), v=0.4)
    u = np.linspace(0.0, 21.999, 2000)
    z = rough.height_at(u)
    weight = np.minimum(u / 5.5, 1.0)
    expected = weight * z  # the line begins at 0
    weight = np.minimum((22.0 - u) / 2.3, 1.0)
    expected = weight * (expected - 1.21) + 1.21  # and ends at 1.21 m
    np.testing.assert_allclose(road.height_at(u), expected, rtol=0, atol=1e-9)
    assert road.height_at([-3.0, 30.0]) == pytest.approx([0.0, 1.21], abs=1e-9)
    with pytest.raises(
        RecordingError, match="the smoothed ends overlap; found '12 m and 11 m of 22 m'"
    ):
        Crg(
            file=with_block(
                tmp_path,
                "handmade_sloped",
                "ROAD_CRG_OPTS",
                border_smooth_ubeg=12,
                border_smooth_uend=11,
            )
        )


def test_a_smoothed_course_is_mirrored_with_its_slopes(tmp_path) -> None:
    options = {"border_smooth_ubeg": 5.5, "border_smooth_uend": 2.3, "border_mode_u": 4}
    road = Crg(file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", **options), v=0.4)
    there = np.linspace(0.013, 21.987, 500)
    segments = road.segments(44.0)
    (height, slope), (mirrored, falling) = segments.evaluate(there), segments.evaluate(44.0 - there)
    np.testing.assert_allclose(mirrored, height, rtol=0, atol=1e-12)
    np.testing.assert_allclose(falling, -slope, rtol=0, atol=1e-12)
    cubic = hermite_profile(
        np.array([0.0, 1.0, 3.0]), np.array([0.0, 0.2, -0.1]), np.array([0.3, -0.4, 0.5])
    )
    both = _add_mirror(cubic)
    x = np.linspace(0.01, 2.99, 300)
    segments = Segments(both.edges, both.kind, both.coefficients)
    (height, slope), (mirrored, falling) = segments.evaluate(x), segments.evaluate(6.0 - x)
    np.testing.assert_allclose(mirrored, height, rtol=0, atol=1e-14)
    np.testing.assert_allclose(falling, -slope, rtol=0, atol=1e-14)


def test_a_closed_track_goes_round_and_round(tmp_path) -> None:
    file = with_block(tmp_path, "handmade_circle", "ROAD_CRG_OPTS", refline_continuation=1)
    road, lap = (
        Crg(file=file),
        240.0 + 2 * 4.4736683479398325,
    )  # both links by the C library: u from -4.47 to 244.47
    inner = Crg(file=FILES / "handmade_circle.crg")
    x = np.linspace(0.0, 239.9, 500)
    for k in (-1, 0, 2):
        np.testing.assert_allclose(
            road.height_at(x + k * lap), inner.height_at(x), rtol=0, atol=1e-9
        )
    assert road.height_at([241.0, 247.0]) == pytest.approx([0.0, 0.0], abs=1e-12)
    left = Crg(file=file, v=1.5)
    # 22 turns of 0.25 rad, one of 2 pi - 6, and 0.5 in the joint
    around = lap - 1.5 * 2.0 * (22 * np.tan(0.125) + np.tan((2 * np.pi - 6.0) / 2) + np.tan(0.25))
    assert left.profile().span == pytest.approx(around, abs=1e-6)
    with pytest.raises(RecordingError, match="the track is closed, but BORDER_MODE_U"):
        Crg(
            file=with_block(
                tmp_path,
                "handmade_circle",
                "ROAD_CRG_OPTS",
                refline_continuation=1,
                border_mode_u=0,
            )
        )
    open_track = with_block(tmp_path, "handmade_straight", "ROAD_CRG_OPTS", refline_continuation=1)
    assert Crg(file=open_track).height_at(50.0) == 0.0  # a straight line cannot be closed


def test_modifiers_scale_and_move(tmp_path) -> None:
    x = np.linspace(0.0, 21.9, 100)
    lines = {"scale_z_grid": 2, "scale_slope": 3, "refline_offset_z": 1}
    road = Crg(file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_MODS", **lines))
    grid, line = (
        Crg(file=FILES / f"handmade_{name}.crg").height_at(x) for name in ("straight", "sloped")
    )
    np.testing.assert_allclose(
        road.height_at(x), 1 + 2 * grid + 3 * (line - grid), rtol=0, atol=1e-9
    )
    long = Crg(file=with_block(tmp_path, "handmade_curved", "ROAD_CRG_MODS", scale_length=2))
    curved = Crg(file=FILES / "handmade_curved.crg")
    np.testing.assert_allclose(long.height_at(2 * x), curved.height_at(x), rtol=0, atol=1e-9)
    wide = Crg(
        file=with_block(tmp_path, "handmade_curved", "ROAD_CRG_MODS", scale_width=1.5), v=0.6
    )
    np.testing.assert_allclose(
        wide.profile().coefficients[:, 0],
        Crg(file=FILES / "handmade_curved.crg", v=0.4).profile().coefficients[:, 0],
        rtol=0,
        atol=1e-9,
    )
    # half the curvature: every turn is half as large
    bent = Crg(
        file=with_block(tmp_path, "handmade_arc", "ROAD_CRG_MODS", scale_curvature=0.5), v=1.0
    )
    turns = np.array([0.125] * 8 + [1.125] + [0.125] * 8)
    assert bent.end() == pytest.approx(88.0 - 2.0 * np.tan(0.25 * turns).sum(), abs=1e-6)
    raised = Crg(
        file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_MODS", refpoint_u=5, refpoint_z=2)
    )
    assert raised.height_at(5.0) == pytest.approx(2.0, abs=1e-9)


def test_gaps_are_filled_only_where_the_file_says_so(tmp_path) -> None:
    with pytest.raises(RecordingError, match="no height at u = 7 m"):
        Crg(file=FILES / "handmade_straight.crg", v=-1.3)
    file = with_block(
        tmp_path, "handmade_straight", "ROAD_CRG_MODS", grid_nan_mode=1, grid_nan_offset=0.1
    )
    # the gap at v = -1.5 becomes 0.1, the section at -1.0 is 0.0111111
    assert Crg(file=file, v=-1.3).height_at(7.0) == pytest.approx(
        0.6 * 0.1 + 0.4 * 0.0111111, abs=1e-9
    )
    file = with_block(tmp_path, "handmade_straight", "ROAD_CRG_MODS", grid_nan_mode=2)
    assert Crg(file=file, v=-1.3).height_at(7.0) == pytest.approx(0.0111111, abs=1e-9)


def test_a_file_may_refer_to_another_one(tmp_path) -> None:
    (tmp_path / "crg-txt").mkdir()
    (tmp_path / "crg-bin").mkdir()
    text = (FILES / "handmade_sloped.crg").read_text()
    (tmp_path / "crg-txt" / "handmade_curved_banked_sloped.crg").write_text(text)
    plain = Crg(file=FILES / "handmade_sloped.crg")
    for name in ("fileref", "fileref_mods", "fileref_opts"):
        (tmp_path / "crg-bin" / f"{name}.crg").write_bytes((FILES / f"{name}.crg").read_bytes())
        road = Crg(file=tmp_path / "crg-bin" / f"{name}.crg")
        assert road.height_at(12.5) == pytest.approx(plain.height_at(12.5), abs=1e-12)
    deep = tmp_path / "a" / "b" / "c"
    deep.mkdir(parents=True)
    (deep / "testOptionBorderMode.crg").write_bytes(
        (FILES / "testOptionBorderMode.crg").read_bytes()
    )
    with pytest.raises(RecordingError, match=r"does not exist: .*handmade_sloped_opt\.crg"):
        Crg(file=deep / "testOptionBorderMode.crg")
    (tmp_path / "crg-txt" / "handmade_sloped_opt.crg").write_text(text)
    bordered = Crg(file=deep / "testOptionBorderMode.crg")  # BORDER_OFFSET_U = 1
    assert bordered.height_at([-1.0, 30.0]) == pytest.approx([1.0, 2.21], abs=1e-9)


@pytest.mark.parametrize(
    "name", ["fileref", "fileref_mods", "fileref_opts", "testOptionBorderMode"]
)
def test_a_missing_file_that_is_referred_to_is_named(name) -> None:
    with pytest.raises(RecordingError, match=rf"{name}\.crg: .*does not exist: .*handmade_"):
        Crg(file=FILES / f"{name}.crg")


def data_of(content: bytes) -> int:
    start = content.index(b"\n$$$$") + 1
    return content.index(b"\n", start) + 1


def test_a_wrong_order_of_bytes_is_refused(tmp_path) -> None:
    content = ONE_INCH.read_bytes()
    start = data_of(content)
    swapped = np.frombuffer(content[start:], dtype=">f4").astype("<f4").tobytes()
    file = tmp_path / "swapped.crg"
    file.write_bytes(content[:start] + swapped)
    with pytest.raises(RecordingError, match=r"swapped\.crg: the OpenCRG file is damaged"):
        read_crg_profile(file)
    small = (
        np.where(np.frombuffer(content[start:], dtype=">f4") > 0.0, 0.011, 0.0)
        .astype("<f4")
        .tobytes()
    )
    file.write_bytes(content[:start] + small)  # only heights that become tiny, or huge
    with pytest.raises(RecordingError, match="damaged"):
        read_crg_profile(file)


def test_a_single_wild_height_is_refused(tmp_path) -> None:
    content = bytearray(ONE_INCH.read_bytes())
    hole = data_of(bytes(content)) + 12 * 5000
    content[hole : hole + 12] = np.array([40.0, 40.0, 40.0], dtype=">f4").tobytes()
    file = tmp_path / "spike.crg"
    file.write_bytes(content)
    with pytest.raises(RecordingError, match=r"a single height at u = 250 m stands out by 40 m"):
        read_crg_profile(file)


@pytest.mark.parametrize("name", ["detrended_rms_course_1in", "handmade_sloped", "handmade_arc"])
def test_turned_bits_never_give_garbage(tmp_path, name) -> None:
    original = road_library().get(name, FILES / f"{name}.crg")
    content, (s, height) = original.read_bytes(), read_crg_profile(original)
    start, random, file = data_of(content), np.random.default_rng(7), tmp_path / "turned.crg"
    refused = 0
    for trial in range(120):
        turned = bytearray(content)
        place = int(random.integers(start) if trial % 2 else random.integers(start, len(content)))
        turned[place] ^= 1 << int(random.integers(8))
        file.write_bytes(turned)
        try:
            found = read_crg_profile(file)
        except JounceError as error:
            refused += "\n" not in str(error)
            continue
        assert np.isfinite(found[1]).all()
        assert len(found[0]) == len(s)
        assert np.allclose(found[0], s, atol=0.5)
        # what cannot be told from a height is one height, or one slope that all later ones follow
        steps = np.abs(np.diff(found[1] - height))
        assert (steps > 1e-6).sum() <= 3
        assert steps.max() <= 4.0
    assert refused > 10


@pytest.mark.parametrize("keep", [0.05, 0.3, 0.5, 0.9, 0.995])
def test_truncated_text_is_refused(tmp_path, keep) -> None:
    text = (FILES / "handmade_curved.crg").read_bytes()
    file = tmp_path / "cut.crg"
    file.write_bytes(text[: int(keep * len(text))])
    with pytest.raises(RecordingError, match=r"cut\.crg"):
        read_crg_profile(file)


def test_misspelt_channels_and_keywords_are_refused(tmp_path) -> None:
    text = (FILES / "handmade_sloped.crg").read_text()
    file = tmp_path / "misspelt.crg"
    for right, wrong in [
        ("D:reference line slope", "D:reference line slpoe"),
        ("D:long section at v =  0.000", "D:long sektion at v =  0.000"),
        ("REFERENCE_LINE_INCREMENT", "REFERENCE_LINE_INCREMNT"),
    ]:
        assert right in text
        file.write_text(text.replace(right, wrong))
        with pytest.raises(RecordingError, match="damaged or contradicts itself: unknown"):
            read_crg_profile(file)
    file.write_text(text.replace(" 0.0110000", " 1.0110000", 1))
    with pytest.raises(RecordingError, match=r"slope above 100 %"):
        read_crg_profile(file)


@pytest.mark.parametrize(
    ("option", "value"), [("border_mode_u", 7), ("border_mode_u", "two"), ("check_eps", -1)]
)
def test_wrong_options_are_refused(tmp_path, option, value) -> None:
    with pytest.raises(RecordingError, match="damaged or contradicts itself"):
        Crg(file=with_block(tmp_path, "handmade_sloped", "ROAD_CRG_OPTS", **{option: value}))
