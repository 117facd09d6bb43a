"""Everything that writes: the outputs of commands, what commands keep, and what pages of the workbench ask."""

from __future__ import annotations

import contextlib
import os
import shutil
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

from corpus.descriptions import _SWEEP
from corpus.outputs import LONG, folder_for, targets, words

from faults.run import Writer

OLD = "mine"
SWEEPS = ("kinematics", "clearances", "steering-effort")
OWN = (*SWEEPS, "export", "inspect evaluate", "animate")
"""Commands whose files are written by other code than files of that name of other commands."""


def writers() -> Iterator[Writer]:
    """Give all of them; of outputs that are written by the same code one."""
    tried = set()
    for name, option, suffix in targets():
        own = name if not suffix or option == "--store" or name.startswith(OWN) else ""
        way = ("sweeps" if name in SWEEPS else own, option, suffix)
        if name not in LONG and way not in tried:
            tried.add(way)
            yield _output(name, option, suffix)
    yield Writer(
        "simulate --out .nc, a new file",
        partial(command, *RUN, "--out", "new.nc"),
        partial(files, "simulate"),
    )
    study = Path("sweep.toml")
    yield Writer(
        "sweep",
        partial(command, "sweep", "sweep.toml", "--out", "swept", "--workers", "1"),
        lambda: study.write_text(_SWEEP, encoding="utf-8"),
        between=(_not_yet(),),
        parts=True,
        again=_resumed,
    )
    yield Writer(
        "report in a folder",
        partial(_page, "another"),
        partial(_page, "old"),
        between=(_not_yet(),),
    )
    results = frozenset(
        {"out/results.json", "out/rig-damping.toml"}
    )  # beside a page that is not drawn yet
    yield Writer(
        "campaign run --table xlsx", _campaign, _old_campaign, between=(_not_yet(),), first=results
    )
    yield Writer(
        "inspect import, another record", _imported("lane.csv"), partial(_lane, ("plate.csv",))
    )
    yield Writer("inspect watch", _watched, partial(_lane, ()))
    again = partial(
        command,
        "inspect",
        "reevaluate",
        "--store",
        "lane.sqlite",
        "--limits",
        "own.toml",
        "--workers",
        "1",
    )
    yield Writer(
        "inspect reevaluate",
        again,
        partial(_lane, ("lane.csv",), limits=True),
        again=lambda: again() and 0,
    )
    yield Writer("compiled code", _compiled, optional=True)
    yield from _pages()


def command(*asked: str) -> int:
    from jounce.cli import main

    return main(list(asked))


LANE = ("--store", "lane.sqlite")
RUN = ("simulate", "kart-quarter-car", "--excitation", "base.csv", "--duration", "0.05 s")


def files(name: str) -> None:
    """The files that a command takes, made once."""
    made = Path(os.environ["JOUNCE_FAULTS"]) / name.replace(" ", "-")
    if not made.exists():
        made.parent.mkdir(exist_ok=True)
        with contextlib.chdir(made.parent), folder_for(name):
            shutil.copytree(".", made, symlinks=True)
        for unused in (
            "loop",
            "rubbish.bin",
            *(() if name.startswith("inspect") else ("lane.sqlite",)),
        ):
            (made / unused).unlink()
    shutil.copytree(made, ".", symlinks=True, dirs_exist_ok=True)


def _output(name: str, option: str, suffix: str) -> Writer:
    target, is_store = Path(f"x{suffix}"), option == "--store"
    asked = words(
        (name, option, suffix, "there already" if is_store else "there already, --force"),
        str(target),
    )

    def prepare() -> None:
        files(name)
        if suffix and not is_store:
            target.write_text(OLD)
        elif not is_store:
            target.mkdir()
            (target / "campaign.toml").write_text(OLD)

    row = " ".join(filter(None, (name, option, suffix)))
    return Writer(row, partial(command, *asked), prepare, parts=bool(suffix))


def _resumed() -> int:
    again = ("--resume",) if Path("swept").exists() else ()
    return command("sweep", "sweep.toml", "--out", "swept", "--workers", "1", *again)


def _not_yet() -> bytes:
    from jounce.report import render

    return render._NOT_YET.encode()


def _page(title: str) -> None:
    from jounce.plots.figures import new_figure
    from jounce.report import Page, Picture, Section, write_page

    def page() -> Page:
        figure = new_figure(1.2)
        figure.subplots().plot([0.0, 1.0], [0.0, len(title)])
        return Page(title, (Section("Line", (Picture(figure, "line", "A line.", "A line."),)),))

    content: dict[str, str | bytes] = {f"{k}.json": title * 1000 * k for k in range(5)}
    write_page(page, "out", files=content, force=True)


def _old_campaign() -> None:
    from jounce.campaign import new_campaign, run

    if not _RESULT:  # what is computed changes no disk: once for all
        file = new_campaign("made")
        text = file.read_text(encoding="utf-8").split("[[trial]]")
        file.write_text("[[trial]]".join(text[:2]) + UPDATE, encoding="utf-8")
        _RESULT.append(run.run_campaign(file))
        shutil.rmtree("made")
    Path("campaign.toml").touch()
    Path("out").mkdir()
    Path("out", "notes.txt").write_text(OLD)


_RESULT: list[Any] = []
UPDATE = """
[[update]]
name = "damping"
free = {"strut.damper.coefficient" = "50 %"}
method = "least-squares"
trials = [1]
"""


def _campaign() -> int:
    import jounce.campaign

    jounce.campaign.run_campaign = lambda *_, **__: _RESULT[0]
    return command("campaign", "run", "campaign.toml", "--out", "out", "--force", "--table", "xlsx")


def _lane(stored: tuple[str, ...], *, limits: bool = False) -> None:
    files("inspect import")
    Path("lane.sqlite").unlink()
    for left in Path().glob("lane.sqlite-*"):
        left.unlink()
    Path("plate.csv").write_text('# plate_number = "B-AB 123"\n' + Path("lane.csv").read_text())
    for name in stored:
        assert _imported(name)() in (0, 2)
    if limits:
        from jounce.inspection import limits as shipped

        text = Path(shipped.__file__).with_name("limits.toml")
        Path("own.toml").write_text(next(iter(text.parent.rglob("*.toml"))).read_text())


def _imported(name: str) -> Callable[[], int]:
    return partial(command, "inspect", "import", name, *LANE, "--tester", "eusama")


def _watched() -> int:
    words = (
        "inspect",
        "watch",
        ".",
        "--store",
        "../work/lane.sqlite",
        "--tester",
        "eusama",
        "--once",
        "--settle",
        "0 s",
    )
    return command(*words)


def _compiled() -> None:
    import casadi as ca

    from jounce.kernel.native import compile_functions

    os.environ["JOUNCE_CACHE_DIR"] = str(Path("cache").absolute())
    x, u, p, m = (ca.SX.sym(name, 1) for name in "xupm")
    for factor in (2.0, 3.0):
        compile_functions({"f": ca.Function("f", [x, u, p, m], [factor * x + u])})


def _pages() -> Iterator[Writer]:
    """What pages of the workbench ask, as the server does it."""
    from jounce.web.kept import history, keep
    from jounce.web.project import Project
    from jounce.web.studies import write_study

    road = {"kind": "half-sine", "height": "10 mm", "length": "60 mm"}
    trial = {"speed": "2 m/s", "duration": "0.1 s", "road": road}
    study = {"trial": trial, "rig": "rig.toml", "metrics": ["rms sprung.az"], "design": {"kind": "sobol", "count": 4},
             "vary": {"strut.spring.rate": "20 %"}}  # fmt: skip

    def rig(text: str = "kart-quarter-car") -> None:
        import jounce as jn

        jn.save(jn.load(text), "rig.toml", force=True)

    def saved() -> None:
        project = Project(".")
        was, mark = project.read("rig.toml"), "# changed\n"
        if not was.text.endswith(mark):
            project.write("rig.toml", was.text + mark, was.digest)

    def told(work: Callable[[], object]) -> Callable[[], int]:
        def do() -> int:
            try:
                work()
            except OSError as error:  # an answer of the server
                print(f"jounce: {error}")
                return 2
            return 0

        return do

    def kept() -> None:
        keep(Project("."), "rig.toml", {}, trial, "mine")
        assert [one["path"] for one in history(Project("."))] == ["runs/mine.nc"]

    yield Writer("workbench: save a rig", told(saved), rig, parts=True)
    yield Writer("workbench: keep a run", told(kept), rig, parts=True)
    yield Writer(
        "workbench: write a study", told(partial(_study, write_study, Project, study)), rig
    )


def _study(
    write_study: Callable[..., Any], project: Callable[..., Any], study: dict[str, Any]
) -> None:
    write_study(project("."), "study.toml", study)
