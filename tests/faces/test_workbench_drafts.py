"""What was entered and not saved: kept however its page is left, offered again, and written over no file by itself."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import jounce as jn
from jounce.web.serving import usual_port

TOKEN = "a-token-of-drafts"
LIBRARY = Path(jn.__file__).parent / "parts" / "library"
RIG, CORNER = "kart-quarter-car.toml", "kart-double-wishbone.toml"
FULL = """const own = Storage.prototype.setItem;
Storage.prototype.setItem = function (key, value) {
  if (key.startsWith('jounce-draft')) throw new Error('full');
  own.call(this, key, value);
};"""
pages = pytest.mark.pages


@pytest.fixture(scope="module")
def project(workbench: tuple[Path, int]) -> tuple[Path, str]:
    folder, port = workbench
    for name in (RIG, CORNER):
        shutil.copy(LIBRARY / name, folder / name)
    (folder / "one.csv").write_text(
        "time [s], sprung.z [mm]\n" + "".join(f"{0.01 * i}, {i % 7}\n" for i in range(50))
    )
    return folder, f"http://127.0.0.1:{port}/"


@pytest.fixture
def page(browser: Any, project: tuple[Path, str]) -> Iterator[Any]:
    """A page of a browser that remembers nothing yet."""
    context, troubles = browser.new_context(viewport={"width": 1280, "height": 720}), []  # type: Any, list[str]
    context.set_default_timeout(60_000)
    made = context.new_page()
    made.on("pageerror", lambda error: troubles.append(str(error)))
    made.goto(f"{project[1]}?token={TOKEN}")
    made.wait_for_selector("html[data-ready=project]")
    yield made
    context.close()
    assert troubles == []


def show(page: Any, base: str, address: str) -> None:
    page.goto(f"{base}#/{address}")
    page.wait_for_selector(f"html[data-ready={address.partition('?')[0]}]")


def until(page: Any, happens: Callable[[], object]) -> None:
    """Wait until something is so; the page goes on meanwhile."""
    assert any(happens() or page.wait_for_timeout(20) for _ in range(3000))


def offers(page: Any) -> Any:
    return page.get_by_role("region", name="Unsaved changes")


def to_project(page: Any) -> None:
    page.get_by_role("navigation").get_by_role("link", name="Project").click()
    page.wait_for_selector("html[data-ready=project]")


@pages
def test_a_text_that_was_left_is_offered_restored_undone_and_discarded(
    page: Any, project: tuple[Path, str]
) -> None:
    folder, base = project
    saved = (folder / RIG).read_text()
    show(page, base, f"rig?name={RIG}")
    text = page.get_by_label(f"text of {RIG}")
    assert not offers(page).is_visible()
    text.press("Control+Home")
    page.keyboard.type("# mine\n")
    to_project(page)  # at once: nothing waits for the end of the typing
    offers(page).get_by_role("link", name=RIG).click()
    page.wait_for_selector("html[data-ready=rig]")
    assert text.input_value() == saved
    offers(page).get_by_role("button", name="Restore").click()
    page.get_by_text("Restored.").wait_for()
    assert text.input_value() == f"# mine\n{saved}"
    assert (
        page.evaluate("document.activeElement.className") == "drafts"
    )  # the keyboard goes on from there
    page.get_by_role("button", name="Undo").click()
    page.get_by_role("button", name="Save").and_(page.locator(":disabled")).wait_for()
    assert text.input_value() == saved
    page.get_by_role("button", name="Redo").click()
    page.get_by_role("button", name="Save").and_(page.locator(":enabled")).wait_for()
    page.go_back()
    page.wait_for_selector("html[data-ready=project]")
    page.go_forward()
    page.wait_for_selector("html[data-ready=rig]")
    offers(page).get_by_role("button", name="Discard").click()
    page.get_by_text("Discarded.").wait_for()
    page.reload()
    page.wait_for_selector("html[data-ready=rig]")
    assert not offers(page).is_visible()
    assert (folder / RIG).read_text() == saved


@pages
def test_a_tab_that_was_closed_says_that_its_file_was_changed_since(
    page: Any, project: tuple[Path, str]
) -> None:
    folder, base = project
    show(page, base, f"rig?name={CORNER}")
    page.get_by_label(f"text of {CORNER}").press("Control+Home")
    page.keyboard.type("# mine\n")
    context = page.context
    page.close(run_before_unload=True)  # nobody is asked: it is kept
    changed = f"# theirs\n{(LIBRARY / CORNER).read_text()}"
    (folder / CORNER).write_text(changed)
    page = context.new_page()
    show(page, base, f"rig?name={CORNER}")
    page.get_by_text("The file has changed since then").wait_for()
    offers(page).get_by_role("button", name="Restore").click()
    page.get_by_text("Restored.").wait_for()
    page.get_by_role("button", name="Save").click()
    difference = page.get_by_role("region", name="Changes to the file")
    assert {"-# theirs", "+# mine"} <= set(difference.inner_text().splitlines())
    assert (folder / CORNER).read_text() == changed
    (folder / CORNER).unlink()
    page.reload()
    assert (
        page.locator("pre").inner_text().startswith("# mine")
    )  # to be copied, where its file is gone
    shutil.copy(LIBRARY / CORNER, folder / CORNER)


@pages
def test_only_what_a_browser_cannot_keep_is_asked_about(
    page: Any, project: tuple[Path, str]
) -> None:
    _, base = project
    page.add_init_script(FULL)
    page.reload()
    show(page, base, f"rig?name={RIG}")
    text, asked = page.get_by_label(f"text of {RIG}"), []  # type: Any, list[str]

    def dismiss(dialog: Any) -> None:
        asked.append(dialog.type)
        dialog.dismiss()

    page.on("dialog", dismiss)
    text.press("Control+Home")
    page.keyboard.type("# mine\n")
    page.get_by_role("navigation").get_by_role("link", name="Project").click()
    until(page, lambda: asked == ["confirm"] and page.url.endswith(RIG))
    assert text.input_value().startswith("# mine")
    page.evaluate("setTimeout(() => location.reload())")
    until(page, lambda: asked == ["confirm", "beforeunload"])
    assert text.input_value().startswith("# mine")


@pages
def test_forms_that_were_left_are_filled_in_again(page: Any, project: tuple[Path, str]) -> None:
    folder, base = project
    (folder / "lane.csv").write_text("time [s], front_left.plate.force [N]\n0, 1\n")

    def again(address: str) -> None:
        to_project(page)
        show(page, base, address)
        offers(page).get_by_role("button", name="Restore").click()
        page.get_by_text("Restored.").wait_for()

    show(page, base, "studies")
    page.get_by_label("Rig").select_option(RIG)
    page.get_by_label("Count").fill("33")
    page.get_by_label("tyre.stiffness, share").wait_for()
    page.get_by_role("button", name="remove tyre.stiffness").click()
    page.get_by_role("button", name="Add a parameter").click()
    page.get_by_label("parameter to vary").last.fill("sprung.mass")
    page.get_by_label("parameter to vary").last.press("Tab")
    page.get_by_label("distribution").last.select_option("range")
    page.get_by_label("sprung.mass, to").fill("18 kg")
    again("studies")
    assert page.get_by_label("Rig").input_value() == RIG
    assert page.get_by_label("Count").input_value() == "33"
    assert page.get_by_label("sprung.mass, to").input_value() == "18 kg"
    assert not page.get_by_label("tyre.stiffness, share").is_visible()
    page.get_by_role("button", name="Save the study").click()
    page.get_by_text("study.toml: 33 variants").wait_for()
    to_project(page)
    assert not offers(page).is_visible()  # it is written

    show(page, base, "ride")
    page.get_by_label("Seed").fill("7")
    page.get_by_label("passive").uncheck()
    page.get_by_label("bounds").fill("1..2 kN*s/m")
    again("ride")
    assert page.get_by_label("Seed").input_value() == "7"
    assert not page.get_by_label("passive").is_checked()
    assert page.get_by_label("bounds").input_value() == "1..2 kN*s/m"

    show(page, base, "inspection")
    page.get_by_label("Number plate").first.fill("B-AB 77")
    again("inspection")
    assert page.get_by_label("Number plate").first.input_value() == "B-AB 77"

    show(page, base, "campaign")
    page.get_by_label("Folder").fill("mine")
    page.get_by_role("button", name="Copy into this project").click()
    page.get_by_role("heading", name="My bench campaign").wait_for()
    show(page, base, "campaign?file=mine/campaign.toml&read=one.csv")
    spring = page.locator("section.job", has=page.get_by_role("heading", name="spring", exact=True))
    spring.get_by_label("Ignore deflections below").fill("3 mm")
    page.get_by_label("Oscillating mass").fill("17 kg")
    page.get_by_label("Results folder").fill("mine/again")
    page.get_by_label("quantity of sprung.z").fill("unsprung.z")
    page.get_by_label("quantity of sprung.z").press("Tab")
    page.get_by_label("Tyre pressure").fill("0.3 MPa")
    again("campaign?file=mine/campaign.toml")
    assert page.get_by_label("quantity of sprung.z").input_value() == "unsprung.z"
    assert page.get_by_label("Tyre pressure").input_value() == "0.3 MPa"
    assert spring.get_by_label("Ignore deflections below").input_value() == "3 mm"
    assert page.get_by_label("Oscillating mass").input_value() == "17 kg"
    assert page.get_by_label("Results folder").input_value() == "mine/again"
    again("campaign?file=mine/campaign.toml")  # it is not saved by being restored
    assert page.get_by_label("quantity of sprung.z").input_value() == "unsprung.z"


@pages
def test_what_was_entered_of_a_campaign_goes_with_any_text_of_its_file(
    page: Any, project: tuple[Path, str]
) -> None:
    """A file that was entered, or saved, changes the text: what else was typed is no draft of the text before it."""
    folder, base = project
    jn.new_campaign(folder / "entered")
    file, address = folder / "entered" / "campaign.toml", "campaign?file=entered/campaign.toml"

    def left_and_restored() -> None:
        to_project(page)
        show(page, base, address)
        assert not page.get_by_text("The file has changed since then").is_visible()
        offers(page).get_by_role("button", name="Restore").click()
        page.get_by_text("Restored.").wait_for()

    def typed(was: str, now: str) -> None:
        if not text.is_visible():
            page.get_by_text("Campaign file", exact=True).click()
        text.fill(text.input_value().replace(was, now, 1))

    show(page, base, address)
    text, out = (
        page.get_by_label("text of entered/campaign.toml"),
        page.get_by_label("Results folder"),
    )
    mass = page.get_by_label("Oscillating mass")
    assert mass.input_value() == "16 kg"
    typed('title = "My', 'title = "Your')
    left_and_restored()  # nobody changed it
    page.get_by_role("button", name="Discard", exact=True).last.click()
    out.fill("entered/again")
    to_project(page)
    rig = folder / "entered" / "rig.toml"
    rig.write_text(rig.read_text().replace('mass = "16 kg"', 'mass = "20 kg"', 1))
    file.write_text(f"{file.read_text()}\n# entered elsewhere\n")
    left_and_restored()
    assert out.input_value() == "entered/again"
    assert mass.input_value() == "20 kg"  # nobody typed it
    assert text.input_value().endswith("# entered elsewhere\n")
    typed('title = "My', 'title = "Our')
    page.get_by_role("button", name="Run the campaign").click()
    page.get_by_role("alert").filter(has_text="unsaved edits").wait_for()
    page.get_by_role("button", name="Discard", exact=True).last.click()
    assert 'title = "My' in text.input_value()
    typed('title = "My', 'title = "Our')
    page.get_by_role("button", name="Save", exact=True).click()
    page.get_by_role("heading", name="Our bench campaign").wait_for()
    left_and_restored()  # what was saved is no part of it
    assert 'title = "Our' in text.input_value()

    whole = file.read_text()
    to_project(page)
    file.write_text("[[[")
    show(page, base, address)
    page.get_by_role("alert").filter(has_text="not valid TOML").wait_for()
    offers(page).get_by_role("button", name="Restore").click()
    page.get_by_text("Restored.").wait_for()
    assert text.input_value() == "[[["
    to_project(page)
    file.write_text(whole)
    show(page, base, address)
    offers(page).get_by_role("button", name="Restore").click()
    page.get_by_text("Restored.").wait_for()
    assert out.input_value() == "entered/again"  # the page of a broken file kept it


@pages
def test_a_trial_that_was_left_is_taken_up_again(page: Any, project: tuple[Path, str]) -> None:
    _, base = project
    show(page, base, f"trial?rig={RIG}")
    page.get_by_label("Obstacle").select_option("pothole")
    page.get_by_label("Depth").fill("33 mm")
    page.get_by_role("textbox", name="Speed").fill("3 m/s")
    page.get_by_label("strut.spring.rate [N/mm], typed").fill("30")
    page.get_by_label("another parameter").select_option("strut.spring.preload")
    page.get_by_label("strut.spring.preload [N], typed").fill("20")
    to_project(page)
    offers(page).get_by_role("link", name=RIG).click()
    page.wait_for_selector("html[data-ready=trial]")
    assert page.get_by_role("textbox", name="Speed").input_value() == "1.95 m/s"
    page.get_by_label("tyre.stiffness [N/mm], typed").fill("150")  # which is not of the draft
    offers(page).get_by_role("button", name="Restore").click()
    page.get_by_text("Restored.").wait_for()
    assert page.get_by_label("Obstacle").input_value() == "pothole"
    assert page.get_by_label("Depth").input_value() == "33 mm"
    assert page.get_by_role("textbox", name="Speed").input_value() == "3 m/s"
    assert page.get_by_label("strut.spring.rate [N/mm], typed").input_value() == "30"
    command = page.get_by_label("The same on the command line")
    command.filter(has_text="strut.spring.preload").filter(has_text="3 m/s").wait_for()
    assert "tyre.stiffness" not in command.inner_text()
    page.get_by_role("button", name="Save the run").click()
    page.get_by_text("Saved as").wait_for()
    to_project(page)
    assert not offers(page).is_visible()  # it lies in the project


@pages
def test_the_head_goes_on_with_the_rig_that_is_open(page: Any, project: tuple[Path, str]) -> None:
    _, base = project
    head = page.get_by_role("navigation")

    def leads(word: str) -> str | None:
        found: str | None = head.get_by_role("link", name=word).get_attribute("href")
        return found

    assert leads("Kinematics") == "#/kinematics?"
    show(page, base, f"rig?name={CORNER}")
    assert leads("Kinematics") == f"#/kinematics?rig={CORNER}"
    assert leads("Trial") == f"#/trial?rig={CORNER}"
    assert leads("Rig") == "#/rig?"  # to another one
    head.get_by_role("link", name="Ride").click()
    page.wait_for_selector("html[data-ready=ride]")
    assert page.get_by_label("Vehicle or rig").first.input_value() == CORNER
    page.get_by_label("Vehicle or rig").first.select_option("kart-quarter-car")
    assert leads("Trial") == "#/trial?rig=kart-quarter-car"
    assert leads("Rig") == "#/rig?"  # what is shipped has no file to be edited
    to_project(page)
    page.reload()
    page.wait_for_selector("html[data-ready=project]")
    assert leads("Trial") == "#/trial?rig=kart-quarter-car"
    show(page, base, "trial?rig=gone.toml")
    assert leads("Kinematics") == "#/kinematics?"


@pages
def test_what_is_edited_is_undone(page: Any, project: tuple[Path, str]) -> None:
    folder, base = project
    show(page, base, f"trial?rig={RIG}")
    spring, obstacle = (
        page.get_by_label("strut.spring.rate [N/mm], typed"),
        page.get_by_label("Obstacle"),
    )
    undo, redo = page.get_by_role("button", name="Undo"), page.get_by_role("button", name="Redo")
    assert undo.is_disabled()
    before = spring.input_value()
    spring.fill("30")
    page.locator("button:enabled", has_text="Undo").wait_for()
    page.wait_for_timeout(400)  # a pause: what follows is another step
    obstacle.select_option("pothole")
    page.get_by_label("Depth").fill("33 mm")
    undo.click()
    assert (obstacle.input_value(), spring.input_value()) == ("half-sine", "30")
    undo.click()
    assert spring.input_value() == before
    assert undo.is_disabled()
    page.keyboard.press("Control+y")
    redo.click()
    assert (page.get_by_label("Depth").input_value(), spring.input_value()) == ("33 mm", "30")
    page.get_by_role("button", name="Reset all").click()
    undo.click()
    assert spring.input_value() == "30"

    show(page, base, f"kinematics?rig={CORNER}")
    height = page.get_by_label(re.compile(r"^hardpoints.lower_ball_joint\[2\] \[mm\], typed"))
    before = height.input_value()
    height.fill(str(float(before) + 3.0))
    undo.click()  # at once: it is a step by now
    assert height.input_value() == before
    redo.click()
    assert float(height.input_value()) == float(before) + 3.0

    show(page, base, "campaign")
    page.get_by_label("Folder").fill("taken")
    page.get_by_role("button", name="Copy into this project").click()
    page.get_by_role("heading", name="My bench campaign").wait_for()
    text = (folder / "taken" / "campaign.toml").read_text()
    show(page, base, "campaign?file=taken/campaign.toml&read=taken/trials/01.csv")
    page.get_by_role("button", name="Add to the campaign").click()
    page.get_by_text("Added to the campaign.").wait_for()
    assert (folder / "taken" / "campaign.toml").read_text() != text
    undo.click()
    page.get_by_text("Added to the campaign.").wait_for(state="hidden")
    assert (folder / "taken" / "campaign.toml").read_text() == text


@pages
def test_how_an_edit_is_done_in_python_follows_the_text(
    page: Any, project: tuple[Path, str]
) -> None:
    folder, base = project
    shutil.copy(LIBRARY / RIG, folder / "told.toml")
    show(page, base, "rig?name=told.toml")
    text, python = page.get_by_label("text of told.toml"), page.get_by_label("The same in Python")
    command = page.get_by_label("The same on the command line")

    def says(words: str) -> None:
        until(page, lambda: python.is_visible() and words in python.inner_text())

    says("print(rig)")
    assert command.is_visible()
    whole = text.input_value()
    text.fill(whole.replace('mass = "16 kg"', 'mass = "17 kg"', 1))
    says("with_changes({'sprung.mass': 17.0})")
    assert not command.is_visible()  # which checks what is saved
    text.fill("[[[")
    python.wait_for(state="hidden")  # what is wrong is no edit
    text.fill(whole.replace('mass = "16 kg"', 'mass = "17 kg"', 1))
    says("with_changes({'sprung.mass': 17.0})")
    page.get_by_role("button", name="Save", exact=True).click()
    page.get_by_role("button", name="Write to the file").click()
    page.get_by_text("Saved.", exact=True).wait_for()
    says("print(rig)")
    command.wait_for()


def test_a_server_comes_back_where_the_browser_knows_it(tmp_path: Path) -> None:
    """What a browser keeps, it keeps for an address with its port."""
    ports = {usual_port(tmp_path / str(i)) for i in range(50)}
    assert usual_port(tmp_path / "1") == usual_port(tmp_path / "x" / ".." / "1")
    assert len(ports) > 45
    assert 20_000 <= min(ports) <= max(ports) < 30_000
