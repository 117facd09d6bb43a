"""Modal analysis of a rig: oscillatory modes, static equilibrium, and limitations of the linear model."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from jounce.core.findings import Finding
from jounce.core.operation import operation
from jounce.core.serialise import Plain
from jounce.parts import as_rig
from jounce.parts.options import AnyRig
from jounce.ride.stationary import linear_findings
from jounce.simulation import Mode, equilibrium, modes


@dataclass(frozen=True)
class ModalAnalysis(Plain):
    """Oscillatory modes of a rig and its static equilibrium.

    Attributes
    ----------
    modes : tuple of Mode
        Modes in ascending order of natural frequency.
    equilibrium : dict
        Static value by state or channel, SI.
    findings : tuple of Finding
        Effects neglected by the linear model.
    """

    modes: tuple[Mode, ...]
    equilibrium: dict[str, float]
    findings: tuple[Finding, ...]

    def rows(self) -> list[dict[str, Any]]:
        """Return each mode as a row: frequencies (Hz), damping ratio (1), and the amplitudes of its shape."""
        return [
            {
                "mode": number,
                "frequency_hz": mode.frequency_hz,
                "damped_frequency_hz": mode.damped_frequency_hz,
                "damping_ratio": mode.damping_ratio,
                **{name: abs(complex(*amplitude)) for name, amplitude in mode.shape.items()},
            }
            for number, mode in enumerate(self.modes, 1)
        ]


@operation(
    "modes",
    named={"changes": "set"},
    echo={"rig": "rig", "changes": "set"},
    offers=("numbers", "figure", "report"),
    page="jounce.report.models:modal_analysis_page",
    title="Modes of {rig}",
    doing="finding modes",
    example='jounce modes kart-quarter-car --set strut.angle="16 deg"',
)
def modal_analysis(rig: AnyRig) -> ModalAnalysis:
    """Compute the oscillatory modes of a rig or vehicle and its static equilibrium.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library.

    Returns
    -------
    ModalAnalysis
        Results of :func:`jounce.modes` and :func:`jounce.equilibrium`, with effects neglected by the linear model.

    Examples
    --------
    >>> found = modal_analysis("kart-quarter-car")
    >>> [round(mode.frequency_hz, 1) for mode in found.modes]
    [5.1, 28.2]
    """
    rig = as_rig(rig)
    findings = tuple(map(_of_modes, linear_findings(rig, {}, {})))
    return ModalAnalysis(modes(rig), equilibrium(rig), findings)


def _of_modes(finding: Finding) -> Finding:
    """Reword a friction finding: modes neglect dry friction, while other linear models include its slope at rest."""
    if not finding.place.endswith("friction.force"):
        return finding
    text = "dry friction is left out: it damps by no ratio, and holds what moves less than it gives way"
    return replace(finding, severity="note", message=text)
