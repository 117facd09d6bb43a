from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.core.optional import MissingPackageError, how_to_install, require
from jounce.recordings import read_columns, read_recording, readers

TIME = np.arange(40) * 0.001
WAVE = np.sin(TIME * 200.0)


def test_missing_package_says_what_to_install() -> None:
    with pytest.raises(
        MissingPackageError, match=f"'not_there_at_all'.*{re.escape(how_to_install('io'))}"
    ):
        require("not_there_at_all", "io")


def test_broken_package_is_not_called_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "jounce_broken_package.py").write_text("import not_there_at_all\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ModuleNotFoundError, match="not_there_at_all"):
        require("jounce_broken_package", "io")


def test_tdms(tmp_path: Path) -> None:
    nptdms = pytest.importorskip("nptdms")
    file = tmp_path / "a.tdms"
    timing = {"wf_increment": 0.001, "wf_start_offset": 0.5}
    channels = [
        nptdms.ChannelObject("Run", "Body", WAVE, properties={"unit_string": "g", **timing}),
        nptdms.ChannelObject(
            "Run", "strut.force", WAVE * 2.0, properties={"unit_string": "kN", **timing}
        ),
    ]
    with nptdms.TdmsWriter(file) as writer:
        writer.write_segment([*channels, nptdms.ChannelObject("Other", "a", WAVE[:4])])
    with pytest.raises(
        RecordingError, match=r"the file has no group or several; found 'Other, Run'"
    ):
        read_recording(file, columns={"sprung.az": "Body"})
    with pytest.raises(RecordingError, match="no group 'run'"):
        read_recording(file, columns={"sprung.az": "Body"}, variable="run")
    run, findings = read_recording(file, columns={"sprung.az": "Body"}, variable="Run")
    np.testing.assert_allclose(run["sprung.az"], WAVE * 9.80665, rtol=1e-14)
    np.testing.assert_allclose(run["strut.force"], WAVE * 2e3, rtol=1e-14)
    np.testing.assert_allclose(run["time"], 0.5 + TIME, rtol=1e-12)
    assert findings == []


def test_tdms_with_bytes_that_belong_to_no_segment(tmp_path: Path) -> None:
    nptdms = pytest.importorskip("nptdms")
    file, told = tmp_path / "a.tdms", {"unit_string": "g", "wf_increment": 0.001}
    with nptdms.TdmsWriter(file) as writer:
        writer.write_segment([nptdms.ChannelObject("Run", "a", WAVE, properties=told)])
        writer.write_segment([nptdms.ChannelObject("Run", "a", WAVE)])
    content, columns = file.read_bytes(), {"sprung.az": "a"}
    for lost in (0, 1, 27):
        file.write_bytes(content + b"x" * lost)
        run, findings = read_recording(file, columns=columns)
        assert run.sizes["time"] == 80
        assert [one.value for one in findings] == [lost] * bool(lost)
        for finding in findings:
            assert (finding.severity, finding.place) == ("problem", str(file))
            assert (
                f"{lost} bytes from byte {len(content)} on belong to no segment" in finding.message
            )
    file.write_bytes(content + b"x" * 28)  # as long as the head of a segment
    with pytest.raises(RecordingError, match="not a TDMS file, or damaged"):
        read_recording(file, columns=columns)
    last = content.rindex(b"TDSm")
    file.write_bytes(
        content[: last + 12] + b"\xff" * 8 + content[last + 20 :]
    )  # the writer did not come to its end
    run, findings = read_recording(file, columns=columns)
    assert (run.sizes["time"], findings) == (80, [])
    with nptdms.TdmsWriter(file) as writer:
        writer.write_segment(
            [
                nptdms.ChannelObject("Run", "a", np.array(["x", "y"])),
                nptdms.ChannelObject("Run", "b", WAVE[:1]),
            ]
        )
    with pytest.raises(RecordingError, match=r"a\.tdms: group 'Run': no numeric channel"):
        read_recording(file, columns=columns)


def data_set_58(entity: str, node: int, values: np.ndarray) -> str:
    """A time response as the Universal File Format has it, ASCII, double precision, 1 kHz."""
    axis = f"{0:10d}{0:5d}{0:5d}{0:5d} "
    lines = ["    -1", "    58", "title", "NONE", "01-Jan-26", "NONE", "NONE"]
    lines.append(
        f"{1:5d}{0:10d}{0:5d}{0:10d} {entity:<10s}{node:10d}{3:4d} {'NONE':<10s}{0:10d}{0:4d}"
    )
    lines.append(f"{4:10d}{len(values):10d}{1:10d}{0.0:13.5e}{0.001:13.5e}{0.0:13.5e}")
    for label, unit in (
        ("Time", "s"),
        ("Acceleration", "m/s^2"),
        ("NONE", "NONE"),
        ("NONE", "NONE"),
    ):
        lines.append(f"{axis}{label:<20s} {unit:<20s}")
    lines += ["".join(f"{v:20.12e}" for v in values[i : i + 4]) for i in range(0, len(values), 4)]
    return "\n".join([*lines, "    -1", ""])


def test_uff(tmp_path: Path) -> None:
    pytest.importorskip("pyuff")
    file = tmp_path / "a.uff"
    sets = [("NONE", 1, WAVE), ("Wheel", 2, WAVE * 2.0), ("Wheel", 3, WAVE[:20])]
    file.write_text("".join(data_set_58(*one) for one in sets))
    run, findings = read_recording(
        file, columns={"sprung.az": "point_1", "unsprung.az": "Wheel:2+3"}
    )
    np.testing.assert_allclose(run["sprung.az"], WAVE, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(run["unsprung.az"], WAVE * 2.0, rtol=0.0, atol=1e-9)
    assert "Wheel:3+3" in findings[0].message  # it has fewer samples
    kind, samples = f"{4:10d}{40:10d}", f"{6:10d}{20:10d}"  # pairs of numbers are complex ones
    phasor, short = (
        data_set_58("Phasor", 4, WAVE).replace(kind, samples),
        data_set_58("Blink", 5, WAVE[:1]),
    )
    file.write_text(data_set_58("Wheel", 2, WAVE) + phasor + short)
    run, findings = read_recording(file, columns={"sprung.az": "Wheel"})
    assert run.sizes["time"] == 40
    assert "Phasor, Blink" in findings[0].message
    file.write_text(phasor)
    with pytest.raises(RecordingError, match="no time response of real numbers; found 'Phasor'"):
        read_recording(file, columns={"sprung.az": "Phasor"})


def test_mdf(tmp_path: Path) -> None:
    asammdf = pytest.importorskip("asammdf")
    file = tmp_path / "a.mf4"
    with asammdf.MDF(version="4.10") as content:
        content.append([asammdf.Signal(WAVE, TIME, name="Acc_Body", unit="g")])
        content.append([asammdf.Signal(WAVE * 2.0, TIME, name="strut.force", unit="kN")])
        content.append([asammdf.Signal(WAVE[:5], TIME[:5] * 4.0, name="slow.az", unit="g")])
        content.append(
            [asammdf.Signal(np.array([b"a"] * 40), TIME, name="remark", encoding="utf-8")]
        )
        content.append([asammdf.Signal(WAVE[:1], TIME[:1], name="once", unit="g")])
        content.save(file)
    run, findings = read_recording(file, columns={"sprung.az": "Acc_Body"})
    np.testing.assert_allclose(run["sprung.az"], WAVE * 9.80665, rtol=1e-14)
    np.testing.assert_allclose(run["strut.force"], WAVE * 2e3, rtol=1e-14)
    assert "slow.az" in findings[0].message
    assert "remark" not in findings[0].message
    assert "once" not in findings[0].message


@pytest.mark.parametrize(
    ("package", "suffix"),
    [("nptdms", ".tdms"), ("pyuff", ".uff"), ("asammdf", ".mf4"), ("pyarrow", ".parquet")],
)
def test_broken_file(tmp_path: Path, package: str, suffix: str) -> None:
    pytest.importorskip(package)
    file = tmp_path / f"broken{suffix}"
    file.write_bytes(b"nothing of the kind\n" * 50)
    with pytest.raises(RecordingError, match=r"broken\.\w+: (not an? |no time response)"):
        read_recording(file)


def test_uff_in_the_units_it_gives_and_cut_off(tmp_path: Path) -> None:
    pytest.importorskip("pyuff")
    file = tmp_path / "a.uff"
    whole = data_set_58("Wheel", 2, WAVE)
    axis = f"{'Time':<20s} {'s':<20s}"
    file.write_text(
        whole.replace(axis, f"{'Time':<20s} {'ms':<20s}").replace("1.00000e-03", "1.00000e+00")
    )
    run, _ = read_recording(file, columns={"sprung.az": "Wheel"})
    np.testing.assert_allclose(run["time"], TIME, rtol=1e-12)
    lines = whole.splitlines()
    file.write_text("\n".join([*lines[:16], "    -1", ""]))
    run, (finding,) = read_recording(file, columns={"sprung.az": "Wheel"})
    assert (finding.severity, finding.value, run.sizes["time"]) == ("problem", 12.0, 12)
    assert "declares 40 samples but contains 12" in finding.message
    file.write_text(whole + "\n".join(data_set_58("Body", 3, WAVE).splitlines()[:16]))
    run, findings = read_recording(file, columns={"sprung.az": "Wheel"})
    assert "the last data set has no end" in findings[0].message
    file.write_text("\n".join(lines[:16]))
    with pytest.raises(
        RecordingError, match=r"no time response; found 'no whole data set'|damaged"
    ):
        read_recording(file)


def test_uff_messages_do_not_contradict_themselves(tmp_path: Path) -> None:
    pytest.importorskip("pyuff")
    file = tmp_path / "a.uff"
    frequency_response = data_set_58("Wheel", 2, WAVE).replace(
        f"{1:5d}{0:10d}{0:5d}", f"{4:5d}{0:10d}{0:5d}", 1
    )
    file.write_text(frequency_response)
    says = (
        r"no time response; found 'data set 58 with functions of type 4'; allowed: data set 58 "
        r"with functions of type 1"
    )
    with pytest.raises(RecordingError, match=says):
        read_recording(file)
    file.write_text("    -1\n   151\nmodel\nNONE\nNONE\n01-Jan-26\nNONE\nNONE\nNONE\n    -1\n")
    with pytest.raises(RecordingError, match=r"found 'data sets 151'; allowed: data set 58 with"):
        read_recording(file)


def test_tdms_cut_off_says_how_much_is_there(tmp_path: Path) -> None:
    nptdms = pytest.importorskip("nptdms")
    file = tmp_path / "a.tdms"
    wave = np.sin(np.arange(2000) * 0.01)
    told = {"unit_string": "g", "wf_increment": 0.001}
    with nptdms.TdmsWriter(file) as writer:
        writer.write_segment(
            [nptdms.ChannelObject("Run", name, wave, properties=told) for name in ("a", "b")]
        )
    content = file.read_bytes()
    file.write_bytes(content[: round(0.9 * len(content))])
    run, findings = read_recording(file, columns={"sprung.az": "a", "unsprung.az": "b"})
    held = run.sizes["time"]
    assert 1000 < held < 2000
    assert (findings[0].severity, findings[0].value) == ("problem", held)
    assert f"declares 2000 samples but contains {held}" in findings[0].message
    np.testing.assert_allclose(run["unsprung.az"], 9.80665 * wave[:held])
    file.write_bytes(content[: round(0.3 * len(content))])
    run, findings = read_recording(file, columns={"sprung.az": "a"})
    assert len([one for one in findings if one.severity == "problem"]) == 2  # nothing of b is there


def test_tdms_cut_off_where_a_segment_says_what_is_in_it(tmp_path: Path) -> None:
    nptdms = pytest.importorskip("nptdms")
    file = tmp_path / "a.tdms"
    wave = np.sin(np.arange(400) * 0.01)
    with nptdms.TdmsWriter(file) as writer:
        for part in (wave[:150], wave[150:]):
            writer.write_segment(
                [nptdms.ChannelObject("Run", "a", part, properties={"wf_increment": 0.001})]
            )
    content = file.read_bytes()
    first = content.index(b"TDSm", 4)
    for more in (5, 40, 60):
        file.write_bytes(content[: first + more])
        run, findings = read_recording(file, columns={"body.speed": "a [m/s]"})
        assert run.sizes["time"] == 150
        assert f"{more} bytes from byte {first} on belong to no segment" in findings[0].message
    file.write_bytes(content)
    assert read_recording(file, columns={"body.speed": "a [m/s]"})[0].sizes["time"] == 400


@pytest.mark.parametrize(
    "options", [{}, {"row_group_size": 30}, {"write_page_index": True}, {"compression": "none"}]
)
def test_parquet_with_bytes_between_its_columns(tmp_path: Path, options: dict[str, Any]) -> None:
    pa, parquet = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    file, time = tmp_path / "a.parquet", np.arange(100) * 0.01
    parquet.write_table(
        pa.table({"time [s]": time, "tyre.force [N]": np.sin(time) + 1.0}), file, **options
    )
    assert [one for one in read_recording(file)[1] if "bytes" in one.message] == []
    content = file.read_bytes()
    at = len(content) - 8 - int.from_bytes(content[-8:-4], "little")
    file.write_bytes(content[:at] + b"rest of another file" + content[at:])
    said = [one for one in read_recording(file)[1] if "bytes" in one.message]
    assert (said[0].severity, said[0].value) == ("warning", 20.0)
    file.write_bytes(content[: at // 2] + content[at:])
    with pytest.raises(RecordingError, match=r"a\.parquet: .*damaged"):
        read_recording(file)


def test_tdms_and_mdf_signals_on_other_clocks_are_brought_onto_one(tmp_path: Path) -> None:
    nptdms, asammdf = pytest.importorskip("nptdms"), pytest.importorskip("asammdf")
    fast, slow = np.arange(4000) * 0.001, 0.0123 + np.arange(300) * 0.013

    def truth(time: np.ndarray) -> np.ndarray:
        return np.sin(2.0 * np.pi * 1.5 * time)

    clocks = [(name, clock, {"unit_string": unit, "wf_increment": clock[1] - clock[0], "wf_start_offset": clock[0]})
              for name, clock, unit in (("az", fast, "g"), ("speed", slow, "m/s"))]  # fmt: skip
    with nptdms.TdmsWriter(tmp_path / "a.tdms") as writer:
        writer.write_segment(
            [nptdms.ChannelObject("R", name, truth(t), properties=told) for name, t, told in clocks]
        )
    with asammdf.MDF(version="4.10") as content:
        for name, time, told in clocks:
            content.append([asammdf.Signal(truth(time), time, name=name, unit=told["unit_string"])])
        content.save(tmp_path / "a.mf4")
    columns = {"sprung.az": "az", "body.speed": "speed"}
    for file in (tmp_path / "a.tdms", tmp_path / "a.mf4"):
        both, notes = read_recording(file, columns=columns)
        assert both["body.speed"].attrs["recorded_rate"] == pytest.approx(1.0 / 0.013)
        assert [note.severity for note in notes] == [
            "warning",
            "note",
        ]  # what the slower one lacks at its end is told
        assert (float(both["time"][0]), float(both["time"][-1])) == pytest.approx((0.013, 3.899))
        np.testing.assert_allclose(both["body.speed"], truth(both["time"].to_numpy()), atol=2e-4)
        np.testing.assert_allclose(
            both["sprung.az"], 9.80665 * truth(both["time"].to_numpy()), atol=1e-9
        )
        alone, notes = read_recording(file, columns={"sprung.az": "az"})
        assert "speed [m/s]; resample puts them on a common time base" in notes[0].message
        np.testing.assert_allclose(alone["sprung.az"], 9.80665 * truth(fast), atol=1e-9)
        run, notes = read_recording(file, columns=columns, resample="5 ms")
        time = run["time"].to_numpy()
        assert time[0] == pytest.approx(0.0123)
        np.testing.assert_allclose(run["body.speed"][5:-5], truth(time)[5:-5], atol=2e-4)
        np.testing.assert_allclose(
            run["sprung.az"][20:-20], 9.80665 * truth(time)[20:-20], atol=2e-3
        )
        assert any(
            "largest gap in the recorded time of body.speed is 0.013 s" in note.message
            for note in notes
        )
        with pytest.raises(
            RecordingError, match=r"with resample, e\.g\. '10 ms' and without a sample time"
        ):
            read_recording(file, columns=columns, resample="5 ms", sample_time="2 ms")
        slowed, notes = read_recording(
            file, columns={"sprung.az": "az"}, resample="5 ms", sample_time="2 ms"
        )
        assert float(slowed["time"][-1]) == pytest.approx(7.995)
        assert any("resample without a sample time puts" in note.message for note in notes)


DATABASE = """VERSION ""
NS_ :
BS_:
BU_: ECU
BO_ 256 Body: 8 ECU
 SG_ AccZ : 0|16@1- (0.001,0) [-32|32] "g" ECU
 SG_ Travel : 16|16@1- (0.01,0) [-300|300] "mm" ECU
BO_ 257 Car: 8 ECU
 SG_ Speed : 0|16@1+ (0.01,0) [0|600] "km/h" ECU
"""


def bus_file(folder: Path) -> Path:
    """400 frames of the message Body every 5 ms, 100 of the message Car every 20 ms, as a CAN logger stores them."""
    asammdf = pytest.importorskip("asammdf")
    from asammdf.blocks import v4_constants

    first, second = np.arange(400) * 0.005, 0.0007 + np.arange(100) * 0.02
    payload = np.zeros((500, 8), np.uint8)
    payload[:400, 0:2] = (
        np.round(np.sin(first * 9.0) / 0.001).astype("<i2").view(np.uint8).reshape(-1, 2)
    )
    payload[:400, 2:4] = (
        np.round(20.0 * np.cos(first * 9.0) / 0.01).astype("<i2").view(np.uint8).reshape(-1, 2)
    )
    payload[400:, 0:2] = (
        np.round((50.0 + second) / 0.01).astype("<u2").view(np.uint8).reshape(-1, 2)
    )
    fields = {
        "BusChannel": "u1",
        "ID": "<u4",
        "IDE": "u1",
        "DLC": "u1",
        "DataLength": "u1",
        "DataBytes": "(8,)u1",
        "Dir": "u1",
    }
    frames = np.zeros(
        500, np.dtype([(f"CAN_DataFrame.{name}", kind) for name, kind in fields.items()])
    )
    frames["CAN_DataFrame.BusChannel"] = 1
    frames["CAN_DataFrame.ID"] = np.repeat([256, 257], [400, 100])
    frames["CAN_DataFrame.DLC"] = frames["CAN_DataFrame.DataLength"] = 8
    frames["CAN_DataFrame.DataBytes"] = payload
    stamps = np.concatenate((first, second))
    order = np.argsort(stamps, kind="stable")
    source = asammdf.Source("CAN1", "CAN1", "", v4_constants.SOURCE_BUS, v4_constants.BUS_TYPE_CAN)
    with asammdf.MDF(version="4.10") as content:
        content.append(
            asammdf.Signal(frames[order], stamps[order], name="CAN_DataFrame", source=source),
            acq_source=source,
            common_timebase=True,
        )
        flags = v4_constants.FLAG_CG_BUS_EVENT | v4_constants.FLAG_CG_PLAIN_BUS_EVENT
        content.groups[0].channel_group.flags |= flags
        content.save(folder / "bus.mf4")
    (folder / "car.dbc").write_text(DATABASE)
    return folder / "bus.mf4"


def test_mdf_bus_frames_with_a_database(tmp_path: Path) -> None:
    file, database = bus_file(tmp_path), tmp_path / "car.dbc"
    columns = {"sprung.az": "AccZ", "strut.deflection": "Travel"}
    run, findings = read_recording(file, columns=columns, database=database)
    np.testing.assert_allclose(run["time"], np.arange(400) * 0.005, atol=1e-9)
    time = run["time"].to_numpy()
    np.testing.assert_allclose(run["sprung.az"], 9.80665 * np.sin(time * 9.0), atol=0.01)
    np.testing.assert_allclose(run["strut.deflection"], 0.02 * np.cos(time * 9.0), atol=1e-5)
    assert "Speed [km/h]" in findings[0].message
    together, findings = read_recording(
        file, columns={**columns, "body.speed": "Speed"}, database=database, resample="10 ms"
    )
    np.testing.assert_allclose(together["body.speed"], (50.0 + together["time"]) / 3.6, atol=5e-3)
    with pytest.raises(
        RecordingError, match=r"The file contains bus frames: give the database \(\.dbc\)"
    ):
        read_recording(file, columns=columns)
    database.write_text(DATABASE.replace("BO_ 256", "BO_ 300").replace("BO_ 257", "BO_ 301"))
    with pytest.raises(RecordingError, match="none of the bus frames of the file"):
        read_recording(file, columns=columns, database=database)
    with pytest.raises(RecordingError, match="no such file"):
        read_recording(file, columns=columns, database=tmp_path / "none.dbc")
    plain = tmp_path / "a.csv"
    plain.write_text("time [s], sprung.az [g]\n0, 1\n")
    with pytest.raises(
        RecordingError, match=r"a bus message database cannot be used.*allowed: \.mf4"
    ):
        read_recording(plain, database=database)


def test_parquet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pa, pq = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    monkeypatch.setattr(
        readers, "is_possible", lambda: False
    )  # a child that has loaded Arrow serves one file only
    file = tmp_path / "a.parquet"
    stamps = pa.array(1_700_000_000_000_000_000 + np.arange(40) * 1_000_000, pa.timestamp("ns"))
    fields = [
        pa.field("clock", stamps.type),
        pa.field("acc [g]", pa.float32()),
        pa.field("force", pa.int32(), metadata={"unit": "N"}),
        pa.field("remark", pa.string()),
        pa.field("seconds", pa.float64()),
    ]
    arrays = [
        stamps,
        pa.array(WAVE, pa.float32()),
        pa.array(np.arange(40), pa.int32()),
        pa.array(["a"] * 40),
        TIME,
    ]
    pq.write_table(pa.table(arrays, schema=pa.schema(fields)), file)
    columns = {"sprung.az": "acc", "strut.force": "force"}
    for time in ("clock", "seconds [s]"):
        run, findings = read_recording(file, columns={"time": time, **columns})
        np.testing.assert_allclose(run["sprung.az"], WAVE * 9.80665, rtol=1e-6, atol=1e-7)
        np.testing.assert_allclose(run["strut.force"], np.arange(40.0))
        np.testing.assert_allclose(run["time"], TIME, atol=1e-9)
        assert "remark" in findings[0].message
    with pytest.raises(
        RecordingError, match="column 'remark': text in a number column; found 'string'"
    ):
        read_recording(file, columns={"time": "clock", "sprung.az": "remark [g]"})
    holes = pa.table({"time [s]": TIME, "sprung.az [g]": pa.array([None, *WAVE[1:]])})
    pq.write_table(holes, file)
    with pytest.raises(RecordingError, match="not a finite number at row 1"):
        read_recording(file)


@pytest.mark.parametrize("head", ["sprung.az [m/s^2]", "sprung.az", "heat [degC]"])
def test_durations_in_a_channel_of_parquet_are_no_seconds(tmp_path: Path, head: str) -> None:
    pa, pq = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    ticks = pa.array(np.arange(20), pa.duration("ms"))
    pq.write_table(pa.table({"time [s]": np.arange(20) * 0.1, head: ticks}), tmp_path / "a.parquet")
    name = head.partition(" ")[0]
    with pytest.raises(RecordingError, match=r"number column; found 'duration\[ms\]'"):
        read_columns(tmp_path / "a.parquet", {name: "s"})


def test_parquet_without_rows_and_with_durations(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pa, pq = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    monkeypatch.setattr(readers, "is_possible", lambda: False)
    file = tmp_path / "a.parquet"
    pq.write_table(pa.table({"time [s]": TIME[:0], "sprung.az [g]": WAVE[:0]}), file)
    with pytest.raises(RecordingError, match=r"a\.parquet: no rows"):
        read_recording(file)
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)):
        ticks = pa.array(np.arange(40) * 7, pa.duration(unit))
        pq.write_table(pa.table({"time": ticks, "sprung.az [g]": pa.array(WAVE)}), file)
        run, _ = read_recording(file)
        np.testing.assert_allclose(run["time"], 7.0 * size * np.arange(40), rtol=1e-12)
