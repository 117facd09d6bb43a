"""Drawings and animations of suspensions, with positions from the description, a sweep or a run."""

from __future__ import annotations

from jounce.plots.mechanisms.drawing import mechanism

__all__ = ["mechanism"]
