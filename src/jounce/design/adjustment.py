"""Adjustments of a rig for commands and pages: settings, or the lengths for a required camber and toe."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.operation import Number, Settings, operation
from jounce.core.serialise import Plain, to_plain
from jounce.design.adjustments import AdjustReport, Lengths, adjust_report, lengths_for
from jounce.kinematics.adjustments import SETTINGS, write_setting
from jounce.parts import Corner, as_rig
from jounce.parts.options import RigAlone

_LARGEST = 0.35  # rad: largest angle of an adjustment; a larger bare number is taken as degrees
Angle = float | str | None


@dataclass(frozen=True)
class Adjustment(Plain):
    """Effects of adjustments on a rig.

    Attributes
    ----------
    report : AdjustReport
        The wheel before and after; if no setting was made, the effect of each possible setting.
    lengths : Lengths or None
        Lengths found for the required camber and toe.
    """

    report: AdjustReport
    lengths: Lengths | None

    @property
    def rig(self) -> Corner:
        """The adjusted rig."""
        return self.report.rig

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings of the report."""
        return self.report.findings

    @property
    def settings(self) -> str:
        """Settings in words, preceded by "with"; empty without settings."""
        made = ", ".join(
            f"{name} {write_setting(value, SETTINGS[name].unit)}"
            for name, value in self.report.settings.items()
        )
        return f" with {made}" if made else ""

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI."""
        report = self.report
        effects = [
            {
                **to_plain(effect),
                "text": SETTINGS[effect.setting].text,
                "source": SETTINGS[effect.setting].source,
            }
            for effect in report.effects
        ]
        return {
            "settings": report.settings,
            "lengths": to_plain(self.lengths),
            "before": to_plain(report.before),
            "after": to_plain(report.after),
            "over_travel": to_plain(report.over_travel),
            "effects": effects,
            "findings": to_plain(self.findings),
        }


def check_adjusted(**given: Any) -> None:
    """Reject an output file if nothing changes the rig."""
    if given["out"] is not None and not any(given[name] for name in ("set_", "camber", "toe")):
        raise DescriptionError(
            "nothing to adjust", where="--out", allowed="--out with --set, --camber or --toe"
        )


@operation(
    "adjust",
    named={"settings": "set"},
    echo={"rig": "rig"},
    offers=("changed_rig",),
    check="jounce.design.adjustment:check_adjusted",
    page="jounce.report.adjustment:adjustment_page",
    title="{rig}{result.settings}",
    doing="sweeping",
    example='jounce adjust kart-double-wishbone --camber "-2 deg" --toe "0.5 deg" --out cambered.toml',
)
def adjust_rig(
    rig: RigAlone,
    settings: Annotated[
        Mapping[str, float | str] | None,
        Settings(
            'Adjust a setting: upper_arm_length="10 mm". Repeat it.',
            "SETTING=VALUE",
            'upper_arm_length="10 mm"',
        ),
    ] = None,
    camber: Annotated[
        Angle,
        Number(
            'Find the length of an arm or link for this camber, top outward positive: "-2 deg".',
            "ANGLE",
            "rad",
            most=_LARGEST,
        ),
    ] = None,
    toe: Annotated[
        Angle,
        Number(
            'Find the tie-rod length for this toe, toe-in positive: "0.5 deg".',
            "ANGLE",
            "rad",
            most=_LARGEST,
        ),
    ] = None,
) -> Adjustment:
    """Show the effect of the prototype's adjustments, apply them, or find the lengths for a camber and a toe.

    Parameters
    ----------
    rig : Rig, str or Path
        A rig with hardpoints, its file or its name in the library.
    settings : mapping, optional
        Setting to its value, text with a unit or SI.
    camber, toe : float or str, optional
        Required static angles, rad; top outward and toe-in positive.

    Returns
    -------
    Adjustment
        SI.

    Raises
    ------
    DescriptionError
        For settings that the rig does not have, values out of range, and a length that is both given and to be found.

    Examples
    --------
    >>> found = adjust_rig("kart-double-wishbone", camber="-2 deg", toe="0.5 deg")
    >>> round(found.report.after.camber, 4), round(found.report.after.toe, 4)
    (-0.0349, 0.0087)
    """
    rig, made = as_rig(rig), dict(settings or {})
    lengths = lengths_for(rig, camber, toe) if camber is not None or toe is not None else None
    if lengths is not None:
        for name in made:
            if name == "camber_plate" or (name.endswith("_length") and name != "pushrod_length"):
                hint = "Leave it out, or --camber and --toe."
                raise DescriptionError(
                    "a length is both given and to be found", where=f"--set {name}", hint=hint
                )
        made |= lengths.settings()
    return Adjustment(adjust_report(rig, made, effects=not made), lengths)
