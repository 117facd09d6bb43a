"""A fitted damper law, and its force next to the measured force."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from jounce.core.findings import Finding
from jounce.core.results import Shows
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.identify.estimate import Estimate
from jounce.identify.signs import ForcePositive, StrokePositive


@dataclass(frozen=True)
class DamperResult(Shown):
    """A damper law identified from a record.

    Attributes
    ----------
    law : str
        Name of the law.
    parameters : dict of str to Estimate
        Parameters by name, SI. The standard errors allow for autocorrelated residuals. A parameter at a bound has no
        interval.
    units : dict of str to str
        Unit of each parameter.
    nrmse : float
        Root mean square of measured minus fitted force, over the range (largest minus smallest) of the force [1].
    r2 : float
        Share of the variance of the force explained [1].
    rms_residual : float
        R.m.s. residual [N].
    energy_per_cycle, fitted_energy_per_cycle : float
        Work done on the damper per cycle, measured and by the law [J].
    cycles : float
        Cycles fitted [1].
    samples : int
        Number of samples fitted [1].
    displacement_centre : float
        Middle of the stroke in the record, compression positive [m]: displacement in the law is counted from there.
    stroke_positive : {"compression", "extension"}
        Positive direction of the stroke in the record, as stated or detected. In the law compression is positive.
    force_positive : {"compression", "tension"}
        Positive direction of the force in the record.
    damper : dict
        Table to write under ``strut.damper`` in a rig, SI, bump positive. F(v) laws leave the offset out: it is a
        static force and belongs to the preload.
    friction : dict or None
        Table to write under ``strut.friction`` (N, m/s); None when the law has none.
    findings : tuple of Finding
        Findings about record and law.
    """

    law: Annotated[str, Shows("law")]
    parameters: Annotated[dict[str, Estimate], Shows("", lambda fit: fit.units)]
    units: dict[str, str]
    nrmse: Annotated[float, Shows("residual, of the force range", "%", 3)]
    r2: Annotated[float, Shows("R²", "1", 6)]
    rms_residual: Annotated[float, Shows("r.m.s. residual", "N")]
    energy_per_cycle: Annotated[float, Shows("energy per cycle", "J")]
    fitted_energy_per_cycle: Annotated[float, Shows("energy per cycle of the law", "J")]
    cycles: Annotated[float, Shows("cycles", "1")]
    samples: Annotated[int, Shows("samples")]
    displacement_centre: float
    stroke_positive: Annotated[StrokePositive, Shows("positive stroke of the record")]
    force_positive: Annotated[ForcePositive, Shows("positive force of the record")]
    damper: dict[str, Any]
    friction: dict[str, float] | None
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class DamperCurve(Shown):
    """Measured and fitted force side by side, for drawing.

    Attributes
    ----------
    time, displacement, velocity, measured, fitted : array (n,)
        [s], [m] from the middle of the stroke, [m/s], [N], [N].
    """

    time: Array
    displacement: Array
    velocity: Array
    measured: Array
    fitted: Array
