"""A commented campaign to start from, and the shipped one."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

from jounce.core.errors import unknown
from jounce.core.serialise import write_files
from jounce.papers.table2 import table2
from jounce.papers.virtual_bench import BenchPlan, measurement_texts


def campaign_texts(name: str) -> dict[str, str]:
    """Give the description files of a shipped campaign: file name to text.

    Parameters
    ----------
    name : str
        ``kart-prototype`` or ``template``; their measurements come from the virtual bench.

    Returns
    -------
    dict
        ``campaign.toml``, ``rig.toml`` and what stands beside them; the prototype's ``quick-look.toml`` is the same
        campaign with a lumped rig.

    Raises
    ------
    DescriptionError
        For another name.

    Examples
    --------
    >>> sorted(campaign_texts("kart-prototype"))
    ['campaign.toml', 'quarter-car.toml', 'quick-look.toml', 'rig.toml']
    """
    library = resources.files("jounce") / "library" / "campaigns"
    names = sorted(folder.name for folder in library.iterdir() if folder.is_dir())
    if name not in names:
        raise unknown(name, names, what="shipped campaign", where="library")
    files = sorted((library / name).iterdir(), key=lambda file: file.name)
    return {file.name: file.read_text(encoding="utf-8") for file in files if file.is_file()}


def new_campaign(folder: Path | str, *, force: bool = False) -> Path:
    """Write a small commented campaign that runs as it is, with synthetic example recordings.

    Parameters
    ----------
    folder : path
        Where to; it is made.
    force : bool
        Overwrite existing files.

    Returns
    -------
    Path
        The new ``campaign.toml``.

    Raises
    ------
    OutputError
        When one of the files exists, without ``force``; then nothing is written.

    Examples
    --------
    >>> import tempfile
    >>> file = new_campaign(tempfile.mkdtemp())
    >>> sorted(path.name for path in file.parent.iterdir())
    ['README.txt', 'bench', 'campaign.toml', 'rig.toml', 'trials']
    """
    shown = tuple(row for row in table2() if row.number in (1, 2, 4))
    plan = BenchPlan(spring_trials=2, tyre_trials=2, decays=1, pressures=(310e3,), trials=shown, duration=1.5, seed=7)
    write_files(folder, {**campaign_texts("template"), **measurement_texts(plan)}, force=force)
    return Path(folder) / "campaign.toml"
