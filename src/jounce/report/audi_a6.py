"""Paper 2's half-car cases as a page: windows of extremes, curves, statics, modes, the paper beside what is correct."""

from __future__ import annotations

from jounce.core.serialise import to_json
from jounce.papers.audi_a6 import RAMP, SPEED, AudiCase, CaseRun
from jounce.papers.audi_a6_paper import Erratum
from jounce.papers.extremes import Window
from jounce.plots.audi_a6 import case_curve, case_overview, start_up_transient
from jounce.plots.display import number, quantity
from jounce.report.curves import curve_files
from jounce.report.page import Fact, Facts, Findings, Page, Paragraph, Picture, Section, Table

_ABOUT = (
    "The half car of the paper (eqs. 6 to 11, Table 2): a body that bounces and pitches on massless axles, two wheels "
    "each. From 3 s on it brakes (case A) or accelerates (case B), which acts as a pitch moment; from 6 s to 8 s its "
    "front axle is on the obstacle or in the pothole."
)
_VARIANTS = (
    "simulink is the demo literally: its road counts downwards, meets both axles at once and is not felt by the "
    "dampers. sign-corrected is the same with the road's sign right. physical delays the rear axle by wheelbase over "
    f"speed ({SPEED:g} m/s, estimated), lets the dampers feel the road's rate, and rounds the steps to raised-cosine "
    f"ramps of {RAMP:g} m (estimated)."
)
_SIGNS = "Bounce z (up) and pitch θ (nose down) are changes from static equilibrium. Windows are closed."
_SAME = "The paper's figures are scope screens without numbers; these curves stand for them."


def audi_case_page(study: AudiCase) -> Page:
    """Put a case's page together; nothing is computed here."""
    curves = (file for run in study.runs for file in curve_files(f"{run.variant}-{_moment_name(run)}", run.signals))
    return Page(
        f"Audi A6, {study.case.title[0].lower()}{study.case.title[1:]}",
        (
            _summary(study),
            _windows(study),
            _curves(study),
            _statics(study),
            _demo(study),
            Section("The paper beside what is correct", (errata_table(study.errata),)),
            Section("Findings", (Findings(study.findings),)),
        ),
        subtitle="Half car of the suspension-system paper, section 5",
        files=(("results.json", to_json(study.to_dict())), *curves),
    )


def errata_table(errata: tuple[Erratum, ...]) -> Table:
    """Table of what the paper prints, what is correct, and how one can tell."""
    rows = tuple((erratum.place, erratum.printed, erratum.correct, erratum.why) for erratum in errata)
    note = "Every number is computed from the paper's tables; results.json holds them in SI."
    return Table("What is to be read with care.", ("where", "the paper", "correct", "why"), rows, "llll", note)


def _moment_name(run: CaseRun) -> str:
    return f"{abs(run.moment):.0f}Nm"


def _summary(study: AudiCase) -> Section:
    first = study.runs[0].moment
    facts = []
    for run in study.runs:
        if run.moment == first:
            window = run.outputs["z"][1]
            note = f"{run.variant}: furthest bounce from 6 s to 8 s, M_y = {number(first, 3)} N·m"
            furthest = max(window.min, window.max, key=abs)
            facts.append(Fact("body moves by", quantity(furthest, "m", 4), note))
    return Section(
        "Summary", (Paragraph(_ABOUT), Facts(tuple(facts)), Paragraph(_VARIANTS), Paragraph(_SIGNS, "muted"))
    )


def _windows(study: AudiCase) -> Section:
    tables = []
    names = (f"{what} {end} {unit}" for what, unit in (("z", "[mm]"), ("θ", "[mrad]")) for end in ("min", "max"))
    header = ("variant, window", *(text for name in names for text in (name, "at [s]")))
    for moment in dict.fromkeys(run.moment for run in study.runs):
        rows = tuple(
            (f"{run.variant}, {z.start:g}–{z.end:g} s", *_extremes(z), *_extremes(theta))
            for run in study.runs
            if run.moment == moment
            for z, theta in zip(run.outputs["z"], run.outputs["theta"], strict=True)
        )
        caption = f"Extremes with a pitch moment of {_signed(moment)} N·m from 3 s on; θ is positive nose down."
        tables.append(Table(caption, header, rows, "l" + "r" * 8))
    peaks = tuple(
        (
            f"{run.variant}, {_signed(run.moment)} N·m",
            quantity(run.peak_acceleration, "m/s^2", 4),
            quantity(run.least_wheel_force, "N", 4),
        )
        for run in study.runs
    )
    heads = ("variant, moment", "largest body acceleration, 6–8 s", "least force on a wheel")
    return Section("Windows", (*tables, Table("Acceleration and wheel force.", heads, peaks, "lrr")))


def _extremes(window: Window) -> tuple[str, str, str, str]:
    return _thousand(window.min), f"{window.t_min:.3f}", _thousand(window.max), f"{window.t_max:.3f}"


def _thousand(value: float) -> str:
    """Write a value in thousandths of its unit (m or rad) with three decimals."""
    return f"{1e3 * value + 0.0:.3f}".replace("-0.000", "0.000").replace("-", "−")


def _signed(value: float) -> str:
    return f"{value:.6g}".replace("-", "−")


def _curves(study: AudiCase) -> Section:
    bounce, pitch = study.case.figures
    titles = {
        "bounce.displacement": (bounce, "bounce", "Bounce of the body against time", "up"),
        "pitch.angle": (pitch, "pitch", "Pitch of the body against time", "nose down"),
    }
    pictures = []
    for channel, (figure, name, words, sign) in titles.items():
        text = f"{words} (figure {figure} of the paper): both pitch moments, all variants; {sign} positive."
        pictures.append(Picture(case_curve(study, channel), f"figure-{figure}-{name}", text, text))
    for moment in dict.fromkeys(run.moment for run in study.runs):
        text = (
            f"What figure 16 of the paper shows, with a pitch moment of {_signed(moment)} N·m: bounce, pitch, forces "
            "of the axles on the body, road under both axles, moment."
        )
        name = f"figure-16-signals-{abs(moment):.0f}Nm"
        pictures.append(Picture(case_overview(study, moment), name, text, text))
    return Section("Curves", (Paragraph(_SAME), *pictures))


def _statics(study: AudiCase) -> Section:
    rest = study.runs[0].statics
    axles = tuple(
        (
            name,
            quantity(axle.force, "N", 6),
            quantity(axle.force_per_wheel, "N", 6),
            quantity(axle.compression, "m", 6),
        )
        for name, axle in (("front", rest.front), ("rear", rest.rear))
    )
    modes = tuple(
        (
            quantity(mode.frequency_hz, "Hz", 5),
            quantity(mode.damped_frequency_hz, "Hz", 5),
            number(mode.damping_ratio, 4),
            *(number(abs(complex(*mode.shape[name])), 3) for name in ("body.z", "body.pitch")),
        )
        for mode in study.modes
    )
    text = (
        f"At rest the centre of gravity is {quantity(-rest.z, 'm', 6)} below where the springs are undeformed, and the "
        f"body pitches by {_thousand(rest.theta)} mrad: nose up, because K_f L_f is not K_r L_r. All variants have the "
        "same statics and modes."
    )
    names = ("natural frequency", "damped", "damping ratio", "height [m]", "pitch [rad]")
    return Section(
        "Statics and modes",
        (
            Paragraph(text),
            Table("Axles at rest.", ("axle", "force", "per wheel", "compression of a spring"), axles, "lrrr"),
            Table("Modes; the last columns are their shape.", names, modes, "rrrrr"),
        ),
    )


def _demo(study: AudiCase) -> Section:
    start, printed = study.start_up, study.printed
    words = "Height of the body after a start where the demo starts its own car, with the paper's vehicle."
    first = (
        f"The demo starts at {_signed(1e3 * start.initial)} mm, the balance of its own car. The paper's vehicle "
        f"balances at {_signed(1e3 * start.equilibrium)} mm: unless the initial state is changed, a transient of "
        f"{quantity(start.transient, 'm', 3)} runs through the first second. The runs here start in balance."
    )
    second = (
        f"Eq. (9) as printed, M_rear = −L_r F_rear, turns the rear axle's moment round: an eigenvalue of "
        f"+{printed.growth_rate:.3f} 1/s makes pitch run away, and the equations balance at a pitch of "
        f"{printed.pitch_at_rest:.3f} rad. It is computed here from the matrices; no variant of the model has it."
    )
    rows = tuple(
        (name, *(_eigenvalue(*value) for value in values))
        for name, values in (("as printed", printed.eigenvalues), ("correct", printed.correct_eigenvalues))
    )
    return Section(
        "The demo's start and the printed sign",
        (
            Paragraph(first),
            Picture(start_up_transient(study), "start-up", words, words),
            Paragraph(second),
            Table("Eigenvalues [1/s].", ("eq. (9)", "1", "2", "3", "4"), rows, "lrrrr"),
        ),
    )


def _eigenvalue(real: float, imaginary: float) -> str:
    text = f"{real:+.4f}" if imaginary == 0.0 else f"{real:+.4f} {'+' if imaginary > 0 else '-'} {abs(imaginary):.4f} i"
    return text.replace("-", "−")
