"""Arrays passed to the loops: type, number of dimensions and order in memory.

The machine code of a loop is compiled for exactly these layouts. They are stated in the annotations of the loop and of
its tuple arguments, and checked at every call (``call.Loop``).
"""

from __future__ import annotations

from typing import Annotated, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array, Complex


class Layout(NamedTuple):
    """Number of dimensions, order in memory (rows, C, or columns, F, side by side without gaps) and NumPy's type.

    The type is repeated here because the internals of ``NDArray`` differ between versions of NumPy.
    """

    dimensions: int
    order: str = "C"
    dtype: str = "float64"


Vector: TypeAlias = Annotated[Array, Layout(1)]
Matrix: TypeAlias = Annotated[Array, Layout(2)]
Block: TypeAlias = Annotated[Array, Layout(3)]
Columns: TypeAlias = Annotated[Array, Layout(2, "F")]
Integers: TypeAlias = Annotated[NDArray[np.int64], Layout(1, dtype="int64")]
IntegerMatrix: TypeAlias = Annotated[NDArray[np.int64], Layout(2, dtype="int64")]
ComplexVector: TypeAlias = Annotated[Complex, Layout(1, dtype="complex128")]
