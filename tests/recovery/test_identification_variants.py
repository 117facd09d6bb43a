"""No estimate is silently wrong: records of known truths in every sign, datum and sampling, as the pages list."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

_FILE = Path(__file__).parent.parent.parent / "docs" / "identification_variants.py"
_SPEC = importlib.util.spec_from_file_location("identification_variants", _FILE)
VARIANTS = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(VARIANTS)


@pytest.mark.parametrize("subject", VARIANTS.SUBJECTS)
def test_nothing_is_silently_wrong(subject):
    tried, right, flagged, silent = VARIANTS.counts(subject)
    assert silent == 0
    assert right + flagged == tried
    assert tried >= 8
    assert right >= tried // 2 - tried // 8
