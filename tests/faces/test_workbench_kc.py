"""The page K&C: tests of an axle, their overview, what is moved, and what was measured beside it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import JounceError
from jounce.web import sweeps
from jounce.web.laboratory import Question, run_tests
from jounce.web.project import Project

RIG = "semi-trailing-arm"
LIBRARY = Path(jn.__file__).parent / "parts" / "library"
SPRING = "strut.spring.rate"


@pytest.fixture
def project(tmp_path):
    return Project(tmp_path)


def curves(answer):
    """Return curves by quantity: label and values."""
    panes = answer.viewer.scenes[0].panes
    return {pane.name: {curve.label: curve.values for curve in pane.curves} for pane in panes}


def test_curves_are_those_of_the_laboratory(project):
    answer = run_tests(project, Question(RIG, {}, "roll", to={"roll": "2 deg"}))
    run = jn.kc_test(jn.load(RIG), "roll", to="2 deg")
    order = np.argsort(np.asarray(run["input"]), kind="stable")
    inputs, first = np.unique(np.round(np.asarray(run["input"])[order], 12), return_index=True)
    expected = np.rad2deg(np.asarray(run["right.camber"])[order][first])
    assert np.allclose(answer.viewer.scenes[0].x, np.rad2deg(inputs))
    assert np.allclose(curves(answer)["camber"]["right"], expected, atol=1e-6)


def test_a_change_is_shown_beside_what_is_saved(project):
    rate = jn.load(RIG).parameters()[SPRING]
    answer = run_tests(project, Question(RIG, {SPRING: 1.2 * rate}, "bounce"))
    load = curves(answer)["vertical_force"]
    assert set(load) == {"left", "right", "left, as saved", "right, as saved"}
    assert load["left"][-1] > load["left, as saved"][-1] + 100.0


def test_the_overview_comes_in_parts_and_is_complete_in_the_end(project):
    question = Question(RIG, {}, overview=True, within={"bounce": "20 mm"})
    missing = [run_tests(project, question).equivalents["missing"]]
    while missing[-1]:
        missing.append(run_tests(project, question).equivalents["missing"])
        assert missing[-1] < missing[-2]
    rows = run_tests(project, question).equivalents["overview"]
    assert {row["test"] for row in rows} == set(jn.kc_tests(jn.load(RIG)))
    row = next(row for row in rows if row["label"] == "ride camber")
    tests = jn.kc_tests(jn.load(RIG), ("bounce",))
    value = jn.kc_overview(tests, within={"bounce": "20 mm"}).row("bounce", "ride_camber").left
    assert float(row["now"][0].replace("−", "-")) == pytest.approx(np.rad2deg(value), rel=1e-3)


def test_a_measured_sheet_is_judged_and_drawn_from_the_model_at_zero(project):
    run = jn.kc_test(jn.load(RIG), "bounce")
    travel, toe = (np.asarray(run[name]) for name in ("left.wheel_centre_z", "left.toe"))
    rows = [
        f"{1e3 * z:.4f}; {np.rad2deg(1.5 * angle) + 0.2:.5f}"
        for z, angle in zip(travel, toe - toe[0], strict=True)
    ]
    text = "\n".join(["travel [mm]; toe [deg]", *rows])
    (project.root / "front-left.csv").write_text(text)
    question = Question(RIG, {}, measured=["front-left.csv"], overview=True)
    answer = run_tests(project, question)
    verdict = answer.equivalents["compared"][0]
    assert (verdict["quantity"], verdict["verdict"]) == ("left.toe", "outside")
    both, zero = curves(answer)["toe"], int(np.argmin(np.abs(answer.viewer.scenes[0].x)))
    label = next(label for label in both if label.startswith("left, measured"))
    assert both[label][zero] == pytest.approx(both["left"][zero], abs=0.02)


def measured_toe(project, gain):
    """Write a sheet of the rig with another bump steer."""
    run = jn.kc_test(jn.load(RIG), "bounce")
    travel, toe = (np.asarray(run[name]) for name in ("left.wheel_centre_z", "left.toe"))
    rows = [
        f"{1e3 * z:.4f}; {np.rad2deg(gain * (angle - toe[0])):.6f}"
        for z, angle in zip(travel, toe, strict=True)
    ]
    (project.root / "left.csv").write_text("\n".join(["travel [mm]; toe [deg]", *rows]))


@pytest.mark.parametrize(("gain", "verdict"), [(1.05, "within"), (1.5, "outside")])
def test_the_tolerance_of_a_measured_curve_is_a_band_about_it(project, gain, verdict):
    measured_toe(project, gain)
    answer = run_tests(project, Question(RIG, {}, measured=["left.csv"]))
    band = next(item for item in answer.equivalents["bands"] if item["quantity"] == "toe")
    own, x = band["measured"], answer.viewer.scenes[0].x
    low, high = (
        np.interp(x, band["at"], np.array(band[end], dtype=float)) for end in ("low", "high")
    )
    toe = curves(answer)["toe"]
    drawn = toe[next(label for label in toe if label.startswith("left, measured"))]
    inside = (x >= band["at"][0]) & (x <= band["at"][-1])
    assert np.allclose(0.5 * (low + high)[inside], drawn[inside], atol=1e-6, equal_nan=True)
    assert (own["side"], own["verdict"], own["leaves"] is None) == ("left", verdict, gain < 1.1)
    model = toe["left"]
    out = inside & ((model > high + 1e-9) | (model < low - 1e-9))
    assert out.any() == (verdict == "outside")
    if out.any():
        assert np.abs(x[out]).min() == pytest.approx(abs(own["leaves"]), abs=3.0)


@pytest.mark.parametrize(
    "rig", [RIG, "mcpherson-elastic", "formula-student-front", "solid-axle", "twist-beam"]
)
def test_the_picture_moves_as_the_test_says(project, rig):
    question = Question(rig, {}, "roll")
    axle = run_tests(project, question).viewer.scenes[0].motion.mechanism
    run = jn.kc_test(jn.load(rig), "roll")
    order = np.argsort(np.asarray(run["input"]), kind="stable")
    for side, posed in (("left", axle), ("right", axle.other)):
        centre = posed.poses.points["wheel_centre"]
        moves = np.asarray(run[f"{side}.wheel_centre_z"])[order]
        over = np.asarray(run["input"])[order]
        expected = np.interp(posed.poses.over, over, moves)
        design = posed.drawing.design.points["wheel_centre"]
        assert np.allclose(centre[:, 2] - design[2], expected, atol=5e-4)  # friction opens loops
        assert posed.poses.spin_axis[0, 1] * posed.drawing.side > 0.0
        for part in posed.drawing.parts:  # rigid but for rubber, and the bar's twist
            if part.name != "anti_roll_bar":
                first, second = (posed.poses.points[name] for name in part.points[:2])
                length = np.linalg.norm(second - first, axis=1)
                assert np.ptp(length) < 0.004, part.name


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"test": "jump"}, "jump"),
        ({"to": {"jump": "1 mm"}}, "jump"),
        ({"travel": "2 kN"}, "kN"),
        ({"measured": ["../other.csv"]}, "other"),
        ({"rig": "kart-quarter-car"}, "hardpoints"),
    ],
)
def test_what_is_wrong_is_one_message(project, more, said):
    with pytest.raises(JounceError, match=said):
        run_tests(project, Question(**{"rig": RIG, "changes": {}, **more}))


@pytest.mark.parametrize("rig", ["solid-axle", "twist-beam"])
def test_dependent_axles_are_tested_without_a_rack(project, rig):
    answer = run_tests(project, Question(rig, {}, "steer"))
    assert not answer.equivalents["is_steered"]
    assert answer.equivalents["test"] == "bounce"
    assert "steer" not in answer.equivalents["tests"]


@pytest.mark.parametrize(("over", "name"), [("travel", "toe"), ("roll", "camber")])
def test_dependent_axles_are_swept_and_drawn_on_both_sides(project, over, name):
    given = {"travel": "-20 mm:20 mm:10 mm", "roll": "-2 deg:2 deg:1 deg"}
    answer = sweeps.swept(project, sweeps.Question("twist-beam", {}, over=over, **given))
    scene = answer.viewer.scenes[0]
    sweep = getattr(jn, f"sweep_{over}")(jn.load("twist-beam"), given[over])
    assert curves(answer)[f"right.{name}"]["as it is"] == pytest.approx(
        np.degrees(sweep[f"right.{name}"].values), abs=1e-9
    )
    assert "roll_steer" in curves(answer)
    drawn = scene.motion.mechanism
    for side, posed in (("left", drawn), ("right", drawn.other)):
        height = posed.poses.points["wheel_centre"][:, 2]
        assert height == pytest.approx(sweep[f"{side}.wheel_centre_z"].values, abs=1e-9)


def test_the_page_says_that_bushings_yield(project):
    asked = sweeps.Question("solid-axle", {}, "-10 mm:10 mm:10 mm")
    (note,) = sweeps.swept(project, asked).equivalents["notes"]
    assert "bushings yield" in note


@pytest.fixture(scope="module")
def workbench(tmp_path_factory):
    """A workbench over a corner and a twist beam: its address and folder."""
    folder = tmp_path_factory.mktemp("project")
    for name in (RIG, "twist-beam"):
        (folder / f"{name}.toml").write_bytes((LIBRARY / f"{name}.toml").read_bytes())
    command = [sys.executable, "-m", "jounce", "serve", str(folder), "--no-open", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as started:
        yield json.loads(started.stdout.readline())["url"], folder
        started.terminate()


@pytest.fixture
def page(workbench):
    """A page of the workbench in Chromium, and how to go to another."""
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox"])
        page = browser.new_page()
        page.goto(workbench[0])
        yield page
        browser.close()


def go(page, to, ready):
    page.evaluate("(to) => { location.hash = to }", f"#/{to}")
    page.wait_for_selector(f"html[data-ready={ready}]", timeout=60_000)


@pytest.mark.pages
def test_a_stiffness_is_moved_and_written_into_the_file(page, workbench):
    file = workbench[1] / f"{RIG}.toml"
    go(page, f"kc?rig={RIG}.toml", "kc")
    page.wait_for_selector(".sheet tbody tr:nth-child(30)", timeout=60_000)
    page.get_by_role("button", name="Roll", exact=True).click()
    box = page.get_by_role("spinbutton", name=f"{SPRING} ").or_(
        page.locator(f"[data-path='{SPRING}'] input").last
    )
    was = float(box.first.input_value())
    box.first.fill(str(1.1 * was))
    page.wait_for_selector(".sheet tbody .muted", timeout=60_000)
    page.get_by_role("button", name="Save these changes to the file").click()
    page.get_by_role("button", name="Write to the file").click()
    page.get_by_text("Saved. The previous state").wait_for(timeout=60_000)
    assert jn.load(file).parameters()[SPRING] == pytest.approx(
        1.1 * jn.load(RIG).parameters()[SPRING], rel=1e-5
    )


@pytest.mark.pages
@pytest.mark.parametrize("to", ["kinematics", "trial"])
def test_other_pages_lead_dependent_axles_to_the_kc_rig(page, to):
    go(page, f"{to}?rig=twist-beam.toml", to)
    page.get_by_role("link", name="Show its K&C").first.click()
    page.wait_for_selector("html[data-ready=kc]", timeout=60_000)
    page.wait_for_selector(".sheet tbody tr:nth-child(30)", timeout=60_000)


@pytest.mark.pages
def test_a_twist_beam_is_swept_over_roll_on_the_page_kinematics(page):
    go(page, "kinematics?rig=twist-beam.toml", "kinematics")
    page.wait_for_selector("[data-path='hardpoints.shear_centre[2]'] input", timeout=60_000)
    with page.expect_response(lambda answer: "kinematics" in answer.url) as answered:
        page.get_by_label("Curves over").select_option("roll")
    assert answered.value.ok
    assert page.get_by_label("Curves over").locator("option").all_inner_texts() == [
        "wheel travel",
        "roll of the body",
    ]
    assert page.locator(".problem").count() == 0


@pytest.mark.pages
def test_a_hardpoint_is_dragged_in_the_picture_of_the_axle(page, workbench):
    go(page, f"kc?rig={RIG}.toml", "kc")
    page.wait_for_selector(".sheet tbody tr:nth-child(30)", timeout=60_000)
    point = page.get_by_label("Hardpoint", exact=True).first
    point.select_option("wheel_centre")
    before = float(page.get_by_label("z [mm]").first.input_value())
    canvas = page.locator(".movers .mechanism canvas")
    canvas.scroll_into_view_if_needed()
    page.get_by_role("button", name="front", exact=True).click()
    page.get_by_label("Input of the test").fill("0")
    page.wait_for_timeout(300)
    box = canvas.bounding_box()
    moved = False
    for share in np.linspace(0.5, 0.95, 12):  # the left wheel is on one side of the picture
        for height in np.linspace(0.3, 0.8, 9):
            x, y = box["x"] + share * box["width"], box["y"] + height * box["height"]
            page.mouse.move(x, y)
            page.mouse.down()
            page.mouse.move(x, y - 12, steps=3)
            page.mouse.up()
            if page.locator(".points select").first.input_value() != "wheel_centre" or (
                float(page.get_by_label("z [mm]").first.input_value()) != before
            ):
                moved = True
                break
        if moved:
            break
    assert moved
    page.wait_for_selector(".sheet tbody .muted", timeout=60_000)
    page.get_by_role("button", name="Undo", exact=True).click()


@pytest.mark.pages
def test_a_measured_curve_has_its_band_and_verdict(page, workbench):
    measured_toe(Project(workbench[1]), 1.5)
    page.reload()
    go(page, f"kc?rig={RIG}.toml", "kc")
    page.locator(".against > summary").click()
    page.locator(".against input[value='left.csv']").check()
    page.keyboard.press("Escape")
    verdict = page.locator(".multiples figure.wanted .verdict.missed").first
    verdict.wait_for(timeout=60_000)
    assert "mm" in verdict.inner_text()
    assert "left: leaves the tolerance at" in verdict.get_attribute("title")
