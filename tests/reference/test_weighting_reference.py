"""Frequency weightings against the design values of ISO 8041-1, and sampled signals against its tolerances."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.ride.weighting import WEIGHTINGS, tolerance, weight, weighting_response

pytestmark = pytest.mark.source(
    kind="published",
    of="ride and roughness",
    key="iso-8041-1",
    where="Annex B: design values at third-octave centres",
    tolerance="four printed digits",
)

# ISO 8041-1:2017, Annex B: design values at the exact third-octave centres 10^(n/10) Hz, four digits as printed
PRINTED = (
    # n, Wk, Wd, Wf
    (-17, None, None, "0.02407"),
    (-16, None, None, "0.03803"),
    (-15, None, None, "0.06021"),
    (-14, None, None, "0.09619"),
    (-13, None, None, "0.1575"),
    (-12, None, None, "0.2675"),
    (-11, None, None, "0.4537"),
    (-10, "0.03121", "0.06242", "0.6951"),
    (-9, "0.04931", "0.09867", "0.9"),
    (-8, "0.07756", "0.1553", "1.004"),
    (-7, "0.1207", "0.242", "0.9928"),
    (-6, "0.1832", "0.3682", "0.8501"),
    (-5, "0.2644", "0.533", "0.6149"),
    (-4, "0.3504", "0.7097", "0.3884"),
    (-3, "0.4188", "0.854", "0.2225"),
    (-2, "0.4588", "0.9443", "0.1157"),
    (-1, "0.4767", "0.9914", "0.05434"),
    (0, "0.4825", "1.011", "0.02352"),
    (1, "0.4846", "1.007", "0.009705"),
    (2, "0.4935", "0.9707", "0.003916"),
    (3, "0.5308", "0.8913", "0.001566"),
    (4, "0.6335", "0.7733", None),
    (5, "0.8071", "0.6398", None),
    (6, "0.9648", "0.5143", None),
    (7, "1.039", "0.4081", None),
    (8, "1.054", "0.3226", None),
    (9, "1.037", "0.255", None),
    (10, "0.9884", "0.2017", None),
    (11, "0.8989", "0.1597", None),
    (12, "0.7743", "0.1266", None),
    (13, "0.6373", "0.1004", None),
    (14, "0.5103", "0.07958", None),
    (15, "0.4031", "0.06299", None),
    (16, "0.316", "0.04965", None),
    (17, "0.2451", "0.03872", None),
    (18, "0.1857", "0.02946", None),
    (19, "0.1339", "0.0213", None),
    (20, "0.08873", "0.01414", None),
    (21, "0.05311", "0.008478", None),
    (22, "0.02922", "0.004668", None),
    (23, "0.01528", "0.002442", None),
    (24, "0.007795", "0.001246", None),
    (25, "0.003935", "0.0006293", None),
    (26, "0.001978", "0.0003164", None),
)
CASES = [
    (name, n, text)
    for n, *texts in PRINTED
    for name, text in zip(("Wk", "Wd", "Wf"), texts, strict=True)
    if text is not None
]
RATES = (100.0, 128.0, 256.0, 500.0, 1000.0, 10e3)


@pytest.mark.no_source
def test_the_table_is_whole() -> None:
    assert len(CASES) == 37 + 37 + 21


@pytest.mark.parametrize(("name", "n", "printed"), CASES)
def test_design_values_to_the_printed_digits(name: str, n: int, printed: str) -> None:
    gain = abs(weighting_response(name, 10.0 ** (n / 10.0)))
    last_digit = 10.0 ** (np.floor(np.log10(float(printed))) - 3.0)
    assert gain == pytest.approx(float(printed), abs=0.5001 * last_digit)


@pytest.mark.source(
    kind="published",
    of="ride and roughness",
    key="iso-8041-1",
    where="Table 1: factors at the reference frequencies",
    tolerance="half a unit of the last printed digit",
)
@pytest.mark.parametrize(
    ("name", "frequency", "gain", "digits"),
    [
        ("Wk", 15.915, 0.7718, 4),
        ("Wd", 15.915, 0.1261, 4),
        ("Wf", 0.3979, 0.3888, 4),
        ("Wc", 15.915, 0.5145, 4),
        ("We", 15.915, 0.06287, 5),
    ],
)
def test_reference_frequencies(name: str, frequency: float, gain: float, digits: int) -> None:
    # ISO 8041-1:2017, Table 1: weighting factors at the reference frequencies 500 rad/s / (10 pi) and 2.5 rad/s
    assert float(abs(weighting_response(name, frequency))) == pytest.approx(
        gain, abs=0.5000001 * 10.0**-digits
    )


@pytest.mark.source(
    kind="computed",
    of="ride and roughness",
    key="iso-8041-1",
    where="its transfer function, evaluated beside jounce",
    tolerance="half a unit of the last printed digit",
)
@pytest.mark.parametrize(("frequency", "degrees"), [(1.0, 40.06), (15.85, -61.84)])
def test_phase_of_wk(frequency: float, degrees: float) -> None:
    # computed from the transfer function of ISO 8041-1 with f1 = 0.4 Hz exactly, two digits
    assert np.degrees(np.angle(weighting_response("Wk", frequency))) == pytest.approx(
        degrees, abs=0.006
    )


@pytest.mark.source(
    kind="published",
    of="ride and roughness",
    key="iso-8041-1",
    where="Tables 4 and 5",
    tolerance="+12 % and -11 % of the standard; 3 % are allowed here",
    compares="sampled signals, five weightings at six rates",
)
@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("name", WEIGHTINGS)
def test_sampled_signals_are_weighted_within_the_tolerances_of_the_standard(
    name: str, rate: float
) -> None:
    # ISO 8041-1:2017, Tables 4 and 5; an impulse holds all frequencies
    row = WEIGHTINGS[name]
    count = 1 << int(np.ceil(np.log2(2.0 * row.memory * rate)))
    impulse = np.zeros(count)
    impulse[count // 4] = 1.0
    spectrum = np.fft.rfft(weight(impulse, rate, name)) * np.exp(
        2j * np.pi * np.arange(count // 2 + 1) / 4.0
    )
    frequency = np.fft.rfftfreq(count, 1.0 / rate)
    seen = (frequency >= row.limits[0]) & (frequency < 0.499 * rate)
    low, high = tolerance(name, frequency[seen])
    ratio = abs(spectrum[seen]) / abs(weighting_response(name, frequency[seen]))
    finite = (frequency[seen] > row.limits[0]) & (frequency[seen] < row.limits[3])
    assert np.count_nonzero(finite) > 50
    assert np.all((ratio[finite] > low[finite]) & (ratio[finite] < high[finite]))
    np.testing.assert_allclose(ratio[finite], 1.0, atol=0.03)
    far = finite & (
        frequency[seen] < 0.4 * rate
    )  # far from half the rate it is the analog filter itself
    np.testing.assert_allclose(
        spectrum[seen][far], weighting_response(name, frequency[seen])[far], rtol=1e-3
    )


@pytest.mark.source(
    kind="computed",
    of="ride and roughness",
    key="iso-8041-1",
    where="errors of a bilinear filter, evaluated beside jounce",
    tolerance="1 %",
)
@pytest.mark.parametrize(("rate", "at", "error"), [(200.0, 63.0, -0.495), (1000.0, 63.0, -0.017)])
def test_the_tolerances_notice_a_bilinear_design(rate: float, at: float, error: float) -> None:
    # largest errors of the plain bilinear transform within 0.5 to 63 Hz, computed: -49.5 % at 200 Hz, -1.7 % at 1 kHz
    warped = rate / np.pi * np.tan(np.pi * at / rate)
    ratio = abs(weighting_response("Wk", warped)) / abs(weighting_response("Wk", at))
    assert ratio - 1.0 == pytest.approx(error, abs=1e-2)
    low, high = tolerance("Wk", at)
    assert (low < ratio < high) == (rate == 1000.0)


@pytest.mark.no_source
def test_tolerances_are_those_of_the_tables() -> None:
    low, high = tolerance(
        "Wk", [0.2, 10**-0.6, 0.4, 10**-0.2, 10.0, 10**1.8, 100.0, 10**2.2, 300.0]
    )
    assert low.tolist() == [0.0, 0.0, 0.79, 0.89, 0.89, 0.89, 0.79, 0.0, 0.0]
    assert high.tolist() == [1.26, 1.26, 1.26, 1.12, 1.12, 1.12, 1.26, 1.26, 1.26]


@pytest.mark.no_source
@pytest.mark.parametrize("name", WEIGHTINGS)
def test_tolerances_change_at_the_limits_of_each_weighting(name: str) -> None:
    # ISO 8041-1, tables of Annex B: tenths of a decade
    tenths = np.array([-13, -9, -4, 0] if name == "Wf" else [-6, -2, 18, 22])
    below, above = (tolerance(name, 10.0 ** (0.1 * tenths + shift)) for shift in (-0.01, 0.01))
    assert np.stack(below).T.tolist() == [[0.0, 1.26], [0.79, 1.26], [0.89, 1.12], [0.79, 1.26]]
    assert np.stack(above).T.tolist() == [[0.79, 1.26], [0.89, 1.12], [0.79, 1.26], [0.0, 1.26]]
