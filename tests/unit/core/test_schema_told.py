"""What schema a file names, before it is read: also one that is not sound yet."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.core.description import schema_named_in


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('schema = "jounce.optimisation/1"\n', "jounce.optimisation/1"),
        ("# a study\n  'schema'='jounce.sweep/1'  # of springs\n[free]\n", "jounce.sweep/1"),
        ('schema = "jounce.optimisation/1"\nfree = {\n', "jounce.optimisation/1"),
        ('# schema = "jounce.optimisation/1"\nmodel = "quarter-car"\n', ""),
        ('my_schema = "jounce.optimisation/1"\n', ""),
        ("", ""),
    ],
)
def test_the_line_is_found_however_it_is_written(tmp_path: Path, text: str, told: str) -> None:
    file = tmp_path / "study.toml"
    file.write_text(text, encoding="utf-8")
    assert schema_named_in(file) == told


def test_what_is_no_file_of_toml_names_none(tmp_path: Path) -> None:
    (tmp_path / "study.txt").write_text('schema = "jounce.optimisation/1"\n', encoding="utf-8")
    assert [schema_named_in(tmp_path / name) for name in ("study.txt", "missing.toml", ".")] == [
        "",
        "",
        "",
    ]
    assert schema_named_in(Path("audi-a6-quarter-car")) == ""
