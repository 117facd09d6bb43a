"""Answers that come late: what was typed meanwhile stays, and what was left or chosen anew is not taken back by them.

The answers are held, not timed: each comes when the test lets it, so that no machine is too slow or too quick.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import jounce as jn

pytestmark = pytest.mark.pages
TOKEN = "a-token-of-late-answers"
LIBRARY = Path(jn.__file__).parent / "parts" / "library"
RIG, CORNER = "kart-quarter-car.toml", "kart-double-wishbone.toml"


def until(page: Any, happens: Callable[[], object]) -> None:
    """Wait until something is so; the page goes on meanwhile."""
    assert any(happens() or page.wait_for_timeout(20) for _ in range(3000))


class Held:
    """Questions that the server does not hear of before they are let go."""

    def __init__(self, page: Any, glob: str) -> None:
        self.page, self.routes, self.holds = page, [], True  # type: Any, list[Any], bool
        page.route(
            glob, lambda route: self.routes.append(route) if self.holds else route.continue_()
        )

    def come(self) -> list[Any]:
        """Wait until one has been asked."""
        until(self.page, lambda: self.routes)
        return self.routes

    def go(self, answer: object = None, status: int = 200) -> None:
        """Let the one that has waited longest be answered, by the server or as given; it has come when this ends."""
        route = self.come().pop(0)
        with self.page.expect_event("requestfinished", lambda request: request == route.request):
            if answer is None:
                route.continue_()
            else:
                route.fulfill(status=status, json=answer)
        drawn(self.page)

    def refuse(self, why: str) -> None:
        self.go({"error": {"text": why}}, status=422)

    def end(self) -> None:
        """Let all go that are held, and hold no others."""
        self.holds = False
        while self.routes:
            self.go()


@pytest.fixture(scope="module")
def base(workbench: tuple[Path, int]) -> str:
    folder, port = workbench
    for name in (RIG, CORNER):
        shutil.copy(LIBRARY / name, folder / name)
    for name in ("mine/campaign.toml", "c.toml"):  # what they hold is answered by the tests
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text("")
    (folder / "one.csv").write_text(
        "time [s], sprung.z [mm]\n" + "".join(f"{0.01 * i}, {i % 7}\n" for i in range(50))
    )
    return f"http://127.0.0.1:{port}/"


@pytest.fixture(scope="module")
def context(browser: Any, base: str) -> Iterator[Any]:
    made = browser.new_context(viewport={"width": 1280, "height": 720})
    made.set_default_timeout(60_000)
    page = made.new_page()
    page.goto(f"{base}?token={TOKEN}")
    page.wait_for_selector("html[data-ready=project]")
    page.close()
    yield made
    made.close()


@pytest.fixture
def page(context: Any) -> Iterator[Any]:
    made, troubles = context.new_page(), []  # type: Any, list[str]
    made.on("pageerror", lambda error: troubles.append(str(error)))
    yield made
    made.close()
    assert troubles == []


def show(page: Any, base: str, address: str) -> None:
    page.goto(f"{base}#/{address}")
    page.wait_for_selector(f"html[data-ready={address.partition('?')[0]}]")


def typed(field: Any, value: str) -> None:
    """Fill a field in and leave it, as a change is made."""
    field.fill(value)
    field.press("Tab")


def drawn(page: Any) -> None:
    page.evaluate(
        "() => new Promise((done) => setTimeout(() => requestAnimationFrame(() => done())))"
    )


def mass_of(page: Any, part: str) -> Any:
    return page.locator(f"[data-path='{part}.mass'] input").first


def test_what_is_typed_into_a_form_is_not_taken_away_by_the_answer_to_the_field_before(page, base):
    show(page, base, f"rig?name={RIG}")
    text = page.get_by_label(f"text of {RIG}")
    forms = Held(page, "**/api/form")
    typed(mass_of(page, "sprung"), "17 kg")
    other = mass_of(page, "unsprung")
    other.click()
    page.keyboard.press("Control+A")
    page.keyboard.type("6")
    forms.go()
    until(page, lambda: "17 kg" in text.input_value())
    drawn(page)
    assert other.input_value() == "6"
    page.keyboard.type(" kg")
    page.keyboard.press("Tab")
    forms.go()
    page.get_by_text("no problems found").wait_for()
    assert [mass_of(page, one).input_value() for one in ("sprung", "unsprung")] == ["17 kg", "6 kg"]
    assert '"6 kg"' in text.input_value()


def test_what_is_typed_into_a_text_stays_while_its_first_answer_and_that_of_a_save_are_under_way(
    page, base, workbench
):
    forms, saves = Held(page, "**/api/form"), Held(page, "**/api/file*")
    page.goto(f"{base}#/rig?name={RIG}")
    text = page.get_by_label(f"text of {RIG}")
    saves.go()  # its text is read
    text.press("Control+Home")
    page.keyboard.type("# first\n")
    forms.go()
    assert text.input_value().startswith("# first\n")
    forms.end()
    page.get_by_text("no problems found").wait_for()
    page.get_by_role("button", name="Save").click()
    page.get_by_role("button", name="Write to the file").click()
    saves.come()
    text.press("Control+Home")
    page.keyboard.type("# second\n")
    typed(mass_of(page, "sprung"), "18 kg")
    saves.go()
    page.get_by_text("Saved.").wait_for()
    until(page, lambda: "18 kg" in text.input_value())
    drawn(page)
    assert text.input_value().startswith("# second\n# first\n")
    assert (workbench[0] / RIG).read_text().startswith("# first\n")
    assert page.get_by_role("button", name="Save").is_enabled()


def test_what_is_set_and_typed_at_once_stands_in_the_text_after_every_answer(page, base):
    show(page, base, f"rig?name={CORNER}")
    text, forms = page.get_by_label(f"text of {CORNER}"), Held(page, "**/api/form")
    wanted = {"sprung.mass": "17 kg", "tyre.stiffness": "139 N/mm", "wheel.radius": "128 mm"}
    for path, value in wanted.items():
        page.locator(f"[data-path='{path}'] input").first.evaluate(
            "(one, value) => { one.value = value; one.dispatchEvent(new Event('change', {bubbles: true})); }",
            value,
        )
    text.press("Control+Home")
    page.keyboard.type("# mine\n")
    for _ in range(
        len(wanted) + 2
    ):  # the first was asked of the text without the line, and is asked again
        forms.go()
        assert text.input_value().startswith("# mine\n")
    forms.end()
    page.get_by_text("no problems found").wait_for()
    assert all(one in text.input_value() for one in ("# mine\n", *wanted.values()))
    assert [page.locator(f"[data-path='{path}'] input").first.input_value() for path in wanted] == [
        *wanted.values()
    ]


def test_what_a_save_would_change_stays_on_the_page_when_its_text_is_found_to_be_right(page, base):
    show(page, base, f"rig?name={RIG}")
    text, forms = page.get_by_label(f"text of {RIG}"), Held(page, "**/api/form")
    text.evaluate(  # in one go: the text is asked about 0.4 s after it was typed, however long that takes here
        """(one) => { one.value = "# typed\\n" + one.value; one.dispatchEvent(new Event("input"));
                     [...document.querySelectorAll("button")].find((own) => own.textContent === "Save").click(); }"""
    )
    forms.go()
    write = page.get_by_role("button", name="Write to the file")
    write.wait_for()
    forms.go()  # of what was typed, which is asked about when nothing more is
    page.get_by_text("no problems found").wait_for()
    assert write.is_visible()
    mass = mass_of(page, "sprung")
    typed(mass, "21 kg")
    forms.come()
    write.click()  # it would not hold what was set meanwhile
    forms.end()
    page.locator(".difference .added", has_text="21 kg").wait_for()
    assert page.get_by_text("Saved.").count() == 0


def test_undo_takes_back_the_edit_that_is_under_way_and_what_was_typed_last(page, base):
    show(page, base, f"rig?name={RIG}")
    text = page.get_by_label(f"text of {RIG}")
    before = text.input_value()
    typed(mass_of(page, "sprung"), "19 kg")
    until(page, lambda: "19 kg" in text.input_value())
    one = text.input_value()
    forms = Held(page, "**/api/form")
    typed(mass_of(page, "unsprung"), "7 kg")
    forms.come()
    page.get_by_role("button", name="Undo").click()
    forms.end()
    page.get_by_text("no problems found").wait_for()
    until(page, lambda: text.input_value() == one)
    page.get_by_role("button", name="Redo").click()
    until(page, lambda: "7 kg" in text.input_value())
    text.press("Control+Home")
    page.keyboard.type("# mine\n")
    page.get_by_role("button", name="Undo").click()
    until(page, lambda: "# mine" not in text.input_value())
    assert "7 kg" in text.input_value()
    page.get_by_role("button", name="Redo").click()
    until(page, lambda: "# mine" in text.input_value())
    assert before != one


def test_the_rows_of_another_vehicle_go_at_once_and_its_search_waits_for_its_numbers(page, base):
    show(page, base, "ride")
    bounds, search = page.get_by_label("bounds"), page.get_by_role("button", name="Search")
    bounds.wait_for()
    rigs = Held(page, "**/api/rig?*")
    vehicle = page.get_by_label("Vehicle or rig").nth(1)
    vehicle.select_option(RIG)
    rigs.come()
    assert bounds.count() == 0
    assert search.is_disabled()
    assert page.get_by_role("button", name="Add a parameter").is_disabled()
    vehicle.select_option("audi-a6-quarter-car")
    until(page, lambda: len(rigs.routes) == 2)
    rigs.routes.reverse()  # the answer to the choice before comes last
    rigs.go()
    bounds.fill("600..6000 N*s/m")
    rigs.go()
    assert bounds.input_value() == "600..6000 N*s/m"
    assert search.is_enabled()


def test_what_is_begun_is_what_was_asked_for_whatever_is_typed_meanwhile(page, base):
    show(page, base, "studies")
    page.get_by_label("Count").fill("4")
    name, into = page.get_by_label("Study file"), page.get_by_label("Results folder")
    typed(name, "mine.toml")
    studies, jobs = Held(page, "**/api/study"), Held(page, "**/api/jobs")
    page.get_by_role("button", name="Save and start").click()
    studies.come()
    assert page.get_by_role("button", name="Save the study").is_disabled()
    name.fill("other.toml")
    into.fill("elsewhere")
    studies.go({"digest": "of mine", "count": 4, "path": "mine.toml"})
    (begun,) = jobs.come()
    asked = json.loads(begun.request.post_data)
    assert (asked["study"], asked["out"]) == ("mine.toml", "mine-swept")
    jobs.refuse("enough")
    page.get_by_text("enough").wait_for()
    page.get_by_role("button", name="Save the study").click()
    (second,) = studies.come()
    assert (
        json.loads(second.request.post_data)["was"] == ""
    )  # another file than the one that was written
    studies.refuse("it lies there")
    assert name.input_value() == "other.toml"
    page.get_by_role("button", name="Save the study").wait_for()
    typed(name, "mine.toml")
    page.get_by_role("button", name="Save the study").click()
    assert json.loads(studies.come()[0].request.post_data)["was"] == "of mine"
    studies.end()


def test_an_answer_takes_nobody_from_the_page_where_they_are_by_now(page, base):
    answers = [
        ("ride", "**/api/jobs", "Drive"),
        ("campaign", "**/api/ask", "Copy into this project"),
    ]
    for address, glob, button in answers:
        show(page, base, address)
        held = Held(page, glob)
        page.get_by_role("button", name=button, exact=True).click()
        held.come()
        show(page, base, "jobs")
        held.go({"id": "one", "result": {}})
        assert page.url.partition("#")[2].startswith("/jobs")
    show(page, base, "campaign")
    held = Held(page, "**/api/ask")
    page.get_by_label("Folder").fill("mine")
    page.get_by_role("button", name="Copy into this project").click()
    held.come()
    page.get_by_label("Folder").fill("another")
    asked = Held(page, "**/api/campaign?*")
    held.go({"result": {}})
    assert asked.come()[0].request.url.endswith("path=mine%2Fcampaign.toml")
    asked.refuse("enough")


def test_a_file_that_arrives_late_leaves_the_form_of_an_inspection_as_it_is(page, base, workbench):
    (workbench[0] / "lane.csv").write_text("time [s], front_left.plate.force [N]\n0, 1\n")
    show(page, base, "inspection")
    plate, record = page.get_by_label("Number plate").first, page.get_by_label("Record of one axle")
    files, asks = Held(page, "**/api/upload?*"), Held(page, "**/api/ask")
    drop = page.locator(".drop input[type=file]")
    content = {"mimeType": "text/csv", "buffer": b"time [s], front_left.tyre.force [N]\n0, 1\n"}
    drop.set_input_files([{"name": "axle.csv", **content}, {"name": "second.csv", **content}])
    files.come()
    drop.set_input_files(
        [{"name": "axle.csv", **content}]
    )  # once more, while the first is under way
    plate.fill("B-AB 1")
    for one in ("axle.csv", "second.csv"):
        files.go({"path": f"records/{one}", "size": 9})
    page.get_by_text("records/axle.csv, records/second.csv: uploaded.").wait_for()
    files.refuse("the file already exists")
    page.get_by_text("the file already exists").wait_for()
    assert page.get_by_text("records/axle.csv, records/second.csv: uploaded.").is_visible()
    assert (plate.input_value(), record.input_value()) == ("B-AB 1", "records/axle.csv")
    page.get_by_text("No record available?").click()
    out = page.get_by_label("Record", exact=True)
    out.fill("first.csv")
    page.get_by_role("button", name="Simulate the test").click()
    asks.come()
    out.fill("next.csv")
    asks.go({"result": {}, "python": "", "command": "", "files": {}, "report": ""})
    page.get_by_text("first.csv was saved.").wait_for()
    assert "record=first.csv" in page.get_by_role("link", name="Evaluate").get_attribute("href")


def test_a_file_is_read_as_one_of_the_same_columns_was_unless_it_is_said_otherwise(page, base):
    """Sixteen trials of a bench have the columns of the first."""
    read = {"columns": {"time": "t [ms]", "sprung.az": "up"}, "stroke_positive": "extension"}
    trials = [
        {"number": 1, "file": "one.csv", **read},
        {"number": 2, "file": "two.csv", "columns": {"time": "other"}},
    ]
    nothing = {
        "title": "Bench",
        "synthetic": "",
        "rig": RIG,
        "roads": ["A"],
        "mass": "",
        "bench": [],
        "updates": [],
    }
    page.route("**/api/campaign?*", lambda route: route.fulfill(json={**nothing, "trials": trials}))
    asks = Held(page, "**/api/ask")
    columns = [
        {"name": name, "unit": "", "count": 9, "least": 0.0, "greatest": 1.0}
        for name in ("t", "up")
    ]
    found = {
        "columns": columns,
        "more": 0,
        "problem": None,
        "findings": [],
        "content": None,
        "points": None,
    }
    answer = {"result": found, "python": "", "command": "", "files": {}, "report": ""}
    page.goto(f"{base}#/campaign?file=mine/campaign.toml&read=three.csv")
    asks.go(answer)
    page.get_by_role("button", name="Read with the settings of one.csv").click()
    asked = asks.come()[0].request.post_data_json
    assert {key: asked[key] for key in read} == read
    asks.go(answer)
    assert page.get_by_label("quantity of up").input_value() == "sprung.az"
    assert page.get_by_label("unit of t", exact=True).input_value() == "ms"
    assert not page.get_by_role("button", name="Read with the settings").count()


def test_what_is_moved_or_wanted_while_a_rig_is_written_is_there_after_it(page, base, workbench):
    show(page, base, f"kinematics?rig={CORNER}")
    page.get_by_label("Tolerance").fill("0.2 deg")
    page.get_by_role("button", name="Add the target").click()
    number = page.locator(".sliders:not(.drives) .slider input[type=number]")
    number.nth(0).fill("201")
    saves = Held(page, "**/api/file")
    page.get_by_role("button", name="Save these changes to the file").click()
    page.get_by_role("button", name="Write to the file").click()
    saves.come()
    number.nth(1).fill("202")
    page.evaluate("delete document.documentElement.dataset.ready")
    saves.go()
    page.wait_for_selector("html[data-ready=kinematics]")
    page.get_by_text("Saved. The previous state").wait_for()
    assert [number.nth(i).input_value() for i in (0, 1)] == ["201", "202"]
    assert "201 mm" in (workbench[0] / CORNER).read_text()
    assert "202 mm" not in (workbench[0] / CORNER).read_text()
    page.get_by_text("± 0.2 deg").wait_for()


def test_the_pose_stays_in_the_sweep_that_is_drawn_until_another_one_is(page, base):
    show(page, base, f"kinematics?rig={CORNER}")
    sweeps = Held(page, "**/api/kinematics")
    rack = page.get_by_label("Rack travel, to the left positive [mm], typed")
    page.get_by_label("Curves over").select_option("rack")
    sweeps.come()
    holder = page.locator(".multiples .holder").first
    box = holder.bounding_box()
    page.mouse.move(box["x"] + 0.9 * box["width"], box["y"] + 20)
    assert (
        rack.input_value() == "0"
    )  # the curves are those over travel, and so is what the pointer is at
    sweeps.go()
    page.mouse.move(box["x"] + 0.8 * box["width"], box["y"] + 20)
    until(page, lambda: float(rack.input_value()) > 3.0)


def test_a_file_that_arrives_late_does_not_take_the_place_of_the_one_that_is_entered(page, base):
    campaigns, asks, files = (
        Held(page, f"**/api/{one}") for one in ("campaign?*", "ask", "upload?*")
    )
    page.goto(f"{base}#/campaign?file=c.toml")
    trial = {
        "number": 1,
        "file": "one.csv",
        "recording": "one.csv",
        "use": "fit",
        "road": "A",
        "speed": "2 m/s",
    }
    whole = {
        "title": "Mine",
        "synthetic": "",
        "rig": "r.toml",
        "roads": ["A"],
        "mass": "16 kg",
        "bench": [],
    }
    campaigns.go(whole | {"trials": [trial], "updates": []})
    content = {"mimeType": "text/csv", "buffer": b"time [s], sprung.z [mm]\n0, 1\n"}
    page.locator(".drop input[type=file]").set_input_files([{"name": "late.csv", **content}])
    files.come()
    page.get_by_role("button", name="view one.csv").click()
    page.get_by_role("textbox", name="Speed", exact=True).fill("3 m/s")
    files.go({"path": "measured/late.csv", "size": 9})
    page.get_by_text("measured/late.csv: uploaded.").wait_for()
    assert page.get_by_role("heading", name="one.csv").is_visible()
    assert page.get_by_role("textbox", name="Speed", exact=True).input_value() == "3 m/s"
    page.get_by_role("button", name="view measured/late.csv").click()
    page.get_by_role("heading", name="measured/late.csv").wait_for()
    columns = [{"name": "z", "unit": "mm", "count": 2, "least": 0.0, "greatest": 1.0}]
    preview = {
        "columns": columns,
        "more": 0,
        "problem": None,
        "findings": [],
        "content": None,
        "points": None,
    }
    answer = {"result": preview, "python": "", "command": "", "files": {}, "report": ""}
    asks.go(answer)  # of the file that was opened before
    assert page.get_by_label("unit of z").count() == 0
    asks.go(answer)
    page.get_by_label("unit of z").wait_for()
    typed(page.get_by_label("Variable or group"), "other")
    asks.come()
    assert (
        page.get_by_label("unit of z").count() == 0
    )  # what is typed there would be of columns that are left
    asks.go(answer)
    page.get_by_label("unit of z").wait_for()


def test_a_card_of_a_job_takes_no_older_news_and_opens_its_results_as_often_as_asked(page, base):
    job = {
        "id": "one",
        "kind": "design",
        "asked": {"out": "o"},
        "title": "Mine",
        "state": "running",
        "said": "",
        "out": "",
    }
    job |= {
        "python": "",
        "command": "",
        "files": {},
        "begun": 1.0,
        "ended": None,
        "share": 0.5,
        "left": 9.0,
        "steps": [],
    }
    done = job | {"error": None, "state": "done", "ended": 2.0}
    sockets: list[Any] = []
    page.route_web_socket("**/api/live", lambda socket: sockets.append(socket))  # noqa: PLW0108 - it is marked
    show(page, base, "jobs")
    until(page, lambda: sockets)
    for told in ([job | {"error": None}], [done], [job | {"error": None}]):
        sockets[0].send(json.dumps(told))
    opens = page.get_by_role("button", name="Show the results: Mine")
    opens.wait_for()
    drawn(page)
    for _ in range(2):
        with page.context.expect_page() as opened:
            opens.click()
        opened.value.close()


@pytest.mark.parametrize(
    ("name", "page_of", "number", "unit", "used"),
    [
        (RIG, "trial", "sprung.mass", "kg", "strut.spring.rate [N/mm], typed"),
        (
            CORNER,
            "kinematics",
            "hardpoints.tie_rod_outer[2]",
            "mm",
            "Rack travel, to the left positive [mm], typed",
        ),
    ],
)
def test_numbers_whose_file_was_changed_under_their_page_are_told_and_loaded_again(
    page, base, workbench, name, page_of, number, unit, used
):
    file = workbench[0] / name
    was, rig = file.read_bytes(), jn.load(file)
    show(page, base, f"{page_of}?rig={name}")
    field, told = (
        page.get_by_label(f"{number} [{unit}], typed", exact=True),
        page.get_by_text(f"{name} has changed"),
    )
    before = float(field.input_value())
    assert not told.count()
    jn.save(rig.with_changes({number: 1.25 * rig.parameters()[number]}), file, force=True)
    typed(page.get_by_label(used), "19")
    told.wait_for()
    assert float(field.input_value()) == before
    page.get_by_role("button", name="Reload").click()
    until(page, lambda: field.count() == 1 and float(field.input_value()) == 1.25 * before)
    page.get_by_text("drawn in").wait_for()
    assert not told.count()
    file.write_bytes(was)
