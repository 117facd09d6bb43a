"""Drawings of axles on the K&C rig."""

from __future__ import annotations

import re

import pytest

import jounce as jn
from jounce.kc.tests import TESTS
from jounce.report.kc_drawing import axle_drawing


@pytest.mark.parametrize("name", ["mcpherson-elastic", "solid-axle", "twist-beam"])
@pytest.mark.parametrize("test", ["roll", "braking", "aligning-opposed"])
def test_wheels_links_and_input_of_each_side(name: str, test: str) -> None:
    drawn = axle_drawing(jn.load(name), TESTS[test])
    assert drawn is not None
    places = [float(x) for x in re.findall(r'<text x="(\d+)" y="14"', drawn.drawn)]
    assert places[0] < places[1]  # the left wheel is on the left
    assert drawn.drawn.count("var(--rubber)") == 2
    assert drawn.drawn.count('class="m after"') == 2  # heads of arrows
    inside = [float(x) for x in re.findall(r"[ML](-?[\d.]+) ", drawn.drawn)]
    assert min(inside) >= 0.0
    assert max(inside) <= drawn.width


def test_a_panhard_rod_is_drawn_once() -> None:
    """Mirrored links are drawn twice."""
    rig = jn.load("solid-axle")
    lines = axle_drawing(rig, TESTS["roll"]).drawn.count('class="l"')
    assert (
        lines == 2 * (1 + 2 * 2 + 1) + 2
    )  # beam, two links with brackets, strut; the rod with its bracket


def test_a_lumped_rig_has_no_drawing() -> None:
    assert axle_drawing(jn.load("kart-quarter-car"), TESTS["bounce"]) is None
