"""Creation of campaigns: from a commented template, or from a folder of measured files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from jounce.campaign.from_folder import FolderCampaign, Strategies, campaign_from_folder
from jounce.campaign.template import new_campaign
from jounce.core.errors import DescriptionError, unknown
from jounce.core.operation import File, Mark, Switch, operation
from jounce.core.shown import Shown

_STRATEGIES = ("default", "paper")


@dataclass(frozen=True)
class NewCampaign(Shown):
    """A campaign that was written into a folder.

    Attributes
    ----------
    folder : Path
        The folder.
    campaign : Path
        The campaign file in it.
    files : tuple of str
        All files in the folder.
    made : FolderCampaign or None
        Recognised kinds of the measured files, if the campaign was created from files.
    """

    folder: Path
    campaign: Path
    files: tuple[str, ...]
    made: FolderCampaign | None = None

    def to_dict(self) -> dict[str, Any]:
        """Return the folder with its files, or with the kinds recognised for the measured files."""
        more = {"files": list(self.files)} if self.made is None else self.made.to_dict()
        return {"folder": str(self.folder), **more}


@operation(
    "campaign new",
    named={"source": "from"},
    page="jounce.report.laboratory:new_campaign_page",
    title="{folder}",
    doing="writing the campaign",
    example="jounce campaign new my-campaign --from measured",
)
def start_campaign(
    folder: Annotated[Path | str, Mark("Folder to create.", "DIR")],
    source: Annotated[
        Path | str | None,
        File("Folder of measured files from which to create the campaign.", "FOLDER"),
    ] = None,
    *,
    settings: Annotated[
        Path | str | None,
        File("Settings of the laboratory; default: the settings file in --from.", "FILE"),
    ] = None,
    strategies: Annotated[
        Strategies,
        Mark(
            "Updates: one with all parameters, or the three of the prototype paper.",
            "default|paper",
        ),
    ] = "default",
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> NewCampaign:
    """Write a commented template campaign, or create a campaign from a folder of measured files.

    Parameters
    ----------
    folder : Path or str
        Folder to write to; created if necessary.
    source : Path or str, optional
        Folder of a laboratory's files, as for :func:`jounce.campaign_from_folder`; they are not moved.
    settings : Path or str, optional
        Settings of the laboratory, for files of ``source``.
    strategies : {"default", "paper"}
        Updates of a campaign created from ``source``.
    force : bool
        Overwrite existing files.

    Returns
    -------
    NewCampaign
        The campaign file, and what was written or recognised.

    Raises
    ------
    DescriptionError
        If settings or strategies are given without ``source``, or the settings are invalid.
    RecordingError
        If ``source`` is not a folder, or contains no table of trials.
    OutputError
        If a file exists and ``force`` is not set; nothing is written.

    Examples
    --------
    >>> import tempfile
    >>> start_campaign(tempfile.mkdtemp() + "/mine").campaign.name
    'campaign.toml'
    """
    if strategies not in _STRATEGIES:
        raise unknown(strategies, _STRATEGIES, what="strategies", where="strategies")
    if source is not None:
        made = campaign_from_folder(
            folder, source, settings=settings, strategies=strategies, force=force
        )
        return NewCampaign(Path(folder), made.campaign, _files(folder), made)
    if settings is not None or strategies != "default":
        where = "settings" if settings is not None else "strategies"
        raise DescriptionError(
            "applies only to measured files",
            where=where,
            hint="Name the folder of the files with --from.",
        )
    campaign = new_campaign(folder, force=force)
    return NewCampaign(Path(folder), campaign, _files(folder))


def _files(folder: Path | str) -> tuple[str, ...]:
    return tuple(
        sorted(str(file.relative_to(folder)) for file in Path(folder).rglob("*") if file.is_file())
    )
