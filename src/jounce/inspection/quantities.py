"""Notation of an inspection's values and sentences, in English and German."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

Language = Literal["en", "de"]
LANGUAGES: tuple[Language, ...] = ("en", "de")
_MOST_DECIMALS = 6  # maximum number of displayed decimals


class Sentence(NamedTuple):
    """A sentence in each language, with ``{names}`` as placeholders."""

    en: str
    de: str

    def in_language(self, language: Language) -> str:
        """Return the sentence in a language."""
        return self.de if language == "de" else self.en


def with_decimal_sign(number: str, language: Language) -> str:
    """Replace the decimal point by a comma if the language uses one."""
    return number.replace(".", ",") if language == "de" else number


@dataclass(frozen=True)
class WheelQuantity:
    """One value of a wheel.

    Attributes
    ----------
    name : str
        Key in results.
    si : str
        Unit of the value in results and of bare numbers in limits files.
    unit : str
        Displayed unit; empty for plain numbers.
    factor : float
        Displayed value per ``si`` unit.
    decimals : int
        Number of displayed decimals.
    english, german : str
        Names.
    """

    name: str
    si: str
    unit: str
    factor: float
    decimals: int
    english: str
    german: str

    def words(self, language: Language = "en") -> str:
        """Return the name in a language."""
        return self.german if language == "de" else self.english

    def label(self, language: Language = "en") -> str:
        """Return the name with the unit in brackets, for figure titles and column headings."""
        words = self.words(language)
        return f"{words[:1].upper()}{words[1:]}" + (f" [{self.unit}]" if self.unit else "")

    def text(
        self,
        value: float | None,
        language: Language = "en",
        *,
        apart_from: Sequence[float] = (),
        with_unit: bool = True,
    ) -> str:
        """Format a value (``si``), or an en dash for None; German numbers have a decimal comma.

        Decimals are added until the value is distinguishable from each of the limits ``apart_from`` (``si``).

        Examples
        --------
        >>> from jounce.inspection.methods import QUANTITIES
        >>> adhesion = QUANTITIES["adhesion"]
        >>> adhesion.text(0.399), adhesion.text(0.39999, apart_from=[0.4]), adhesion.text(0.5, "de")
        ('39.9 %', '39.999 %', '50,0 %')
        """
        if value is None or not math.isfinite(value):
            return "–"
        decimals = self.decimals
        while decimals < _MOST_DECIMALS and any(
            value != limit
            and self._write_number(value, decimals) == self._write_number(limit, decimals)
            for limit in apart_from
        ):
            decimals += 1
        text = with_decimal_sign(self._write_number(value, decimals).replace("-", "−"), language)
        return self._with_unit(text) if with_unit else text

    def rounded_up(self, half: float, language: Language = "en", *, with_unit: bool = True) -> str:
        """Format the half width of an interval (``si``), always rounded up."""
        step = 10.0**-self.decimals
        shown = math.ceil(half * self.factor / step - 1e-9) * step
        text = with_decimal_sign(f"{shown:.{self.decimals}f}", language)
        return self._with_unit(text) if with_unit else text

    def limit_text(self, value: float, language: Language = "en") -> str:
        """Format a limit (``si``) without trailing zeros: ``40 %``, ``0.13``."""
        text = f"{value * self.factor:.6g}".replace("-", "−")
        return self._with_unit(with_decimal_sign(text, language))

    def _with_unit(self, text: str) -> str:
        return f"{text}{self.unit}" if self.unit == "°" else f"{text} {self.unit}".strip()

    def _write_number(self, value: float, decimals: int) -> str:
        text = f"{value * self.factor:.{decimals}f}"
        return text.lstrip("-") if float(text) == 0.0 else text


NUMBERS: dict[str, WheelQuantity] = {
    quantity.name: quantity
    for quantity in (
        WheelQuantity("static_load", "N", "N", 1.0, 0, "static load", "statische Radlast"),
        WheelQuantity("adhesion", "1", "%", 100.0, 1, "adhesion (EUSAMA)", "Bodenhaftung (EUSAMA)"),
        WheelQuantity(
            "adhesion_frequency_hz", "Hz", "Hz", 1.0, 2, "frequency of the least force", "Frequenz der kleinsten Kraft"
        ),
        WheelQuantity(
            "phase_angle_min_deg", "deg", "°", 1.0, 1, "least phase angle (EGEA)", "kleinster Phasenwinkel (EGEA)"
        ),
        WheelQuantity("phase_frequency_hz", "Hz", "Hz", 1.0, 2, "frequency of that angle", "Frequenz dieses Winkels"),
        WheelQuantity(
            "relative_force_amplitude", "1", "%", 100.0, 1, "relative force amplitude", "relative Kraftamplitude"
        ),
        WheelQuantity("tyre_rigidity", "N/m", "N/mm", 1e-3, 0, "tyre rigidity", "Reifensteifigkeit"),
        WheelQuantity("theta_rig", "1", "", 1.0, 3, "damping ratio on the tester", "Dämpfungsgrad, Prüfstand"),
        WheelQuantity(
            "theta_road", "1", "", 1.0, 3, "damping ratio on the road (THETA)", "Dämpfungsgrad, Straße (THETA)"
        ),
        WheelQuantity("resonance_frequency_hz", "Hz", "Hz", 1.0, 2, "resonance frequency", "Resonanzfrequenz"),
        WheelQuantity(
            "boge_amplitude", "m", "mm", 1e3, 1, "greatest plate movement (BOGE)", "größter Ausschlag (BOGE)"
        ),
        WheelQuantity(
            "body_damping_ratio", "1", "", 1.0, 3,
            "damping ratio of the body on this wheel", "Dämpfungsgrad, Aufbau über dem Rad",
        ),
        WheelQuantity(
            "explained_force", "1", "%", 100.0, 1,
            "force that a linear wheel explains", "Kraft, die ein lineares Rad erklärt",
        ),
    )
}  # fmt: skip
"""All numeric quantities of a wheel by their key in results, in table order."""
