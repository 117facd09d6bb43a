"""HTTP interface of the page: one function per request, each calling the functions used by scripts and commands."""

from __future__ import annotations

import json
import os
import threading
import tomllib
from collections.abc import Callable
from functools import lru_cache, partial
from importlib import metadata
from pathlib import Path
from typing import Annotated, Any, Literal
from urllib.parse import urlencode

from pydantic import BaseModel, ConfigDict, Field

from jounce.core.errors import JounceError, OutputError, unforeseen
from jounce.core.findings import with_german
from jounce.core.optional import require
from jounce.core.phrases import german_of
from jounce.core.serialise import to_plain
from jounce.core.units import Unit
from jounce.web import answers, comparing, forms, laboratory, sweeps
from jounce.web import kept as history
from jounce.web.assets import Asset, assets
from jounce.web.bodies import Route
from jounce.web.data_page import data_routes
from jounce.web.exports import APART, DOCUMENT, KINDS, Exported, exported, file_name
from jounce.web.jobs import Jobs, without_options
from jounce.web.project import (
    LONGEST,
    Entry,
    Project,
    Text,
    Version,
    has_axle,
    has_hardpoints,
    is_dependent,
    unusable,
)
from jounce.web.records import Records
from jounce.web.safety import EXPORT, Guard, seal_address
from jounce.web.tasks import JobSpec
from jounce.web.working import routes

require("fastapi", "web")  # ruff: isort: split
from fastapi import Depends, FastAPI, Request  # noqa: E402
from fastapi.responses import JSONResponse, Response  # noqa: E402


class _Refusal(JSONResponse):
    """Response that preserves file names and values, even if they are not valid UTF-8."""

    def render(self, content: Any) -> bytes:
        return json.dumps(content).encode()


class _Answer(JSONResponse):
    """Add the German sentence to each finding."""

    def render(self, content: Any) -> bytes:
        return super().render(with_german(content))


class _Asked(BaseModel):
    model_config = ConfigDict(extra="forbid")


class Saved(_Asked):
    """A description to write; ``was`` is the digest of the replaced content, empty for a new file."""

    path: str
    text: str
    was: str = ""


class Started(_Asked):
    """A copy of a shipped file under a new name."""

    name: str
    path: str


class Edited(_Asked):
    """A text of the project with values set (as typed, by key) or changed (SI or with units, by path)."""

    path: str
    text: str = Field(max_length=LONGEST)
    sets: list[tuple[list[str | int], Any]] = Field(default_factory=list, max_length=200)
    changes: dict[str, Any] = Field(default_factory=dict, max_length=200)


class RecordPart(_Asked):
    """Part of a record, in the unit of its time (the whole record by default), in a number of columns."""

    path: str
    channels: list[str] = Field(min_length=1, max_length=20)
    low: Annotated[float, Unit("s")] | None = None
    high: Annotated[float, Unit("s")] | None = None
    columns: int = Field(default=1000, ge=10, le=8000)


class Changed(_Asked):
    """A rig (path in the project, or name in the library) with changed numbers (SI or with units, by path).

    ``text`` is the unsaved content of its file, if any.
    """

    rig: str
    text: str | None = Field(default=None, max_length=LONGEST)
    changes: dict[str, Any] = Field(default_factory=dict, max_length=200)
    channels: list[str] = Field(default_factory=list, max_length=60)


class PastedTable(Changed):
    """A table of hardpoints as copied from a spreadsheet, and what it does not state."""

    table: str = Field(max_length=200_000)
    unit: str = ""
    axes: str = ""
    side: Literal["left", "right"] = "left"
    axle: Literal["", "front", "rear"] = ""
    names: dict[str, str] = Field(default_factory=dict, max_length=200)


class PastedForce(_Asked):
    """A table of a force over deflection or velocity copied from a spreadsheet, and the present values as written."""

    table: str = Field(max_length=200_000)
    over: Literal["deflection", "velocity"]
    over_unit: str = ""
    force_unit: str = ""
    turned: Literal["", "over", "force", "both"] = ""
    before: tuple[list[Any], list[Any]] = ([], [])


class RunRequest(Changed):
    """A run over an obstacle: the table of a road file, a speed and a duration with their units.

    With ``numbers``, the response contains curves of these channels and the initially shown ones, otherwise of all.
    """

    road: dict[str, Any]
    speed: str
    duration: str
    numbers: list[str] | None = Field(default=None, max_length=400)
    measured: str = ""
    begins: str = ""
    against: answers.Others = Field(default_factory=list)
    spectra: bool = False


class Keep(RunRequest):
    """A run to be written into the project under a title; ``digest`` identifies the rig that was displayed."""

    title: str
    digest: str = ""


class OverlayRequest(_Asked):
    """Recordings of the project to be overlaid."""

    paths: list[str] = Field(min_length=1, max_length=answers.MOST)
    channels: list[str] = Field(default_factory=list, max_length=60)


class CompareRequest(_Asked):
    """Rigs, vehicles, campaigns or saved runs whose differences are listed."""

    names: list[str] = Field(min_length=2, max_length=20)


class SweepRequest(Changed):
    """A sweep over wheel travel, rack or roll: a range first:last:step for one, single values for others; with units.

    ``against`` are rigs for comparison; ``targets`` have the keys of a study, ``study`` is a study file.
    """

    travel: str = ""
    over: Literal["travel", "rack", "roll"] = "travel"
    rack: str = ""
    roll: str = ""
    against: answers.Others = Field(default_factory=list)
    targets: list[dict[str, Any]] = Field(default_factory=list, max_length=60)
    study: str = ""


_SOON = 3.0  # s: the first page does not wait for the process that works for the page


class LaboratoryRequest(Changed):
    """Tests on the K&C rig: the open ``test``, and with ``overview`` as many others as are fast enough.

    ``to`` and ``within`` are ends of ranges and ranges of fits by test, with units; ``axle`` is that of a car.
    ``measured`` are files of a measured sheet; ``loads`` adds forces of links and bushings to the curves.
    """

    test: str = "bounce"
    axle: Literal["", "front", "rear"] = ""
    to: dict[str, str] = Field(default_factory=dict, max_length=20)
    within: dict[str, str] = Field(default_factory=dict, max_length=20)
    travel: str = ""
    steer: str = ""
    held: Literal["load", "height"] = "load"
    handwheel: Literal["locked", "free"] = "locked"
    measured: list[str] = Field(default_factory=list, max_length=20)
    overview: bool = False
    loads: bool = False


def create_app(
    folder: Path | str, *, token: str, port: int, ready: Callable[[], None] = lambda: None
) -> Guard:
    """Create the interface of a folder; ``ready`` is called when it accepts requests."""
    from contextlib import asynccontextmanager

    project = Project(folder)
    jobs = Jobs(project)
    records, seal = Records(project, jobs), partial(seal_address, token)
    version = metadata.version("jounce")

    @asynccontextmanager
    async def close_at_end(_: FastAPI) -> Any:
        ready()
        soon = threading.Timer(_SOON, jobs.prepare)
        soon.daemon = True
        soon.start()
        yield
        soon.cancel()
        jobs.end()
        records.end()

    app = FastAPI(
        title="jounce workbench",
        version=version,
        docs_url=None,
        redoc_url=None,
        lifespan=close_at_end,
        default_response_class=_Answer,
    )
    app.router.route_class = Route

    @app.exception_handler(JounceError)
    def handle_refusal(_: Request, error: JounceError) -> JSONResponse:
        text_found = None if error.found is None else str(error.found)
        plain = {
            "what": error.what,
            "where": error.where,
            "found": text_found,
            "allowed": error.allowed,
            "hint": error.hint,
        }
        plain |= {"text": str(error), "german": error.message().german()}
        plain |= without_options(plain)
        here = f"{project.root}{os.sep}"  # files are named relative to the project
        shortened = {key: text and text.replace(here, "") for key, text in plain.items()}
        return _Refusal({"error": shortened}, 409 if isinstance(error, OutputError) else 422)

    @app.exception_handler(OSError)
    def unwritten(_: Request, error: OSError) -> JSONResponse:
        place = Path(str(error.filename)).name if error.filename else ""
        return handle_refusal(_, unusable(error, place))

    @app.exception_handler(Exception)
    def handle_crash(_: Request, error: Exception) -> JSONResponse:
        return JSONResponse(
            {"error": {"what": str(unforeseen(error)), "text": str(unforeseen(error))}}, 500
        )

    @app.get("/api/health")
    def health() -> dict[str, str]:
        """Return the status and the version of the server."""
        return {"status": "ok", "version": version}

    @app.get("/api/project")
    def whole() -> dict[str, Any]:
        """List the files of the folder."""
        name, folder = (
            os.fsencode(path).decode(errors="replace") for path in (project.root.name, project.root)
        )
        entries = project.entries()
        pages = {entry.path: seal(_document(entry)) for entry in entries if entry.kind == "page"}
        addressed = [{**vars(entry), "address": pages.get(entry.path, "")} for entry in entries]
        return {"name": name, "folder": folder, "entries": addressed}

    @app.get("/api/library")
    def library() -> list[dict[str, str | bool]]:
        """List the shipped rigs and vehicles: model, source, and which of them are corners with kinematics."""
        from jounce.parts.files import library as shipped

        tables = {name: tomllib.loads(file.read_text("utf-8")) for name, file in shipped().items()}
        return [
            {
                "name": name,
                "model": str(table["model"]),
                "source": str(table.get("source", "")),
                "has_hardpoints": has_hardpoints(table),
                "has_axle": has_axle(table),
                "is_dependent": is_dependent(table),
            }
            for name, table in tables.items()
        ]

    @app.get("/api/drawing")
    def drawing(name: str) -> Response:
        """Return a small picture of a shipped rig or vehicle (SVG)."""
        return Response(_drawing(name), media_type="image/svg+xml")

    @app.post("/api/library")
    def start(asked: Started) -> Text:
        """Copy a shipped rig into the project."""
        from jounce.core.errors import unknown
        from jounce.parts.files import library as shipped

        files = shipped()
        if asked.name not in files:
            raise unknown(asked.name, files, what="rig", where="name")
        return project.write(asked.path, files[asked.name].read_text(encoding="utf-8"))

    @app.get("/api/file")
    def read(path: str) -> Text:
        """Return a description and its digest."""
        return project.read(path)

    @app.put("/api/file")
    def save(asked: Saved) -> Text:
        """Write a description, unless it was changed by others meanwhile."""
        return project.write(asked.path, asked.text, asked.was)

    @app.get("/api/versions")
    def versions(path: str) -> list[Version]:
        """Return earlier versions of a description that were replaced here, newest first."""
        return project.versions(path)

    @app.get("/api/check")
    def check(path: str) -> dict[str, Any]:
        """Return the problems of a file of the project, as ``jounce check`` reports them."""
        from jounce.core.files import only_below
        from jounce.operations.checks import check_file

        with only_below(project.root):
            checked = check_file(project.inside(path))
        problems = [{"text": text, "german": german_of(text)} for text in checked.problems]
        return {
            "kind": checked.kind,
            "what": checked.what,
            "problems": problems,
            "notes": to_plain(checked.notes),
        }

    @app.get("/api/rig")
    def rig(name: str) -> dict[str, Any]:
        """Return the parameters of a rig with their units."""
        return answers.describe_rig(answers.rig_of(project, name), name)

    @app.get("/api/schema")
    def schema(model: str) -> dict[str, Any]:
        """Return the schema of a model of rigs or vehicles."""
        return forms.schema(model)

    @app.post("/api/form")
    def form(asked: Edited) -> forms.Form:
        """Return a rig's text as a form: values, problems, and differences from the saved file."""
        return forms.form_of(project, asked.path, asked.text, asked.sets, asked.changes)

    @app.post("/api/points")
    def points(asked: PastedTable) -> dict[str, Any]:
        """Return the hardpoints of a pasted table beside those of a rig; nothing is written."""
        return answers.pasted_points(project, **asked.model_dump(exclude={"channels"}))

    @app.post("/api/curve")
    def curve(asked: PastedForce) -> dict[str, Any]:
        """Return a pasted curve in SI beside the present one; nothing is written."""
        return answers.pasted_curve(**asked.model_dump())

    @app.get("/api/record")
    def record(path: str) -> dict[str, Any]:
        """Return a summary of a record: channels with units, number of samples, and time range."""
        return records.open(path).about

    @app.post("/api/record")
    def part(asked: RecordPart, request: Request) -> Response:
        """Return some channels of a record at screen resolution."""
        opened = records.open(asked.path)
        low = opened.about["first"] if asked.low is None else asked.low
        high = opened.about["last"] if asked.high is None else asked.high
        shown = opened.viewer(asked.channels, low, high, asked.columns)
        return _curves_response(
            answers.CurvesAnswer(
                shown, records.equivalents(asked.path, opened.about, asked.channels)
            ),
            request,
        )

    @app.post("/api/simulate")
    def simulate(asked: RunRequest, request: Request) -> Response:
        """Return a run as curves of the viewer, compared with the unchanged rig, with equivalent code and command."""
        trial = {"road": asked.road, "speed": asked.speed, "duration": asked.duration}
        beside = answers.Beside(asked.against, asked.measured, asked.begins)
        shown = answers.simulate_changes(
            project, asked.rig, asked.changes, trial, asked.channels, text=asked.text,
            beside=beside, spectra=asked.spectra, numbers=asked.numbers,
        )  # fmt: skip
        return _curves_response(shown, request)

    @app.post("/api/keep")
    def keep_run(asked: Keep) -> dict[str, Any]:
        """Write a run into the project, with the record of its inputs."""
        trial = {"road": asked.road, "speed": asked.speed, "duration": asked.duration}
        return history.keep(project, asked.rig, asked.changes, trial, asked.title, asked.digest)

    @app.get("/api/history")
    def runs() -> list[dict[str, Any]]:
        """List stored runs, newest first: digests of rig and trial, changes, version and seed."""
        return history.history(project)

    @app.post("/api/compare")
    def compare(asked: OverlayRequest, request: Request) -> Response:
        """Overlay recordings."""
        return _curves_response(
            history.compare_recordings(project, asked.paths, asked.channels), request
        )

    @app.post("/api/differences")
    def differences(asked: CompareRequest) -> dict[str, Any]:
        """List what differs between rigs, vehicles, campaigns or saved runs, with units."""
        return comparing.compare_files(project, asked.names)

    @app.post(EXPORT)
    def export(asked: Exported, content: Annotated[bytes, Depends(_content)]) -> Response:
        """Export the content of a page as an image, a document or a table."""
        if asked.form in APART:
            question = {"kind": "export", "asked": content.decode()}
            written = jobs.document(JobSpec("Exporting", [], question=question), DOCUMENT)
        else:
            written = exported(asked)
        kept = {"Content-Disposition": f'attachment; filename="{file_name(asked)}"'}
        return Response(written, media_type=KINDS[asked.form], headers=kept)

    @app.post("/api/kinematics")
    def kinematics(asked: SweepRequest, request: Request) -> Response:
        """Return a sweep of a corner as curves of the viewer, as for a run, with instant centres and targets."""
        return _curves_response(
            sweeps.swept(project, sweeps.Question(**asked.model_dump())), request
        )

    @app.post("/api/kc")
    def tests(asked: LaboratoryRequest, request: Request) -> Response:
        """Return curves of one test on the K&C rig, and an overview of the tests that were run."""
        question = laboratory.Question(**asked.model_dump(exclude={"channels"}))
        return _curves_response(laboratory.run_tests(project, question), request)

    app.include_router(routes(project, jobs, seal))
    app.include_router(data_routes(project, jobs, records))
    for path, asset in assets().items():
        app.add_api_route(path, _served(asset), include_in_schema=False)
    return Guard(app, token=token, port=port)


async def _content(request: Request) -> bytes:
    return await request.body()


@lru_cache(64)
def _drawing(name: str) -> str:
    from jounce.core.errors import unknown
    from jounce.parts.files import library, load
    from jounce.plots.mechanisms.sketch import sketch

    if name not in library():
        raise unknown(name, library(), what="rig", where="name")
    return sketch(load(name))


def _document(entry: Entry) -> str:
    return f"/api/document?{urlencode({'path': entry.path})}"


def _curves_response(shown: answers.CurvesAnswer, request: Request) -> Response:
    """Return curves as JSON for scripts, or as binary numbers for the page, which requests bytes."""
    if "application/octet-stream" in request.headers.get("accept", ""):
        return Response(shown.straight(), media_type="application/octet-stream")
    return JSONResponse(shown.plain())


def _served(asset: Asset) -> Callable[[Request], Response]:
    def serve(request: Request) -> Response:
        content, headers = asset.response(request.headers.get("accept-encoding", ""))
        return Response(content, headers=headers)

    return serve
