"""Requests of all pages in random order, as an hour of clicks sends them; `make bench-web` shows the server's memory.

Every route of the workbench is among them, with numbers, rigs and files chosen at random. Some are refused, as those
of people are; none may end in an internal error.
"""

from __future__ import annotations

import contextlib
import http.client
import json
import random
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlsplit

import numpy as np

import jounce as jn
from jounce.analysis.layouts import Layout, layout_text

Request = tuple[str, str, Any]
RIGS = {
    "kart-quarter-car": 22_000.0,
    "kart-double-wishbone": 22_000.0,
    "formula-student-front": 35_000.0,
}
CORNERS = ("kart-double-wishbone", "formula-student-front")
VEHICLES = ("audi-a6-half-car", "audi-a6-full-car")
FILES = ("run.csv", "other.csv", "run.nc")


def prepare_project(folder: Path) -> None:
    """Write a campaign, recordings, a rig, a road and a page into a folder."""
    jn.new_campaign(folder / "mine")
    time_ = np.arange(40_000) / 1000.0
    for name, lag in (("run.csv", 0.0), ("other.csv", 0.3)):
        moved = time_ - lag
        bump = np.exp(-(((moved - 20.0) / 4.0) ** 2))
        columns = [time_, 5.0 * np.sin(3.0 * moved) * bump, np.cos(17.0 * moved), 8.0 * time_]
        np.savetxt(
            folder / name, np.column_stack(columns), fmt="%.7g", delimiter=",", comments="",
            header="time [s],sprung.z [mm],sprung.az [m/s^2],distance [m]",
        )  # fmt: skip
    jn.write_recording(jn.read_recording(folder / "run.csv")[0], folder / "run.nc")
    (folder / "layouts").mkdir()
    saved = Layout(recordings=[{"path": "run.csv"}])
    (folder / "layouts" / "mine.toml").write_text(layout_text(saved), encoding="utf-8")
    (folder / "page.html").write_text("<p>page</p>", encoding="utf-8")
    (folder / "road.toml").write_text(
        'kind = "iso-8608"\nroad_class = "C"\nlength = "100 m"\nseed = 1\n'
    )
    kart = Path(jn.__file__).parent / "parts" / "library" / "kart-quarter-car.toml"
    (folder / "mine.toml").write_text(kart.read_text(encoding="utf-8"), encoding="utf-8")


class Clicks:
    """Requests to one server, chosen by the seed."""

    def __init__(self, address: str, token: str, seed: int = 0) -> None:
        self.at = urlsplit(address)
        self.head = {"Authorization": f"Bearer {token}", "Content-Type": "application/json"}
        self.choice = random.Random(seed)  # noqa: S311 - no secret
        self.number, self.job = 0, "000001-abcdef01"

    def send(self, method: str, path: str, body: Any = None) -> tuple[int, bytes]:
        """Send one request; return its status and its answer."""
        content = body if body is None or isinstance(body, bytes) else json.dumps(body).encode()
        with contextlib.closing(
            http.client.HTTPConnection(self.at.hostname or "", self.at.port, timeout=300)
        ) as connection:
            connection.request(method, path, content, self.head)
            answer = connection.getresponse()
            return answer.status, answer.read()

    def routes(self) -> set[tuple[str, str]]:
        """Return every route of the server that has an address of its own."""
        paths = json.loads(self.send("GET", "/openapi.json")[1])["paths"]
        return {(method.upper(), path) for path, methods in paths.items() for method in methods}

    def click(self, count: int) -> dict[tuple[str, str], list[int]]:
        """Send requests at random, each route at least once if there are enough; return their statuses by route."""
        makers = self.makers()
        wanted = list(makers)
        self.choice.shuffle(wanted)
        frequent = [route for route in makers if route not in SLOW]
        wanted += self.choice.choices(frequent, k=max(0, count - len(wanted)))
        statuses: dict[tuple[str, str], list[int]] = {}
        for route in wanted[:count]:
            status, answer = self.send(*makers[route]())
            statuses.setdefault(route, []).append(status)
            if route == ("POST", "/api/jobs") and status == 200:
                self.job = json.loads(answer)["id"]
                makers = self.makers()
        return statuses

    def drive(self, rig: str) -> dict[str, Any]:
        """Return a random trial of a rig with another spring."""
        random_ = self.choice.uniform
        kind = self.choice.choice(["half-sine", "versine", "step"])
        road = {"kind": kind, "height": f"{random_(2, 15):.1f} mm", "start": "0.2 m"}
        if kind != "step":
            road["length"] = f"{random_(50, 90):.1f} mm"
        return {
            "rig": rig, "changes": {"strut.spring.rate": RIGS[rig] * random_(0.6, 1.5)} if rig in RIGS else {},
            "road": road, "speed": f"{random_(1, 9):.2f} m/s", "duration": self.choice.choice(["0.5 s", "1.5 s"]),
        }  # fmt: skip

    def layout(self) -> dict[str, Any]:
        """Return a random layout of the page of recordings."""
        chart = self.choice.choice(["", "spectrum", "histogram", "scatter"])
        formula = {
            "name": "rate",
            "formula": self.choice.choice(["derivative(sprung.z)", "2 * sprung.z"]),
        }
        return {
            "recordings": [{"path": path} for path in self.choice.sample(FILES, 2)],
            "graphs": [{"channels": ["sprung.z"]}, {"channels": ["sprung.az"]}],
            "formulas": self.choice.choice([[], [], [], [formula]]),
            "axis": self.choice.choice(["time", "time", "distance"]),
            "chart": {"kind": chart, "channel": "sprung.az"} if chart else {},
        }  # fmt: skip

    def makers(self) -> dict[tuple[str, str], Callable[[], Request]]:
        """Return for each route a function that makes a random request."""
        choose, random_ = self.choice.choice, self.choice.uniform

        def get(route: str, **names: Any) -> Callable[[], Request]:
            def make() -> Request:
                chosen = {name: choose(values) for name, values in names.items()}
                asked = "&".join(f"{name}={quote(text)}" for name, text in chosen.items())
                return "GET", f"{route}?{asked}" if asked else route, None

            return make

        def post(path: str, body: Callable[[], Any], method: str = "POST") -> Callable[[], Request]:
            return lambda: (method, path, body())

        def new(suffix: str) -> str:
            self.number += 1
            return f"new-{self.number}{suffix}"

        def window() -> dict[str, Any]:
            begin = random_(0.0, 20.0)
            return {"layout": self.layout(), "begin": begin, "end": begin + random_(1.0, 15.0)}

        def simulate() -> dict[str, Any]:
            run = self.drive(choose([*RIGS, *VEHICLES]))
            beside = {
                "against": choose([[], [], [choose(list(RIGS))]]),
                "spectra": choose([False, False, True]),
            }
            return {**run, **beside, "numbers": [], "measured": choose(["", "", "run.csv"])}

        def sweep() -> dict[str, Any]:
            point = f"hardpoints.{choose(['tie_rod_inner', 'lower_ball_joint'])}[2]"
            over = choose([("travel", "travel"), ("roll", "roll"), ("rack", "rack")])
            values = {
                "travel": "-20 mm : 20 mm : 2 mm",
                "roll": "-2 deg : 2 deg : 0.5 deg",
                "rack": "-5 mm : 5 mm : 1 mm",
            }
            return {"rig": choose(CORNERS), "changes": {point: random_(0.1, 0.14)}, "over": over[0],
                    over[1]: values[over[0]], "against": choose([[], [], [choose(CORNERS)]])}  # fmt: skip

        def export() -> dict[str, Any]:
            curve = {"label": "run", "role": "after", "y": [random_(0, 1) for _ in range(300)]}
            panel = {"title": "force", "unit": "N", "curves": [curve]}
            chart = {
                "kind": "chart",
                "caption": "run",
                "x_label": "time [s]",
                "x": list(range(300)),
                "panels": [panel],
            }
            form = choose(["svg", "png", "pdf", "html", "csv", "xlsx"])
            return {"title": "page", "subtitle": "", "form": form, "scale": 1.0, "blocks": [chart]}

        def curve() -> dict[str, Any]:
            table = f"mm\tN\n0\t0\n10\t{random_(100, 300):.1f}"
            return {
                "table": table,
                "over": "deflection",
                "over_unit": "mm",
                "force_unit": "N",
                "turned": "",
            }

        def points() -> dict[str, Any]:
            table = f"point\tx\ty\tz\ntie_rod_inner\t{random_(1, 9)}\t200\t110"
            return {"rig": choose(CORNERS), "changes": {}, "table": table, "unit": "mm"}

        text = (Path(jn.__file__).parent / "parts" / "library" / "kart-quarter-car.toml").read_text(
            "utf-8"
        )
        every = [*RIGS, *VEHICLES]
        study = {
            "path": "study.toml", "was": "", "rig": "kart-quarter-car", "design": {"kind": "grid"},
            "trial": {"speed": "2 m/s", "duration": "0.4 s", "road": {"kind": "half-sine", "height": "10 mm",
                                                                      "length": "60 mm", "start": "0.2 m"}},
            "metrics": ["max sprung.az"], "vary": {"strut.spring.rate": ["20 N/mm", "25 N/mm"]},
        }  # fmt: skip
        decay = {"kind": "decay", "files": ["run.csv"], "mass": "16 kg", "columns": {"sprung.z": "sprung.z"},
                 "channel": "sprung.z"}  # fmt: skip
        return {
            ("GET", "/api/health"): get("/api/health"),
            ("GET", "/api/project"): get("/api/project"),
            ("GET", "/api/library"): get("/api/library"),
            ("POST", "/api/library"): post(
                "/api/library", lambda: {"name": choose(every), "path": new(".toml")}
            ),
            ("GET", "/api/drawing"): get("/api/drawing", name=every),
            ("GET", "/api/file"): get(
                "/api/file", path=["mine.toml", "road.toml", "mine/campaign.toml"]
            ),
            ("PUT", "/api/file"): post(
                "/api/file", lambda: {"path": new(".toml"), "text": text}, "PUT"
            ),
            ("GET", "/api/versions"): get("/api/versions", path=["mine.toml", "road.toml"]),
            ("GET", "/api/check"): get(
                "/api/check", path=["mine.toml", "road.toml", "run.csv", "mine/campaign.toml"]
            ),
            ("GET", "/api/rig"): get("/api/rig", name=every),
            ("GET", "/api/schema"): get(
                "/api/schema", model=["quarter-car", "half-car", "double-wishbone"]
            ),
            ("POST", "/api/form"): post(
                "/api/form",
                lambda: {
                    "path": "mine.toml",
                    "text": text,
                    "sets": [[["sprung", "mass"], f"{random_(10, 20):.2f} kg"]],
                },
            ),
            ("POST", "/api/points"): post("/api/points", points),
            ("POST", "/api/curve"): post("/api/curve", curve),
            ("GET", "/api/record"): get("/api/record", path=FILES),
            ("POST", "/api/record"): post(
                "/api/record",
                lambda: {
                    "path": choose(FILES),
                    "channels": ["sprung.z"],
                    "low": random_(0, 5),
                    "high": random_(6, 9),
                },
            ),
            ("POST", "/api/simulate"): post("/api/simulate", simulate),
            ("POST", "/api/keep"): post(
                "/api/keep", lambda: {**self.drive("kart-quarter-car"), "title": new("")}
            ),
            ("GET", "/api/history"): get("/api/history"),
            ("POST", "/api/compare"): post(
                "/api/compare", lambda: {"paths": list(FILES[1:]), "channels": ["sprung.z"]}
            ),
            ("POST", "/api/differences"): post(
                "/api/differences", lambda: {"names": self.choice.sample(every, 2)}
            ),
            ("POST", "/api/export"): post("/api/export", export),
            ("POST", "/api/kinematics"): post("/api/kinematics", sweep),
            ("GET", "/api/jobs"): get("/api/jobs"),
            ("POST", "/api/jobs"): post(
                "/api/jobs", lambda: {"kind": "sweep", "study": "study.toml", "out": new("")}
            ),
            ("GET", "/api/jobs/{name}"): get(f"/api/jobs/{self.job}"),
            ("DELETE", "/api/jobs/{name}"): lambda: ("DELETE", f"/api/jobs/{self.job}", None),
            ("POST", "/api/jobs/{name}/cancel"): post(f"/api/jobs/{self.job}/cancel", dict),
            ("POST", "/api/jobs/{name}/again"): post(f"/api/jobs/{self.job}/again", dict),
            ("GET", "/api/jobs/{name}/report"): get(f"/api/jobs/{self.job}/report"),
            ("POST", "/api/ask"): post("/api/ask", lambda: decay),
            ("POST", "/api/protocol"): post(
                "/api/protocol", lambda: {"kind": "protocol", "store": "no.sqlite", "records": [1]}
            ),
            ("GET", "/api/reports/{key}"): get("/api/reports/none"),
            ("GET", "/api/document"): get("/api/document", path=["page.html"]),
            ("POST", "/api/study"): post("/api/study", lambda: {**study, "path": new(".toml")}),
            ("GET", "/api/sweep"): get("/api/sweep", folder=["none"]),
            ("GET", "/api/campaign"): get("/api/campaign", path=["mine/campaign.toml"]),
            ("POST", "/api/campaign"): post(
                "/api/campaign",
                lambda: {
                    "campaign": "mine/campaign.toml",
                    "use": "trial",
                    "fields": {"recording": "run.csv", "speed": "2 m/s"},
                },
            ),
            ("POST", "/api/campaign/files"): post(
                "/api/campaign/files",
                lambda: {
                    "campaign": "mine/campaign.toml",
                    "files": [{"use": "spring", "file": "run.csv", "state": "0", "fields": {}}],
                },
            ),
            ("POST", "/api/campaign/trials"): post(
                "/api/campaign/trials",
                lambda: {
                    "campaign": "mine/campaign.toml",
                    "table": f"trial\tspeed\n1\t{random_(1, 3):.2f} m/s",
                },
            ),
            ("GET", "/api/choices"): get("/api/choices"),
            ("PUT", "/api/upload"): lambda: (
                "PUT",
                f"/api/upload?path={new('.csv')}",
                b"time [s],x [m]\n0,1\n1,2\n",
            ),
            ("POST", "/api/data/curves"): post(
                "/api/data/curves", lambda: {"layout": self.layout(), "columns": 1000}
            ),
            ("POST", "/api/data/window"): post("/api/data/window", window),
            ("POST", "/api/data/chart"): post("/api/data/chart", window),
            ("POST", "/api/data/align"): post(
                "/api/data/align",
                lambda: {
                    "layout": {**self.layout(), "axis": "time"},
                    "reference": 0,
                    "moved": 1,
                    "channel": "sprung.z",
                    "by": choose(["correlation", "maximum", "start"]),
                },
            ),
            ("POST", "/api/data/state"): post("/api/data/state", lambda: {"paths": list(FILES)}),
            ("GET", "/api/data/reading"): get("/api/data/reading"),
            ("GET", "/api/data/layout"): get("/api/data/layout", path=["layouts/mine.toml"]),
            ("PUT", "/api/data/layout"): post(
                "/api/data/layout",
                lambda: {"layout": self.layout(), "path": f"layouts/{new('.toml')}"},
                "PUT",
            ),
        }


SLOW = {
    ("POST", "/api/ask"),
    ("POST", "/api/jobs"),
    ("POST", "/api/protocol"),
    ("GET", "/api/sweep"),
}
"""Routes that start a process for each request: sent once."""


def settled_memory(process: int, pause: float = 6.0) -> dict[str, float]:
    """Return the memory of an idle process, MB: resident, and the part of it that is no file."""
    time.sleep(pause)
    rows = Path(f"/proc/{process}/status").read_text(encoding="utf-8").splitlines()
    held = {row.split(":")[0]: int(row.split()[1]) / 1024 for row in rows if "kB" in row}
    return {"resident": held["VmRSS"], "own": held["RssAnon"]}
