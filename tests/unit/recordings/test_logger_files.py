"""Files of test rigs and race loggers: RPC III, MoTeC, VBO, AiM, Race Technology, Sufni."""

from __future__ import annotations

from pathlib import Path

import logger_files
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import jounce as jn
from jounce.core.errors import JounceError, OutputError, RecordingError
from jounce.recordings import Sensor, read_recording
from jounce.recordings.reader import ReaderOptions
from jounce.recordings.readers import read_signals
from jounce.recordings.vbox import crossings

TIME = np.arange(400) / 200.0
STROKE = 12.0 * np.sin(9.0 * TIME) + 0.1 * TIME
FORCE = 0.9 + 0.3 * np.cos(9.0 * TIME)
CHANNELS = (("strut.stroke", "mm", STROKE), ("strut.force", "kN", FORCE))
SCALES = [12.3 / 32752, 1.2 / 32752]


def codes(findings: list[jn.Finding]) -> list[str]:
    return [finding.code.removeprefix("recordings.") for finding in findings]


# --- RPC III


@pytest.mark.parametrize(
    "form", ["BINARY", "BINARY_IEEE_LITTLE_END", "BINARY_IEEE_BIG_END", "ASCII"]
)
@pytest.mark.parametrize("kind", ["FLOATING_POINT", "SHORT_INTEGER"])
@pytest.mark.parametrize(("frame", "group"), [(64, 64), (64, 128), (256, 1024), (512, 512)])
def test_rpc_of_every_layout(tmp_path: Path, form: str, kind: str, frame: int, group: int) -> None:
    file = tmp_path / "run.rsp"
    scales = SCALES if kind == "SHORT_INTEGER" else []
    file.write_bytes(
        logger_files.rpc_file(
            CHANNELS,
            0.005,
            kind=kind,
            form=form,
            frame=frame,
            group=group,
            scales=scales,
            extra={"SAMPLES": 400},
        )
    )
    run, findings = read_recording(file)
    assert findings == []
    within = 0.5 * SCALES[0] * 1e-3 if scales else 6e-8 * 12.3e-3
    np.testing.assert_allclose(run["strut.stroke"], 1e-3 * STROKE, rtol=0.0, atol=1.001 * within)
    np.testing.assert_allclose(run["strut.force"], 1e3 * FORCE, rtol=0.0, atol=1e3 * SCALES[1])
    np.testing.assert_allclose(run["time"], TIME, rtol=0.0, atol=1e-15)
    assert run.attrs["date"] == "22-Feb-2000 10:20:11"


def test_rpc_header_as_lines_of_text(tmp_path: Path) -> None:
    file = tmp_path / "run.tim"
    file.write_bytes(
        logger_files.rpc_file(CHANNELS, 0.005, form="ASCII", lines=True, extra={"SAMPLES": 400})
    )
    run, findings = read_recording(file)
    assert findings == []
    np.testing.assert_allclose(run["strut.stroke"], 1e-3 * STROKE, rtol=1e-12)


@pytest.mark.parametrize("padding", ["last", "zeros"])
def test_rpc_padding_of_the_last_frame_is_left_out_with_a_note(
    tmp_path: Path, padding: str
) -> None:
    file = tmp_path / "run.rsp"
    file.write_bytes(logger_files.rpc_file(CHANNELS, 0.005, frame=256, group=512, padding=padding))
    run, findings = read_recording(file)
    assert codes(findings) == ["padding"]
    assert findings[0].value == 112
    assert run.sizes["time"] == 400


def test_rpc_short_last_group_and_cut_off_groups(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"
    file.write_bytes(logger_files.rpc_file(CHANNELS, 0.005, frame=16, group=128, full=False))
    run, findings = read_recording(file)
    assert codes(findings) == ["short_group"]
    assert run.sizes["time"] == 400
    np.testing.assert_allclose(run["strut.force"], 1e3 * FORCE, rtol=1e-7)
    whole = logger_files.rpc_file(CHANNELS, 0.005, frame=64, group=128, extra={"SAMPLES": 400})
    file.write_bytes(whole[:-1])
    run, findings = read_recording(file)
    assert (codes(findings), run.sizes["time"]) == (["cut_off"], 384)
    np.testing.assert_allclose(run["strut.force"], 1e3 * FORCE[:384], rtol=1e-7)
    file.write_bytes(whole + b"more")
    assert codes(read_recording(file)[1]) == ["bytes_left"]


def test_rpc_half_frames_are_read_and_reported(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"
    content = logger_files.rpc_file(
        CHANNELS, 0.005, frame=16, group=16, extra={"HALF_FRAMES": "YES", "SAMPLES": 400}
    )
    file.write_bytes(
        content.replace(b"FRAMES".ljust(32, b"\0") + b"25", b"FRAMES".ljust(32, b"\0") + b"24")
    )
    run, findings = read_recording(file)
    assert (codes(findings), run.sizes["time"]) == (["half_frames"], 400)


def test_rpc_channels_without_name_or_unit_or_with_one_name(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"
    channels = [
        ("", "NONE", STROKE),
        ('"Left axis"', "mm", STROKE),
        ("z", "mm", STROKE),
        ("z", "N", FORCE),
    ]
    file.write_bytes(logger_files.rpc_file(channels, 0.005))
    table = read_signals(file, ReaderOptions()).columns
    assert [column.label for column in table] == [
        "time [s]", "channel 1", "Left axis [mm]", "z (3) [mm]", "z (4) [N]",
    ]  # fmt: skip
    run, _ = read_recording(file, columns={"strut.stroke": "channel 1 [mm]"})
    np.testing.assert_allclose(run["strut.stroke"][:400], 1e-3 * STROKE, rtol=1e-6, atol=1e-12)


@pytest.mark.parametrize("scale", ["nan", "0", "x", "1_0", ""])
def test_rpc_wrong_scale_is_the_fault_of_its_channel(tmp_path: Path, scale: str) -> None:
    file = tmp_path / "run.rsp"
    extra = {"SCALE.CHAN_1": scale, "SAMPLES": 400}
    content = logger_files.rpc_file(
        CHANNELS, 0.005, kind="SHORT_INTEGER", scales=SCALES, extra=extra
    )
    file.write_bytes(content)
    with pytest.raises(RecordingError, match=r"run\.rsp: SCALE\.CHAN_1"):
        read_recording(file)
    columns, _ = jn.read_columns(file, {"strut.force": "N"})
    np.testing.assert_allclose(columns["strut.force"], 1e3 * FORCE, atol=1e3 * SCALES[1])


def test_rpc_scale_of_floats_is_reported(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"
    extra = {"SCALE.CHAN_1": "2.0", "SAMPLES": 400}
    file.write_bytes(logger_files.rpc_file(CHANNELS, 0.005, extra=extra))
    assert codes(read_recording(file)[1]) == ["scale_of_floats"]


@pytest.mark.parametrize(
    ("key", "value", "says"),
    [
        ("FORMAT", "VAX", r"a kind that jounce does not read; found 'VAX'"),
        ("FILE_TYPE", "MATRIX", r"FILE_TYPE: an RPC III file of a kind"),
        ("DATA_TYPE", "COMPLEX", r"DATA_TYPE: an RPC III file of a kind"),
        ("CHANNELS", "0", r"CHANNELS: an impossible count"),
        ("CHANNELS", "99999999999", r"CHANNELS: an impossible count"),
        ("CHANNELS", "900", r"none of the samples that it declares"),
        ("FRAMES", "-1", r"FRAMES: an impossible count"),
        ("FRAMES", "1.5", r"FRAMES: an impossible count"),
        ("PTS_PER_GROUP", "100", r"a group does not consist of whole frames"),
        ("PTS_PER_GROUP", "2147483647", r"impossible count|whole frames|none of the samples"),
        ("DELTA_T", "0", r"DELTA_T: the sample time is not positive"),
        ("DELTA_T", "inf", r"DELTA_T: not a finite number"),
        ("NUM_HEADER_BLOCKS", "5000", r"NUM_HEADER_BLOCKS: an impossible count"),
        ("NUM_PARAMS", "9999", r"NUM_PARAMS: an impossible count"),
    ],
)
def test_rpc_damaged_headers_are_refused(tmp_path: Path, key: str, value: str, says: str) -> None:
    content = logger_files.rpc_file(CHANNELS, 0.005)
    at = content.index(key.encode() + b"\0") + 32
    file = tmp_path / "run.rsp"
    file.write_bytes(content[:at] + value.encode().ljust(96, b"\0") + content[at + 96 :])
    with pytest.raises(RecordingError, match=says):
        read_recording(file)


def test_rpc_other_files_and_missing_keywords_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"
    file.write_bytes(b"MATLAB 5.0" + bytes(600))
    with pytest.raises(RecordingError, match=r"not an RPC III file; found 'MATLAB 5\.0"):
        read_recording(file)
    content = logger_files.rpc_file(CHANNELS, 0.005)
    file.write_bytes(content.replace(b"DELTA_T", b"DELTA_U"))
    with pytest.raises(RecordingError, match=r"the header has no DELTA_T.*Is the file complete"):
        read_recording(file)
    rows = "\n".join(f"{x} {f}" for x, f in zip(STROKE, FORCE, strict=True)).encode() + b"\n"
    head = logger_files.rpc_file(CHANNELS, 0.005, form="ASCII", lines=True).split(
        b"SCALE.CHAN_2 1.0\n"
    )[0]
    file.write_bytes(head + b"SCALE.CHAN_2 1.0\n" + rows)
    with pytest.raises(RecordingError, match="rows of samples, or groups"):
        read_recording(file)


NUMBERS = hnp.arrays(np.float32, st.tuples(st.integers(1, 4), st.integers(8, 700)),
                     elements=st.floats(-1e6, 1e6, width=32))  # fmt: skip


@settings(max_examples=40, deadline=None)
@given(values=NUMBERS, rate=st.integers(1, 5000), start=st.sampled_from([0.0, -2.5, 17.0]))
def test_rpc_floats_come_back_bit_by_bit(tmp_path_factory, values, rate, start) -> None:
    file = tmp_path_factory.mktemp("rpc") / "run.rsp"
    time = start + np.arange(values.shape[1]) / rate
    run = jn.recording(
        time, {f"p{i}.tyre.force": (row.astype(float), "N", "") for i, row in enumerate(values)}
    )
    assert set(jn.write_rpc(run, file).values()) == {0.0}
    again = read_signals(file, ReaderOptions()).columns
    np.testing.assert_allclose(again["time"].values, time, rtol=0.0, atol=1e-9 / rate)
    for i, row in enumerate(values):
        assert again[f"p{i}.tyre.force"].values.tobytes() == row.astype(float).tobytes()


@settings(max_examples=40, deadline=None)
@given(values=NUMBERS)
def test_rpc_integers_are_within_half_a_step_as_stated(tmp_path_factory, values) -> None:
    file = tmp_path_factory.mktemp("rpc") / "run.rsp"
    rows = {f"p{i}.tyre.force": (row.astype(float), "N", "") for i, row in enumerate(values)}
    run = jn.recording(np.arange(values.shape[1]) * 0.001, rows)
    stated = jn.write_rpc(run, file, integers=True)
    again = read_signals(file, ReaderOptions()).columns
    for name, (row, _, _) in rows.items():
        error = float(np.abs(again[name].values - row).max())
        assert error == stated[name]
        assert error <= 0.5001 * np.abs(row).max() / 32752


def test_rpc_what_cannot_be_written_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"

    def run(values: np.ndarray = STROKE, name: str = "tyre.force", time: np.ndarray = TIME):
        return jn.recording(time, {name: (values, "N", "")})

    for given_run, says in (
        (run(np.where(TIME > 1.0, np.nan, STROKE)), "only finite numbers"),
        (run(1e39 * STROKE), "a number that the file cannot store"),
        (run(name="x" * 100 + ".force"), "up to 95 Latin letters"),
        (run(name="дуга.force"), "up to 95 Latin letters"),
        (run(time=TIME**2), "the time steps are not uniform"),
        (
            jn.recording(TIME, {f"p{i}.force": (STROKE, "N", "") for i in range(129)}),
            "more channels",
        ),
    ):
        with pytest.raises(OutputError, match=says):
            jn.write_rpc(given_run, file)
    with pytest.raises(OutputError, match=r"\.rsp"):
        jn.write_rpc(run(), tmp_path / "run.txt")
    jn.write_rpc(run(), file)
    with pytest.raises(OutputError, match="exists"):
        jn.write_rpc(run(), file)


def test_rpc3_file_reads_what_jounce_writes(tmp_path: Path) -> None:
    rpc3 = pytest.importorskip("rpc3")
    rpc3.progressbar = False
    run = jn.recording(
        TIME, {"tyre.force": (1e3 * FORCE, "N", ""), "tyre.az": (STROKE, "m/s^2", "")}
    )
    for integers in (False, True):
        errors = jn.write_rpc(run, tmp_path / "run.rsp", integers=integers, force=True)
        channels, _ = rpc3.read(str(tmp_path / "run.rsp"))
        assert [(one.name, one.unit, one.dt) for one in channels] == [
            ("tyre.force", "N", 0.005), ("tyre.az", "m/s^2", 0.005),
        ]  # fmt: skip
        for one in channels:
            truth = run[one.name].to_numpy()
            bound = errors[one.name] + 1e-7 * np.abs(truth).max()  # it gives single precision
            assert np.abs(one.data - truth).max() <= bound


def test_rpc_reader_reads_what_jounce_writes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    reader = pytest.importorskip("rpc_reader.rpc_reader")
    run = jn.recording(
        TIME, {"tyre.force": (1e3 * FORCE, "N", ""), "tyre.az": (STROKE, "m/s^2", "")}
    )
    for integers in (False, True):
        errors = jn.write_rpc(run, tmp_path / "run.rsp", integers=integers, force=True)
        read = reader.ReadRPC(tmp_path / "run.rsp")
        read.import_rpc_data_from_file()
        factor = 32752 / 32768 if integers else 1.0  # it scales integers in a different way
        for k, name in enumerate(run.data_vars):
            values = read.get_data()[:400, k] / factor
            np.testing.assert_allclose(values, run[name], rtol=0.0, atol=1.001 * errors[name])


def text_file(written: str, number: str) -> bytes:
    """An ASCII file with a number replaced."""
    content = logger_files.rpc_file(CHANNELS, 0.005, form="ASCII", extra={"SAMPLES": 400})
    assert content.count(written.encode()) == 1
    return content.replace(written.encode(), number.encode())


@pytest.mark.parametrize("number", ["1,5", "1_0", '"5"', "-", "0x1"])
def test_rpc_text_that_is_no_number_is_refused(tmp_path: Path, number: str) -> None:
    """A decimal comma must not become two numbers: all later samples would be in the wrong place."""
    file = tmp_path / "run.rsp"
    file.write_bytes(text_file(repr(float(FORCE[7])), number))
    with pytest.raises(RecordingError, match="text in a number column") as caught:
        read_recording(file)
    assert f"found {number!r}" in str(caught.value)


def test_rpc_samples_are_in_the_last_frame(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"
    content = logger_files.rpc_file(CHANNELS, 0.005, frame=64, group=128, extra={"SAMPLES": 300})
    file.write_bytes(content)
    with pytest.raises(RecordingError, match=r"SAMPLES: an impossible count.*allowed: 385 to 448"):
        read_recording(file)


def test_rpc_rest_of_more_than_a_frame_belongs_to_the_record(tmp_path: Path) -> None:
    file = tmp_path / "run.rsp"
    rest = [
        (name, unit, np.where(TIME < 1.0, values, values[200])) for name, unit, values in CHANNELS
    ]
    file.write_bytes(logger_files.rpc_file(rest, 0.005, frame=40, group=40))
    run, findings = read_recording(file)
    assert "padding" not in codes(findings)
    assert run.sizes["time"] == 400


# --- MoTeC

SLOW = np.arange(40) * 2.0
LD = (
    ("Damper Pos FL", "mm", 200, (7, 4), STROKE),
    ("Damper Force FL", "N", 200, (5, 4), np.round(1e3 * FORCE)),
    ("Brake", "bar", 200, (3, 2), np.arange(400)),
    ("Oil Temp", "C", 20, (3, 2), SLOW),
)
MAPPED = {"front_left.strut.stroke": "Damper Pos FL", "front_left.strut.force": "Damper Force FL"}


def test_motec_channels_of_two_rates_and_laps(tmp_path: Path) -> None:
    file = tmp_path / "outing.ld"
    texts = {94: b"23/11/2026", 126: b"16:20:35", 158: b"A. Driver", 350: b"Interlagos"}
    file.write_bytes(logger_files.ld_file(LD, numbers={"Brake": (3, 2, 4, 1)}, texts=texts))
    laps = [("Lap 2", 1.5), ("Lap 1", 0.25)]
    (tmp_path / "outing.ldx").write_text(logger_files.ldx_text(laps))
    signals = read_signals(file, ReaderOptions())
    assert [[column.label for column in table] for table in signals.tables] == [
        ["time [s]", "Damper Pos FL [mm]", "Damper Force FL [N]", "Brake [bar]"],
        ["time [s]", "Oil Temp [C]"],
    ]
    np.testing.assert_allclose(signals.columns["Brake"].values, (np.arange(400) / 4 * 0.1 + 3) * 2)
    np.testing.assert_allclose(signals.others[0]["time"].values, np.arange(40) / 20.0)
    run, findings = read_recording(file, columns=MAPPED)
    assert all(finding.severity == "note" for finding in findings)
    np.testing.assert_allclose(run["front_left.strut.stroke"], 1e-3 * STROKE, rtol=1e-6, atol=1e-9)
    assert (run.attrs["driver"], run.attrs["venue"]) == ("A. Driver", "Interlagos")
    np.testing.assert_allclose(run.attrs["beacons"], [0.25, 1.5])
    assert run.attrs["beacon_names"] == "Lap 1; Lap 2"
    np.testing.assert_allclose(jn.find_laps(run), [[0.25, 1.5]])
    again, _ = read_recording(jn.write_recording(run, tmp_path / "again.nc"))
    np.testing.assert_allclose(jn.find_laps(again), [[0.25, 1.5]])


def test_motec_markers_that_cannot_be_read_are_a_finding(tmp_path: Path) -> None:
    file = tmp_path / "outing.ld"
    file.write_bytes(logger_files.ld_file(LD))
    whole = logger_files.ldx_text([("", 1.0)])
    for text in (whole[:120], whole.replace("Time=", "When="), whole.replace('Time="', 'Time="x'),
                 "<!DOCTYPE a [<!ENTITY b 'c'>]>" + whole.partition("?>")[2]):  # fmt: skip
        (tmp_path / "outing.ldx").write_text(text)
        run, findings = read_recording(file, columns=MAPPED)
        assert codes(findings)[0] == "no_beacons"
        assert "beacons" not in run.attrs
    (tmp_path / "outing.ldx").write_text(logger_files.ldx_text([]))
    run, findings = read_recording(file, columns=MAPPED)
    assert "no_beacons" not in codes(findings)


def test_motec_units_in_the_field_of_short_names_are_taken_with_a_note(tmp_path: Path) -> None:
    file, unit = tmp_path / "outing.ld", 1762 + 64
    content = logger_files.ld_file([(*LD[0][:1], "", *LD[0][2:]), LD[1]])
    file.write_bytes(content)
    assert read_signals(file, ReaderOptions()).columns[1].unit == ""
    file.write_bytes(content[:unit] + b"mm".ljust(8, b"\0") + content[unit + 8 :])
    run, findings = read_recording(file, columns=MAPPED)
    assert codes(findings) == ["units_in_short_names"]
    np.testing.assert_allclose(run["front_left.strut.stroke"], 1e-3 * STROKE, rtol=1e-6, atol=1e-9)


def replaced(content: bytes, at: int, value: int, width: int = 4) -> bytes:
    return content[:at] + value.to_bytes(width, "little") + content[at + width :]


def test_motec_damaged_lists_keep_the_channels_before(tmp_path: Path) -> None:
    file, first = tmp_path / "outing.ld", 1762
    content = logger_files.ld_file(LD)
    for value, code in ((first, "list_loops"), (first + 124, "list_loops"), (2**31, "list_ends"),
                        (len(content) - 10, "list_ends")):  # fmt: skip
        file.write_bytes(replaced(content, first + 124 + 4, value))  # what follows the second
        run, findings = read_recording(file, columns=MAPPED)
        assert code in codes(findings)
        assert run.sizes["time"] == 400


def test_motec_damaged_channels(tmp_path: Path) -> None:
    file, first = tmp_path / "outing.ld", 1762
    content = logger_files.ld_file(LD)
    file.write_bytes(content[:-20])  # ten numbers of the oil
    _, findings = read_recording(file, columns=MAPPED)
    assert "the file declares 40 samples but contains 30" in str(findings[0])
    file.write_bytes(replaced(content, first + 3 * 124 + 8, 2**31))  # the oil's samples
    _, findings = read_recording(file, columns=MAPPED)
    assert "contains 0" in str(findings[0])
    for at, width, says in ((28, 2, "impossible scale"), (26, 2, "impossible multiplier")):
        file.write_bytes(replaced(content, first + at, 0, width))
        with pytest.raises(RecordingError, match=says):
            read_recording(file, columns=MAPPED)
        run, _ = read_recording(file, columns={"front_left.strut.force": "Damper Force FL"})
        assert run.sizes["time"] == 400
    file.write_bytes(replaced(content, first + 18, 9, 2))  # an unknown number type
    run, findings = read_recording(file, columns={"front_left.strut.force": "Damper Force FL"})
    assert "Damper Pos FL" in " ".join(map(str, findings))
    for k in range(1, 4):
        content = replaced(content, first + 124 * k + 8, first)  # all read the same bytes
    content = replaced(content, first + 2 * 124 + 12, 900)
    file.write_bytes(replaced(content, first + 124 + 12, 900))
    with pytest.raises(RecordingError, match=r"channels share the same bytes|no channel"):
        read_signals(file, ReaderOptions())


def test_motec_other_files_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "outing.ld"
    for content in (b"x" * 5000, logger_files.ld_file(LD)[:1000]):
        file.write_bytes(content)
        with pytest.raises(RecordingError, match="not a MoTeC log file, or only its beginning"):
            read_recording(file)
    file.write_bytes(logger_files.ld_file([]))
    with pytest.raises(RecordingError, match="no channel with samples"):
        read_recording(file)


# --- VBO

ROWS = [f"008 2359{58 + 0.25 * i:05.2f} +3119.371150 -00059.479950 {36.0 + i:07.3f} 013.36 +0162.82 +0000.24 "
        f"+0000.10 -0000.20" if i < 8 else
        f"008 0000{0.25 * (i - 8):05.2f} +3119.371150 -00059.479950 {36.0 + i:07.3f} 013.36 +0162.82 +0000.24 "
        f"+0000.10 -0000.20" for i in range(20)]  # fmt: skip


def test_vbo_positions_units_and_midnight(tmp_path: Path) -> None:
    file = tmp_path / "drive.vbo"
    file.write_text(logger_files.vbo_text(ROWS), newline="")
    table = read_signals(file, ReaderOptions()).columns
    units = {column.name: column.unit for column in table}
    assert units == {
        "sats": "1", "time": "s", "lat": "deg", "long": "deg", "velocity": "kmh", "heading": "deg", "height": "m",
        "vert-vel": "kmh", "Longacc": "g", "Latacc": "g",
    }  # fmt: skip
    assert table["lat"].values[0] == pytest.approx(51.98951917)
    assert table["long"].values[0] == pytest.approx(
        +0.99133250
    )  # 59.48 minutes *east*: negative in the file
    np.testing.assert_allclose(table["time"].values, 0.25 * np.arange(20), atol=1e-9)
    run, _ = read_recording(file, columns={"body.speed": "velocity", "body.ay": "Latacc"})
    np.testing.assert_allclose(run["body.speed"], (36.0 + np.arange(20)) / 3.6)
    np.testing.assert_allclose(run["body.ay"], -0.2 * 9.80665)
    assert run.attrs["created"] == "on 08/07/2008 @ 11:18"


def test_vbo_units_of_header_and_channel_units(tmp_path: Path) -> None:
    file = tmp_path / "drive.vbo"
    rows = [f"004 07214{i:.2f} +3119.408424 +00062.635139 015.13 1{i} 5.5" for i in range(9)]
    titles = ["satellites", "time", "latitude", "longitude", "velocity knots", "Damper FL", "other"]
    text = logger_files.vbo_text(
        rows, names="sats time lat long velocity Damper_FL other", titles=titles
    )
    file.write_text(
        text.replace("[channel units]\r\n", "[channel units]\r\nmm\r\nwidgets\r\n"), newline=""
    )
    table = read_signals(file, ReaderOptions()).columns
    assert [column.unit for column in table] == ["1", "s", "deg", "deg", "knots", "mm", ""]
    assert table["long"].values[0] == pytest.approx(-62.635139 / 60.0)  # positive is west


@pytest.mark.parametrize(
    ("title", "stated", "units"),
    [
        ("velocity Knots", ["mm", "bar"], ["knots", "mm", "bar"]),
        ("velocity widgets", ["mm", "bar"], ["", "mm", "bar"]),
        ("vehicle velocity", ["", "bar"], ["km/h", "", "bar"]),
        ("velocity", ["mm", ""], ["km/h", "mm", ""]),
        ("velocity", ["", "", "bar"], ["km/h", "", ""]),  # whose they are cannot be known
    ],
)
def test_vbo_units_that_are_empty_or_unknown_are_not_guessed(
    tmp_path: Path, title: str, stated: list[str], units: list[str]
) -> None:
    rows = [f"004 07214{i:.2f} +3119.408424 +00062.635139 015.13 1{i} 5.5" for i in range(9)]
    names = "sats time lat long velocity Damper Pressure"
    titles = ["satellites", "time", "latitude", "longitude", title, "Damper", "Pressure"]
    text = logger_files.vbo_text(rows, names=names, titles=titles)
    lines = "".join(f"{unit}\r\n" for unit in stated)
    file = tmp_path / "drive.vbo"
    file.write_text(text.replace("[channel units]\r\n", f"[channel units]\r\n{lines}"), newline="")
    table = read_signals(file, ReaderOptions()).columns
    assert [table[name].unit for name in ("velocity", "Damper", "Pressure")] == units


def test_vbo_row_that_lost_only_digits_is_left_out(tmp_path: Path) -> None:
    """The last number would be wrong by a factor: -0000.2 is not -0000.20, but -0000 is not either."""
    file = tmp_path / "drive.vbo"
    text = logger_files.vbo_text(ROWS)
    for lost in (3, 4, 5):  # with the end of the line
        file.write_text(text[:-lost], newline="")
        run, findings = read_recording(file, columns={"body.speed": "velocity"})
        assert (codes(findings)[0], run.sizes["time"]) == ("row_cut_off", 19)
    file.write_text(text[:-2], newline="")
    assert read_recording(file, columns={"body.speed": "velocity"})[0].sizes["time"] == 20


def test_vbo_laps_are_crossings_of_the_start_line(tmp_path: Path) -> None:
    """A circle of one lap in 10 s, started opposite of the line; the line is crossed outward in minutes west."""
    time = np.arange(0.0, 36.0, 0.1)
    angle = 2.0 * np.pi * time / 10.0
    west, north = -60.0 + 0.1 * np.cos(angle), 3120.0 + 0.1 * np.sin(angle)
    rows = [
        f"8 {100000 + t:09.2f} {n:.6f} {w:.6f} 100"
        for t, n, w in zip(time, north, west, strict=True)
    ]
    line = "[laptiming]\r\nStart -60.15 3120.0 -60.05 3120.0 \u00ac Start / Finish\r\n\r\n"
    text = logger_files.vbo_text(rows, names="sats time lat long velocity", titles=["a"], more=line)
    file = tmp_path / "drive.vbo"
    file.write_text(text, newline="", encoding="cp1252")
    run, _ = read_recording(file, columns={"body.speed": "velocity"})
    np.testing.assert_allclose(run.attrs["beacons"], [5.0, 15.0, 25.0, 35.0], atol=1e-3)


def test_crossings_count_only_between_the_posts() -> None:
    time, zero = np.arange(3.0), np.zeros(3)
    assert crossings(time, time, zero, ((0.5, 1.0), (0.5, 2.0))).size == 0
    assert crossings(time, time, zero, ((0.5, 1.0), (0.5, 1.0))).size == 0


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("[column names]", "[columns]", r"not a VBO file, or only a part of it; found '\[header\]"),
        ("[data]", "", "not a VBO file, or only a part"),
        (
            ROWS[3] + "\r\n",
            ROWS[3] + " 7\r\n",
            r"drive\.vbo, line \d+: the row does not have as many cells",
        ),
        ("036.000", "no fix", "the row does not have as many cells"),
        ("036.000", "nofix", r"line \d+: velocity: text in a number column; found 'nofix'"),
        ("235958.00", "239958.00", "not a time of day; found '239958'"),
    ],
)
def test_vbo_damage_is_refused(tmp_path: Path, old: str, new: str, says: str) -> None:
    file = tmp_path / "drive.vbo"
    file.write_text(logger_files.vbo_text(ROWS).replace(old, new, 1), newline="")
    with pytest.raises(RecordingError, match=says):
        read_recording(file, columns={"body.speed": "velocity"})


def test_vbo_cut_off_row_and_degrees_are_reported(tmp_path: Path) -> None:
    file = tmp_path / "drive.vbo"
    file.write_text(logger_files.vbo_text(ROWS)[:-40], newline="")
    run, findings = read_recording(file, columns={"body.speed": "velocity"})
    assert (codes(findings)[0], run.sizes["time"]) == ("row_cut_off", 19)
    degrees = [
        row.replace("+3119.371150", "51.98952").replace("-00059.479950", "0.99") for row in ROWS
    ]
    file.write_text(logger_files.vbo_text(degrees), newline="")
    assert (
        codes(read_recording(file, columns={"body.speed": "velocity"})[1])[0]
        == "degrees_for_minutes"
    )


def test_laps_are_whole_and_within_the_recording() -> None:
    run = jn.recording(TIME, {"body.speed": (30.0 + TIME, "m/s", "")})
    with pytest.raises(RecordingError, match=r"the recording has no lap markers.*Set them"):
        jn.find_laps(run)
    laps = jn.find_laps(run.assign_attrs(beacons=[-1.0, 0.5, 0.5, 1.5, 7.0]))
    assert laps.tolist() == [[0.5, 1.5]]
    assert jn.find_laps(run.assign_attrs(beacons=0.5)).shape == (0, 2)


# --- tables of AiM and Race Technology


def test_aim_table_with_laps(tmp_path: Path) -> None:
    file = tmp_path / "session.csv"
    rows = "".join(f'"{0.05 * i:.3f}","{36 + i}","0.1","{10 + i % 3}"\n' for i in range(20))
    head = (
        '"Format","AiM CSV File"\n"Venue","Fuji GP Sh"\n"Vehicle","SFJ"\n"User","CMD"\n"Comment",""\n'
        '"Date","Tuesday, November 4, 2025"\n"Time","3:50 PM"\n"Sample Rate","20"\n"Duration","0.95"\n'
        '"Segment","Session"\n"Beacon Markers","0.3","0.8"\n"Segment Times","0:00.300","0:00.500"\n\n'
        '"Time","GPS Speed","GPS LatAcc","FL Damper"\n"sec","km/h","g","mm"\n\n'
    )
    for markers in ('"0.3","0.8"', '"0.3 0.8"'):
        file.write_text(head.replace('"0.3","0.8"', markers) + rows)
        columns = {"body.speed": "GPS Speed", "front_left.strut.stroke": "FL Damper"}
        run, findings = read_recording(file, columns=columns)
        assert all(finding.severity == "note" for finding in findings)
        np.testing.assert_allclose(run["body.speed"], (36 + np.arange(20)) / 3.6)
        np.testing.assert_allclose(run["front_left.strut.stroke"][:3], [0.01, 0.011, 0.012])
        np.testing.assert_allclose(run.attrs["beacons"], [0.3, 0.8])
        assert (run.attrs["venue"], run.attrs["date"]) == (
            "Fuji GP Sh",
            "Tuesday, November 4, 2025",
        )
        assert "comment" not in run.attrs


def test_aim_markers_that_are_no_numbers_are_a_finding(tmp_path: Path) -> None:
    file = tmp_path / "session.csv"
    rows = "".join(f'"{0.05 * i:.3f}","{36 + i}"\n' for i in range(20))
    head = '"Format","AiM CSV File"\n"Beacon Markers",{}\n\n"Time","GPS Speed"\n"sec","km/h"\n\n'
    columns = {"body.speed": "GPS Speed"}
    file.write_text(head.format('"0,3","0,8"') + rows)
    np.testing.assert_allclose(
        read_recording(file, columns=columns)[0].attrs["beacons"], [0.3, 0.8]
    )
    file.write_text(head.format('"0.3","none"') + rows)
    run, findings = read_recording(file, columns=columns)
    assert codes(findings)[0] == "no_beacons"
    assert "beacons" not in run.attrs


def test_markers_are_left_out_when_another_sample_time_is_given(tmp_path: Path) -> None:
    file = tmp_path / "outing.ld"
    file.write_bytes(logger_files.ld_file(LD))
    (tmp_path / "outing.ldx").write_text(logger_files.ldx_text([("Lap 1", 0.5)]))
    run, findings = read_recording(file, columns=MAPPED, sample_time=0.01)
    assert "beacons_of_other_time" in codes(findings)
    assert not {"beacons", "beacon_names"} & set(run.attrs)


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_race_technology_table(tmp_path: Path, separator: str) -> None:
    file = tmp_path / "run.csv"
    names = ["Time (s)", "Distance (m)", "GPS Speed (mph)", "Lateral accel (g)", "Damper FL (mm)"]
    rows = [
        [f"{0.01 * i:.2f}", f"{i}", "60", f"{0.1 * (i % 5):.1f}", f"{i % 7}"] for i in range(50)
    ]
    file.write_text("\n".join(separator.join(row) for row in [names, *rows]) + "\n")
    columns = {"body.speed": "GPS Speed", "body.ay": "Lateral accel", "strut.stroke": "Damper FL"}
    run, _ = read_recording(file, columns=columns)
    assert float(run["body.speed"][0]) == pytest.approx(26.8224)
    assert float(run["body.ay"].max()) == pytest.approx(0.4 * 9.80665)
    assert "beacons" not in run.attrs


# --- Sufni


def test_sst_counts_become_strokes_by_sensors(tmp_path: Path) -> None:
    file = tmp_path / "00001.sst"
    fork = np.round(1500.0 + 20.0 * STROKE)
    file.write_bytes(logger_files.sst_file(fork, np.full(400, 0xFFFF), 200))
    chain = Sensor(
        column="fork", sensitivity="20 counts/mm", zero="1500 counts", datum="undeformed"
    )
    run, findings = read_recording(file, sensors={"front.strut.stroke": chain})
    np.testing.assert_allclose(run["front.strut.stroke"], 1e-3 * STROKE, atol=0.5e-3 / 20.0 + 1e-9)
    assert "shock" in " ".join(map(str, findings))
    content = file.read_bytes()
    for bad in (
        b"SSX" + content[3:],
        content[:3] + b"\4" + content[4:],
        content[:4] + b"\0\0" + content[6:],
        content[:15],
    ):
        file.write_bytes(bad)
        with pytest.raises(RecordingError, match="not a file of Sufni telemetry of version 3"):
            read_recording(file)


def test_sst_lost_samples_are_gaps_and_no_strokes(tmp_path: Path) -> None:
    file = tmp_path / "00001.sst"
    fork = np.round(1500.0 + 20.0 * STROKE)
    file.write_bytes(logger_files.sst_file(np.where(TIME[7] == TIME, 0xFFFF, fork), fork, 200))
    table = read_signals(file, ReaderOptions()).columns
    assert np.flatnonzero(np.isnan(table["fork"].values)).tolist() == [7]
    assert np.isfinite(table["shock"].values).all()


# --- damage of any kind


def good_files() -> dict[str, bytes]:
    return {
        "a.rsp": logger_files.rpc_file(CHANNELS, 0.005, kind="SHORT_INTEGER", scales=SCALES),
        "b.rsp": logger_files.rpc_file(CHANNELS, 0.005, form="ASCII"),
        "c.ld": logger_files.ld_file(LD),
        "d.vbo": logger_files.vbo_text(ROWS).encode(),
        "e.sst": logger_files.sst_file(STROKE + 20.0, FORCE, 200),
    }


@pytest.mark.parametrize("name", list(good_files()))
def test_cut_or_flipped_anywhere_a_file_is_read_or_refused_clearly(
    tmp_path: Path, name: str
) -> None:
    content, file = good_files()[name], tmp_path / name
    step = max(1, len(content) // 60)
    random = np.random.default_rng(7)
    damaged = [content[:end] for end in range(1, len(content), step)]
    for place in random.integers(min(len(content), 2500), size=60):
        flipped = bytearray(content)
        flipped[place] ^= 1 << int(random.integers(8))
        damaged.append(bytes(flipped))
    refused = []
    for made in damaged:
        file.write_bytes(made)
        try:
            signals = read_signals(file, ReaderOptions())
        except JounceError as error:
            refused.append(str(error))
            continue
        for table in signals.tables:
            assert len({column.values.size for column in table if column.fault is None}) == 1
    assert refused
    assert all(name in text for text in refused)
