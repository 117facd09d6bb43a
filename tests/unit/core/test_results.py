"""Results that know their units: as text at 80 columns, in a notebook, and with an uncertainty."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated

import pytest

from jounce.core.display import local_units
from jounce.core.results import Shows, fields_of, marks_of
from jounce.core.shown import Shown
from jounce.identify.estimate import Estimate

if TYPE_CHECKING:
    from collections.abc import Sequence


@dataclass(frozen=True)
class Corner(Shown):
    name: Annotated[str, Shows("corner")]
    load: Annotated[float, Shows("static load", "N")]
    rate: Annotated[float | None, Shows("rate", lambda corner: corner.unit)]
    unit: str = "N/m"


@dataclass(frozen=True)
class Fit(Shown):
    rate: Annotated[Estimate, Shows("spring rate", "N/m")]
    nrmse: Annotated[float, Shows("residual, of the force range", "%", 3)]
    times: Annotated[Sequence[float] | None, Shows("times", "s")] = None
    corners: Annotated[tuple[Corner, ...], Shows("Corners")] = ()
    left_out: dict[str, float] = field(default_factory=dict)

    @property
    def per_wheel(self) -> Annotated[float, Shows("rate per wheel", "N/m")]:
        return 0.5 * self.rate.value


FIT = Fit(
    Estimate(22731.4, 12.3, (22705.0, 22757.0)),
    0.00132,
    corners=(Corner("front left", 1.1e3, 22e3), Corner("rear left", 35e3, None)),
)


def test_marks_are_read_where_types_are_for_checkers_only() -> None:
    assert list(marks_of(Fit)) == ["rate", "nrmse", "times", "corners", "per_wheel"]
    assert [(field.label, field.in_words()) for field in fields_of(FIT, "nrmse", "per_wheel")] == [
        ("residual, of the force range", "0.132 %"),
        ("rate per wheel", "11.37 N/mm"),
    ]


def test_print_gives_a_table_with_units_and_intervals() -> None:
    text = str(FIT)
    assert re.search(r"spring rate +22\.731 +0\.012 +22\.705 to 22\.757 +N/mm", text)
    assert re.search(r"corner +static load \[kN\] +rate \[N/mm\]", text)
    assert re.search(r"rear left +35\.00 +–", text)
    assert max(map(len, text.splitlines())) <= 80
    assert "times" not in text


def test_rows_have_a_unit_each_where_units_differ() -> None:
    text = str(Fit(FIT.rate, 0.0, corners=(Corner("a", 1.0, 2e4), Corner("b", 1.0, 0.1, "m"))))
    assert re.search(r"a +1\.000 +20\.00 +N/mm", text)
    assert re.search(r"b +1\.000 +100\.0 +mm", text)


def test_chosen_units_and_notebooks() -> None:
    with local_units("imperial"):
        assert "129.80" in str(FIT)
    page = FIT._repr_html_()
    assert "22.705 to 22.757" in page
    assert "rear left" in page


def test_numbers_are_never_broken() -> None:
    for width in (40, 60, 80):
        table = next(iter(_tables()))
        lines = "\n".join(table.lines(width))
        assert all(cell in lines for row in table.rows for cell in row[1:3])


def _tables():
    from jounce.core.results import tables_of

    return tables_of(FIT)


@pytest.mark.parametrize("value", [Estimate(1.0), Estimate(2.0, 0.1, (1.8, 2.2))])
def test_an_estimate_is_one_line(value: Estimate) -> None:
    assert "\n" not in str(value)
    assert str(value).startswith(("1.0", "2.0"))
