"""Linear models about equilibrium: matrices, modes, frequency response."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.errors import SimulationError, unknown
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import as_number
from jounce.mechanics.facts import motion_of_speed
from jounce.parts import Rig
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.result import flipped_at
from jounce.simulation.statics import Equilibrium, find_equilibrium, for_small_motions

_NOTHING_HOLDS = 1e-7  # eigenvalues below this share of the fastest are zero: root of rounding, as for a double root


@dataclass(frozen=True)
class LinearModel(Shown):
    """``dx/dt = A x + B u``, ``y = C x + D u`` for small motions about static equilibrium, SI.

    Attributes
    ----------
    states, inputs, outputs : tuple of str
        Names; the inputs of each track are its value and its time derivative.
    A, B, C, D : ndarray
        Matrices in the order of these names.
    equilibrium : dict
        Static value of each state.
    """

    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    A: Array
    B: Array
    C: Array
    D: Array
    equilibrium: dict[str, float]

    def frequency_response(
        self, frequency: ArrayLike, output: str, track: str = "road.z"
    ) -> NDArray[np.complex128]:
        """Compute the complex amplitude of an output for unit harmonic motion of a track.

        Parameters
        ----------
        frequency : array_like, shape (n,)
            Hz.
        output : str
            Channel name.
        track : str
            Input track: the road under a wheel (m), or a manoeuvre load (N m, m/s^2).

        Returns
        -------
        ndarray of complex, shape (n,)
            Output unit per unit of the track, e.g. per metre.

        Raises
        ------
        DescriptionError
            If the model does not have the output or track.
        """
        tracks = tuple(name for name in self.inputs if f"{name} rate" in self.inputs)
        for name, names, what in ((output, self.outputs, "output"), (track, tracks, "track")):
            if name not in names:
                raise unknown(name, names, what=what, where="frequency response")
        row, first = self.outputs.index(output), self.inputs.index(track)
        amplitudes = []
        for s in 2j * np.pi * np.atleast_1d(as_samples(frequency, "Hz", where="frequency")):
            drive = np.array([1.0, s])
            x = np.linalg.solve(
                s * np.eye(len(self.states)) - self.A, self.B[:, first : first + 2] @ drive
            )
            amplitudes.append(self.C[row] @ x + self.D[row, first : first + 2] @ drive)
        return np.array(amplitudes)


@dataclass(frozen=True)
class Mode(Shown):
    """One oscillating eigenmode of the linearised rig.

    Attributes
    ----------
    frequency_hz : float
        Undamped natural frequency, magnitude of the eigenvalue over 2 pi, Hz.
    damped_frequency_hz : float
        Imaginary part of the eigenvalue over 2 pi, Hz.
    damping_ratio : float
        Fraction of critical damping (1).
    shape : dict
        Real and imaginary part of the eigenvector by height (channel such as ``sprung.z``, m; for vehicles also
        ``body.pitch`` and ``body.roll``, rad), with the largest component scaled to 1.
    """

    frequency_hz: float
    damped_frequency_hz: float
    damping_ratio: float
    shape: dict[str, tuple[float, float]]


def linearise(rig: Rig, road_height: float = 0.0) -> LinearModel:
    """Linearise a rig about static equilibrium.

    A damper with different slopes in bump and rebound has their mean. Dry friction has its slope at rest: it almost
    locks the strut, as it does in motions that are too small to make it slide.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    road_height : float
        Height of the road under the wheel, m.

    Returns
    -------
    LinearModel
        Matrices, SI.

    Raises
    ------
    SimulationError
        If there is no static equilibrium.

    Examples
    --------
    >>> import jounce as jn
    >>> model = jn.linearise(jn.load("kart-quarter-car"))
    >>> bool(abs(model.frequency_response([1e-3], "sprung.z")[0] - 1.0) < 1e-3)   # quasi-static: the body follows
    True
    """
    return _linearise(rig, road_height)


def numbers_without_friction(rig: Rig) -> dict[str, float]:
    """Return the parameters of a rig, SI by path, without dry friction."""
    return {
        path: 0.0 if path.endswith("friction.force") else value
        for path, value in rig.parameters().items()
    }


def _linearise(rig: Rig, road_height: float, *, slides: bool = False) -> LinearModel:
    compiled, p, rest, u = _at_rest(rig, road_height, slides=slides)
    facts, where = compiled.facts, (rest.x, u, p, rest.modes)
    c, along = compiled.slopes("x", *where)["output"], compiled.slopes("u", *where)
    orders = ("", " rate", " acceleration")[: facts.track_order]
    inputs = tuple(f"{track}{order}" for track in facts.tracks for order in orders)
    b, d = rest.pick @ along["rate"], along["output"]
    equilibrium = dict(zip(facts.states, map(float, rest.x), strict=True))
    speeds = [
        facts.speeds[i] for i in rest.free
    ]  # states: free motions, their speeds, and internal states
    states = (*map(motion_of_speed, speeds), *speeds, *facts.internal)
    return LinearModel(
        states, inputs, compiled.output_names, rest.reduced, b, c @ rest.lift, d, equilibrium
    )


def modes(rig: Rig, road_height: float = 0.0) -> tuple[Mode, ...]:
    """Compute the oscillating modes of a rig about static equilibrium, by ascending frequency.

    A motion without restoring force, such as yaw on a spherical joint, is not a mode. A damper with different slopes
    in bump and rebound has their mean. Dry friction is ignored: it has no damping ratio, and it locks the strut at
    rest.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    road_height : float
        Height of the road under the wheel, m.

    Returns
    -------
    tuple of Mode
        Modes by ascending undamped natural frequency.

    Examples
    --------
    >>> import jounce as jn
    >>> body_bounce, wheel_hop = jn.modes(jn.load("kart-quarter-car"))
    >>> round(body_bounce.frequency_hz, 1), round(wheel_hop.frequency_hz, 1)
    (5.1, 28.2)
    """
    model = _linearise(rig, road_height, slides=True)
    values, vectors = np.linalg.eig(model.A)
    heights = [
        i
        for i, name in enumerate(model.outputs)
        if _is_shown(name, model.outputs) and np.any(model.C[i])
    ]
    names = [model.outputs[i] for i in heights]
    oscillations = []
    for value, vector in zip(values, (model.C[heights] @ vectors).T, strict=True):
        if value.imag > 1e-9 * abs(value) and abs(value) > _NOTHING_HOLDS * np.max(np.abs(values)):
            shape = vector / vector[np.argmax(np.abs(vector))]
            shapes = {
                name: (float(z.real), float(z.imag)) for name, z in zip(names, shape, strict=True)
            }
            undamped, damped = float(abs(value)) / (2 * np.pi), float(value.imag) / (2 * np.pi)
            oscillations.append(Mode(undamped, damped, float(-value.real / abs(value)), shapes))
    return tuple(sorted(oscillations, key=lambda mode: mode.frequency_hz))


def _is_shown(name: str, outputs: tuple[str, ...]) -> bool:
    """Whether a channel is part of a mode's shape: a height, or a vehicle body's height and angles."""
    if "body.z" in outputs and name.endswith("sprung.z") and not name.endswith("unsprung.z"):
        return False
    return name.endswith(".z") or name in ("body.pitch", "body.roll")


def equilibrium(rig: Rig, road_height: float = 0.0) -> dict[str, float]:
    """Compute the static equilibrium of a rig: every state and output channel by name, SI.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    road_height : float
        Height of the road under the wheel, m.

    Returns
    -------
    dict
        State or channel to static value, SI.

    Examples
    --------
    >>> import jounce as jn
    >>> round(jn.equilibrium(jn.load("kart-quarter-car"))["tyre.force"], 2)   # (16 + 5) kg * 9.81 m/s^2
    206.01
    """
    compiled, p, rest, u = _at_rest(rig, road_height)
    outputs = compiled.evaluate("output", rest.x, u, p, rest.modes)
    return {
        **dict(zip(compiled.facts.states, map(float, rest.x), strict=True)),
        **dict(zip(compiled.output_names, map(float, outputs), strict=True)),
    }


def _at_rest(
    rig: Rig, road_height: float, *, slides: bool = False
) -> tuple[Compiled, Array, Equilibrium, Array]:
    road_height = as_number(road_height, "m", where="road_height")
    if not np.isfinite(road_height):
        raise SimulationError(
            "not a finite number", where="road_height", found=road_height, allowed="a height in m"
        )
    compiled = compile_rig(rig)
    p = compiled.parameter_values(numbers_without_friction(rig) if slides else rig.parameters())
    u = compiled.inputs(road_height)
    rest = for_small_motions(compiled, find_equilibrium(compiled, p, u), p, u)
    outputs = compiled.evaluate("output", rest.x, u, compiled.plain.extend(p), rest.modes)
    if flipped_at(compiled.output_names, outputs[:, None]) is not None:
        raise SimulationError(
            "the linkage can only be assembled in its inverted configuration",
            where="static equilibrium",
            hint="Check whether the tie rod reaches the rack's travel and whether the spring is far too stiff or soft.",
        )
    return compiled, p, rest, u
