"""``jounce bench``: the paper's numbers, the documented defaults, and wrong values."""

from __future__ import annotations

import re

import pytest
import typer

from jounce.bench.drive import BeltLoad, BenchDrive
from jounce.bench.similitude import Similitude
from jounce.bench.springs import SpringChoice
from jounce.cli.entry import application
from jounce.core.description import Description
from jounce.core.units import Unit, to_si

KINDS = {
    "speed": (BenchDrive,),
    "drive": (BenchDrive, BeltLoad),
    "scale": (Similitude,),
    "springs": (SpringChoice,),
}
ELSEWHERE = {
    "speed": {"motor_power", "efficiency", "standstill_torque"},  # nothing of these in a speed
    "drive": {"belt_length"},  # nothing of it in a pull
}


def options_of(command: str) -> dict[str, str]:
    """Help text of every option by its name in the description."""
    bench = typer.main.get_command(application()).commands["bench"]
    parameters = bench.commands[command].params
    return {
        item.opts[0].removeprefix("--").replace("-", "_"): getattr(item, "help", "")
        for item in parameters
    }


@pytest.mark.parametrize("command", KINDS)
def test_every_value_has_its_option(command: str) -> None:
    fields = {name for kind in KINDS[command] for name in kind.model_fields}
    assert fields - set(options_of(command)) == ELSEWHERE.get(command, set())


def unit_of(kind: type[Description], name: str) -> str | None:
    return next(
        (item.si for item in kind.model_fields[name].metadata if isinstance(item, Unit)), None
    )


@pytest.mark.parametrize(
    ("command", "kind"), [(name, kind) for name, kinds in KINDS.items() for kind in kinds]
)
def test_documented_defaults_are_true(command: str, kind: type[Description]) -> None:
    checked = 0
    for name, text in options_of(command).items():
        if name not in kind.model_fields or name == "bed_load":
            continue
        shown = re.search(r"Default: (.+?)( \(estimated\))?\.$", text)
        assert shown is not None, text
        field = kind.model_fields[name]
        unit = unit_of(kind, name)
        if unit is None:
            assert str(field.default) == shown[1]
        else:
            assert to_si(shown[1], unit) == pytest.approx(field.default, rel=1e-3, abs=1e-12), name
        is_estimated = isinstance(field.json_schema_extra, dict) and bool(
            field.json_schema_extra.get("estimated")
        )
        assert is_estimated == (shown[2] is not None), name
        checked += 1
    assert checked >= 6


def test_belt_speed(cli) -> None:
    """60 Hz are 178.025 rad/s at the cylinder (paper 1, section 2: 356.05 rad/s, pulleys 60 and 120 mm)."""
    words = (
        "bench",
        "speed",
        "--belt-reference",
        "bare",
        "--pulley-slip",
        "0 %",
        "--cylinder-radius",
        "50 mm",
    )
    found = cli(*words, "--inverter-frequency", "60 Hz", "--json").json
    assert found["inverter"]["cylinder_speed"] == pytest.approx(178.025, rel=1e-6)
    assert found["speed"] == pytest.approx(0.05 * 178.025, rel=1e-6)
    back = cli(*words, "--speed", "3.87 m/s", "--json").json
    assert back["inverter"]["inverter_frequency"] == pytest.approx(
        60.0 * 3.87 / (0.05 * 178.025), rel=1e-6
    )
    assert "belt speed" in cli(*words, "--speed", "3.87 m/s").out


def test_photo_sensor(cli) -> None:
    words = ("bench", "speed", "--pulses", 62, "--duration", "10 s", "--belt-thickness", "3 mm")
    found = cli(*words, "--cylinder-radius", "50 mm", "--json").json
    assert found["inverter"] is None
    assert found["speed"] == pytest.approx(
        2 * 3.141592653589793 * 6.2 * 0.0515, rel=1e-9
    )  # 2 pi n (R + t/2)
    assert found["photo_sensor"]["speed"]["interval"][0] < found["speed"]
    assert not any("estimated" in item["message"] for item in found["findings"])


def test_drive(cli) -> None:
    """168.5 N and 652 W at 3.87 m/s for a bare radius of 50 mm without losses (1.5 kW at 356.05 rad/s, 2 to 1)."""
    words = (
        "--belt-reference",
        "bare",
        "--efficiency",
        1,
        "--pulley-slip",
        0,
        "--cylinder-radius",
        "50 mm",
    )
    found = cli("bench", "drive", "--speed", "3.87 m/s", *words, "--json").json
    assert found["available_force"] == pytest.approx(168.5, abs=0.05)
    assert found["available_power"] == pytest.approx(652.0, abs=0.5)
    assert 0.0 < found["margin"] < 1.0
    assert found["attainable"]["limited_by"] == "supply frequency"
    heavy = cli("bench", "drive", "--speed", "3.87 m/s", *words, "--bed-load", "2 kN")
    assert "more than the rated torque" in heavy.out


def test_scale(cli) -> None:
    """265 kg at full size are 16.96 kg by edges of 1 to 2.5, and 15.45 kg in cast iron (paper 1, Eq. 1)."""
    found = cli("bench", "scale", "--json").json
    assert found["mass_same_density"] == pytest.approx(16.96, rel=1e-9)
    assert found["mass_prototype_density"] == pytest.approx(16.96 * 7150 / 7850, rel=1e-9)
    assert found["violations"]
    assert "Similitude" in cli("bench", "scale", "--prototype-mass", "18.6 kg").out


def test_springs(cli) -> None:
    """52 775 N/m was rejected for 22 730 N/m (paper 1, section 4)."""
    found = cli("bench", "springs", "--json").json
    assert found["chosen"] == "scooter"
    assert [row["spring_rate"] for row in found["rows"]] == [52775.0, 22730.0]
    named = cli("bench", "springs", "a=20 N/mm", "b=40 N/mm", "--strut-angle", "10 deg")
    assert "recommended: a" in named.out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("speed",), "give an inverter frequency, a speed or pulses"),
        (
            ("speed", "--speed", "1", "--inverter-frequency", "20 Hz"),
            "give an inverter frequency, a speed or pulses",
        ),
        (("speed", "--pulses", "62"), "--duration is missing"),
        (("speed", "--pulses", "0", "--duration", "10 s"), "number of pulses is not positive"),
        (("speed", "--inverter-frequency", "0 Hz"), "inverter frequency is not positive"),
        (
            ("speed", "--speed", "1 m/s", "--cylinder-radius", "-1 mm"),
            "--cylinder-radius: out of range",
        ),
        (
            ("speed", "--speed", "1 m/s", "--belt-reference", "inner"),
            "--belt-reference: input should be 'pitch'",
        ),
        (("drive", "--speed", "1 kg"), "--speed: wrong unit"),
        (("drive", "--wheel-load", "206 kg"), "--wheel-load: wrong unit"),
        (("drive", "--wheel-laod", "206 N"), "Did you mean '--wheel-load'?"),
        (("scale", "--geometry-factor", "0"), "--geometry-factor: out of range"),
        (("springs", "a"), "NAME=RATE: not NAME=VALUE"),
        (("springs", "a=-1 N/m"), "a: out of range"),
        (("springs", "a=1 N/m", "a=2 N/m"), "'a' is given twice"),
    ],
)
def test_bad_values(words: tuple[str, ...], message: str, cli) -> None:
    outcome = cli("bench", *words)
    assert outcome.exit_code == 2
    assert outcome.out == ""
    assert message in outcome.err


def test_by_default_the_drive_of_the_published_bench_is_explained(cli) -> None:
    found = cli("bench", "drive", "--json").json
    assert found["attainable"]["implied_force"] > 0.0
    assert any("a ceiling of 3.87 m/s implies" in one["message"] for one in found["findings"])
    assert (
        cli("bench", "drive", "--observed-ceiling", "5 m/s", "--json").json["findings"]
        != found["findings"]
    )
    own = cli("bench", "drive", "--cylinder-radius", "60 mm", "--json").json
    assert own["attainable"]["implied_force"] is None
