from __future__ import annotations

import json
import re
from collections import Counter
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import pytest

import jounce as jn
from jounce.campaign.characterise import Characterisation
from jounce.campaign.result import CampaignResult
from jounce.core.findings import finding
from jounce.report import campaign_page, write_campaign
from jounce.report.campaign import most_important
from jounce.report.page import Details, Facts, PageTable

_VOID = {"wbr", "meta", "path", "use", "rect", "link", "br", "image", "line", "circle"}


class Reader(HTMLParser):
    """What a browser or a screen reader would find."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.tags: Counter[str] = Counter()
        self.missing: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        self.tags[tag] += 1
        self.ids += [str(found["id"])] if "id" in found else []
        self.links += [str(value) for key, value in attrs if key in ("href", "src", "xlink:href")]
        self.links += [
            f"#{name}" for name in re.findall(r"url\(#([^)]+)\)", self.get_starttag_text() or "")
        ]
        if "aria-labelledby" in found:
            self.links.append(f"#{found['aria-labelledby']}")
        if tag == "svg" and found.get("role") != "img":
            self.missing.append("svg without role")
        if tag == "th" and "scope" not in found:
            self.missing.append("th without scope")
        if tag not in _VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in _VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        if tag not in _VOID:
            assert self.open.pop() == tag


@pytest.fixture(scope="session")
def html(written: Path) -> str:
    return (written / "report.html").read_text(encoding="utf-8")


def table_named(page, start: str) -> PageTable:
    def inside(blocks):
        for block in blocks:
            yield block
            yield from inside(getattr(block, "blocks", ()))

    return next(
        block
        for section in page.sections
        for block in inside(section.blocks)
        if isinstance(block, PageTable) and block.caption.startswith(start)
    )


def text_of(cell: object) -> str:
    return cell if isinstance(cell, str) else cell.text  # type: ignore[attr-defined]


def test_files(written: Path, result: CampaignResult) -> None:
    names = {str(file.relative_to(written)) for file in written.rglob("*") if file.is_file()}
    assert {
        "report.html",
        "results.json",
        "rig-strategy-a-1.toml",
        "rig-strategy-a-1-2.toml",
    } <= names
    vectors = {name.removesuffix(".svg") for name in names if name.endswith(".svg")}
    assert vectors == {name.removesuffix(".png") for name in names if name.endswith(".png")}
    assert {f"figures/trial-0{number}" for number in (1, 2, 3)} <= vectors
    assert len(list(written.parent.iterdir())) == 1


def test_results_are_strict_and_complete(written: Path, result: CampaignResult) -> None:
    def refuse(constant: str) -> None:
        raise AssertionError(constant)

    found = json.loads(
        (written / "results.json").read_text(encoding="utf-8"), parse_constant=refuse
    )
    assert found == result.to_dict()
    assert {"characterisation", "updates", "trials", "findings"} <= set(found)


def test_rigs_hold_the_fitted_values(written: Path, result: CampaignResult) -> None:
    for name, strategy in zip(("strategy-a-1", "strategy-a-1-2"), result.strategies, strict=True):
        rig = jn.load(written / f"rig-{name}.toml")
        for path, parameter in strategy.update.parameters.items():
            assert rig.parameters()[path] == pytest.approx(parameter.value, rel=1e-9)


def test_page_is_sound(html: str) -> None:
    reader = Reader(html)
    assert reader.open == []
    assert reader.missing == []
    assert [name for name, count in Counter(reader.ids).items() if count > 1] == []
    assert {link.removeprefix("#") for link in reader.links if link.startswith("#")} <= set(
        reader.ids
    )
    assert reader.tags["caption"] == reader.tags["table"] > 10
    assert reader.tags["figure"] == reader.tags["figcaption"] > 8
    assert reader.tags["svg"] > reader.tags["figure"]  # every panel of a figure is one
    assert reader.tags["h1"] == 1


def test_page_needs_nothing_else(html: str) -> None:
    assert [
        link for link in Reader(html).links if not link.startswith(("#", "data:image/png;"))
    ] == []
    assert "@import" not in html
    assert re.findall(r"url\((?!#)", html) == []


def test_synthetic_everywhere(html: str, written: Path) -> None:
    reader = Reader(html)
    assert (
        html.count('<span class="tag">Synthetic data, not measurements</span>')
        == reader.tags["section"]
        == 9
    )
    assert "Made by a test." in html
    for file in (written / "figures").glob("*.svg"):
        assert "Synthetic data, not measurements" in file.read_text(encoding="utf-8")


def test_text_of_the_user_is_escaped(html: str) -> None:
    assert "Tests &lt;b&gt;&amp; more&lt;/b&gt;" in html
    assert "<b>" not in html


def test_all_curves_are_there(html: str) -> None:
    assert len(re.findall(r"<details data-scene=\"trial-\d+\"><summary>Trial", html)) == 3
    assert html.count("data-viewer=") == 1
    assert [number for number in (1, 2, 3) if f'id="picture-trial-0{number}"' in html] == [1, 2, 3]


def test_validation_table_holds_the_results(result: CampaignResult) -> None:
    rows = table_named(campaign_page(result), "Model compared with measurement").rows
    assert [text_of(row[0]) for row in rows] == ["1", "", "2", "", "3", ""]
    for trial, row in zip(result.trials, rows[::2], strict=True):
        channel = trial.after.channels["sprung.az"]
        assert text_of(row[2]) == "sprung.az"
        assert float(text_of(row[3])) == pytest.approx(channel.nrmse, rel=0.05)
        assert float(text_of(row[4])) == pytest.approx(channel.r2, abs=6e-4)
        assert float(text_of(row[7])) == pytest.approx(channel.iso18571, abs=6e-3)
        assert text_of(row[10]) == trial.after.verdict


def test_parameters_with_bounds_and_units(result: CampaignResult) -> None:
    page = campaign_page(result)
    row = table_named(page, "Parameters of Strategy A/1").rows[0]
    parameter = result.strategies[0].update.parameters["strut.spring.rate"]
    assert text_of(row[0]) == "strut.spring.rate"
    assert float(text_of(row[2])) == pytest.approx(1e-3 * parameter.value, rel=1e-3)
    assert text_of(row[6]) == "N/mm"
    bound = table_named(page, "Parameters of strategy a 1").rows[0][2]
    tyre = result.strategies[1].update.parameters["tyre.stiffness"]
    assert tyre.at_bound  # the truth lies beyond 2 %
    assert bound.note == "at its bound"  # type: ignore[union-attr]


def test_replaced_values(result: CampaignResult) -> None:
    rows = table_named(campaign_page(result), "Rig parameters replaced by measured values").rows
    assert [row[0] for row in rows] == [
        "strut.spring.rate",
        "tyre.stiffness",
        "strut.damper.coefficient",
    ]
    assert rows[0][1] == "22.73"
    assert float(str(rows[0][2])) == pytest.approx(
        22.59, abs=0.03
    )  # 22.5, 22.59 and 22.68 N/mm were measured


def test_summary_counts_verdicts(result: CampaignResult) -> None:
    facts = next(
        block for block in campaign_page(result).sections[0].blocks if isinstance(block, Facts)
    ).items
    assert [fact.label for fact in facts] == [
        "Fitted trials",
        "Held-out trials",
        "Objective, strategy a 1",
    ]
    held = sum(
        trial.after.verdict == "holds" for trial in result.trials if trial.entry.use == "hold-out"
    )
    assert facts[1].value == f"{held} of 2 hold"


def test_the_answer_comes_first_with_intervals(result: CampaignResult) -> None:
    page = campaign_page(result)
    assert [section.title for section in page.sections][:3] == ["Answer", "Curves", "Validation"]
    table = table_named(page, "From the rig file to the updated model")
    rows = {text_of(row[0]): row for row in table.rows}
    spring = result.strategies[0].update.parameters["strut.spring.rate"]
    assert list(rows) == ["strut.spring.rate", "tyre.stiffness", "strut.damper.coefficient"]
    assert [text_of(cell) for cell in rows["strut.spring.rate"][1:2]] == ["22.73"]
    low, _, high = rows["strut.spring.rate"][3].note.partition(" to ")
    assert (float(low), float(high)) == pytest.approx(
        [1e-3 * end for end in spring.interval], rel=1e-3
    )
    bench = result.characterisation.spring.stiffness
    assert float(text_of(rows["strut.spring.rate"][2])) == pytest.approx(
        1e-3 * bench.value, rel=1e-4
    )
    low, _, high = rows["strut.spring.rate"][2].note.partition(" to ")
    assert (float(low), float(high)) == pytest.approx(
        [1e-3 * end for end in bench.interval], rel=1e-3
    )


def test_superseded_updates_stand_folded_with_their_findings(result: CampaignResult) -> None:
    first = result.strategies[0].update.name
    alone = tuple(
        entry.model_copy(update={"start_from": None}) if entry.start_from else entry
        for entry in result.campaign.update
    )
    notes = (
        jn.Finding(f"{first}: x", "warning", "old"),
        jn.Finding("strategy a 1: x", "warning", "new"),
    )
    campaign = result.campaign.model_copy(update={"update": alone})
    page = campaign_page(replace(result, campaign=campaign, findings=notes))
    careful = next(
        block
        for block in page.sections[0].blocks
        if getattr(block, "title", "").startswith("Warnings")
    )
    assert [finding.message for finding in careful.blocks[0].items] == ["new"]
    folded = [block.summary for block in page.blocks() if isinstance(block, Details)]
    assert f"{first}: superseded, not part of the final model" in folded
    assert [
        finding.message
        for finding in next(s for s in page.sections if s.title == "Findings").blocks[0].items
    ] == [
        "old",
        "new",
    ]


def test_findings_that_differ_in_numbers_are_one() -> None:
    findings = [
        jn.Finding("a", "note", "n"),
        finding("identify.mass_moved", "d1", 0.1, moved=0.1),
        finding("identify.mass_moved", "d2", 0.2, moved=0.2),
        jn.Finding("t", "problem", "lost"),
    ]
    assert [item.place for item in most_important(findings)] == ["t", "d1", "a"]


def test_failures_are_shown_as_such(damaged: CampaignResult, tmp_path: Path) -> None:
    assert not damaged.is_complete
    write_campaign(damaged, tmp_path / "out", figures=["svg"])
    html = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Parts of this campaign failed" in html
    assert "The tyre could not be evaluated" in html
    assert "Update &#39;strategy a 1&#39; failed" in html
    assert "Trial 3 (held out), 3 m/s, road A: not usable" in html
    assert "there is nothing to plot" in html
    assert "Problems</h4>" in html
    assert not (tmp_path / "out" / "figures" / "trial-03.svg").exists()
    assert (tmp_path / "out" / "figures" / "trial-02.svg").exists()
    assert "ynthetic data" not in html


def test_without_bench_updates_and_usable_trials(result: CampaignResult, tmp_path: Path) -> None:
    lost = tuple(
        replace(trial, before=None, after=None, signals={}, signals_before={})
        for trial in result.trials
    )
    campaign = result.campaign.model_copy(
        update={"update": (), "bench": type(result.campaign.bench)()}
    )
    bare = replace(
        result,
        campaign=campaign,
        characterisation=Characterisation(),
        strategies=(),
        trials=lost,
        findings=(),
    )
    write_campaign(bare, tmp_path / "out")
    html = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "contains no bench measurements" in html
    assert "data-viewer=" not in html
    assert "No update was requested" in html
    assert "Nothing to report." in html
    assert html.count("not usable") >= 3


def test_no_trial_at_all_is_said(result: CampaignResult, tmp_path: Path) -> None:
    bare = replace(
        result,
        trials=(),
        strategies=(),
        campaign=result.campaign.model_copy(update={"trial": (), "update": ()}),
    )
    write_campaign(bare, tmp_path / "out", pdf=True)
    html = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "This campaign contains no trial" in html
    assert "data-viewer=" not in html


def test_five_hundred_trials_are_a_page_that_opens(result: CampaignResult, tmp_path: Path) -> None:
    many = []
    for k in range(500):
        trial = result.trials[k % 3]
        use = "fit" if k == 499 else "hold-out"
        many.append(
            replace(
                trial,
                entry=trial.entry.model_copy(update={"number": k + 1, "use": use}),
                motion=None,
            )
        )
    strategies = tuple(replace(strategy, trials=()) for strategy in result.strategies)
    write_campaign(replace(result, trials=tuple(many), strategies=strategies), tmp_path / "out")
    html = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Shown are 64 of 500 trials" in html
    assert 'id="picture-trial-500"' in html  # the fitted one
    assert len(re.findall(r"<details data-scene=\"trial-\d+\"><summary>Trial", html)) == 64
    assert len(html) < 4_000_000
    reader = Reader(html)
    assert {link.removeprefix("#") for link in reader.links if link.startswith("#")} <= set(
        reader.ids
    )


def test_bench_files_that_vanished_do_not_stop_the_report(
    result: CampaignResult, tmp_path: Path
) -> None:
    names = {
        picture.name
        for picture in campaign_page(replace(result, folder=tmp_path / "gone")).pictures()
    }
    assert {"bench-spring", "bench-decay-1", "bench-decay-2", "trial-01"} <= names


def test_same_campaign_same_bytes(result: CampaignResult, written: Path, tmp_path: Path) -> None:
    write_campaign(result, tmp_path / "out", figures=("svg", "png"))
    for file in sorted(written.rglob("*")):
        if file.is_file():
            assert (
                tmp_path / "out" / file.relative_to(written)
            ).read_bytes() == file.read_bytes(), file.name


def test_the_answer_says_of_which_trials_a_verdict_is(html: str) -> None:
    assert re.search(r"Of those fitted, trials? \d", html)
    assert re.search(r"Of those held out, trials? \d", html)
