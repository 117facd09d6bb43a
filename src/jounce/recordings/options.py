"""How people give what is needed to read a measured file: its columns, its sampling, its part."""

from __future__ import annotations

from jounce.core.operation import Columns, File, Mark, Number

LONGEST_STEP = 1.0
"""Sampling interval (s) above which a bare number is taken for milliseconds."""
COLUMNS = Columns(
    r'Column that holds a quantity, with its unit if the header gives none: force="F \[kN]". Repeat it.',
    "NAME=COLUMN",
    'force="F [kN]"',
)
VARIABLE = Mark(
    "Matrix or struct of a .mat file, group of a .tdms file, or sheet of a workbook (or rows: Run!5:300).", "VARIABLE"
)
SAMPLE_TIME = Number(
    'Constant sampling interval of a file without time, e.g. "10 ms".', "TIME", "s", is_positive=True, most=LONGEST_STEP
)
RESAMPLE = Number(
    'Bring irregular time, or signals at different instants, onto constant steps, e.g. "10 ms".',
    "TIME",
    "s",
    is_positive=True,
    most=LONGEST_STEP,
)
DATABASE = File("Database of bus messages (.dbc) with which the bus frames of an MDF file are decoded.")
