"""More than two rigs and runs side by side: curves of each, and a table of what differs."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError

pytest.importorskip("fastapi")
pydantic = pytest.importorskip("pydantic")

from jounce.web import answers, comparing, sweeps  # noqa: E402
from jounce.web.kept import keep  # noqa: E402
from jounce.web.project import Project  # noqa: E402

LIBRARY = Path(jn.__file__).parent / "parts" / "library"
HARDPOINT = "hardpoints.upper_ball_joint[2]"
TRIAL = {
    "road": {"kind": "half-sine", "start": "0.2 m", "height": "10 mm", "length": "60 mm"},
    "speed": "2 m/s",
    "duration": "0.3 s",
}


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """A folder with three quarter cars, and a corner with an earlier version."""
    folder = tmp_path_factory.mktemp("compared")
    quarter = (LIBRARY / "kart-quarter-car.toml").read_text()
    for name, rate in (("soft", "15"), ("kart", "22.73"), ("stiff", "30")):
        (folder / f"{name}.toml").write_text(quarter.replace("22.73 N/mm", f"{rate} N/mm"))
    shutil.copy(LIBRARY / "kart-double-wishbone.toml", folder / "corner.toml")
    project = Project(folder)
    saved = project.read("corner.toml")
    project.write("corner.toml", saved.text.replace("270.83 mm", "260 mm"), saved.digest)
    return project


def labels(shown: answers.CurvesAnswer) -> list[str]:
    return [label for _, label, _ in shown.viewer.roles]


def test_a_sweep_is_compared_with_several_rigs_and_says_what_differs(project: Project) -> None:
    (version,) = project.versions("corner.toml")
    shown = sweeps.swept(
        project,
        sweeps.Question(
            "corner.toml",
            {HARDPOINT: 0.25},
            "-10 mm:10 mm:10 mm",
            against=[version.name, "formula-student-front", "generic-mcpherson"],
            channels=["camber"],
        ),
    )
    assert labels(shown)[:2] == ["changed", "as it is"]
    assert labels(shown)[3:] == ["formula-student-front", "generic-mcpherson"]
    curves = shown.viewer.scenes[0].panes[0].curves
    assert len({curve.role for curve in curves}) == len(curves) == 5
    differs = shown.equivalents["differences"]
    assert differs["names"] == labels(shown)
    (row,) = (row for row in differs["rows"] if row[0] == HARDPOINT)
    assert row[1:5] == ["mm", "250.0", "260.0", "270.8"]


def test_a_version_is_named_by_its_file_and_time(project: Project) -> None:
    (version,) = project.versions("corner.toml")
    assert re.search(r"@\d+-", version.name)
    label = answers.label_of(version.name)
    assert re.fullmatch(r"corner\.toml, replaced \d{4}-\d\d-\d\d \d\d:\d\d:\d\d", label)


def test_a_single_name_is_still_accepted(project: Project) -> None:
    from jounce.web.app import SweepRequest

    assert SweepRequest(rig="corner.toml", against="kart.toml").against == ["kart.toml"]
    assert SweepRequest(rig="corner.toml", against="").against == []
    with pytest.raises(pydantic.ValidationError):
        SweepRequest(rig="corner.toml", against=[f"{i}.toml" for i in range(6)])


def test_a_trial_is_driven_with_several_rigs_beside_a_saved_run(project: Project) -> None:
    kept = keep(project, "stiff.toml", {}, TRIAL, "stiff run")
    shown = answers.simulate_changes(
        project,
        "kart.toml",
        {},
        TRIAL,
        ["sprung.az"],
        beside=answers.Beside(["soft.toml", "stiff.toml", kept["path"]]),
    )
    assert labels(shown) == ["as it is", "soft.toml", "stiff.toml", "runs/stiff run.nc"]
    own, soft, stiff, run = (curve.values for curve in shown.viewer.scenes[0].panes[0].curves)
    np.testing.assert_allclose(run, stiff, rtol=1e-6, atol=1e-9)
    assert np.abs(soft).max() < np.abs(own).max() < np.abs(stiff).max()
    assert shown.equivalents["differences"] == {
        "names": ["as it is", "soft.toml", "stiff.toml"],
        "rows": [["strut.spring.rate", "N/mm", "22.73", "15.00", "30.00"]],
    }


def test_files_and_runs_are_compared_in_a_table(project: Project) -> None:
    listed = comparing.compare_files(project, ["soft.toml", "kart.toml", "stiff.toml"])
    assert listed["rows"] == [["strut.spring.rate", "N/mm", "15.00", "22.73", "30.00"]]
    assert "jn.compare_descriptions({\n    'soft.toml': jn.load('soft.toml')," in listed["python"]
    faster = keep(project, "kart.toml", {"sprung.mass": 20.0}, TRIAL | {"speed": "3 m/s"}, "fast")
    plain = keep(project, "kart.toml", {}, TRIAL, "plain")
    listed = comparing.compare_files(project, [faster["path"], plain["path"]])
    assert listed["rows"] == [
        ["sprung.mass", "kg", "20.00", "16.00"],
        ["speed", "m/s", "3.000", "2.000"],
    ]
    assert [
        row[0] for row in comparing.compare_files(project, ["soft.toml", plain["path"]])["rows"]
    ] == ["strut.spring.rate"]


def test_results_of_campaigns_are_compared_with_their_intervals(tmp_path: Path) -> None:
    project = Project(tmp_path)
    for name, rate in (("a", 22e3), ("b", 23e3)):
        spring = {"value": rate, "interval": [rate - 100.0, rate + 100.0], "unit": "N/m"}
        update = {"name": "all", "parameters": {"strut.spring.rate": spring}}
        (tmp_path / name).mkdir()
        (tmp_path / name / "results.json").write_text(
            json.dumps({"schema": "jounce.results/1", "updates": [update], "trials": []})
        )
    names = ["a/results.json", "b/results.json"]
    listed = comparing.compare_files(project, names)
    cells = ["22.00 (21.90 … 22.10)", "23.00 (22.90 … 23.10)"]
    assert listed["rows"] == [["all: strut.spring.rate", "N/mm", *cells]]
    assert "jn.compare_results({\n    'a/results.json': 'a/results.json'," in listed["python"]
    (tmp_path / "b" / "results.json").write_text("[1, 2")
    with pytest.raises(DescriptionError, match=r"b/results\.json: not the results of a campaign"):
        comparing.compare_files(project, names)


def test_code_that_compares_campaigns_runs(tmp_path: Path, monkeypatch) -> None:
    jn.new_campaign(tmp_path / "one")
    shutil.copytree(tmp_path / "one", tmp_path / "two")
    other = tmp_path / "two" / "campaign.toml"
    other.write_text(re.sub(r'(?m)^title = ".*"', 'title = "another"', other.read_text()))
    listed = comparing.compare_files(Project(tmp_path), ["one/campaign.toml", "two/campaign.toml"])
    assert [row[0] for row in listed["rows"]] == ["title"]
    monkeypatch.chdir(tmp_path)
    exec(listed["python"], {})  # noqa: S102 - as a user would


def test_a_run_keeps_its_rig_when_the_file_changes(project: Project) -> None:
    kept = keep(project, "kart.toml", {}, TRIAL, "before the change")
    saved = project.read("kart.toml")
    project.write("kart.toml", saved.text.replace("22.73 N/mm", "24 N/mm"), saved.digest)
    listed = comparing.compare_files(project, [kept["path"], "kart.toml"])
    assert listed["rows"] == [["strut.spring.rate", "N/mm", "22.73", "24.00"]]
    shutil.rmtree(project.root / ".jounce" / "versions" / "kart.toml")
    with pytest.raises(DescriptionError, match="not known any more"):
        comparing.compare_files(project, [kept["path"], "kart.toml"])


def test_files_of_different_kinds_are_refused(project: Project) -> None:
    (project.root / "campaign").mkdir()
    text = 'schema = "jounce.campaign/1"\nname = "bench"\nrig = "../kart.toml"\n'
    (project.root / "campaign" / "campaign.toml").write_text(text)
    with pytest.raises(DescriptionError):
        comparing.compare_files(project, ["campaign/campaign.toml", "soft.toml"])


TOKEN = "a token of these tests"


@pytest.mark.pages
def test_pages_compare_several_and_show_what_a_save_would_change(browser, workbench) -> None:
    folder, port = workbench
    for name in ("kart-double-wishbone", "formula-student-front", "audi-a6-half-car"):
        shutil.copy(LIBRARY / f"{name}.toml", folder)
    (folder / "a-broken.toml").write_text('schema = "jounce.rig/1"\nmodel = "quarter-car"\n')
    page = browser.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))

    def go(where: str) -> None:
        page.evaluate(
            "page => { delete document.documentElement.dataset.ready; location.hash = page; }",
            where,
        )
        page.wait_for_selector("html[data-ready]", timeout=90_000)

    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}")
    page.wait_for_selector("html[data-ready]", timeout=60_000)
    steps = page.locator("section.next").inner_text()
    assert "Drive a-broken.toml" not in steps
    assert "Correct a-broken.toml" in steps

    go("/kinematics?rig=kart-double-wishbone.toml")
    page.locator(".against > summary").click()
    for name in ("formula-student-front.toml", "generic-mcpherson", "polaris-front"):
        page.locator(f".against input[value='{name}']").check()
    page.keyboard.press("Escape")
    page.locator("ul.legend li", has_text="polaris-front").wait_for(timeout=60_000)
    legend = page.locator(".beside ul.legend").last.locator("li").all_inner_texts()
    assert len(legend) == len({text.rpartition("(")[2] for text in legend}) == 4
    assert page.locator(".differing > summary").inner_text().startswith("What differs (")

    field = page.locator("[data-path='hardpoints.upper_ball_joint[2]'] input[type=number]")
    field.fill("269.923794")
    page.get_by_role("button", name="Save these changes to the file").click()
    page.locator("section.difference .added", has_text='"269.924 mm"').wait_for()
    assert "270.83 mm" in (folder / "kart-double-wishbone.toml").read_text()
    page.get_by_role("button", name="Write to the file").click()
    page.get_by_text("Saved. The previous state is under earlier versions.").wait_for(
        timeout=60_000
    )
    assert '"269.924 mm"' in (folder / "kart-double-wishbone.toml").read_text()

    go("/trial?rig=audi-a6-half-car.toml")
    page.locator(".pane-head").first.wait_for(timeout=60_000)
    sliders = page.locator(".slider .name").all_inner_texts()
    assert {"front.spring_rate", "rear.damping_coefficient", "body.mass"} <= set(sliders)
    assert "front.road.z" in page.locator(".pane-head").first.inner_text()

    go("/kinematics?rig=formula-student-front.toml")
    page.locator(".beside figure canvas").first.wait_for(timeout=60_000)
    page.locator(".mechanism .save > summary").click()
    with page.expect_download() as drawn:
        page.locator(".mechanism .save").get_by_role("button", name="SVG").click()
    svg = Path(drawn.value.path()).read_text()
    assert svg.count("<path") > 100
    assert "tie rod outer" in svg
    page.locator("main > .saving .save > summary").click()
    with page.expect_download() as saved:
        page.locator("main > .saving .save").get_by_role("button", name="HTML report").click()
    report = Path(saved.value.path()).read_text()
    for view in ("as seen", "front", "side", "top"):
        assert f"Mechanism of Kinematics of formula-student-front.toml: {view}" in report
    assert not errors
    page.close()


@pytest.mark.pages
def test_german_fields_show_and_take_a_decimal_comma(browser, workbench) -> None:
    folder, port = workbench
    shutil.copy(LIBRARY / "kart-quarter-car.toml", folder)
    context = browser.new_context(locale="de-DE")
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}#/trial?rig=kart-quarter-car.toml")
    page.wait_for_selector("html[data-ready]", timeout=60_000)
    speed = page.get_by_label("Geschwindigkeit")
    assert speed.input_value() == "1,95 m/s"
    for typed in ("2,5 m/s", "2.5 m/s"):
        speed.fill(typed)
        with page.expect_response("**/api/simulate") as answered:
            speed.press("Enter")
        assert answered.value.status == 200
        assert answered.value.request.post_data_json["speed"] == "2.5 m/s"
    context.close()
