"""What a designer chooses of a rig, and what no design changes."""

import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.design.variables import is_constant
from jounce.parts.files import library


@pytest.mark.parametrize("name", library())
def test_nobody_chooses_gravity_masses_or_tyres(name: str) -> None:
    chosen, every = jn.design_variables(name), jn.load(name).parameters()
    assert chosen
    assert chosen.items() <= every.items()
    for path in chosen:
        words = path.split(".")
        assert not {"gravity", "mass", "tyre", "body", "bodies", "track", "distance"} & set(words)


def test_the_choice_of_a_quarter_car_and_of_a_corner() -> None:
    quarter = ["strut.spring.rate", "strut.spring.preload", "strut.damper.coefficient"]
    assert list(jn.design_variables("audi-a6-quarter-car")) == quarter
    corner = list(jn.design_variables("generic-double-wishbone-curve"))
    assert corner.index("strut.spring.free_length") < corner.index("strut.damper.force[0]")
    assert corner[-1].startswith("hardpoints.")
    assert not any("velocity[" in path or "deflection[" in path for path in corner)


def test_no_design_changes_gravity() -> None:
    assert is_constant("gravity")
    assert is_constant("front.corner.gravity")
    assert not is_constant("body.mass")
    with pytest.raises(DescriptionError, match="constant of nature"):
        jn.pareto("audi-a6-half-car-4dof", {"gravity": "20 %"}, "C", "20 m/s")


def test_a_front_says_which_wheels_its_metrics_combine() -> None:
    free = {"front.damping_coefficient": (1000.0, 5000.0)}
    front = jn.pareto("audi-a6-half-car-4dof", free, "C", "20 m/s", points=3)
    assert front.words == {
        "comfort": "sprung.az, unweighted r.m.s. of front and rear",
        "holding": "tyre.force coefficient, r.m.s. of front and rear",
        "travel": "strut.deflection, r.m.s. of front and rear",
    }
    assert "sprung.az, unweighted r.m.s. of front and rear [m/s^2]" in str(front)
    quarter = jn.pareto(
        "kart-quarter-car", {"strut.damper.coefficient": "20 %"}, "C", "9 m/s", points=3
    )
    assert quarter.words == quarter.metrics
