"""Bands without gaps and overlaps divide their range: each value has one, and the edges belong where they say."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from jounce.core.errors import DescriptionError
from jounce.inspection.limits import Criterion, VerdictBand

EDGES = (
    st.lists(st.floats(-1e3, 1e3), min_size=2, max_size=6, unique=True)
    .map(sorted)
    .filter(lambda edges: all(b - a > 1e-3 for a, b in pairwise(edges)))
)


def bands(edges: list[float], included: list[bool]) -> list[VerdictBand]:
    ends = zip(edges[:-1], edges[1:], included, strict=False)
    return [
        VerdictBand(
            start=a, end=b, end_included=closed, label=f"{i}", colour="green", verdict="pass"
        )
        for i, (a, b, closed) in enumerate(ends)
    ]


@given(EDGES, st.lists(st.booleans(), min_size=5, max_size=5), st.floats(-1.5e3, 1.5e3))
def test_every_value_inside_has_one_band(
    edges: list[float], included: list[bool], value: float
) -> None:
    made = bands(edges, included)
    criterion = Criterion(quantity="theta_road", source="test", bands=tuple(made))
    for asked in (value, *edges):
        found = criterion.band_of(asked)
        last = made[-1]
        inside = edges[0] <= asked < edges[-1] or (asked == edges[-1] and last.end_included)
        assert (found is not None) == inside
        if found is None:
            continue
        assert found.start <= asked <= found.end
        if asked == found.start and found is not made[0]:
            assert not made[made.index(found) - 1].end_included
        if asked == found.end:
            assert found.end_included


@given(EDGES, st.floats(1e-3, 1e2), st.booleans(), st.data())
def test_any_gap_or_overlap_is_refused(
    edges: list[float], by: float, gap: bool, data: st.DataObject
) -> None:
    if len(edges) < 3:
        edges = [*edges, edges[-1] + 1.0]
    made = bands(edges, [False] * 5)
    which = data.draw(st.integers(1, len(made) - 1))
    moved = made[which].start + (by if gap else -by)
    end = math.inf if which == len(made) - 1 else edges[-1] + 200.0
    made[which] = VerdictBand.model_construct(**{**dict(made[which]), "start": moved, "end": end})
    with pytest.raises(DescriptionError, match="a gap" if gap else "an overlap"):
        Criterion(quantity="theta_road", source="test", bands=tuple(made[: which + 1]))
