"""Where arrays lie that a step reads a vector at a time."""

import numpy as np
import pytest

from jounce.variants.side_by_side import _align, _spans


@pytest.mark.parametrize("shape", [(13, 24), (88, 8), (1, 32)])
def test_vectors_lie_within_lines_of_the_cache(shape):
    array = np.arange(np.prod(shape), dtype=float).reshape(shape)
    shifted = np.append(0.0, array)[1:].reshape(
        shape
    )  # which begins 8 bytes farther than memory is given out
    found = _align(shifted)
    assert found.ctypes.data % 64 == 0
    assert found.flags.c_contiguous
    assert found.flags.writeable
    np.testing.assert_array_equal(found, array)


@pytest.mark.parametrize("count", [4, 24, 1000, 4321])
@pytest.mark.parametrize("workers", [1, 2, 7])
def test_variants_are_handed_out_once_each_in_whole_blocks_ever_fewer(count, workers):
    spans = _spans(count, 24, workers)
    assert [row for first, last in spans for row in range(first, last)] == list(range(count))
    assert all(first % 24 == 0 for first, _ in spans)
    sizes = [last - first for first, last in spans]
    assert sizes == sorted(sizes, reverse=True)
    assert workers > 1 or len(spans) == 1
    if count > 24 * 4 * workers:  # then nobody is left alone with more than a few blocks
        assert max(sizes) <= -(-count // workers)
        assert workers == 1 or sizes[-1] <= 24
