"""Poses of a mechanism as a film: GIF, or MP4 through ffmpeg."""

from __future__ import annotations

import io
import shutil
import subprocess
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import OutputError
from jounce.core.optional import MissingPackageError
from jounce.core.types import Array
from jounce.plots.drawing import MM, draw_ground, draw_pose, draw_steering_axis
from jounce.plots.poses import Poses
from jounce.plots.roadways import REACH, Roadway
from jounce.plots.scenes import Pose, Scene
from jounce.plots.shapes import View
from jounce.plots.sheets import draw_directions, everything, views_of
from jounce.plots.style import INK, MUTED, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from PIL import Image as Pictures

Say = Callable[[str], None]
_SIZE, _DOTS = (8.8, 4.6), 100  # inches, per inch
_HEAD = 0.55
_COLOURS = 96
FRAMES_A_SECOND = 25.0
_SWEEP_FRAMES_A_SECOND = 20.0


def gif(scene: Scene, poses: Poses, road: Roadway | None, title: str, seconds: float, say: Say) -> bytes:
    """Draw all poses as a GIF that plays for ``seconds`` (s) and begins again; a sweep goes back the way it came."""
    from PIL import Image

    frames = [
        frame.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE)
        for frame in _frames(scene, poses, road, title, say)
    ]
    length = max(20, 10 * round(100.0 * seconds / len(frames)))  # browsers slow down what is shorter
    stream = io.BytesIO()
    frames[0].save(stream, "GIF", save_all=True, append_images=frames[1:], duration=length, loop=0, optimize=True)
    return stream.getvalue()


def mp4(scene: Scene, poses: Poses, road: Roadway | None, title: str, seconds: float, say: Say, file: Path) -> None:
    """Let ffmpeg write all poses into a file that plays for ``seconds`` (s)."""
    program = ffmpeg()
    order = _order(poses)
    rate = f"{len(order) / seconds:.4f}"
    width, height = (round(_DOTS * inches) for inches in _SIZE)
    picture = ["-f", "rawvideo", "-pix_fmt", "rgba", "-s", f"{width}x{height}", "-r", rate, "-i", "-"]
    film = ["-an", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-fflags", "+bitexact"]
    words = [program, "-hide_banner", "-loglevel", "error", "-y", *picture, *film, "-f", "mp4", str(file)]
    with subprocess.Popen(words, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        try:
            for frame in _frames(scene, poses, road, title, say):
                process.stdin.write(frame.tobytes())
            process.stdin.close()
        except BrokenPipeError:
            pass  # it says why below
        complaint = process.stderr.read().decode(errors="replace").strip()
    if process.returncode:
        raise OutputError(
            "ffmpeg could not write the film", found=complaint[-300:], hint="Write .gif or .html instead."
        )


def ffmpeg() -> str:
    """Find ffmpeg: installed, or that of the package imageio-ffmpeg."""
    program = shutil.which("ffmpeg")
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


def film_length(poses: Poses, slow: float) -> float:
    """How long a film of these poses plays, s; a run ``slow`` times (1) longer than in reality."""
    if poses.in_time:
        return max(slow * float(np.ptp(poses.over)), 0.1)
    return len(_order(poses)) / _SWEEP_FRAMES_A_SECOND


def _order(poses: Poses) -> list[int]:
    """Poses in the order in which they are shown: a sweep there and back."""
    there = list(range(len(poses)))
    return there if poses.in_time else there + there[-2:0:-1]


def _frames(scene: Scene, poses: Poses, road: Roadway | None, title: str, say: Say) -> Iterator[Pictures.Image]:
    """Draw one picture after the other; on the way back a sweep's are those of the way there."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    drawn: dict[int, Pictures.Image] = {}
    with style():
        film = _Film(scene, poses, road, title)
        canvas = FigureCanvasAgg(film.figure)
        for k in _order(poses):
            if k not in drawn:
                say(f"drawing picture {k + 1} of {len(poses)}")
                film.show(k)
                canvas.draw()  # type: ignore[no-untyped-call]
                picture = Image.fromarray(np.asarray(canvas.buffer_rgba()).copy())  # type: ignore[no-untyped-call]
                if poses.in_time:
                    yield picture
                    continue
                drawn[k] = picture
            yield drawn[k]


class _Film:
    """A figure whose content changes from pose to pose: in space, and from the side (a run) or the front (a sweep)."""

    def __init__(self, scene: Scene, poses: Poses, road: Roadway | None, title: str) -> None:
        from matplotlib.figure import Figure

        self.scene, self.poses, self.road = scene, poses, road
        front, side, _, space = views_of(scene)
        self.views = (space, side if poses.in_time else front)
        self.figure = Figure(figsize=_SIZE, dpi=_DOTS)
        self.figure.text(0.02, 1.0 - 0.12 / _SIZE[1], title, ha="left", va="top", fontsize=11, fontweight="bold")
        self.state = self.figure.text(0.98, 1.0 - 0.12 / _SIZE[1], "", ha="right", va="top", fontsize=11, color=INK)
        sample = [poses.pose(int(k)) for k in np.unique(np.linspace(0, len(poses) - 1, 9).astype(int))]
        cloud = np.vstack([everything(scene, pose) for pose in sample])
        self.axes = [_panel(self.figure, view, cloud, k) for k, view in enumerate(self.views)]

    def show(self, k: int) -> None:
        """Draw pose ``k``."""
        pose = self.poses.pose(k)
        line = None
        if self.road is not None:
            reach = REACH * self.scene.undeformed_radius
            line = self.road.line(k, reach, float(pose.points["wheel_centre"][0]))
        for axes, view in zip(self.axes, self.views, strict=True):
            for artist in [*axes.lines, *axes.patches, *axes.texts]:
                artist.remove()
            self._draw(axes, view, pose, line)
        draw_directions(self.axes[0], self.views[0])
        self.state.set_text(pose.label if pose.touches else f"no contact · {pose.label}")
        self.state.set_color(INK if pose.touches else "#97330f")

    def _draw(self, axes: Axes, view: View, pose: Pose, line: Array | None) -> None:
        draw_ground(axes, view, self.scene, pose, line)
        for track, dash in ((self.poses.points["wheel_centre"], "-"), (self.poses.contact, (0, (3, 1.2)))):
            axes.plot(*(MM * view.flat(track)).T, color=MUTED, linewidth=0.7, linestyle=dash, zorder=0.9)
        draw_pose(axes, view, self.scene, pose, pressed=self.poses.in_time)
        draw_steering_axis(axes, view, self.scene, pose)


def _panel(figure: Figure, view: View, cloud: Array, k: int) -> Axes:
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
