"""Description files of every kind with lines that are wrong: checked, and used by a command that needs them."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from corpus.commands import folder_of_files, said_by
from corpus.judging import is_clear
from corpus.mutations import SEED
from jounce.core.errors import DescriptionError
from jounce.core.units import to_si


@dataclass(frozen=True)
class Kind:
    """A good file of a kind: its text, its name, and the command that uses it, empty where that takes long."""

    text: Callable[[], str]
    name: str = "given.toml"
    use: str = ""


def _shipped(package: str, *parts: str) -> Callable[[], str]:
    def read() -> str:
        from importlib import resources

        return resources.files(package).joinpath(*parts).read_text(encoding="utf-8")

    return read


_ROADS = {
    "half-sine": 'height = "10 mm"\nlength = "60 mm"\nstart = "0.1 m"\n',
    "trapezoid": 'height = "10 mm"\nlength = "0.3 m"\nrise = "0.1 m"\nstart = "0.1 m"\n',
    "step": 'height = "10 mm"\nstart = "0.1 m"\n',
    "train": 'count = 3\npitch = "0.2 m"\n[of]\nkind = "versine"\nheight = "10 mm"\nlength = "60 mm"\n',
}
_HEADER = 'plate_number = "B-AB 123"\ndate = "2026-11-22"\naxle = "front"\n[left]\nstatic_load = "4.3 kN"\n'
_LIBRARY = "jounce.parts", "library"
_DESIGN = """schema = "jounce.design/1"
rig = "formula-student-front"
[[free]]
point = "hardpoints.tie_rod_inner"
within = "15 mm"
[[target]]
quantity = "camber_gain"
value = "-33 deg/m"
tolerance = "0.5 deg/m"
[[target]]
quantity = "toe"
over = "-30 mm:30 mm:5 mm"
value = "0 deg"
tolerance = "0.03 deg"
"""
_SWEEP = """schema = "jounce.sweep/1"
rig = "audi-a6-quarter-car"
metrics = ["rms sprung.az"]
outputs = ["sprung.z"]
output_step = "1 ms"
[trial]
speed = "10 m/s"
duration = "0.5 s"
road = {kind = "half-sine", height = "10 mm", length = "1 m"}
[design]
kind = "sobol"
count = 4
seed = 1
[vary]
"strut.damper.coefficient" = "40 %"
"sprung.mass" = ["400 kg", "520 kg"]
"tyre.stiffness" = {mean = "300 N/mm", sd = "5 %"}
"""
_OPTIMISATION = """schema = "jounce.optimisation/1"
rig = "audi-a6-quarter-car"
free = {"strut.damper.coefficient" = ["500 N*s/m", "5000 N*s/m"]}
front = ["motorway: p95 sprung.az", "bump: p95 tyre.force"]
constraints = {"motorway: strut.deflection" = "30 mm"}
spread = {"sprung.mass" = ["400 kg", "550 kg"], "strut.damper.coefficient" = "15 %"}
samples = 8
seed = 1
points = 3
[cases.motorway]
road = "A"
speed = "36 m/s"
[cases.bump]
road = {kind = "half-sine", height = "10 mm", length = "1 m"}
speed = "10 m/s"
duration = "0.5 s"
"""

_LABORATORY = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {height = "10 mm", length = "60 mm"}
belt = {length = "1.97 m", radius = "50 mm", pulses = 12, column = "ch2"}
trials = "trials.csv"
[channels]
ch0 = {measures = "sprung.az", sensitivity = "100 mV/g", high_pass = "0.5 Hz"}
ch1 = {measures = "unsprung.az", sensitivity = ["10 pC/(m/s^2)", "1 mV/pC"], orientation = -1}
"""

_SENSORS = """schema = "jounce.sensors/1"
[sensors."sprung.az"]
column = "ch0"
sensitivity = "100 mV/g"
zero = "0.1 V"
range = "5 V"
high_pass = "0.5 Hz"
low_pass = "250 Hz"
noise = "0.05 m/s^2"
orientation = -1
[sensors."unsprung.az"]
column = "ch1"
sensitivity = ["10 pC/(m/s^2)", "1 mV/pC"]
gain = 1.0
bias = "0 m/s^2"
datum = "rest"
"""

_KC_MAP = """schema = "jounce.kc-map/1"
convention = {y = "right", z = "down", steer = "right"}
track = "1.5 m"
gauge_base = "400 mm"
wheel = "left"
axle = "front"
[tests]
"Run 07" = "lateral-opposed"
[columns]
ch0 = "left.toe [deg]"
ch1 = {quantity = "camber", wheel = "right", unit = "deg", sign = -1, offset = 0.5, test = "bounce"}
"""

_LAYOUT = """schema = "jounce.layout/1"
axis = "time"
note = "kerbs"
[[recordings]]
path = "lane.csv"
shown = true
shifts = {time = 0.5}
[[graphs]]
channels = ["speed", "force"]
[[formulas]]
name = "way"
formula = "integral(speed)"
unit = "m"
[[events]]
at = 1.0
text = "kerb"
recording = ""
axis = "time"
"""

KINDS = {
    "rig": Kind(_shipped(*_LIBRARY, "kart-quarter-car.toml"), use="modes given.toml"),
    "rig in 3-D": Kind(_shipped(*_LIBRARY, "kart-double-wishbone.toml"), use="modes given.toml"),
    "vehicle": Kind(_shipped(*_LIBRARY, "audi-a6-half-car-4dof.toml"), use="modes given.toml"),
    "full car": Kind(_shipped(*_LIBRARY, "audi-a6-full-car.toml"), use="modes given.toml"),
    **{
        f"road: {kind}": Kind(
            lambda kind=kind: f'schema = "jounce.road/1"\nkind = "{kind}"\n{_ROADS[kind]}',
            use="simulate kart-quarter-car --road given.toml --speed 2 --duration 0.05",
        )
        for kind in _ROADS
    },
    "control": Kind(lambda: 'schema = "jounce.control/1"\nlaw = "skyhook"\n'),
    "tester": Kind(
        _shipped(*_LIBRARY, "testers", "eusama.toml"),
        use="inspect evaluate lane.csv --tester given.toml",
    ),
    "limits": Kind(
        _shipped("jounce.inspection", "limits.toml"),
        use="inspect evaluate lane.csv --tester eusama --limits given.toml",
    ),
    "truth": Kind(_shipped("jounce.campaign", "library", "kart-prototype.toml")),
    "campaign": Kind(
        _shipped("jounce", "library", "campaigns", "template", "campaign.toml"),
        name="c/campaign.toml",
    ),
    "laboratory": Kind(lambda: _LABORATORY, use="campaign sheet given.toml"),
    "sensors": Kind(lambda: _SENSORS, use="analyse statistics lane.csv --sensors given.toml"),
    "kc-map": Kind(lambda: _KC_MAP),
    "layout": Kind(lambda: _LAYOUT),
    "design": Kind(lambda: _DESIGN),
    "sweep": Kind(lambda: _SWEEP),
    "optimisation": Kind(lambda: _OPTIMISATION),
    "header": Kind(
        lambda: _HEADER, name="lane.toml", use="inspect evaluate lane.csv --tester eusama"
    ),
}
"""A good file of each kind; a test holds that every schema has one."""

VALUES = {
    "digits": "1" + "0" * 5000,
    "long integer": "9" * 400,
    "nested": "[" * 3000 + "]" * 3000,
    "nested a little": "[" * 60 + "]" * 60,
    "dotted": "{" + ".".join("a" * 200) + " = 1}",
    "huge": "1e308",
    "nan": "nan",
    "infinite": "-inf",
    "table": "{a = {b = 1}}",
    "date": "1979-05-27",
    "truth": "true",
    "negative": "-1e-9",
    "zero": "0",
    "list": '["a", 1, []]',
    "empty": '""',
    "many units": '"1 mm mm mm"',
    "huge with a unit": '"1e999 mm"',
    "bomb": '"1 m^9**9**9**9"',
    "blanks": '"1' + " " * 3000 + 'x"',
    "long text": '"' + "x" * 200_000 + '"',
    "markup": '"$x^$ \\u001b[2J \\u202e \\u0000"',
    "no TOML": "= =",
}
"""What is written behind the equals sign."""
NEVER = (
    "digits",
    "nested",
    "dotted",
    "nan",
    "infinite",
    "date",
    "no TOML",
    "huge",
    "long integer",
    "list",
)
"""What no key of any description takes."""
NO_QUANTITY = (
    "table",
    "truth",
    "empty",
    "many units",
    "huge with a unit",
    "bomb",
    "blanks",
    "long text",
    "markup",
)
"""What no quantity is."""
WHOLE = ("line twice", "misspelt", "left out", "file cut", "bytes", "a different schema")
"""Mutations of the file rather than of a value."""
_LINE = re.compile(r"(\s*(?:[\w-]+|\"[^\"]*\")(?:\.[\w-]+)*\s*=\s*)([^\s].*)$")


@cache
def lines_of(kind: str) -> tuple[list[str], list[int]]:
    """Lines of the good file, and the indices of those with a key."""
    lines = KINDS[kind].text().splitlines()
    keys = [
        index
        for index, line in enumerate(lines)
        if _LINE.match(line) and line.count("[") == line.count("]")
    ]
    return lines, [index for index in keys if '"""' not in lines[index]]


def cases(most: int = 55) -> list[tuple[str, int, str]]:
    """Kind of file, line, and what is done to it."""
    found: list[tuple[str, int, str]] = []
    wrongs = [*VALUES, *WHOLE]
    for kind in KINDS:
        _, keys = lines_of(kind)
        pairs = [(line, wrong) for line in keys for wrong in wrongs]
        chosen = np.random.default_rng(SEED).permutation(len(pairs))[:most]
        found += [(kind, *pairs[index]) for index in sorted(chosen)]
    return found


def damaged(kind: str, line: int, wrong: str) -> tuple[bytes, bool]:
    """The bad file, and whether it must be refused."""
    lines, _ = lines_of(kind)
    lines = list(lines)
    match = _LINE.match(lines[line])
    assert match
    if wrong in VALUES:
        lines[line] = match[1] + VALUES[wrong]
        quantity = _is_quantity(match[2])
        never = NEVER + (NO_QUANTITY if quantity else ())
        must = wrong in never and (kind, wrong) != ("header", "date")
        return "\n".join(lines).encode(), must
    if wrong == "line twice":
        lines.insert(line, lines[line])
        return "\n".join(lines).encode(), True
    if wrong == "misspelt":
        lines[line] = "x" + lines[line].lstrip().replace('"', "", 0)
        return "\n".join(lines).encode(), False
    if wrong == "left out":
        del lines[line]
        return "\n".join(lines).encode(), False
    text = "\n".join(lines).encode()
    if wrong == "file cut":
        return text[: len("\n".join(lines[:line]).encode()) + len(match[1])], True
    if wrong == "bytes":
        return text[: len(text) // 2] + bytes(range(128, 200)) + text[len(text) // 2 :], True
    return re.sub(
        rb'schema = "jounce\.[\w-]+/1"', b'schema = "jounce.nothing/7"', text, count=1
    ), b"schema =" in text


def _is_quantity(value: str) -> bool:
    written = re.sub(r"\s+#.*$", "", value).strip()
    text = written.strip('"')
    try:
        float(text)
        return text == written  # a number in quotes is the name of something
    except ValueError:
        for si in (
            "m",
            "kg",
            "N/m",
            "N*s/m",
            "m/s",
            "s",
            "Hz",
            "N",
            "rad",
            "Pa",
            "kg*m^2",
            "m/s^2",
        ):
            try:
                to_si(text, si)
            except DescriptionError:
                continue
            return True
        return False


def verdict(case: tuple[str, int, str]) -> tuple[str, str]:
    """What ``check`` says to a bad file, and whether it refuses what its use refuses."""
    kind, line, wrong = case
    content, must = damaged(kind, line, wrong)
    of = KINDS[kind]
    with folder_of_files():
        if kind == "campaign":
            from jounce.campaign import new_campaign

            new_campaign("c")
        file = Path(of.name)
        file.write_bytes(content)
        code, out, err = said_by(["check", str(file)])
        told = f"check {code}: {(err or out)[:600]}"
        if code not in (0, 2):
            return "crashed", told
        if code == 2 and not is_clear(err, file.name):
            return "unclear", told
        if code == 0 and must:
            return ("flagged" if "warning: " in out else "silently wrong"), told
        if of.use:
            used, _, error = said_by(of.use.split())
            if used == 1 and "internal error" in error:
                return "crashed", f"{of.use} {used}: {error}"
            if used == 2 and code == 0:
                return "unclear", f"check takes what is refused by {of.use}: {error}"
        return ("refused" if code == 2 else "accepted"), told
