"""How this was made: version, definition of every number, sources."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.report.page import Block, Bullets, Paragraph, Section, Subsection, Table

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult

_DEFINITIONS = (
    (
        "objective",
        "Sum over all channels and samples of the squared difference between measurement and simulation (Eq. 2 of "
        "the quarter-car prototype paper), each channel weighted where the campaign says so.",
    ),
    ("reduction", "100 (before − after) / before, relative to the start of the same update."),
    (
        "standard error of a parameter",
        "From the exact sensitivities at the optimum, allowing for residuals that are "
        "correlated over time (Newey and West); interval: value ± 1.96 standard errors.",
    ),
    (
        "NRMSE",
        "Root mean square of the difference over the standard deviation of the measured signal: 0 is perfect, 1 is as "
        "good as the measured mean.",
    ),
    ("R²", "1 − NRMSE²."),
    ("peak error", "Largest absolute value simulated over that measured, minus 1."),
    ("lag", "Delay of the simulated signal with the largest cross-correlation."),
    (
        "ISO 18571",
        "Overall rating of ISO/TS 18571 (0.4 corridor + 0.2 phase + 0.2 magnitude + 0.2 slope): above 0.94 "
        "excellent, above 0.80 good, above 0.58 fair, else poor.",
    ),
    (
        "verdict",
        "By the worst channel of a trial. Holds: ISO 18571 above 0.80 and R² above 0.95. Holds partly: above 0.58 and "
        "0.75. Else it does not hold; not usable: the recording could not be read or simulated.",
    ),
    ("stiffness", "Slope of the fitted law; its interval treats the trials as the independent repetitions."),
    ("loss factor", "Energy lost in a cycle over 2π times the work of loading."),
    (
        "viscous damping and dry friction",
        "Fit of m x″ + c x′ + F sign(x′) + k (x − x₀) = 0 to the free decay, solved in "
        "closed form from turning point to turning point.",
    ),
    (
        "sensitivity",
        "Root mean square change of the weighted residuals when a parameter goes from the middle of its bounds to "
        "one end, at the start values.",
    ),
)
_SOURCES = (
    "ISO/TS 18571:2014, Road vehicles: Objective rating metric for non-ambiguous signals.",
    "J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, "
    "Transactions of the ASME 53 (1931) "
    "107–115.",
    "W. K. Newey, K. D. West, A simple, positive semi-definite, heteroskedasticity and autocorrelation "
    "consistent covariance "
    "matrix, Econometrica 55 (1987) 703–708.",
)


def method(result: CampaignResult) -> Section:
    """Version, campaign, definitions and sources."""
    import jounce

    blocks: list[Block] = [
        Paragraph(
            f"Made by jounce {jounce.__version__} from {len(result.trials)} trials. All numbers are also in "
            "results.json "
            "(SI units); updated rigs are the TOML files beside this page; figures are in the folder figures."
        )
    ]
    if result.campaign.synthetic:
        blocks.append(Paragraph(f"Origin of the data: {result.campaign.synthetic}", "bad"))
    if result.rig.source:
        blocks.append(Paragraph(f"Origin of the rig's described values: {result.rig.source}."))
    if result.rig.estimated:
        blocks.append(Paragraph(f"Not published, estimated: {', '.join(result.rig.estimated)}."))
    blocks += [
        Subsection("Definitions", (Table("What the numbers mean", ("number", "definition"), _DEFINITIONS),)),
        Subsection("Sources", (Bullets(_SOURCES),)),
    ]
    return Section("How this was made", tuple(blocks))
