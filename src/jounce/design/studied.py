"""Hardpoints from the targets of a study file, with the output files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.operation import Count, File, operation
from jounce.core.serialise import Plain, to_json
from jounce.design.kinematics import KinematicDesign, design, run_study
from jounce.parts.files import updated_text


@dataclass(frozen=True)
class StudiedDesign(Plain):
    """Hardpoints found for a study file.

    Attributes
    ----------
    design : KinematicDesign
        Rigs, targets before and after, moved points, SI.
    sources : mapping of str to Path
        The file of each rig.
    study : str
        Name of the study.
    """

    design: KinematicDesign
    sources: Mapping[str, Path]
    study: str

    @property
    def is_met(self) -> bool:
        """Whether all targets are within their tolerances."""
        return self.design.met

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings of the search."""
        return self.design.findings

    @property
    def subject(self) -> str:
        """Name of the rig, or of the study if it has several rigs."""
        return next(iter(self.sources.values())).stem if len(self.sources) == 1 else self.study

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI."""
        return self.design.to_dict()

    def files(self) -> dict[str, bytes | str]:
        """Return the rigs with their comments, the results, and tables, by file name."""
        design = self.design
        rigs = {
            f"{name or 'rig'}.toml": updated_text(
                self.sources[name].read_text(encoding="utf-8"), rig
            )
            for name, rig in design.rigs.items()
        }
        spreads = {
            f"spread-{name}.csv" if name else "spread.csv": spread.table()
            for name, spread in design.spread.items()
        }
        return {
            **rigs,
            "results.json": f"{to_json(design.results())}\n",
            "targets.csv": design.curve_table(),
            "sensitivity.csv": design.sensitivity_table(),
            "tradeoffs.csv": design.tradeoff_table(),
            "identified.csv": design.identified_table(),
            **spreads,
        }


@operation(
    "design kinematics",
    offers=("folder", "figure", "report"),
    page="jounce.report.kinematic_design:studied_design_page",
    title="Kinematics of {result.subject}",
    doing="searching",
    example="jounce design kinematics study.toml --out designed",
)
def design_from_study(
    study: Annotated[Path | str, File('Study file, schema = "jounce.design/1".', "STUDY.toml")],
    *,
    starts: Annotated[
        int | None, Count("Number of searches; the study's own by default.", least=1)
    ] = None,
) -> StudiedDesign:
    """Find hardpoints that meet kinematic targets. Exit code 1 if targets are missed.

    Parameters
    ----------
    study : path
        A file of the schema ``jounce.design/1``.
    starts : int, optional
        Number of searches; the study's own by default.

    Returns
    -------
    StudiedDesign
        The result of :func:`jounce.design_kinematics`, with its output files.

    Raises
    ------
    DescriptionError
        As for :func:`jounce.design_kinematics`, with file and line.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "study.toml"
    >>> text = '''
    ... schema = "jounce.design/1"
    ... rig = "formula-student-front"
    ... starts = 1
    ... free = [{point = "hardpoints.tie_rod_inner", within = "5 mm"}]
    ... target = [{quantity = "toe", at = "10 mm", value = "0 deg", tolerance = "0.1 deg"}]
    ... '''
    >>> _ = file.write_text(text)
    >>> design_from_study(file).is_met
    True
    """
    if starts is not None and starts < 1:
        raise DescriptionError("out of range", where="starts", found=starts, allowed="1 or more")
    result, sources = run_study(
        study, lambda asked, task: design(task, starts or asked.starts, asked.seed)
    )
    return StudiedDesign(result, sources, Path(study).stem)
