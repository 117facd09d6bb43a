"""Where a fault stands in a file: the line of its own entry, also in lists that go over several lines."""

from __future__ import annotations

import pytest
from pydantic import Field

from jounce.core.description import Description, line_of
from jounce.core.errors import DescriptionError

TEXT = """# bands ] of [ a limit
name = "x"
bands = [                              # from, to {
  { from = 0, to = 1, label = "a, b" },

  # { from = 3 },
  { from = 1, to = 2,
    label = "]" },
  { from = 2 },
]
points = [
  [0.0, 1.0],
  [2.0,
   3.0]
]
after = 1

[one."two.three"]   # a header
[[trial]]
speed = 1
[[trial]]
roads = ["A", "B",
  "C"]
"""


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("bands",), 3),
        (("bands", 0, "to"), 4),
        (("bands", 1, "label"), 7),
        (("bands", 2), 9),
        (("bands", 3), 3),
        (("points", 0, 1), 12),
        (("points", 1), 13),
        (("after",), 16),
        (("one", "two.three", "key"), 18),
        (("trial", 0, "speed"), 20),
        (("trial", 1, "roads", 1), 22),
        (("trial", 1, "roads", 2), 23),
    ],
)
def test_line_of_an_entry(path: tuple[str | int, ...], line: int) -> None:
    assert line_of(TEXT, path) == line


class Entry(Description):
    label: str


class Whole(Description):
    entries: tuple[Entry, ...] = Field(min_length=1)


def test_a_list_of_faulty_entries_is_not_called_empty() -> None:
    text = 'entries = [\n  {label = 1},\n  {lable = "b"},\n]\n'
    with pytest.raises(DescriptionError) as caught:
        Whole.from_table({"entries": [{"label": 1}, {"lable": "b"}]}, where="f.toml", text=text)
    lines = str(caught.value).splitlines()
    assert len(lines) == 2
    assert lines[0].startswith("f.toml, line 2: entries[0].label")
    assert lines[1].startswith("f.toml, line 3: entries[1].lable: unknown key")
    with pytest.raises(DescriptionError, match="at least 1 item"):
        Whole.from_table({"entries": []})
