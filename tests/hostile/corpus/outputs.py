"""Every file and folder that a command writes, in a place where it cannot be written, or one that is odd but right."""

from __future__ import annotations

import contextlib
import resource
import shlex
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from corpus.commands import OUTPUTS, SLOW, commands, folder_of_files, said_by, words_of
from corpus.descriptions import _DESIGN, _SWEEP
from corpus.judging import is_clear

READ = (
    "serve",
    "inspect reevaluate",
    "inspect history",
    "inspect protocol",
    "inspect search",
    "inspect export",
    "inspect verify",
    "inspect watch",
)
"""Commands whose store is there already, or whose folder is looked into."""
NO_OUTPUTS = [
    (name, option) for name in ("demo", "campaign run") for option in ("--report", "--figure")
]
"""Options that choose among what is written into the folder."""
LONG = (
    *SLOW,
    "kc",
    "load-cases",
    "campaign run",
    "campaign posterior",
    "design kinematics",
    "design optimise",
    "design pareto",
    "campaign synthesise",
    "compare",
    "ride",
    "speed-limit",
    "sweep",
    "design kinematic-front",
    "fit hardpoints",
)
"""Commands that compute for long: only places that are refused before they begin."""
USES = {
    "design kinematics": "design kinematics study.toml --out designed",
    "design kinematic-front": "design kinematic-front study.toml --points 2 --out front",
    "campaign run": "campaign run c/campaign.toml --out r",
    "campaign posterior": "campaign posterior c/campaign.toml --out drawn",
    "campaign models": "campaign models c/campaign.toml",
    "sweep": "sweep sweep.toml --out swept",
    "fit stiffness --out": "fit stiffness spring.csv --rig kart-quarter-car",
    "spring map --out": "spring map spring.csv --rig kart-quarter-car",
}
"""Right uses that need a file or a rig of their own, some of them for one option."""

REFUSED = (
    "there already",
    "a folder or file there",
    "no folder",
    "inside a file",
    "a name of 300 bytes",
)
"""Places that are refused before anything is computed."""
PLACES = (
    *REFUSED,
    "a system that refuses",
    "a full disk",
    "there already, --force",
    "a folder or file there, --force",
    "a link to nothing",
    "a link to a file, --force",
    "a name of 255 bytes",
    "right to left",
    "emoji, quotes, blanks and markup",
    "two lines",
    "a hyphen first",
)


def targets() -> Iterator[tuple[str, str, str]]:
    """Command, option or argument, and suffix of all that is written; the suffix of folders is empty."""
    for name, command in commands().items():
        for parameter in command.params:
            option = (
                parameter.opts[0]
                if parameter.param_type_name == "option"
                else parameter.name.upper()
            )
            is_read = name in READ and option in ("--store", "FOLDER")
            if option not in OUTPUTS or is_read or (name, option) in NO_OUTPUTS:
                continue
            for suffix in suffixes(name, option):
                yield name, option, suffix


def suffixes(name: str, option: str) -> tuple[str, ...]:
    """Suffixes that an output may have, from the tables of formats."""
    from jounce.exchange.equations import EQUATION_FORMATS
    from jounce.exchange.points import POINT_FORMATS
    from jounce.exchange.roads import ROAD_FORMATS
    from jounce.inspection.archive.exporting import TABLES
    from jounce.kinematics.sweeps import SWEEP_FILES
    from jounce.plots.figures import FIGURES
    from jounce.recordings.writers import RECORDING_FILES
    from jounce.report.protocol import PROTOCOLS
    from jounce.report.render import REPORTS

    special = {
        ("animate", "--figure"): (".gif",),  # .mp4 needs another program
        ("animate", "--report"): (".html",),
        **dict.fromkeys(
            (("inspect evaluate", "--report"), ("inspect protocol", "--report")),
            tuple(PROTOCOLS.writers),
        ),
        ("inspect export", "--out"): tuple(TABLES.writers),
        **dict.fromkeys(
            ((one, "--out") for one in ("kinematics", "clearances", "steering-effort")),
            (*SWEEP_FILES.writers,),
        ),
        ("export fmu", "--out"): (".fmu",),
        ("export equations", "--out"): tuple(EQUATION_FORMATS.writers),
        ("export hardpoints", "--out"): tuple(POINT_FORMATS.writers),
        ("export chrono", "--out"): (".json",),
        ("export mjcf", "--out"): (".xml",),
        ("export road", "--out"): tuple(ROAD_FORMATS.writers),
        **dict.fromkeys(
            (
                (one, "--out")
                for one in ("simulate", "ride", "inspect simulate", "analyse integrate")
            ),
            (*RECORDING_FILES.writers,),
        ),
        **dict.fromkeys(
            (
                (one, "--out")
                for one in (
                    "adjust",
                    "import adams",
                    "import chrono",
                    "import hardpoints",
                    "import mjcf",
                    "fit hardpoints",
                    "fit stiffness",
                    "spring map",
                    "design springs",
                    "design optimise",
                )
            ),
            (".toml",),
        ),
        **dict.fromkeys(
            ((one, "--out") for one in ("modes", "iri", "study lumped-vs-spatial")),
            (".csv", ".json"),
        ),
        **dict.fromkeys(
            (
                (f"analyse {one}", "--out")
                for one in ("statistics", "spectrum", "transfer", "modes")
            ),
            (".csv", ".json"),
        ),
        **dict.fromkeys(((one, "--figure") for one in ("kinematics", "load-cases")), ("",)),
        ("load-cases", "--out"): (".csv",),
        ("damper map", "--out"): (".csv",),
        ("speed-limit", "--out"): (".csv",),
        ("damper histogram", "--out"): (".csv",),
        **dict.fromkeys(
            ((one, "--out") for one in ("damper sheet", "damper compare")), (".csv", ".xlsx")
        ),
        ("damper clicks", "--out"): (".toml",),
    }
    usual = {
        "--figure": tuple(FIGURES.writers),
        "--report": tuple(REPORTS.writers),
        "--store": (".sqlite",),
    }
    return special.get((name, option), usual.get(option, ("",)))


def cases() -> list[tuple[str, str, str, str]]:
    """Command, option, suffix and kind of place."""
    return [
        (*target, place)
        for target in targets()
        for place in (REFUSED if target[0] in LONG else PLACES)
        if not (target[2] == "" and place == "no folder")  # folders are made
    ]


def words(case: tuple[str, str, str, str], name: str) -> list[str]:
    """The command line of a case that writes to this name."""
    command, option, _, place = case
    use = USES.get(f"{command} {option}", USES.get(command))
    base = None if use is None else shlex.split(use)
    plain = [word for word in words_of((command, option, "a word"), base) if word != "--force"]
    found = [word.replace("nonsense", name) for word in plain]
    if option == "FOLDER" and name.startswith("-"):
        at = found.index(name)
        found = [*found[:at], *found[at + 1 :], "--", name]
    return [
        *found[: len(command.split())],
        *(["--force"] if "--force" in place else []),
        *found[len(command.split()) :],
    ]


@cache
def _at(place: str, suffix: str) -> str:
    """Name of the output in a place."""
    names = {
        "no folder": f"no/such/x{suffix}",
        "inside a file": f"base.csv/x{suffix}",
        "a name of 300 bytes": "x" * (300 - len(suffix)) + suffix,
        "a name of 255 bytes": "ä" * ((255 - len(suffix)) // 2)
        + "x" * ((255 - len(suffix)) % 2)
        + suffix,
        "a system that refuses": f"/proc/x{suffix}",
        "right to left": f"\u202eעגלה\u202c{suffix}",
        "emoji, quotes, blanks and markup": f"🚗 'a' \"b\" $x^$ <b>&%{suffix}",
        "two lines": f"a\nb{suffix}",
        "a hyphen first": f"-x{suffix}",
    }
    return names.get(place, f"x{suffix}")


@contextlib.contextmanager
def folder_for(command: str) -> Iterator[None]:
    """Stand in a new folder with what the right use of a command needs."""
    from jounce.campaign import new_campaign

    with folder_of_files():
        Path("study.toml").write_text(_DESIGN, encoding="utf-8")
        Path("sweep.toml").write_text(_SWEEP, encoding="utf-8")
        if command in ("campaign run", "campaign posterior", "campaign models"):
            new_campaign("c")
        yield


@contextlib.contextmanager
def _in_place(place: str, name: str, *, is_folder: bool) -> Iterator[None]:
    """Make the place what its name says, while the command runs."""
    limits, leaves_no_bytecode = resource.getrlimit(resource.RLIMIT_FSIZE), sys.dont_write_bytecode
    mine = Path("mine.txt")
    mine.write_text("mine", encoding="utf-8")
    if place.startswith("there already"):
        (Path(name) / "mine.txt" if is_folder else Path(name)).parent.mkdir(exist_ok=True)
        (Path(name) / "campaign.toml" if is_folder else Path(name)).write_text(
            "mine", encoding="utf-8"
        )
    elif place.startswith("a folder or file there"):
        Path(name).write_text("mine", encoding="utf-8") if is_folder else Path(name).mkdir()
    elif place.startswith("a link"):
        Path(name).symlink_to(mine if "to a file" in place else "nothing")
    elif place == "a full disk":
        sys.dont_write_bytecode = (
            True  # of what is imported meanwhile: it would be cut at the limit
        )
        resource.setrlimit(resource.RLIMIT_FSIZE, (200, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        sys.dont_write_bytecode = leaves_no_bytecode


def _listing() -> dict[str, bytes]:
    return {
        str(file): file.read_bytes()
        if file.is_file()
        else b"a link"
        if file.is_symlink()
        else b"a folder"
        for file in sorted(Path().rglob("*"))
    }


def verdict(case: tuple[str, str, str, str]) -> tuple[str, str]:
    """What a command does where its output cannot be written, or has an odd name."""
    sys.dont_write_bytecode = True  # half a module would be kept where the disk is full
    command, option, suffix, place = case
    name, is_folder = _at(place, suffix), not suffix
    with folder_for(command), _in_place(place, name, is_folder=is_folder):
        before = _listing()
        code, out, err = said_by(words(case, name))
        after = _listing()
    told = f"{code}: {err} {out if code == 1 else ''}"
    if code not in (0, 1, 2) or "internal error" in err:
        return "crashed", told
    asked = [one for word in words(case, name) for one in (word, word.partition("=")[2]) if one]
    owned = {
        *asked,
        name,
        str(Path(name).with_suffix(".json")),
        "lane.sqlite",
    }  # values stand beside a protocol
    owned |= {
        f"{one}{end}" for one in owned for end in ("-wal", "-shm")
    }  # SQLite's own, while the store is open
    if place.startswith("a link to nothing") and is_folder:
        owned.add("nothing")  # which is made where the link leads to
    lost = [file for file, content in before.items() if after.get(file) != content]
    more = sorted({*after} - {*before})
    foreign = [
        file
        for file in (*lost, *more)
        if not any(file == one or file.startswith(f"{one}/") for one in owned)
    ]
    told = f"{told}; changed {lost}, new {more}"
    if foreign or any(Path(file).name.startswith(".") for file in after):
        return "silently wrong", told
    if code == 2:
        is_said = is_clear(
            err, name[:20], name.partition("/")[0], option, "--force", *owned, tempfile.gettempdir()
        )
        return ("refused" if is_said and not lost else "unclear"), told
    own = [
        file
        for file in (*lost, *more)
        if file in owned or file.startswith((f"{name}/", "nothing/"))
    ]
    if code == 1:  # what was computed is there, and a finding says what is not
        said = "".join((err + out).split())  # which the console breaks into lines
        return (
            "flagged"
            if is_clear(said, "".join(name[:20].split())) and place not in REFUSED
            else "unclear"
        ), told
    return ("right" if own and place not in REFUSED else "silently wrong"), told
