"""Values that must be above zero are refused with what would be allowed."""

from __future__ import annotations

import pytest

from jounce.core.errors import DescriptionError
from jounce.core.units import positive_si


def test_values_that_must_be_above_zero() -> None:
    assert positive_si("2 mm", "m", where="length") == 0.002
    assert positive_si(0.0, "1", where="share", zero=True) == 0.0
    with pytest.raises(
        DescriptionError, match=r"length: out of range; found '0 mm'; allowed: above 0 m\."
    ):
        positive_si("0 mm", "m", where="length")
    with pytest.raises(
        DescriptionError, match=r"share: out of range; found -0\.1; allowed: at least 0\."
    ):
        positive_si(-0.1, "1", where="share", zero=True)
