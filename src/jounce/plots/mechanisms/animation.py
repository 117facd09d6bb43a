"""Mechanisms in motion: a page for the browser, a GIF, or an MP4 through ffmpeg."""

from __future__ import annotations

import html
import json
import re
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from importlib import import_module, resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import display_unit
from jounce.core.errors import DescriptionError, OutputError
from jounce.core.optional import MissingPackageError
from jounce.core.programs import program_on_path
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.core.writing import Formats
from jounce.plots.display import settled
from jounce.plots.mechanisms.drawing import (
    COILS,
    DAMPER_BODY,
    MM,
    View,
    draw_directions,
    draw_ground,
    draw_pose,
    draw_steering_axis,
    everything,
    views_of,
)
from jounce.plots.mechanisms.scene import REACH, Poses, Roadway, Scene, poses_of, roadway_of, scene_of
from jounce.plots.style import INK, MUTED, style

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from PIL import Image as Pictures

    from jounce.parts.corners import Corner
    from jounce.roads import Trial


_MOST_IN_PAGE, _MOST_IN_FILM = 1000, 300
_SAME_HEIGHT = 1e-4  # m
_AT_JUMPS = 0.02  # share of the samples


def animate(
    rig: Corner,
    poses: xr.Dataset,
    path: Path | str,
    *,
    trial: Trial | None = None,
    between: tuple[float | str, float | str] | None = None,
    slow: float = 5.0,
    frames: int | None = None,
    title: str = "",
    force: bool = False,
    progress: Callable[[str], None] = lambda _text: None,
) -> Path:
    """Show a sweep or a run of a 3-D rig in motion; the suffix chooses how.

    Parameters
    ----------
    rig : Corner
        What moves.
    poses : xarray.Dataset
        A sweep (``jn.sweep_travel(rig, ..., points=True)``) or a run (``jn.simulate(rig, trial, detail=True)``).
    path : Path or str
        ``.html`` (one page that opens anywhere without a network: turn, play, read values), ``.gif``, or ``.mp4``
        (through ffmpeg).
    trial : Trial, optional
        What the run was driven over: its road then passes under the wheel; otherwise a plate lifts the wheel.
    between : tuple, optional
        First and last travel (m) or time (s), or texts with units, to show only a part.
    slow : float
        How many times slower than in reality a run is played [1].
    frames : int, optional
        The most poses to show; by default 1000 in a page and 300 in a film. A film of a run takes no more than it needs
        for 25 pictures a second.
    title : str
        Heading; model and side by default.
    force : bool
        Overwrite an existing file.
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    Path
        The file written; the same input gives the same page.

    Raises
    ------
    OutputError
        For an existing file without ``force``, a missing folder, or another suffix.
    MissingPackageError
        For ``.mp4`` without ffmpeg.
    DescriptionError
        When the poses are not of this trial, or for a part that they do not reach.
    RecordingError
        For poses without hardpoints.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import jounce as jn
    >>> rig = jn.load("kart-double-wishbone")
    >>> sweep = jn.sweep_travel(rig, [-0.02, 0.0, 0.02], points=True)
    >>> animate(rig, sweep, pathlib.Path(tempfile.mkdtemp()) / "motion.html").name
    'motion.html'
    """
    file = check_animation(path, force=force)
    if not (np.isfinite(slow) and slow > 0.0):
        raise DescriptionError("out of range", where="slow", found=slow, allowed="above 0")
    if frames is not None and frames < 1:
        raise DescriptionError("out of range", where="frames", found=frames, allowed="at least 1")
    scene = scene_of(rig)
    tracks = poses_of(rig, scene, poses)
    if between is not None:
        ends = (tracks.nearest(to_si(value, tracks.unit, where="between"), "between") for value in between)
        first, last = sorted(ends)
        tracks = tracks.taken(slice(first, last + 1))
    motion = Motion(scene, tracks, None, title or scene.title[0].upper() + scene.title[1:], slow, progress)
    is_page = file.suffix.lower() == ".html"
    most = frames or (_MOST_IN_PAGE if is_page else _MOST_IN_FILM)
    if tracks.in_time and not is_page:
        most = min(most, max(2, round(FRAMES_A_SECOND * motion.seconds) + 1))
    kept = tracks
    if len(tracks) > most:  # evenly chosen
        kept = tracks.taken(np.unique(np.round(np.linspace(0, len(tracks) - 1, most)).astype(int)))
    motion = replace(motion, poses=kept, road=_roadway(trial, tracks, kept, scene))
    return ANIMATIONS.write(motion, file, force=force)


def check_animation(path: Path | str, *, force: bool = False) -> Path:
    """Refuse, before the work, a file that could not be written: its suffix, its folder, what stands there, ffmpeg."""
    file = ANIMATIONS.check(path, force=force)
    if file.suffix.lower() == ".mp4":
        ffmpeg()
    return file


def _roadway(trial: Trial | None, poses: Poses, kept: Poses, scene: Scene) -> Roadway | None:
    if trial is None:
        return None
    if not poses.in_time:
        raise DescriptionError("a sweep is not driven; leave out the trial", where="trial")
    expected = trial.segments().evaluate(np.minimum(poses.over, trial.duration))[0]
    if np.mean(np.abs(expected - poses.ground) > _SAME_HEIGHT) > _AT_JUMPS:
        raise DescriptionError(
            "the poses are not of this trial; its road has other heights",
            where="trial",
            hint="Give the trial that the run was simulated with.",
        )
    return roadway_of(trial, kept.over, scene.undeformed_radius)


@dataclass(frozen=True)
class Motion:
    """What an animation shows."""

    scene: Scene
    poses: Poses
    road: Roadway | None
    title: str
    slow: float  # how many times slower than in reality a run is played
    say: Callable[[str], None]  # told one line of text as the work goes on

    @property
    def order(self) -> list[int]:
        """Poses in the order in which a film shows them: a sweep there and back."""
        there = list(range(len(self.poses)))
        return there if self.poses.in_time else there + there[-2:0:-1]

    @property
    def seconds(self) -> float:
        """How long a film plays, s."""
        if self.poses.in_time:
            return max(self.slow * float(np.ptp(self.poses.over)), 0.1)
        return len(self.order) / _SWEEP_FRAMES_A_SECOND


# --- films: GIF, or MP4 through ffmpeg -------------------------------------------------------------------------

_SIZE, _DOTS = (8.8, 4.6), 100  # inches, per inch
_HEAD = 0.55
_COLOURS = 96
FRAMES_A_SECOND = 25.0
_SWEEP_FRAMES_A_SECOND = 20.0


def _write_gif(motion: Motion, file: Path) -> None:
    """Write all poses; the film begins again, a sweep goes back the way it came."""
    from PIL import Image

    frames = [frame.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE) for frame in _frames(motion)]
    length = max(20, 10 * round(100.0 * motion.seconds / len(frames)))  # browsers slow down what is shorter
    frames[0].save(file, "GIF", save_all=True, append_images=frames[1:], duration=length, loop=0, optimize=True)


def _write_mp4(motion: Motion, file: Path) -> None:
    rate = f"{len(motion.order) / motion.seconds:.4f}"
    width, height = (round(_DOTS * inches) for inches in _SIZE)
    picture = ["-f", "rawvideo", "-pix_fmt", "rgba", "-s", f"{width}x{height}", "-r", rate, "-i", "-"]
    film = ["-an", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-fflags", "+bitexact"]
    words = [ffmpeg(), "-hide_banner", "-loglevel", "error", "-y", *picture, *film, "-f", "mp4", str(file)]
    with subprocess.Popen(words, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        try:
            for frame in _frames(motion):
                process.stdin.write(frame.tobytes())
            process.stdin.close()
        except BrokenPipeError:
            pass  # it says why below
        message = process.stderr.read().decode(errors="replace").strip()
    if process.returncode:
        raise OutputError("ffmpeg could not write the film", found=message[-300:], hint="Write .gif or .html instead.")


def ffmpeg() -> str:
    """Find ffmpeg: installed, or that of the package imageio-ffmpeg."""
    program = program_on_path("ffmpeg")
    if program is None:
        try:
            program = str(import_module("imageio_ffmpeg").get_ffmpeg_exe())
        except (ImportError, RuntimeError):
            raise MissingPackageError(
                "MP4 is written by ffmpeg, which was not found",
                hint="Install it (apt-get install ffmpeg, brew install ffmpeg, or pip install imageio-ffmpeg), or "
                "write .gif or .html, which need nothing.",
            ) from None
    return program


def _frames(motion: Motion) -> Iterator[Pictures.Image]:
    """Draw one picture after the other; on the way back a sweep's are those of the way there."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    drawn: dict[int, Pictures.Image] = {}
    with style():
        film = _Film(motion)
        canvas = FigureCanvasAgg(film.figure)
        for k in motion.order:
            if k not in drawn:
                motion.say(f"drawing picture {k + 1} of {len(motion.poses)}")
                film.show(k)
                canvas.draw()  # type: ignore[no-untyped-call]
                picture = Image.fromarray(np.asarray(canvas.buffer_rgba()).copy())  # type: ignore[no-untyped-call]
                if motion.poses.in_time:
                    yield picture
                    continue
                drawn[k] = picture
            yield drawn[k]


class _Film:
    """A figure whose content changes from pose to pose: in space, and from the side (a run) or the front (a sweep)."""

    def __init__(self, motion: Motion) -> None:
        from matplotlib.figure import Figure

        self.scene, self.poses, self.road = motion.scene, motion.poses, motion.road
        scene, poses = motion.scene, motion.poses
        front, side, _, space = views_of(scene)
        self.views = (space, side if poses.in_time else front)
        self.figure = Figure(figsize=_SIZE, dpi=_DOTS)
        self.figure.text(0.02, 1.0 - 0.12 / _SIZE[1], motion.title, ha="left", va="top", fontsize=11, fontweight="bold")
        self.state = self.figure.text(0.98, 1.0 - 0.12 / _SIZE[1], "", ha="right", va="top", fontsize=11, color=INK)
        sample = [poses.pose(int(k)) for k in np.unique(np.linspace(0, len(poses) - 1, 9).astype(int))]
        cloud = np.vstack([everything(scene, pose) for pose in sample])
        self.axes = [_film_panel(self.figure, view, cloud, k) for k, view in enumerate(self.views)]

    def show(self, k: int) -> None:
        """Draw pose ``k``."""
        pose = self.poses.pose(k)
        line = None
        if self.road is not None:
            reach = REACH * self.scene.undeformed_radius
            line = self.road.line(k, reach, float(pose.points["wheel_centre"][0]))
        tracks = ((self.poses.points["wheel_centre"], "-"), (self.poses.contact, (0, (3, 1.2))))
        for axes, view in zip(self.axes, self.views, strict=True):
            for artist in [*axes.lines, *axes.patches, *axes.texts]:
                artist.remove()
            draw_ground(axes, view, self.scene, pose, line)
            for track, dash in tracks:
                axes.plot(*(MM * view.flat(track)).T, color=MUTED, linewidth=0.7, linestyle=dash, zorder=0.9)
            draw_pose(axes, view, self.scene, pose, pressed=self.poses.in_time)
            draw_steering_axis(axes, view, self.scene, pose)
        draw_directions(self.axes[0], self.views[0])
        self.state.set_text(pose.label if pose.touches else f"no contact · {pose.label}")
        self.state.set_color(INK if pose.touches else "#97330f")


def _film_panel(figure: Figure, view: View, cloud: Array, k: int) -> Axes:
    """Axes with one scale in both directions into which all points fit."""
    width, height = 0.5 * _SIZE[0] - 0.1, _SIZE[1] - _HEAD - 0.3
    axes = figure.add_axes((0.05 / _SIZE[0] + 0.5 * k, 0.06 / _SIZE[1], width / _SIZE[0], height / _SIZE[1]))
    flat = MM * view.flat(cloud)
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = float(np.max((high - low) / [width - 0.3, height - 0.3]))
    half = 0.5 * scale * np.array([width, height])
    middle = 0.5 * (low + high)
    axes.set(xlim=(middle[0] - half[0], middle[0] + half[0]), ylim=(middle[1] - half[1], middle[1] + half[1]))
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)
    axes.grid(visible=False)
    axes.set_title(view.name, fontsize=8.5, fontweight="normal", color=MUTED)
    return axes


# --- the page: one file for any browser, nothing from a network -------------------------------------------------

_REACTIONS = tuple(f".{kind}{axis}" for kind in "ft" for axis in "xyz")
_FIRST = ("tyre.force", "camber")
_SWEEP_SPEEDS = (("slow", 8.0), ("normal", 20.0), ("fast", 50.0))
_SIGN = re.compile(r",? (?:compression|bump|up) positive\b|, positive [\w ]+")
"""What long names say of signs; there is no room for it beside the values."""
_MOST_DIGITS = 4
_SLOWER = (1.0, 2.0, 4.0, 10.0, 20.0, 50.0)


def _write_page(motion: Motion, file: Path) -> None:
    """Write the page; the same input gives the same text."""
    template = resources.files("jounce.plots.mechanisms").joinpath("viewer.html").read_text(encoding="utf-8")
    data = json.dumps(_data(motion), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    page = template.replace("{{title}}", html.escape(motion.title))
    file.write_text(page.replace("{{data}}", data.replace("<", "\\u003c")), encoding="utf-8", newline="\n")


def _data(motion: Motion) -> dict[str, Any]:
    scene, poses, road = motion.scene, motion.poses, motion.road
    names = list(poses.points)
    index = {name: i for i, name in enumerate(names)}
    parts = [part for part in scene.parts if all(name in index for name in part.points)]
    brackets = [one for one in scene.brackets if {one.point, one.first, one.second} <= set(index)]
    show = poses.display
    over, digits = _digits(poses.over * show.factor)
    return {
        "side": scene.side,
        "inTime": poses.in_time,
        "words": poses.words,
        "unit": show.name,
        "digits": digits,
        "over": over,
        "start": 0 if poses.in_time else int(np.abs(poses.over).argmin()),
        "names": names,
        "onBody": [name in scene.on_body for name in names],
        "points": [_track(poses.points[name]) for name in names],
        "parts": [
            {
                "name": part.name,
                "words": part.words,
                "colour": part.colour,
                "plate": part.plate,
                "points": [index[name] for name in part.points],
            }
            for part in parts
        ],
        "brackets": [
            [index[one.point], index[one.first], index[one.second], round(one.share, 4), one.colour] for one in brackets
        ],
        "strut": {
            "spring": [index[name] for name in scene.spring],
            "damper": [index[name] for name in scene.damper],
            "radius": _millimetres(np.array(scene.coil_radius)),
            "tube": _millimetres(np.array(DAMPER_BODY * scene.damper_length)),
            "coils": COILS,
            "colour": scene.strut_colour,
        },
        "axis": None if scene.steering_axis is None else [index[name] for name in scene.steering_axis],
        "wheel": {
            "centre": index["wheel_centre"],
            "radius": _millimetres(np.array(scene.undeformed_radius if poses.in_time else scene.radius)),
            "width": _millimetres(np.array(scene.width)),
            "pressed": poses.in_time,
        },
        "spin": np.round(poses.spin_axis, 5).tolist(),
        "contact": _millimetres(poses.contact),
        "ground": _millimetres(poses.ground),
        "touches": poses.touches.astype(int).tolist(),
        "road": None
        if road is None
        else {
            name: _millimetres(line) for name, line in (("x", road.distance), ("z", road.height), ("way", road.driven))
        },
        "signals": _signals(poses),
        "first": next((name for name in _FIRST if name in poses.signals), ""),
        **_speeds(poses, motion.slow),
    }


def _millimetres(values: Array) -> Any:
    """Lengths in mm to a hundredth."""
    return np.round(MM * values, 2).tolist()


def _track(track: Array) -> dict[str, Any]:
    """Places of a point, or its place where it stands still."""
    still = bool(np.ptp(track, axis=0).max() < 5e-6)
    return {"at": _millimetres(track[0])} if still else {"track": _millimetres(track)}


def _signals(poses: Poses) -> list[dict[str, Any]]:
    """What else is known of each pose; forces in joints are left to the recording."""
    found = []
    for name, values in poses.signals.items():
        if name.endswith(_REACTIONS) or name == "constraint.residual" or not np.isfinite(values).any():
            continue
        known = values[np.isfinite(values)]
        unit = display_unit(poses.signal_units[name], float(np.abs(known).max()))
        shown, digits = _digits(settled(values, poses.signal_units[name]) * unit.factor)
        words = _SIGN.sub("", poses.signal_words[name])
        found.append({"name": name, "words": words, "unit": unit.name, "digits": digits, "values": shown})
    return found


def _digits(values: Array) -> tuple[list[float | None], int]:
    """Values as they are drawn, and how many digits stand behind the point where they are written.

    Written are four significant digits of the largest; drawn is what a screen shows of their range.
    """
    finite = np.isfinite(values)
    largest = float(np.abs(values[finite]).max(initial=0.0))
    range_ = float(np.ptp(values[finite])) if finite.any() else 0.0
    digits = 0 if largest == 0.0 else int(np.clip(3 - np.floor(np.log10(largest)), 0, _MOST_DIGITS))
    drawn = digits + 2 if range_ == 0.0 else int(np.clip(4 - np.floor(np.log10(range_)), digits, 12))
    rounded = np.round(values, drawn) + 0.0
    return [float(value) if ok else None for value, ok in zip(rounded, finite, strict=True)], digits


def _speeds(poses: Poses, slow: float) -> dict[str, Any]:
    """Choices of speed: words and poses a second, and the one to begin with."""
    if not poses.in_time:
        return {"speeds": list(_SWEEP_SPEEDS), "speed": _SWEEP_SPEEDS[1][1]}
    length = float(poses.over[-1] - poses.over[0]) or 1.0
    rate = (len(poses) - 1) / length
    choices = sorted({*_SLOWER, slow})
    speeds = [("real time" if one == 1.0 else f"1/{one:g}", round(rate / one, 4)) for one in choices]
    return {"speeds": speeds, "speed": round(rate / slow, 4)}


ANIMATIONS = Formats("animations", {".html": _write_page, ".gif": _write_gif, ".mp4": _write_mp4})
