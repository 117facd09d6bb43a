"""What the page may ask to be done by a command: each kind a few named fields, of which its words are made.

Every value stands behind its option with an equals sign, and every path is one inside of the project: whatever a field
holds, it is no other option, and no other command.
"""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from jounce.core.errors import DescriptionError
from jounce.web.project import Project

_LIMITS = (4e9, 120.0)  # bytes and seconds of computing that reading a record may take


@dataclass(frozen=True)
class Doing:
    """A command with what the page shows of it.

    Attributes
    ----------
    title : str
        What it is, for people.
    words : list of str
        The command.
    own : list of str
        Further words, not shown: ``{folder}`` is the folder of the job.
    python : str
        The same in Python.
    out : str
        Folder of the project that it writes into.
    page : str
        File of the project that is its report; without one, ``report.html`` in the folder of the job.
    files : dict
        Files that command and Python need, by name.
    limits : tuple of float, optional
        Bytes and seconds of computing.
    patience : float
        Seconds that somebody waits for it, where somebody does.
    question : dict, optional
        Instead of a command, what no command answers (see `jounce.web.questions`).
    command : str
        Then, the command that comes nearest.
    light : bool
        Whether it loads little: what has loaded everything is then not waited for.
    """

    title: str
    words: list[str]
    own: list[str] = field(default_factory=list)
    python: str = ""
    out: str = ""
    page: str = ""
    files: dict[str, str] = field(default_factory=dict)
    limits: tuple[float, float] | None = None
    patience: float = 120.0
    question: dict[str, Any] | None = None
    command: str = ""
    light: bool = False


class _Task(BaseModel):
    model_config = ConfigDict(extra="forbid")

    def _doing(self, project: Project) -> Doing:
        """Give the command."""
        raise NotImplementedError


Text = Annotated[str, Field(max_length=400)]
Changes = Annotated[dict[str, Any], Field(default_factory=dict, max_length=200)]


class SweepTask(_Task):
    """Simulate the variants of a study into a folder, or go on where that was stopped."""

    kind: Literal["sweep"]
    study: Text
    out: Text
    resume: bool = False
    force: bool = False

    def _doing(self, project: Project) -> Doing:
        study, out = _file(project, self.study), _folder(project, self.out)
        more = ["--resume"] if self.resume else ["--force"] if self.force else []
        said = ", resume=True" if self.resume else ", force=True" if self.force else ""
        python = f"import jounce as jn\n\nresult = jn.run_sweep({study!r}, {out!r}{said})\nprint(result)\n"
        return Doing(f"Sweep {Path(study).stem}", ["sweep", study, f"--out={out}", *more], python=python, out=out,
                     page=f"{out}/report.html")  # fmt: skip


class CampaignTask(_Task):
    """Characterise, update, compare every trial, and write the report."""

    kind: Literal["campaign"]
    campaign: Text
    out: Text
    force: bool = False

    def _doing(self, project: Project) -> Doing:
        file, out = _file(project, self.campaign), _folder(project, self.out)
        python = (
            "import jounce as jn\nfrom jounce.report import write_campaign\n\n"
            f"result = jn.run_campaign({file!r})\n"
            f"write_campaign(result, {out!r}{', force=True' if self.force else ''})\n"
        )
        words = ["campaign", "run", file, f"--out={out}", *(["--force"] if self.force else [])]
        return Doing(f"Campaign {Path(file).parent.name or Path(file).stem}", words, python=python, out=out,
                     page=f"{out}/report.html")  # fmt: skip


class DesignTask(_Task):
    """Find the hardpoints that give wanted kinematic values."""

    kind: Literal["design"]
    study: Text
    out: Text
    starts: Annotated[int, Field(ge=1, le=1000)] | None = None
    force: bool = False

    def _doing(self, project: Project) -> Doing:
        study, out = _file(project, self.study), _folder(project, self.out)
        words = ["design", "kinematics", study, f"--out={out}"]
        words += [] if self.starts is None else [f"--starts={self.starts}"]
        starts = "asked.starts" if self.starts is None else str(self.starts)
        python = (
            "from jounce.design.kinematics import design, run_study\n\n"
            f"found, rigs = run_study({study!r}, lambda asked, task: design(task, {starts}, asked.seed))\n"
            "print(found)\n"
        )
        words += ["--force"] if self.force else []
        return Doing(f"Kinematic design {Path(study).stem}", words, python=python, out=out, page=f"{out}/report.html")


class CompareTask(_Task):
    """Drive a vehicle over a road with several controllers: comfort, travel, road holding, spectra."""

    kind: Literal["compare"]
    vehicle: Text
    road: Text = "iso:C"
    speed: Text = "20 m/s"
    duration: Text = ""
    seed: Annotated[int, Field(ge=0, le=2**31)] = 0
    control: Annotated[list[Text], Field(max_length=40)] = Field(default_factory=lambda: ["passive"])
    changes: Changes

    def _doing(self, project: Project) -> Doing:
        vehicle = _rig(project, self.vehicle)
        words = ["compare", vehicle, f"--road={self.road}", f"--speed={self.speed}"]
        words += [f"--duration={self.duration}"] if self.duration else []
        words += [f"--seed={self.seed}"] if self.seed else []
        words += [f"--control={one}" for one in self.control] + _set(self.changes)
        lasting = f", duration={self.duration!r}" if self.duration else ""
        iso = self.road.lower().startswith("iso:")
        trial = (
            f"iso_trial(rig, {self.road[4:5].upper()!r}, {self.speed!r}, seed={self.seed}{lasting})"
            if iso
            else f"road_trial(rig, jn.load_road({self.road!r}), {self.speed!r}{lasting})"
        )
        python = (
            f"import jounce as jn\nfrom jounce.ride.study import {'iso_trial' if iso else 'road_trial'}\n\n"
            f"rig = jn.load({vehicle!r}){_with(self.changes)}\n"
            f"study = jn.compare_rides(rig, {trial}, {self.control!r})\nprint(study)\n"
        )
        return Doing(f"{Path(vehicle).stem} on {self.road} at {self.speed}", words, _REPORT, python)


class ParetoTask(_Task):
    """Find the best designs between comfort and road holding."""

    kind: Literal["pareto"]
    vehicle: Text
    road: Text = "iso:C"
    speed: Text = "20 m/s"
    free: Annotated[dict[str, Text], Field(min_length=1, max_length=20)]
    comfort: Text = "sprung.az"
    holding: Text = "tyre.force coefficient"
    travel: Text = "strut.deflection"
    limit: Annotated[dict[str, Text], Field(max_length=20)] = Field(default_factory=dict)
    points: Annotated[int, Field(ge=2, le=200)] = 15

    def _doing(self, project: Project) -> Doing:
        vehicle = _rig(project, self.vehicle)
        words = ["design", "pareto", vehicle, *(f"--free={path}={text}" for path, text in self.free.items())]
        words += [f"--road={self.road}", f"--speed={self.speed}", f"--comfort={self.comfort}"]
        words += [f"--holding={self.holding}", f"--travel={self.travel}", f"--points={self.points}"]
        words += [f"--limit={name}={text}" for name, text in self.limit.items()]
        free = {path: _pair(text) for path, text in self.free.items()}
        limits = {name: _pair(text) for name, text in self.limit.items()}
        python = (
            f"import jounce as jn\n\nfront = jn.pareto(\n    jn.load({vehicle!r}), {free!r}, {self.road!r}, "
            f"{self.speed!r},\n    comfort={self.comfort!r}, holding={self.holding!r}, travel={self.travel!r},\n"
            f"    constraints={limits!r}, points={self.points},\n)\nprint(front)\n"
        )
        return Doing(f"Best designs of {Path(vehicle).stem}", words, _REPORT, python)


class EvaluateTask(_Task):
    """Evaluate and grade the records of one or both axles, with the protocol; keep them in a store by wish."""

    kind: Literal["evaluate"]
    records: Annotated[list[Text], Field(min_length=1, max_length=2)]
    tester: Text
    methods: Annotated[list[Text], Field(max_length=8)] = Field(default_factory=list)
    vehicle: Text = ""
    limits: Text = ""
    store: Text = ""
    plate: Text = ""
    date: Text = ""
    place: Text = ""
    inspector: Text = ""
    language: Literal["en", "de"] = "en"

    def _doing(self, project: Project) -> Doing:
        records = [_file(project, one) for one in self.records]
        tester = _shipped_or_file(project, self.tester)
        words = ["inspect", "evaluate", *records, f"--tester={tester}"]
        words += [f"--vehicle={_rig(project, self.vehicle)}"] if self.vehicle else []
        words += [f"--method={one}" for one in self.methods]
        words += [f"--limits={_file(project, self.limits)}"] if self.limits else []
        words += [f"--store={_store(project, self.store)}"] if self.store else []
        for name in ("plate", "date", "place", "inspector"):
            words += [f"--{name}={getattr(self, name)}"] if getattr(self, name) else []
        words += ["--language=de"] if self.language == "de" else []
        methods = f", methods={self.methods!r}" if self.methods else ""
        python = (
            "import jounce as jn\nfrom jounce.parts.testers import load_tester\n\n"
            f"record, findings = jn.read_record({records[0]!r}, load_tester({tester!r}))\n"
            f"graded = jn.grade(jn.evaluate(record{methods}))\nprint(graded)\n"
        )
        title = f"Inspection of {', '.join(Path(one).name for one in records)}"
        return Doing(title, words, _REPORT, python, limits=_LIMITS)


class HistoryTask(_Task):
    """The history of one vehicle in a store, with the change per year."""

    kind: Literal["history"]
    store: Text
    plate: Text

    def _doing(self, project: Project) -> Doing:
        store = _file(project, self.store)
        words = ["inspect", "history", f"--plate={self.plate}", f"--store={store}"]
        python = (
            "from jounce.inspection.archive.history import history_of, trends_of\n"
            "from jounce.inspection.archive.store import Store\n\n"
            f"visits = history_of(Store({store!r}, read_only=True), {self.plate!r})\nprint(trends_of(visits))\n"
        )
        return Doing(f"History of {self.plate}", words, _REPORT, python, patience=60.0)


class SearchTask(_Task):
    """Records of a store by plate, verdict, tester and date."""

    kind: Literal["search"]
    store: Text
    plate: Text = ""
    verdict: Text = ""
    tester: Text = ""
    since: Text = ""
    until: Text = ""

    def _doing(self, project: Project) -> Doing:
        store = _file(project, self.store)
        names = ("plate", "verdict", "tester", "since", "until")
        given = {name: getattr(self, name) for name in names if getattr(self, name)}
        words = ["inspect", "search", f"--store={store}", *(f"--{name}={text}" for name, text in given.items())]
        said = "".join(f", {name}={text!r}" for name, text in given.items())
        python = (
            "from jounce.inspection.archive.store import Store\n\n"
            f"records = Store({store!r}, read_only=True).records({said.removeprefix(', ')})\n"
        )
        return Doing(f"Search in {store}", words, [], python, patience=60.0)


class NewCampaignTask(_Task):
    """Write a commented campaign to start from, with synthetic recordings, that runs as it is."""

    kind: Literal["new-campaign"]
    out: Text

    def _doing(self, project: Project) -> Doing:
        out = _folder(project, self.out)
        python = f"import jounce as jn\n\nfile = jn.new_campaign({out!r})\n"
        return Doing(f"Campaign to start from in {out}", ["campaign", "new", out], python=python, patience=60.0)


class TestTask(_Task):
    """Simulate a test of a shock absorber and write its record, as a tester would."""

    kind: Literal["test"]
    vehicle: Text
    tester: Text
    out: Text
    wear: Text = ""
    wheel: Literal["left", "right", "both"] = "both"

    def _doing(self, project: Project) -> Doing:
        rig, tester, out = (
            _rig(project, self.vehicle),
            _shipped_or_file(project, self.tester),
            _folder(project, self.out),
        )
        words = ["inspect", "simulate", rig, f"--tester={tester}", f"--wheel={self.wheel}", f"--out={out}"]
        words += [f"--wear={self.wear}"] if self.wear else []
        worn = f"worn(jn.load({rig!r}), {self.wear!r})" if self.wear else f"jn.load({rig!r})"
        python = (
            "import jounce as jn\nfrom jounce.parts.testers import load_tester\n"
            + ("from jounce.parts.variants import worn\n" if self.wear else "")
            + f"\ngraded, record = jn.simulate_axle({worn}, load_tester({tester!r}))\n"
        )
        return Doing(f"Test of {Path(rig).stem}", words, python=python)


class _Reading(_Task):
    """How measured files are read: names of their columns, and which way they count."""

    files: Annotated[list[Text], Field(min_length=1, max_length=50)]
    columns: Annotated[dict[str, Text], Field(max_length=100)] = Field(default_factory=dict)
    variable: Text = ""
    stroke_positive: Literal["", "compression", "extension"] = ""
    force_positive: Literal["", "compression", "tension"] = ""

    def _words(self, project: Project, *more: str) -> list[str]:
        words = [_file(project, one) for one in self.files]
        words += [f"--columns={name}={column}" for name, column in self.columns.items()]
        for name in ("variable", "stroke_positive", *more):
            words += [f"--{name.replace('_', '-')}={getattr(self, name)}"] if getattr(self, name) else []
        return words


class StiffnessTask(_Reading):
    """Fit the stiffness of a spring or a tyre: the discarded zone, the line, and its intervals."""

    kind: Literal["stiffness"]
    law: Literal["linear", "polynomial", "power", "monotone-spline"] = "linear"
    discard_below: Text = ""
    intercept: Literal["drop", "shift", "keep"] = "drop"
    branch: Literal["loading", "unloading", "both"] = "loading"

    def _doing(self, project: Project) -> Doing:
        words = self._words(project, "force_positive", "discard_below")
        words += [f"--law={self.law}", f"--intercept={self.intercept}", f"--branch={self.branch}"]
        columns = f", columns={self.columns!r}" if self.columns else ""
        discard = f", discard_below={self.discard_below!r}" if self.discard_below else ""
        python = (
            "import jounce as jn\n\ntrials = [jn.read_columns(file, "
            f'{{"displacement": "m", "force": "N"}}{columns})[0] for file in {self.files!r}]\n'
            f'result = jn.fit_stiffness([(one["displacement"], one["force"]) for one in trials], law={self.law!r},\n'
            f"                          intercept={self.intercept!r}, branch={self.branch!r}{discard})\nprint(result)\n"
        )
        return Doing("Stiffness", ["fit", "stiffness", *words], _REPORT, python, limits=_LIMITS)


class DecayTask(_Reading):
    """Separate viscous damping, dry friction and drag in a free decay; friction bends its envelope."""

    kind: Literal["decay"]
    channel: Text = "sprung.z"
    mass: Text
    sample_time: Text = ""
    begin: Text = ""
    end: Text = ""

    def _doing(self, project: Project) -> Doing:
        words = [*self._words(project, "sample_time"), f"--channel={self.channel}", f"--mass={self.mass}"]
        words += [f"--from={self.begin}"] if self.begin else []
        words += [f"--to={self.end}"] if self.end else []
        columns = f", columns={self.columns!r}" if self.columns else ""
        python = (
            f"import jounce as jn\n\nrecord, findings = jn.read_recording({self.files[0]!r}{columns})\n"
            f'result = jn.fit_decay(record["time"], record[{self.channel!r}], mass={self.mass!r})\nprint(result)\n'
        )
        return Doing("Free decay", ["fit", "decay", *words], _REPORT, python, limits=_LIMITS)


class PreviewTask(_Reading):
    """What would be read of a record with these names, units and signs: a picture, and what the reader found."""

    kind: Literal["preview"]
    form: Literal["recording", "force-deflection"] = "recording"
    sample_time: Text = ""
    resample: Text = ""

    def _doing(self, project: Project) -> Doing:
        words = self._words(project, "sample_time", "resample")
        asked = ("columns", "variable", "sample_time", "resample")
        said = "".join(f", {name}={getattr(self, name)!r}" for name in asked if getattr(self, name))
        if self.form == "recording":
            read = f"record, findings = jn.read_recording({self.files[0]!r}{said})\nprint(record, findings)\n"
        else:
            wanted = '{"displacement": "m", "force": "N"}'
            read = f"columns, findings = jn.read_columns({self.files[0]!r}, {wanted}{said})\nprint(columns, findings)\n"
        command = shlex.join(["jounce", "plot", *words, "--figure=record.png"]) if self.form == "recording" else ""
        return Doing(f"Preview of {self.files[0]}", [], python=f"import jounce as jn\n\n{read}", limits=_LIMITS,
                     patience=60.0, question=self.model_dump(), command=command)  # fmt: skip


AnyTask = (
    SweepTask | CampaignTask | DesignTask | CompareTask | ParetoTask | EvaluateTask | HistoryTask | SearchTask
    | NewCampaignTask | TestTask | StiffnessTask | DecayTask | PreviewTask
)  # fmt: skip
Asked = Annotated[AnyTask, Field(discriminator="kind")]
_READ: TypeAdapter[AnyTask] = TypeAdapter(Asked)
_REPORT = ["--report={folder}/report.html"]


def task_of(plain: Mapping[str, Any]) -> AnyTask:
    """Read what was asked from plain data."""
    try:
        return _READ.validate_python(dict(plain))
    except ValidationError as error:
        raise DescriptionError("this says nothing of a job", where="job", found=error.errors()[0]["msg"]) from None


def doing_of(task: AnyTask, project: Project) -> Doing:
    """Give the command that a task means in a project."""
    return task._doing(project)


def _file(project: Project, path: str) -> str:
    file = project.inside(path)
    if not file.is_file():
        raise DescriptionError("no such file", where=path, hint="Choose one of the project.")
    return _plain(path)


def _folder(project: Project, path: str) -> str:
    folder = project.inside(path)
    if folder.is_file():
        raise DescriptionError("a file, not a folder", where=path, hint="Choose another name.")
    return _plain(path)


def _plain(path: str) -> str:
    text = Path(path).as_posix()
    return f"./{text}" if text.startswith("-") else text


def _rig(project: Project, name: str) -> str:
    from jounce.core.errors import unknown
    from jounce.parts.files import library

    if name.endswith(".toml"):
        return _file(project, name)
    if name not in library():
        raise unknown(name, library(), what="rig", where="vehicle")
    return name


def _shipped_or_file(project: Project, name: str) -> str:
    return _file(project, name) if name.endswith(".toml") else name


def _store(project: Project, path: str) -> str:
    project.inside(path)
    if not path.endswith((".sqlite", ".db")):
        raise DescriptionError("not the name of a store", where="store", found=path, allowed="one that ends in .sqlite")
    return _plain(path)


def _set(changes: Mapping[str, float | str]) -> list[str]:
    return [f"--set={path}={value}" for path, value in changes.items()]


def _with(changes: Mapping[str, float | str]) -> str:
    return f".with_changes({dict(changes)!r})" if changes else ""


def _pair(text: str) -> str | tuple[str, str]:
    """Both ends of ``LOW..HIGH UNIT``, each with the unit, as the command reads them."""
    first, dots, last = (part.strip() for part in text.partition(".."))
    if not dots:
        return text
    _, space, unit = last.partition(" ")
    is_bare = not first.strip("0123456789.eE+-")
    return (f"{first} {unit}" if is_bare and space else first), last
