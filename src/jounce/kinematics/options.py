"""Options shared by several kinematics commands: travel, rack."""

from __future__ import annotations

from jounce.core.operation import Mark

TRAVEL = Mark('Wheel travel, bump positive: "-80 mm:80 mm:4 mm", or a single value.', "RANGE")
RACK = Mark('Rack travel, positive to the left: "-20 mm:20 mm:5 mm", or a single value.', "RANGE")
