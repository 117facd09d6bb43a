"""Uncertainty of a model and its measurements: standard deviations of all inputs that are never exact."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from jounce.core.description import Description
from jounce.core.errors import DescriptionError
from jounce.core.units import NonNegativeForce, NonNegativeLength, Unit

Share = Annotated[float, Unit("1", at_least=0.0)]


class Doubt(Description):
    """Uncertainty of model and measurements, each as one standard deviation; 0 means exact.

    The defaults are those of a careful small laboratory. State what is known better, and what is known less: with half
    or double of them all, intervals of a spring rate are 0.5 to 0.7 and 2 times as wide, of a tyre's stiffness 0.7 to
    0.9 and 1.7 times, of a damper 0.7 to 1.1 and 1.4 to 1.8 times, of frictions and tyre damping 0.8 to 1.3 and 1.0 to
    1.9 times (three virtual benches of three trials): those depend more on what nothing explains.

    Attributes
    ----------
    stated : float
        Masses that the rig states, in 3-D, as a share (1).
    lumped : float
        The same of lumped models, whose masses are on no scale: the arms are sprung in part.
    estimated : float
        Masses that the rig's ``estimated`` list names, as a share (1).
    values : dict
        Path of any number of the rig to its own: a share (``"3 %"``), or in its unit (``"0.2 kg"``).
    angle : float
        Strut angle, rad.
    damper_shape : float
        Force of the damper beside its law, as a share (1) of it, at velocities as far apart as slow and fast; in
        addition ``damper_force`` (N).
    damper_force : float
        See there, N.
    presliding : float
        Hysteretic force of damper, mounts and seals that builds up over half a millimetre, N.
    guide_presliding : float
        Share (1) of the guide's friction that builds up over travel (half a millimetre, within a factor of two) instead
        of with the velocity, where that friction is fitted: about one half of it.
    arms : float
        Inertia that arms and struts share between body and wheel, as a share (1) of the unsprung mass; of quarter cars,
        whose two masses feel each other through springs and dampers only.
    friction : float
        Friction that is not fitted, as a share (1) of the load on the spring.
    friction_onset : float
        Regularisation velocities of friction, as a factor: 1 for between half and double (1).
    spring_curvature : float
        Change of the spring's rate at the strut for a deflection as large as the static one, as a share (1); of lumped
        models, which have no motion ratio that changes.
    tyre_curvature : float
        The same of the tyre's stiffness.
    height : float
        Height of obstacles, or size of a base motion, as a share (1).
    contact_patch : float
        Length of the patch over which the tyre averages an obstacle, in static deflections of the tyre (1).
    speed : float
        Speed of each trial, m/s.
    slowing : float
        Share (1) by which the speed changes during a pass, of each trial.
    gain : float
        Gain of a sensor, as a share (1).
    corner : float
        Corner frequency of a low pass, as a share (1).
    bandwidth : float
        Time constant of a low pass that a sensor's chain has and nobody states, one over its angular corner, s; of
        channels without a stated one.
    bias : float
        Constant error of a sensor, as a share (1) of the standard deviation of its record.
    start : float
        How far each natural vibration may go when a record begins, m: 0 where all begin at rest, or on a belt whose
        loops are simulated.
    wheel_load : float
        Wheel load at rest where it was measured, as a share (1) of it.

    Examples
    --------
    >>> Doubt(height="3 %", values={"unsprung.mass": "0.1 kg"}).height
    0.03
    """

    stated: Share = 0.005
    lumped: Share = 0.02
    estimated: Share = 0.03
    values: dict[str, Any] = {}
    angle: Annotated[float, Unit("rad", at_least=0.0)] = 0.0087
    damper_shape: Share = 0.2
    damper_force: NonNegativeForce = 2.0
    presliding: NonNegativeForce = 4.0
    guide_presliding: Share = 0.3
    arms: Share = 0.04
    friction: Share = 0.02
    friction_onset: Share = 1.0
    spring_curvature: Share = 0.03
    tyre_curvature: Share = 0.02
    height: Share = 0.015
    contact_patch: Share = 6.0
    speed: Annotated[float, Unit("m/s", at_least=0.0)] = 0.003
    slowing: Share = 0.02
    gain: Share = 0.01
    corner: Share = 0.15
    bandwidth: Annotated[float, Unit("s", at_least=0.0)] = 0.0005
    bias: Share = 0.03
    start: NonNegativeLength = 0.0
    wheel_load: Share = 0.005


def doubts_of(given: Doubt | Mapping[str, Any]) -> Doubt:
    """Return the uncertain inputs, also from a table."""
    if isinstance(given, Doubt):
        return given
    if not isinstance(given, Mapping):
        allowed = 'jn.Doubt() or a table such as {"gain": "2 %"}'
        raise DescriptionError("not an uncertainty", where="doubt", found=given, allowed=allowed)
    return Doubt.from_table(dict(given), where="doubt")
