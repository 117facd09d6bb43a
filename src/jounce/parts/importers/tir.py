"""Reader of tyre property files (``.tir``): radial stiffness, damping and radius, with the units of the file."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, at_line, below, nearest
from jounce.core.files import content_of, existing_file
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.units import conversion_factor
from jounce.parts.importers.teim_orbit import SI, UNITS

_SECTION = re.compile(r"\[([A-Za-z0-9_ \t]+)\]")
_VALUE = re.compile(r"([A-Za-z_]\w*)\s*=\s*(.*)")
_BEFORE_COMMENT = re.compile(r"(?:[^'$!]|'[^']*')*")  # $ and ! start a comment, except in quotes
_LARGEST = 20_000_000  # bytes: far above the size of real files; protects memory
_POINTS = 9  # number of samples of a curve that is not a table
_USUAL = {
    "stiffness": (5e3, 5e6, "N/m"),
    "radius": (0.05, 2.0, "m"),
    "damping_coefficient": (0.0, 5e4, "N*s/m"),
}


@dataclass(frozen=True)
class TyreProperties(Shown):
    """Vertical properties of a tyre from its property file, in SI units.

    Attributes
    ----------
    name : str
        Name of the file without its ending.
    file_format : str
        PROPERTY_FILE_FORMAT, e.g. "PAC2002".
    stiffness : float
        Radial stiffness in N/m at the nominal pressure, the scale factor LCZ included.
    damping_coefficient : float
        Radial damping in N*s/m; 0 if the file has none.
    radius : float
        Undeformed radius in m.
    nominal_load : float or None
        FNOMIN in N, the scale factor LFZO not included.
    load_scale : float
        LFZO (1).
    pressure, nominal_pressure : float or None
        Inflation pressure of the file, and nominal pressure of the stiffness, in Pa.
    pressure_slope : float
        PFZ1 (1): relative stiffness increase per relative pressure increase; 0 if the file has none.
    deflection, load : tuple of float
        Measured curve of radial force (N) over deflection (m); empty if the file has none.
    load_curvature : float
        Q_FZ2 (1): coefficient of the squared ratio of deflection to radius in the load; 0 if the file has none.
    bottoming_radius, bottoming_stiffness : float or None
        Radius in m below which the rim hits the road, and rim stiffness in N/m; None if absent or 0.
    bottoming_penetration, bottoming_load : tuple of float
        Curve of the additional rim force (N) over the depth below ``bottoming_radius`` (m); empty if the file has
        none.
    findings : tuple of Finding
        Unusual values, which may reveal a wrong unit, and a note with the deflection (m) of rim contact if `tyre` omits
        the rim.
    """

    name: str
    file_format: str
    stiffness: float
    damping_coefficient: float
    radius: float
    nominal_load: float | None = None
    load_scale: float = 1.0
    pressure: float | None = None
    nominal_pressure: float | None = None
    pressure_slope: float = 0.0
    deflection: tuple[float, ...] = ()
    load: tuple[float, ...] = ()
    load_curvature: float = 0.0
    bottoming_radius: float | None = None
    bottoming_stiffness: float | None = None
    bottoming_penetration: tuple[float, ...] = ()
    bottoming_load: tuple[float, ...] = ()
    findings: tuple[Finding, ...] = field(default=(), compare=False)

    def stiffness_at(self, pressure: float | None = None) -> float:
        """Return the radial stiffness in N/m at an inflation pressure in Pa, by default that of the file.

        The stiffness is linear in the pressure: k (1 + PFZ1 (p - p_nominal) / p_nominal).

        Raises
        ------
        DescriptionError
            If the pressure is not above 0, the file lacks the pressure dependence, or the stiffness is not positive.
        """
        return self.stiffness * self._pressure_factor(pressure)

    def _pressure_factor(self, pressure: float | None) -> float:
        wanted = self.pressure if pressure is None else pressure
        if wanted is None:
            return 1.0
        if not (math.isfinite(wanted) and wanted > 0.0):
            raise DescriptionError(
                "invalid inflation pressure", found=f"{wanted} Pa", allowed="above 0 Pa"
            )
        nominal = self.nominal_pressure
        if nominal is None or self.pressure_slope == 0.0:
            if pressure is None or (
                nominal is not None and math.isclose(pressure, nominal, rel_tol=1e-9)
            ):
                return 1.0
            raise DescriptionError(
                "the file does not state how the stiffness depends on the pressure",
                where=self.name,
                found=f"{pressure:g} Pa",
                allowed="files with PFZ1 and a nominal pressure"
                if nominal is None
                else f"{nominal:g} Pa",
                hint="Leave out the pressure.",
            )
        factor = 1.0 + self.pressure_slope * (wanted - nominal) / nominal
        if factor <= 0.0:
            raise DescriptionError(
                "the stiffness is not positive at this pressure",
                where=self.name,
                found=f"{wanted:g} Pa",
                allowed=Phrase(
                    "above {nominal:g} Pa", nominal=nominal * (1.0 - 1.0 / self.pressure_slope)
                ),
            )
        return factor

    def tyre(self, pressure: float | None = None, *, rim: bool = False) -> dict[str, Any]:
        """Return a tyre table for rigs: ``stiffness`` or ``curve``, ``damping_coefficient`` and ``undeformed_radius``.

        The table has a curve if the file has a measured curve or Q_FZ2. ``pressure`` is in Pa, by default that of the
        file. Lumped tyres have no ``undeformed_radius`` (m): remove it for them. With ``rim``, the curve includes rim
        contact below ``bottoming_radius``.
        """
        factor = self._pressure_factor(pressure)
        tyre: dict[str, Any] = {"stiffness": self.stiffness * factor}
        if self.load:
            force = [factor * value for value in self.load]
            tyre = {"curve": {"kind": "table", "deflection": list(self.deflection), "force": force}}
        elif self.load_curvature and self.nominal_load:
            share = self.stiffness * self.radius / self.nominal_load
            if share**2 < 4.0 * self.load_curvature:
                raise DescriptionError(
                    "Q_FZ2 is too large for the stiffness: the force would not rise from zero deflection",
                    where=self.name,
                    found=f"{self.load_curvature:g}",
                    allowed=Phrase("up to {share:.4g}", share=0.25 * share**2),
                )
            first = math.sqrt(share**2 - 4.0 * self.load_curvature)
            scale = factor * self.nominal_load / self.radius
            terms = [scale * first, scale * self.load_curvature / self.radius]
            tyre = {"curve": {"kind": "polynomial", "coefficients": terms}}
        if (
            rim
            and self.bottoming_radius is not None
            and (self.bottoming_penetration or self.bottoming_stiffness)
        ):
            tyre = {"curve": self._with_rim(tyre, self.radius - self.bottoming_radius)}
        return {
            **tyre,
            "damping_coefficient": self.damping_coefficient,
            "undeformed_radius": self.radius,
        }

    def _with_rim(self, tyre: dict[str, Any], free: float) -> dict[str, Any]:
        """Return the table of a tyre whose rim hits the road at a deflection ``free`` (m)."""
        depth, load = self.bottoming_penetration, self.bottoming_load
        if not depth:
            depth, load = (0.0, 0.1 * free), (0.0, 0.1 * free * (self.bottoming_stiffness or 0.0))
        own = tyre.get("curve", {})
        deflections = np.array(
            own.get("deflection", np.linspace(0.0, free, _POINTS) if own else [0.0])
        )
        at = np.unique([*deflections, free, *(free + extra for extra in depth)])
        if own.get("kind") == "polynomial":
            first, second = own["coefficients"]
            force = first * at + second * at**2
        elif own:
            rise = (own["force"][-1] - own["force"][-2]) / (deflections[-1] - deflections[-2])
            force = np.interp(at, deflections, own["force"]) + rise * np.maximum(
                at - deflections[-1], 0.0
            )
        else:
            force = tyre["stiffness"] * at
        force = force + np.interp(at - free, depth, load, left=0.0)
        return {"kind": "table", "deflection": at.tolist(), "force": force.tolist()}


def read_tir(path: Path | str) -> TyreProperties:
    r"""Read the vertical properties from a tyre property file.

    Parameters
    ----------
    path : Path or str
        Text file with ``[SECTIONS]`` and ``KEY = value`` lines, from PAC2002, MF-Tyre 5 or 6 and similar models.

    Returns
    -------
    TyreProperties
        Stiffness (N/m), damping (N*s/m), radius (m) and related values, converted from the units in section [UNITS];
        the scale factor LCZ is applied to the stiffness.

    Raises
    ------
    DescriptionError
        For a missing or binary file, a missing section [UNITS], unknown units, a missing stiffness or radius, keys
        given twice with different values, text instead of numbers, and values out of range; each with its line.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "small.tir"
    >>> _ = file.write_text(
    ...     "[UNITS]\nLENGTH = 'mm'\nFORCE = 'newton'\nTIME = 'second'\n[DIMENSION]\nUNLOADED_RADIUS = 300\n"
    ...     "[VERTICAL]\nVERTICAL_STIFFNESS = 200 $ N/mm\nVERTICAL_DAMPING = 0.05\n"
    ... )
    >>> tyre = read_tir(file)
    >>> tyre.stiffness, tyre.damping_coefficient, tyre.radius
    (200000.0, 50.0, 0.3)
    """
    entries = _Entries(Path(path))
    length, force = entries.unit("LENGTH"), entries.unit("FORCE")
    rate = force / length
    stiffness = entries.number(
        ("VERTICAL", "PARAMETER"), "VERTICAL_STIFFNESS", rate, needed=True, above=0.0
    )
    scale = entries.number(("SCALING_COEFFICIENTS", "SCALING"), "LCZ", 1.0, above=0.0)
    damping = entries.number(
        ("VERTICAL", "PARAMETER"), "VERTICAL_DAMPING", rate * entries.unit("TIME"), at_least=0.0
    )
    radius = entries.number(("DIMENSION",), "UNLOADED_RADIUS", length, needed=True, above=0.0)
    conditions = (
        "TIRE_CONDITIONS",
        "OPERATING_CONDITIONS",
        "INFLATION_PRESSURE",
        "VERTICAL",
        "MODEL",
    )
    pressures = [
        entries.pressure(conditions, names) for names in (("IP", "INFLPRES"), ("IP_NOM", "NOMPRES"))
    ]
    deflection, load = entries.curve("DEFLECTION_LOAD_CURVE", length, force)
    penetration, rim_load = entries.curve("BOTTOMING_CURVE", length, force)
    rim_radius = entries.number(("DIMENSION", "VERTICAL"), "BOTTOMING_RADIUS", length) or None
    rim_stiffness = entries.number(("VERTICAL",), "BOTTOM_STIFF", rate) or None
    tyre: dict[str, Any] = {
        "stiffness": (stiffness or 0.0) * (scale or 1.0),
        "damping_coefficient": damping or 0.0,
        "radius": radius or 0.0,
    }
    return TyreProperties(
        name=entries.file.stem,
        file_format=entries.text("MODEL", "PROPERTY_FILE_FORMAT")
        or entries.text("MODEL", "FITTYP")
        or "",
        **tyre,
        nominal_load=entries.number(("VERTICAL",), "FNOMIN", force, above=0.0),
        load_scale=entries.number(("SCALING_COEFFICIENTS", "SCALING"), "LFZO", 1.0, above=0.0)
        or 1.0,
        pressure=pressures[0],
        nominal_pressure=pressures[1],
        pressure_slope=entries.number(("VERTICAL",), "PFZ1", 1.0) or 0.0,
        deflection=deflection,
        load=load,
        load_curvature=entries.number(("VERTICAL",), "Q_FZ2", 1.0) or 0.0,
        bottoming_radius=rim_radius,
        bottoming_stiffness=rim_stiffness,
        bottoming_penetration=penetration,
        bottoming_load=rim_load,
        findings=(
            *_note_unusual(entries.file.stem, tyre),
            *_note_rim(
                entries.file.stem,
                tyre["radius"],
                rim_radius,
                has_rim=bool(penetration or rim_stiffness),
            ),
        ),
    )


def _note_rim(
    name: str, radius: float, rim_radius: float | None, *, has_rim: bool
) -> tuple[Finding, ...]:
    """Return a note if the file describes rim contact, which a rig's tyre omits by default."""
    if not has_rim:
        return ()
    if rim_radius is None:
        return (finding("parts.import_no_bottoming_radius", name),)
    deflection = radius - rim_radius
    return (finding("parts.rim_left_out", name, deflection, deflection=deflection),)


def _note_unusual(name: str, tyre: dict[str, float]) -> tuple[Finding, ...]:
    return tuple(
        finding("parts.unusual_tyre", name, tyre[key], key=key, value=tyre[key], unit=unit)
        for key, (low, high, unit) in _USUAL.items()
        if not low <= tyre[key] <= high
    )


def tyre_from_tir(
    path: Path | str, *, pressure: float | None = None, rim: bool = False
) -> dict[str, Any]:
    r"""Read a tyre property file as a table for rigs.

    Parameters
    ----------
    path : Path or str
        The ``.tir`` file.
    pressure : float, optional
        Inflation pressure in Pa; by default that of the file.
    rim : bool
        Include rim contact in the curve, if the file describes bottoming.

    Returns
    -------
    dict
        ``stiffness`` (N/m) or ``curve``, ``damping_coefficient`` (N*s/m) and ``undeformed_radius`` (m).

    Raises
    ------
    DescriptionError
        As `read_tir`, and if the file lacks the pressure dependence of the stiffness.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "small.tir"
    >>> _ = file.write_text(
    ...     "[UNITS]\nLENGTH='meter'\nFORCE='newton'\nTIME='second'\n[DIMENSION]\nUNLOADED_RADIUS=0.3\n"
    ...     "[VERTICAL]\nVERTICAL_STIFFNESS=2e5\n"
    ... )
    >>> tyre_from_tir(file)
    {'stiffness': 200000.0, 'damping_coefficient': 0.0, 'undeformed_radius': 0.3}
    """
    return read_tir(path).tyre(pressure, rim=rim)


class _Entries:
    """Keys and tables of a file by section, with line numbers."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.values: dict[tuple[str, str], tuple[str, int]] = {}
        self.rows: dict[str, list[tuple[list[str], int]]] = {}
        section = ""
        if existing_file(file).stat().st_size > _LARGEST:
            allowed = Phrase("at most {largest} MB", largest=_LARGEST // 1_000_000)
            raise DescriptionError(
                "the file is too large for a tyre property file", where=str(file), allowed=allowed
            )
        content = content_of(file)
        if b"\0" in content:
            raise DescriptionError(
                "not a text file", where=str(file), allowed="a tyre property file"
            )
        for number, line in enumerate(content.decode("cp1252", errors="replace").splitlines(), 1):
            text = _BEFORE_COMMENT.match(line)
            bare = text[0].strip() if text else ""
            if match := _SECTION.fullmatch(bare):
                section = match[1].strip().upper()
            elif match := _VALUE.fullmatch(bare):
                self._keep(
                    (section, match[1].upper()), match[2].strip().strip("'\"").strip(), number
                )
            elif bare and not bare.startswith(("{", "(")):
                self.rows.setdefault(section, []).append((bare.split(), number))
        if not self.values:
            raise DescriptionError(
                "not a tyre property file", where=str(file), allowed="[SECTIONS] with KEY = value"
            )
        if not any(section == "UNITS" for section, _ in self.values):
            raise DescriptionError(
                "the section [UNITS] is missing",
                where=str(file),
                allowed="[UNITS] with LENGTH, FORCE and TIME",
                hint="Without it, N/mm and N/m cannot be distinguished.",
            )

    def _keep(self, key: tuple[str, str], text: str, line: int) -> None:
        if key in self.values and self.values[key][0] != text:
            raise DescriptionError(
                Phrase("{key} is given twice in [{second_key}]", key=key[1], second_key=key[0]),
                where=at_line(self.file, line),
                found=f"{self.values[key][0]} and {text}",
            )
        self.values.setdefault(key, (text, line))

    def text(self, section: str, key: str) -> str | None:
        entry = self.values.get((section, key))
        return entry[0] if entry else None

    def unit(self, quantity: str) -> float:
        """Return the SI value of the unit declared in [UNITS] for a quantity."""
        entry = self.values.get(("UNITS", quantity))
        if entry is None:
            raise DescriptionError(
                Phrase("the unit for {quantity} is missing", quantity=quantity),
                where=f"{self.file}: [UNITS]",
            )
        known = {word: unit for words, unit in UNITS[quantity].items() for word in words.split()}
        unit = known.get(entry[0].lower())
        if unit is None:
            raise DescriptionError(
                Phrase("unknown unit for {quantity}", quantity=quantity),
                where=at_line(self.file, entry[1]),
                found=entry[0],
                allowed=", ".join(words.split()[0] for words in UNITS[quantity]),
                hint=nearest(entry[0].lower(), known),
            )
        return conversion_factor(unit, SI[quantity])

    def number(
        self,
        sections: tuple[str, ...],
        key: str,
        unit: float,
        *,
        needed: bool = False,
        above: float | None = None,
        at_least: float | None = None,
    ) -> float | None:
        """Return the SI value from the first section that has the key, or None."""
        for section in sections:
            if (section, key) in self.values:
                text, line = self.values[section, key]
                value = _number(text, below(at_line(self.file, line), key))
                word, bound = ("above", above) if above is not None else ("at least", at_least)
                if bound is not None and (value < bound or (value == bound and above is not None)):
                    where = below(at_line(self.file, line), key)
                    raise DescriptionError(
                        "out of range", where=where, found=text, allowed=f"{word} {bound:g}"
                    )
                return value * unit
        if needed:
            keys = [name for section, name in self.values if section in sections]
            raise DescriptionError(
                Phrase("{key} is missing", key=key),
                where=str(self.file),
                allowed=Phrase(
                    "{key} in {sections}",
                    key=key,
                    sections=" or ".join(f"[{section}]" for section in sections),
                ),
                hint=nearest(key, keys),
            )
        return None

    def pressure(self, sections: tuple[str, ...], keys: tuple[str, ...]) -> float | None:
        """Return the pressure in Pa under any of its names, or None; 0 means not stated."""
        for key in keys:
            if any((section, key) in self.values for section in sections):
                declared = ("UNITS", "PRESSURE") in self.values
                is_si = self.unit("LENGTH") == 1.0 and self.unit("FORCE") == 1.0
                if not declared and not is_si:
                    raise DescriptionError(
                        "the unit for PRESSURE is missing", where=f"{self.file}: [UNITS]"
                    )
                return (
                    self.number(
                        sections, key, self.unit("PRESSURE") if declared else 1.0, at_least=0.0
                    )
                    or None
                )
        return None

    def curve(
        self, section: str, length: float, force: float
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Return ascending deflections (m) and loads (N) of a table."""
        pairs = []
        for cells, line in self.rows.get(section, []):
            where = below(at_line(self.file, line), f"[{section}]")
            if len(cells) != 2:
                raise DescriptionError(
                    "a pair of numbers is required", where=where, found=" ".join(cells)
                )
            pairs.append((_number(cells[0], where) * length, _number(cells[1], where) * force))
            if len(pairs) > 1 and not (
                pairs[-1][0] > pairs[-2][0] and pairs[-1][1] >= pairs[-2][1]
            ):
                raise DescriptionError(
                    "the curve does not increase", where=where, found=" ".join(cells)
                )
        if len(pairs) == 1:
            raise DescriptionError(
                "the curve has one point", where=f"{self.file}: [{section}]", allowed="2 or more"
            )
        return tuple(x for x, _ in pairs), tuple(y for _, y in pairs)


def _number(text: str, where: str) -> float:
    try:
        value = float(re.sub(r"[dD](?=[+-]?\d+$)", "e", text)) if "_" not in text else math.nan
    except ValueError:
        hint = "Write a decimal point." if re.fullmatch(r"[+-]?\d+,\d+", text) else ""
        raise DescriptionError("not a number", where=where, found=text, hint=hint) from None
    if not math.isfinite(value):
        raise DescriptionError("not a finite number", where=where, found=text)
    return value
