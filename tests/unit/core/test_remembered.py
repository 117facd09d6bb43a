"""What follows from frozen objects is computed once for each, and forgotten with it."""

from __future__ import annotations

import gc
import sys

import pytest

import jounce as jn
from jounce.core.remembered import Recent, once_per_object


class Thing:
    def __eq__(self, other: object) -> bool:
        return isinstance(other, Thing)

    __hash__ = None


def test_once_for_each_object_by_identity():
    asked = []
    ask = once_per_object(lambda thing: asked.append(id(thing)) or len(asked))
    one, other = Thing(), Thing()
    assert one == other
    assert [ask(one), ask(other), ask(one), ask(other)] == [1, 2, 1, 2]


def test_it_is_forgotten_with_the_object():
    asked = []
    ask = once_per_object(lambda _: asked.append(1) or len(asked))
    known = next(
        cell.cell_contents for cell in ask.__closure__ if isinstance(cell.cell_contents, dict)
    )
    for i in range(1, 50):
        assert ask(Thing()) == i  # new objects take the place of old ones in memory
        gc.collect(0)
    gc.collect()
    assert not known


def test_a_changed_copy_of_a_rig_has_its_own_numbers_and_structure():
    from jounce.parts.rig import structure_of

    rig = jn.load("kart-quarter-car")
    numbers, structure = rig.parameters(), structure_of(rig)
    numbers["tyre.stiffness"] = -1.0  # of the caller alone
    assert rig.parameters()["tyre.stiffness"] > 0.0
    softer = rig.model_copy(
        update={"tyre": rig.tyre.model_copy(update={"stiffness": 1.0e5, "lift_off": False})}
    )
    assert softer.parameters()["tyre.stiffness"] == 1.0e5
    assert structure_of(softer) != structure == structure_of(rig)


@pytest.mark.parametrize(("most", "own"), [(2, sys.maxsize), (sys.maxsize, 2), (2, 3)])
def test_those_asked_for_last_are_kept(monkeypatch, most, own):
    monkeypatch.setattr(Recent, "most", most)
    made, recent = [], Recent(own)

    def of(key):
        return recent.of(key, lambda: made.append(key) or key.upper())

    assert [of(key) for key in ("a", "b", "a", "c", "a", "b")] == ["A", "B", "A", "C", "A", "B"]
    assert made == ["a", "b", "c", "b"]  # the third let go of b, which was asked for before a


def test_all_are_kept_where_nobody_says_how_many():
    recent = Recent()
    first = [recent.of(key, object) for key in range(1000)]
    assert [recent.of(key, object) for key in range(1000)] == first
    recent.clear()
    assert recent.of(0, object) is not first[0]


def test_what_could_not_be_made_is_tried_again_and_nothing_is_something():
    recent = Recent()
    with pytest.raises(ZeroDivisionError):
        recent.of("one", lambda: 1 / 0)
    assert recent.of("one", lambda: None) is None
    assert recent.of("one", lambda: 1) is None
