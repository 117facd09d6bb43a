"""Operations: what a request means is the same for the command line, for a job and for Python."""

from __future__ import annotations

import inspect

import numpy as np
import pytest

import jounce as jn
from jounce.cli.derived import command_of
from jounce.core.errors import DescriptionError
from jounce.core.typed import ends
from jounce.operations.index import operations, resolve
from jounce.operations.request import Request

DAMPER = "strut.damper.coefficient"


def pareto(**given: object) -> Request:
    free = {DAMPER: "300..6000"}
    return Request(
        operations()["design pareto"], {"vehicle": "audi-a6-quarter-car", "free": free, **given}
    )


def result_of(request: Request):
    values = request.read()
    return request.call(values, request.make(values))


def test_every_operation_is_public_and_its_page_exists():
    for operation in operations().values():
        assert getattr(jn, (operation.python or operation.function).partition(":")[2])
        assert callable(resolve(operation.page))
        assert operation.example.startswith(f"jounce {operation.command} ")
        assert all(parameter.mark.help for parameter in operation.parameters)


def test_words_python_and_call_mean_the_same(capsys):
    request = pareto(points=3, limit={"strut.deflection": "20 mm"}, set={"sprung.mass": "450 kg"})
    assert request.words() == [
        "design", "pareto", "audi-a6-quarter-car", "--set=sprung.mass=450 kg", f"--free={DAMPER}=300..6000",
        "--limit=strut.deflection=20 mm", "--points=3",
    ]  # fmt: skip
    names: dict[str, object] = {}
    exec(request.python(), names)  # noqa: S102 - that is what it is for
    found = result_of(request)
    assert "Pareto" in capsys.readouterr().out or found
    np.testing.assert_allclose(names["result"].comfort, found.comfort, rtol=1e-12)
    rig = jn.load("audi-a6-quarter-car").with_changes({"sprung.mass": "450 kg"})
    limit = {"strut.deflection": "20 mm"}
    direct = jn.pareto(
        rig, {DAMPER: (300.0, 6000.0)}, "iso:C", "20 m/s", points=3, constraints=limit
    )
    np.testing.assert_allclose(found.comfort, direct.comfort, rtol=1e-12)


def test_defaults_of_faces_are_those_of_the_function():
    assert {p.option: value for p, value in pareto().values()}["points"] == 25
    assert "--points" not in " ".join(pareto(points=25).words())


def test_values_are_read_before_anything_is_made():
    with pytest.raises(DescriptionError, match="--speed: wrong unit"):
        pareto(vehicle="no-such-rig", speed="20 kg").read()


def test_options_that_make_one_value_need_no_second():
    request = Request(
        operations()["design springs"],
        {
            "vehicle": "sldemo-half-car",
            "frequency": "1.4 Hz",
            "damping_ratio": "40 %",
            "rear_damping_ratio": "43 %",
        },
    )
    ratios = [wheel.wanted.damping_ratio for wheel in result_of(request).wheels]
    assert ratios == pytest.approx([0.4, 0.43])
    assert "frequency=1.4," in request.python()
    assert "damping_ratio=(0.4, 0.43)," in request.python()


@pytest.mark.parametrize(
    ("text", "pair"),
    [("1..3 mm", ("1 mm", "3 mm")), ("-1e-3 .. 2", (-1e-3, 2.0)), ("±30 %", None), ("20 mm", None)],
)
def test_ends_of_ranges(text, pair):
    assert ends(text) == pair


def test_a_required_value_that_is_empty_is_refused_by_its_option():
    given = {"vehicle": "kart-quarter-car", "frequency": "", "damping_ratio": "0.3"}
    with pytest.raises(DescriptionError, match="--frequency: "):
        Request(operations()["design springs"], given).read()


def test_fields_of_a_description_are_options_and_python(capsys):
    given = {"inverter_frequency": "24.6 Hz", "cylinder_radius": "60 mm"}
    request = Request(operations()["bench speed"], given)
    assert request.words() == [
        "bench",
        "speed",
        "--cylinder-radius=60 mm",
        "--inverter-frequency=24.6 Hz",
    ]
    assert "drive=jn.BenchDrive(cylinder_radius='60 mm')," in request.python()
    names: dict[str, object] = {}
    exec(request.python(), names)  # noqa: S102 - that is what it is for
    assert names["result"] == result_of(request)


def test_a_refused_field_of_a_description_is_named_as_its_option():
    request = Request(operations()["bench drive"], {"pulley_slip": "-1 %"})
    with pytest.raises(DescriptionError, match="--pulley-slip: out of range"):
        result_of(request)


def test_a_trial_is_made_of_options_and_written_as_python():
    given = {"rig": "kart-quarter-car", "road": "iso:C:1", "speed": "2 m/s", "duration": "0.5 s"}
    request = Request(operations()["simulate"], {**given, "set": {"sprung.mass": "17 kg"}})
    assert request.words()[2:] == [
        "--set=sprung.mass=17 kg",
        "--road=iso:C:1",
        "--speed=2 m/s",
        "--duration=0.5 s",
    ]
    names: dict[str, object] = {}
    exec(request.python(), names)  # noqa: S102 - that is what it is for
    np.testing.assert_array_equal(
        names["result"]["sprung.az"], result_of(request).recording()["sprung.az"]
    )


def test_what_must_be_written_is_a_required_option():
    operation = operations()["campaign posterior"]
    assert operation.required == ("folder",)
    out = inspect.signature(command_of(operation)).parameters["out"]
    assert out.default is inspect.Parameter.empty


def test_a_campaign_is_run_into_a_folder_by_python(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    new = Request(operations()["campaign new"], {"folder": "mine"})
    exec(new.python(), names)  # noqa: S102 - that is what it is for
    assert names["result"].to_dict() == result_of(
        Request(new.operation, {"folder": "other"})
    ).to_dict() | {"folder": "mine"}
    run = Request(
        operations()["campaign run"],
        {"campaign": "mine/campaign.toml", "out": "results", "table": ["csv"]},
    )
    assert run.words() == ["campaign", "run", "mine/campaign.toml", "--out=results", "--table=csv"]
    exec(run.python(), names)  # noqa: S102
    found = names["result"]
    assert found.is_met
    assert found.to_dict()["out"] == "results"
    assert (tmp_path / "results" / "report.html").is_file()
    assert list((tmp_path / "results" / "tables").glob("*.csv"))
    with pytest.raises(DescriptionError, match="--figure: unknown form 'mine'"):
        result_of(
            Request(
                run.operation,
                {"campaign": "mine/campaign.toml", "out": "third", "figure": ["mine"]},
            )
        )


def test_an_export_is_written_by_python_as_by_its_command(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    given = {"rig": "kart-double-wishbone", "set": {"sprung.mass": "17 kg"}, "out": "kart.xml"}
    request = Request(operations()["export mjcf"], given)
    assert request.words() == [
        "export",
        "mjcf",
        "kart-double-wishbone",
        "--set=sprung.mass=17 kg",
        "--out=kart.xml",
    ]
    names: dict[str, object] = {}
    exec(request.python(), names)  # noqa: S102 - that is what it is for
    by_python = (tmp_path / "kart.xml").read_text(encoding="utf-8")
    assert result_of(Request(request.operation, {**given, "out": "again.xml"})).loops == 2
    assert (tmp_path / "again.xml").read_text(encoding="utf-8") == by_python


def test_a_live_trial_is_python_without_files_and_a_command_with_one():
    bump = {"kind": "half-sine", "height": "10 mm", "length": "60 mm"}
    given = {"rig": "kart-quarter-car", "speed": "2 m/s", "duration": "0.5 s"}
    text = Request(operations()["simulate"], {**given, "road": bump}).python()
    assert (
        "trial=jn.Trial(road=jn.HalfSine(height='10 mm', length='60 mm'), speed=2.0, duration=0.5),"
        in text
    )


def test_one_option_may_feed_several_parameters():
    operation = operations()["inspect simulate"]
    changes = {"tester.plate_mass": "25 kg", "sprung.mass": "450 kg"}
    request = Request(operation, {"rig": "audi-a6-quarter-car", "method": "egea", "set": changes})
    assert request.words()[2:] == [
        "audi-a6-quarter-car", "--set=tester.plate_mass=25 kg", "--set=sprung.mass=450 kg", "--method=egea",
    ]  # fmt: skip
    made = request.make(request.read())
    assert (made["rig"].sprung.mass, made["tester"].plate_mass) == (450.0, 25.0)
    assert (
        "tester=jn.load_tester('egea-specsus2018').with_changes({'plate_mass': '25 kg'}),"
        in request.python()
    )
    alone = Request(operation, {"rig": "audi-a6-quarter-car"})
    with pytest.raises(DescriptionError, match="--method: no method is given"):
        alone.make(alone.read())


def test_each_record_is_shown_as_soon_as_it_is_stored(tmp_path):
    (tmp_path / "half.csv").write_text("time [s], left.plate.z [mm]")
    (tmp_path / "empty.csv").write_text("")
    files = [str(tmp_path / name) for name in ("half.csv", "empty.csv")]
    request = Request(
        operations()["inspect import"], {"files": files, "store": str(tmp_path / "lane.sqlite")}
    )
    shown: list[object] = []
    found = request.call(request.read(), {}, show=shown.append)
    assert shown == [found.records[0], *found.failed.values()]
    assert not found.is_whole
