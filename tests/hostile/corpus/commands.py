"""Every option and argument of every command with values that are wrong."""

from __future__ import annotations

import contextlib
import io
import os
import shlex
import shutil
import tempfile
import zlib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from corpus.judging import is_clear
from corpus.mutations import SEED
from jounce.core.text import visible

BASES = {
    "demo": "demo --quick --out demo",
    "simulate": 'simulate kart-quarter-car --excitation base.csv --duration "0.05 s" --out run.nc',
    "modes": "modes kart-quarter-car",
    "adjust": 'adjust kart-double-wishbone --camber "-2 deg"',
    "kinematics": 'kinematics kart-double-wishbone --travel "-4 mm:4 mm:4 mm"',
    "ride": 'ride audi-a6-quarter-car --road iso:C --speed "20 m/s" --duration "3 s"',
    "ride-metrics": "ride-metrics ride.csv",
    "compare": 'compare audi-a6-quarter-car --speed "20 m/s" --duration "3 s" --control skyhook',
    "speed-limit": 'speed-limit audi-a6-quarter-car --road iso:D --slowest "9 m/s" --fastest "10 m/s" --points 3 '
    '--length "40 m"',
    "iri": "iri profile.csv",
    "plot": "plot base.csv --figure base.png",
    "draw": "draw kart-double-wishbone --figure kart.png",
    "animate": 'animate kart-double-wishbone --travel "-4 mm:4 mm:4 mm" --report kart.html',
    "check": "check base.csv",
    "library": "library kart-quarter-car",
    "serve": "serve none --no-open",
    "version": "version",
    "completion": "completion bash",
    "kc": "kc twist-beam --test bounce --points 9",
    "load-cases": "load-cases formula-student-front --car axle=front --car mass=280 --car wheelbase=1.55 "
    "--car centre_of_mass_height=0.3 --car weight_share=0.48 --car brake_share=0.65",
    "clearances": "clearances kart-double-wishbone --between "
    '"rod: tie_rod_inner-tie_rod_outer 5 mm, rim 120 mm from -50 mm to 20 mm"',
    "steering-effort": 'steering-effort kart-double-wishbone --load lateral_force="100 N"',
    "analyse statistics": "analyse statistics ride.csv",
    "analyse spectrum": "analyse spectrum ride.csv",
    "analyse transfer": "analyse transfer lane.csv --input left.plate.z --output left.plate.force",
    "analyse modes": "analyse modes decay.csv --decay",
    "analyse integrate": 'analyse integrate ride.csv --above "1 Hz"',
    "campaign run": "campaign run none.toml --out results",
    "campaign posterior": "campaign posterior none.toml --out drawn",
    "campaign next": "campaign next none.toml",
    "campaign models": "campaign models none.toml",
    "campaign sheet": "campaign sheet settings.toml",
    "campaign new": "campaign new mine",
    "campaign synthesise": 'campaign synthesise bench --duration "0.6 s"',
    "sweep": "sweep none.toml --out swept",
    "design springs": 'design springs audi-a6-full-car --frequency "1.2 Hz" --damping-ratio 0.3',
    "design optimise": "design optimise kart-quarter-car --objective sprung.az --free strut.damper.coefficient=50..500",
    "design pareto": 'design pareto audi-a6-quarter-car --free strut.damper.coefficient="300..6000" --points 3',
    "design kinematics": "design kinematics none.toml --out designed",
    "export equations": "export equations kart-quarter-car --out kart.tex",
    "export hardpoints": "export hardpoints kart-double-wishbone --out kart.dxf",
    "design kinematic-front": "design kinematic-front none.toml --points 2 --out front",
    "export chrono": "export chrono sedan-double-wishbone --out sedan.json",
    "export mjcf": "export mjcf kart-double-wishbone --out kart.xml",
    "export road": 'export road iso:C --length "5 m" --out class-c.crg',
    "export fmu": "export fmu kart-quarter-car --out kart.fmu --sources-only",
    "import adams": "import adams front.sub",
    "import chrono": "import chrono chrono.json",
    "import hardpoints": "import hardpoints points.csv",
    "import mjcf": "import mjcf corner.xml",
    "fit stiffness": "fit stiffness spring.csv",
    "fit hardpoints": 'fit hardpoints formula-student-front poses.csv --free hardpoints.tie_rod_inner[2]="10 mm"',
    "fit decay": 'fit decay base.csv --channel road.z --mass "16 kg"',
    "fit damper": "fit damper damper.csv",
    "damper map": "damper map damper.csv",
    "damper histogram": "damper histogram damper.csv --channel damper=displacement",
    "damper sheet": "damper sheet sheet.csv",
    "damper compare": "damper compare sheet.csv sheet.csv",
    "damper clicks": "damper clicks sheet.csv --target kart-quarter-car",
    "spring map": "spring map spring.csv",
    "fit calibration": "fit calibration tilt.csv",
    "bench speed": 'bench speed --inverter-frequency "24.6 Hz" --cylinder-radius "50 mm"',
    "bench drive": 'bench drive --speed "3.87 m/s" --cylinder-radius "50 mm"',
    "bench scale": 'bench scale --prototype-mass "18.6 kg"',
    "bench springs": 'bench springs stiff="52.775 N/mm" --sprung-mass "16 kg"',
    "inspect simulate": "inspect simulate audi-a6-quarter-car --method theta",
    "inspect evaluate": "inspect evaluate lane.csv --tester eusama",
    "inspect import": "inspect import lane.csv --store lane.sqlite --tester eusama",
    "inspect watch": "inspect watch . --store lane.sqlite --tester eusama --once",
    "inspect reevaluate": "inspect reevaluate --store lane.sqlite",
    "inspect history": 'inspect history --plate "B-AB 123" --store lane.sqlite',
    "inspect protocol": "inspect protocol 1 --store lane.sqlite",
    "inspect search": "inspect search --store lane.sqlite",
    "inspect export": "inspect export --store lane.sqlite --out table.csv",
    "inspect verify": "inspect verify --store lane.sqlite",
    "study proving-ground": "study proving-ground --out ground",
    "study lumped-vs-spatial": "study lumped-vs-spatial kart-double-wishbone --lumped kart-quarter-car",
    "study audi-a6-case-a": "study audi-a6-case-a --out a",
    "study audi-a6-case-b": "study audi-a6-case-b --out b",
    "study audi-a6-excenter": "study audi-a6-excenter --out c",
    "study inspection-equivalence": "study inspection-equivalence audi-a6-quarter-car --points 2",
}
"""A right use of each command; a test holds that there is one for every command."""

_SETTINGS = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {height = "10 mm", length = "60 mm"}
trials = "trials.csv"
belt = {length = "1.97 m"}
"""

VALUES = {
    "nothing": "",
    "a word": "nonsense",
    "a different unit": "5 furlong*kg",
    "beyond numbers": "1e400 m",
    "no number": "nan",
    "infinite": "-inf",
    "a large number": "1e308",
    "a bomb of a unit": "1 m^9**9**9**9",
    "many digits": "9" * 400,
    "a long text": "x" * 20_000,
    "nested": "[" * 500 + "]" * 500,
    "spaces": "1" + " " * 4000 + "\n x",
    "escapes": "\x1b[2J\u202e",
    "no text": "\udcff",
    "a path away": "no/such/folder/file.xyz",
    "a folder": ".",
    "an empty file": "empty",
    "rubbish": "rubbish.bin",
    "an equation": "a=b=c",
    "an own table": 'x={a=[1,2,{b="$x^$"}]}',
    "a long integer by path": "mass=" + "9" * 400,
    "a NUL": "a\0b",
    "a hyphen": "-",
    "an option": "--json",
    "formats": "%s%n{0}{x!r}",
    "a home": "~no-such-user/x.toml",
    "a device": "/dev/null",
    "a link to itself": "loop",
    "another process": "/proc/self/mem",
}
"""What is given in the place of an option's value, or of an argument."""

TEXTS = {
    "--plate",
    "--place",
    "--inspector",
    "--date",
    "--variable",
    "--name",
    "--serial",
    "--remark",
    "--wheel",
    "--since",
    "--until",
    "--tester",
}
"""Options that are any text, or that are looked for and not found."""
ANY_NUMBER = {"--workers", "--seed"}
"""Any integer is a seed, and no more processes are started than there is work for."""
OUTPUTS = {"--out", "--figure", "--report", "--store", "FOLDER"}
"""What is written: a name that the system takes is a right one."""
SLOW = (
    "demo",
    "study audi-a6-excenter",
    "study lumped-vs-spatial",
    "study proving-ground",
    "study audi-a6-case-a",
    "study audi-a6-case-b",
    "study inspection-equivalence",
)
"""Commands whose outputs are not tried: where the name is a right one, it is a study."""


def parameters(command: Any, name: tuple[str, ...] = ()) -> Iterator[tuple[str, Any]]:
    """Each command that can be run, by its name."""
    if hasattr(command, "commands"):
        for word, inner in command.commands.items():
            yield from parameters(inner, (*name, word))
    else:
        yield " ".join(name), command


@cache
def commands() -> dict[str, Any]:
    """All commands, from the command line itself, with the options that each of them has."""
    from jounce.cli.entry import _command
    from jounce.web import command as _workbench  # noqa: F401 - it adds its command

    return dict(parameters(_command()))


def cases() -> list[tuple[str, str, str]]:
    """Command, option or argument, and name of the value."""
    found: list[tuple[str, str, str]] = []
    kinds = list(VALUES)
    for name, command in commands().items():
        found += [
            (name, place, "")
            for place in ("no such option", "one word too many", "an option twice", "no value")
        ]
        for parameter in command.params:
            if name in SLOW and parameter.opts[0] in OUTPUTS:
                continue
            option = (
                parameter.opts[0]
                if parameter.param_type_name == "option"
                else parameter.name.upper()
            )
            if getattr(parameter, "is_flag", False):
                continue
            # A seed of its own, so that an option more changes nothing of the others.
            random = np.random.default_rng([SEED, zlib.crc32(f"{name} {option}".encode())])
            chosen = random.choice(len(kinds), 3 if name in SLOW else 4, replace=False)
            found += [(name, option, kinds[index]) for index in sorted(chosen)]
    return found


def words_of(case: tuple[str, str, str], words: list[str] | None = None) -> list[str]:
    """The command line of a case, made of a right one."""
    name, place, kind = case
    words = words or shlex.split(BASES[name])
    if place == "no such option":
        return [*words, "--no-such-option", "1"]
    if place == "one word too many":
        return [*words, "--", "a", "b", "c", "d", "e", "f", "g", "h"]
    if place == "an option twice":
        return [*words, "--json", "--json", "--json=1"]
    if place == "no value":
        option = next(
            (
                p.opts[0]
                for p in commands()[name].params
                if p.param_type_name == "option" and not p.is_flag
            ),
            "",
        )
        return [*words, option or "--nothing"]
    value = VALUES[kind]
    if place.startswith("--"):
        if place in words:
            at = words.index(place)
            return [*words[: at + 1], value, *words[at + 2 :]]
        return [*words, f"{place}={value}"]
    at = len(name.split())
    return [*words[:at], value, *words[at + 1 :]]


@contextlib.contextmanager
def folder_of_files() -> Iterator[None]:
    """Stand in a new folder with the files that the right uses name."""
    home = Path.cwd()
    if not (home / "whole").is_dir():
        (home / "whole").mkdir()
        os.chdir(home / "whole")
        prepare()
        os.chdir(home)
    with tempfile.TemporaryDirectory(dir=home) as folder:
        shutil.copytree(home / "whole", folder, dirs_exist_ok=True, symlinks=True)
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(home)


def prepare() -> None:
    """Make the files that the right uses name."""
    time = np.arange(200) * 0.005
    wave = np.sin(2.0 * np.pi * 3.0 * time)

    def write(name: str, head: str, *columns: np.ndarray) -> None:
        rows = "".join(
            ",".join(f"{v:.9g}" for v in row) + "\n" for row in zip(*columns, strict=True)
        )
        Path(name).write_text(f"{head}\n{rows}", encoding="utf-8")

    write("base.csv", "time [s], road.z [m]", time, 0.01 * wave)
    write("profile.csv", "x [m], z [m]", time * 40.0, 0.01 * wave)
    way = np.concatenate([np.linspace(0.0, 15.0, 31), np.linspace(14.5, 0.0, 30)])
    write("spring.csv", "displacement [mm], force [N]", way, 22.73 * way)
    force = 900.0 * np.cos(2.0 * np.pi * 3.0 * time)
    poses = np.linspace(-0.03, 0.03, 13)
    write("poses.csv", "wheel_travel [m], toe [deg]", poses, 0.3 - 4.0 * poses)
    write(
        "tilt.csv",
        "angle [deg], out [V]",
        np.array([0.0, 90.0, 180.0]),
        np.array([2.6, 2.501, 2.4]),
    )
    write("damper.csv", "time [s], displacement [m], force [N]", time, 0.02 * wave, force)
    places = np.array([(c, v) for c in (0.0, 8.0) for v in (-0.3, -0.1, 0.1, 0.3)]).T
    loads_at = (400.0 - 20.0 * places[0]) * places[1]
    write("sheet.csv", "clicks, velocity [m/s], force [N]", *places, loads_at)
    long = np.arange(5000) * 0.005
    sweep = np.sin(2.0 * np.pi * (25.0 * long - 0.5 * long**2))
    loads = [
        3.0 * sweep,
        4000.0 + 900.0 * np.sin(2.0 * np.pi * (25.0 * long - 0.5 * long**2) + 0.6),
    ]
    write(
        "ride.csv",
        "time [s], seat.az [m/s^2]",
        long,
        np.random.default_rng(2).normal(size=len(long)),
    )
    decay = np.exp(-2.0 * long) * np.cos(2.0 * np.pi * 3.0 * long)
    write("decay.csv", "time [s], sprung.az [m/s^2]", long[:1000], decay[:1000])
    write("lane.csv", "time [s], left.plate.z [mm], left.plate.force [N]", long, *loads)
    Path("settings.toml").write_text(_SETTINGS, encoding="utf-8")
    Path("trials.csv").write_text(
        "trial,speed [m/s],profile\n1,1.95,A\n2,1.97,B 0.10\n", encoding="utf-8"
    )
    Path("empty").write_bytes(b"")
    Path("loop").symlink_to("loop")
    Path("rubbish.bin").write_bytes(np.random.default_rng(1).bytes(3000))
    Path("plate.csv").write_text(
        '# plate_number = "B-AB 123"\n' + Path("lane.csv").read_text(encoding="utf-8")
    )
    store = ["--store", "lane.sqlite", "--tester", "eusama"]
    code, *said = said_by(["inspect", "import", "lane.csv", "plate.csv", *store])
    Path("plate.csv").unlink()
    assert Path("lane.sqlite").is_file(), (code, said)
    shutil.copy(
        Path(__file__).parents[2] / "files" / "chrono" / "DoubleWishbone.json", "chrono.json"
    )
    shutil.copy(Path(__file__).parents[2] / "files" / "hardpoints" / "strut.txt", "points.csv")
    shutil.copy(Path(__file__).parents[2] / "files" / "mjcf" / "corner.xml", "corner.xml")
    shutil.copy(
        Path(__file__).parents[2]
        / "files"
        / "adams_car"
        / "made_up.cdb"
        / "subsystems.tbl"
        / "front.sub",
        "front.sub",
    )


def said_by(words: list[str]) -> tuple[int, str, str]:
    """Exit code, standard output and standard error of a command."""
    from jounce.cli import main

    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main(words)
    return code, out.getvalue(), err.getvalue()


def verdict(case: tuple[str, str, str]) -> tuple[str, str]:
    """What a command says to a wrong value."""
    with folder_of_files():
        return _verdict(case)


def _verdict(case: tuple[str, str, str]) -> tuple[str, str]:
    before = {entry.name: entry.stat(follow_symlinks=False).st_size for entry in os.scandir()}
    name, place, kind = case
    words = words_of(case)
    code, out, err = said_by(words)
    lost = [
        name
        for name, size in before.items()
        if not os.path.lexists(name) or Path(name).lstat().st_size != size
    ]
    told = f"{code}: {err}"
    if code == 2:
        value = VALUES.get(kind, "")
        key = value.partition("=")[0][:20] + (":" if "=" in value else "")
        places = [
            place,
            place.strip("-").replace("-", "_"),
            name,
            key or "''",
            visible(value)[:10],
            "--json",
        ]
        places += ["an argument with a NUL character"] if kind == "a NUL" else []
        places += [
            "/proc/",
            "none.toml",
            repr(value.partition("=")[0]),
            value.partition("=")[2][:10] or "--json",
        ]
        places += (
            ["jounce: .:", "no such file, and no", *words[-8:]]
            if kind in ("nothing", "no text", "")
            else []
        )
        places += [
            word for word in words if word.startswith("--")
        ]  # two that contradict each other
        is_said = is_clear(err or out, *places)
        return ("refused" if is_said and not lost else "unclear"), told
    if code == 0:
        fits = place in TEXTS or place in OUTPUTS or place in ANY_NUMBER
        return ("accepted" if fits else "silently wrong"), told
    return "crashed", told
