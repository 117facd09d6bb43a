"""The proving-ground study as a page: what was measured, what was derived, what comes out."""

from __future__ import annotations

from jounce.core.serialise import to_json
from jounce.papers.proving_ground import FIGURES, LAW, SHOWN_SPEED, ProvingGround
from jounce.plots import damper_loops, number, quantity, road_profile, sweep, time_history
from jounce.report.page import Fact, Facts, Findings, Page, Paragraph, Picture, Section, Table

_ABOUT = (
    "Only real hardware goes in: a magneto-rheological damper measured on a shaking table at 0 V and 0.88 V, the "
    "front corner of a HMMWV, and the measured one-inch r.m.s. course of a proving ground. The vehicle's own "
    "damper is driven beside it."
)
_LIMITS = (
    "The model is the lumped quarter car: one corner, vertical motion, spring and damper referred to the wheel, "
    "no stops, no friction in the joints. Accelerations are unweighted; the weighting of ISO 2631 is not applied."
    " The measured damper is of laboratory size: it is enlarged by the similitude below, so its figures show how "
    "such a law behaves, not what a damper on sale does."
)
_TRANSFORM = (
    "With r = motion ratio / stroke scale and g = motion ratio × force scale, the force at the wheel is g × law(r"
    " x, r v): coefficient and stiffness change with g r, forces with g, the tanh's slope (and the rate of a "
    "Bouc-Wen law) with r; the coupling in 1/s stays, because time is not scaled. The static offset is left out."
)
_ENVELOPE = (
    "A tyre does not follow edges shorter than its contact, so the course is averaged over the contact length; "
    "steps of up to 80 mm between samples 50 mm apart would otherwise strike a point."
)


def proving_ground_page(study: ProvingGround) -> Page:
    """Put the study's page together; nothing is computed here."""
    return Page(
        "Measured damper, real vehicle, measured course",
        (
            _summary(study),
            _damper(study),
            _model(study),
            _course(study),
            _ride(study),
            _signals(study),
            _findings(study),
        ),
        subtitle="Ride of a HMMWV's front corner as a quarter car",
        files=(("results.json", to_json(study.to_dict())),),
    )


def _summary(study: ProvingGround) -> Section:
    shown = study.figures.sel(speed=SHOWN_SPEED, method="nearest")
    facts = tuple(
        Fact(
            str(name),
            quantity(float(shown["body_acceleration"].sel(damper=name)), "m/s^2", 3),
            f"r.m.s. of the body at {3.6 * SHOWN_SPEED:.0f} km/h",
        )
        for name in study.figures["damper"].to_numpy()
    )
    return Section("Summary", (Paragraph(_ABOUT), Facts(facts), Paragraph(_LIMITS, "muted")))


def _damper(study: ProvingGround) -> Section:
    rows = tuple(
        (
            f"{one.name}, {law}",
            number(100.0 * fit.nrmse, 3),
            number(fit.r2, 4),
            number(fit.energy_per_cycle, 4),
            number(fit.fitted_energy_per_cycle, 4),
        )
        for one in study.dampers
        for law, fit in one.laws.items()
    )
    blocks: list[Table | Picture | Paragraph] = [
        Table(
            "Laws fitted to the records.",
            ("record, law", "NRMSE [%]", "R²", "energy per cycle, measured [J]", "fitted [J]"),
            rows,
            "lrrrr",
            f"The law {LAW} is driven below.",
        )
    ]
    for one in study.dampers:
        curve = one.curves[LAW]
        fits = {law: found.fitted for law, found in one.curves.items() if law != "bouc-wen"}
        figure = damper_loops(curve.displacement, curve.velocity, curve.measured, fits, one.name)
        words = f"Damper at {one.name}: force against velocity and displacement, measured and fitted."
        blocks.append(Picture(figure, f"damper-{one.name.replace(' ', '').replace('.', '')}", words, words))
    return Section("Measured damper", tuple(blocks))


def _model(study: ProvingGround) -> Section:
    rows = tuple(
        (item.name, quantity(item.value, item.unit), "estimated" if item.is_estimated else "", item.origin)
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
            Table(
                "Every number of the quarter car and where it comes from.",
                ("quantity", "value", "", "origin"),
                rows,
                "lrll",
            ),
            Paragraph(_TRANSFORM),
            Picture(sweep(study.damping, along="amplitude"), "damping-ratio", words, words),
            Paragraph(
                "A damper whose force hardly rises with velocity damps small motions strongly and large ones weakly: "
                "the ratio holds at one amplitude only."
            ),
            Table("Dampers as they stand at the wheel.", ("damper", "parameter", "value (SI)"), parameters, "llr"),
        ),
    )


def _course(study: ProvingGround) -> Section:
    words = "Height of the course against distance, as measured and averaged over the tyre's contact."
    point = quantity(study.point_contact, "m/s^2", 3)
    first = str(study.figures["damper"].to_numpy()[0])
    averaged = study.figures["body_acceleration"].sel(damper=first).sel(speed=SHOWN_SPEED, method="nearest")
    text = (
        f"{_ENVELOPE} For {first} at {3.6 * SHOWN_SPEED:.0f} km/h the r.m.s. body acceleration is "
        f"{quantity(float(averaged), 'm/s^2', 3)}; a point contact would give {point}."
    )
    return Section("Course", (Picture(road_profile(study.courses), "course", words, words), Paragraph(text)))


def _ride(study: ProvingGround) -> Section:
    names = (
        "body_acceleration",
        "bump_travel_utilisation",
        "rebound_travel_utilisation",
        "wheel_load_variation",
        "lift_off",
        "damper_power",
    )
    words = "Ride figures against speed for the three dampers."
    speeds = [float(speed) for speed in study.figures["speed"].to_numpy()]
    rows = tuple(
        (
            f"{words_}, {damper}",
            *(quantity(float(study.figures[key].sel(damper=damper, speed=speed)), unit, 3) for speed in speeds),
        )
        for key, (unit, words_) in FIGURES.items()
        for damper in study.figures["damper"].to_numpy()
    )
    header = ("figure, damper", *(f"{3.6 * speed:.0f} km/h" for speed in speeds))
    note = "The imbalance is what the powers leave over: the energy in the tyre when it lifts off, and sampling."
    return Section(
        "Ride figures",
        (
            Picture(sweep(study.figures, names), "ride-figures", words, words),
            Table(
                "Ride figures over the undulated 304.8 m; wheel load r.m.s. is over the static load.",
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
        words = f"Signals with {name} at {3.6 * SHOWN_SPEED:.0f} km/h; deflection counts from design position."
        part = run.isel(time=(run["time"] > 20.0) & (run["time"] < 32.0))
        file = f"signals-{name.replace(' ', '-').replace('.', '')}"
        pictures.append(Picture(time_history(part, channels), file, words, words))
    return Section("Signals", tuple(pictures))


def _findings(study: ProvingGround) -> Section:
    return Section("Findings", (Findings(study.findings),))
