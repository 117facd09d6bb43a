"""Scaling of the prototype (paper 1 section 3 Eq. 1, domain A3)."""

import pytest

from jounce.bench.similitude import Similitude, scaled_mass, similitude_report
from jounce.core.errors import FitError
from jounce.core.serialise import to_json

pytestmark = pytest.mark.source(
    kind="computed",
    of="bench",
    key="quarter-car-prototype",
    where="section 3, eq. (1), calculated by hand",
    tolerance="half a unit of the last digit, or 0.04 %",
)


@pytest.mark.parametrize(
    ("density_ratio", "mass"),
    # domain A3: same density, steel 7850 -> cast iron 7150, steel 7800 -> 7150, and the density that gives 16.0 exactly
    [(1.0, 16.960), (7150 / 7850, 15.448), (7150 / 7800, 15.547), (7150 / 7579, 16.0)],
)
def test_mass_by_equation_1(density_ratio, mass):
    assert scaled_mass(265.0, 2.5, density_ratio=density_ratio) == pytest.approx(mass, abs=6e-4)


def test_the_built_mass_is_neither():
    report = similitude_report()
    assert report.mass_same_density == pytest.approx(16.960, abs=5e-4)
    assert report.mass_prototype_density == pytest.approx(15.448, abs=5e-4)
    assert report.density_for_built_mass == pytest.approx(7579.0, abs=0.5)
    assert report.effective_mass_factor == pytest.approx(2.471, abs=5e-4)
    same = similitude_report(Similitude(reference_density=7150.0))
    assert same.effective_mass_factor == pytest.approx(2.549, abs=5e-4)


@pytest.mark.parametrize(
    ("name", "factor"),
    # domain A3
    [
        ("time", 1.2247),
        ("mass", 16.56),
        ("wheel rate", 11.04),
        ("damping coefficient", 13.52),
        ("speed", 1.2247),
        ("force", 16.56),
        ("length", 1.5),
    ],
)
def test_factors_of_froude_similitude(name, factor):
    found = {one.name: one.factor for one in similitude_report().factors}
    assert found[name] == pytest.approx(factor, rel=4e-4)


@pytest.mark.parametrize(("name", "full_size"), [("wheel rate", 203e3), ("tyre stiffness", 1.53e6)])
def test_what_the_prototype_stands_for(name, full_size):
    found = {one.name: one.full_size for one in similitude_report().factors}
    assert found[name] == pytest.approx(full_size, rel=3e-3)


def test_violations_of_the_published_prototype():
    report = similitude_report()
    # domain A3: body mode 5.07 Hz; 1.5 Hz at full size asks for 1.5 sqrt(1.5)
    assert report.frequency == pytest.approx(5.066, abs=1e-3)
    assert report.similar_frequency == pytest.approx(1.8371, abs=1e-4)
    text = " | ".join(report.violations)
    assert all(
        word in text for word in ("two length factors", "mass:", "frequency:", "static deflection")
    )
    assert "reference_density" in report.findings[-1].message


@pytest.mark.no_source
def test_a_similar_prototype_violates_nothing():
    # full size: 265 kg at 1.5 Hz on a stiff tyre, reduced by 1.5 throughout, same density
    mass, frequency = 265.0 / 1.5**3, 1.5 * 1.5**0.5
    rate = (2 * 3.141592653589793 * frequency) ** 2 * mass
    case = Similitude(
        reference_mass=265.0,
        prototype_mass=mass,
        geometry_factor=1.5,
        mass_factor=1.5,
        prototype_density=7850.0,
        reference_density=7850.0,
        prototype_wheel_rate=rate,
        prototype_tyre_stiffness=1e9,
        reference_frequency=1.5,
    )
    report = similitude_report(case)
    assert report.violations == ()
    assert report.findings == ()


@pytest.mark.no_source
def test_result_is_plain_data():
    assert "violations" in to_json(similitude_report())


@pytest.mark.no_source
@pytest.mark.parametrize("wrong", [{"mass": 0.0}, {"factor": -2.0}])
def test_unusable_values_are_refused(wrong):
    with pytest.raises(FitError, match="not positive"):
        scaled_mass(**{"mass": 1.0, "factor": 2.0, **wrong})
