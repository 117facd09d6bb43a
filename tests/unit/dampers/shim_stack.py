"""A damper of known physics on a virtual rig: bleed and shim-stack valves in both pistons, gas, friction, oil springs.

The library has none of this. Flow through the bleed is turbulent; the stack opens above a preload and then lets flow
pass in proportion to the pressure beyond it. The oil's compressibility delays the force.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr

import jounce as jn

AREA, ROD = 1.2e-3, 1.1e-4  # of piston and rod, m^2
DENSITY = 870.0  # kg/m^3


@dataclass(frozen=True)
class Side:
    """Valves of one direction: bleed area (m^2), pressure at which the stack opens (Pa), its flow beyond (m^3/s/Pa)."""

    bleed: float
    opening: float
    stack: float

    def pressure(self, flow: np.ndarray) -> np.ndarray:
        """Pressure drop (Pa) at a flow (m^3/s), by bisection over the sum of both flows."""
        low, high = np.zeros_like(flow), np.full_like(flow, 5e7)
        for _ in range(60):
            middle = 0.5 * (low + high)
            through = 0.7 * self.bleed * np.sqrt(2.0 * middle / DENSITY)
            through = through + self.stack * np.maximum(middle - self.opening, 0.0)
            high = np.where(through > flow, middle, high)
            low = np.where(through > flow, low, middle)
        return 0.5 * (low + high)


@dataclass(frozen=True)
class ShimDamper:
    bump: Side = Side(8e-6, 4e5, 4.5e-10)
    rebound: Side = Side(5e-6, 8e5, 2.2e-10)
    gas: float = 150.0  # N in mid-stroke
    gas_stiffness: float = 800.0  # N/m
    friction: float = 12.0  # N
    lag: float = 1.5e-3  # s

    def with_clicks(self, clicks: float) -> ShimDamper:
        """A click opens the rebound's bleed by a tenth of a square millimetre and lowers its preload."""
        side = Side(
            self.rebound.bleed + 3e-7 * clicks,
            self.rebound.opening * (1.0 - 0.02 * clicks),
            self.rebound.stack,
        )
        return ShimDamper(self.bump, side, self.gas, self.gas_stiffness, self.friction, self.lag)

    def valves(self, velocity: np.ndarray) -> np.ndarray:
        """Force of the valves alone (N) at a steady velocity."""
        speed = np.abs(velocity)
        bump = self.bump.pressure(AREA * speed) * AREA
        rebound = -self.rebound.pressure((AREA - ROD) * speed) * (AREA - ROD)
        return np.where(velocity > 0.0, bump, rebound)

    def on_rig(self, displacement, velocity, acceleration) -> np.ndarray:
        """Force (N) on a rig: late by the oil's compression, with gas, and friction that turns round within 1 mm/s."""
        late = velocity - self.lag * acceleration
        return (
            self.valves(late) + self.gas + self.gas_stiffness * displacement
            + self.friction * np.tanh(velocity / 5e-4)
        )  # fmt: skip


def record(
    damper: ShimDamper,
    peak: float,
    rng: np.random.Generator,
    *,
    stroke: float = 0.05,
    seconds: float = 10.0,
    rate: float = 1000.0,
    noise: float = 3.0,
    with_velocity: bool = False,
    signs: tuple[int, int] = (1, 1),
) -> xr.Dataset:
    """A sine of a peak velocity (m/s) on the rig, with noise (N) and a displacement of 1 µm noise."""
    omega = 2.0 * peak / stroke
    t = np.arange(0.0, seconds, 1.0 / rate)
    phase = omega * t + rng.uniform(0.0, 2.0 * np.pi)
    x, v, a = (0.5 * stroke * np.sin(phase), peak * np.cos(phase), -peak * omega * np.sin(phase))
    force = damper.on_rig(x, v, a) + noise * rng.standard_normal(len(t))
    channels = {
        "displacement": (signs[0] * (x + 1e-6 * rng.standard_normal(len(t))), "m", ""),
        "force": (signs[1] * force, "N", ""),
    }
    if with_velocity:
        channels["velocity"] = (signs[0] * v, "m/s", "")
    return jn.recording(t, channels)
