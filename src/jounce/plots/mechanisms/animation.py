"""Animations of mechanisms: selection of poses from a sweep or a run, and films as GIF, or MP4 through ffmpeg."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import DescriptionError, OutputError
from jounce.core.optional import MissingPackageError
from jounce.core.programs import program_on_path
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.core.waiting import progress_through
from jounce.core.writing import Formats
from jounce.plots.figures import INK, MUTED, style
from jounce.plots.mechanisms.drawing import (
    MM,
    View,
    draw_directions,
    draw_ground,
    draw_pose,
    draw_steering_axis,
    everything,
    views_of,
)
from jounce.plots.mechanisms.scene import (
    REACH,
    Poses,
    Roadway,
    Scene,
    poses_of,
    roadway_of,
    scene_of,
)

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from PIL import Image as Pictures

    from jounce.parts.corners import Corner
    from jounce.roads import Trial


_MOST_IN_FILM = 300
_SAME_HEIGHT = 1e-4  # m: smaller differences are invisible in a film
_AT_JUMPS = 0.02  # share of the samples


def motion_of(
    rig: Corner,
    poses: xr.Dataset,
    *,
    trial: Trial | None = None,
    between: tuple[float | str, float | str] | None = None,
    slow: float = 5.0,
    most: Callable[[float], int],
    title: str = "",
    say: Callable[[str], None] = lambda _text: None,
) -> Animation:
    """Select the poses of a sweep or a run for an animation, at most as many as ``most`` allows.

    ``most`` is called with the playing time (s) of the video; the other arguments are those of :func:`jounce.animate`.
    """
    if not (np.isfinite(slow) and slow > 0.0):
        raise DescriptionError("out of range", where="slow", found=slow, allowed="above 0")
    scene = scene_of(rig)
    tracks = poses_of(rig, scene, poses)
    if between is not None:
        ends = (
            tracks.nearest(to_si(value, tracks.unit, where="between"), "between")
            for value in between
        )
        first, last = sorted(ends)
        tracks = tracks.subset(slice(first, last + 1))
    motion = Animation(
        scene, tracks, None, title or scene.title[0].upper() + scene.title[1:], slow, say
    )
    shown, count = tracks, most(motion.seconds if tracks.in_time else np.inf)
    if len(tracks) > count:  # evenly spaced
        shown = tracks.subset(
            np.unique(np.round(np.linspace(0, len(tracks) - 1, count)).astype(int))
        )
    return replace(motion, poses=shown, road=_roadway(trial, tracks, shown, scene))


def film_poses(frames: int | None) -> Callable[[float], int]:
    """Return a function from the playing time (s) of a film to its maximum number of poses."""
    most = frames or _MOST_IN_FILM
    return lambda seconds: int(min(most, max(2.0, FRAMES_A_SECOND * seconds + 1.5)))


def _roadway(trial: Trial | None, poses: Poses, shown: Poses, scene: Scene) -> Roadway | None:
    if trial is None:
        return None
    if not poses.in_time:
        raise DescriptionError("a kinematic sweep has no trial; leave it out", where="trial")
    expected = trial.segments().evaluate(np.minimum(poses.over, trial.duration))[0]
    if np.mean(np.abs(expected - poses.ground) > _SAME_HEIGHT) > _AT_JUMPS:
        raise DescriptionError(
            "the poses do not belong to this trial; its road has different heights",
            where="trial",
            hint="Give the trial that the run was simulated with.",
        )
    return roadway_of(trial, shown.over, scene.undeformed_radius)


@dataclass(frozen=True)
class Animation:
    """Content of an animation."""

    scene: Scene
    poses: Poses
    road: Roadway | None
    title: str
    slow: float  # factor by which a run is played slower than in reality
    say: Callable[[str], None]  # receives one line of progress at a time

    @property
    def order(self) -> list[int]:
        """Indices of the poses in the order of a film: a sweep is played forwards and backwards."""
        there = list(range(len(self.poses)))
        return there if self.poses.in_time else there + there[-2:0:-1]

    @property
    def seconds(self) -> float:
        """Playing time of a film, s."""
        if self.poses.in_time:
            return max(self.slow * float(np.ptp(self.poses.over)), 0.1)
        return len(self.order) / _SWEEP_FRAMES_A_SECOND


# --- films: GIF, or MP4 through ffmpeg -------------------------------------------------------------------------

_SIZE, _DOTS = (8.8, 4.6), 100  # inches, per inch
_HEAD = 0.55
_COLOURS = 96
FRAMES_A_SECOND = 25.0
_SWEEP_FRAMES_A_SECOND = 20.0


def _write_gif(motion: Animation, file: Path) -> None:
    """Write all poses; the film repeats, and a sweep is played forwards and backwards."""
    from PIL import Image

    frames = [
        frame.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE)
        for frame in _frames(motion)
    ]
    length = max(
        20, 10 * round(100.0 * motion.seconds / len(frames))
    )  # browsers slow down films with shorter frames
    frames[0].save(
        file, "GIF", save_all=True, append_images=frames[1:], duration=length, loop=0, optimize=True
    )


def _write_mp4(motion: Animation, file: Path) -> None:
    rate = f"{len(motion.order) / motion.seconds:.4f}"
    width, height = (round(_DOTS * inches) for inches in _SIZE)
    picture = [
        "-f",
        "rawvideo",
        "-pix_fmt",
        "rgba",
        "-s",
        f"{width}x{height}",
        "-r",
        rate,
        "-i",
        "-",
    ]
    film = [
        "-an",
        "-c:v",
        "libx264",
        "-pix_fmt",
        "yuv420p",
        "-movflags",
        "+faststart",
        "-fflags",
        "+bitexact",
    ]
    words = [
        ffmpeg(),
        "-hide_banner",
        "-loglevel",
        "error",
        "-y",
        *picture,
        *film,
        "-f",
        "mp4",
        str(file),
    ]
    with subprocess.Popen(words, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        try:
            for frame in _frames(motion):
                process.stdin.write(frame.tobytes())
            process.stdin.close()
        except BrokenPipeError:
            pass  # its message is read below
        message = process.stderr.read().decode(errors="replace").strip()
    if process.returncode:
        raise OutputError(
            "ffmpeg could not write the video",
            found=message[-300:],
            hint="Write .gif or .html instead.",
        )


def ffmpeg() -> str:
    """Find ffmpeg: the installed program, or that of the package imageio-ffmpeg."""
    program = program_on_path("ffmpeg")
    if program is None:
        try:
            program = str(import_module("imageio_ffmpeg").get_ffmpeg_exe())
        except (ImportError, RuntimeError):
            raise MissingPackageError(
                "MP4 is written by ffmpeg, which was not found",
                hint=(
                    "Install ffmpeg (apt-get install ffmpeg, brew install ffmpeg, or pip install "
                    "imageio-ffmpeg), or write .gif or .html, which need no other program."
                ),
            ) from None
    return program


def _frames(motion: Animation) -> Iterator[Pictures.Image]:
    """Yield the frames one by one; a sweep played backwards reuses its frames."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    drawn: dict[int, Pictures.Image] = {}
    with style():
        film = _Film(motion)
        canvas = FigureCanvasAgg(film.figure)
        for k in motion.order:
            if k not in drawn:
                motion.say(
                    progress_through("drawing frame {which} of {count}", k + 1, len(motion.poses))
                )
                film.show(k)
                canvas.draw()  # type: ignore[no-untyped-call]
                picture = Image.fromarray(np.asarray(canvas.buffer_rgba()).copy())  # type: ignore[no-untyped-call]
                if motion.poses.in_time:
                    yield picture
                    continue
                drawn[k] = picture
            yield drawn[k]


class _Film:
    """A figure redrawn for each pose: an oblique view, and a side view (run) or front view (sweep)."""

    def __init__(self, motion: Animation) -> None:
        from matplotlib.figure import Figure

        self.scene, self.poses, self.road = motion.scene, motion.poses, motion.road
        scene, poses = motion.scene, motion.poses
        front, side, _, space = views_of(scene)
        self.views = (space, side if poses.in_time else front)
        self.figure = Figure(figsize=_SIZE, dpi=_DOTS)
        self.figure.text(
            0.02,
            1.0 - 0.12 / _SIZE[1],
            motion.title,
            ha="left",
            va="top",
            fontsize=11,
            fontweight="bold",
        )
        self.state = self.figure.text(
            0.98, 1.0 - 0.12 / _SIZE[1], "", ha="right", va="top", fontsize=11, color=INK
        )
        sample = [
            poses.pose(int(k)) for k in np.unique(np.linspace(0, len(poses) - 1, 9).astype(int))
        ]
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
                axes.plot(
                    *(MM * view.flat(track)).T,
                    color=MUTED,
                    linewidth=0.7,
                    linestyle=dash,
                    zorder=0.9,
                )
            draw_pose(axes, view, self.scene, pose, pressed=self.poses.in_time)
            draw_steering_axis(axes, view, self.scene, pose)
        draw_directions(self.axes[0], self.views[0])
        self.state.set_text(pose.label if pose.touches else f"no contact · {pose.label}")
        self.state.set_color(INK if pose.touches else "#97330f")


def _film_panel(figure: Figure, view: View, cloud: Array, k: int) -> Axes:
    """Add axes with equal scales in both directions that contain all points."""
    width, height = 0.5 * _SIZE[0] - 0.1, _SIZE[1] - _HEAD - 0.3
    axes = figure.add_axes(
        (0.05 / _SIZE[0] + 0.5 * k, 0.06 / _SIZE[1], width / _SIZE[0], height / _SIZE[1])
    )
    flat = MM * view.flat(cloud)
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = float(np.max((high - low) / [width - 0.3, height - 0.3]))
    half = 0.5 * scale * np.array([width, height])
    middle = 0.5 * (low + high)
    axes.set(
        xlim=(middle[0] - half[0], middle[0] + half[0]),
        ylim=(middle[1] - half[1], middle[1] + half[1]),
    )
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)
    axes.grid(visible=False)
    axes.set_title(view.name, fontsize=8.5, fontweight="normal", color=MUTED)
    return axes


FILMS = Formats("animations", {".gif": _write_gif, ".mp4": _write_mp4})
