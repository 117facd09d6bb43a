"""Options shared by several design searches: design variables, limits, road, speed, band."""

from __future__ import annotations

from jounce.core.operation import Band, Mark, Number, Ranges

FREE = Ranges(
    'Design variable and its bounds: front.spring_rate="±30 %" or "20..40 N/mm". Repeat it.',
    "PATH=BOUNDS",
    'front.spring_rate="±30 %"',
)
LIMITS = Ranges(
    'Constraint: strut.deflection="20 mm" (at most), "mode 1 frequency"="1.2..1.5 Hz". Repeat it.',
    "METRIC=LIMIT",
    'strut.deflection="20 mm"',
)
RANDOM_ROAD = Mark(
    "A class of ISO 8608 (iso:A to iso:H), or its roughness G_d(0.1 1/m), e.g. 256e-6 m^3.", "ROAD"
)
ROAD_SPEED = Number('Speed over the road, e.g. "20 m/s".', "SPEED", "m/s", is_positive=True)
ROAD_BAND = Band(
    'Band of spatial frequencies: iso (0.011 to 2.83 1/m) or "0.02..3"; unlimited by default where possible.',
    "BAND",
    "1/m",
    ("iso",),
)
