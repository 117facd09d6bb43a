"""HTTP interface for jobs, short queries, uploads and reports."""

from __future__ import annotations

import asyncio
import contextlib
import filecmp
import json
import secrets
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from jounce.core.errors import DescriptionError, OutputError
from jounce.core.optional import require
from jounce.core.writing import temporary_beside
from jounce.variants.shards import read_kept
from jounce.web.bodies import Route
from jounce.web.campaigns import (
    FileEntry,
    NewCampaign,
    OwnRig,
    Use,
    enter_file,
    enter_files,
    overview,
    own_values,
    pasted_trials,
)
from jounce.web.jobs import Jobs
from jounce.web.project import LONGEST, RECORDS, Project, unusable
from jounce.web.safety import PROTOCOL
from jounce.web.studies import write_study
from jounce.web.tasks import AS_PDF, LIMITS, Asked, EvaluateTask, JobSpec, ProtocolTask, spec_of
from jounce.web.untrusted import content

require("fastapi", "web")  # ruff: isort: split
from fastapi import APIRouter, Request, WebSocket, WebSocketDisconnect  # noqa: E402
from fastapi.responses import Response  # noqa: E402

_BETWEEN = 0.25  # s between two checks of the jobs for connected clients
_MOST_PAGES, _LARGEST_PAGE = (
    16,
    250_000_000,
)  # number of reports of short queries kept; maximum bytes of a page
_UPLOADED = (*RECORDS, ".crg", ".dbc", ".toml")
_ALONE = (
    "sandbox allow-scripts; default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; font-src data:; frame-ancestors 'self'; base-uri 'none'; form-action 'none'"
)
"""Policy of a report: it may run its own script, in an isolated origin without access to this server."""
_KINDS = {
    ".html": "text/html; charset=utf-8",
    ".pdf": "application/pdf",
    ".png": "image/png",
    ".svg": "image/svg+xml",
}


class Study(BaseModel):
    """A study of a sweep: the keys of its schema, and the file to write."""

    model_config = ConfigDict(extra="forbid")
    path: str
    was: str = ""
    rig: str
    trial: dict[str, Any]
    design: dict[str, Any]
    vary: dict[str, Any]
    metrics: list[str]
    outputs: list[str] | None = None
    control: str | None = None


class EnteredFiles(BaseModel):
    """Measured files for a campaign, or for a new one that is written with them."""

    model_config = ConfigDict(extra="forbid")
    campaign: str
    new: NewCampaign | None = None
    files: Annotated[list[FileEntry], Field(min_length=1, max_length=500)]


class PastedTrials(BaseModel):
    """A table of trials as copied from a spreadsheet; it is written if the digest of the campaign is given."""

    model_config = ConfigDict(extra="forbid")
    campaign: str
    table: Annotated[str, Field(max_length=200_000)]
    was: str = ""


class Entered(BaseModel):
    """A measured file for a campaign: its role and the keys of its table, with file paths in the project."""

    model_config = ConfigDict(extra="forbid")
    campaign: str
    use: Use
    fields: dict[str, Any]


def routes(project: Project, jobs: Jobs, seal: Callable[[str], str]) -> APIRouter:
    """Return the routes of a project; ``seal`` creates addresses that a browser can open without the token."""
    router = APIRouter(route_class=Route)
    pages: OrderedDict[str, str] = OrderedDict()

    def with_report(state: dict[str, Any]) -> dict[str, Any]:
        return {**state, "report": seal(f"/api/jobs/{state['id']}/report")}

    @router.get("/api/jobs")
    def every(*, running: bool = False) -> list[dict[str, Any]]:
        """Return the state of all jobs, or of those that are running, newest first."""
        lively = ("running", "cancelling")
        return [
            with_report(state) for state in jobs.all() if not running or state["state"] in lively
        ]

    @router.post("/api/jobs")
    def begin(asked: Asked) -> dict[str, Any]:
        """Start a job: a command in a separate process."""
        return with_report(jobs.begin(asked))

    @router.get("/api/jobs/{name}")
    def job(name: str) -> dict[str, Any]:
        """Return the state of a job and the output of its command."""
        state = jobs.state(name)
        finished = state["state"] == "done"
        return {
            **with_report(state),
            "result": jobs.result(name) if finished else None,
            "has_page": jobs.page(name) is not None,
        }

    @router.post("/api/jobs/{name}/cancel")
    def cancel(name: str) -> dict[str, Any]:
        """Request a job to stop; finished results are kept."""
        return with_report(jobs.cancel(name))

    @router.post("/api/jobs/{name}/again")
    def again(name: str) -> dict[str, Any]:
        """Restart a job; a sweep resumes where it stopped, outputs of other jobs are replaced."""
        return with_report(jobs.begin(jobs.again(name)))

    @router.delete("/api/jobs/{name}")
    def forget(name: str) -> dict[str, str]:
        """Remove a finished job from the list; files it wrote into the project are kept."""
        jobs.forget(name)
        return {"forgotten": name}

    @router.get("/api/jobs/{name}/report")
    def report(name: str) -> Response:
        """Return the report of a job."""
        file = jobs.page(name)
        if file is None:
            raise DescriptionError("the job wrote no report", where="job", found=name)
        return _alone(_page(file, name), ".html")

    @router.websocket("/api/live")
    async def live(socket: WebSocket) -> None:
        """Send the state of the jobs now and whenever it changes."""
        # Some versions of uvicorn do not split the offered protocols, so the scope is not used.
        await socket.accept(PROTOCOL if "sec-websocket-protocol" in socket.headers else None)
        await asyncio.to_thread(jobs.prepare)
        before = ""
        try:
            while True:
                now = json.dumps(await asyncio.to_thread(every))
                if now != before:
                    await socket.send_text(now)
                    before = now
                with contextlib.suppress(TimeoutError):
                    await asyncio.wait_for(socket.receive_text(), _BETWEEN)
        except (WebSocketDisconnect, RuntimeError):
            return

    @router.post("/api/ask")
    def ask(asked: Asked) -> dict[str, Any]:
        """Run a short command and wait for its result."""
        answer = jobs.ask(spec_of(asked, project))
        text = answer.pop("page")
        key = ""
        if text:
            key = secrets.token_hex(8)
            pages[key] = text
            while len(pages) > _MOST_PAGES:
                pages.popitem(last=False)
        return {**answer, "report": seal(f"/api/reports/{key}") if key else ""}

    @router.post("/api/protocol")
    def protocol(
        asked: Annotated[EvaluateTask | ProtocolTask, Field(discriminator="kind")],
    ) -> Response:
        """Return a protocol as PDF; nothing is stored."""
        told = asked.model_copy(update={"store": ""}) if asked.kind == "evaluate" else asked
        spec = replace(spec_of(told, project), hidden=AS_PDF)
        return _alone(jobs.document(spec), ".pdf")

    @router.get("/api/reports/{key}")
    def past_report(key: str) -> Response:
        """Return the report of a short query while it is kept."""
        if key not in pages:
            raise DescriptionError(
                "the report is no longer available", where="report", hint="Create the report again."
            )
        return _alone(pages[key].encode(), ".html")

    @router.get("/api/document")
    def document(path: str) -> Response:
        """Return a page or image of the project, in an isolated origin."""
        file = project.inside(path)
        if file.suffix.lower() not in _KINDS or not file.is_file():
            raise DescriptionError(
                "neither a page nor a picture", where="path", found=path, allowed=", ".join(_KINDS)
            )
        return _alone(_page(file, path), file.suffix.lower())

    @router.post("/api/study")
    def study(asked: Study) -> dict[str, Any]:
        """Write a complete study of a sweep; return its text and number of variants."""
        fields = asked.model_dump(exclude={"path", "was"}, exclude_none=True)
        return write_study(project, asked.path, fields, asked.was)

    @router.get("/api/sweep")
    def sweep(folder: str) -> dict[str, Any]:
        """Return the finished variants of a sweep, with their statistics."""
        read_kept(project.inside(folder))
        question = {"kind": "swept", "root": str(project.root), "folder": folder}
        result: dict[str, Any] = jobs.ask(
            JobSpec(f"Reading {folder}", [], limits=LIMITS, question=question)
        )["result"]
        return result

    @router.get("/api/campaign")
    def campaign(path: str) -> dict[str, Any]:
        """Return the contents of a campaign."""
        return overview(project, path)

    @router.post("/api/campaign")
    def enter(asked: Entered) -> dict[str, Any]:
        """Add a measured file to a campaign, with its reading options."""
        return enter_file(project, asked.campaign, asked.use, asked.fields)

    @router.post("/api/campaign/files")
    def enter_all(asked: EnteredFiles) -> dict[str, Any]:
        """Add measured files to a campaign or a new one; return the files that were refused, with the reason."""
        return enter_files(project, asked.campaign, asked.files, asked.new)

    @router.post("/api/campaign/values")
    def values(asked: OwnRig) -> list[dict[str, Any]]:
        """Return the values of a rig that a new campaign would replace, before and after."""
        return own_values(project, asked)

    @router.post("/api/campaign/trials")
    def paste_trials(asked: PastedTrials) -> dict[str, Any]:
        """Return what a pasted table of trials changes in a campaign; write it if the digest is given."""
        return pasted_trials(project, asked.campaign, asked.table, asked.was)

    @router.get("/api/choices")
    def choices() -> dict[str, list[str]]:
        """Return shipped names: testers, methods, controllers, roads."""
        from jounce.control import CONTROLS
        from jounce.inspection.methods import METHODS
        from jounce.parts.testers import library as testers
        from jounce.roads.loading import road_library

        return {
            "testers": list(testers()),
            "methods": list(METHODS),
            "controls": list(CONTROLS),
            "roads": list(road_library()),
        }

    @router.get("/api/tested")
    def tested() -> list[dict[str, str | None]]:
        """List the records of the project, each with the reason why it cannot be inspected, if there is one."""
        from jounce.inspection.record import missing_plates

        reasons: list[dict[str, str | None]] = []
        for path in (entry.path for entry in project.entries() if entry.kind == "record"):
            try:
                why = missing_plates(project.inside(path))
            except OSError as error:
                why = unusable(error, "").message()
            reasons.append({"path": path, "why": why, "german": why and why.german()})
        return reasons

    @router.put("/api/upload")
    async def upload(request: Request, path: str) -> dict[str, Any]:
        """Store an uploaded file unchanged; an existing file is never replaced, but an identical upload is accepted."""
        file = project.inside(path)
        if file.suffix.lower() not in _UPLOADED:
            raise OutputError("not a measurement file", where=path, allowed=", ".join(_UPLOADED))
        expected, size = int(request.headers.get("content-length", "0")), 0
        if file.suffix.lower() == ".toml" and expected > LONGEST:
            raise OutputError("too long for a description", where=path, found=f"{expected} bytes")
        if file.exists() and file.stat().st_size != expected:
            raise OutputError("the file already exists", where=path, hint="Choose another name.")
        file.parent.mkdir(parents=True, exist_ok=True)
        temporary = temporary_beside(file)
        try:
            with temporary.open("wb") as stream:
                async for part in request.stream():
                    size += len(part)
                    await asyncio.to_thread(stream.write, part)
            if size != expected:
                raise OutputError(
                    "the upload is incomplete", where=path, found=f"{size} of {expected} bytes"
                )
            if not (
                file.exists()
                and await asyncio.to_thread(filecmp.cmp, temporary, file, shallow=False)
            ):
                _put_new(temporary, file)
        except OSError as error:
            raise unusable(error, path) from None
        finally:
            temporary.unlink(missing_ok=True)
        return {"path": path, "size": size}

    return router


def _put_new(temporary: Path, file: Path) -> None:
    """Rename a file, unless the name was taken meanwhile."""
    taken = OutputError("the file already exists", where=file.name, hint="Choose another name.")
    try:
        file.hardlink_to(temporary)
    except FileExistsError:
        raise taken from None
    except OSError:  # a file system without links
        if file.exists():
            raise taken from None
        temporary.replace(file)


def _page(file: Path, where: str) -> bytes:
    try:
        return content(file, _LARGEST_PAGE)
    except ValueError:
        raise DescriptionError(
            "too large to display", where=where, allowed=f"{_LARGEST_PAGE} bytes"
        ) from None


def _alone(content: bytes, suffix: str) -> Response:
    return Response(content, media_type=_KINDS[suffix], headers={"Content-Security-Policy": _ALONE})
