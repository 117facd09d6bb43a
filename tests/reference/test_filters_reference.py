"""Published coefficients of SAE J211 / ISO 6487 filters."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.recordings.signals import cfc_coefficients

pytestmark = pytest.mark.source(
    kind="computed",
    of="signals and identification",
    key="sae-j211",
    where="Appendix C: the recursion, evaluated by hand",
    tolerance="eight digits",
)


def test_cfc_60_at_10_khz() -> None:
    # SAE J211-1 appendix C recursion evaluated for CFC 60 at T = 1e-4 s, eight digits
    expected = (0.00145237, 0.00290473, 0.00145237, 1.88934322, -0.89515269)
    np.testing.assert_allclose(cfc_coefficients(60.0, 10e3), expected, rtol=0.0, atol=6e-9)


def test_cfc_1000_at_10_khz_lies_at_1_751_times_the_class() -> None:
    # the bilinear transform moves -3 dB from 1.667 CFC to 1.751 CFC at this rate
    a0, a1, a2, b1, b2 = cfc_coefficients(1000.0, 10e3)
    z = np.exp(-2j * np.pi * 1.751 * 1000.0 / 10e3)
    two_passes = abs((a0 + a1 * z + a2 * z * z) / (1.0 - b1 * z - b2 * z * z)) ** 2
    np.testing.assert_allclose(two_passes, np.sqrt(0.5), rtol=5e-4)
