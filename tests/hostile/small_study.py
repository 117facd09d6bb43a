"""A sweep of twenty runs that takes a second, for tests of what may happen to it meanwhile."""

STUDY = """schema = "jounce.sweep/1"
rig = "kart-quarter-car"
metrics = ["max sprung.az"]
trial = {speed = "2 m/s", duration = "1 s", road = {kind = "step", height = "10 mm", start = "1 m"}}
design = {kind = "monte-carlo", count = 20, seed = 1}
vary = {"strut.spring.rate" = "20 %"}
"""
COMMAND = ("sweep", "study.toml", "--out", "swept", "--workers", "2")
