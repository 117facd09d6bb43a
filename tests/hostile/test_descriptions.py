"""Description files with values that nobody would write: one message of a length that can be read, exit code 2."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.cli import main
from jounce.core.errors import DescriptionError
from jounce.core.units import to_si
from jounce.parts import rig_path

HOSTILE = {
    "digits": "1" + "0" * 5000,
    "long integer": "9" * 400,
    "nested": "[" * 3000 + "]" * 3000,
    "nested a little": "[" * 300 + "]" * 300,
    "long text": '"' + "x" * 200_000 + '"',
    "huge": "1e308",
    "nan": "nan",
    "infinite": "-inf",
    "null": '"\\u0000"',
    "table": "{a = {b = 1}}",
    "date": "1979-05-27",
    "many units": '"1 mm mm mm"',
    "huge with a unit": '"1e999 mm"',
}


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ["mass", "model", "estimated"])
def test_a_value_of_a_rig(
    key: str, value: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = rig_path("kart-quarter-car").read_text(encoding="utf-8").splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith(f"{key} "))
    lines[at] = f"{key} = {HOSTILE[value]}"
    file = tmp_path / "rig.toml"
    file.write_text("\n".join(lines), encoding="utf-8")
    assert main(["check", str(file)]) == 2
    said = capsys.readouterr().err
    assert said.startswith("jounce: ")
    assert "internal" not in said
    assert "rig.toml" in said
    assert len(said) < 1500


def test_a_file_that_is_no_description_by_its_size(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "rig.toml"
    with file.open("wb") as stream:
        stream.truncate(50_000_000)
    assert main(["modes", str(file)]) == 2
    assert "too large for a description" in capsys.readouterr().err


@pytest.mark.parametrize("value", [10**400, 10**5000, 1e31, "1e300 N/m", -1e300], ids=range(5))
def test_sizes_that_nothing_has(value: object) -> None:
    with pytest.raises(DescriptionError, match=r"not a finite number|an impossible value"):
        to_si(value, "N/m")


def test_the_length_that_is_told_is_that_of_the_value() -> None:
    with pytest.raises(DescriptionError) as caught:
        to_si("x" * 200_000, "N/m")
    assert "xxx... (200002 characters)" in str(caught.value)  # with its quotes
    assert len(str(caught.value)) < 500


@pytest.mark.parametrize("mass", ["1e29 kg", "1e20 kg"])
def test_a_wheel_without_an_equilibrium(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], mass: str
) -> None:
    """It was an internal error of linear algebra: the search had left the numbers that there are."""
    text = rig_path("polaris-front").read_text(encoding="utf-8")
    (tmp_path / "rig.toml").write_text(
        text.replace('mass = "30.1917839 kg"', f'mass = "{mass}"'), encoding="utf-8"
    )
    assert main(["modes", str(tmp_path / "rig.toml")]) == 2
    assert "no static equilibrium was found" in capsys.readouterr().err
