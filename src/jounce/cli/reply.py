"""Output of commands: one JSON object or tables, findings, errors, progress."""

from __future__ import annotations

import contextlib
import io
import json
import os
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from jounce.cli.tables import FittedTable
from jounce.core.errors import JounceError
from jounce.core.findings import DrawingError
from jounce.core.text import ESCAPES, encodable, listed_places, visible

if TYPE_CHECKING:
    from rich.console import Console
    from rich.text import Text

    from jounce.core.catalogue import Severity
    from jounce.core.findings import Finding


PIPED_WIDTH = 140
DONE, FAILED, REFUSED, PIPE_CLOSED = 0, 1, 2, 141
"""Exit codes: success; failure; invalid request; output pipe closed."""


@dataclass(frozen=True)
class Reply:
    """Output of one command."""

    plain: Mapping[str, Any]  # what --json prints: names to plain values in SI
    draw: Callable[[Console], None]  # prints the same as text on the given console
    as_json: bool = False  # which of the two is requested
    exit_code: int = DONE
    missing: Sequence[Finding] = ()  # figures that could not be drawn

    def show(self) -> int:
        """Print to stdout; return the exit code."""
        if self.as_json:
            more = (
                {"findings": [*self.plain.get("findings", ()), *self.missing]}
                if self.missing
                else {}
            )
            print_json({**self.plain, **more})
        else:
            out = console()
            self.draw(out)
            show_findings(out, self.missing)
        return max(self.exit_code, FAILED) if self.missing else self.exit_code


@contextmanager
def drawing() -> Iterator[list[Finding]]:
    """Collect the figures that cannot be drawn in a block; the results are still printed."""
    missing: list[Finding] = []
    try:
        yield missing
    except DrawingError as error:
        missing += error.findings


def console(*, stderr: bool = False) -> Console:
    """Console that prints text unchanged; piped output has wide lines to keep table rows intact."""
    from rich.console import Console
    from rich.segment import Segment

    class HonestConsole(Console):
        """Console that passes closed-pipe errors to `main` and removes terminal control sequences from text."""

        def on_broken_pipe(self) -> None:
            raise BrokenPipeError

        def render_str(self, text: str, **options: Any) -> Text:
            return super().render_str(
                visible(encodable(text, self.encoding)), **options
            )  # before its width is computed

        def render(self, renderable: Any, options: Any = None) -> Iterator[Segment]:
            for segment in super().render(renderable, options):
                steers = segment.control is not None
                yield segment if steers else Segment(visible(segment.text), segment.style)

    stream = sys.stderr if stderr else sys.stdout
    width = None if stream.isatty() or "COLUMNS" in os.environ else PIPED_WIDTH
    return HonestConsole(stderr=stderr, markup=False, highlight=False, emoji=False, width=width)


def print_json(plain: Mapping[str, Any]) -> None:
    """Print one strict JSON object to stdout; characters that the terminal cannot show are escaped."""
    from jounce.core.serialise import to_json, to_plain

    if _FOLLOWER.get() is not None:  # a page may be in German
        from jounce.core.findings import for_page

        plain = for_page(to_plain(plain))
    text = to_json(plain)
    if not _is_unicode(sys.stdout):
        text = json.dumps(json.loads(text), indent=2)
    sys.stdout.write(f"{visible(text, json=True)}\n")


def make_streams_usable() -> None:
    """Prepare the standard streams: replace closed ones, escape unsupported characters, use the terminal width."""
    for name, mode in (
        ("stdin", "r"),
        ("stdout", "w"),
        ("stderr", "w"),
    ):  # otherwise the next file would get their descriptors
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode, encoding="utf-8"))  # noqa: SIM115 - open until exit
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and not _is_unicode(stream):
            stream.reconfigure(errors=ESCAPES)
    columns = os.environ.get("COLUMNS", "")
    if columns and not (
        columns.isdecimal() and len(columns) < 5 and _NARROWEST <= int(columns) <= _WIDEST
    ):
        del os.environ["COLUMNS"]


_NARROWEST, _WIDEST = 20, 1000  # readable line lengths in characters


def lead_nowhere(stream: TextIO) -> None:
    """Discard what Python flushes when it exits."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _is_unicode(stream: TextIO) -> bool:
    return (stream.encoding or "utf").lower().startswith("utf")


def refuse(error: JounceError, *, as_json: bool) -> int:
    """Print an error on stderr (and as JSON on stdout); return the exit code."""
    parts = {
        "what": error.what,
        "found": error.found,
        "allowed": error.allowed or None,
        "hint": error.hint or None,
    }
    first = {"kind": type(error).__name__, "message": error.message(), "where": error.where or None}
    return report_error({**first, **parts}, REFUSED, as_json=as_json)


def report_error(error: Mapping[str, Any], exit_code: int, *, as_json: bool) -> int:
    """Print an error as one message on stderr and, if requested, as ``{"error": ...}`` on stdout."""
    tell(error["message"])
    if as_json:
        with contextlib.suppress(OSError):  # stderr itself may have failed
            print_json({"error": error})
            sys.stdout.flush()
    return exit_code


def tell(message: str, *, program: str = "jounce: ") -> None:
    """Write one message to stderr, if it is open."""
    try:
        sys.stderr.write(
            f"{program}{visible(encodable(message, sys.stderr.encoding or 'utf-8'))}\n"
        )
        sys.stderr.flush()
    except OSError:
        lead_nowhere(sys.stderr)


class Elapsed:
    """The current work, its elapsed time and, if its completed share is known (`Stage`), the remaining time.

    Parameters
    ----------
    clock : callable
        Returns the time in s.
    stages : sequence of str
        How the texts of each stage begin, with ``|`` between those of one stage, and with its part of the whole
        after a ``*`` if that is not one, such as ``update*3``. With several stages, or when a
        second phase turns up without them, the remaining time is unknown; the share never decreases.
    """

    def __init__(
        self, clock: Callable[[], float] = time.monotonic, stages: Sequence[str] = ()
    ) -> None:
        named = [stage.partition("*") for stage in stages]
        self.clock, self.stages = clock, [tuple(names.split("|")) for names, _, _ in named]
        self.parts = [float(part or 1.0) for _, _, part in named]
        self._stage, self._within, self._shared, self._is_known = -1, 0.0, "", True
        self.started = clock()
        self.said, self.waits = "starting", ""
        self._phase, self._since, self._from, self._heard = "", self.started, 0.0, self.started

    def say(self, text: str) -> None:
        """Store the current activity."""
        self.said, self._heard = text, self.clock()
        phase = getattr(text, "phase", text.partition(":")[0])
        if phase != self._phase:
            self._phase, self._since, self._from = phase, self._heard, self._own_share() or 0.0
        share = self._own_share()
        if share is not None:
            self._is_known = self._is_known and self._shared in ("", phase)
            self._shared = phase
        stage = next((k for k, one in enumerate(self.stages) if text.startswith(one)), -1)
        if stage > self._stage:
            self._stage, self._within = stage, 0.0
        if stage == self._stage >= 0:
            self._within = max(self._within, share or 0.0)

    def _own_share(self) -> float | None:
        share: float | None = getattr(self.said, "share", None)
        return share

    def share(self) -> float | None:
        """Completed share of the whole work, 0 to 1; None if unknown."""
        if self.stages:
            if self._stage < 0:
                return None
            done = sum(self.parts[: self._stage]) + self._within * self.parts[self._stage]
            return done / sum(self.parts)
        return self._own_share() if self._is_known else None

    def stage(self) -> tuple[int, int] | None:
        """Which stage of how many; None if there is only one, or before the first."""
        return (self._stage + 1, len(self.stages)) if self._stage >= 0 else None

    def text(self) -> str:
        """Return the progress as one line.

        Examples
        --------
        >>> from jounce.core.waiting import progress_through
        >>> time = iter((0.0, 0.0, 8.0, 9.0))
        >>> line = Elapsed(lambda: next(time))
        >>> line.say(progress_through("testing {which} of {count}", 1, 10))
        >>> line.say(progress_through("testing {which} of {count}", 5, 10))
        >>> line.text()   # 2 s each, of which this one has had 1 s
        'testing 5 of 10 · 9 s, 40 %, about 11 s left'
        """
        now = self.clock()
        line = f"{self.waits or self.said} · {_duration(now - self.started)}"
        share, left = self.share(), self._left(now)
        if stage := self.stage():
            return f"{line}, stage {stage[0]} of {stage[1]}"
        if not share:
            return line
        return f"{line}, {100.0 * share:.0f} %" + (
            f", about {_duration(left)} left" if left and left >= 1.0 else ""
        )

    def left(self) -> float | None:
        """Remaining time (s), estimated from the completed share; None if unknown, as with several stages."""
        return self._left(self.clock())

    def _left(self, now: float) -> float | None:
        share = None if self.stages else self.share()
        done = (share or 0.0) - self._from
        if share is None or done <= 0.0:
            return None
        return max(0.0, (1.0 - share) * (self._heard - self._since) / done - (now - self._heard))

    def __rich__(self) -> Text:
        """Return the line for a console that redraws it repeatedly."""
        from rich.text import Text

        return Text(self.text())


def _duration(seconds: float) -> str:
    """Format a duration for people.

    >>> _duration(8.4), _duration(94.0), _duration(7500.0)
    ('8 s', '1 min 34 s', '2 h 5 min')
    """
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    return (
        f"{whole // 60} min {whole % 60} s"
        if whole < 3600
        else f"{whole // 3600} h {whole % 3600 // 60} min"
    )


_WORTH_TELLING = 2.0  # s
_FOLLOWER: ContextVar[Callable[[Elapsed], None] | None] = ContextVar("follower", default=None)


@contextmanager
def followed_by(follower: Callable[[Elapsed], None]) -> Iterator[None]:
    """Call a function whenever a command in the block reports its activity or waits, from any thread."""
    before = _FOLLOWER.set(follower)
    try:
        yield
    finally:
        _FOLLOWER.reset(before)


@contextmanager
def progress(stages: Sequence[str] = ()) -> Iterator[Callable[[str], None]]:
    """Return a function that shows one line of progress on stderr, if that is a terminal.

    The line ends with the elapsed time, and with fraction and remaining time if known (`Stage`), or with the stage
    (`Elapsed`). Within `followed_by`, progress is reported to the given function instead.
    """
    follower = _FOLLOWER.get()
    if follower is None and not sys.stderr.isatty():
        yield lambda _: None
        return
    from jounce.core.waiting import Waiting, heard_by

    line = Elapsed(stages=stages)

    def wait(text: str | None) -> None:
        line.waits = text.what if isinstance(text, Waiting) else text or ""
        if follower is not None:
            follower(line)

    if follower is not None:

        def say(text: str) -> None:
            line.say(text)
            follower(line)

        with heard_by(wait):
            yield say
        return
    shown = console(stderr=True)
    with shown.status(line, refresh_per_second=4.0), heard_by(wait):
        yield line.say
    took = line.clock() - line.started
    if took > _WORTH_TELLING:
        shown.print(f"took {_duration(took)}", style="dim")


ROUNDING = 1e-12  # SI values below this are rounding errors of zero
SEVERITY_STYLES = {"note": "dim", "warning": "yellow", "problem": "bold red"}


def table(
    title: str,
    columns: Sequence[str],
    rows: Iterable[Sequence[object]],
    *,
    text: Sequence[int] = (0,),
) -> FittedTable:
    """Build a table; columns are right-aligned numbers except those listed in ``text``.

    A terminal shows only the first rows of long tables, unless ``--all`` is given.
    """
    return FittedTable(title, columns, [[cell(item) for item in row] for row in rows], text)


def cell(value: object) -> str:
    """Format one cell: numbers with five digits, ``None`` as a dash."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return number(value) if isinstance(value, float) else str(value)


def number(value: float) -> str:
    """Format a number with five significant digits, without an exponent from 0.0001 up to ten million.

    Examples
    --------
    >>> number(138891.4), number(22730.0), number(-1.5), number(1e-15), number(2.5e9)
    ('138891', '22730', '-1.5', '0', '2.5e+09')
    """
    if abs(value) < ROUNDING:
        return "0"
    return f"{value:.0f}" if 1e5 <= abs(value) < 1e7 else f"{value:.5g}"


def show_written(out: Console, plain: Mapping[str, Any]) -> None:
    """Print the names of the written files."""
    for key in ("out", "record", "figure", "report"):
        if plain.get(key) is not None:
            out.print(f"written: {plain[key]}")


def show_findings(out: Console, findings: Iterable[Finding]) -> None:
    """Print findings, one sentence each; piped output has one line per finding.

    Identical findings about several places are merged into one sentence.
    """
    from rich.text import Text

    places: dict[tuple[Severity, str], list[str]] = {}
    for finding in findings:
        places.setdefault((finding.severity, finding.message), []).append(finding.place)
    for (severity, message), where in places.items():
        line = Text(f"{severity}: ", style=SEVERITY_STYLES[severity])
        line.append(f"{listed_places(list(dict.fromkeys(where)))}: {message}", style="default")
        out.print(line, soft_wrap=not out.is_terminal)
