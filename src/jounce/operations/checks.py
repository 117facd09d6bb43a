"""Checks of files: the kind of a file, and all its problems, without running it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from jounce.core.display import display_unit_for
from jounce.core.errors import DescriptionError, JounceError, RecordingError, below, unknown
from jounce.core.files import existing_file, matching_files
from jounce.core.operation import Switch, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.waiting import progress_through

if TYPE_CHECKING:
    from jounce.control import FmuVariable
    from jounce.core.findings import Finding
    from jounce.report.page import Block, Page


@dataclass
class FileCheck:
    """Result for one file: kind, description, problems, and the parameters that ``--set`` can change."""

    file: Path
    kind: str = "unknown"
    what: str = ""
    problems: list[str] = field(default_factory=list)
    notes: list[str | Finding] = field(default_factory=list)
    parameters: dict[str, dict[str, float | str]] = field(default_factory=dict)

    @contextmanager
    def step(self) -> Iterator[None]:
        """Record the error of one step and continue with the next one."""
        try:
            yield
        except JounceError as error:
            self.problems.append(error.message())
        except OSError as error:
            self.problems.append(f"{error.filename or self.file}: {error.strerror or error}.")


@dataclass(frozen=True)
class CheckedFiles(Shown):
    """Result of checking files.

    Attributes
    ----------
    files : tuple of FileCheck
        Each file with its kind, problems and notes.
    lists_parameters : bool
        Whether the numbers of rigs, vehicles and testers are listed by their paths.
    """

    files: tuple[FileCheck, ...]
    lists_parameters: bool = False

    @property
    def problems(self) -> tuple[str, ...]:
        """Return all problems, file by file."""
        return tuple(problem for item in self.files for problem in item.problems)

    def to_dict(self) -> dict[str, Any]:
        """Return the result of each file as plain data; numbers are in SI units."""
        files = [
            {
                "file": str(item.file),
                "kind": item.kind,
                "ok": not item.problems,
                "what": item.what,
                "problems": list(item.problems),
                "notes": list(map(str, item.notes)),
                **({"parameters": item.parameters} if self.lists_parameters else {}),
            }
            for item in self.files
        ]
        return {"ok": not self.problems, "files": files}


@operation(
    "check",
    page="jounce.operations.checks:checked_page",
    title="Checked files",
    doing="checking",
    example="jounce check campaign.toml rig.toml roads/*.toml",
)
def check_files(
    given: Annotated[
        Sequence[Path | str],
        Texts(
            "Rigs, vehicles (also shipped ones by their name), controllers, FMUs, laboratories, campaigns, studies, "
            "roads, testers, limits, layouts, recordings; or a folder with all its descriptions.",
            "FILE...",
        ),
    ],
    *,
    parameters: Annotated[
        bool, Switch("List the parameters of rigs, vehicles and testers by their paths.")
    ] = False,
    progress: Callable[[str], None] = lambda _: None,
) -> CheckedFiles:
    """Check files, and for a campaign all files it refers to. Exit code 2 if anything is wrong.

    Parameters
    ----------
    given : sequence of Path or str
        Files, patterns of their names, or names of shipped rigs and vehicles. Of a folder, all TOML files in it and
        below are checked, but not those of hidden folders such as ``.jounce``.
    parameters : bool
        List the numbers of rigs, vehicles and testers by their paths.
    progress : callable
        Called with a one-line message at each stage.

    Returns
    -------
    CheckedFiles
        Kind and problems of each file. Nothing is run.

    Raises
    ------
    RecordingError
        If no file matches a pattern, or a folder has no TOML file.

    Examples
    --------
    >>> found = check_files(["kart-quarter-car"], parameters=True)
    >>> found.problems, found.files[0].parameters["sprung.mass"]
    ((), {'value': 16.0, 'unit': 'kg'})
    """
    from jounce.parts import library as rigs

    checked, every = [], []
    for name in map(str, given):
        folder = Path(name)
        every += _descriptions_in(folder) if folder.is_dir() else matching_files([name], "FILE")
    for k, file in enumerate(every, 1):
        progress(progress_through("checking {which} of {count}: {name}", k, len(every), name=file))
        shipped = None if file.exists() else rigs().get(str(file))
        checked.append(
            check_file(file) if shipped is None else replace(check_file(shipped), file=file)
        )
    return CheckedFiles(tuple(checked), parameters)


def _descriptions_in(folder: Path) -> list[Path]:
    """Return all TOML files of a folder and below, but not those of hidden folders."""
    found = sorted(
        file
        for file in folder.rglob("*.toml")
        if not any(part.startswith(".") for part in file.relative_to(folder).parts)
    )
    if not found:
        raise RecordingError(
            "the folder has no description",
            where=str(folder),
            allowed="TOML files in it or below",
        )
    return found


def checked_page(checked: CheckedFiles, *, title: str) -> Page:
    """Create a page of the kinds and checks of files, with notes and parameters."""
    from jounce.report.page import Page, PageTable, Paragraph, Section

    rows = tuple(
        (str(item.file), item.kind, _verdict(len(item.problems)), item.what)
        for item in checked.files
    )
    blocks: list[Block] = [PageTable("", ("file", "kind", "verdict", "what"), rows, "llll")]
    blocks += [Paragraph(str(note)) for item in checked.files for note in item.notes]
    for item in checked.files:
        if checked.lists_parameters and item.parameters:
            numbers = tuple(_in_chosen_unit(path, given) for path, given in item.parameters.items())
            blocks.append(
                PageTable(f"{item.file}: parameters", ("path", "value", "unit"), numbers, "lrl")
            )
    return Page(title, (Section("Files", tuple(blocks)),))


def _verdict(problems: int) -> str:
    return f"{problems} problem{'s' if problems > 1 else ''}" if problems else "ok"


def _in_chosen_unit(path: str, given: Mapping[str, Any]) -> tuple[str, str, str]:
    """Format a parameter of a rig in the selected unit."""
    value = float(given["value"])
    shown = display_unit_for(given["unit"], path, abs(value))
    return path, f"{value * shown.factor:.6g}", shown.name


def check_file(file: Path) -> FileCheck:
    """Check one file by its kind: a description (TOML), the header of a record, a road, a table or a recording."""
    check = FileCheck(file)
    with check.step():
        checks: dict[str, Callable[[FileCheck], None]] = {
            ".toml": _check_toml,
            ".crg": _check_road,
            ".fmu": _check_fmu,
        }
        checks.get(file.suffix.lower(), _check_measured)(check)
    return check


def _check_toml(check: FileCheck) -> None:
    from jounce.core.description import read_toml
    from jounce.inspection.record import NUMBERS, SIDES, TEXTS, flat_facts

    table, text = read_toml(check.file)
    of_header = {*TEXTS, *(f"{side}.{name}" for side in SIDES for name in NUMBERS)}
    further = {key for key, value in table.items() if isinstance(value, (dict, list))} - {*SIDES}
    if "schema" not in table and not further and not of_header.isdisjoint(flat_facts(table)):
        _check_header(check, flat_facts(table), text)
        return
    schema = table.get("schema", "jounce.road/1" if "kind" in table else None)
    if schema is None:
        raise DescriptionError(
            "the schema line is missing", where=str(check.file), allowed=", ".join(_SCHEMAS)
        )
    schema = str(schema)
    if schema not in _SCHEMAS:
        raise unknown(schema, _SCHEMAS, what="schema", where=str(check.file))
    check.kind = schema.removeprefix("jounce.").removesuffix("/1")
    _SCHEMAS[schema](check)


def _check_rig(check: FileCheck) -> None:
    from jounce.parts import DependentAxle, load, rig_findings
    from jounce.simulation import equilibrium

    rig = load(check.file)
    check.what = f"{getattr(rig, 'model', 'rig')} with {len(rig.parameters())} parameters"
    check.parameters = _parameters(rig)
    check.notes += rig_findings(rig, str(check.file))
    lacks: tuple[str, ...] = getattr(rig, "lacks", ())
    if lacks:
        text = f"it has no {', '.join(lacks)}: its kinematics can be swept, it cannot move."
        check.notes.append(f"note: {check.file}: {text}")
        return
    try:
        if isinstance(rig, DependentAxle):
            from jounce.kc.laboratory import Laboratory

            Laboratory(rig)
        else:
            equilibrium(rig)
    except JounceError as error:
        raise DescriptionError(
            Phrase("the rig has no equilibrium: {error}", error=error.message()),
            where=str(check.file),
        ) from None


def _parameters(description: Any) -> dict[str, dict[str, float | str]]:
    """Return all parameters of a description by path, SI, with their units."""
    from jounce.parts.rig import parameters_of, unit_of

    parameters = parameters_of(description)
    return {
        path: {"value": value, "unit": unit_of(description, path)}
        for path, value in parameters.items()
    }


def _check_road(check: FileCheck) -> None:
    from jounce.roads import load_road
    from jounce.roads.trial import road_findings

    check.kind = "road"
    road = load_road(check.file)
    check.notes += road_findings(road, str(check.file))
    check.what = f"{getattr(road, 'kind', 'road')}, ends at {road.end():g} m"


def _check_control(check: FileCheck) -> None:
    from jounce.control import FmuControl, controller, read_fmu

    control = controller(check.file)
    check.what = str(getattr(control, "law", type(control).__name__))
    if check.what == "fmu":  # it is read, but not run
        from jounce.control import read_fmu

        component = read_fmu(str(getattr(control, "file", "")))
        component.binary()
        check.what = f"{check.what}: {component.path.name}"
    if isinstance(control, FmuControl):
        read_fmu(control.file).binary()


def _check_fmu(check: FileCheck) -> None:
    """Check an FMU: its connectable variables, and whether it runs here as a controller or force element."""
    from jounce.control import read_fmu

    component = read_fmu(check.file)
    check.kind = "FMU"
    uses = [
        word
        for word, can in (
            ("co-simulation", component.can_step),
            ("model exchange", component.can_be_integrated),
        )
        if can
    ]
    check.what = f"FMI {component.version}.0, {', '.join(uses)}, for {', '.join(component.platforms) or 'no platform'}"
    for word, group in (
        ("inputs", component.inputs),
        ("outputs", component.outputs),
        ("parameters", component.parameters),
    ):
        shown = [_connectable(v) for v in group[:_MANY]]
        more = f" and {len(group) - _MANY} more" if len(group) > _MANY else ""
        check.notes.append(f"{word}: {', '.join(shown) or 'none'}{more}")
    check.notes += component.findings


def _connectable(v: FmuVariable) -> str:
    """Describe a variable of an FMU with its unit, and its type if it is not a real scalar."""
    of = "" if v.kind in ("Real", "Float64") and not v.dimensions else f" ({v.shape})"
    return f"{v.name}{f' [{v.unit}]' if v.unit else ''}{of}"


_MANY = 20  # variables of an FMU per line


def _check_tester(check: FileCheck) -> None:
    from jounce.parts.testers import findings_of_tester, load_tester

    tester = load_tester(check.file)
    check.what = f"{tester.name}: {tester.kind}, evaluated by {tester.method}"
    check.parameters = _parameters(tester)
    check.notes += findings_of_tester(tester, str(check.file))


def _check_limits(check: FileCheck) -> None:
    from jounce.inspection.limits import load_limits

    limits = load_limits(check.file)
    further = [*limits.conditions, *(f"difference of {name}" for name in limits.differences)]
    check.what = f"{limits.label}: {', '.join([*limits.methods, *further])}"


def _check_header(check: FileCheck, facts: dict[str, Any], text: str) -> None:
    """Check the header file of a record, with facts about the car; each error is reported with its line."""
    from jounce.core.description import line_of
    from jounce.inspection.record import read_facts

    check.kind, check.what = "header of a record", ", ".join(facts)
    for key, value in facts.items():
        line = line_of(text, tuple(key.split("."))) or line_of(text, (key,))
        with check.step():
            _, findings = read_facts({key: value}, where=f"{check.file}, line {line}")
            check.notes += findings


def _check_measured(check: FileCheck) -> None:
    """Check a recording, a force-deflection trial or a road table: the first whose columns the file contains."""
    from jounce.recordings import read_columns

    tables = {
        "force-deflection trial": {"displacement": "m", "force": "N"},
        "road table": {"x": "m", "z": "m"},
    }
    missing: list[JounceError] = []
    for kind in ("recording", *tables):
        check.kind = kind
        try:
            if kind == "recording":
                _check_recording(check)
            else:
                values, findings = read_columns(check.file, tables[kind])
                check.what = f"{len(next(iter(values.values())))} rows"
                check.notes += findings
        except RecordingError as error:
            if not error.what.startswith(
                ("no column", "no channel")
            ):  # errors of readers on a different kind of file
                raise
            missing.append(error)
        else:
            return
    check.kind = "unknown"
    raise missing[0]


def _check_recording(check: FileCheck) -> None:
    from jounce.recordings import read_recording

    data, findings = read_recording(check.file)
    if any(str(name).endswith(".plate.force") for name in data.data_vars):
        from jounce.inspection.record import read_record

        check.kind = "record of a tester"
        data, findings = read_record(check.file)
    time = data["time"].to_numpy()
    check.what = (
        f"{', '.join(map(str, data.data_vars))}; {len(time)} samples, {time[-1] - time[0]:g} s"
    )
    check.notes += findings


def _check_campaign(check: FileCheck) -> None:
    """Check a campaign, its rig and roads, and all files of bench and trials."""
    from jounce.campaign import load_campaign
    from jounce.campaign.characterise import files_of, read_force_deflection
    from jounce.campaign.run import checks_of, load_trial
    from jounce.parts import load
    from jounce.parts.files import rig_named_in
    from jounce.roads import read_roads
    from jounce.roads.trial import road_findings

    campaign, text = load_campaign(check.file)
    folder, where = check.file.parent, str(check.file)
    check.what = ", ".join(
        f"{count} {word}{'' if count == 1 else 's'}"
        for count, word in ((len(campaign.trial), "trial"), (len(campaign.update), "update"))
    )
    with check.step():
        rig = load(rig_named_in(campaign.rig, check.file))
        for examine in checks_of(campaign, rig, check.file):
            with check.step():
                examine()
    roads: dict[str, Any] = dict.fromkeys(campaign.roads)
    with check.step():
        roads = dict(read_roads(campaign.roads, where=where, text=text, folder=folder))
        for name, road in roads.items():
            check.notes += road_findings(road, f"{where}: roads.{name}")
    for entry in campaign.trial:
        place = f"{where}: trial {entry.number}"
        if entry.road is not None and entry.road not in roads:
            check.problems.append(unknown(entry.road, roads, what="road", where=place).message())
        with check.step():
            try:
                if entry.road is not None and roads.get(entry.road) is None:
                    entry.read(
                        folder / entry.recording, folder
                    )  # errors of its road are already reported
                else:
                    load_trial(entry, roads, folder, campaign)
            except JounceError as error:
                raise RecordingError(
                    error.what,
                    where=below(place, error.where),
                    found=error.found,
                    allowed=error.allowed,
                    hint=error.hint,
                ) from None
    bench = campaign.bench
    tables = {
        "bench.spring": bench.spring,
        **{f'bench.tyre."{name}"': item for name, item in bench.tyre.items()},
    }
    for name, asked in tables.items():
        if asked is not None:
            with check.step():
                read_force_deflection(files_of(asked.files, folder, f"{where}: {name}"), asked)
    if bench.decay is not None:
        with check.step():
            for file in files_of(bench.decay.files, folder, f"{where}: bench.decay"):
                bench.decay.read(file, folder)


def _check_laboratory(check: FileCheck) -> None:
    """Check the settings of a laboratory, with the rig and the table of trials they refer to."""
    from jounce.campaign.laboratory import load_laboratory, read_trials
    from jounce.parts import load
    from jounce.parts.files import rig_named_in

    laboratory = load_laboratory(check.file)
    measured = ", ".join(channel.measures for channel in laboratory.channels.values())
    obstacle = f"obstacle of {1e3 * laboratory.obstacle.height:g} mm by {1e3 * laboratory.obstacle.length:g} mm"
    check.what = f"settings of a laboratory: {obstacle}; channels {measured or 'none'}"
    if laboratory.rig:
        with check.step():
            load(rig_named_in(laboratory.rig, check.file))
    if laboratory.trials:
        with check.step():
            try:
                table = existing_file(check.file.parent / laboratory.trials, RecordingError)
            except RecordingError as error:
                where = f"{check.file}: trials"
                raise RecordingError(
                    error.what, where=where, found=laboratory.trials, hint=error.hint
                ) from None
            count = len(read_trials(table))
            check.what += f"; {count} trial{'' if count == 1 else 's'}"


def _check_truth(check: FileCheck) -> None:
    from jounce.campaign import load_truth

    truth = load_truth(check.file)
    channels, rig = ", ".join(truth.sensors), truth.true_rig()
    check.what = (
        f"virtual bench: {getattr(rig, 'model', '')} with {len(rig.parameters())} parameters; "
        f"records {channels}"
    )


def _check_design(check: FileCheck) -> None:
    from jounce.design.kinematics import check_study

    study, free = check_study(check.file)
    check.what = f"design of {study.rig}: {free} free numbers, {len(study.target)} targets, {study.starts} starts"


def _check_sweep(check: FileCheck) -> None:
    from jounce.variants.study import read_sweep

    sweep = read_sweep(check.file)
    metrics, numbers = len(sweep.work.metrics), len(sweep.columns)
    check.what = (
        f"sweep of {sweep.study.rig}: {sweep.count} variants of {numbers} number{'' if numbers == 1 else 's'}, "
        f"{metrics} metric{'' if metrics == 1 else 's'}"
    )


def _check_optimisation(check: FileCheck) -> None:
    from jounce.design.optimisation_study import check_optimisation

    study, problem = check_optimisation(check.file)
    wanted = "front" if study.front is not None else "best design"
    count = len(problem.free)
    check.what = (
        f"{wanted} of {study.rig}: {count} number{'' if count == 1 else 's'} over {problem.driven}"
    )


def _check_sensor_file(check: FileCheck) -> None:
    from jounce.recordings.sensor_files import read_sensors

    check.what = f"sensors of {', '.join(read_sensors(check.file))}"


def _check_layout(check: FileCheck) -> None:
    """Check a layout of the page Data: its formulas, and whether its recordings are in the project."""
    from jounce.analysis.formula_text import channels_in
    from jounce.analysis.layouts import FOLDER, load_layout

    layout = load_layout(check.file)
    check.what = ", ".join(
        f"{len(items)} {word}{'' if len(items) == 1 else 's'}"
        for word, items in (
            ("recording", layout.recordings),
            ("graph", layout.graphs),
            ("formula", layout.formulas),
        )
    )
    for formula in layout.formulas:
        with check.step():
            try:
                channels_in(formula.formula, [])
            except DescriptionError as error:
                raise DescriptionError(
                    error.what,
                    where=f"{check.file}: {formula.name} = {error.where}",
                    found=error.found,
                    allowed=error.allowed,
                    hint=error.hint,
                ) from None
    folder = check.file.parent
    project = folder.parent if folder.name == FOLDER else folder
    for recording in layout.recordings:
        if not (project / recording.path).is_file():
            check.problems.append(
                RecordingError(
                    "no such file", where=f"{check.file}: recordings", found=recording.path
                ).message()
            )


def _check_kc_map(check: FileCheck) -> None:
    from jounce.kc.channels import as_map

    rig = as_map(check.file)
    check.what = f"{len(rig.columns)} columns, {len(rig.tests)} tests"


_SCHEMAS: dict[str, Callable[[FileCheck], None]] = {
    "jounce.rig/1": _check_rig,
    "jounce.vehicle/1": _check_rig,
    "jounce.campaign/1": _check_campaign,
    "jounce.laboratory/1": _check_laboratory,
    "jounce.sensors/1": _check_sensor_file,
    "jounce.truth/1": _check_truth,
    "jounce.road/1": _check_road,
    "jounce.control/1": _check_control,
    "jounce.tester/1": _check_tester,
    "jounce.limits/1": _check_limits,
    "jounce.design/1": _check_design,
    "jounce.sweep/1": _check_sweep,
    "jounce.optimisation/1": _check_optimisation,
    "jounce.layout/1": _check_layout,
    "jounce.kc-map/1": _check_kc_map,
}
