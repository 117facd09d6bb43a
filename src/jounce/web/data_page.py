"""HTTP interface of the page of recordings: curves, figures of a window, and layouts."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from jounce.analysis.layouts import MOST_RECORDINGS, TIME, Layout, layout_of, layout_text
from jounce.core.optional import require
from jounce.core.units import Unit
from jounce.web import overlays
from jounce.web.bodies import Route
from jounce.web.jobs import Jobs
from jounce.web.project import Project
from jounce.web.records import Records
from jounce.web.tasks import LIMITS, JobSpec

require("fastapi", "web")  # ruff: isort: split
from fastapi import APIRouter  # noqa: E402
from fastapi.responses import Response  # noqa: E402

Number = Annotated[float, Unit("1")]


class _Asked(BaseModel):
    model_config = ConfigDict(extra="forbid")
    layout: dict[str, Any]

    def read(self) -> Layout:
        """Return the layout, or refuse it."""
        return Layout(**self.layout)


class CurvesRequest(_Asked):
    """Curves of a layout, from ``low`` to ``high`` of its axis (everything by default), in a number of columns."""

    low: Number | None = None
    high: Number | None = None
    columns: int = Field(default=1000, ge=10, le=4000)


class WindowRequest(_Asked):
    """Figures of the samples between two values of the axis of a layout."""

    begin: Number
    end: Number


class AlignRequest(_Asked):
    """A recording to be shifted onto another, by their numbers in the layout, with a channel of both.

    ``moved_channel`` is the channel of the shifted recording if its name differs. ``level`` of a rise or a fall is in
    the unit of the channel in the reference, ``maximum_shift`` in that of the axis.
    """

    reference: int = Field(ge=0, lt=MOST_RECORDINGS)
    moved: int = Field(ge=0, lt=MOST_RECORDINGS)
    channel: str
    by: Literal["correlation", "rise", "fall", "maximum", "minimum", "start"]
    level: Number | None = None
    maximum_shift: Annotated[float, Unit("1", above=0.0)] | None = None
    moved_channel: str = ""


class FilesAsked(BaseModel):
    """Files of the project."""

    model_config = ConfigDict(extra="forbid")
    paths: list[str] = Field(max_length=MOST_RECORDINGS)


class LayoutSaved(_Asked):
    """A layout to write; ``was`` is the digest of the replaced file, empty for a new one."""

    path: str
    was: str = ""


def data_routes(project: Project, jobs: Jobs, records: Records) -> APIRouter:
    """Return the routes of the page of recordings of a project."""
    router = APIRouter(route_class=Route)

    @router.post("/api/data/curves")
    def curves(asked: CurvesRequest) -> Response:
        """Return the curves of a layout at screen resolution, and the state of its recordings."""
        from jounce.report.live import live_bytes

        layout = asked.read()
        tracks = overlays.tracks_of(records, layout)
        low, high = overlays.whole_range(tracks, layout)
        more = {"whole": [low, high], "recordings": overlays.about_tracks(tracks)}
        low = low if asked.low is None else asked.low
        high = high if asked.high is None else asked.high
        if high <= low:
            low, high = low - 0.5, low + 0.5
        viewer, beside = overlays.curves(layout, tracks, low, high, asked.columns)
        return Response(
            live_bytes([viewer], {**more, **beside}), media_type="application/octet-stream"
        )

    @router.post("/api/data/window")
    def window(asked: WindowRequest) -> dict[str, Any]:
        """Return values at both ends of a window and the statistics of all samples in it."""
        layout = asked.read()
        tracks = overlays.tracks_of(records, layout)
        apart = asked.end - asked.begin
        rate = 1.0 / abs(apart) if layout.axis == TIME and apart else None
        rows = overlays.window_rows(layout, tracks, asked.begin, asked.end)
        return {"difference": apart, "rate": rate, "rows": rows}

    @router.post("/api/data/chart")
    def chart(asked: WindowRequest) -> Response:
        """Return the spectrum, histogram or scatter plot of a window."""
        from jounce.report.live import live_bytes
        from jounce.web.window_charts import window_chart

        layout = asked.read()
        viewer, notes = window_chart(
            layout, overlays.tracks_of(records, layout), asked.begin, asked.end
        )
        return Response(live_bytes([viewer], notes), media_type="application/octet-stream")

    @router.post("/api/data/align")
    def align(asked: AlignRequest) -> dict[str, Any]:
        """Return the shift of a recording onto another, by correlation or by an event."""
        tracks = overlays.tracks_of(records, asked.read())
        for number in {asked.reference, asked.moved} & set(range(len(tracks))):
            if (problem := tracks[number].problem) is not None:
                raise problem
        shown = [(track.path, track.clock) for track in tracks if track.clock is not None]
        question = {
            "kind": "align",
            "layout": asked.layout,
            "folders": {path: str(clock.levels.folder) for path, clock in shown},
            "how": asked.model_dump(exclude={"layout"}),
        }
        spec = JobSpec("Aligning recordings", [], limits=LIMITS, question=question)
        result: dict[str, Any] = jobs.ask(spec)["result"]
        return result

    @router.post("/api/data/state")
    def state(asked: FilesAsked) -> dict[str, str]:
        """Return the digest of each file as it is now; empty for a file that is gone."""
        return {path: records.digest(path) for path in asked.paths}

    @router.get("/api/data/reading")
    def reading() -> list[dict[str, Any]]:
        """Return the recordings that are being read now: path, share (0 to 1, if known), and seconds so far."""
        return records.reading()

    @router.get("/api/data/layout")
    def read_layout(path: str) -> dict[str, Any]:
        """Return a saved layout and the digest of its file."""
        saved = project.read(path)
        return {"layout": layout_of(saved.text, path), "digest": saved.digest}

    @router.put("/api/data/layout")
    def save_layout(asked: LayoutSaved) -> dict[str, str]:
        """Write a layout into the project, unless its file was changed by others meanwhile."""
        saved = project.write(asked.path, layout_text(asked.read()), asked.was)
        return {"path": saved.path, "digest": saved.digest}

    return router
