"""Synonyms of public names used in the field, to suggest the right name for a wrong one."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

SYNONYMS: dict[str, tuple[str, ...]] = {
    "bode": ("transfer_function", "linearise"),
    "bump_steer": ("sweep_travel",),
    "calibrate": ("update_model",),
    "comfort": ("ride_metrics",),
    "damper": ("fit_damper",),
    "decrement": ("fit_decay",),
    "doe": ("latin_hypercube", "sobol", "grid"),
    "eigenfrequencies": ("modes",),
    "eigenvalues": ("modes",),
    "fft": ("power_spectrum",),
    "fit": ("update_model", "fit_damper", "fit_decay", "fit_stiffness"),
    "frequency_response": ("transfer_function", "linearise"),
    "frf": ("transfer_function",),
    "from_csv": ("read_recording",),
    "identify": ("update_model",),
    "iso2631": ("ride_metrics",),
    "iso8608": ("Iso8608", "iso_trial"),
    "jacobian": ("gradient", "sensitivities"),
    "kinematics": ("sweep_travel",),
    "log_decrement": ("fit_decay",),
    "mcmc": ("posterior",),
    "minimise": ("optimise",),
    "minimize": ("optimise",),
    "natural_frequencies": ("modes",),
    "open": ("load", "read_recording"),
    "plot": ("plots",),
    "psd": ("power_spectrum", "road_psd"),
    "read": ("read_recording", "load"),
    "read_csv": ("read_recording",),
    "run": ("simulate",),
    "solve": ("simulate",),
    "static": ("equilibrium",),
    "sweep": ("simulate_many", "sweep_travel"),
    "tf": ("transfer_function",),
    "to_csv": ("write_recording",),
    "welch": ("power_spectrum",),
    "write": ("write_recording", "save"),
}
"""Names in other programs and books, in lower case, with the corresponding names in jounce."""


def suggestion(name: str, options: Iterable[str]) -> str:
    """Return the sentence ``Did you mean 'x' or 'y'?``; an empty text without a similar name.

    >>> suggestion("psd", ["power_spectrum", "road_psd", "Rig"]), suggestion("RIG", ["Rig", "load"])
    ("Did you mean 'power_spectrum' or 'road_psd'?", "Did you mean 'Rig'?")
    """
    spelt = {option.lower(): option for option in options}
    near = difflib.get_close_matches(name.lower()[:100], spelt, n=1, cutoff=0.6)
    result = SYNONYMS.get(name.lower()) or [spelt[name_] for name_ in near]
    return f"Did you mean {' or '.join(map(repr, result))}?" if result else ""
