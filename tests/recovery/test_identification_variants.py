"""No estimate is silently wrong: records of known truths in every sign, datum and sampling, as the pages list."""

from __future__ import annotations

import identification_variants
import pytest

RIGHT = {"dampers": (132, 192), "springs": (8, 8), "free decays": (48, 48), "updates": (15, 30)}
"""Golden: how many of how many variants are right. The others are turned, and a finding says so."""


@pytest.mark.parametrize("subject", identification_variants.SUBJECTS)
def test_nothing_is_silently_wrong(subject):
    tried, right, _, silent = identification_variants.counts(subject)
    assert silent == 0
    assert (right, tried) == RIGHT[subject.partition(":")[0]]
