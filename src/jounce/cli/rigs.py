"""The rig of a command: loaded, changed, and what looks wrong with it said on stderr."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jounce.parts import Rig


def chosen_rig(name: str, wanted: dict[str, Any]) -> Rig:
    """Load a rig and change its values; every warning about it is one line on stderr, as in ``jounce check``."""
    from jounce.parts import load

    rig = load(name)
    rig = rig.with_changes(wanted) if wanted else rig
    warn_of(rig, name)
    return rig


def warn_of(rig: Rig, name: str) -> None:
    """Say on stderr what looks wrong with a rig; notes are left to ``jounce check``."""
    from jounce.parts import rig_findings

    sys.stderr.writelines(f"{found}\n" for found in rig_findings(rig, name) if found.severity != "note")
