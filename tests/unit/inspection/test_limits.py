"""Limits files: bands, edges, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.core.errors import DescriptionError
from jounce.inspection.limits import Criterion, VerdictBand, load_limits, shipped_limits


def changed(tmp_path: Path, old: str, new: str) -> Path:
    text = shipped_limits().read_text(encoding="utf-8")
    assert old in text
    file = tmp_path / "mine.toml"
    file.write_text(text.replace(old, new, 1), encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("method", "value", "label", "verdict", "note"),
    [
        # paper 2: below 0.1 red, 0.1 to 0.13 yellow, 0.13 to 0.3 green, nothing said above
        ("theta", 0.0, "red", "fail", ""),
        ("theta", 0.0999999, "red", "fail", ""),
        ("theta", 0.1, "yellow", "advise", ""),
        ("theta", 0.1299999, "yellow", "advise", ""),
        ("theta", 0.13, "green", "pass", ""),
        ("theta", 0.30, "green", "pass", ""),
        ("theta", 0.3000001, "green, above the optimal band", "pass", "over_range"),
        ("theta", 5.0, "green, above the optimal band", "pass", "over_range"),
        # EUSAMA classes 0-19 bad, 20-39 insufficient, 40-59 sufficient, from 60 good
        ("eusama", 0.0, "bad", "fail", ""),
        ("eusama", 0.1999, "bad", "fail", ""),
        ("eusama", 0.2, "insufficient", "fail", ""),
        ("eusama", 0.3999, "insufficient", "fail", ""),
        ("eusama", 0.4, "sufficient", "pass", ""),
        ("eusama", 0.5999, "sufficient", "pass", ""),
        ("eusama", 0.6, "good", "pass", ""),
        ("eusama", 1.0, "good", "pass", ""),
        # EGEA: at least 35 degrees
        ("egea", -12.0, "too small", "fail", ""),
        ("egea", 34.999, "too small", "fail", ""),
        ("egea", 35.0, "sufficient", "pass", ""),
        ("boge", 0.010999, "hard", "advise", ""),
        ("boge", 0.085, "acceptable", "pass", ""),
        ("boge", 0.0851, "worn", "fail", ""),
    ],
)
def test_edges_of_the_shipped_bands(
    method: str, value: float, label: str, verdict: str, note: str
) -> None:
    band = load_limits().methods[method].band_of(value)
    assert band is not None
    assert (band.label, band.verdict, band.note) == (label, verdict, note)


def test_values_outside_all_bands_have_none() -> None:
    methods = load_limits().methods
    assert methods["eusama"].band_of(1.0001) is None
    assert methods["eusama"].band_of(-1e-9) is None
    assert methods["theta"].band_of(float("nan")) is None


def test_conditions_and_differences_of_egea() -> None:
    limits = load_limits()
    tyre = limits.conditions["tyre-rigidity"]
    shown = [tyre.band_of(value).verdict for value in (159.9e3, 160e3, 400e3, 400.1e3)]
    assert shown == ["advise", "pass", "pass", "advise"]
    for name, share in (
        ("relative-force-amplitude", 0.3),
        ("phase-angle", 0.3),
        ("tyre-rigidity", 0.35),
    ):
        criterion = limits.differences[name]
        assert (criterion.definition, criterion.across) == ("relative", "wheels")
        assert criterion.band_of(share).verdict == "pass"
        assert criterion.band_of(share + 1e-6).verdict != "pass"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "from = 0.10, to = 0.13",
            "from = 0.10, to = 0.12",
            "methods.theta.bands[2]: a gap from 0.12 to 0.13",
        ),
        (
            "from = 0.10, to = 0.13",
            "from = 0.09, to = 0.13",
            "methods.theta.bands[1]: an overlap from 0.09 to 0.1",
        ),
        ("from = 0.10, to = 0.13", "from = 0.10, to = 0.05", "methods.theta.bands[1]: empty"),
        ('to = "35 deg"', 'to = "30 deg"', "methods.egea.bands[1]: a gap from 30° to 35°"),
        (
            '"20 %", to = "40 %"',
            '"20 mm", to = "40 %"',
            "methods.eusama.bands[1].from: wrong unit; found 'mm'",
        ),
        (
            '"160 N/mm", to = "400 N/mm"',
            '160, to = "400 N/mm"',
            "conditions.tyre-rigidity.bands[1]: an overlap",
        ),
        ('"theta_road"', '"theta_roda"', "unknown quantity 'theta_roda'"),
        ("[methods.egea]", "[methods.eega]", "methods.eega: unknown method"),
        ('methods = ["egea"]', 'methods = ["egae"]', "no limits of a method 'egae'"),
        ('verdict = "pass"', 'verdict = "passed"', "found 'passed'. Did you mean 'pass'?"),
        ('colour = "red"', 'colour = "#f00"', "found '#f00'"),
        ('version = "1"', 'versoin = "1"', "Did you mean 'version'?"),
        ("from = 0.13", "from = nan", "not a finite number"),
        ("from = 0.13", "from = true", "invalid physical value"),
        ("jounce.limits/1", "jounce.rig/1", "the schema line is missing or wrong"),
    ],
)
def test_wrong_files_are_refused_with_one_message(
    tmp_path: Path, old: str, new: str, message: str
) -> None:
    file = changed(tmp_path, old, new)
    with pytest.raises(DescriptionError) as caught:
        load_limits(file)
    text = str(caught.value)
    assert message in text
    assert str(file) in text
    assert "\n" not in text


def test_errors_name_the_line(tmp_path: Path) -> None:
    file = changed(tmp_path, "from = 0.10, to = 0.13", "from = 0.10, to = 0.12")
    lines = file.read_text(encoding="utf-8").splitlines()
    first = next(i for i, line in enumerate(lines, 1) if "from = 0.13" in line)
    with pytest.raises(DescriptionError, match=rf"line {first}: methods\.theta"):
        load_limits(file)


def test_missing_files_and_folders(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="no such file"):
        load_limits(tmp_path / "none.toml")
    with pytest.raises(DescriptionError, match="a folder"):
        load_limits(tmp_path)


def test_a_users_file_may_hold_one_method_and_other_units(tmp_path: Path) -> None:
    file = tmp_path / "lane.toml"
    file.write_text(
        'schema = "jounce.limits/1"\nversion = "7"\ndate = "2026-01-01"\nsource = "lane"\n'
        '[methods.egea]\nquantity = "phase_angle_min_deg"\nsource = "lane"\n'
        'bands = [{to = "0.7853981633974483 rad", label = "low", colour = "red", verdict = "fail"},'
        ' {from = "45 deg", label = "high", colour = "green", verdict = "pass"}]\n',
        encoding="utf-8",
    )
    limits = load_limits(file)
    assert limits.name == "lane"
    assert [limits.methods["egea"].band_of(value).label for value in (44.99, 45.0)] == [
        "low",
        "high",
    ]
    assert limits.methods["egea"].bands[0].words("de") == "low"


def test_the_digest_tells_limits_apart_that_have_the_same_version(tmp_path: Path) -> None:
    shipped, other = load_limits(), load_limits(changed(tmp_path, 'from = "35 deg"', "from = 35"))
    assert other.digest == shipped.digest  # 35 deg in other words
    text = shipped_limits().read_text(encoding="utf-8").replace("35 deg", "36 deg")
    (tmp_path / "stricter.toml").write_text(text, encoding="utf-8")
    stricter = load_limits(tmp_path / "stricter.toml")
    assert stricter.version == shipped.version
    assert stricter.digest != shipped.digest


def test_nothing_between_bands_falls_through_by_rounding() -> None:
    end, start = 0.1 + 0.2, 0.3  # differ in the last digit
    criterion = Criterion(
        quantity="theta_road",
        source="test",
        bands=(
            VerdictBand(start=0.0, end=end, label="low", colour="red", verdict="fail"),
            VerdictBand(start=start, label="high", colour="green", verdict="pass"),
        ),
    )
    for value in (start, end):
        band = criterion.band_of(value)
        assert band is not None
        assert band.label == "high"
