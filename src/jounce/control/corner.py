"""The corner of a car as gains are designed for it: a quarter car about its static equilibrium."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from jounce.core.constants import GRAVITY
from jounce.core.types import Array

_TYPICAL_RATIO = 0.3  # damping ratio of a body on a damper where the corner has none


@dataclass(frozen=True)
class CornerModel:
    """Quarter car of one corner: what a decentralised controller knows of its plant.

    Attributes
    ----------
    sprung_mass : float
        Share of the body that rests on this corner, kg.
    unsprung_mass : float
        kg; 0 for a massless axle.
    spring_rate : float
        Wheel rate (spring at the wheel), N/m.
    tyre_stiffness : float
        N/m; 0 for a massless axle.
    damping_coefficient : float
        Of the corner's own damper, at the wheel, N s/m.
    motion_ratio : float
        Strut travel over wheel travel, 1.
    gravity : float
        m/s^2.
    static_deflection : float
        Strut deflection at rest, m.
    """

    sprung_mass: float
    unsprung_mass: float
    spring_rate: float
    tyre_stiffness: float
    damping_coefficient: float
    motion_ratio: float = 1.0
    gravity: float = GRAVITY
    static_deflection: float = 0.0

    @property
    def reference_damping(self) -> float:
        """Coefficient (N s/m, at the strut) that bounds and gains are set from where none are given."""
        wheel = self.damping_coefficient
        if wheel <= 0.0:
            wheel = 2.0 * _TYPICAL_RATIO * math.sqrt(self.spring_rate * self.sprung_mass)
        return wheel / self.motion_ratio**2


def corner_equations(corner: CornerModel, damping_coefficient: float | None = None) -> tuple[Array, Array, Array]:
    """Matrices ``A``, ``B``, ``G`` of ``dx/dt = A x + B u + G w``: ``u`` lifts the body (N), ``w`` is road.vz (m/s).

    States: sprung.z - unsprung.z (m), sprung.vz (m/s), unsprung.z - road.z (m), unsprung.vz (m/s).

    Parameters
    ----------
    corner : CornerModel
        The plant, with wheel and tyre.
    damping_coefficient : float, optional
        N s/m at the wheel; the corner's own damper otherwise.
    """
    m_s, m_u, k, k_t = corner.sprung_mass, corner.unsprung_mass, corner.spring_rate, corner.tyre_stiffness
    c = corner.damping_coefficient if damping_coefficient is None else damping_coefficient
    A = np.array(
        [
            [0.0, 1.0, 0.0, -1.0],
            [-k / m_s, -c / m_s, 0.0, c / m_s],
            [0.0, 0.0, 0.0, 1.0],
            [k / m_u, c / m_u, -k_t / m_u, -c / m_u],
        ]
    )
    B = np.array([[0.0], [1.0 / m_s], [0.0], [-1.0 / m_u]])
    G = np.array([[0.0], [0.0], [-1.0], [0.0]])
    return A, B, G


def corner_outputs(
    corner: CornerModel, channels: tuple[str, ...], damping_coefficient: float | None = None
) -> tuple[Array, Array]:
    """Matrices ``C``, ``D`` of channels (changes from static equilibrium, SI) from states and force (N)."""
    A, B, _ = corner_equations(corner, damping_coefficient)
    r, eye = corner.motion_ratio, np.eye(4)
    zero = np.zeros(1)
    known = {
        "strut.deflection": (-r * eye[0], zero),
        "strut.velocity": (r * (eye[3] - eye[1]), zero),
        "sprung.vz": (eye[1], zero),
        "sprung.az": (A[1], B[1]),
        "tyre.deflection": (-eye[2], zero),
        "tyre.force": (-corner.tyre_stiffness * eye[2], zero),
        "unsprung.vz": (eye[3], zero),
        "unsprung.az": (A[3], B[3]),
    }
    rows = [known[name] for name in channels]
    return np.array([row for row, _ in rows]), np.array([column for _, column in rows])
