"""Files dropped on any page: recognised, mended, and entered together into a campaign."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any

import pytest

import jounce as jn
from jounce.core.errors import JounceError, OutputError

pytest.importorskip("fastapi")
TOKEN = "a-token-of-files"
AXE = Path(__file__).parents[2] / "viewer" / "node_modules" / "axe-core" / "axe.min.js"
RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]
DROP = """files => {
  const dropped = new DataTransfer(), place = document.querySelector('h1');
  for (const [name, text] of files) dropped.items.add(new File([text], name));
  for (const kind of ['dragover', 'drop'])
    place.dispatchEvent(new DragEvent(kind, {bubbles: true, cancelable: true, dataTransfer: dropped}));
}"""
PASTE = """text => {
  const copied = new DataTransfer();
  copied.setData('text/plain', text);
  document.body.dispatchEvent(new ClipboardEvent('paste', {bubbles: true, clipboardData: copied}));
}"""
HEAD = "trial\tspeed [m/s]\tangle [deg]\tp [MPa]\tprofile\n"
TABLE = (
    (1, 1.95, 26, 0.31, "A"), (2, 2.86, 26, 0.31, "A"), (3, 3.79, 26, 0.31, "A"), (4, 1.97, 26, 0.31, "B 0.10"),
    (5, 1.92, 26, 0.31, "B 0.15"), (6, 1.99, 26, 0.31, "B 0.20"), (7, 2.03, 16, 0.31, "A"), (8, 2.06, 10, 0.31, "A"),
    (9, 1.92, 26, 0.25, "A"), (10, 2.90, 26, 0.25, "A"), (11, 3.87, 26, 0.25, "A"), (12, 2.03, 16, 0.25, "A"),
    (13, 1.97, 10, 0.25, "A"), (14, 2.01, 26, 0.25, "B 0.10"), (15, 2.01, 26, 0.25, "B 0.15"),
    (16, 2.01, 26, 0.25, "B 0.20"),
)  # fmt: skip
"""Table 2 of the quarter-car prototype paper, whose bench the virtual one is."""
SPRING = "displacement [mm],force [N]\n" + "".join(f"{x},{22 * x}\n" for x in range(20))
NEW: dict[str, Any] = {
    "rig": "kart-quarter-car",
    "obstacle": {"kind": "half-sine", "height": "10 mm", "length": "60 mm"},
}


@pytest.fixture(scope="module")
def laboratory(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[str, str]]:
    """The 31 files of a virtual bench, by name: five springs, six tyres, four decays, sixteen trials."""
    from jounce.cli import main

    folder = tmp_path_factory.mktemp("bench")
    assert main(["campaign", "synthesise", str(folder), "--force", "--json"]) == 0
    files = [(file.name, file.read_text()) for file in sorted(folder.glob("*/*.csv"))]
    assert len(files) == 31
    return files


def entered(
    folder: Path, path: str, *files: dict[str, Any], new: bool = True, **more: Any
) -> dict[str, Any]:
    from jounce.web.campaigns import FileEntry, NewCampaign, enter_files
    from jounce.web.project import Project

    entries = [FileEntry.model_validate(file) for file in files]
    start = NewCampaign.model_validate(NEW | more) if new else None
    return enter_files(Project(folder), path, entries, start)


def trial(file: str, number: int, **fields: Any) -> dict[str, Any]:
    known = {"recording": file, "number": number, "speed": "2 m/s", "road": "A", **fields}
    return {"use": "trial", "file": file, "fields": known}


def spring(file: str) -> dict[str, Any]:
    return {"use": "spring", "file": file, "fields": {"files": [file]}}


def test_files_that_do_not_fit_do_not_stop_the_others(tmp_path: Path) -> None:
    wrong = [trial("m/3.csv", 3, speed="fast"), trial("m/4.csv", 1), trial("../5.csv", 5)]
    files = [trial("m/1.csv", 1), trial("m/2.csv", 2, speed="4 m/s"), spring("m/s.csv"), *wrong]
    answer = entered(tmp_path, "new/campaign.toml", *files)
    assert sorted(answer["entered"]) == ["m/1.csv", "m/2.csv", "m/s.csv"]
    said = {item["file"]: item["message"] for item in answer["refused"]}
    assert set(said) == {"m/3.csv", "m/4.csv", "../5.csv"}
    assert "speed" in said["m/3.csv"]
    assert "trial number 1 is given twice" in said["m/4.csv"]
    campaign, _ = jn.campaign.load_campaign(tmp_path / "new" / "campaign.toml")
    assert [(row.recording, row.use) for row in campaign.trial] == [
        ("../m/1.csv", "fit"), ("../m/2.csv", "fit"),
    ]  # fmt: skip
    assert campaign.bench.spring is not None
    assert campaign.bench.spring.files == ("../m/s.csv",)


def test_a_new_campaign_replaces_nothing_and_needs_a_trial(tmp_path: Path) -> None:
    answer = entered(tmp_path, "campaign.toml", spring("s.csv"))
    assert answer["entered"] == []
    assert not (tmp_path / "campaign.toml").exists()
    entered(tmp_path, "campaign.toml", trial("1.csv", 1))
    before = (tmp_path / "campaign.toml").read_text()
    with pytest.raises(OutputError, match="the file already exists"):
        entered(tmp_path, "campaign.toml", trial("2.csv", 2))
    assert (tmp_path / "campaign.toml").read_text() == before
    answer = entered(tmp_path, "campaign.toml", trial("2.csv", 2), spring("s.csv"), new=False)
    assert answer["refused"] == []
    assert before.splitlines()[0] in answer["text"]


def test_a_new_campaign_takes_the_values_of_its_laboratory(tmp_path: Path) -> None:
    changes = {"sprung.mass": "17.5 kg", "strut.angle": "20 deg"}
    answer = entered(tmp_path, "a/campaign.toml", trial("1.csv", 1), changes=changes)
    assert answer["entered"] == ["1.csv"]
    rig: Any = jn.load(tmp_path / "a" / "rig.toml")
    assert (rig.sprung.mass, rig.unsprung.mass) == (17.5, jn.load(NEW["rig"]).unsprung.mass)
    assert jn.campaign.load_campaign(tmp_path / "a" / "campaign.toml")[0].rig == "rig.toml"
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "rig.toml").write_text("# another rig\n")
    with pytest.raises(OutputError, match="Choose another folder"):
        entered(tmp_path, "b/campaign.toml", trial("1.csv", 1), changes=changes)
    for wrong in ({"sprung.mass": "-3 kg"}, {"sprung.mass": "3 mm"}, {"no.mass": "3 kg"}):
        with pytest.raises(JounceError):
            entered(tmp_path, "c/campaign.toml", trial("1.csv", 1), changes=wrong)
    assert not (tmp_path / "c").exists()


def test_values_of_a_laboratory_are_shown_before_they_are_written(tmp_path: Path) -> None:
    from jounce.web.campaigns import OwnRig, own_values
    from jounce.web.project import Project

    asked = OwnRig(rig=NEW["rig"], changes={"sprung.mass": "17.5 kg"})
    assert own_values(Project(tmp_path), asked) == [
        {"path": "sprung.mass", "before": "16 kg", "after": "17.5 kg"}
    ]
    assert not list(tmp_path.iterdir())


def test_a_file_that_changed_since_it_was_shown_is_refused(tmp_path: Path) -> None:
    from jounce.campaign.arrivals import file_state

    file = tmp_path / "1.csv"
    file.write_text("time [s],sprung.az [m/s^2]\n0,0\n")
    shown = file_state(file)
    file.write_text("time [s],sprung.az [m/s^2]\n0,0\n1,1\n")
    answer = entered(tmp_path, "campaign.toml", trial("1.csv", 1) | {"state": shown})
    assert "has changed since it was shown" in answer["refused"][0]["message"]
    assert answer["refused"][0]["german"]
    assert not (tmp_path / "campaign.toml").exists()


def opened(browser: Any, workbench: tuple[Path, int], page: str, **context: Any) -> Any:
    made = browser.new_context(viewport={"width": 1280, "height": 900}, **context).new_page()
    made.set_default_timeout(120_000)
    made.goto(f"http://127.0.0.1:{workbench[1]}/?token={TOKEN}#/{page}")
    made.wait_for_selector(f"html[data-ready={page.partition('?')[0]}]")
    return made


def until(page: Any, expression: str) -> None:
    """Wait until something is so: a page whose policy forbids `eval` cannot tell by itself."""
    assert any(page.evaluate(expression) or page.wait_for_timeout(50) for _ in range(600)), (
        expression
    )


@pytest.mark.pages
def test_a_laboratory_is_entered_with_four_clicks(
    browser: Any, workbench: tuple[Path, int], laboratory: list[tuple[str, str]]
) -> None:
    folder, _ = workbench
    page = opened(browser, workbench, "rig")
    page.evaluate("addEventListener('click', () => { window.clicks = (window.clicks ?? 0) + 1; })")
    page.evaluate(DROP, [*laboratory, ("broken.csv", "a,b\n1,2\nx,y\n"), ("notes.docx", "x")])
    page.wait_for_selector(".arrivals tbody tr")
    rows = page.locator(".arrivals tbody tr")
    assert rows.count() == 32
    page.get_by_role("alert").get_by_text("notes.docx").wait_for()
    assert page.locator(".arrivals .spark").count() == 31
    assert page.get_by_text("missing: speed").count() == 16
    page.evaluate(f"(() => {{ {AXE.read_text()} }})()")
    found = page.evaluate("rules => axe.run(document, {runOnly: rules})", RULES)["violations"]
    assert not found, json.dumps(found)[:2000]
    page.get_by_text("Paste the table of trials").click()
    text = HEAD + "\n".join("\t".join(map(str, row)) for row in TABLE)
    page.locator("details textarea").fill(text)
    page.get_by_role("button", name="Fill in from the table").click()
    page.get_by_label("speed: 01.csv").and_(page.locator("[value='1.95 m/s']")).wait_for()
    assert page.get_by_text("missing: speed").count() == 0
    page.reload()  # what was typed and pasted stays in this tab
    page.get_by_label("speed: 16.csv").and_(page.locator("[value='2.01 m/s']")).wait_for()
    page.evaluate("addEventListener('click', () => { window.clicks = (window.clicks ?? 2) + 1; })")
    page.get_by_role("button", name="Make the campaign with 31 files").click()
    page.wait_for_selector("html[data-ready=campaign]")
    page.get_by_role("button", name="Check", exact=True).click()
    page.get_by_text("No problems found.").wait_for()
    assert page.evaluate("window.clicks") == 4
    campaign, _ = jn.campaign.load_campaign(folder / "campaign" / "campaign.toml")
    assert [entry.number for entry in campaign.trial] == list(range(1, 17))
    assert [entry.number for entry in campaign.trial if entry.use == "fit"] == [1, 2, 3]
    assert len(campaign.bench.tyre) == 2
    assert (folder / "measured" / "01.csv").read_text() == dict(laboratory)["01.csv"]


@pytest.mark.pages
def test_taken_names_missing_units_and_several_rows_at_once(
    browser: Any, workbench: tuple[Path, int]
) -> None:
    folder, _ = workbench
    (folder / "measured").mkdir(exist_ok=True)
    (folder / "measured" / "feder.csv").write_text("mine")
    record = "time [s],sprung.az [m/s^2],unsprung.az [m/s^2]\n"
    record += "".join(f"{k / 1000},{k % 7},{k % 5}\n" for k in range(300))
    page = opened(browser, workbench, "project", locale="de-DE")
    bare = SPRING.replace(" [mm]", "").replace(" [N]", "")
    chosen = [
        ("feder.csv", bare),
        ("feder2.csv", bare),
        ("r1.csv", record),
        ("r2.csv", record + "1,2,3\n"),
    ]
    page.locator("input[type=file]:not([webkitdirectory])").set_input_files(
        [{"name": name, "mimeType": "text/csv", "buffer": text.encode()} for name, text in chosen]
    )
    page.wait_for_selector(".arrivals tbody tr")
    assert (folder / "measured" / "feder.csv").read_text() == "mine"
    assert (folder / "measured" / "feder-2.csv").read_text() == bare
    page.get_by_label("Einheit von displacement, feder-2.csv").select_option("cm")
    page.get_by_text("2,2 N/mm").or_(page.get_by_text("2.2 N/mm")).nth(1).wait_for()
    page.get_by_label("Alle angehakten Dateien").select_option("speed")
    page.get_by_label("Wert", exact=True).fill("3 m/s")
    page.get_by_role("button", name="Für alle angehakten Dateien setzen").click()
    assert page.get_by_label("Geschwindigkeit: r1.csv").input_value() == "3 m/s"
    assert page.get_by_label("Geschwindigkeit: r2.csv").input_value() == "3 m/s"
    chosen_in = "label.field:has(> span:text-is('{}'))"
    page.locator(chosen_in.format("Kampagne")).locator("select").select_option("+")
    page.locator(chosen_in.format("Ordner")).locator("input").fill("zweite")
    mass = page.get_by_label("sprung.mass", exact=True)
    mass.fill("17,5")
    mass.press("Tab")
    assert mass.input_value() == "17,5 kg"
    page.get_by_role("cell", name="17,5 kg").wait_for()
    page.get_by_text("mit diesen Werten als zweite/rig.toml gespeichert").wait_for()
    page.get_by_role("button", name="Kampagne mit 4 Dateien anlegen").click()
    page.wait_for_selector("html[data-ready=campaign]")
    campaign, _ = jn.campaign.load_campaign(folder / "zweite" / "campaign.toml")
    rig: Any = jn.load(folder / "zweite" / campaign.rig)
    assert rig.sprung.mass == 17.5
    assert campaign.bench.spring is not None
    assert campaign.bench.spring.columns["displacement"] == "displacement [cm]"
    assert [entry.speed for entry in campaign.trial] == [3.0, 3.0]
    page.context.close()


SETTINGS = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {height = "10 mm", length = "60 mm"}
belt = {length = "1.97 m"}
[channels]
body = {measures = "sprung.az", sensitivity = "100 mV/g"}
"""


@pytest.fixture
def folder_of_files(tmp_path: Path) -> Path:
    """A laboratory's folder: settings, three trials and, below, 120 springs; a hidden folder is none of its files."""
    place = tmp_path / "lab"
    (place / "springs").mkdir(parents=True)
    (place / ".cache").mkdir()
    (place / "settings.toml").write_text(SETTINGS)
    (place / ".cache" / "old.csv").write_text(SPRING)
    rows = "".join(f"{k},{k + 0.95},26,0.31,A\n" for k in (1, 2, 3))
    (place / "table.csv").write_text(
        f"trial,speed [m/s],angle [deg],pressure [MPa],profile\n{rows}"
    )
    time = [k / 1000 for k in range(1000)]
    for number in (1, 2, 3):
        rows = "".join(f"{t},{math.sin(40 * t + number)}\n" for t in time)
        (place / f"run{number}.csv").write_text(f"time [s],body [V]\n{rows}")
    for number in range(120):  # more than a browser lists at a time
        (place / "springs" / f"spring_{number}.csv").write_text(SPRING)
    return place


@pytest.mark.pages
def test_a_folder_is_dropped_with_all_that_is_in_it(
    browser: Any, workbench: tuple[Path, int], folder_of_files: Path
) -> None:
    page = opened(browser, workbench, "jobs")
    session = page.context.new_cdp_session(page)
    data = {"items": [], "files": [str(folder_of_files)], "dragOperationsMask": 1}

    def drag(kind: str) -> None:
        session.send("Input.dispatchDragEvent", {"type": kind, "x": 400, "y": 300, "data": data})

    drag("dragEnter")
    for _ in range(
        100
    ):  # a hand that rests says so again and again: what it is told is hidden without
        drag("dragOver")
        if page.get_by_text("Drop the files: they are recognised").is_visible():
            break
    else:
        pytest.fail("nothing says what becomes of the files")
    drag("drop")
    page.wait_for_selector("html[data-ready=files]")
    until(page, "document.querySelectorAll('.arrivals tbody tr').length === 125")
    stored = workbench[0] / "measured" / "lab"
    assert len(list((stored / "springs").iterdir())) == 120
    assert not (stored / ".cache").exists()
    page.context.close()


@pytest.mark.pages
def test_a_chosen_folder_with_settings_makes_its_campaign(
    browser: Any, workbench: tuple[Path, int], folder_of_files: Path
) -> None:
    folder = workbench[0]
    page = opened(browser, workbench, "files")
    page.locator("input[webkitdirectory]").set_input_files(folder_of_files)
    page.get_by_text("settings.toml states masses, obstacle, belt and sensors.").wait_for()
    page.get_by_label("Folder", exact=True).fill("bench")
    page.get_by_label("Folder", exact=True).press("Tab")
    page.get_by_role("button", name="Make the campaign from the settings file").click()
    page.wait_for_selector("html[data-ready=campaign]")
    assert "bench/campaign.toml" in page.url.replace("%2F", "/")
    campaign, _ = jn.campaign.load_campaign(folder / "bench" / "campaign.toml")
    assert [(entry.number, entry.speed) for entry in campaign.trial] == [
        (1, 1.95), (2, 2.95), (3, 3.95),
    ]  # fmt: skip
    page.context.close()


RIG = "kart-double-wishbone.toml"
TURNED = "Punkt\tx [mm]\ty [mm]\tz [mm]\nLBJ\t-6\t-335\t47,5\nTie rod inner\t106,1\t-101,6\t112\nkingpin\t1\t2\t3\n"
"""Two hardpoints of that rig, x back and y right, with a row too many."""


def _copied(folder: Path) -> None:
    (folder / RIG).write_text((Path(jn.__file__).parent / "parts" / "library" / RIG).read_text())


@pytest.mark.pages
def test_pasted_points_are_shown_and_taken_and_bare_numbers_get_their_unit(
    browser: Any, workbench: tuple[Path, int]
) -> None:
    _copied(workbench[0])
    page = opened(browser, workbench, f"rig?name={RIG}")
    page.evaluate(PASTE, TURNED)
    page.get_by_text("Axes: x back, y right, z up.").wait_for()
    page.get_by_text("line 4: kingpin is no hardpoint of this rig").wait_for()
    cells = page.locator(".pasting tbody tr", has_text="LBJ").locator("td")
    said = [" ".join(text.split()) for text in cells.all_inner_texts()]
    assert said == ["LBJ", "6 335 45", "6 335 47.5", "2.500"]
    page.get_by_role("button", name="Take 2 changed points").click()
    page.get_by_text("2 points taken. Undo reverses this.").wait_for()
    text = page.get_by_label(f"text of {RIG}")
    until(page, "document.querySelector('textarea[aria-label^=text]').value.includes('47.5 mm')")
    field = page.get_by_label("hardpoints.lower_ball_joint[1]", exact=True)
    field.fill("150")
    field.press("Tab")
    page.get_by_text("150 is read as 150 mm; write a unit to mean another.").wait_for()
    assert '"150 mm"' in text.input_value()
    page.evaluate(f"(() => {{ {AXE.read_text()} }})()")
    found = page.evaluate("rules => axe.run(document, {runOnly: rules})", RULES)["violations"]
    assert not found, json.dumps(found)[:2000]
    page.goto(f"http://127.0.0.1:{workbench[1]}/#/kinematics?rig={RIG}")
    page.wait_for_selector("html[data-ready=kinematics]")
    page.evaluate(PASTE, TURNED)
    page.get_by_role("button", name="Take 2 changed points").click()
    page.get_by_text("2 points taken. Undo reverses this.").wait_for()
    page.get_by_role("button", name="Undo").click()
    page.context.close()


@pytest.mark.pages
def test_a_wrong_table_of_points_names_its_row_in_german(
    browser: Any, workbench: tuple[Path, int]
) -> None:
    _copied(workbench[0])
    page = opened(browser, workbench, f"rig?name={RIG}", locale="de-DE")
    page.evaluate(PASTE, "Punkt\tx\ty\tz\nLBJ\t6\tetwa\t45\nUBJ\t1\t2\t3\n")
    said = page.locator(".pasting").get_by_role("alert")
    said.wait_for()
    assert "2" in said.inner_text()
    assert "LBJ" in said.inner_text()
    page.context.close()


@pytest.mark.pages
def test_a_curve_is_pasted_beside_the_present_one(
    browser: Any, workbench: tuple[Path, int]
) -> None:
    _copied(workbench[0])
    rig = workbench[0] / RIG
    damper = "damper = {velocity = [-1.0, 0.0, 1.0], force = [-200, 0, 100]}"
    text = re.sub(r"(?m)^\[strut.damper\]\n(?:(?!\[).*\n)*", "", rig.read_text())
    text = re.sub(r"(?m)^damper = .*$", "", text).replace("[strut]\n", f"[strut]\n{damper}\n", 1)
    (workbench[0] / "table.toml").write_text(text)
    page = opened(browser, workbench, "rig?name=table.toml")
    page.locator("[data-path='strut.damper']").wait_for(state="attached")
    opens = (
        "() => document.querySelectorAll('.described details').forEach(one => { one.open = true; })"
    )
    page.evaluate(opens)
    fold = page.locator(".described details.pasting").first
    fold.locator("textarea").fill("v [mm/s];F [N]\n-500;-100\n0;0\n500;60\n250;40\n")
    fold.get_by_role("button", name="Compare").click()
    fold.get_by_text("Units: mm/s, N.").wait_for()
    fold.get_by_role("button", name="Take 4 rows").click()
    until(page, "document.querySelector('textarea[aria-label^=text]').value.includes('0.25, 0.5]')")
    now = page.get_by_label("text of table.toml").input_value()
    assert re.search(r"velocity = \[-0.5, 0(\.0)?, 0.25, 0.5\]", now)
    page.context.close()


def test_a_table_of_trials_is_compared_and_written(tmp_path: Path) -> None:
    from jounce.web.campaigns import pasted_trials
    from jounce.web.project import Project

    entered(tmp_path, "campaign.toml", trial("1.csv", 1), trial("2.csv", 2))
    project = Project(tmp_path)
    table = "trial\tspeed [km/h]\tangle [deg]\tprofile\n1\t7,2\t\tA\n2\t14,4\t\tB 0.10\n9\t1\t\t\n"
    shown = pasted_trials(project, "campaign.toml", table)
    assert [(row["number"], row["key"], row["after"]) for row in shown["changes"]] == [
        (2, "speed", "4 m/s"), (2, "road", "B 0.1"),
    ]  # fmt: skip
    assert (shown["absent"], shown["unlisted"]) == ([9], [])
    before = (tmp_path / "campaign.toml").read_text()
    with pytest.raises(OutputError, match="changed since it was loaded"):
        pasted_trials(project, "campaign.toml", table, "another digest")
    assert (tmp_path / "campaign.toml").read_text() == before
    written = pasted_trials(project, "campaign.toml", table, shown["digest"])
    assert written["before"] == before
    campaign, _ = jn.campaign.load_campaign(tmp_path / "campaign.toml")
    assert [row.speed for row in campaign.trial] == [2.0, 4.0]
    assert campaign.trial[1].road == "B 0.1"
    assert pasted_trials(project, "campaign.toml", table)["changes"] == []
