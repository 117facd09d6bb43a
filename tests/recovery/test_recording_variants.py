"""Known truths in every variant of a file: right, refused or flagged, and none silently wrong."""

from __future__ import annotations

from types import ModuleType

import pytest


@pytest.fixture(scope="module")
def variants() -> ModuleType:
    import make_variants

    return make_variants


def test_no_text_file_is_silently_wrong(variants: ModuleType) -> None:
    texts = list(variants.texts())
    units = [one for one in texts if one[0] == "text: units"]
    groups = variants.outcomes([one for one in texts if one[0] != "text: units"] + units[::40])
    assert {group.what: group.wrong for group in groups if group.wrong} == {}
    right = {group.what: group.outcomes["right"] for group in groups}
    assert right["text: units"] == 20
    assert right["text: separator, decimal, header"] >= 38
    assert right["text: layout and damage"] >= 14
    assert right["text: sampling"] >= 19


def test_a_wrong_reading_would_be_seen(
    variants: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    true = variants.truth
    monkeypatch.setattr(
        variants, "truth", lambda time: {name: 1.01 * values for name, values in true(time).items()}
    )
    columns = {"time": variants.TIME, **true(variants.TIME)}
    content = variants.text(
        columns, {"time": "s", "sprung.az": "m/s^2", "strut.deflection": "m", "strut.force": "N"}
    )
    (group,) = variants.outcomes([("one", ("a", ".csv", content.encode(), {}))])
    assert group.wrong == ["a"]


@pytest.mark.slow
def test_the_page_of_the_documentation_is_true(variants: ModuleType) -> None:
    for package in ("nptdms", "asammdf", "pyuff", "pyarrow"):
        pytest.importorskip(package)
    page = variants.tables()
    assert page == variants.PAGE.read_text(encoding="utf-8").partition(variants.MARK)[2]
    assert next(row for row in page.splitlines() if row.startswith("| **all**")).endswith("| 0 |")
