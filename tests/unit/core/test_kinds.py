"""Registries without a list: a class joins its family when it is written, and fields of the family take it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar, Literal

import pytest

from jounce.core.description import Description
from jounce.core.errors import DescriptionError
from jounce.core.kinds import FILE_REF, Kinds, Rows
from jounce.core.units import Length


class Shape(Description, ABC):
    kinds: ClassVar[Kinds] = Kinds("kind", package="jounce.core", schema="shape.schema.json")
    start: Length = 0.0

    @abstractmethod
    def size(self) -> float: ...


class Bar(Shape):
    kind: Literal["bar"] = "bar"
    length: Length

    def size(self) -> float:
        return self.length


class Pair(Shape):
    kind: Literal["pair"] = "pair"
    of: Shape

    def size(self) -> float:
        return 2.0 * self.of.size()


class Drawing(Description):
    shape: Shape | None = None


def test_a_table_becomes_the_member_that_its_word_selects():
    drawing = Drawing.from_table(
        {"shape": {"kind": "pair", "of": {"kind": "bar", "length": "3 mm"}}}
    )
    assert drawing.shape == Pair(of=Bar(length=0.003))
    assert drawing.shape.size() == 0.006
    assert drawing.model_dump(exclude_unset=True) == {
        "shape": {"kind": "pair", "of": {"kind": "bar", "length": 0.003}}
    }


def test_a_class_written_later_joins():
    class Ring(Shape):
        kind: Literal["ring"] = "ring"

        def size(self) -> float:
            return 1.0

    assert list(Shape.kinds) == ["bar", "pair", "ring"]
    assert Drawing.from_table({"shape": {"kind": "ring"}}).shape == Ring()


def test_a_variant_of_a_class_does_not_take_its_place():
    class LongBar(Bar):
        length: Length = 5.0

    assert Shape.kinds["bar"] is Bar
    assert Drawing(shape=LongBar()).shape == LongBar()


def test_a_word_is_given_once():
    with pytest.raises(TypeError, match="Rod: the kind 'bar' is already used by Bar"):

        class Rod(Shape):
            kind: Literal["bar"] = "bar"

            def size(self) -> float:
                return 0.0


@pytest.mark.parametrize(
    ("shape", "message"),
    [
        (
            {"kind": "pair", "of": {"kind": "bar", "lenght": 1}},
            r"shape\.of\.lenght: unknown key; allowed: .*'length'",
        ),
        (
            {"kind": "pair", "of": {"kind": "baar"}},
            r"shape\.of: unknown kind 'baar'; allowed: bar, .*'bar'",
        ),
        (
            {"kind": "pair", "of": {}},
            r"shape\.of: the key 'kind', which selects the kind, is missing",
        ),
        ({"kind": "bar", "length": "3 kg"}, r"shape\.length: wrong unit; found '3 kg'"),
        (3, r"shape: .*found 3"),
    ],
)
def test_mistakes_are_placed(shape: object, message: str):
    with pytest.raises(DescriptionError, match=message):
        Drawing.from_table({"shape": shape})


def test_schemas_refer_to_the_file_of_the_family():
    assert {FILE_REF: "shape.schema.json"} in Drawing.model_json_schema()["properties"]["shape"][
        "anyOf"
    ]


def test_rows_are_there_at_the_first_look():
    rows: Rows[int] = Rows("jounce.core")
    rows.add("b", 2)
    rows.add("a", 1)
    assert dict(rows) == {"a": 1, "b": 2}
