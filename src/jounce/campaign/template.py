"""Commented template of a campaign."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

from jounce.core.writing import write_files


def new_campaign(folder: Path | str, *, force: bool = False) -> Path:
    """Write a small commented campaign with synthetic example recordings, which runs without changes.

    Parameters
    ----------
    folder : path
        Folder to write to; created if necessary.
    force : bool
        Overwrite existing files.

    Returns
    -------
    Path
        The new ``campaign.toml``.

    Raises
    ------
    OutputError
        If one of the files exists and ``force`` is not set; nothing is written.

    Examples
    --------
    >>> import tempfile
    >>> file = new_campaign(tempfile.mkdtemp())
    >>> sorted(path.name for path in file.parent.iterdir())
    ['README.txt', 'bench', 'campaign.toml', 'rig.toml', 'trials']
    """
    template = Path(str(resources.files("jounce"))) / "library" / "campaigns" / "template"
    files = (file for file in sorted(template.rglob("*")) if file.is_file())
    write_files(
        folder, {str(file.relative_to(template)): file.read_bytes() for file in files}, force=force
    )
    return Path(folder) / "campaign.toml"
