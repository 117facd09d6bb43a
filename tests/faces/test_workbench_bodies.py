"""Whatever is sent to the workbench, it is answered: nothing ends in an internal error, and nothing is printed."""

from __future__ import annotations

import contextlib
import copy
import http.client
import json
import logging
import socket
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest

import jounce as jn

pytest.importorskip("uvicorn")
TOKEN = "a-token-of-bodies"
BUMP = {"kind": "half-sine", "height": "10 mm", "length": "60 mm", "start": "0.2 m"}
KART = (Path(jn.__file__).parent / "parts" / "library" / "kart-quarter-car.toml").read_text()
DRIVE = {"rig": "kart-quarter-car", "changes": {"sprung.mass": 17.0}, "road": BUMP, "speed": "2 m/s",
         "duration": "0.05 s"}  # fmt: skip
TASK = {
    "kind": "decay",
    "files": ["no.csv"],
    "mass": "16 kg",
    "columns": {"time": "t"},
    "channel": "sprung.z",
}
LAYOUT = {
    "schema": "jounce.layout/1", "axis": "time", "note": "belt", "window": {"begin": 0.1, "end": 0.9},
    "recordings": [{"path": "run.csv", "shift": 0.1}], "graphs": [{"channels": ["sprung.z"]}],
    "formulas": [{"name": "rate", "text": "derivative(sprung.z)", "unit": "m/s"}],
}  # fmt: skip
BODIES: dict[tuple[str, str], list[dict[str, Any]]] = {
    ("POST", "/api/library"): [{"name": "kart-quarter-car", "path": "rig.toml"}],
    ("PUT", "/api/file"): [{"path": "rig.toml", "text": KART, "was": "0"}],
    ("POST", "/api/form"): [
        {"path": "rig.toml", "text": KART, "sets": [[["sprung", "mass"], "17 kg"]], "changes": {"sprung.mass": 18.0}}
    ],
    ("POST", "/api/record"): [
        {"path": "run.csv", "channels": ["sprung.z"], "low": 0.0, "high": 1.0, "columns": 100}
    ],
    ("POST", "/api/simulate"): [
        {**DRIVE, "text": None, "channels": ["sprung.az"], "numbers": ["sprung.z"], "measured": "", "begins": "",
         "spectra": False},
    ],
    ("POST", "/api/keep"): [{**DRIVE, "title": "run", "digest": "0"}],
    ("POST", "/api/compare"): [{"paths": ["run.csv"], "channels": ["sprung.z"]}],
    ("POST", "/api/export"): [
        {"title": "page", "subtitle": "project", "form": "csv", "scale": 2.0, "blocks": [
            {"kind": "chart", "caption": "run", "x_label": "time [s]", "x": [0.0, 1.0], "window": [0.0, 1.0],
             "columns": 1, "panels": [{"title": "force", "unit": "N", "curves": [
                 {"label": "measured", "role": "measured", "y": [1.0, None]}]}]}]},
        {"title": "page", "form": "svg", "blocks": [
            {"kind": "chart", "caption": "", "x_label": "t", "x": [0.0], "panels": [
                {"title": "f", "curves": [{"y": [1.0]}]}]}]},
        {"title": "page", "form": "html", "blocks": [
            {"kind": "heading", "text": "Modes"}, {"kind": "text", "text": "two"},
            {"kind": "table", "caption": "modes", "header": ["f"], "rows": [["1"]], "numbers": [0]}]},
    ],
    ("POST", "/api/kinematics"): [
        {"rig": "kart-double-wishbone", "changes": {"hardpoints.tie_rod_inner[2]": 0.11}, "travel": "-5 mm:5 mm:5 mm",
         "over": "travel", "rack": "1 mm", "roll": "", "against": "", "study": "", "channels": ["camber"],
         "targets": [{"quantity": "camber", "over": "-5 mm:5 mm:5 mm", "value": "0 deg", "tolerance": "1 deg"}]},
    ],
    ("POST", "/api/kc"): [
        {"rig": "semi-trailing-arm", "changes": {"strut.spring.rate": 24000.0}, "test": "bounce", "axle": "",
         "to": {"bounce": "10 mm"}, "within": {"bounce": "5 mm"}, "travel": "1 mm", "steer": "", "held": "load",
         "handwheel": "locked", "measured": [], "overview": False, "loads": True, "text": None, "channels": []},
    ],
    ("POST", "/api/points"): [
        {"rig": "kart-double-wishbone", "text": None, "changes": {"hardpoints.tie_rod_inner[2]": 0.11},
         "channels": ["camber"], "table": "point\tx\ty\tz\ntie_rod_inner\t1\t2\t3", "unit": "mm",
         "axes": "", "side": "left", "axle": "", "names": {"tie rod": "tie_rod_inner"}},
    ],
    ("POST", "/api/curve"): [
        {"table": "mm\tN\n0\t0\n10\t200", "over": "deflection", "over_unit": "mm", "force_unit": "N",
         "turned": "both", "before": [["0 mm", "10 mm"], ["0 N", "100 N"]]},
    ],
    ("POST", "/api/differences"): [{"names": ["kart-quarter-car", "audi-a6-quarter-car"]}],
    ("POST", "/api/data/curves"): [{"layout": LAYOUT, "low": 0.0, "high": 1.0, "columns": 100}],
    ("POST", "/api/data/window"): [{"layout": LAYOUT, "begin": 0.0, "end": 1.0}],
    ("POST", "/api/data/chart"): [{"layout": LAYOUT, "begin": 0.0, "end": 1.0}],
    ("POST", "/api/data/align"): [
        {"layout": LAYOUT, "reference": 0, "moved": 0, "channel": "sprung.z", "by": "correlation", "level": 0.0,
         "maximum_shift": 1.0},
    ],
    ("POST", "/api/data/state"): [{"paths": ["run.csv"]}],
    ("PUT", "/api/data/layout"): [{"layout": LAYOUT, "path": "layouts/belt.toml", "was": "0"}],
    ("POST", "/api/protocol"): [
        {"kind": "protocol", "store": "no.sqlite", "records": [1], "language": "en"},
    ],
    ("POST", "/api/campaign/files"): [
        {"campaign": "mine/campaign.toml", "new": {"rig": "kart-quarter-car", "title": "bench", "obstacle": BUMP,
         "roads": {"A": BUMP}, "changes": {"sprung.mass": "17 kg"}},
         "files": [{"use": "spring", "file": "run.csv", "state": "0", "fields": {"columns": {"force": "F"}}}]},
    ],
    ("POST", "/api/campaign/values"): [
        {"rig": "kart-quarter-car", "changes": {"sprung.mass": "17 kg"}},
    ],
    ("POST", "/api/campaign/trials"): [
        {"campaign": "mine/campaign.toml", "table": "trial\tspeed\n1\t2 m/s", "was": ""},
    ],
    ("POST", "/api/study"): [
        {"path": "study.toml", "was": "", "rig": "kart-quarter-car", "design": {"kind": "grid"}, "outputs": None,
         "trial": {"speed": "2 m/s", "duration": "0.4 s", "road": BUMP}, "metrics": ["max sprung.az"],
         "vary": {"strut.spring.rate": ["20 N/mm"]}, "control": None},
    ],
    ("POST", "/api/campaign"): [
        {"campaign": "mine/campaign.toml", "use": use, "fields": fields}
        for use, fields in {
            "spring": {"files": ["mine/bench/spring_1.csv"], "columns": {"force": "F"}, "replace": True},
            "tyre": {"files": ["mine/bench/spring_1.csv"], "pressure": "0.2 MPa"},
            "trial": {"recording": "mine/trials/02.csv", "road": "A", "speed": "2 m/s", "use": "fit"},
        }.items()
    ],
    ("POST", "/api/jobs"): [TASK],
    ("POST", "/api/jobs/none/cancel"): [{}],
    ("POST", "/api/jobs/none/again"): [{}],
    ("POST", "/api/ask"): [
        TASK,
        {"kind": "overlay", "rides": [{"vehicle": "no.toml", "changes": {"sprung.mass": 1.0}, "seed": 1}]},
        {"kind": "pareto", "vehicle": "no.toml", "free": {"sprung.mass": "10 %"}, "points": 3},
        {"kind": "evaluate", "records": ["no.csv"], "tester": "eusama", "methods": ["eusama"]},
    ],
    ("PUT", "/api/upload?path=new.csv"): [{}],
}  # fmt: skip
DEEP = 3000
ODD: dict[str, str] = {
    "null": "null", "true": "true", "text": '"x"', "empty": '""', "list": "[]", "lists": "[[[]]]", "object": "{}",
    "keys": '{"": {"": null}, "a.b[0]": [1, null]}', "zero": "0", "negative": "-1", "fraction": "0.5",
    "large": "1e308", "integer": "1" + "0" * 25, "digits": "9" * 5000, "infinite": "1e999", "NaN": "NaN",
    "Infinity": "-Infinity", "surrogate": '"\\ud800"', "pair": '"\\udc00\\ud800x"', "zero character": '"a\\u0000b"',
    "control": '"\\u0007\\u2028\\u202e"', "deep list": "[" * DEEP + "]" * DEEP,
    "deep": '{"a":' * DEEP + "1" + "}" * DEEP,
    "fifty deep": '{"a":' * 50 + "1" + "}" * 50, "long": json.dumps("x" * 100_000), "path": '"../../etc/passwd"',
    "list of null": "[null]", "list of numbers": "[1, 2.5]", "object of null": '{"a": null}', "bytes": '"\udcff"',
    "unit": '"1e400 m"', "not a number": '"nan mm"', "range": '"0:1e300:1e-300"', "percent": '"%s%n{0}"',
}  # fmt: skip
PLACE = "a place of these tests"


def places(value: Any, way: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Every place in a body, the whole of it first."""
    yield way
    for key, inner in (
        value.items()
        if isinstance(value, dict)
        else enumerate(value)
        if isinstance(value, list)
        else ()
    ):
        yield from places(inner, (*way, key))


def with_odd(body: Any, way: tuple[Any, ...], odd: str) -> bytes:
    """Give a body with a text of JSON, or what is none, in place of one value."""
    if not way:
        return odd.encode(errors="surrogateescape")
    made = copy.deepcopy(body)
    here = made
    for key in way[:-1]:
        here = here[key]
    here[way[-1]] = PLACE
    return json.dumps(made).replace(json.dumps(PLACE), odd).encode(errors="surrogateescape")


def with_odd_key(body: Any, way: tuple[Any, ...]) -> bytes:
    """Give a body with a key that is no text beside the keys of a table."""
    made = copy.deepcopy(body)
    here = made
    for key in way:
        here = here[key]
    here[PLACE] = 1
    return json.dumps(made).replace(json.dumps(PLACE), '"\\ud800"').encode()


@pytest.fixture(scope="module")
def send(workbench):
    folder, port = workbench
    (folder / "run.csv").write_text(
        "time [s],sprung.z [mm]\n" + "".join(f"{i / 50},{i % 7}\n" for i in range(60))
    )
    jn.new_campaign(folder / "mine")
    head = {"Authorization": f"Bearer {TOKEN}", "Content-Type": "application/json"}

    def send(method: str, path: str, body: bytes | None = None) -> tuple[int, bytes]:
        with contextlib.closing(
            http.client.HTTPConnection("127.0.0.1", port, timeout=300)
        ) as connection:
            connection.request(method, path, body, head)
            answer = connection.getresponse()
            return answer.status, answer.read()

    return send


def test_every_route_that_takes_a_body_is_sent_odd_ones(send):
    paths = json.loads(send("GET", "/openapi.json")[1])["paths"]
    taking = {
        (method.upper(), path)
        for path, one in paths.items()
        for method in one
        if method in ("post", "put")
    }
    assert {
        (method, path.partition("?")[0].replace("none", "{name}")) for method, path in BODIES
    } == taking


def test_of_whole_bodies_none_is_refused_as_such(send):
    """Else what is odd in them would not be reached."""
    for (method, path), bodies in BODIES.items():
        for body in bodies:
            status, answer = send(method, path, json.dumps(body).encode())
            assert status in (200, 409, 422), answer
            assert b'"detail"' not in answer, (path, answer)


@pytest.mark.parametrize("every", [5, pytest.param(1, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("method", "path"), BODIES, ids=lambda text: text.strip("/"))
def test_no_body_ends_in_an_internal_error(send, method, path, every):
    for body in BODIES[method, path]:
        for k, way in enumerate(places(body)):
            for name, odd in list(ODD.items())[k % every :: every]:
                status, answer = send(method, path, with_odd(body, way, odd))
                assert status < 500, (way, name, answer[-600:])
                if (status, path) not in {(200, "/api/export"), (200, "/api/data/curves")}:  # bytes
                    json.loads(answer, parse_constant=pytest.fail)
            here = body
            for key in way:
                here = here[key]
            if isinstance(here, dict) and method == "POST":
                assert send(method, path, with_odd_key(body, way))[0] in (400, 422), way


@pytest.mark.parametrize(
    "path",
    [
        "/api/file?path={}", "/api/versions?path={}", "/api/check?path={}", "/api/rig?name={}", "/api/schema?model={}",
        "/api/record?path={}", "/api/jobs/{}", "/api/jobs/{}/report", "/api/reports/{}", "/api/document?path={}",
        "/api/sweep?folder={}", "/api/campaign?path={}",
    ],
)  # fmt: skip
def test_no_address_ends_in_an_internal_error(send, path):
    names = ["", ".", "..", "a" * 300, "a/" * 1500, "\x00", "\ufffd", "rig.toml@", "@", "mine", "mine/", "run.csv",
             "//", "~", ".jounce", "rig.toml@1700000000000-abcdef00", "run.csv/x", "nul", "C:\\x", "\n"]  # fmt: skip
    for name in [quote(one, safe="") for one in names] + ["%ff", "%ed%a0%80", "%", "%zz", "%00"]:
        status, answer = send("GET", path.format(name))
        assert status < 500, (name, answer)


def test_an_upload_that_is_aborted_prints_nothing_and_leaves_nothing(workbench, caplog, capfd):
    folder, port = workbench
    head = f"PUT /api/upload?path=cut.csv HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nAuthorization: Bearer {TOKEN}\r\n"
    body = f"POST /api/form HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nAuthorization: Bearer {TOKEN}\r\n"
    logging.getLogger("uvicorn.error").addHandler(caplog.handler)
    try:
        for start in (head, f"{body}Content-Type: application/json\r\n"):
            for sent in (b"", b"time [s]", b"x" * 200_000):
                plain = socket.create_connection(("127.0.0.1", port), timeout=10)
                plain.sendall(f"{start}Content-Length: 1000000\r\n\r\n".encode() + sent)
                time.sleep(0.1)
                plain.close()
        time.sleep(1.0)
    finally:
        logging.getLogger("uvicorn.error").removeHandler(caplog.handler)
    assert [one.getMessage() for one in caplog.records] == []
    assert "Traceback" not in "".join(capfd.readouterr())
    assert [one.name for one in folder.rglob("*") if one.name.startswith((".jounce-", "cut"))] == []
