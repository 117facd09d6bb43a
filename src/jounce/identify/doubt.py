"""Uncertainty of a model and its measurements: standard deviations of all inexact inputs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from jounce.core.description import Description
from jounce.core.errors import DescriptionError
from jounce.core.units import NonNegativeForce, NonNegativeLength, Unit

Share = Annotated[float, Unit("1", at_least=0.0)]


class Doubt(Description):
    """Uncertainty of model and measurements, each as one standard deviation; 0 means exact.

    The defaults suit a careful small laboratory. State inputs that are known better or worse. With half or double of
    all defaults, intervals of a spring rate are 0.5 to 0.7 and 2 times as wide, of a tyre's stiffness 0.7 to 0.9 and
    1.7 times, of a damper 0.7 to 1.1 and 1.4 to 1.8 times, of frictions and tyre damping 0.8 to 1.3 and 1.0 to 1.9
    times (three virtual benches of three trials). The latter depend more on the unexplained residual.

    Attributes
    ----------
    stated : float
        Masses stated by the rig, for 3-D models, as a share (1).
    lumped : float
        The same for lumped models, whose masses cannot be weighed, as the arms are partly sprung.
    estimated : float
        Masses in the rig's ``estimated`` list, as a share (1).
    values : dict
        Mapping from the path of any number of the rig to its own uncertainty: a share (``"3 %"``), or a value in its
        unit (``"0.2 kg"``).
    angle : float
        Strut angle, rad.
    damper_shape : float
        Deviation of the damper's force from its law, as a share (1) of it, with little correlation between slow and
        fast motion; ``damper_force`` (N) is added.
    damper_force : float
        Constant part of that deviation, N.
    presliding : float
        Hysteretic force of damper, mounts and seals that builds up over half a millimetre of travel, N.
    guide_presliding : float
        Share (1) of a fitted guide friction that builds up over travel (half a millimetre, within a factor of two)
        instead of with the velocity, as a deviation from one half.
    arms : float
        Inertia that arms and struts share between body and wheel, as a share (1) of the unsprung mass; for quarter
        cars, whose two masses are coupled by springs and dampers only.
    friction : float
        Friction that is not fitted, as a share (1) of the load on the spring.
    friction_onset : float
        Regularisation velocities of friction, as a power of two: 1 means between half and double (1).
    spring_curvature : float
        Change of the spring's rate at the strut over a deflection equal to the static one, as a share (1); for lumped
        models, which have a constant motion ratio.
    tyre_curvature : float
        The same for the tyre's stiffness.
    height : float
        Height of obstacles, or size of a base motion, as a share (1).
    contact_patch : float
        Length of the contact patch over which the tyre averages an obstacle, in static tyre deflections (1).
    speed : float
        Speed of each trial, m/s.
    slowing : float
        Change of speed during a pass of each trial, as a share (1).
    gain : float
        Gain of a sensor, as a share (1).
    corner : float
        Corner frequency of a low pass, as a share (1).
    bandwidth : float
        Time constant of an undeclared low pass in a sensor's chain, the inverse of its angular corner, s; for channels
        without a stated low pass.
    bias : float
        Constant error of a sensor, as a share (1) of the standard deviation of its record.
    start : float
        Amplitude of each natural vibration at the start of a record, m; 0 if all records begin at rest or on a belt
        whose loops are simulated.
    wheel_load : float
        Measured static wheel load, as a share (1).

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
    """Return the uncertain inputs, reading them from a table if necessary."""
    if isinstance(given, Doubt):
        return given
    if not isinstance(given, Mapping):
        allowed = 'jn.Doubt() or a table such as {"gain": "2 %"}'
        raise DescriptionError("invalid uncertainty", where="doubt", found=given, allowed=allowed)
    return Doubt.from_table(dict(given), where="doubt")
