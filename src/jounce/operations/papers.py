"""Operations of the papers: these use public names only, so their commands are described here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

from jounce.core.commands import command_line
from jounce.core.operation import Count, File, Mark, Number, Settings, Switch, operation
from jounce.core.serialise import Plain
from jounce.core.writing import check_folder
from jounce.papers.virtual_bench import virtual_bench
from jounce.report.page import Bullets, Page, Paragraph, Section


@dataclass(frozen=True)
class SyntheticCampaign(Plain):
    """Synthetic recordings with the campaign that evaluates them: campaign file, and all files of its folder."""

    left_out = ("campaign",)

    folder: str
    campaign: Path
    seed: int
    changes: Mapping[str, Any] = field(default_factory=dict)
    files: tuple[str, ...] = ()


@operation(
    "campaign synthesise",
    named={"changes": "set"},
    faces={"duration": "3 s"},
    python="jounce.papers.virtual_bench:virtual_bench",
    page="jounce.operations.papers:synthetic_page",
    title="{folder}",
    doing="simulating",
    example='jounce campaign synthesise my-bench --seed 7 --set rig.strut.friction.force="0 N"',
)
def synthesise_campaign(
    folder: Annotated[Path | str, Mark("Folder to create.", "DIR")],
    truth: Annotated[
        str,
        File(
            "True parameters of the bench: a file, or a shipped name (kart-prototype, kart-low-friction).",
            "TRUTH",
        ),
    ] = "kart-prototype",
    *,
    changes: Annotated[
        Mapping[str, Any] | None,
        Settings(
            'Change the truth, or its rig behind "rig.": belt.speed_drop="0 %", '
            'rig.strut.damper="{coefficient = 104}". Repeat it.',
            "PATH=VALUE",
            'strut.spring.rate="25 N/mm"',
        ),
    ] = None,
    seed: Annotated[int, Count("Random seed of all scatter and noise.", least=0)] = 2008,
    duration: Annotated[
        float, Number("Length of each recording.", "TIME", "s", is_positive=True)
    ] = 3.0,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
    progress: Callable[[str], None] = lambda _: None,
) -> SyntheticCampaign:
    """Generate synthetic recordings of a bench with known parameters, and the campaign that evaluates them.

    A method can be tested by whether it recovers the chosen values. Equivalent to :func:`jounce.virtual_bench`.
    """
    check_folder(folder, force=force)
    given = dict(changes or {})
    options: dict[str, Any] = {"changes": given, "seed": seed, "duration": duration, "force": force}
    file = virtual_bench(folder, truth, **options, progress=progress)
    made = sorted(
        str(path.relative_to(folder)) for path in Path(folder).rglob("*") if path.is_file()
    )
    return SyntheticCampaign(str(folder), file, seed, given, tuple(made))


def synthetic_page(campaign: SyntheticCampaign, *, title: str) -> Page:
    """Create a page of a synthetic campaign: number of files, and next steps."""
    run = command_line(["jounce", "campaign", "run", str(campaign.campaign), "--out", "results"])
    text = f"{len(campaign.files)} files, synthetic; the values behind them are in truth.toml"
    return Page(title, (Section("Files", (Paragraph(text), Paragraph("Next:"), Bullets((run,)))),))
