"""What is known about the rig at one point of a campaign, and the rig as it was set up for each trial."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from jounce.identify.update import UpdatedParameter
from jounce.parts import Rig
from jounce.parts.variants import with_strut_angle

TyreTable = dict[str, Any]
_TYRE_PATHS = ("tyre.stiffness", "tyre.curve")


@dataclass(frozen=True)
class Knowledge:
    """Rig values that hold for all trials, and the tyre's elastic law at each pressure (Pa) that has its own.

    ``between`` gives the tyre at a pressure that was not measured, or None where nothing is known about pressure.
    """

    rig: Rig
    tyres: Mapping[float, TyreTable] = field(default_factory=dict)
    between: Callable[[float], TyreTable] | None = None

    def tyre_at(self, pressure: float | None) -> TyreTable:
        """Elastic law of the tyre at a pressure, as a rig file writes it; empty: the rig's own."""
        if pressure is None:
            return {}
        if pressure in self.tyres:
            return self.tyres[pressure]
        return self.between(pressure) if self.between is not None else {}

    def rig_for(self, strut_angle: float | None, pressure: float | None, changes: Mapping[str, Any]) -> Rig:
        """Rig as set up for one trial: strut angle (rad), pressure (Pa) and further changes by path.

        A 3-D rig's strut is turned about its lower end, see :func:`jounce.parts.variants.with_strut_angle`.
        """
        rig = with_tyre(self.rig, self.tyre_at(pressure))
        rig = rig if strut_angle is None else with_strut_angle(rig, strut_angle)
        return rig.with_changes(dict(changes)) if changes else rig

    def after(self, fitted: Mapping[str, UpdatedParameter], pressures: Sequence[float | None]) -> Knowledge:
        """Take over fitted values; those of the tyre hold for the pressures they were fitted at, all others always."""
        tyre = {path: p for path, p in fitted.items() if path.startswith(_TYRE_PATHS)}
        rig = self.rig.with_changes({path: p.value for path, p in fitted.items() if path not in tyre})
        if not tyre:
            return Knowledge(rig, self.tyres, self.between)
        tyres = dict(self.tyres)
        for pressure in dict.fromkeys(pressures):
            set_up = with_tyre(rig, self.tyre_at(pressure))
            start = set_up.parameters()
            scaled = set_up.with_changes(
                {path: start[path] * p.value / p.initial if p.initial else p.value for path, p in tyre.items()}
            )
            if pressure is not None:
                tyres[pressure] = tyre_of(scaled)
            if pressure == pressures[0]:
                rig = scaled
        return Knowledge(rig, tyres, self.between)


def with_tyre(rig: Rig, table: TyreTable) -> Rig:
    """Give the rig with the elastic law of its tyre replaced; an empty table changes nothing."""
    if not table:
        return rig
    dump = rig.model_dump(by_alias=True, exclude_none=True)
    kept = {key: value for key, value in dump["tyre"].items() if key not in ("stiffness", "curve")}
    return type(rig).from_table({**dump, "tyre": {**kept, **table}})


def tyre_of(rig: Rig) -> TyreTable:
    """Elastic law of a rig's tyre, as a rig file writes it."""
    tyre = rig.model_dump(by_alias=True, exclude_none=True)["tyre"]
    return {key: tyre[key] for key in ("stiffness", "curve") if key in tyre}
