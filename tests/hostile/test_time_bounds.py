"""Texts whose reading took minutes: each is refused, or read, before a deadline that is far from what it takes now."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from jounce.core.columns import columns_in
from jounce.core.description import DescriptionError, toml_table
from jounce.core.errors import RecordingError
from jounce.parts.importers import import_hardpoints

_SIZE = 200_000
_SHAPES = {
    "items.yaml": "- " * (_SIZE // 2),
    "blanks.yaml": (" " * 1990 + "x\n") * 2000,
    "axles.txt": "front{" * (_SIZE // 6),
    "keys.toml": ".".join(["a"] * (_SIZE // 2)) + " = 1\n",
    "trials.toml": 'schema = "jounce.campaign/1"\n' + "[[trial]]\nx = 1\n" * 9_999,
    "units.csv": "time [s],"
    + ",".join(f"c{i} (q{i})" for i in range(9_000))
    + ("\n" + "0," * 9_000 + "0") * 2,
}
_READ = """
import json, sys
from jounce.campaign.description import load_campaign
from jounce.core.errors import JounceError
from jounce.parts.importers import import_hardpoints
from jounce.recordings import read_recording
read = {".toml": load_campaign, ".csv": read_recording}.get(sys.argv[1][-5:].lstrip("s"), import_hardpoints)
try:
    read(sys.argv[1])
except JounceError as error:
    print(json.dumps(str(error)[:4000]))
"""


@pytest.mark.some(2)
@pytest.mark.parametrize("name", _SHAPES)
def test_a_text_that_took_minutes(tmp_path: Path, name: str) -> None:
    file = tmp_path / name
    file.write_text(_SHAPES[name])
    words = [sys.executable, "-c", _READ, str(file)]
    ended = subprocess.run(words, check=False, capture_output=True, text=True, timeout=60)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert name in json.loads(ended.stdout)


def test_limits_are_named(tmp_path: Path) -> None:
    for text in (
        "".join(f"[a{i}]\n" for i in range(10_002)),
        "".join(f"a{i}=1\n" for i in range(100_001)),
    ):
        with pytest.raises(tomllib.TOMLDecodeError, match="more than 10000 tables or 100000 keys"):
            toml_table(text)
    for text in (
        f"[{'a.' * 30}a]",
        f"{{x={{{'b . ' * 30}b=1}}}}",
        '"a".' * 30 + "a=1",
        "'a'.b." * 15 + "a=1",
    ):
        with pytest.raises(tomllib.TOMLDecodeError, match="a key of more than 30 parts"):
            toml_table(text)
    assert toml_table("a = [0.1, 0.2]\n" + "b." * 20 + 'c = "a.b"')["a"] == [0.1, 0.2]
    with pytest.raises(
        RecordingError,
        match=r"a\.csv, line 2: too many columns; found '10001'; allowed: up to 10000",
    ):
        columns_in("# made by hand\n" + ",".join(["a"] * 10_001) + "\n1,2\n", Path("a.csv"))
    (tmp_path / "a.txt").write_text("a 1 2 3\n" + "x" * 2001)
    with pytest.raises(
        DescriptionError, match=r"a\.txt, line 2: a line is too long .*'2001'; allowed: up to 2000"
    ):
        import_hardpoints(tmp_path / "a.txt")
    (tmp_path / "a.json").write_text('{"a":' * 900 + "1" + "}" * 900)
    with pytest.raises(DescriptionError, match=r"too long|no points"):
        import_hardpoints(tmp_path / "a.json")
