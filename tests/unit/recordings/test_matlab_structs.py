"""MATLAB structs and cells as testers, Simulink and data loggers write them, in both kinds of file."""

from __future__ import annotations

import struct
from pathlib import Path

import h5py
import numpy as np
import pytest
from scipy.io import savemat

from jounce.core.errors import RecordingError
from jounce.recordings import read_recording

TIME = np.arange(400) * 0.001
WAVE = np.sin(TIME * 20.0)
SIGNAL = {"name": "AccBody", "unit": "g", "values": WAVE}


def check(file: Path, factor: float = 9.80665, **told: object) -> list[str]:
    run, findings = read_recording(file, **told)  # type: ignore[arg-type]
    np.testing.assert_allclose(run["sprung.az"], WAVE * factor, rtol=1e-12)
    np.testing.assert_allclose(run["time"], TIME, rtol=0.0, atol=1e-12)
    return [finding.message for finding in findings]


def cell(*items: object) -> np.ndarray:
    found = np.empty(len(items), dtype=object)
    found[:] = items
    return found


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ({"run": {"time": TIME, "az": WAVE}}, {"columns": {"time": "time [s]", "sprung.az": "az [g]"}}),
        ({"run": {"time": TIME, "az": WAVE}}, {"columns": {"time": "run.time [s]", "sprung.az": "run.az [g]"}}),
        (
            {"run": {"time": TIME, "az": WAVE}, "other": {"time": TIME, "az": 2.0 * WAVE}},
            {"columns": {"time": "time [s]", "sprung.az": "az [g]"}, "variable": "run"},
        ),
        (
            {"run": {"time": TIME, "sprung": {"az": WAVE}, "units": {"time": "s"}}},
            {"columns": {"sprung.az": "sprung.az [g]"}},
        ),
        (
            {"run": {"time": TIME, "acc": WAVE, "units": {"time": "s", "acc": "g"}}},
            {"columns": {"sprung.az": "run.acc"}},
        ),
        ({"t": TIME, "acc": SIGNAL}, {"columns": {"time": "t [s]", "sprung.az": "AccBody"}}),
        ({"t": TIME, "acc": SIGNAL}, {"columns": {"time": "t [s]", "sprung.az": "acc.values"}}),
        (
            {"t": TIME, "Y": cell(SIGNAL, {**SIGNAL, "name": "AccWheel"})},
            {"columns": {"time": "t [s]", "sprung.az": "AccBody"}},
        ),
        (
            {"X": {"Data": TIME}, "Y": [{"Name": "Acc [g]", "Data": WAVE}]},
            {"columns": {"time": "X.Data [s]", "sprung.az": "Acc"}},
        ),
        (  # Simulink, structure with time
            {"out": {"time": TIME, "signals": {"values": np.stack((WAVE, -WAVE), axis=1), "label": "acc"}}},
            {"columns": {"time": "time [s]", "sprung.az": "acc(:,1) [g]"}},
        ),
        (
            {"data": np.stack((TIME, WAVE), axis=1), "names": cell("time", "sprung.az"), "units": cell("s", "g")},
            {},
        ),
        ({"data": np.stack((TIME, WAVE), axis=1), "channels": cell("time (s)", "sprung.az (g)")}, {}),
        ({"c": cell("made by hand", TIME, WAVE)}, {"columns": {"time": "c{2} [s]", "sprung.az": "c{3} [g]"}}),
    ],
)  # fmt: skip
def test_structs_and_cells(
    tmp_path: Path, content: dict[str, object], told: dict[str, object]
) -> None:
    savemat(tmp_path / "a.mat", content)
    check(tmp_path / "a.mat", **told)
    write_hdf5(tmp_path / "b.mat", content)
    check(tmp_path / "b.mat", **told)


def write_hdf5(path: Path, content: dict[str, object]) -> None:
    """The same content as MATLAB stores it in version 7.3."""
    with h5py.File(path, "w", userblock_size=512) as file:
        refs = file.create_group("#refs#")

        def put(group: h5py.Group, name: str, value: object) -> None:
            if isinstance(value, dict):
                inner = group.create_group(name)
                inner.attrs["MATLAB_class"] = np.bytes_("struct")
                for key, item in value.items():
                    put(inner, key, item)
            elif isinstance(value, str):
                group[name] = np.array([[ord(letter)] for letter in value], dtype=np.uint16)
                group[name].attrs["MATLAB_class"] = np.bytes_("char")
            elif isinstance(
                value, list
            ):  # array of structs: a group with references for each field
                inner = group.create_group(name)
                inner.attrs["MATLAB_class"] = np.bytes_("struct")
                for key in value[0]:
                    inner[key] = np.array(
                        [[reference(item[key])] for item in value], dtype=h5py.ref_dtype
                    )
            elif isinstance(value, np.ndarray) and value.dtype == object:
                group[name] = np.array([[reference(item)] for item in value], dtype=h5py.ref_dtype)
                group[name].attrs["MATLAB_class"] = np.bytes_("cell")
            else:
                numbers = np.asarray(value, dtype=float)
                group[name] = numbers.T if numbers.ndim == 2 else numbers[None, :]
                group[name].attrs["MATLAB_class"] = np.bytes_("double")

        def reference(value: object) -> h5py.Reference:
            name = f"r{len(refs)}"
            put(refs, name, value)
            return refs[name].ref

        for name, value in content.items():
            put(file, name, value)
    header = b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM"
    path.write_bytes(header + path.read_bytes()[128:])


def test_what_cannot_be_read_is_named(tmp_path: Path) -> None:
    content = {"t": TIME, "acc": WAVE, "phasor": WAVE + 1j, "remark": "text", "short": TIME[:7]}
    savemat(tmp_path / "a.mat", content)
    messages = check(tmp_path / "a.mat", columns={"time": "t [s]", "sprung.az": "acc [g]"})
    assert "left out: short, phasor" in messages[-1]
    with pytest.raises(RecordingError, match="no numeric variable 'Run'"):
        read_recording(tmp_path / "a.mat", variable="Run", columns={"time": "t [s]"})
    savemat(tmp_path / "a.mat", {"phasor": WAVE + 1j})
    with pytest.raises(RecordingError, match=r"no numeric variable.*cannot be read: phasor"):
        read_recording(tmp_path / "a.mat")


def test_nesting_without_end_is_left_out(tmp_path: Path) -> None:
    deep: dict[str, object] = {"az": WAVE}
    for _ in range(30):
        deep = {"a": deep}
    savemat(tmp_path / "a.mat", {"t": TIME, "acc": WAVE, "deep": deep})
    messages = check(tmp_path / "a.mat", columns={"time": "t [s]", "sprung.az": "acc [g]"})
    assert "deep.a.a" in messages[-1]


@pytest.mark.parametrize("inside", [False, True])
def test_a_matrix_that_announces_other_numbers_than_it_holds_is_refused(
    tmp_path: Path, inside: bool
) -> None:
    savemat(
        tmp_path / "a.mat", {"t": TIME, "s": {"acc": WAVE}} if inside else {"t": TIME, "acc": WAVE}
    )
    content = (tmp_path / "a.mat").read_bytes()
    count, more = (struct.pack("<2i", 1, WAVE.size + extra) for extra in (0, 7))
    at = content.rindex(count)
    (tmp_path / "a.mat").write_bytes(content[:at] + more + content[at + len(more) :])
    with pytest.raises(
        RecordingError, match=f"declares {WAVE.size + 7} numbers but contains {WAVE.size}"
    ):
        read_recording(
            tmp_path / "a.mat",
            columns={"time": "t [s]", "sprung.az": f"{'s.' if inside else ''}acc [g]"},
        )


def test_variables_that_do_not_end_where_they_should(tmp_path: Path) -> None:
    told = {"columns": {"time": "t [s]", "sprung.az": "acc [m/s^2]"}}
    file = tmp_path / "a.mat"
    savemat(file, {"t": TIME, "acc": WAVE})
    good = file.read_bytes()
    size = struct.pack("<2i", 9, WAVE.nbytes)
    numbers = good.rindex(size)
    file.write_bytes(good[:numbers] + struct.pack("<2i", 9, WAVE.nbytes + 1) + good[numbers + 8 :])
    with pytest.raises(
        RecordingError, match=r"a\.mat: not a MATLAB file.*a part of a variable is cut off"
    ):
        read_recording(file, **told)
    for end, missing in ((good[:-1], 1), (good[:-8], 8)):
        file.write_bytes(end)
        held = 48 + WAVE.nbytes
        with pytest.raises(
            RecordingError,
            match=f"cut off within a variable; found '{held - missing} bytes'; allowed: {held}",
        ):
            read_recording(file, **told)
    savemat(file, {"t": TIME, "acc": WAVE}, do_compression=True)
    good = file.read_bytes()
    kind, size = struct.unpack("<2i", good[128:136])
    more = (
        good[:128]
        + struct.pack("<2i", kind, size + 3)
        + good[136 : 136 + size]
        + b"abc"
        + good[136 + size :]
    )
    less = (
        good[:128]
        + struct.pack("<2i", kind, size - 1)
        + good[136 : 135 + size]
        + good[136 + size :]
    )
    for bad in (more, less):
        file.write_bytes(bad)
        with pytest.raises(
            RecordingError, match="a compressed variable does not end where it should"
        ):
            read_recording(file, **told)


def test_objects_and_empty_values_of_version_7_3_are_no_signals(tmp_path: Path) -> None:
    write_hdf5(
        tmp_path / "a.mat", {"t": TIME, "acc": WAVE, "series": WAVE, "note": "x", "none": WAVE}
    )
    with h5py.File(tmp_path / "a.mat", "a") as file:
        file["series"].attrs["MATLAB_object_decode"] = 3
        file["note"].attrs["MATLAB_empty"] = 1
        file["none"].attrs["MATLAB_empty"] = 1
    content = (tmp_path / "a.mat").read_bytes()
    run, (finding,) = read_recording(
        tmp_path / "a.mat", columns={"time": "t [s]", "sprung.az": "acc [g]"}
    )
    np.testing.assert_allclose(run["sprung.az"], 9.80665 * WAVE)
    assert finding.message.endswith("left out: series")
    assert content == (tmp_path / "a.mat").read_bytes()


def test_damaged_files_are_refused_in_one_way(tmp_path: Path) -> None:
    savemat(
        tmp_path / "a.mat",
        {"t": TIME, "s": {"acc": WAVE, "names": cell("a", "b")}},
        do_compression=True,
    )
    good = (tmp_path / "a.mat").read_bytes()
    random = np.random.default_rng(5)
    outcomes = []
    for _ in range(20):
        bad = bytearray(good)
        for place in random.integers(128, len(bad), 3):
            bad[place] = random.integers(256)
        (tmp_path / "b.mat").write_bytes(bytes(bad[: random.integers(200, len(bad))]))
        try:
            read_recording(tmp_path / "b.mat", columns={"time": "t [s]", "sprung.az": "s.acc [g]"})
        except RecordingError as error:
            outcomes.append(str(error))
    assert len(outcomes) > 13
    assert all("b.mat" in text for text in outcomes)
