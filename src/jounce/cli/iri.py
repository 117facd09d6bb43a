"""``jounce iri``: roughness of a longitudinal profile."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from jounce.cli.options import AsJson, Columns, columns, positive_quantity, quantity
from jounce.cli.reply import Reply
from jounce.cli.tables import show_findings, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.roughness.iri import Roughness


def iri(
    profile: Annotated[
        str, typer.Argument(metavar="PROFILE", help="Columns x [m] and z [m], or a straight .crg road.")
    ],
    segment: Annotated[str, typer.Option(help="Length of the segments.")] = "100 m",
    offset: Annotated[str, typer.Option(help="Lateral offset of the line to take from a .crg road.")] = "0 m",
    columns_: Columns = None,
    as_json: AsJson = False,
) -> Reply:
    """Give the international roughness index (IRI) of a profile and of its segments.

    Example: jounce iri track.csv --segment "100 m"
    """
    length, lateral = positive_quantity(segment, "m", "--segment"), quantity(offset, "m", "--offset")
    from jounce.core.serialise import to_plain
    from jounce.roughness.iri import iri as roughness_of
    from jounce.roughness.iri import read_profile

    x, z, notes = read_profile(profile, columns=columns(columns_), lateral_offset=lateral)
    found = roughness_of(x, z, segment=length, place=profile)
    findings = [*notes, *found.findings]
    plain = {"profile": profile, "offset": lateral, **to_plain(found), "findings": to_plain(findings)}
    return Reply(plain, lambda out: _draw(out, profile, found, findings), as_json)


def _draw(out: Console, profile: str, found: Roughness, findings: list[Finding]) -> None:
    rows = [(part.start, part.end, part.iri_m_per_km, "partial" if part.partial else "") for part in found.segments]
    out.print(f"{profile}: IRI {found.iri_m_per_km:.4g} m/km", soft_wrap=True)
    out.print(table("", ("from m", "to m", "IRI m/km", ""), rows, text=(3,)))
    out.print(f"{found.end - found.start:g} m, samples every {found.spacing:g} m, slopes over {found.base:g} m")
    show_findings(out, findings)
