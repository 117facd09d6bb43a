"""Layouts of the page of recordings: what is shown and how, as one plain description that is saved, kept and shared."""

from __future__ import annotations

import re
from pathlib import Path
from tomllib import TOMLDecodeError
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from jounce.core.description import (
    Description,
    Whole,
    check_schema,
    read_description,
    toml_error,
    toml_table,
)
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.units import Unit

SCHEMA: Literal["jounce.layout/1"] = "jounce.layout/1"
TIME = "time"
FOLDER = "layouts"
"""Folder of a project with its layouts; paths of recordings begin at the project."""
Number = Annotated[float, Unit("1")]
Span = tuple[Number, Number]
Text = Annotated[str, Field(max_length=400)]
_NAME = re.compile(r"[^\W\d]\w*(\.\w+)*")
MOST_RECORDINGS = 6


class LaidRecording(Description):
    """A recording by its path in the project; ``shifts`` are added to its values on each axis, in the axis's unit."""

    path: Text
    shown: bool = True
    shifts: dict[str, Number] = Field(default_factory=dict, max_length=20)


class Graph(Description):
    """Channels that share one graph and its unit."""

    channels: tuple[Text, ...] = Field(max_length=6)


class Formula(Description):
    """A computed channel; without ``unit`` it has the SI unit that follows from its formula."""

    name: Annotated[str, Field(max_length=80)]
    formula: Annotated[str, Field(max_length=1000)]
    unit: Annotated[str, Field(max_length=40)] = ""

    @model_validator(mode="after")
    def _check_name(self) -> Formula:
        if not _NAME.fullmatch(self.name) or self.name == TIME:
            raise error_at(
                ("name",),
                "not a name for a computed channel",
                found=self.name,
                allowed="letters, digits, _ and points, such as front.slip; not time",
            )
        return self


class Event(Description):
    """A note at ``at`` of an ``axis``, in its unit: of a recording, or of the common axis if ``recording`` is empty."""

    at: Number
    text: Text
    recording: Text = ""
    axis: Text = TIME


class Chart(Description):
    """What is drawn of the window below the curves; ``across`` is the horizontal channel of a scatter plot."""

    kind: Literal["", "spectrum", "histogram", "scatter"] = ""
    channel: Text = ""
    across: Text = ""
    bins: Annotated[Whole, Field(ge=5, le=200)] = 40


class Layout(Description):
    """What the page of recordings shows; values of ``window`` and ``cursors`` are those of the common axis.

    ``axis`` is ``time`` (s), or a channel that never descends, such as a distance, in its unit.
    """

    schema_: Literal["jounce.layout/1"] = Field(default=SCHEMA, alias="schema")
    recordings: tuple[LaidRecording, ...] = Field(default=(), max_length=MOST_RECORDINGS)
    axis: Text = TIME
    graphs: tuple[Graph, ...] = Field(default=(), max_length=12)
    formulas: tuple[Formula, ...] = Field(default=(), max_length=40)
    events: tuple[Event, ...] = Field(default=(), max_length=200)
    window: Span | None = None
    cursors: Span | None = None
    chart: Chart = Field(default_factory=Chart)
    note: Annotated[str, Field(max_length=4000)] = ""

    @model_validator(mode="after")
    def _check_names(self) -> Layout:
        for key, names in (
            ("recordings", [one.path for one in self.recordings]),
            ("formulas", [one.name for one in self.formulas]),
        ):
            again = next((name for k, name in enumerate(names) if name in names[:k]), None)
            if again is not None:
                raise error_at((key,), Phrase("{name!r} is given twice", name=again))
        return self


def layout_text(layout: Layout) -> str:
    """Return a layout as the text of its file, without what is as usual."""
    import tomlkit

    plain = layout.model_dump(mode="json", by_alias=True, exclude_defaults=True)
    return tomlkit.dumps({"schema": SCHEMA, **_without_nothing(plain)})


def load_layout(file: Path) -> Layout:
    """Read a layout from its file; an error names what is wrong in it, with its line."""
    return read_description(Layout, file, SCHEMA)[0]


def layout_of(text: str, where: str) -> dict[str, Any]:
    """Return the layout in the text of a file as plain data; an error names what is wrong in it."""
    try:
        table = toml_table(text)
    except TOMLDecodeError as error:
        raise toml_error(error, where) from None
    check_schema(table, (SCHEMA,), where)
    return Layout.from_table(table, where=where, text=text).model_dump(mode="json", by_alias=True)


def _without_nothing(plain: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in plain.items() if value is not None}
