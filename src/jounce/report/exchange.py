"""Pages of exports to other programs: their content, and what the format cannot represent."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from jounce.report.page import Block, Fact, Facts, Findings, Page, Paragraph, Section

if TYPE_CHECKING:
    from jounce.core.findings import Finding
    from jounce.exchange.chrono import ChronoExport
    from jounce.exchange.equations import Equations
    from jounce.exchange.fmu.export import FmuExport
    from jounce.exchange.mjcf import MjcfExport
    from jounce.exchange.points import HardpointExport
    from jounce.exchange.roads import RoadExport
    from jounce.parts.importers.drafts import ImportedRig


def fmu_page(export: FmuExport, *, title: str) -> Page:
    """Create a page of an FMU export."""
    binaries = f"for {', '.join(export.platforms)}" if export.platforms else "as sources only"
    facts = (
        Fact("inputs", ", ".join(export.inputs) or "none"),
        Fact("outputs", str(len(export.outputs))),
        Fact("states", str(export.states)),
        Fact("parameters", str(export.parameters)),
    )
    text = f"FMI {export.version}.0, model exchange and co-simulation, {binaries}"
    return _page(title, "FMU", [Paragraph(text), Facts(facts)], export.findings)


def equations_page(equations: Equations, *, title: str) -> Page:
    """Create a page of the names in equations of motion."""
    words = ("coordinates", "speeds", "inputs", "modes", "constraints")
    facts = tuple(Fact(word, ", ".join(getattr(equations, word)) or "none") for word in words)
    text = Paragraph("M a = Q + G^T lambda, G a + gamma = 0, dq/dt = dq; SI")
    return _page(title, "Equations of motion", [text, Facts(facts)])


def hardpoint_export_page(export: HardpointExport, *, title: str) -> Page:
    """Create a page with the number of hardpoints written."""
    text = Paragraph(
        f"{len(export.hardpoints)} hardpoints in mm: x forward, y left, z up from the road"
    )
    return _page(title, "Hardpoints", [text])


def chrono_export_page(export: ChronoExport, *, title: str) -> Page:
    """Create a page with the Project Chrono template that was written."""
    text = Paragraph(
        f"{export.template} of Project Chrono, left side; heights count from the wheel centre"
    )
    return _page(title, "Project Chrono", [text], export.findings)


def mjcf_export_page(export: MjcfExport, *, title: str) -> Page:
    """Create a page of the contents of a MuJoCo model."""
    parts = f"{export.bodies} bodies, {export.joints} joints, {export.loops} loops"
    return _page(
        title, "MuJoCo", [Paragraph(f"{parts}; SI, all frames as at design")], export.findings
    )


def road_export_page(export: RoadExport, *, title: str) -> Page:
    """Create a page with the number of road points written."""
    text = Paragraph(f"{export.points} points over {export.length:g} m")
    return _page(title, "Road", [text], export.findings)


def imported_rig_page(found: ImportedRig, *, title: str) -> Page:
    """Create a page about an imported file: the resulting rig, and the values that were estimated."""
    what = f"{getattr(found.rig, 'model', '')}, {found.rig.source}"
    estimated = f"estimated: {', '.join(found.rig.estimated) or 'nothing'}"
    return _page(title, what, [Paragraph(estimated)], found.advice())


def _page(title: str, what: str, blocks: Sequence[Block], findings: Sequence[Finding] = ()) -> Page:
    more = (Findings(tuple(findings)),) if findings else ()
    return Page(title, (Section(what, (*blocks, *more)),), what)
