"""No estimate is silently wrong: records of known truths in every sign, datum and sampling, as the pages list."""

from __future__ import annotations

import identification_variants
import pytest

RIGHT = {
    "dampers": (132, 192),
    "springs": (8, 8),
    "free decays": (48, 48),
    "updates": (15, 30),
    "files of dampers": (199, 280),
    "files of springs": (189, 230),
}
"""Golden: how many of how many variants are right. Of the others a finding names the cause, or they are refused."""


@pytest.mark.some(3)
@pytest.mark.usefixtures("units_kept")
@pytest.mark.parametrize("subject", identification_variants.SUBJECTS)
def test_nothing_is_silently_wrong(subject):
    tried, right, _, silent = identification_variants.counts(subject)
    assert silent == 0
    assert (right, tried) == RIGHT[subject.partition(":")[0]]


@pytest.mark.parametrize("subject", identification_variants.FILES)
def test_a_sound_file_is_right_without_a_warning(subject):
    records, fit = identification_variants.FILES[subject]
    verdicts = [identification_variants.judged(one, fit) for one in records() if not one.about]
    assert set(verdicts) == {"right"}
    assert len(verdicts) >= 20
