"""The workbench's server: it answers its own page and scripts with the token, and keeps to its folder."""

from __future__ import annotations

import asyncio
import ctypes
import gzip
import http.client
import importlib.util
import json
import logging
import shlex
import socket
import subprocess
import sys
import threading
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.cli import main
from jounce.core.errors import DescriptionError, OutputError
from jounce.core.remembered import Recent
from jounce.parts import library
from jounce.variants.shards import SCHEMA
from jounce.web import answers, forms, serve, serving, sweeps
from jounce.web.assets import assets
from jounce.web.project import Project
from jounce.web.safety import HEADERS

uvicorn = pytest.importorskip("uvicorn")
TOKEN = "a-token-of-these-tests"
BUMP = {"kind": "half-sine", "height": "10 mm", "length": "60 mm", "start": "0.2 m"}
KART = (Path(jn.__file__).parent / "parts" / "library" / "kart-double-wishbone.toml").read_text()
RUN = {"rig": "kart-quarter-car", "road": BUMP, "speed": "2 m/s", "duration": "0.4 s"}


class Asked:
    """Asks a server, as a script does."""

    def __init__(self, port: int, folder: Path) -> None:
        self.port, self.folder = port, folder

    def straight(self, path: str, body: Any) -> tuple[Any, list[Any]]:
        """What the page gets: plain content, and its arrays."""
        given = {"Authorization": f"Bearer {TOKEN}", "Content-Type": "application/json"}
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.request(
            "POST", path, json.dumps(body), given | {"Accept": "application/octet-stream"}
        )
        answer = connection.getresponse()
        got = answer.read()
        connection.close()
        assert (answer.status, answer.getheader("content-type")) == (
            200,
            "application/octet-stream",
        ), got
        start = 4 + int.from_bytes(got[:4], "little")
        content = json.loads(got[4:start])
        return content, [
            np.frombuffer(got, f"<{one['form']}", one["n"], start + one["at"])
            for one in content["arrays"]
        ]

    def __call__(
        self, method: str, path: str, body: Any = None, **headers: str | None
    ) -> tuple[int, Any]:
        given = {"Authorization": f"Bearer {TOKEN}"} | {
            name.replace("_", "-"): text for name, text in headers.items()
        }
        if body is not None:
            given["Content-Type"] = "application/json"
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        text = None if body is None else json.dumps(body)
        connection.request(
            method, path, text, {name: value for name, value in given.items() if value is not None}
        )
        answer = connection.getresponse()
        content = answer.read()
        self.headers = {name.lower(): text for name, text in answer.getheaders()}
        connection.close()
        is_json = self.headers.get("content-type", "").startswith("application/json")
        return answer.status, json.loads(content) if is_json else content.decode()


@pytest.fixture(scope="module")
def ask(workbench):
    folder, port = workbench
    return Asked(port, folder)


def test_it_says_that_it_is_well_and_what_it_can(ask):
    status, answer = ask("GET", "/api/health")
    assert (status, answer["status"], answer["version"]) == (200, "ok", jn.__version__)
    assert set(ask("GET", "/openapi.json")[1]["paths"]) >= {
        "/api/health",
        "/api/project",
        "/api/simulate",
        "/api/file",
    }


@pytest.mark.parametrize(
    "path", ["/api/health", "/api/project", "/openapi.json", "/api/file?path=rig.toml", "/nowhere"]
)
def test_nobody_is_answered_without_the_token(ask, path):
    for wrong in (None, "Bearer ", "Bearer another", "Basic YTpi", f"Bearer {TOKEN}x", TOKEN):
        assert ask("GET", path, Authorization=wrong)[0] == 401
    for cookie in (f"jounce-{ask.port}={TOKEN}", f"token={TOKEN}", f"Authorization=Bearer {TOKEN}"):
        assert ask("GET", path, Authorization=None, Cookie=cookie)[0] == 401


def test_the_printed_address_opens_the_page_and_leaves_nothing_that_other_servers_are_sent(ask):
    """Browsers send a cookie to all servers of a machine, whatever their ports."""
    status, page = ask("GET", f"/?token={TOKEN}", Authorization=None)
    assert (status, "set-cookie" in ask.headers, TOKEN in page) == (200, False, False)
    assert ask("GET", "/?token=another", Authorization=None)[0] == 401


def test_an_address_that_a_browser_opens_by_itself_opens_nothing_else(ask):
    for name in ("a & b.html", "other.html"):
        (ask.folder / name).write_text(f"<p>{name}")
    entries = {one["path"]: one["address"] for one in ask("GET", "/api/project")[1]["entries"]}
    sealed, other = entries["a & b.html"], entries["other.html"]
    assert TOKEN not in sealed
    assert ask("GET", sealed, Authorization=None) == (200, "<p>a & b.html")
    key, another = (one.rpartition("key=")[2] for one in (sealed, other))
    asked, foreign = sealed.rpartition("&key=")[0], other.rpartition("&key=")[0]
    for wrong in (
        asked, f"{asked}&key=", f"{asked}&key={another}", f"{foreign}&key={key}", f"{asked}&path=other.html&key={key}",
        f"/api/project?key={key}", f"{sealed}&path=other.html", f"{sealed}&key={another}", f"{sealed}0",
        sealed.replace("/api/document", "/api/document/"), sealed.replace("/api/document", "/api/file"),
    ):  # fmt: skip
        assert ask("GET", wrong, Authorization=None)[0] == 401, wrong
    for method in ("POST", "PUT", "DELETE", "HEAD"):
        assert ask(method, sealed, Authorization=None)[0] == 401
    assert ask("GET", sealed, Authorization=None, Host="evil.example")[0] == 403
    assert ask("GET", sealed, Authorization=None, Origin="http://evil.example")[0] == 403


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "evil.example"},
        {"Host": "evil.example:80"},
        {"Host": "127.0.0.1.evil.example"},
        {"Host": "127.0.0.1:1"},
        {"Host": ""},
        {"Origin": "http://evil.example"},
        {"Origin": "null"},
        {"Origin": "https://127.0.0.1"},
    ],
    ids=str,
)
def test_other_hosts_and_origins_are_refused_with_the_token_too(ask, headers):
    assert ask("GET", "/api/health", **headers)[0] == 403
    assert ask("GET", "/", **headers)[0] == 403


def test_its_own_origin_is_none_of_them(ask):
    for name in ("127.0.0.1", "localhost"):
        assert (
            ask(
                "GET", "/api/health", Host=f"{name}:{ask.port}", Origin=f"http://{name}:{ask.port}"
            )[0]
            == 200
        )


def test_the_page_may_run_its_own_scripts_only_and_fetches_nothing_else(ask):
    for path in (*assets(), "/api/health"):
        assert (
            ask("GET", path, Authorization=None if "api" not in path else f"Bearer {TOKEN}")[0]
            == 200
        )
        required = {name.lower(): text for name, text in HEADERS.items()}
        if path not in ("/", "/icon.svg", "/api/health"):
            required["cache-control"] = "private, max-age=31536000, immutable"
        assert required.items() <= ask.headers.items()
    policy = HEADERS["Content-Security-Policy"]
    assert "unsafe" not in policy
    assert "default-src 'none'" in policy
    page = ask("GET", "/")[1]
    assert '<script type="module" src="/app-' in page
    assert "style=" not in page
    assert "://" not in page


def test_scripts_are_compressed_for_those_who_can_read_them(ask):
    path = next(path for path in assets() if path.startswith("/main-"))
    whole = assets()[path].content
    assert ask("GET", path, **{"Accept-Encoding": "gzip;q=0, br"})[1].encode() == whole
    assert "content-encoding" not in ask.headers
    connection = http.client.HTTPConnection("127.0.0.1", ask.port, timeout=20)
    connection.request("GET", path, headers={"Accept-Encoding": "br, gzip"})
    response = connection.getresponse()
    body = response.read()
    connection.close()
    assert response.headers["Content-Encoding"] == "gzip"
    assert response.headers["Vary"] == "Accept-Encoding"
    assert gzip.decompress(body) == whole
    assert len(body) < 0.6 * len(whole)
    assert ask("GET", "/main-AAAAAAAA.js", Authorization=None)[0] == 401


def test_a_step_of_a_slider_computes_only_the_changed_rig(tmp_path, monkeypatch):
    (tmp_path / "a.toml").write_text(KART)
    project, computed, run = Project(tmp_path), [], sweeps._run
    monkeypatch.setattr(sweeps, "_run", lambda rig, asked: computed.append(rig) or run(rig, asked))
    asked = sweeps.Question(
        "a.toml", {}, "-10 mm : 10 mm : 5 mm", against=("kart-double-wishbone",)
    )
    path = "hardpoints.tie_rod_inner[2]"
    height = answers.rig_of(project, "a.toml").parameters()[path]
    for step in range(1, 5):
        changes = {path: height + 1e-3 * step}
        values = replace(asked, changes=changes)
        curves = sweeps.swept(project, values).viewer.scenes[0].panes
        assert len(curves[0].curves) == 3
    assert [rig.parameters()[path] == height for rig in computed] == [False, True, *[False] * 3]
    assert answers.rig_of(project, "a.toml") is answers.rig_of(project, "a.toml")
    (tmp_path / "a.toml").write_text(KART.replace('camber = "0 deg"', 'camber = "1 deg"'))
    assert answers.rig_of(project, "a.toml").parameters()["wheel.camber"] > 0.01


OUTSIDE = ["../secret.toml", "/etc/hostname", "a/../../secret.toml", "link.toml", "linked/secret.toml", "..", "", ".",
           "a\x00.toml", "\\\\server\\share"]  # fmt: skip


@pytest.mark.parametrize(
    "path", OUTSIDE, ids=lambda text: text[:12].encode("unicode_escape").decode()
)
def test_nothing_outside_of_the_folder_is_read_written_or_checked(ask, path):
    secret = ask.folder.parent / "secret.toml"
    secret.write_text('schema = "jounce.rig/1"\n# secret\n')
    for name, target in (("link.toml", secret), ("linked", ask.folder.parent)):
        if not (ask.folder / name).is_symlink():
            (ask.folder / name).symlink_to(target)

    for status, answer in (
        ask("GET", f"/api/file?path={quote(path)}"),
        ask("GET", f"/api/check?path={quote(path)}"),
        ask("GET", f"/api/rig?name={quote(path)}"),
        ask("PUT", "/api/file", {"path": path, "text": "x = 1", "was": ""}),
        ask("POST", "/api/library", {"name": "kart-quarter-car", "path": path}),
    ):
        assert status in (409, 422)
        assert "secret" not in str(answer).replace("secret.toml", "")
    assert secret.read_text() == 'schema = "jounce.rig/1"\n# secret\n'


def test_names_that_no_system_takes_are_refused(ask):
    name = f"{'x' * 5000}.toml"
    assert ask("GET", f"/api/file?path={name}")[0] == 422
    assert ask("PUT", "/api/file", {"path": name, "text": "x = 1", "was": ""})[0] in (409, 422)
    assert "no such file" in str(ask("GET", f"/api/check?path={name}")[1]["problems"])


def test_descriptions_lead_to_no_file_outside_either(ask):
    corner = ask.folder.parent / "corner.toml"
    corner.write_text("a secret")
    car = (Path(jn.__file__).parent / "parts" / "library" / "audi-a6-full-car.toml").read_text()
    spatial = 'schema = "jounce.rig/1"\nmodel = "full-car-3d"\nfront = "../corner.toml"\nrear = "../corner.toml"\n'
    for name, text in (("car.toml", spatial), ("plain.toml", car)):
        (ask.folder / name).write_text(text)
    status, answer = ask("GET", "/api/rig?name=car.toml")
    assert status == 422
    assert "a secret" not in str(answer)
    assert ask("GET", "/api/rig?name=plain.toml")[0] == 200
    road = {"kind": "table", "file": str(corner)}
    asked = {"rig": "kart-quarter-car", "road": road, "speed": "2 m/s", "duration": "0.2 s"}
    status, answer = ask("POST", "/api/simulate", asked)
    assert status == 422
    assert "a secret" not in str(answer)


def test_what_is_shipped_says_whose_kinematics_can_be_swept(ask):
    status, shipped = ask("GET", "/api/library")
    has_hardpoints = {one["name"]: one["has_hardpoints"] for one in shipped}
    assert status == 200
    assert has_hardpoints["kart-double-wishbone"]
    assert not has_hardpoints["kart-quarter-car"]
    has_axle = {one["name"]: one["has_axle"] for one in shipped}
    for name in ("kart-double-wishbone", "solid-axle", "twist-beam", "sedan-full-car-3d"):
        assert has_axle[name]
        assert has_hardpoints[name] == (name == "kart-double-wishbone")
    assert not has_axle["kart-quarter-car"]
    models = {one["name"]: one["model"] for one in shipped}
    assert models["generic-mcpherson"] == "mcpherson"


def test_what_is_shipped_has_a_drawing_and_nothing_else_does(ask):
    status, answer = ask("GET", "/api/drawing?name=no-such-rig")
    assert status == 422
    assert "no-such-rig" in answer["error"]["text"]
    assert ask("GET", "/api/drawing?name=../kart-quarter-car")[0] == 422


def test_a_rig_is_started_changed_and_never_overwritten_unseen(ask):
    status, made = ask(
        "POST", "/api/library", {"name": "kart-quarter-car", "path": "karts/mine.toml"}
    )
    assert status == 200
    assert (
        ask("POST", "/api/library", {"name": "kart-quarter-car", "path": "karts/mine.toml"})[0]
        == 409
    )
    text = made["text"].replace("16", "17", 1)
    status, saved = ask(
        "PUT", "/api/file", {"path": "karts/mine.toml", "text": text, "was": made["digest"]}
    )
    assert status == 200
    assert (ask.folder / "karts" / "mine.toml").read_text() == text
    status, answer = ask(
        "PUT", "/api/file", {"path": "karts/mine.toml", "text": "lost", "was": made["digest"]}
    )
    assert (status, answer["error"]["what"]) == (409, "the file has changed since it was loaded")
    assert ask("GET", "/api/file?path=karts/mine.toml")[1] == saved
    assert ("karts/mine.toml", "rig") in {
        (one["path"], one["kind"]) for one in ask("GET", "/api/project")[1]["entries"]
    }
    assert ask("GET", "/api/check?path=karts/mine.toml")[1]["problems"] == []


def test_what_was_written_and_what_is_to_be_read_are_no_records(ask):
    for folder in ("swept/shards", "designed"):
        (ask.folder / folder).mkdir(parents=True, exist_ok=True)
    table = "time [s], sprung.z [mm]\n0, 1\n0.1, 2\n"
    texts = {
        "README.txt": "Files 1 to 4 are measured.\nbegin: 3\n",
        "log.txt": table,
        "wide.dat": "# a\n  1.5e-3\t-2\n",
        "utf.txt": table.encode("utf-16").decode("latin-1"),
        "swept/sweep.json": "{}",
        "swept/study.toml": 'schema = "jounce.sweep/1"\n',
        "swept/variants.csv": table,
        "swept/shards/0.nc": "",
        "designed/results.json": "{}",
        "designed/targets.csv": table,
        "study.toml": 'schema = "jounce.sweep/1"\n',
    }
    for name, text in texts.items():
        (ask.folder / name).write_text(text, encoding="latin-1")
    entries = ask("GET", "/api/project")[1]["entries"]  # other tests have written there, too
    found = {one["path"]: one["kind"] for one in entries if one["path"] in {*texts, "swept"}}
    assert [name for name, kind in found.items() if kind == "record"] == [
        "log.txt",
        "utf.txt",
        "wide.dat",
    ]
    assert [name for name, kind in found.items() if kind == "sweep"] == ["study.toml"]
    assert "README.txt" not in found
    assert {name for name in found if name.startswith("swept")} == {
        "swept"
    }  # though its manifest says nothing
    assert (found["swept"], found["designed/targets.csv"]) == ("swept", "results")


@pytest.mark.pages
def test_runs_are_kept_with_what_they_were_made_of_and_compared(ask):
    asked = RUN | {"title": "as it is"}
    status, kept = ask("POST", "/api/keep", asked)
    assert (status, kept["path"], kept["version"]) == (200, "runs/as it is.nc", jn.__version__)
    assert ask("POST", "/api/keep", asked)[0] == 409
    for title in ("../out", "a/b", "", ".hidden", "x" * 200):
        assert ask("POST", "/api/keep", asked | {"title": title})[0] == 422
    stiffer = {"changes": {"strut.spring.rate": "30 N/mm"}}
    other = ask("POST", "/api/keep", asked | stiffer | {"title": "stiffer"})[1]
    again = ask("POST", "/api/keep", asked | {"title": "again"})[1]
    assert again["rig_digest"] == kept["rig_digest"] != other["rig_digest"]
    assert {one["trial_digest"] for one in (kept, other, again)} == {kept["trial_digest"]}
    assert [one["path"] for one in ask("GET", "/api/history")[1]][:3] == [
        f"runs/{title}.nc" for title in ("again", "stiffer", "as it is")
    ]
    run = jn.read_recording(ask.folder / "runs" / "stiffer.nc")[0]
    assert json.loads(run.attrs["jounce_changes"]) == stiffer["changes"]
    content, arrays = ask.straight(
        "/api/compare", {"paths": [kept["path"], other["path"]], "channels": ["sprung.az"]}
    )
    curves = content["viewers"][0]["scenes"][0]["panes"][0]["curves"]
    assert [curve["label"] for curve in curves] == [kept["path"], other["path"]]
    assert arrays[curves[1]["y"]] == pytest.approx(run["sprung.az"].to_numpy(), abs=1e-6)


@pytest.mark.pages
def test_a_run_is_kept_of_the_rig_that_was_looked_at(ask):
    """Its file may have been changed since: the run would be of another rig than the curves beside it."""
    text = library()["kart-quarter-car"].read_text(encoding="utf-8")
    written = ask("PUT", "/api/file", {"path": "looked-at.toml", "text": text})[1]
    rig = ask("GET", "/api/rig?name=looked-at.toml")[1]
    asked = RUN | {"rig": "looked-at.toml", "title": "looked at", "digest": rig["digest"]}
    heavier = text.replace('mass = "16 kg"', 'mass = "20 kg"')
    assert heavier != text
    assert (
        ask(
            "PUT",
            "/api/file",
            {"path": "looked-at.toml", "text": heavier, "was": written["digest"]},
        )[0]
        == 200
    )
    status, answer = ask("POST", "/api/keep", asked)
    assert (status, answer["error"]["what"]) == (409, "the file has changed since it was loaded")
    assert not (ask.folder / "runs" / "looked at.nc").exists()
    now = ask("GET", "/api/rig?name=looked-at.toml")[1]
    assert ask("POST", "/api/keep", asked | {"digest": now["digest"]})[0] == 200


def test_only_the_numbers_that_are_drawn_are_sent(ask):
    asked = RUN | {"changes": {"strut.spring.rate": 30e3}}
    whole, arrays = ask.straight("/api/simulate", asked)
    every = {pane["name"]: pane for pane in whole["viewers"][0]["scenes"][0]["panes"]}
    content, held = ask.straight(
        "/api/simulate", asked | {"numbers": ["sprung.vz", "Δ sprung.z", "no.such"]}
    )
    panes = content["viewers"][0]["scenes"][0]["panes"]
    assert [(one["name"], one["unit"], one["words"]) for one in panes] == [
        (one["name"], one["unit"], one["words"]) for one in every.values()
    ]  # what is left out can be chosen all the same
    shown = {name for name, pane in every.items() if pane["shown"]}
    assert {pane["name"] for pane in panes if pane["curves"]} == shown | {"sprung.vz", "Δ sprung.z"}
    for pane in panes:
        for one, other in zip(
            pane["curves"], every[pane["name"]]["curves"] if pane["curves"] else [], strict=True
        ):
            assert one["label"] == other["label"]
            np.testing.assert_array_equal(held[one["y"]], arrays[other["y"]])


@pytest.mark.pages
def test_a_recording_stands_beside_a_run_on_its_time_and_as_spectra(ask):
    rig, road = (
        jn.load("kart-quarter-car"),
        jn.HalfSine(start="0.2 m", height="10 mm", length="60 mm"),
    )
    run = jn.simulate(rig, jn.Trial(road=road, speed="2 m/s", duration="0.4 s"))
    time = xr.Variable("time", run["time"].to_numpy() + 3.0, {"units": "s"})
    twice = xr.Variable("time", 2.0 * run["sprung.az"].to_numpy(), {"units": "m/s^2"})
    jn.write_recording(
        xr.Dataset({"sprung.az": twice}, coords={"time": time}), ask.folder / "late.nc"
    )
    asked = RUN | {"measured": "late.nc", "begins": "3 s", "channels": ["sprung.az"]}
    content, arrays = ask.straight("/api/simulate", asked)
    one, two = content["viewers"][0]["scenes"][0]["panes"][0]["curves"]
    assert two["label"] == "late.nc"
    both = np.isfinite(arrays[two["y"]])
    assert arrays[two["y"]][both] == pytest.approx(2.0 * arrays[one["y"]][both], abs=1e-3)
    assert both.sum() >= 0.9 * len(both)
    status, answer = ask("POST", "/api/simulate", asked | {"begins": "9 s"})
    assert (status, answer["error"]["where"]) == (422, "begins")
    content, arrays = ask.straight("/api/simulate", asked | {"spectra": True})
    scene = content["viewers"][0]["scenes"][0]
    assert (content["viewers"][0]["x"]["unit"], scene["panes"][0]["unit"]) == ("Hz", "m/s²/√Hz")
    one, two = (arrays[curve["y"]] for curve in scene["panes"][0]["curves"])
    seen = np.isfinite(two)
    assert two[seen].max() == pytest.approx(2.0 * one[seen].max(), rel=0.02)


@pytest.mark.pages
def test_of_a_long_record_every_peak_is_seen_at_every_zoom(ask):
    n = 300_000
    noise = np.random.default_rng(1).standard_normal(n)
    noise[123_456] = 50.0
    time = xr.Variable("time", np.arange(n) / 1000.0, {"units": "s"})
    record = xr.Dataset({"sprung.az": ("time", noise, {"units": "m/s^2"})}, coords={"time": time})
    record.to_netcdf(ask.folder / "long.nc", engine="h5netcdf")
    status, about = ask("GET", "/api/record?path=long.nc")
    assert (status, about["count"], about["channels"]) == (
        200,
        n,
        [{"name": "sprung.az", "unit": "m/s^2"}],
    )
    for low, high in ((None, None), (100.0, 150.0), (123.0, 124.0), (123.4559, 123.4561)):
        asked = {
            "path": "long.nc",
            "channels": ["sprung.az"],
            "low": low,
            "high": high,
            "columns": 400,
        }
        content, arrays = ask.straight("/api/record", asked)
        scene = content["viewers"][0]["scenes"][0]
        x, y = arrays[scene["x"]], arrays[scene["panes"][0]["curves"][0]["y"]]
        assert len(x) == len(y) <= 1601
        assert y.max() == 50.0
        assert x[y.argmax()] == pytest.approx(123.456, abs=2.0 * (x[-1] - x[0]) / 400 + 1e-3)
    few = noise[123_000:124_001]
    assert y.min() >= few.min()
    for wrong in ({"path": "../long.nc"}, {"channels": ["nothing"]}, {"columns": 1}):
        assert (
            ask("POST", "/api/record", {"path": "long.nc", "channels": ["sprung.az"]} | wrong)[0]
            == 422
        )
    (ask.folder / "broken.nc").write_bytes((ask.folder / "long.nc").read_bytes()[:5000])
    assert ask("GET", "/api/record?path=broken.nc")[0] == 422
    (ask.folder / "no-time.csv").write_text("a [mm], b [N]\n1, 2\n2, 3\n")
    assert "time" in str(ask("GET", "/api/record?path=no-time.csv")[1])


def test_what_a_file_was_before_it_was_saved_is_kept_and_compared(ask):
    text, was = KART, ""
    for mass in ("16 kg", "17 kg", "18 kg"):
        text = text.replace(text.split('[sprung]\nmass = "')[1].split('"')[0], mass)
        status, saved = ask("PUT", "/api/file", {"path": "kept/k.toml", "text": text, "was": was})
        assert status == 200
        was = saved["digest"]
    versions = ask("GET", "/api/versions?path=kept/k.toml")[1]
    found = [ask("GET", f"/api/rig?name={quote(one['name'])}")[1]["numbers"] for one in versions]
    masses = [
        next(one["value"] for one in numbers if one["path"] == "sprung.mass") for numbers in found
    ]
    assert masses == [17.0, 16.0]  # the newest first
    assert not any(".jounce" in entry["path"] for entry in ask("GET", "/api/project")[1]["entries"])
    for wrong in (
        "kept/k.toml@1",
        "kept/k.toml@../../secret",
        "../secret.toml@1792824586000-00000000",
        "@",
    ):
        assert ask("GET", f"/api/rig?name={quote(wrong)}")[0] == 422


def test_the_same_run_in_python_and_on_the_command_line(ask, tmp_path, monkeypatch):
    """What the page offers to copy gives what the page shows."""
    asked = {"rig": "kart-quarter-car", "changes": {"strut.spring.rate": "30 N/mm"}, "road": BUMP,
             "speed": "1.95 m/s", "duration": "0.4 s", "channels": ["sprung.az"]}  # fmt: skip
    status, answer = ask("POST", "/api/simulate", asked)
    assert status == 200
    assert [role["label"] for role in answer["viewers"][0]["roles"]] == ["changed", "as it is"]
    names: dict[str, Any] = {}
    exec(answer["python"], names)  # noqa: S102 - that is what it is for
    by_python = float(abs(names["run"]["sprung.az"]).max())
    monkeypatch.chdir(tmp_path)
    for name, text in answer["files"].items():
        Path(name).write_text(text)
    assert main(shlex.split(answer["command"])[1:]) == 0
    by_command = float(abs(jn.read_recording("run.nc")[0]["sprung.az"]).max())
    assert by_command == pytest.approx(by_python, rel=1e-9)
    pane = next(
        pane for pane in answer["viewers"][0]["scenes"][0]["panes"] if pane["name"] == "sprung.az"
    )
    changed, as_it_is = (answer["arrays"][curve["y"]] for curve in pane["curves"])
    assert changed["low"] == pytest.approx(
        float(names["run"]["sprung.az"].min()), abs=changed["step"]
    )
    assert changed["low"] != pytest.approx(as_it_is["low"], rel=1e-3)


def test_the_page_gets_the_numbers_that_scripts_get(ask):
    asked = {"rig": "kart-double-wishbone", "changes": {"hardpoints.upper_ball_joint[2]": "250 mm"}}
    asked |= {"travel": "-10 mm:10 mm:5 mm", "channels": ["camber"]}
    plain = ask("POST", "/api/kinematics", asked)[1]
    content, arrays = ask.straight("/api/kinematics", asked)
    assert {key: content[key] for key in ("python", "command", "files")} == {
        key: plain[key] for key in ("python", "command", "files")
    }
    pane = content["viewers"][0]["scenes"][0]["panes"][0]
    assert (pane["name"], [curve["label"] for curve in pane["curves"]]) == (
        "camber",
        ["changed", "as it is"],
    )
    rig = jn.load("kart-double-wishbone").with_changes({"hardpoints.upper_ball_joint[2]": 0.25})
    camber = np.degrees(jn.sweep_travel(rig, "-10 mm:10 mm:5 mm")["camber"].to_numpy())
    assert arrays[pane["curves"][0]["y"]] == pytest.approx(camber, abs=1e-12)
    drawn, packed = content["mechanisms"][0], plain["mechanisms"][0]
    for name, index in zip(drawn["names"], drawn["points"], strict=True):
        rounded = np.array(packed["points"][packed["names"].index(name)])
        assert arrays[index].reshape(-1, 3) == pytest.approx(rounded, abs=6e-4)
    assert drawn["parts"] == packed["parts"]


def test_the_mechanism_that_moves_is_the_changed_one(ask):
    asked = {"rig": "kart-double-wishbone", "travel": "-10 mm:10 mm:10 mm"}
    as_it_is = ask("POST", "/api/kinematics", asked)[1]["mechanisms"][0]
    moved = {"hardpoints.upper_ball_joint[2]": "250 mm"}
    changed = ask("POST", "/api/kinematics", asked | {"changes": moved})[1]["mechanisms"][0]
    heights = [
        one["points"][one["names"].index("upper_ball_joint")][1][2] for one in (as_it_is, changed)
    ]
    assert heights == pytest.approx([270.83, 250.0], abs=0.01)


def test_a_form_writes_values_as_they_are_typed_and_keeps_comments(ask):
    asked = {"path": "form.toml", "text": KART, "sets": [[["sprung", "mass"], "17.5 kg"]]}
    asked |= {"changes": {"hardpoints.tie_rod_inner[2]": 0.111}}
    status, form = ask("POST", "/api/form", asked)
    assert (status, form["problems"], form["model"]) == (200, [], "double-wishbone")
    changed = {line[1:] for line in form["changed"] if line.startswith("+")} - set(
        KART.splitlines()
    )
    comment = KART.split('mass = "16 kg"')[1].splitlines()[0]
    assert changed == {
        f'mass = "17.5 kg"{comment}',
        'tie_rod_inner = ["-106.1 mm", "101.6 mm", "111 mm"]',
    }
    assert form["values"]["sprung"]["mass"] == "17.5 kg"
    by_path = {number["path"]: number["value"] for number in form["rig"]["numbers"]}
    assert (by_path["sprung.mass"], by_path["hardpoints.tie_rod_inner[2]"]) == (
        17.5,
        pytest.approx(0.111),
    )
    assert not (ask.folder / "form.toml").exists()
    without = ask(
        "POST", "/api/form", asked | {"sets": [[["wheel", "width"], None]], "changes": {}}
    )[1]
    assert "width" not in without["values"]["wheel"]


def test_an_edit_is_told_in_python_and_as_a_command(ask, monkeypatch, capsys):
    """Numbers are changed and saved as here; of what is more than numbers, the saved file is shown."""
    path = "edited.toml"
    assert ask("PUT", "/api/file", {"path": path, "text": KART})[0] == 200
    head = "import jounce as jn\n\nrig = jn.load('edited.toml')"
    as_it_is = ask("POST", "/api/form", {"path": path, "text": KART})[1]
    assert as_it_is["python"] == f"{head}\nprint(rig)\n"
    changed = ask(
        "POST", "/api/form", {"path": path, "text": KART, "sets": [[["sprung", "mass"], "17.5 kg"]]}
    )[1]
    assert changed["python"].startswith(f"{head}.with_changes({{'sprung.mass': 17.5}})\n")
    monkeypatch.chdir(ask.folder)
    exec(changed["python"], {})  # noqa: S102 - that is what it is for
    assert jn.load(path) == jn.load(ask.folder / path)
    assert (
        ask("POST", "/api/form", {"path": path, "text": changed["text"]})[1]["python"]
        == f"{head}\nprint(rig)\n"
    )
    assert changed["command"] == ""  # which checks what is saved
    changed = ask("POST", "/api/form", {"path": path, "text": (ask.folder / path).read_text()})[1]
    assert main(shlex.split(changed["command"])[1:]) == 0
    assert path in capsys.readouterr().out
    other = ask(
        "POST", "/api/form", {"path": path, "text": KART, "sets": [[["source"], "measured"]]}
    )[1]
    unsaved = ask("POST", "/api/form", {"path": "nowhere-yet.toml", "text": KART})[1]
    assert all("once it is saved" in one["python"] for one in (other, unsaved))


@pytest.mark.parametrize("name", sorted(library()))
def test_an_edit_in_python_is_that_of_the_page(tmp_path, monkeypatch, name):
    """Of every shipped file, those of cars among them that name their corners."""
    text = library()[name].read_text(encoding="utf-8")
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")
    path, value = next(
        (path, value)
        for path, value in jn.load(name).parameters().items()
        if value and path.endswith(("mass", "spring.rate"))  # axles of the K&C rig have no mass
    )
    form = forms.form_of(Project(tmp_path), "mine.toml", text, (), {path: 1.01 * value})
    monkeypatch.chdir(tmp_path)
    exec(form.python, {})  # noqa: S102 - that is what it is for
    (tmp_path / "typed.toml").write_text(form.text, encoding="utf-8")
    assert jn.load("mine.toml") == jn.load("typed.toml") != jn.load(name)
    assert text.splitlines()[0] in (tmp_path / "mine.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("sets", "text", "path", "told"),
    [
        ([[["sprung", "mass"], "17 mm"]], KART, "sprung.mass", "kg"),
        (
            [[["hardpoints", "tie_rod_inner", 2], "1 kg"]],
            KART,
            "hardpoints.tie_rod_inner[2]",
            "unit",
        ),
        ([[["strut", "spring", "rat"], 1]], KART, "strut.spring.rat", "unknown key"),
        ([], KART.replace('side = "left"', 'side = "lefft"'), "side", "lefft"),
        ([], KART + "\nx ==", "", "TOML"),
        ([], "", "", "schema"),
    ],
    ids=["unit", "a list of", "key", "word", "no TOML", "empty"],
)
def test_errors_of_a_form_say_at_which_value(ask, sets, text, path, told):
    status, form = ask("POST", "/api/form", {"path": "form.toml", "text": text, "sets": sets})
    assert status == 200
    assert form["problems"][0]["path"] == path
    assert told in form["problems"][0]["text"]
    assert form["rig"] is None


@pytest.mark.parametrize("path", ["../form.toml", "/etc/form.toml", "link.toml"])
def test_forms_are_of_the_project(ask, path):
    status, answer = ask("POST", "/api/form", {"path": path, "text": KART})
    assert status == 422 if path != "link.toml" else status in (200, 422)
    assert "secret" not in str(answer).replace("secret.toml", "")


def test_poses_that_nobody_waits_for_are_counted_before_they_are_computed(ask, monkeypatch):
    for name in ("sweep_travel", "sweep_rack", "sweep_roll"):
        monkeypatch.setattr(jn, name, lambda *_, **__: pytest.fail("computed"))
    for over, text in (
        ("travel", "-20 mm:20 mm:0.05 mm"),
        ("rack", "-4 mm:4 mm:1 um"),
        ("roll", "-4 deg:4 deg:1 mdeg"),
    ):
        status, answer = ask(
            "POST", "/api/kinematics", {"rig": "kart-double-wishbone", "over": over, over: text}
        )
        assert (status, answer["error"]["where"]) == (422, over)
        assert "400" in answer["error"]["allowed"]


def test_a_road_whose_file_was_changed_is_driven_anew(ask):
    road = {"kind": "table", "file": str(ask.folder / "course.csv")}
    asked = RUN | {
        "road": {"kind": "train", "of": road, "count": 2, "pitch": "1 m"},
        "channels": ["sprung.az"],
    }
    tops = []
    for height in (10, 20):
        (ask.folder / "course.csv").write_text(
            f"x [m],z [mm]\n0,0\n0.1,0\n0.2,{height}\n0.3,0\n0.4,0\n"
        )
        content, arrays = ask.straight("/api/simulate", asked)
        tops.append(
            float(
                np.nanmax(arrays[content["viewers"][0]["scenes"][0]["panes"][0]["curves"][0]["y"]])
            )
        )
    assert tops[1] > 1.5 * tops[0]


def test_what_is_not_saved_yet_is_swept_beside_what_is(ask):
    (ask.folder / "swept.toml").write_text(KART)
    moved = KART.replace('upper_ball_joint = ["-9.8 mm", "303.25 mm", "270.83 mm"]',
                         'upper_ball_joint = ["-9.8 mm", "303.25 mm", "260 mm"]')  # fmt: skip
    asked = {
        "rig": "swept.toml",
        "text": moved,
        "travel": "-10 mm:10 mm:10 mm",
        "channels": ["camber"],
    }
    content, arrays = ask.straight("/api/kinematics", asked | {"against": "formula-student-front"})
    pane = content["viewers"][0]["scenes"][0]["panes"][0]
    assert [curve["label"] for curve in pane["curves"]] == [
        "changed",
        "as it is",
        "formula-student-front",
    ]
    for curve, rig in zip(
        pane["curves"], ("moved", "kart-double-wishbone", "formula-student-front"), strict=True
    ):
        given = jn.load("kart-double-wishbone").with_changes(
            {"hardpoints.upper_ball_joint[2]": 0.26}
        )
        swept = jn.sweep_travel(given if rig == "moved" else jn.load(rig), "-10 mm:10 mm:10 mm")
        assert arrays[curve["y"]] == pytest.approx(
            np.degrees(swept["camber"].to_numpy()), abs=1e-4
        )  # rounding is drawn as zero


@pytest.mark.parametrize(
    ("over", "body", "channel"),
    [
        ("rack", {"rack": "-4 mm:4 mm:2 mm", "travel": "5 mm"}, "steer"),
        ("roll", {"roll": "-2 deg:2 deg:1 deg"}, "roll_centre_height"),
        ("travel", {"travel": "-10 mm:10 mm:5 mm", "rack": "2 mm"}, "camber"),
    ],
)
def test_sweeps_over_travel_rack_and_roll_are_those_of_python_and_command(
    ask, tmp_path, monkeypatch, over, body, channel
):
    asked = {"rig": "kart-double-wishbone", "over": over, "channels": [channel], **body}
    content, arrays = ask.straight("/api/kinematics", asked)
    scene = content["viewers"][0]["scenes"][0]
    assert scene["motion"] is not None
    names: dict[str, Any] = {}
    exec(content["python"], names)  # noqa: S102 - that is what it is for
    by_python = names["curves"][channel].to_numpy()
    factor = {"rad": 180.0 / np.pi, "m": 1e3}[names["curves"][channel].attrs["units"]]
    assert arrays[scene["panes"][0]["curves"][0]["y"]] == pytest.approx(
        factor * by_python, rel=1e-9, abs=1e-4
    )
    monkeypatch.chdir(tmp_path)
    assert main([*shlex.split(content["command"])[1:-1], "curves.nc"]) == 0
    with xr.open_dataset("curves.nc", engine="h5netcdf") as written:
        assert written[channel].to_numpy() == pytest.approx(by_python, rel=1e-9, abs=1e-12)
    every = ask.straight("/api/kinematics", asked | {"channels": []})[0]["viewers"][0]["scenes"][0][
        "panes"
    ]
    shown = [pane["name"] for pane in every]
    assert sorted(shown) == sorted(
        map(str, names["curves"].data_vars)
    )  # each once, and none besides
    assert shown[0] == ("left.camber" if over == "roll" else "camber")


def test_targets_stand_in_the_units_of_their_curves(ask):
    target = {
        "quantity": "camber",
        "value": "-1 deg",
        "tolerance": "0.5 deg",
        "over": "-10 mm:10 mm:10 mm",
    }
    other = target | {"value": "0 kg"}
    asked = {"rig": "kart-double-wishbone", "travel": "-10 mm:10 mm:10 mm", "targets": [target]}
    content, _ = ask.straight("/api/kinematics", asked)
    band = content["targets"][0]
    assert (band["quantity"], band["at"]) == ("camber", pytest.approx([-10.0, 0.0, 10.0]))
    assert (band["low"], band["high"]) == (pytest.approx([-1.5] * 3), pytest.approx([-0.5] * 3))
    study = 'schema = "jounce.design/1"\nrig = "kart-double-wishbone"\n'
    study += '[[free]]\npoint = "hardpoints.tie_rod_inner[2]"\nwithin = "10 mm"\n'
    study += '[[target]]\nquantity = "camber"\nat_least = "-2 deg"\ntolerance = "0.1 deg"\nat = "10 mm"\n'
    (ask.folder / "study.toml").write_text(study)
    band = ask.straight("/api/kinematics", asked | {"targets": [], "study": "study.toml"})[0][
        "targets"
    ][0]
    assert (band["low"], band["high"]) == (pytest.approx([-2.1]), [None])
    status, answer = ask("POST", "/api/kinematics", asked | {"targets": [other]})
    assert status == 422
    assert "target[0].value" in answer["error"]["text"]


def test_centres_are_those_of_the_catalogue(ask):
    content, _ = ask.straight(
        "/api/kinematics", {"rig": "formula-student-front", "travel": "-10 mm:10 mm:10 mm"}
    )
    rows = jn.sweep_travel(jn.load("formula-student-front"), "-10 mm:10 mm:10 mm", points=True)
    front = 1e3 * np.stack([rows["instant_centre_y"], rows["instant_centre_z"]], axis=1)
    assert np.array(content["centres"]["front"]) == pytest.approx(front, abs=0.01)
    height = 1e3 * (rows["contact_point.z"] + rows["roll_centre_height"])
    assert [place[1] for place in content["centres"]["roll"]] == pytest.approx(
        height.to_numpy(), abs=0.01
    )


@pytest.mark.parametrize(
    ("question", "body", "told"),
    [
        ("simulate", RUN | {"rig": "kart-quarter"}, "kart-quarter-car"),
        ("simulate", RUN | {"road": {"kind": "wave"}}, "kind of road"),
        ("simulate", RUN | {"road": BUMP | {"height": "10 kg"}}, "height"),
        ("simulate", RUN | {"speed": "2 kg"}, "speed"),
        ("simulate", RUN | {"duration": "3 days"}, "too long"),
        ("simulate", RUN | {"changes": {"strut.spring": 1}}, "strut.spring"),
        ("kinematics", {"rig": "kart-quarter-car", "travel": "-20 mm:20 mm:2 mm"}, "no kinematics"),
        ("kinematics", {"rig": "kart-double-wishbone", "travel": "-20:20:2"}, "20 m"),
        ("kinematics", {"rig": "kart-double-wishbone", "travel": "-20 mm:20 mm:2 mm", "more": 1}, "more"),
        ("kinematics", {"rig": "kart-double-wishbone", "travel": "-20 mm:20 mm:0.1 um"}, "too many poses"),
    ],
    ids=str,
)  # fmt: skip
def test_bad_questions_get_one_clear_message(ask, question, body, told):
    status, answer = ask("POST", f"/api/{question}", body)
    assert status == 422
    assert told in str(answer)
    assert "Traceback" not in str(answer)


def test_long_requests_are_refused_before_they_are_read(ask):
    assert ask("PUT", "/api/file", None, Content_Length="4000001")[0] == 413
    assert (
        ask("PUT", "/api/file", {"path": "long.toml", "text": "#" * 2_100_000, "was": ""})[0] == 409
    )
    assert not (ask.folder / "long.toml").exists()
    with socket.create_connection(("127.0.0.1", ask.port), timeout=10) as plain:
        plain.sendall(
            f"GET /api/health HTTP/1.1\r\nHost: 127.0.0.1:{ask.port}\r\nContent-Length: x\r\n\r\n".encode()
        )
        assert plain.recv(100).split()[1] == b"400"


def test_no_folder_no_port(tmp_path):
    with pytest.raises(DescriptionError, match="not a folder"):
        serve(tmp_path / "nowhere")
    with pytest.raises(OutputError, match="no such port"):
        serve(tmp_path, port=70000)
    taken = serving._listening(0)
    try:
        with pytest.raises(OutputError, match="the port is not available"):
            serve(tmp_path, port=taken.getsockname()[1])
    finally:
        taken.close()


@pytest.mark.skipif(sys.platform == "win32", reason="there a port is free at once")
def test_a_port_can_be_had_again_at_once():
    """What ends a connection first keeps its port for a minute: a server that was ended, with a page open."""
    first = serving._listening(0)
    port = first.getsockname()[1]
    with socket.create_connection(("127.0.0.1", port)):
        first.accept()[0].close()
        first.close()
    serving._listening(port).close()


def test_connections_send_at_once():
    """Else an answer of two packets waits for word of the first, 40 ms; whoever serves sees how its end was set."""
    listening = serving._listening(0)
    seen = []

    def met(_, writer):
        seen.append(
            writer.get_extra_info("socket").getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)
        )
        writer.close()

    async def asked():
        async with await asyncio.start_server(met, sock=listening):
            reader, writer = await asyncio.open_connection(*listening.getsockname())
            await reader.read()
            writer.close()

    asyncio.run(asked())
    assert [bool(one) for one in seen] == [True]


def test_what_lies_in_a_project_is_known_by_its_content(tmp_path):
    rig = 'schema = "jounce.rig/1"'
    for name, text in {
        "rig.toml": rig, "road.toml": 'kind = "half-sine"', "x.toml": "a = 1", "run.csv": "t,x",
        "notes.txt~": "", ".hidden/rig.toml": rig, "out/results.json": "{}", "out/report.html": "",
    }.items():  # fmt: skip
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    found = {entry.path: entry.kind for entry in Project(tmp_path).entries()}
    described = {"rig.toml": "rig", "road.toml": "road", "run.csv": "record"}
    assert found == {**described, "out/results.json": "results", "out/report.html": "page"}


@pytest.mark.parametrize("name", sorted(library()))
def test_rigs_with_hardpoints_are_known_by_their_text(tmp_path, name):
    text = library()[name].read_text(encoding="utf-8")
    (tmp_path / "rig.toml").write_text(
        f"# hardpoints = none\n{text}" + "\n" * 100_000, encoding="utf-8"
    )
    (entry,) = Project(tmp_path).entries()
    table = tomllib.loads(text)
    is_corner = entry.kind == "rig" and table["model"] not in ("solid-axle", "twist-beam")
    assert entry.has_hardpoints == (is_corner and "hardpoints" in table)
    assert entry.is_dependent == (table["model"] in ("solid-axle", "twist-beam"))


def test_whether_a_rig_has_hardpoints_is_asked_of_what_it_is_now(tmp_path):
    file, head = tmp_path / "rig.toml", 'schema = "jounce.rig/1"\n'
    texts = {
        "": False,
        "'hardpoints' = {}\n": True,
        "hardpoints = [\n": False,
        'x = "[hardpoints]"\n': False,
    }
    for text, has in texts.items():
        file.write_text(head + text)
        (entry,) = Project(tmp_path).entries()
        assert entry.has_hardpoints is has


def test_what_a_sweep_wrote_is_one_entry_with_how_far_it_is(tmp_path):
    for name, suffix, shards in (("swept", "nc", 3), ("swept.zarr", "json", 2)):
        folder = tmp_path / name
        (folder / "shards").mkdir(parents=True)
        about = {
            "schema": SCHEMA,
            "count": 50,
            "shard": 20,
            "study": {},
            "format": folder.suffix[1:] or "netcdf",
        }
        (folder / "sweep.json").write_text(json.dumps(about))
        (folder / "report.html").write_text("")
        (folder / "study.toml").write_text('schema = "jounce.sweep/1"')
        (folder / "sprung.az").mkdir()
        (folder / "sprung.az" / ".zarray").write_text("{}")
        (folder / "sprung.az" / "a.csv").write_text("t,x")  # in an array of a group: nobody's file
        for i in range(shards):
            (folder / "shards" / f"{i:06d}.{'0' * 32}.{suffix}").write_text("12345")
    (tmp_path / "swept" / "mine").mkdir()
    (tmp_path / "swept" / "mine" / "run.csv").write_text("t,x")
    found = {one.path: one for one in Project(tmp_path).entries()}
    assert {path: one.kind for path, one in found.items()} == {
        "swept": "swept", "swept/report.html": "page", "swept/mine/run.csv": "record",
        "swept.zarr": "swept", "swept.zarr/report.html": "page",
    }  # fmt: skip
    assert [(found[name].finished, found[name].count) for name in ("swept", "swept.zarr")] == [
        (3, 3),
        (2, 3),
    ]
    assert found["swept"].size == sum(
        one.stat().st_size for one in (tmp_path / "swept").rglob("*") if one.is_file()
    )


def test_the_command_prints_one_line_and_ends_when_it_is_told(tmp_path):
    command = [sys.executable, "-m", "jounce", "serve", str(tmp_path), "--no-open", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as started:
        assert started.stdout is not None
        line = json.loads(started.stdout.readline())
        assert line["url"].startswith("http://127.0.0.1:")
        assert line["token"] in line["url"]
        started.terminate()


@pytest.mark.pages
@pytest.mark.parametrize(("width", "scheme"), [(1280, "light"), (390, "dark")])
def test_a_rig_is_started_driven_and_swept_in_the_browser(ask, browser, width, scheme):
    context = browser.new_context(viewport={"width": width, "height": 720}, color_scheme=scheme)
    page = context.new_page()
    troubles: list[str] = []
    asked: list[str] = []
    page.on(
        "console", lambda message: troubles.append(message.text) if message.type != "log" else None
    )
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))

    def ready(name: str) -> None:
        page.wait_for_selector(f"html[data-ready={name}]", timeout=60_000)
        assert page.evaluate("document.documentElement.scrollWidth") <= width

    page.goto(f"http://127.0.0.1:{ask.port}/?token={TOKEN}")
    ready("project")
    assert TOKEN not in page.url
    name = f"kart-{width}.toml"
    page.get_by_label("Shipped rig").select_option("kart-double-wishbone")
    page.get_by_label("Name of your file").fill(name)
    page.get_by_role("button", name="Copy into this project").click()
    ready("rig")
    assert (ask.folder / name).is_file()

    text = page.get_by_label(f"text of {name}")
    assert page.get_by_role("button", name="Save").is_disabled()
    right = text.input_value()
    text.fill(right.replace('side = "left"', 'side = "lefft"'))
    page.get_by_role("alert").first.wait_for()
    assert "lefft" in page.get_by_role("alert").first.inner_text()
    text.fill(right)
    page.get_by_text("no problems found").wait_for()
    assert page.get_by_role("button", name="Save").is_disabled()

    mass = page.get_by_label("mass", exact=True).first
    mass.fill("17 mm")
    mass.press("Tab")
    page.get_by_text("a unit that converts to kg").first.wait_for()
    assert page.get_by_label("mass", exact=True).first.get_attribute("aria-invalid") == "true"
    page.get_by_role("button", name="Undo").click()
    page.get_by_text("no problems found").wait_for()
    assert text.input_value() == right
    page.get_by_label("Hardpoint", exact=True).select_option("tie_rod_inner")
    page.get_by_label("z [mm]", exact=True).fill("111")
    page.get_by_label("z [mm]", exact=True).press("Tab")
    page.get_by_role("button", name="Save").click()
    added = page.locator(".difference .added")
    assert added.inner_text().startswith('+tie_rod_inner = ["-106.1 mm", "101.6 mm", "111 mm"]')
    page.get_by_role("button", name="Write to the file").click()
    page.get_by_text("Saved.").wait_for()
    wanted = right.replace('tie_rod_inner = ["-106.1 mm", "101.6 mm", "110 mm"]',
                           'tie_rod_inner = ["-106.1 mm", "101.6 mm", "111 mm"]')  # fmt: skip
    assert (ask.folder / name).read_text() == wanted

    page.get_by_role("link", name="Drive over an obstacle").click()
    ready("trial")
    page.wait_for_selector(".player .u-over", timeout=60_000)
    page.get_by_label("strut.spring.rate [N/mm]", exact=True).press("ArrowRight")
    page.get_by_role("button", name="as it is").wait_for()
    assert "strut.spring.rate=" in page.get_by_label("The same on the command line").inner_text()
    page.get_by_label("Speed", exact=True).fill("2 kg")
    page.get_by_label("Speed", exact=True).press("Tab")
    page.get_by_text("wrong unit").wait_for()
    page.get_by_label("Speed", exact=True).fill("3 m/s")
    page.get_by_label("Speed", exact=True).press("Tab")
    page.get_by_text("computed and drawn").wait_for()

    page.get_by_role("link", name="Kinematics").first.click()
    ready("kinematics")
    page.get_by_text("curves computed and drawn").wait_for(timeout=60_000)
    page.get_by_label("hardpoints.upper_ball_joint[2] [mm]", exact=True).press("ArrowRight")
    page.get_by_text("as it is (dashed)").wait_for()
    camber = page.locator("figure", has_text="camber").first
    before = camber.locator("output").inner_text()
    page.get_by_label("Wheel travel, bump positive [mm], typed").fill("10")
    assert camber.locator("output").inner_text() != before
    page.get_by_label("Value", exact=True).fill("0 deg")
    page.get_by_label("Quantity").select_option("camber")
    page.get_by_label("Tolerance", exact=True).fill("20 deg")
    page.get_by_label("Tolerance", exact=True).press("Enter")
    page.locator("figure.wanted .verdict.good").wait_for()
    reach = page.get_by_label("Wheel travel, bump positive: first:last:step")
    whole = reach.input_value()
    for text, mark in (("-10 mm:10 mm:5 mm", "?"), (whole, "✓")):  # what is not swept is not judged
        reach.fill(text)
        reach.press("Tab")
        page.locator("figure.wanted .verdict", has_text=mark).wait_for()
    page.get_by_label("Curves over").select_option("roll")
    page.locator("figure", has_text="roll centre height").first.wait_for()
    for label in ("tie rod inner", "tie rod outer", "strut top"):
        page.get_by_label(label, exact=True).set_checked(label == "strut top")
    dark = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(21, 25, 29)"
    assert dark == (scheme == "dark")
    context.close()
    assert [one for one in troubles if "422" not in one] == []  # the browser tells refusals, too
    assert [
        url
        for url in asked
        if not url.startswith((f"http://127.0.0.1:{ask.port}/", "data:", "blob:"))
    ] == []


def test_long_runs_are_kept_only_while_there_is_room(ask, monkeypatch):
    from jounce.web import answers

    monkeypatch.setattr(answers, "_DONE", type(answers._DONE)())
    monkeypatch.setattr(answers, "_MOST_DONE", 4)
    speeds = ("1 m/s", "2 m/s", "3 m/s", "4 m/s", "5 m/s")
    for speed in speeds:
        assert ask("POST", "/api/simulate", RUN | {"speed": speed})[0] == 200
    assert len(answers._DONE) == 4
    monkeypatch.setattr(answers, "_LARGEST_DONE", 2 * next(iter(answers._DONE.values()))[1])
    assert ask("POST", "/api/simulate", RUN | {"speed": "6 m/s"})[0] == 200
    assert len(answers._DONE) == 2


@pytest.mark.skipif(
    sys.platform != "linux" or not hasattr(ctypes.CDLL(None), "mallopt"),
    reason="only glibc can be told so",
)
def test_what_a_request_has_freed_is_given_back():
    """Pieces of a megabyte, one in fifty of which stays: glibc keeps all of them where larger ones were freed once."""
    script = """
import sys
import numpy as np
from jounce.web.memory import give_memory_back
if sys.argv[1:]:
    give_memory_back()
held = lambda: int(open("/proc/self/statm").read().split()[1]) * 4096e-6
del (large := [np.ones(4_000_000)])[:]
before = held()
pieces = [np.ones(125_000) for _ in range(100)]
stay = pieces[49::50]
del pieces
print(held() - before)
"""
    given, kept = (
        float(
            subprocess.run(
                [sys.executable, "-c", script, *words], capture_output=True, text=True, check=True
            ).stdout
        )
        for words in (["give"], [])
    )
    assert given < 10.0
    assert kept > 30.0  # or there would be nothing to do


def test_a_server_keeps_few_models_and_collects_in_pauses_until_it_ends(monkeypatch):
    monkeypatch.setattr(serving, "_PAUSE", 0.01)
    monkeypatch.setattr(serving, "_IDLE", 10.0)  # the test's own work is no pause's end
    monkeypatch.setattr(serving, "_BUSY", 0.0)
    monkeypatch.setattr(serving, "_USED", 0.0)
    given_back, before = threading.Event(), Recent.most
    with serving._within_bounds(given_back.set):
        assert Recent.most == serving._MOST_MODELS < before
        assert given_back.wait(30.0)
        [collecting] = [one for one in threading.enumerate() if one.name == "pauses"]
    collecting.join(30.0)
    assert not collecting.is_alive()
    assert Recent.most == before


def test_a_server_loads_in_its_first_pauses_what_first_answers_would_wait_for(
    monkeypatch, tmp_path
):
    (tmp_path / "needed_by_an_answer.py").write_text("")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(serving, "_PAUSE", 0.01)
    monkeypatch.setattr(serving, "_IDLE", 10.0)
    monkeypatch.setattr(serving, "_BUSY", 0.0)
    monkeypatch.setattr(serving, "_USED", 0.0)
    assert all(importlib.util.find_spec(name) for name in serving._LATER)
    monkeypatch.setattr(serving, "_LATER", ("needed_by_an_answer",))
    given_back = threading.Event()
    with serving._within_bounds(given_back.set):
        assert given_back.wait(30.0)
        assert sys.modules.pop("needed_by_an_answer")


def test_a_server_ends_after_what_it_loads_and_not_within(monkeypatch, tmp_path):
    """The end of the process would cut off the import, which prints a traceback."""
    (tmp_path / "slow_to_load.py").write_text(
        "import sys, time\nsys.begun.set()\ntime.sleep(0.3)\nis_whole = True\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "begun", threading.Event(), raising=False)
    monkeypatch.setattr(serving, "_PAUSE", 0.01)
    monkeypatch.setattr(serving, "_IDLE", 10.0)
    monkeypatch.setattr(serving, "_LATER", ("slow_to_load",))
    with serving._within_bounds(lambda: None):
        assert sys.begun.wait(30.0)
    assert sys.modules.pop("slow_to_load").is_whole


def test_a_server_at_work_is_not_stopped_to_look_for_garbage(monkeypatch):
    monkeypatch.setattr(serving, "_PAUSE", 0.01)
    monkeypatch.setattr(serving, "_IDLE", -1.0)  # never idle
    monkeypatch.setattr(serving, "_BUSY", 0.0)
    monkeypatch.setattr(serving, "_USED", 0.0)
    given_back = threading.Event()
    with serving._within_bounds(given_back.set):
        assert not given_back.wait(0.1)


@pytest.mark.parametrize(
    ("message", "error", "is_said"),
    [
        ("Exception in ASGI application\n", asyncio.CancelledError("Task cancelled"), False),
        ("Cancel %s running task(s), timeout graceful shutdown exceeded", None, False),
        ("Exception in ASGI application\n", ValueError("a mistake of ours"), True),
        ("[Errno 98] address already in use", None, True),
    ],
)
def test_a_server_that_ends_says_nothing_of_requests_that_it_cuts_off(
    message, error, is_said
) -> None:
    """Ctrl-C while a campaign was begun printed fifty lines of calls."""
    about = (type(error), error, None) if error else None
    record = logging.LogRecord(
        "uvicorn.error", logging.ERROR, "", 1, message, (1,) if "%" in message else (), about
    )
    assert serving._is_trouble(record) is is_said
