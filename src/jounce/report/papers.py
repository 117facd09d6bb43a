"""The studies of published work as pages: the proving ground, paper 2's half car and its corner on an exciter."""

from __future__ import annotations

from functools import partial

from jounce.core.display import display_unit
from jounce.core.serialise import to_json
from jounce.papers.audi_a6 import RAMP, SPEED, AudiCase, Window
from jounce.papers.audi_a6_exciter import EccentricExciter, Range
from jounce.papers.audi_a6_paper import FREQUENCY, LOAD, POWER, Erratum
from jounce.papers.proving_ground import FIGURES, LAW, SHOWN_SPEED, ProvingGround
from jounce.plots import damper_loops, road_profile, sweep, time_history
from jounce.plots.audi_a6 import (
    case_curve,
    case_overview,
    exciter_spring,
    exciter_torque_curve,
    start_up_transient,
)
from jounce.plots.display import number, percent, quantity
from jounce.report.page import (
    Block,
    Fact,
    Facts,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Picture,
    Section,
)
from jounce.report.recordings import curve_blocks
from jounce.report.render import curve_files

_PROVING_GROUND = "Measured damper, real vehicle, measured course"
_ABOUT_PROVING_GROUND = (
    "All inputs come from real hardware: a magneto-rheological damper measured on a shaking table at 0 V and 0.88 V, "
    "the front corner of a HMMWV, and the measured one-inch r.m.s. course of a proving ground. The vehicle's own "
    "damper is included for comparison."
)
_LIMITS = (
    "The model is the lumped quarter car: one corner, vertical motion, spring and damper referred to the wheel, "
    "no stops, no friction in the joints. Accelerations are unweighted; the weighting of ISO 2631 is not applied."
    " The measured damper is of laboratory size: it is scaled up by the similitude below, so its results show how "
    "such a law behaves, not how a production damper performs."
)
_TRANSFORM = (
    "With r = motion ratio / stroke scale and g = motion ratio × force scale, the force at the wheel is g × law(r"
    " x, r v): coefficient and stiffness scale with g r, forces with g, the tanh's slope (and the rate of a "
    "Bouc-Wen law) with r; the coupling in 1/s is unchanged, because time is not scaled. The static offset is omitted."
)
_ENVELOPE = (
    "A tyre does not follow edges shorter than its contact patch, so the course is averaged over the contact length; "
    "otherwise steps of up to 80 mm between samples 50 mm apart would hit a point contact."
)


def proving_ground_files(study: ProvingGround) -> dict[str, str | bytes]:
    """Return the results of the study as files, name to content."""
    return {"results.json": to_json(study.to_dict())}


def proving_ground_summary(study: ProvingGround) -> Page:
    """Return a summary page of the study, without curves."""
    sections = (_ride_summary(study), _damper(study), _quarter_car(study), _ride(study))
    return Page(_PROVING_GROUND, (*sections, Section("Findings", (Findings(study.findings),))))


def proving_ground_page(study: ProvingGround) -> Page:
    """Assemble the study's page; nothing is computed here."""
    return Page(
        _PROVING_GROUND,
        (
            _ride_summary(study),
            _damper(study),
            _quarter_car(study),
            _course(study),
            _ride(study),
            _signals(study),
            Section("Findings", (Findings(study.findings),)),
        ),
        subtitle="Ride of a HMMWV's front corner as a quarter car",
        files=tuple(proving_ground_files(study).items()),
    )


def _ride_summary(study: ProvingGround) -> Section:
    facts = tuple(_headline(study, str(name)) for name in study.figures["damper"].to_numpy())
    return Section(
        "Summary", (Paragraph(_ABOUT_PROVING_GROUND), Facts(facts), Paragraph(_LIMITS, "muted"))
    )


def _headline(study: ProvingGround, damper: str) -> Fact:
    """Return body acceleration at the highest speed within the available travel, beyond which the model is invalid."""
    speeds = [float(speed) for speed in study.figures["speed"].to_numpy()]
    used = {speed: _travel_used(study, damper, speed) for speed in speeds}
    within = [speed for speed in speeds if used[speed] <= 1.0]
    if not within:
        least = min(speeds, key=lambda speed: used[speed])
        why = f"{percent(used[least], 0)} of the travel used even at {3.6 * least:.0f} km/h, without stops in the model"
        return Fact(damper, "not valid", why)
    acceleration = study.figures["body_acceleration"].sel(damper=damper, speed=within[-1])
    words = f"r.m.s. of the body at {3.6 * within[-1]:.0f} km/h, {percent(used[within[-1]], 0)} of the travel used"
    return Fact(damper, quantity(float(acceleration), "m/s^2", 3), words)


def _travel_used(study: ProvingGround, damper: str, speed: float) -> float:
    """Return the larger of the used fractions (1) of bump and rebound travel in a run at a speed (m/s)."""
    run = study.figures.sel(damper=damper).sel(speed=speed, method="nearest")
    return max(float(run[key]) for key in ("bump_travel_utilisation", "rebound_travel_utilisation"))


def _damper(study: ProvingGround) -> Section:
    rows = tuple(
        (
            f"{damper.name}, {law}",
            number(100.0 * fit.nrmse, 3),
            number(fit.r2, 4),
            number(fit.energy_per_cycle, 4),
            number(fit.fitted_energy_per_cycle, 4),
        )
        for damper in study.dampers
        for law, fit in damper.laws.items()
    )
    blocks: list[PageTable | Picture | Paragraph] = [
        PageTable(
            "Laws fitted to the records.",
            ("record, law", "NRMSE [%]", "R²", "energy per cycle, measured [J]", "fitted [J]"),
            rows,
            "lrrrr",
            f"The law {LAW} is used below.",
        )
    ]
    for damper in study.dampers:
        curve = damper.curves[LAW]
        fits = {law: curve.fitted for law, curve in damper.curves.items() if law != "bouc-wen"}
        figure = partial(
            damper_loops, curve.displacement, curve.velocity, curve.measured, fits, damper.name
        )
        words = f"Damper at {damper.name}: force against velocity and displacement, measured and fitted."
        blocks.append(
            Picture(figure, f"damper-{damper.name.replace(' ', '').replace('.', '')}", words, words)
        )
    return Section("Measured damper", tuple(blocks))


def _quarter_car(study: ProvingGround) -> Section:
    rows = tuple(
        (
            item.name,
            quantity(item.value, item.unit),
            "estimated" if item.is_estimated else "",
            item.origin,
        )
        for item in study.derived
    )
    parameters = tuple(
        (name, key, number(float(value)))
        for name, rig in study.rigs.items()
        for key, value in rig.strut.damper.model_dump().items()
        if key != "kind"
    )
    words = "Equivalent linear damping ratio against the amplitude of wheel travel at the frequency of body bounce."
    return Section(
        "Model",
        (
            PageTable(
                "Parameters of the quarter car and their origin.",
                ("quantity", "value", "", "origin"),
                rows,
                "lrll",
            ),
            Paragraph(_TRANSFORM),
            Picture(
                partial(sweep, study.damping, along="amplitude"), "damping-ratio", words, words
            ),
            Paragraph(
                "A damper whose force hardly rises with velocity damps small motions strongly and large ones weakly: "
                "a damping ratio holds at one amplitude only."
            ),
            PageTable(
                "Dampers referred to the wheel.",
                ("damper", "parameter", "value (SI)"),
                parameters,
                "llr",
            ),
        ),
    )


def _course(study: ProvingGround) -> Section:
    words = "Height of the course against distance, as measured and averaged over the tyre's contact patch."
    point = quantity(study.point_contact, "m/s^2", 3)
    first = str(study.figures["damper"].to_numpy()[0])
    averaged = (
        study.figures["body_acceleration"]
        .sel(damper=first)
        .sel(speed=SHOWN_SPEED, method="nearest")
    )
    text = (
        f"{_ENVELOPE} For {first} at {3.6 * SHOWN_SPEED:.0f} km/h the r.m.s. body acceleration is "
        f"{quantity(float(averaged), 'm/s^2', 3)}; a point contact would give {point} (both without stops, "
        f"{percent(_travel_used(study, first, SHOWN_SPEED), 0)} of the travel used)."
    )
    return Section(
        "Course", (Picture(road_profile(study.courses), "course", words, words), Paragraph(text))
    )


def _ride(study: ProvingGround) -> Section:
    names = (
        "body_acceleration",
        "bump_travel_utilisation",
        "rebound_travel_utilisation",
        "wheel_load_variation",
        "lift_off",
        "damper_power",
    )
    words = "Ride metrics against speed for the three dampers."
    speeds = [float(speed) for speed in study.figures["speed"].to_numpy()]
    rows = tuple(
        (
            f"{words_}, {damper}",
            *(
                quantity(float(study.figures[key].sel(damper=damper, speed=speed)), unit, 3)
                for speed in speeds
            ),
        )
        for key, (unit, words_) in FIGURES.items()
        for damper in study.figures["damper"].to_numpy()
    )
    header = ("metric, damper", *(f"{3.6 * speed:.0f} km/h" for speed in speeds))
    note = "The imbalance is the residual of the power balance: energy stored in the tyre at lift-off, and sampling."
    return Section(
        "Ride metrics",
        (
            Picture(partial(sweep, study.figures, names), "ride-figures", words, words),
            PageTable(
                "Ride metrics over the undulating 304.8 m; r.m.s. wheel load relative to the static load.",
                header,
                rows,
                "l" + "r" * len(speeds),
                note,
            ),
        ),
    )


def _signals(study: ProvingGround) -> Section:
    channels = ("road.z", "sprung.az", "strut.deflection", "strut.force", "tyre.force")
    pictures = []
    for name, run in study.runs.items():
        words = (
            f"Signals with {name} at {3.6 * SHOWN_SPEED:.0f} km/h, "
            f"{percent(_travel_used(study, name, SHOWN_SPEED), 0)} of the travel used; deflections are measured from "
            "the design position."
        )
        part = run.isel(time=(run["time"] > 20.0) & (run["time"] < 32.0))
        file = f"signals-{name.replace(' ', '-').replace('.', '')}"
        pictures.append(Picture(time_history(part, channels), file, words, words))
    blocks = curve_blocks(
        {"": study.runs},
        channels,
        title="Time histories",
        name="signals",
        window=(20.0, 32.0),
        figures=pictures,
    )
    return Section(
        "Time histories", (Paragraph(f"Driven at {3.6 * SHOWN_SPEED:.0f} km/h."), *blocks)
    )


_ABOUT_CASES = (
    "The half car of the paper (eqs. 6 to 11, Table 2): a body that bounces and pitches on massless axles with two "
    "wheels each. From 3 s on it brakes (case A) or accelerates (case B), which acts as a pitch moment; from 6 s to "
    "8 s its front axle is on the obstacle or in the pothole."
)
_VARIANTS = (
    "simulink reproduces the demo literally: its road is positive downwards, reaches both axles at once and does not "
    "act on the dampers. sign-corrected is the same with the sign of the road corrected. physical delays the rear axle "
    f"by wheelbase over speed ({SPEED:g} m/s, estimated), lets the dampers respond to the road's rate, and rounds the "
    f"steps to raised-cosine ramps of {RAMP:g} m (estimated)."
)
_SIGNS = "Bounce z (up) and pitch θ (nose down) are changes from static equilibrium. Windows include both ends."
_SAME = (
    "The paper's figures are scope screens without numerical values; these curves reproduce them."
)


def audi_case_files(study: AudiCase) -> dict[str, str | bytes]:
    """Return the results of a case as files, name to content: numbers, and the curves of each run."""
    named = ((f"{run.variant}-{abs(run.moment):.0f}Nm", run.signals) for run in study.runs)
    return {
        "results.json": to_json(study.to_dict()),
        **dict(file for curves in named for file in curve_files(*curves)),
    }


def audi_case_summary(study: AudiCase) -> Page:
    """Return a summary page of a case, without curves."""
    return Page(
        _title_of(study), (_summary(study), _windows(study), _statics(study), *_ending(study))
    )


def _title_of(study: AudiCase) -> str:
    return f"Audi A6, {study.case.title[0].lower()}{study.case.title[1:]}"


def _ending(study: AudiCase | EccentricExciter) -> tuple[Section, ...]:
    errata = Section("Errata of the paper", (errata_table(study.errata),))
    return errata, Section("Findings", (Findings(study.findings),))


def audi_case_page(study: AudiCase) -> Page:
    """Assemble a case's page; nothing is computed here."""
    return Page(
        _title_of(study),
        (
            _summary(study),
            _windows(study),
            _case_curves(study),
            _statics(study),
            _demo(study),
            *_ending(study),
        ),
        subtitle="Half car of the suspension-system paper, section 5",
        files=tuple(audi_case_files(study).items()),
    )


def errata_table(errata: tuple[Erratum, ...]) -> PageTable:
    """Return a table of the paper's errors, the corrections, and the evidence for them."""
    rows = tuple(
        (erratum.place, erratum.printed, erratum.correct, erratum.why) for erratum in errata
    )
    note = "Every number is computed from the paper's tables; results.json holds them in SI."
    return PageTable(
        "Statements of the paper that need correction.",
        ("place", "printed", "correct", "reason"),
        rows,
        "llll",
        note,
    )


def _summary(study: AudiCase) -> Section:
    first = study.runs[0].moment
    facts = []
    for run in study.runs:
        if run.moment == first:
            window = run.outputs["z"][1]
            note = f"{run.variant}: largest from 6 s to 8 s, M_y = {quantity(first, 'N*m')}"
            furthest = max(window.min, window.max, key=abs)
            facts.append(Fact("body bounce", quantity(furthest, "m", 4), note))
    return Section(
        "Summary",
        (
            Paragraph(_ABOUT_CASES),
            Facts(tuple(facts)),
            Paragraph(_VARIANTS),
            Paragraph(_SIGNS, "muted"),
        ),
    )


def _windows(study: AudiCase) -> Section:
    tables = []
    length = display_unit("m")
    units = (("z", length.name), ("θ", "mrad"))
    names = (f"{what} {end} [{unit}]" for what, unit in units for end in ("min", "max"))
    header = ("variant, window", *(text for name in names for text in (name, "at [s]")))
    for moment in dict.fromkeys(run.moment for run in study.runs):
        rows = tuple(
            (
                f"{run.variant}, {z.start:g}–{z.end:g} s",
                *_extremes(z, length.factor),
                *_extremes(theta, 1e3),
            )
            for run in study.runs
            if run.moment == moment
            for z, theta in zip(run.outputs["z"], run.outputs["theta"], strict=True)
        )
        given = quantity(moment, "N*m")
        caption = f"Extremes with a pitch moment of {given} from 3 s on; θ is positive nose down."
        tables.append(PageTable(caption, header, rows, "l" + "r" * 8))
    peaks = tuple(
        (
            f"{run.variant}, {quantity(run.moment, 'N*m')}",
            quantity(run.peak_acceleration, "m/s^2", 4),
            quantity(run.least_wheel_force, "N", 4),
        )
        for run in study.runs
    )
    heads = ("variant, moment", "largest body acceleration, 6–8 s", "least force on a wheel")
    return Section(
        "Windows",
        (*tables, PageTable("Peak acceleration and least wheel force.", heads, peaks, "lrr")),
    )


def _extremes(window: Window, factor: float) -> tuple[str, str, str, str]:
    """Return minimum and maximum of a window times ``factor``, with their times; three decimals, four if small."""
    digits = 3 if factor >= 100.0 else 4
    low, high = (f"{factor * value + 0.0:.{digits}f}" for value in (window.min, window.max))
    zero = f"{0.0:.{digits}f}"
    low, high = (text.replace(f"-{zero}", zero).replace("-", "−") for text in (low, high))
    return low, f"{window.t_min:.3f}", high, f"{window.t_max:.3f}"


def _case_curves(study: AudiCase) -> Section:
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
            f"What figure 16 of the paper shows, with a pitch moment of {quantity(moment, 'N*m')}: bounce, pitch, "
            "forces of the axles on the body, road under both axles, moment."
        )
        name = f"figure-16-signals-{abs(moment):.0f}Nm"
        pictures.append(Picture(case_overview(study, moment), name, text, text))
    moments = dict.fromkeys(run.moment for run in study.runs)
    groups = {
        f"pitch moment {quantity(moment, 'N*m')}": {
            run.variant: run.signals for run in study.runs if run.moment == moment
        }
        for moment in moments
    }
    return Section(
        "Curves",
        (Paragraph(_SAME), *curve_blocks(groups, list(titles), title="Curves", figures=pictures)),
    )


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
        f"In equilibrium the centre of gravity lies {quantity(-rest.z, 'm', 6)} below its position with undeformed "
        f"springs, and the body is pitched by {number(1e3 * rest.theta, 5)} mrad: nose up, because K_f L_f differs "
        "from K_r L_r. All variants have the same statics and modes."
    )
    names = ("natural frequency", "damped", "damping ratio", "height [m]", "pitch [rad]")
    return Section(
        "Statics and modes",
        (
            Paragraph(text),
            PageTable(
                "Axle loads in equilibrium.",
                ("axle", "force", "per wheel", "compression of a spring"),
                axles,
                "lrrr",
            ),
            PageTable("Modes; the last two columns are their shapes.", names, modes, "rrrrr"),
        ),
    )


def _demo(study: AudiCase) -> Section:
    start, printed = study.start_up, study.printed
    words = "Height of the body when the paper's vehicle starts from the demo's initial state."
    first = (
        f"The demo starts at {quantity(start.initial, 'm', 6)}, the equilibrium of its own car. The paper's "
        f"vehicle has its equilibrium at {quantity(start.equilibrium, 'm', 6)}: unless the initial state is changed, a "
        f"transient of {quantity(start.transient, 'm', 3)} runs through the first second. The runs here start in "
        "equilibrium."
    )
    second = (
        f"Eq. (9) as printed, M_rear = −L_r F_rear, reverses the moment of the rear axle: an eigenvalue of "
        f"+{printed.growth_rate:.3f} 1/s makes pitch diverge, and the equilibrium would be at a pitch of "
        f"{printed.pitch_at_rest:.3f} rad. This is computed from the matrices; no variant of the model "
        "contains the error."
    )
    rows = tuple(
        (name, *(_eigenvalue(*value) for value in values))
        for name, values in (
            ("as printed", printed.eigenvalues),
            ("correct", printed.correct_eigenvalues),
        )
    )
    return Section(
        "Initial state of the demo, and the printed sign",
        (
            Paragraph(first),
            Picture(partial(start_up_transient, study), "start-up", words, words),
            Paragraph(second),
            PageTable("Eigenvalues [1/s].", ("eq. (9)", "1", "2", "3", "4"), rows, "lrrrr"),
        ),
    )


def _eigenvalue(real: float, imaginary: float) -> str:
    text = (
        f"{real:+.4f}"
        if imaginary == 0.0
        else f"{real:+.4f} {'+' if imaginary > 0 else '-'} {abs(imaginary):.4f} i"
    )
    return text.replace("-", "−")


_EXCITER = "Audi A6, front corner on an eccentric exciter"
_ABOUT_EXCITER = (
    "The paper simulated the front corner on a plate that an eccentric exciter moves (section 4). It merged tyre and "
    "spring into one by adding their rates. Here the same test rig is modelled three times: summed as in the paper, in "
    "series (a massless wheel between spring and tyre), and with two masses (the quarter car, whose tyre may "
    "leave the plate)."
)
_RUN = (
    "The exciter turns steadily at 5 Hz and moves the plate as a Scotch yoke does; the plate starts at its lowest "
    "position with an uncompressed spring of 341 mm, and the load then compresses it. Without friction in the guides, "
    "the mean power of the drive equals the heat dissipated in the dampers."
)


def exciter_files(study: EccentricExciter) -> dict[str, str | bytes]:
    """Return the results of the study as files, name to content: numbers, and the curves of each run."""
    curves = (file for run in study.runs for file in curve_files(run.variant, run.signals))
    return {"results.json": to_json(study.to_dict()), **dict(curves)}


def exciter_summary(study: EccentricExciter) -> Page:
    """Return a summary page of the study, without curves."""
    return Page(_EXCITER, _exciter_sections(study, _spring_table(study)))


def _exciter_sections(study: EccentricExciter, spring: tuple[Block, ...]) -> tuple[Section, ...]:
    return (
        _exciter_summary(study),
        Section("Spring", spring),
        Section("Statics, modes and response", _linear(study)),
        Section("Drive", _drive(study)),
        *_ending(study),
    )


def exciter_page(study: EccentricExciter) -> Page:
    """Assemble the study's page; nothing is computed here."""
    return Page(
        _EXCITER,
        _exciter_sections(study, (*_spring_curves(study), *_spring_table(study))),
        subtitle="Quarter car of the suspension-system paper, section 4, rebuilt",
        files=tuple(exciter_files(study).items()),
    )


def _exciter_summary(study: EccentricExciter) -> Section:
    facts = tuple(
        Fact(
            f"compression, {run.variant}",
            quantity(run.statics["compression"], "m", 5),
            "static, of all springs",
        )
        for run in study.runs
    )
    torque = Fact(
        "torque of eq. (5)",
        quantity(study.torque, "N*m", 4),
        f"the paper: {study.printed_torque:.1f} N·m",
    )
    inputs = (
        f"Inputs of Table 1: load {LOAD:g} N, power {POWER:g} W, frequency {FREQUENCY:g} Hz, spring 38 N/mm with "
        "2 N·s/mm, tyre 300 N/mm with 1 N·s/mm. Estimated: amplitude "
        f"{quantity(study.amplitude, 'm', 3)}, mass of the plate {study.plate_mass:g} kg, unsprung mass "
        f"{study.rig.unsprung.mass:g} kg."
    )
    return Section(
        "Summary",
        (
            Paragraph(_ABOUT_EXCITER),
            Facts((*facts, torque)),
            Paragraph(_RUN),
            Paragraph(inputs, "muted"),
        ),
    )


def _spring_curves(study: EccentricExciter) -> tuple[Block, ...]:
    words = (
        "Plate position, spring length and spring force, starting from the uncompressed "
        "spring (figure 8 of the paper)."
    )
    return curve_blocks(
        {"": {run.variant: run.signals for run in study.runs}},
        title="Spring",
        figures=[Picture(exciter_spring(study), "figure-8-spring", words, words)],
    )


def _spring_table(study: EccentricExciter) -> tuple[Block, ...]:
    rows = tuple(
        (
            run.variant,
            quantity(run.statics["spring_length"], "m", 5),
            _span(run.spring_length, "m", 5),
            _span(run.spring_force, "N", 4),
            quantity(run.shortest, "m", 4),
        )
        for run in study.runs
    )
    header = (
        "model",
        "static length",
        "length in steady motion",
        "force in steady motion",
        "shortest while loading",
    )
    text = (
        "The paper reads 328.8 mm. Only the summed spring comes near it: its static length is "
        f"{quantity(study.runs[0].statics['spring_length'], 'm', 4)}. As the least compression in steady motion, "
        f"12.2 mm would require an amplitude of {quantity(study.fitting_amplitude, 'm', 2)}."
    )
    note = "For the summed model this is the merged spring, for the others the suspension spring."
    return (
        PageTable("Spring of 341 mm under the load.", header, rows, "lrrrr", note),
        Paragraph(text),
    )


def _linear(study: EccentricExciter) -> tuple[Block, ...]:
    statics = tuple(
        (
            run.variant,
            quantity(run.statics["spring_compression"], "m", 5),
            quantity(run.statics["compression"], "m", 5),
            quantity(run.statics["contact_force"], "N", 5),
            "; ".join(
                f"{number(mode.frequency_hz, 5)} Hz, ζ {number(mode.damping_ratio, 4)}"
                for mode in run.modes
            ),
        )
        for run in study.runs
    )
    response = tuple(
        (
            f"{run.variant}, {kind}",
            *(number(values.get(name), 4) for name in ("body", "wheel", "spring")),
            quantity(values["contact"], "N/m", 4),
        )
        for run in study.runs
        for kind, values in (("simulated", run.amplitudes), ("closed form", run.closed_form))
    )
    tester = tuple(
        (
            quantity(rating.tyre_damping_coefficient, "N*s/m"),
            f"{100.0 * rating.adhesion:.1f} %",
            quantity(rating.frequency_hz, "Hz", 3),
        )
        for rating in study.eusama
    )
    return (
        PageTable(
            "Static equilibrium and modes.",
            ("model", "spring", "all springs", "force on the plate", "modes"),
            statics,
            "lrrrl",
            "The tyre of the two-mass model also carries the weight of the wheel.",
        ),
        PageTable(
            "Amplitudes at 5 Hz over that of the plate.",
            ("model", "body [–]", "wheel [–]", "spring [–]", "force on the plate"),
            response,
            "lrrrr",
        ),
        PageTable(
            "EUSAMA adhesion at this amplitude: least contact force over static contact force.",
            ("tyre damping", "adhesion", "at"),
            tester,
            "lrr",
        ),
    )


def _drive(study: EccentricExciter) -> tuple[Block, ...]:
    words = "Torque required by the exciter and force on the plate over two revolutions of steady motion."
    rows = tuple(
        (
            run.variant,
            quantity(run.drive.torque.mean, "N*m", 3),
            _span(run.drive.torque, "N*m", 3),
            quantity(run.drive.power, "W", 4),
            quantity(run.drive.dissipated, "W", 4),
        )
        for run in study.runs
    )
    text = (
        f"Eq. (5) in consistent units gives {quantity(study.torque, 'N*m', 4)} from {POWER:g} W at {FREQUENCY:g} Hz; "
        f"the paper's factor of 60 turns this into {study.printed_torque:.1f} N·m. As a constant torque on the exciter "
        "either would only accelerate it, because the test rig absorbs far less: a drive controls the speed."
    )
    header = ("model", "mean torque", "torque", "mean power", "heat in dampers")
    return (
        Picture(partial(exciter_torque_curve, study), "torque", words, words),
        PageTable(
            "Torque and power required of the drive in steady motion.", header, rows, "lrrrr"
        ),
        Paragraph(text),
    )


def _span(ends: Range, unit: str, digits: int) -> str:
    return f"{quantity(ends.min, unit, digits)} to {quantity(ends.max, unit, digits)}"
