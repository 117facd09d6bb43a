"""Where arrays lie that a step reads a vector at a time."""

import numpy as np
import pytest

from jounce.variants.side_by_side import _in_line


@pytest.mark.parametrize("shape", [(13, 24), (88, 8), (1, 32)])
def test_vectors_lie_within_lines_of_the_cache(shape):
    array = np.arange(np.prod(shape), dtype=float).reshape(shape)
    shifted = np.append(0.0, array)[1:].reshape(shape)  # which begins 8 bytes farther than memory is given out
    found = _in_line(shifted)
    assert found.ctypes.data % 64 == 0
    assert found.flags.c_contiguous
    assert found.flags.writeable
    np.testing.assert_array_equal(found, array)
