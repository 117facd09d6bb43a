"""Tasks that the page may run as commands: each kind has named fields from which the command is built.

Every value is joined to its option by an equals sign, and every path is inside the project. A field therefore cannot
inject another option or command.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError
from jounce.operations.index import operations
from jounce.operations.request import Request
from jounce.web.answers import arguments, rig_of
from jounce.web.campaigns import title_of
from jounce.web.project import Project

_SIGNS = "from jounce.identify.signs import compression_positive\n"
_WANTED = '{"displacement": "m", "force": "N"}'
LIMITS = (4e9, 120.0)  # limits for reading a record: bytes and seconds of CPU time


@dataclass(frozen=True)
class JobSpec:
    """The command of a job, and how the page presents it.

    Attributes
    ----------
    title : str
        Title shown to the user.
    words : list of str
        Words of the command.
    hidden : list of str
        Further words that are not shown; ``{folder}`` is the folder of the job.
    python : str
        Equivalent Python code.
    out : str
        Output folder in the project.
    page : str
        Report file in the project; by default ``report.html`` in the folder of the job.
    files : dict
        Files required by command and Python code, by name.
    limits : tuple of float, optional
        Limits: bytes and seconds of CPU time.
    patience : float
        Seconds that the page waits for the result, if it waits.
    question : dict, optional
        Request without an equivalent command, used instead of one (see `jounce.web.questions`).
    command : str
        Closest equivalent command in that case.
    light : bool
        Whether it imports little, so that the preloaded standby process is not needed.
    """

    title: str
    words: list[str]
    hidden: list[str] = field(default_factory=list)
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

    def _spec(self, project: Project) -> JobSpec:
        """Return the command."""
        raise NotImplementedError


Text = Annotated[str, Field(max_length=400)]
Changes = Annotated[dict[str, Any], Field(default_factory=dict, max_length=200)]


class SweepTask(_Task):
    """Simulate the variants of a study into a folder, or resume an interrupted sweep."""

    kind: Literal["sweep"]
    study: Text
    out: Text
    resume: bool = False
    force: bool = False

    def _spec(self, project: Project) -> JobSpec:
        study, out = _file(project, self.study), _folder(project, self.out)
        given = {
            "study": study,
            "out": out,
            "resume": self.resume,
            "force": self.force and not self.resume,
        }
        request = _request("sweep", given)
        return JobSpec(f"Sweep {Path(study).stem}", request.words(), python=request.python(), out=out,
                     page=f"{out}/report.html")  # fmt: skip


class CampaignTask(_Task):
    """Characterise, update, compare every trial, and write the report."""

    kind: Literal["campaign"]
    campaign: Text
    out: Text
    force: bool = False

    def _spec(self, project: Project) -> JobSpec:
        file, out = _file(project, self.campaign), _folder(project, self.out)
        request = _request("campaign run", {"campaign": file, "out": out, "force": self.force})
        return JobSpec(f"Campaign: {title_of(project, file)}", request.words(), python=request.python(), out=out,
                     page=f"{out}/report.html")  # fmt: skip


class DesignTask(_Task):
    """Find hardpoints that meet kinematic targets."""

    kind: Literal["design"]
    study: Text
    out: Text
    starts: Annotated[int, Field(ge=1, le=1000)] | None = None
    force: bool = False

    def _spec(self, project: Project) -> JobSpec:
        study, out = _file(project, self.study), _folder(project, self.out)
        request = _request("design kinematics", {"study": study, "starts": self.starts})
        words = [*request.words(), f"--out={out}", *(["--force"] if self.force else [])]
        forced = ", force=True" if self.force else ""
        python = f"{request.python()}jn.write_files({out!r}, result.files(){forced})\n"
        return JobSpec(
            f"Kinematic design {Path(study).stem}",
            words,
            python=python,
            out=out,
            page=f"{out}/report.html",
        )


class _Drive(BaseModel):
    """A ride of a vehicle, optionally changed, over a road."""

    model_config = ConfigDict(extra="forbid")

    vehicle: Text
    road: Text = "iso:C"
    speed: Text = "20 m/s"
    duration: Text = ""
    seed: Annotated[int, Field(ge=0, le=2**31)] = 0
    changes: Changes

    @property
    def _lasting(self) -> str:
        """Return the duration of the ride, which for a finite road follows from its length."""
        from jounce.roads.loading import is_class
        from jounce.web.rides import ISO_DURATION

        return self.duration or (ISO_DURATION if is_class(self.road) else "")

    def _request(self, project: Project, command: str, control: list[str]) -> Request:
        """Return the request of one or several rides."""
        given = self.model_dump(include={"road", "speed", "seed"}) | {
            "control": control,
            "duration": self._lasting,
        }
        return _request(
            command, {**given, "vehicle": _rig(project, self.vehicle), "set": self.changes}
        )


class CompareTask(_Task, _Drive):
    """Drive a vehicle over a road with several controllers: comfort, travel, road holding, spectra."""

    kind: Literal["compare"]
    control: Annotated[list[Text], Field(max_length=40)] = Field(
        default_factory=lambda: ["passive"]
    )

    def _spec(self, project: Project) -> JobSpec:
        request = self._request(project, "compare", self.control)
        title = f"{Path(self.vehicle).stem} on {self.road} at {self.speed}"
        return JobSpec(title, request.words(), _REPORT, request.python())


class OneRide(_Drive):
    """A ride with one controller."""

    control: Text = "passive"


class OverlayTask(_Task):
    """Overlay rides of several vehicles, controllers and roads: over time, and as spectra."""

    kind: Literal["overlay"]
    rides: Annotated[list[OneRide], Field(min_length=1, max_length=6)]

    def _spec(self, project: Project) -> JobSpec:
        from jounce.web.rides import labels

        names = labels([ride.model_dump() for ride in self.rides])
        python, commands = "import jounce as jn\n\nrides = {}\n", []
        for k, (ride, name) in enumerate(zip(self.rides, names, strict=True), 1):
            request = ride._request(project, "ride", [ride.control])
            python += f"rides[{name!r}] = {request.expression()}.rides[0]\n"
            commands.append(command_line(["jounce", *request.words(), f"--out=ride-{k}.nc"]))
        python += "runs = {name: ride.evaluated_run for name, ride in rides.items()}\n"
        python += "spectra = {name: ride.spectra() for name, ride in rides.items()}\n"
        if (
            len({type(rig_of(project, ride.vehicle)) for ride in self.rides}) == 1
        ):  # all with channels of the same names
            python += "figure = jn.plots.compare(runs)\n"
            files = [f"ride-{k}.nc" for k in range(1, len(self.rides) + 1)]
            commands.append(command_line(["jounce", "plot", *files, "--figure=rides.png"]))
        return JobSpec(
            "Overlay of rides",
            [],
            python=python,
            question=self.model_dump(),
            command="\n".join(commands),
        )


class ParetoTask(_Task):
    """Find the best designs between comfort and road holding."""

    kind: Literal["pareto"]
    vehicle: Text
    road: Text = ""
    speed: Text = ""
    free: Annotated[dict[str, Text], Field(min_length=1, max_length=20)]
    comfort: Text = ""
    holding: Text = ""
    travel: Text = ""
    limit: Annotated[dict[str, Text], Field(max_length=20)] = Field(default_factory=dict)
    points: Annotated[int, Field(ge=3, le=500)] | None = None

    def _spec(self, project: Project) -> JobSpec:
        vehicle = _rig(project, self.vehicle)
        request = _request(
            "design pareto", {**self.model_dump(exclude={"kind"}), "vehicle": vehicle}
        )
        return JobSpec(
            f"Best designs of {Path(vehicle).stem}", request.words(), _REPORT, request.python()
        )


class EvaluateTask(_Task):
    """Evaluate and grade the records of one axle or two, with protocol and optional storage."""

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

    def _spec(self, project: Project) -> JobSpec:
        given = {
            **self.model_dump(include={"plate", "date", "place", "inspector", "language"}),
            "record": [_file(project, record) for record in self.records],
            "tester": _tester(project, self.tester),
            "method": list(dict.fromkeys(self.methods)),
            "vehicle": self.vehicle and _rig(project, self.vehicle),
            "limits": self.limits and _file(project, self.limits),
            "store": self.store and _store(project, self.store),
        }
        request = _request("inspect evaluate", given)
        title = f"Inspection of {', '.join(Path(record).name for record in self.records)}"
        return JobSpec(title, request.words(), _REPORT, request.python(), limits=LIMITS)


class ProtocolTask(_Task):
    """The protocol of stored records, one of each axle, as they were graded."""

    kind: Literal["protocol"]
    store: Text
    records: Annotated[list[int], Field(min_length=1, max_length=2)]
    language: Literal["en", "de"] = "en"

    def _spec(self, project: Project) -> JobSpec:
        store = _file(project, self.store)
        numbers = [str(number) for number in self.records]
        given = {"record": numbers, "store": store, "language": self.language}
        request = _request("inspect protocol", given)
        title = f"Protocol of record {', '.join(numbers)}"
        return JobSpec(title, request.words(), _REPORT, request.python(), limits=LIMITS)


class HistoryTask(_Task):
    """The history of one vehicle in a store, with the change per year."""

    kind: Literal["history"]
    store: Text
    plate: Text

    def _spec(self, project: Project) -> JobSpec:
        store = _file(project, self.store)
        request = _request("inspect history", {"plate": self.plate, "store": store})
        return JobSpec(
            f"History of {self.plate}", request.words(), _REPORT, request.python(), patience=60.0
        )


class SearchTask(_Task):
    """Records of a store by plate, verdict, tester and date."""

    kind: Literal["search"]
    store: Text
    plate: Text = ""
    verdict: Text = ""
    tester: Text = ""
    since: Text = ""
    until: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        store = _file(project, self.store)
        request = _request("inspect search", {**self.model_dump(exclude={"kind"}), "store": store})
        return JobSpec(f"Search in {store}", request.words(), [], request.python(), patience=60.0)


class NewCampaignTask(_Task):
    """Write a commented template campaign with synthetic recordings, or the campaign of a laboratory's folder."""

    kind: Literal["new-campaign"]
    out: Text
    source: Text = ""
    settings: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        out = _folder(project, self.out)
        source = self.source and _folder(project, self.source)
        settings = self.settings and _file(project, self.settings)
        request = _request("campaign new", {"folder": out, "from": source, "settings": settings})
        title = f"Campaign to start from in {out}"
        return JobSpec(title, request.words(), python=request.python(), patience=60.0)


class TestTask(_Task):
    """Simulate a test of a shock absorber and write its record, as a tester would."""

    kind: Literal["test"]
    vehicle: Text
    tester: Text
    out: Text
    wear: Text = ""
    wheel: Literal["left", "right", "both"] = "both"

    def _spec(self, project: Project) -> JobSpec:
        rig, tester, out = (
            _rig(project, self.vehicle),
            _tester(project, self.tester),
            _folder(project, self.out),
        )
        given = {"rig": rig, "tester": tester, "wheel": self.wheel, "wear": self.wear}
        request = _request("inspect simulate", given)
        words = [*request.words(), f"--out={out}"]
        return JobSpec(f"Test of {Path(rig).stem}", words, python=request.python())


class _Reading(_Task):
    """Reading options of measured files: column names and sign conventions."""

    files: Annotated[list[Text], Field(min_length=1, max_length=50)]
    columns: Annotated[dict[str, Text], Field(max_length=100)] = Field(default_factory=dict)
    variable: Text = ""
    stroke_positive: Literal["", "compression", "extension"] = ""
    force_positive: Literal["", "compression", "tension"] = ""

    def _words(self, project: Project, *more: str) -> list[str]:
        words = [_file(project, file) for file in self.files]
        words += [f"--columns={name}={column}" for name, column in self.columns.items()]
        for name in ("variable", "stroke_positive", *more):
            words += (
                [f"--{name.replace('_', '-')}={getattr(self, name)}"] if getattr(self, name) else []
            )
        return words

    def _request(self, project: Project, command: str, without: set[str], **more: str) -> Request:
        files = [_file(project, file) for file in self.files]
        given = self.model_dump(exclude={"kind", "files", *without})
        return _request(command, {**given, "measured": files, **more})

    def _read(self, *names: str) -> str:
        return arguments({name: getattr(self, name) for name in names if getattr(self, name)}, ", ")


class StiffnessTask(_Reading):
    """Fit the stiffness of a spring or a tyre: the discarded zone, the line, and its intervals."""

    kind: Literal["stiffness"]
    law: Literal["linear", "polynomial", "power", "monotone-spline"] = "linear"
    discard_below: Text = ""
    intercept: Literal["drop", "shift", "keep"] = "drop"
    branch: Literal["loading", "unloading", "both"] = "loading"

    def _spec(self, project: Project) -> JobSpec:
        request = self._request(project, "fit stiffness", set())
        return JobSpec("Stiffness", request.words(), _REPORT, request.python(), limits=LIMITS)


class DecayTask(_Reading):
    """Separate viscous damping, dry friction and drag in a free decay; friction bends its envelope."""

    kind: Literal["decay"]
    channel: Text = "sprung.z"
    mass: Text
    sample_time: Text = ""
    begin: Text = ""
    end: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        others = {"begin", "end", "force_positive"}  # a decay has no force
        section = {"from": self.begin, "to": self.end}
        request = self._request(project, "fit decay", others, **section)
        return JobSpec("Free decay", request.words(), _REPORT, request.python(), limits=LIMITS)


class PreviewTask(_Reading):
    """Preview of a record read with these names, units and signs: a plot, and the reader's findings."""

    kind: Literal["preview"]
    form: Literal["recording", "force-deflection"] = "recording"
    sample_time: Text = ""
    resample: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        words = self._words(project, "sample_time", "resample")
        if self.form == "recording":
            said = self._read("columns", "variable", "sample_time", "resample")
            signs = f"{self.stroke_positive or None!r}, {self.force_positive or None!r}"
            is_turned = bool(self.stroke_positive or self.force_positive)
            turned = f"compression_positive(record, {signs})" if is_turned else "record"
            read = f"record, findings = jn.read_recording({self.files[0]!r}{said})\nprint({turned}, findings)\n"
            read = f"{_SIGNS if is_turned else ''}\n{read}"
        else:
            said = self._read("columns", "variable")
            read = f"\ncolumns, findings = jn.read_columns({self.files[0]!r}, {_WANTED}{said})\n"
            read += "print(columns, findings)\n"
        command = (
            command_line(["jounce", "plot", *words, "--figure=record.png"])
            if self.form == "recording"
            else ""
        )
        return JobSpec(f"Preview of {self.files[0]}", [], python=f"import jounce as jn\n{read}", limits=LIMITS,
                     patience=60.0, question=self.model_dump(), command=command)  # fmt: skip


class PreviewFilesTask(_Task):
    """Kind, small curve and missing information of measured files before they enter a campaign.

    ``columns`` are names and units by file; ``table`` is a table of trials as copied from a spreadsheet.
    """

    kind: Literal["preview-files"]
    files: Annotated[list[Text], Field(min_length=1, max_length=500)]
    columns: Annotated[dict[str, dict[str, Text]], Field(max_length=500)] = Field(
        default_factory=dict
    )
    table: Annotated[str, Field(max_length=200_000)] = ""

    def _spec(self, project: Project) -> JobSpec:
        files = [_file(project, file) for file in self.files]
        given = f", columns={self.columns!r}" if self.columns else ""
        python = f"import jounce as jn\n\nprint(jn.preview_files({files!r}{given}))\n"
        return JobSpec(f"Preview of {len(files)} files", [], python=python, limits=LIMITS,
                     question=self.model_dump())  # fmt: skip


class DamperMapTask(_Task):
    """The map of a damper from the records of a folder: curves of each setting and between clicks, and its page."""

    kind: Literal["damper-map"]
    files: Annotated[list[Text], Field(min_length=1, max_length=500)]
    settings: Text = ""
    reading: Literal["", "peak", "continuous"] = ""
    stroke_positive: Literal["", "compression", "extension"] = ""
    force_positive: Literal["", "compression", "tension"] = ""

    def _spec(self, project: Project) -> JobSpec:
        given = self.model_dump(exclude={"kind", "files"}) | {
            "measured": [_place(project, path) for path in self.files],
            "settings": self.settings and _file(project, self.settings),
        }
        request = _request("damper map", given)
        return JobSpec(
            f"Damper map of {', '.join(self.files[:3])}",
            [],
            python=request.python(),
            limits=LIMITS,
            question=self.model_dump(),
            command=command_line(["jounce", *request.words()]),
        )


class DamperClicksTask(_Task):
    """The clicks with which a damper comes closest to a target: a rig's damper, or damping ratios at the wheel."""

    kind: Literal["damper-clicks"]
    damper_map: Text
    target: Text = ""
    bump: Text = ""
    rebound: Text = ""
    knee: Text = ""
    motion_ratio: Text = ""
    sprung_mass: Text = ""
    wheel_rate: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        given = self.model_dump(exclude={"kind"}) | {
            "damper_map": _place(project, self.damper_map),
            "target": self.target and _file(project, self.target),
        }
        request = _request("damper clicks", given)
        return JobSpec(
            f"Clicks of {self.damper_map}",
            request.words(),
            _REPORT,
            request.python(),
            limits=LIMITS,
        )


class DamperCompareTask(_Task):
    """Two dampers of an axle, force by force, against a tolerance."""

    kind: Literal["damper-compare"]
    first: Text
    second: Text
    tolerance: Text = ""
    tolerance_force: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        given = self.model_dump(exclude={"kind"}) | {
            "first": _place(project, self.first),
            "second": _place(project, self.second),
        }
        request = _request("damper compare", given)
        title = f"Comparison of {self.first} and {self.second}"
        return JobSpec(title, request.words(), _REPORT, request.python(), limits=LIMITS)


class DamperHistogramTask(_Task):
    """Histograms of travel and velocity of dampers from records of the track, beside a run of the model if given."""

    kind: Literal["damper-histogram"]
    records: Annotated[list[Text], Field(min_length=1, max_length=6)]
    beside: Text = ""
    by: Literal["", "laps", "sectors", "whole"] = ""
    low_speed: Text = ""
    stroke: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        given = self.model_dump(exclude={"kind"}) | {
            "records": [_file(project, path) for path in self.records],
            "beside": self.beside and _file(project, self.beside),
        }
        request = _request("damper histogram", given)
        title = f"Histograms of {', '.join(self.records)}"
        return JobSpec(title, request.words(), _REPORT, request.python(), limits=LIMITS)


class DamperSheetTask(_Task):
    """The sheet of a damper, or of a set beside each other."""

    kind: Literal["damper-sheet"]
    maps: Annotated[list[Text], Field(min_length=1, max_length=8)]
    remark: Text = ""

    def _spec(self, project: Project) -> JobSpec:
        maps = [_place(project, path) for path in self.maps]
        request = _request("damper sheet", {"maps": maps, "remark": self.remark})
        title = f"Sheet of {', '.join(self.maps)}"
        return JobSpec(title, request.words(), _REPORT, request.python(), limits=LIMITS)


AnyTask = (
    SweepTask | CampaignTask | DesignTask | CompareTask | OverlayTask | ParetoTask | EvaluateTask | HistoryTask
    | ProtocolTask | SearchTask | NewCampaignTask | TestTask | StiffnessTask | DecayTask | PreviewTask
    | PreviewFilesTask | DamperMapTask | DamperClicksTask | DamperCompareTask | DamperHistogramTask
    | DamperSheetTask
)  # fmt: skip
Asked = Annotated[AnyTask, Field(discriminator="kind")]
_READ: TypeAdapter[AnyTask] = TypeAdapter(Asked)
_REPORT = ["--report={folder}/report.html"]
AS_PDF = ["--report={folder}/report.pdf"]


def task_of(plain: Mapping[str, Any]) -> AnyTask:
    """Parse a task from plain data."""
    try:
        return _READ.validate_python(dict(plain))
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(("job", *(str(part) for part in first["loc"])))
        raise DescriptionError(
            "this does not describe a job", where=place, found=first["msg"]
        ) from None


def spec_of(task: AnyTask, project: Project) -> JobSpec:
    """Return the command of a task in a project."""
    return task._spec(project)


def _request(command: str, given: Mapping[str, Any]) -> Request:
    """Return a request; fields left empty on the page have their defaults.

    A name that is no option would be ignored: it is an error of this file.
    """
    operation = operations()[command]
    unknown = set(given) - {parameter.option for parameter in operation.parameters}
    if unknown:
        raise KeyError(f"{command} has no option {', '.join(sorted(unknown))}")
    return Request(operation, {name: value for name, value in given.items() if value != ""})


def _file(project: Project, path: str) -> str:
    file = project.inside(path)
    if not file.is_file():
        raise DescriptionError("no such file", where=path, hint="Choose a file of the project.")
    return _plain(path)


def _folder(project: Project, path: str) -> str:
    folder = project.inside(path)
    if folder.is_file():
        raise DescriptionError("a file, not a folder", where=path, hint="Choose another name.")
    return _plain(path)


def _place(project: Project, path: str) -> str:
    """Return a file or folder of the project; the project itself is ``.``."""
    if path == ".":
        return path
    return _plain(path) if project.inside(path).is_dir() else _file(project, path)


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


def _tester(project: Project, name: str) -> str:
    from jounce.core.errors import unknown
    from jounce.parts.testers import library

    if name.endswith(".toml"):
        return _file(project, name)
    if name not in library():
        raise unknown(name, library(), what="tester", where="tester")
    return name


def _store(project: Project, path: str) -> str:
    project.inside(path)
    if not path.endswith((".sqlite", ".db")):
        raise DescriptionError(
            "invalid name of a record store",
            where="store",
            found=path,
            allowed="a name ending in .sqlite",
        )
    return _plain(path)
