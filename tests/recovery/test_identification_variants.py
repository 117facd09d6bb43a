"""No estimate is silently wrong: records of known truths in every sign, datum and sampling, as the pages list."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

_FILE = Path(__file__).parent.parent.parent / "docs" / "identification_variants.py"
_SPEC = importlib.util.spec_from_file_location("identification_variants", _FILE)
VARIANTS = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(VARIANTS)


RIGHT = {"dampers": (132, 192), "springs": (8, 8), "free decays": (48, 48), "updates": (15, 30)}
"""Golden: how many of how many variants are right. The others are turned, and a finding says so."""


@pytest.mark.parametrize("subject", VARIANTS.SUBJECTS)
def test_nothing_is_silently_wrong(subject):
    tried, right, _, silent = VARIANTS.counts(subject)
    assert silent == 0
    assert (right, tried) == RIGHT[subject.partition(":")[0]]
