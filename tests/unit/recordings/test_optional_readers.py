from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.core.optional import MissingPackageError, require
from jounce.recordings import read_recording

TIME = np.arange(40) * 0.001
WAVE = np.sin(TIME * 200.0)


def test_missing_package_says_what_to_install() -> None:
    with pytest.raises(MissingPackageError, match=r"'not_there_at_all'.*pip install 'jounce\[io\]'"):
        require("not_there_at_all", "io")


def test_broken_package_is_not_called_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
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
        nptdms.ChannelObject("Run", "strut.force", WAVE * 2.0, properties={"unit_string": "kN", **timing}),
    ]
    with nptdms.TdmsWriter(file) as writer:
        writer.write_segment([*channels, nptdms.ChannelObject("Other", "a", WAVE[:4])])
    with pytest.raises(RecordingError, match=r"not exactly one group; found 'Other, Run'"):
        read_recording(file, columns={"sprung.az": "Body"})
    with pytest.raises(RecordingError, match="no group 'run'"):
        read_recording(file, columns={"sprung.az": "Body"}, variable="run")
    run, findings = read_recording(file, columns={"sprung.az": "Body"}, variable="Run")
    np.testing.assert_allclose(run["sprung.az"], WAVE * 9.80665, rtol=1e-14)
    np.testing.assert_allclose(run["strut.force"], WAVE * 2e3, rtol=1e-14)
    np.testing.assert_allclose(run["time"], 0.5 + TIME, rtol=1e-12)
    assert findings == []


def data_set_58(entity: str, node: int, values: np.ndarray) -> str:
    """A time response as the Universal File Format has it, ASCII, double precision, 1 kHz."""
    axis = f"{0:10d}{0:5d}{0:5d}{0:5d} "
    lines = ["    -1", "    58", "title", "NONE", "01-Jan-26", "NONE", "NONE"]
    lines.append(f"{1:5d}{0:10d}{0:5d}{0:10d} {entity:<10s}{node:10d}{3:4d} {'NONE':<10s}{0:10d}{0:4d}")
    lines.append(f"{4:10d}{len(values):10d}{1:10d}{0.0:13.5e}{0.001:13.5e}{0.0:13.5e}")
    for label, unit in (("Time", "s"), ("Acceleration", "m/s^2"), ("NONE", "NONE"), ("NONE", "NONE")):
        lines.append(f"{axis}{label:<20s} {unit:<20s}")
    lines += ["".join(f"{v:20.12e}" for v in values[i : i + 4]) for i in range(0, len(values), 4)]
    return "\n".join([*lines, "    -1", ""])


def test_uff(tmp_path: Path) -> None:
    pytest.importorskip("pyuff")
    file = tmp_path / "a.uff"
    sets = [("NONE", 1, WAVE), ("Wheel", 2, WAVE * 2.0), ("Wheel", 3, WAVE[:20])]
    file.write_text("".join(data_set_58(*one) for one in sets))
    run, findings = read_recording(file, columns={"sprung.az": "point_1", "unsprung.az": "Wheel:2+3"})
    np.testing.assert_allclose(run["sprung.az"], WAVE, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(run["unsprung.az"], WAVE * 2.0, rtol=0.0, atol=1e-9)
    assert "Wheel:3+3" in findings[0].message  # it has fewer samples


def test_mdf(tmp_path: Path) -> None:
    asammdf = pytest.importorskip("asammdf")
    file = tmp_path / "a.mf4"
    with asammdf.MDF(version="4.10") as content:
        content.append([asammdf.Signal(WAVE, TIME, name="Acc_Body", unit="g")])
        content.append([asammdf.Signal(WAVE * 2.0, TIME, name="strut.force", unit="kN")])
        content.append([asammdf.Signal(WAVE[:5], TIME[:5] * 4.0, name="slow.az", unit="g")])
        content.save(file)
    run, findings = read_recording(file, columns={"sprung.az": "Acc_Body"})
    np.testing.assert_allclose(run["sprung.az"], WAVE * 9.80665, rtol=1e-14)
    np.testing.assert_allclose(run["strut.force"], WAVE * 2e3, rtol=1e-14)
    assert "slow.az" in findings[0].message


@pytest.mark.parametrize(("package", "suffix"), [("nptdms", ".tdms"), ("pyuff", ".uff"), ("asammdf", ".mf4")])
def test_broken_file(tmp_path: Path, package: str, suffix: str) -> None:
    pytest.importorskip(package)
    file = tmp_path / f"broken{suffix}"
    file.write_bytes(b"nothing of the kind\n" * 50)
    with pytest.raises(RecordingError, match=r"broken\.\w+: (not an? |no time response)"):
        read_recording(file)
