"""What a notebook shows of results and descriptions: short, with units, and never as markup."""

from __future__ import annotations

import dataclasses
import html
import inspect
import re
import typing
from functools import cache

import numpy as np
import pytest

import jounce as jn
from jounce.core.display import local_units
from jounce.core.findings import Finding
from jounce.core.shown import Shown, dataset_html, html_table
from jounce.parts import library

NOT_RESULTS = (dict, tuple, list, str, int, float, complex)


def text_of(page: str) -> str:
    return html.unescape(re.sub(r"\s+", " ", re.sub(r"<style>.*?</style>|<[^>]+>", " ", page)))


@cache
def results() -> dict[str, type]:
    """Every class of the public names, and what their functions give."""
    found: dict[str, type] = {}
    for name in jn.__all__:
        public = getattr(jn, name)
        if inspect.isclass(public):
            found[name] = public
        elif inspect.isfunction(public):
            try:
                given = typing.get_type_hints(public).get("return")
            except NameError:  # named for type checkers only
                text = str(inspect.signature(public).return_annotation)
                given = getattr(inspect.getmodule(public), text, None)
            if inspect.isclass(given):
                found[name] = given
    ours = {name: kind for name, kind in found.items() if kind.__module__.startswith("jounce.")}
    return {
        name: kind for name, kind in ours.items() if not issubclass(kind, (Exception, *NOT_RESULTS))
    }


@pytest.mark.parametrize("name", sorted(results()))
def test_every_result_and_description_is_shown(name: str) -> None:
    assert issubclass(results()[name], Shown)


@pytest.mark.parametrize("name", sorted(library()))
def test_descriptions_are_short_and_say_where_the_rest_is(name: str) -> None:
    rig = jn.load(name)
    page = rig._repr_html_()
    assert len(page) <= 8000
    text = text_of(page)
    assert type(rig).__name__ in text
    assert "parameters()" in text


def test_numbers_have_the_units_that_are_chosen() -> None:
    rig = jn.load("kart-quarter-car")
    assert re.search(r"strut\.spring\.rate 22\.73 N/mm", text_of(rig._repr_html_()))
    with local_units("imperial"):
        assert re.search(r"strut\.spring\.rate 129\.79 lbf/in", text_of(rig._repr_html_()))
    bump = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    assert re.search(r"height 10 mm length 60 mm", text_of(bump._repr_html_()))


def test_results_say_what_their_numbers_are() -> None:
    mode = jn.modes(jn.load("kart-quarter-car"))[0]
    text = text_of(mode._repr_html_())
    assert re.search(r"frequency_hz 5\.0676 \S", text)
    assert len(mode._repr_html_()) < 3000
    assert "more:" in text


def test_texts_of_files_are_text() -> None:
    page = Finding(
        "<script>alert(1)</script>", "note", "a & b \x1b[2J" + "long " * 500
    )._repr_html_()
    assert "<script" not in page
    assert "&lt;script&gt;" in page
    assert "a &amp; b \\x1b[2J" in page
    assert len(page) < 2500


def test_a_table_is_never_long() -> None:
    rows = [("<" * 500, ">" * 500, "&" * 500)] * 400
    page = html_table("t", "s", rows, "see more()")
    assert len(page) <= 8000
    assert re.search(r"… and (\d+) more: see more\(\)", text_of(page))
    many = html_table("t", "", [("a", "1", "m")] * 30, "x")
    assert many.count("<tr>") == 20
    assert "… and 10 more: x" in many
    assert "more: x" in html_table("t", "", [], "x")


def test_values_of_every_kind() -> None:
    @dataclasses.dataclass
    class Odd(Shown):
        """A result.

        Attributes
        ----------
        rate, other : float
            In N/m.
        """

        rate: float = -1.5
        other: float = float("nan")
        flag: bool = True
        none: None = None
        many: tuple[float, ...] = (1.0, 2.0, 3.0, 4.0, 5.0)
        array: object = dataclasses.field(default_factory=lambda: np.zeros((3, 2)))
        scalar: object = np.float64(2.0)
        names: tuple[str, ...] = ("a", "b")
        table: dict[str, float] = dataclasses.field(
            default_factory=lambda: dict.fromkeys("abcdef", 0.0)
        )
        pole: complex = 1.0 - 2.0j
        inner: object = dataclasses.field(default_factory=lambda: (Finding("a", "note", "b"),))

    text = text_of(Odd()._repr_html_())
    assert (
        "Odd A result. rate −1.5 In N/m. other – In N/m. flag yes none – many 1 … 5 array 3 x 2 numbers"
        in text
    )
    assert "scalar 2 names a, b table a, b, c and 3 more pole 1 − 2i inner 1 x Finding" in text


def test_recordings_by_channel() -> None:
    from xarray import Dataset

    time = np.linspace(0.0, 1.0, 11)
    data = Dataset(
        {f"c{i}.az": ("time", (i + 1) * np.sin(time), {"units": "m/s^2"}) for i in range(40)},
        coords={"time": ("time", time, {"units": "s"})},
    )
    page = dataset_html(data)
    text = text_of(page)
    assert len(page) <= 8000
    assert (
        "Recording 11 values of time from 0 to 1 s channel least greatest unit c0.az 0 0.84147 m/s²"
        in text
    )
    assert "… and 20 more: jn.plots.show(data)" in text
    assert dataset_html(Dataset({"a": ("x", [1.0])})).startswith("<div><svg")  # not ours
    data["c0.az"][:] = np.nan
    assert "c0.az – – m/s²" in text_of(dataset_html(data))


def test_plots_list_functions_only() -> None:
    listed = dir(jn.plots)
    assert "show" in listed
    assert all(inspect.isfunction(getattr(jn.plots, name)) for name in listed)
    assert set(listed) <= set(jn.plots.__all__)
