"""``jounce iri`` through its entry point."""

from __future__ import annotations

from pathlib import Path

import pytest

FILES = Path(__file__).parents[1] / "files" / "road_iri"


def rows(count: int, spacing: float = 0.25) -> str:
    return "".join(f"{spacing * i:.4f}, {3.0 * ((7 * i) % 11):g}\n" for i in range(count))


def test_a_measured_profile(cli) -> None:
    found = cli("iri", FILES / "profile_1.txt", "--segment", "100 m", "--json")
    assert found.exit_code == 0
    plain = found.json
    assert plain["iri_m_per_km"] == pytest.approx(3.33545, abs=1e-5)
    assert (plain["start"], plain["end"], plain["spacing"], plain["base"]) == (
        478.0,
        1022.0,
        0.25,
        0.25,
    )
    assert [part["partial"] for part in plain["segments"]] == [False] * 5 + [True]
    assert plain["segments"][2] == {
        "start": 678.0,
        "end": 778.0,
        "iri_m_per_km": pytest.approx(3.55511, abs=1e-5),
        "partial": False,
    }
    assert len(plain["findings"]) == 1  # no header


def test_units_of_the_header_count(cli) -> None:
    for name, header in (("track.csv", "x [m], z [mm]\n"), ("track.txt", "x [m]; z [mm]\n")):
        separator = header[5]
        Path(name).write_text(header + rows(200).replace(",", separator), encoding="utf-8")
        found = cli("iri", name, "--json").json
        assert found["findings"] == []
        assert 1.0 < found["iri_m_per_km"] < 100.0


def test_people_get_a_table(cli) -> None:
    found = cli("iri", FILES / "profile_1.txt", "--segment", "200 m")
    assert "IRI of the whole profile: 3.335 m/km" in found.out
    assert "shorter than the others" in found.out
    assert "no header" in found.out


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x [m], z [m]\n" + rows(200), "these heights are implausible for a road"),
        ("x [m], z [mm]\n" + rows(20), "too short"),
        ("x [m], z [mm]\n" + rows(200, 0.75), "too far apart"),
        (
            "x [m], z [mm]\n" + "\n".join(reversed(rows(200).splitlines())),
            "the distance decreases",
        ),
        ("x [m], z [mm]\n" + rows(200) + "50.0, nan\n", "not a finite number"),
        ("x [m], z [mm]\n" + rows(200) + "50.1, 0\n", "not evenly spaced"),
        ("x [s], z [mm]\n" + rows(200), "wrong unit"),
    ],
)
def test_bad_profiles_end_with_exit_code_2_and_one_message(cli, text: str, message: str) -> None:
    Path("track.csv").write_text(text, encoding="utf-8")
    found = cli("iri", "track.csv", "--json")
    assert found.exit_code == 2
    assert message in found.json["error"]["message"]
    assert found.err.count("\n") == 1


def test_missing_files_and_segments(cli) -> None:
    assert cli("iri", "nowhere.csv").exit_code == 2
    assert cli("iri", "nowhere.crg").exit_code == 2
    assert cli("iri", FILES / "profile_1.txt", "--segment", "0 m").exit_code == 2
    assert "wrong unit" in cli("iri", FILES / "profile_1.txt", "--segment", "3 s").err
