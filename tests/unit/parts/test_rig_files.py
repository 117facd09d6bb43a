"""Rig files: round trips of changed text, and errors that name the line."""

from __future__ import annotations

import re
import tomllib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from jounce import parts
from jounce.core.description import line_of
from jounce.core.errors import DescriptionError
from jounce.parts import changed_text, load, rig_from_table

TEXT = """\
# a rig with everything
schema = "jounce.rig/1"
model = "quarter-car"
source = "made up = for tests, [tyre]"
gravity = "1 g"

[sprung]
mass = "16 kg"          # with the block

[unsprung]
mass = "5 kg"

[strut]
angle = "26 deg"
spring = {rate = "22.73 N/mm", preload = "10 N"}   # one line

[strut.damper]
velocity = ["-1 m/s", "0 m/s", "1 m/s"]
force = [-100.0, 0.0, 60.0]

[strut.friction]
force = "5 N"

[guide]
friction = {force = "2 N", regularisation_velocity = "3 mm/s"}

[strut.bump_stop]
gap = "12 mm"
rate = "60 N/mm"
progression = "300 N/mm^3"

[tyre]
damping_coefficient = "20 N*s/m"
lift_off = true
curve.kind = "polynomial"
curve.coefficients = [
  6.0e4,
  2.0e7,
]
"""


def read(text: str, where: str = "rig.toml"):
    return rig_from_table(tomllib.loads(text), where=where, text=text)


RIG = read(TEXT)


def test_nothing_changed_is_the_same_text():
    assert changed_text(TEXT, RIG, {}) == TEXT


@pytest.mark.parametrize("path", RIG.parameters())
def test_round_trip_of_every_number(path):
    value = RIG.parameters()[path] * 1.1 + 1e-3
    text = changed_text(TEXT, RIG, {path: value})
    assert read(text) == RIG.with_changes({path: value})
    changed = [line for line in TEXT.splitlines() if line not in text.splitlines()]
    assert len(changed) == (path != "strut.friction.regularisation_velocity"), (
        "one line, or a new one"
    )
    assert all(line.partition("#")[2] in text for line in TEXT.splitlines() if "#" in line), (
        "comments stay"
    )


def test_round_trip_of_everything():
    values = {path: value * 0.9 + 1e-4 for path, value in RIG.parameters().items()}
    assert read(changed_text(TEXT, RIG, values)).parameters() == values


@given(st.floats(1e-12, 1e12))
def test_round_trip_is_exact(rate):
    assert read(changed_text(TEXT, RIG, {"strut.spring.rate": rate})).strut.spring.rate == rate


@pytest.mark.parametrize("name", list(parts.library()))
def test_shipped_files(name, tmp_path):
    rig = load(name)
    lossy = [path.removesuffix("loss_angle") for path in rig.parameters() if "loss_angle" in path]
    dampings = tuple(f"{path}damping[" for path in lossy)  # a loss angle allows no damping
    values = {
        path: value if path.startswith(dampings) else value * 1.0003 + 1e-7
        for path, value in rig.parameters().items()
    }
    file = tmp_path / "new.toml"
    file.write_text(changed_text(parts.library()[name].read_text(), rig, values), encoding="utf-8")
    assert load(file).parameters() == values


def test_a_default_that_was_not_written_is_added():
    text = parts.library()["kart-quarter-car"].read_text()
    changed = changed_text(text, load("kart-quarter-car"), {"gravity": 9.8})
    assert read(changed).gravity == 9.8


def test_fitted_values_are_often_numpy_floats():
    changed = changed_text(TEXT, RIG, {"strut.spring.rate": np.float64(25000.0)})
    assert read(changed).strut.spring.rate == 25000.0


def test_bump_stop_at_the_top():
    text = TEXT.replace("[strut.bump_stop]", "[bump_stop]")
    rig = read(text)
    assert rig == RIG
    assert read(changed_text(text, rig, {"strut.bump_stop.gap": 0.02})).strut.bump_stop.gap == 0.02


def test_a_part_that_the_rig_lacks_is_an_error_of_the_user():
    kart = load("kart-quarter-car")
    with pytest.raises(DescriptionError, match=r"strut\.friction\.force"):
        changed_text(
            parts.library()["kart-quarter-car"].read_text(), kart, {"strut.friction.force": 5.0}
        )


MISTAKES = [
    ("[sprung]\nmass", '"16 kg" ', '"16 m" ', 8, "sprung.mass: wrong unit"),
    (
        "[unsprung]",
        'mass = "5 kg"',
        'mas = "5 kg"',
        11,
        "unsprung.mas: unknown key; allowed: mass. Did you mean 'mass'",
    ),
    ("gravity", '"1 g"', '"1 kg"', 5, "gravity: wrong unit"),
    ("angle", "26 deg", "86 deg", 14, "strut.angle: out of range"),
    ("spring", "22.73 N/mm", "22.73 Nmm", 15, "strut.spring.rate: wrong unit"),
    ("spring preload", '"10 N"', '"10"', 15, "strut.spring.preload: the unit is missing"),
    (
        "damper table",
        '"0 m/s", "1 m/s"',
        '"0 m/s", "-1 m/s"',
        17,
        r"strut.damper: velocity\[2\] = -1 is not above",
    ),
    ("damper unit", '"1 m/s"]', '"1 m"]', 18, r"strut.damper.velocity\[2\]: wrong unit"),
    ("damper numbers", "-100.0, 0.0", '"-100 kg", 0.0', 19, r"strut.damper.force\[0\]: wrong unit"),
    ("friction", 'force = "5 N"', 'force = "-5 N"', 22, "strut.friction.force: out of range"),
    ("guide", '"3 mm/s"', '"0 mm/s"', 25, "guide.friction.regularisation_velocity: out of range"),
    ("stop", 'gap = "12 mm"', 'gab = "12 mm"', 28, "strut.bump_stop.gab: unknown key.*'gap'"),
    ("stop unit", '"300 N/mm^3"', '"300 N/mm"', 30, "strut.bump_stop.progression: wrong unit"),
    (
        "tyre",
        "lift_off = true",
        "lift_off = 3",
        34,
        "tyre.lift_off: input should be a valid boolean",
    ),
    (
        "tyre curve",
        '"polynomial"',
        '"polynomal"',
        32,
        "tyre.curve: unknown kind 'polynomal'.*'polynomial'",
    ),
    (
        "tyre law",
        "lift_off = true",
        "stiffness = 1.0",
        32,
        "tyre: give exactly one of stiffness, curve",
    ),
    ("section", "[guide]", "[giude]", 24, "giude: unknown key.*'guide'"),
]


@pytest.mark.parametrize(
    ("name", "old", "new", "line", "message"), MISTAKES, ids=[mistake[0] for mistake in MISTAKES]
)
def test_errors_name_file_line_and_path(name, old, new, line, message):
    assert old in TEXT
    with pytest.raises(DescriptionError) as caught:
        read(TEXT.replace(old, new, 1), where="folder/rig.toml")
    place = [
        text for text in str(caught.value).splitlines() if f"folder/rig.toml, line {line}: " in text
    ]
    assert any(re.search(message, text) for text in place), str(caught.value)


def test_several_mistakes_are_told_at_once():
    text = (
        TEXT.replace('"16 kg" ', '"16 m" ')
        .replace('"5 N"', '"-5 N"')
        .replace('gap = "12 mm"', 'gab = "12 mm"')
    )
    with pytest.raises(DescriptionError) as caught:
        read(text)
    message = str(caught.value)
    assert all(
        place in message
        for place in (
            "line 8: sprung.mass",
            "line 22: strut.friction",
            "line 28: strut.bump_stop.gab",
        )
    )


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            '"quarter-car"',
            '"quater-car"',
            "rig.toml.*unknown model 'quater-car'; allowed: .*quarter-car.*Did you mean",
        ),
        ('model = "quarter-car"', "", "the key 'model' is missing"),
        (
            '"jounce.rig/1"',
            '"jounce.rig/2"',
            "schema line.*found 'jounce.rig/2'; allowed: schema = \"jounce.rig/1\"",
        ),
        ('schema = "jounce.rig/1"', "", "schema line is missing"),
    ],
)
def test_kind_of_file(old, new, message):
    with pytest.raises(DescriptionError, match=f"(?s){message}"):
        read(TEXT.replace(old, new, 1))


def test_files_that_are_no_rigs(tmp_path):
    file = tmp_path / "rig.toml"
    for content, message in (
        (b"", "empty"),
        (b"b = 1\na = = 2\n", "not valid TOML.*line 2"),
        (b"\xff\xfe\x00", "not a text file"),
    ):
        file.write_bytes(content)
        with pytest.raises(DescriptionError, match=message):
            load(file)


CAMPAIGN = """\
name = "x"

[[trial]]
speed = "1 m/s"
[trial.road]
height = "1 mm"

[[trial]]
speed = "2 m/s"
[trial.road]
height = "2 mm"

[roads.A]
kind = "x"

[[fit]]
of = "a"
"""


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("name",), 1),
        (("trial", 0, "speed"), 4),
        (("trial", 0, "road", "height"), 6),
        (("trial", 1), 8),
        (("trial", 1, "speed"), 9),
        (("trial", 1, "road"), 10),
        (("trial", 1, "road", "height"), 11),
        (("trial", 1, "missing"), 8),
        (("roads", "A", "kind"), 14),
        (("fit", 0, "of"), 17),
        (("trial", 2, "speed"), None),
        (("nothing",), None),
    ],
)
def test_lines_in_arrays_of_tables(path, line):
    assert line_of(CAMPAIGN, path) == line


@pytest.mark.parametrize(
    ("text", "path", "line"),
    [
        ("[[a.trial]]\nspeed = 1\n[[a.trial]]\nspeed = 2\n", ("a", "trial", 1, "speed"), 4),
        ('note = """\n[tyre]\nrate = 3\n"""\n[tyre]\nrate = 4\n', ("tyre", "rate"), 6),
    ],
    ids=["array in a table", "text of several lines"],
)
def test_lines_in_harder_texts(text, path, line):
    assert line_of(text, path) == line
