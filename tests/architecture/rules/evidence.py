"""What tests hold against sources outside of jounce: seen while they run, and kept for the page on validation.

A test that is marked ``source`` is watched: every number that it holds against ``pytest.approx`` or
``numpy.testing.assert_allclose`` is counted, and the one that takes the largest share of what is allowed is kept in
``docs/explanation/validation.json``, from which the page is written. A later run fails where a test is not on the page,
says something else than the page, agrees worse than it, compares less or allows more. ``make validation`` writes.
"""

from __future__ import annotations

import contextlib
import json
import math
import re
import time
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
import pytest

ROOT = Path(__file__).parents[3]
FILE = ROOT / "docs" / "explanation" / "validation.json"
KINDS = ("measured", "published", "program", "computed")
CAPABILITIES = (
    "mechanisms in space",
    "suspension kinematics",
    "quarter car",
    "half car",
    "ride and roughness",
    "control",
    "testers and inspection",
    "bench",
    "signals and identification",
    "many runs",
    "files of other makers",
    "models for other programs",
)
ROUNDING = 0.02  # share of what is allowed below which machines may differ as they like
LAST_BITS = (
    16 * np.finfo(float).eps
)  # of numbers of about 1: another library's norm moves an angle by some of these
SLACK = 1.25  # by how much more than kept an agreement may take elsewhere: other processors, other libraries
WIDER = 1.01  # by how much more than kept may be allowed: tolerances are relative to what other libraries may compute


class Seen:
    """The comparisons of one test: how many numbers, the most that is allowed, and the one that takes most of it."""

    def __init__(self) -> None:
        self.count, self.room = 0, 0.0
        self.worst: dict[str, float] = {"ours": 0.0, "theirs": 0.0, "allowed": 0.0, "share": -1.0}

    def note(self, ours: Any, theirs: Any, allowed: Any) -> None:
        """Look at numbers of any shape; what is no number is not looked at."""
        if isinstance(theirs, dict):
            for key in theirs:
                self.note(ours[key], theirs[key], allowed(theirs[key]))
            return
        try:
            a, b = (
                np.asarray(ours, dtype=complex).ravel(),
                np.asarray(theirs, dtype=complex).ravel(),
            )
        except (TypeError, ValueError):
            return
        if a.size == 0 or (a.size != b.size and 1 not in {a.size, b.size}):
            return
        room = np.broadcast_to(
            np.asarray(allowed(b.reshape(np.shape(theirs))), dtype=float).ravel(), b.shape
        )
        a, b, room = np.broadcast_arrays(a, b, room)
        with np.errstate(divide="ignore", invalid="ignore"):
            off = np.abs(a - b)
            share = np.where(off == 0.0, 0.0, off / room)
        self.count += a.size
        self.room = max(self.room, float(np.max(np.where(np.isfinite(room), room, 0.0))))
        place = int(np.argmax(np.where(np.isfinite(share), share, -1.0)))
        if share[place] > self.worst["share"]:
            values = {
                "ours": _plain(a[place]),
                "theirs": _plain(b[place]),
                "allowed": float(room[place]),
            }
            self.worst = values | {"share": float(share[place])}

    @contextlib.contextmanager
    def watching(self) -> Iterator[None]:
        """Look at every comparison that is made."""
        approx, allclose, seen = pytest.approx, np.testing.assert_allclose, self

        class Watched:
            """What ``pytest.approx`` gives, which tells what it is compared with."""

            __array_ufunc__ = None
            __array_priority__ = 100
            __hash__ = None  # type: ignore[assignment]

            def __init__(
                self, expected: Any, rel: Any = None, abs: Any = None, nan_ok: bool = False
            ) -> None:
                self.expected, self.rel, self.abs = expected, rel, abs
                self.real = approx(expected, rel=rel, abs=abs, nan_ok=nan_ok)

            def allowed(self, expected: Any) -> Any:
                least = 1e-12 if self.abs is None else float(self.abs)
                relative = (
                    (1e-6 if self.abs is None else 0.0) if self.rel is None else float(self.rel)
                )
                return np.maximum(least, relative * np.abs(np.asarray(expected, dtype=complex)))

            def __eq__(self, other: object) -> bool:
                is_close = bool(self.real == other)
                if is_close:  # what is not fails the test, or chooses between cases
                    seen.note(other, self.expected, self.allowed)
                return is_close

            def __repr__(self) -> str:
                return repr(self.real)

        def close(
            actual: Any, desired: Any, rtol: float = 1e-7, atol: float = 0.0, **other: Any
        ) -> None:
            seen.note(actual, desired, lambda b: atol + rtol * np.abs(b))
            allclose(actual, desired, rtol=rtol, atol=atol, **other)

        with (
            mock.patch.object(pytest, "approx", Watched),
            mock.patch.object(np.testing, "assert_allclose", close),
        ):
            yield


def _plain(value: complex) -> float:
    return float(value.real if value.imag == 0.0 else abs(value))


def told(item: pytest.Item) -> dict[str, str] | None:
    """What the nearest mark of a test says of its source; nothing where there is none, or ``no_source`` is nearer."""
    for marker in item.iter_markers():
        if marker.name == "no_source":
            return None
        if marker.name == "source":
            row = dict.fromkeys(("kind", "of", "key", "where", "tolerance", "compares"), "")
            row.update({name: str(value) for name, value in marker.kwargs.items()})
            unknown = set(row) - {"kind", "of", "key", "where", "tolerance", "compares"}
            empty = [name for name in ("kind", "of", "where", "tolerance") if not row[name]]
            empty += ["key"] if row["kind"] != "computed" and not row["key"] else []
            if unknown or empty or row["kind"] not in KINDS or row["of"] not in CAPABILITIES:
                raise pytest.UsageError(
                    f"{item.nodeid}: mark `source`: unknown {unknown}, missing {empty}, or a kind"
                )
            row["compares"] = row["compares"] or _words(item)
            return row
    return None


NAMES = "ADAMS Butterworth CFC EUSAMA Exudyn Froude Hz Ishigami SI SciPy Wk kHz mm"
_NAMES = {name.lower(): name for name in NAMES.split()} | {
    "paper s": "paper's",
    "0 0965": "0.0965",
    "1 751": "1.751",
}


def _words(item: pytest.Item) -> str:
    name = (
        str(getattr(item, "originalname", None) or item.name)
        .removeprefix("test_")
        .replace("_", " ")
    )
    return re.sub(rf"\b({'|'.join(_NAMES)})\b", lambda found: _NAMES[found[0]], name)


def name_of(item: pytest.Item) -> str:
    """A test without its parameters."""
    return item.nodeid.partition("[")[0]


def kept() -> dict[str, dict[str, Any]]:
    """What the page says, by test."""
    if not FILE.is_file():
        return {}
    rows: list[dict[str, Any]] = json.loads(FILE.read_text(encoding="utf-8"))["tests"]
    return {row["test"]: row for row in rows}


class Evidence:
    """The plugin: watches marked tests, and holds them against what is kept or keeps it anew."""

    def __init__(self, *, writes: bool) -> None:
        self.writes, self.kept = writes, kept()
        self.found: dict[str, dict[str, Any]] = {}

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item: pytest.Item) -> Generator[None, object, object]:
        row = told(item)
        if row is None:
            return (yield)
        seen, begun = Seen(), time.process_time()
        with seen.watching():
            result = yield
        self.look(item, row, seen, time.process_time() - begun)
        return result

    def look(self, item: pytest.Item, row: dict[str, str], seen: Seen, seconds: float) -> None:
        """Take a test that has passed to the page, or hold it against the page."""
        name = name_of(item)
        if seen.count == 0:
            pytest.fail(
                f"{name} names a source and compares no number that can be seen: use pytest.approx",
                False,
            )
        if self.writes:
            new = {"values": 0, "least": seen.count, "room": 0.0, "seconds": 0.0, "share": -1.0}
            one = self.found.setdefault(name, {"test": name, **row, **new})
            one["values"] += seen.count
            one["least"] = min(
                one["least"], seen.count
            )  # of a case; parts of the cases are run, too
            one["room"] = max(one["room"], seen.room)
            one["seconds"] += seconds
            if seen.worst["share"] > one["share"]:
                one.update(seen.worst)
            return
        problem = held(self.kept.get(name), row, seen)
        if problem:
            pytest.fail(f"{name}: {problem}; look at it, then `make validation`", False)

    def pytest_sessionfinish(self) -> None:
        if not self.writes or not self.found:
            return
        rows = {
            name: row
            for name, row in self.kept.items()
            if (ROOT / name.partition("::")[0]).is_file()
        }
        whole = {name.partition("::")[0] for name in self.found}
        rows = {
            name: row for name, row in rows.items() if name.partition("::")[0] not in whole
        } | self.found
        for row in self.found.values():
            row["seconds"] = float(f"{row['seconds']:.1g}")
            row |= {key: float(f"{row[key]:.4g}") for key in ("allowed", "share", "room")}
            row |= {key: float(f"{row[key]:.7g}") for key in ("ours", "theirs")}
        tests = [rows[name] for name in sorted(rows)]
        FILE.write_text(
            json.dumps({"tests": tests}, indent=1, allow_nan=False) + "\n", encoding="utf-8"
        )


def held(row: dict[str, Any] | None, said: dict[str, str], seen: Seen) -> str:
    """Why what a test says and finds is not what the page says; empty where it is."""
    if row is None:
        return "is not on the page of the validation"
    other = [key for key, value in said.items() if row.get(key) != value]
    if other:
        return f"says another {' and '.join(other)} than the page"
    if seen.count < row["least"]:
        return f"compares fewer numbers than the page says, {seen.count} for {row['least']}"
    if seen.room > WIDER * float(row["room"]):
        return f"allows {seen.room:.2g}, the page says {row['room']:.2g}"
    share, off = seen.worst["share"], abs(seen.worst["ours"] - seen.worst["theirs"])
    if off < LAST_BITS:
        return ""
    if not math.isfinite(share) or share > max(
        SLACK * float(row["share"]), float(row["share"]) + ROUNDING
    ):
        return f"takes {share:.2g} of what is allowed, the page says {row['share']:.2g}"
    return ""
