"""Long sweeps: shards, what stops a sweep, and what a resumed one must agree with."""

from __future__ import annotations

import json
import subprocess
import sys
from collections import namedtuple
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import DescriptionError, OutputError
from jounce.core.trust import trust_said, trusting
from jounce.simulation.settings import RunSettings
from jounce.variants import shards, workers
from jounce.variants.many import read_request
from jounce.variants.summary import summarise

RIG = jn.load("audi-a6-quarter-car")
TRIAL = jn.Trial(road=jn.HalfSine(height="10 mm", length="1 m"), speed="10 m/s", duration="0.5 s")
METRICS = ["rms sprung.az", "max tyre.force"]


def design(count: int = 40, seed: int = 1, heaviest: str = "520 kg") -> jn.sobol:
    return jn.sobol(
        {"strut.damper.coefficient": "40 %", "sprung.mass": ["400 kg", heaviest]}, count, seed=seed
    )


def sweep(out: Path, variants=None, **options):
    return jn.simulate_many(RIG, TRIAL, variants or design(), metrics=METRICS, out=out, **options)


@pytest.fixture
def small(monkeypatch):
    """Shards of eight variants."""
    monkeypatch.setattr(shards, "_size", lambda *_: 8)


@pytest.mark.parametrize(
    ("seconds", "workers", "size"),
    [
        (1e-3, 64, 256),  # 0.2 s of work for each, though others stand idle
        (1e-3, 1, 2048),  # four seconds at most
        (0.1, 64, 8),  # four for each of 64
        (5.0, 64, 1),
        (1e-7, 64, 65_536),
    ],
)
def test_shards_are_worth_handing_on(seconds: float, workers: int, size: int, monkeypatch) -> None:
    monkeypatch.setattr(shards, "_bytes_of_a_variant", lambda *_: 100)
    columns = {"sprung.mass": np.zeros(4000)}
    assert shards._size(None, columns, workers, shards._Pace(seconds, is_alone=True)) == size


def files(out: Path) -> list[str]:
    return sorted(file.name for file in (out / "shards").iterdir())


@pytest.mark.parametrize("folder", ["out", "out.zarr"])
def test_shards_hold_what_one_call_gives(tmp_path: Path, small, folder) -> None:
    found = sweep(tmp_path / folder)
    whole = jn.simulate_many(RIG, TRIAL, design(), metrics=METRICS)
    assert len(files(tmp_path / folder)) == 5
    assert found.attrs == {**whole.attrs, "variants": 40}
    for name in (*METRICS, "sprung.mass", "variant"):
        np.testing.assert_array_equal(found[name].values, whole[name].values)
        assert found[name].attrs == whole[name].attrs
    assert set(found["reason"].values) == {""}
    assert jn.load_sweep(tmp_path / folder).identical(found)


@pytest.mark.parametrize("said", [None, False, True])
def test_workers_are_told_what_may_run_in_their_process(monkeypatch, said: bool | None) -> None:
    """They are processes, or machines, of their own: what the user said of FMUs goes with the work."""
    seen = []
    monkeypatch.setattr(workers, "shard_of", lambda *_: seen.append(trust_said()) or b"")
    with trusting(said):
        packed = workers._pack("work")
    workers.work_on(packed, workers.Task(0, 0, {}, workers.metadata.version("jounce")))
    assert seen == [said]


@pytest.mark.parametrize("folder", ["out", "out.zarr"])
def test_a_reason_of_a_later_shard_is_whole(tmp_path: Path, small, folder) -> None:
    masses = [450.0] * 20
    masses[17] = -1.0
    found = sweep(tmp_path / folder, {"sprung.mass": masses})
    assert "sprung.mass" in found["reason"].values[17]
    assert found["reason"].values[17].endswith(".")
    assert np.isnan(found["rms sprung.az"].values[17])
    assert np.isfinite(found["rms sprung.az"].values[[16, 18]]).all()


def test_a_variant_that_ends_in_an_unforeseen_way_is_a_row_with_its_reason(monkeypatch) -> None:
    from jounce.variants import many

    monkeypatch.setattr(many._TrialGroup, "_solve", lambda *_: 1 / 0)
    found = jn.simulate_many(
        RIG,
        TRIAL.model_copy(update={"duration": 3.0}),
        {"sprung.mass": [400.0, 500.0]},
        metrics="Wk sprung.az",
    )
    assert all("division by zero" in text for text in found["reason"].values)


@pytest.mark.parametrize("folder", ["out", "out.zarr"])
def test_channels_over_time_are_kept_by_shards(tmp_path: Path, small, folder) -> None:
    found = jn.simulate_many(RIG, TRIAL, design(20), outputs="sprung.z", out=tmp_path / folder)
    whole = jn.simulate_many(RIG, TRIAL, design(20), outputs="sprung.z")
    assert found["sprung.z"].dims == ("variant", "time")
    np.testing.assert_array_equal(found["sprung.z"].values, whole["sprung.z"].values)
    assert "sprung.z" not in jn.load_sweep(tmp_path / folder, channels=False)


@pytest.mark.parametrize("damage", ["gone", "cut", "changed"])
def test_a_resumed_sweep_works_on_what_is_missing_or_damaged_only(
    tmp_path: Path, small, monkeypatch, damage
) -> None:
    before = sweep(tmp_path)
    chosen = sorted((tmp_path / "shards").iterdir())[2]
    content = chosen.read_bytes()
    if damage == "gone":
        chosen.unlink()
    else:
        chosen.write_bytes(
            content[:-50] if damage == "cut" else content[:-50] + b"!" + content[-49:]
        )
    assert jn.load_sweep(tmp_path).sizes["variant"] == 32  # what is damaged is not read
    worked: list[int] = []
    run = workers.shard_of
    monkeypatch.setattr(
        workers,
        "shard_of",
        lambda work, task, threads: worked.append(task.number) or run(work, task, threads),
    )
    after = sweep(tmp_path, resume=True)
    assert worked == [2]
    assert after.identical(before)
    assert len(files(tmp_path)) == 5


@pytest.mark.parametrize("damage", ["gone", "cut", "changed"])
@pytest.mark.parametrize("piece", ["rms sprung.az/2", "reason/2", "shards/000002.*.json"])
@pytest.mark.some(3)
def test_a_damaged_chunk_of_a_zarr_group_is_worked_on_again(
    tmp_path: Path, small, piece, damage
) -> None:
    out = tmp_path / "out.zarr"
    before = sweep(out)
    (chosen,) = out.glob(piece)
    content = chosen.read_bytes()
    if damage == "gone":
        chosen.unlink()
    else:
        chosen.write_bytes(
            content[:-1] if damage == "cut" else bytes([content[0] ^ 1]) + content[1:]
        )
    assert jn.load_sweep(out)["variant"].values.tolist() == [*range(16), *range(24, 40)]
    assert sweep(out, resume=True).identical(before)
    assert len(files(out)) == 5


def test_other_programs_read_a_zarr_group(tmp_path: Path, small) -> None:
    """By the Zarr package, which knows nothing of jounce; 37 variants: the last chunk is not full."""
    pytest.importorskip("zarr")
    masses = [450.0 + i for i in range(37)]
    masses[17] = -1.0
    variants = {"sprung.mass": masses}
    found = jn.simulate_many(
        RIG, TRIAL, variants, metrics=METRICS, outputs="sprung.z", out=tmp_path / "of masses.zarr"
    )
    with xr.open_zarr(tmp_path / "of masses.zarr") as group:
        assert group["sprung.z"].encoding["chunks"] == (8, found.sizes["time"])
        assert group.load().identical(found)


def test_a_zarr_group_can_be_read_while_its_sweep_goes_on(
    tmp_path: Path, small, monkeypatch
) -> None:
    pytest.importorskip("zarr")
    whole, put = sweep(tmp_path / "whole"), shards.zarr_shards.put

    def stopped(folder, number, *others):
        if number == 3:
            raise KeyboardInterrupt
        return put(folder, number, *others)

    monkeypatch.setattr(shards.zarr_shards, "put", stopped)
    with pytest.raises(KeyboardInterrupt):
        sweep(tmp_path / "out.zarr")
    for name in METRICS:
        values = xr.load_dataset(tmp_path / "out.zarr", engine="zarr")[name].values
        np.testing.assert_array_equal(values[:24], whole[name].values[:24])
        assert np.isnan(values[24:]).all()
    monkeypatch.undo()
    assert sweep(tmp_path / "out.zarr", resume=True)["variant"].values.tolist() == list(range(40))


def test_a_folder_that_was_begun_with_netcdf_goes_on_with_it(tmp_path: Path, small) -> None:
    """Once the name of a folder did not choose the format, and ``sweep.json`` did not tell it."""
    before = sweep(tmp_path / "out")
    about = tmp_path / "out" / "sweep.json"
    about.write_text(
        json.dumps(
            {key: one for key, one in json.loads(about.read_text()).items() if key != "format"}
        )
    )
    (tmp_path / "out").rename(tmp_path / "out.zarr")
    next((tmp_path / "out.zarr" / "shards").iterdir()).unlink()
    assert sweep(tmp_path / "out.zarr", resume=True).identical(before)
    assert {name[-3:] for name in files(tmp_path / "out.zarr")} == {".nc"}


def test_what_is_full_keeps_what_is_finished(tmp_path: Path, small, monkeypatch) -> None:
    write = shards.write_atomically

    def full(path: Path, content, **options):
        if Path(path).name.startswith("000003"):
            raise OutputError(
                "the file cannot be written", where=str(path), found="No space left on device"
            )
        return write(path, content, **options)

    monkeypatch.setattr(shards, "write_atomically", full)
    with pytest.raises(
        OutputError, match=r"No space left on device'\. What is finished is kept: make room"
    ):
        sweep(tmp_path)
    with pytest.raises(
        OutputError, match=r"contains a sweep; found '3 of 5 shards'\. Continue with --resume"
    ):
        sweep(tmp_path)
    assert len(files(tmp_path)) == 3
    monkeypatch.undo()
    found = sweep(tmp_path, resume=True)
    assert found.identical(jn.load_sweep(tmp_path))
    np.testing.assert_array_equal(found["variant"], np.arange(40))


def test_more_results_than_the_disk_holds_are_refused_before_the_work(
    tmp_path: Path, small, monkeypatch
) -> None:
    usage = namedtuple("usage", "total used free")
    monkeypatch.setattr(shards.shutil, "disk_usage", lambda _: usage(1e6, 1e6 - 2e5, 2e5))
    with pytest.raises(OutputError, match="exceed the free disk space"):
        sweep(tmp_path / "out")
    assert not (tmp_path / "out").exists()


def changed_rig(out: Path) -> None:
    jn.simulate_many(
        RIG.with_changes({"tyre.stiffness": 3.1e5}),
        TRIAL,
        design(),
        metrics=METRICS,
        out=out,
        resume=True,
    )


@pytest.mark.parametrize(
    ("change", "named"),
    [
        (changed_rig, "rig.tyre.stiffness: 300000.0 before, 310000.0 now"),
        (
            lambda out: sweep(out, design(seed=2), resume=True),
            r"found 'variants.seed: 1 before, 2 now'\.",
        ),
        (lambda out: sweep(out, design(48), resume=True), r"found 'variants: 40 before, 48 now'\."),
        (
            lambda out: sweep(out, design(heaviest="600 kg"), resume=True),
            r"found 'variants.sprung.mass: 40\S+ to 5[12]\S+ before, 40\S+ to 59\S+ now'\.",
        ),
        (
            lambda out: sweep(out, resume=True, output_step=2e-3),
            "settings.output_step: 0.001 before, 0.002 now",
        ),
        (
            lambda out: jn.simulate_many(
                RIG, TRIAL, design(), metrics=METRICS[:1], out=out, resume=True
            ),
            r"metrics\[1\]: max tyre.force before, nothing now",
        ),
    ],
)
def test_another_study_is_refused_naming_what_changed(tmp_path: Path, small, change, named) -> None:
    sweep(tmp_path)
    before = files(tmp_path)
    with pytest.raises(OutputError, match=named):
        change(tmp_path)
    assert files(tmp_path) == before


def test_a_file_that_the_trial_reads_belongs_to_the_study(tmp_path: Path, small) -> None:
    base = tmp_path / "base.csv"

    def run(height: float):
        rows = "".join(f"{k / 100},{height * (k % 7)}\n" for k in range(40))
        base.write_text(f"time [s], road.z [m]\n{rows}", encoding="utf-8")
        trial = jn.Trial(excitation=base)
        return jn.simulate_many(
            RIG,
            trial,
            {"sprung.mass": [400.0, 450.0]},
            metrics=METRICS,
            out=tmp_path / "out",
            resume=True,
        )

    run(1e-3)
    run(1e-3)
    with pytest.raises(OutputError, match=r"trial.excitation.file.content"):
        run(2e-3)


def test_a_folder_with_other_things_is_left_alone(tmp_path: Path, small) -> None:
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    for resume in (False, True):
        with pytest.raises(OutputError, match="not empty"):
            sweep(tmp_path, resume=resume)
    assert [file.name for file in tmp_path.iterdir()] == ["notes.txt"]
    with pytest.raises(OutputError, match="contains no sweep"):
        jn.load_sweep(tmp_path)


@pytest.mark.parametrize(
    "content", [b"", b"\xff", b"[]", b"{}", b'{"schema": "jounce.sweep-results/1", "count": "x"}']
)
def test_a_manifest_that_says_nothing_is_told(tmp_path: Path, small, content) -> None:
    sweep(tmp_path)
    (tmp_path / "sweep.json").write_bytes(content)
    for read in (jn.load_sweep, lambda out: sweep(out, resume=True)):
        with pytest.raises(OutputError, match="does not describe a sweep"):
            read(tmp_path)


@pytest.mark.parametrize("options", [{"resume": True}, {"workers": 2}, {"client": object()}])
def test_what_goes_with_a_folder_only(options) -> None:
    with pytest.raises(DescriptionError, match=next(iter(options))):
        jn.simulate_many(RIG, TRIAL, design(), metrics=METRICS, **options)


def test_a_function_is_no_part_of_a_file(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="Python function"):
        jn.simulate_many(
            RIG,
            TRIAL,
            {"sprung.mass": [450.0]},
            metrics=METRICS,
            control=lambda _m, _t: 0.0,
            out=tmp_path / "out",
        )


@pytest.mark.skipif(sys.platform == "win32", reason="locks of folders are a thing of POSIX")
def test_two_at_once_on_one_folder(tmp_path: Path, small) -> None:
    sweep(tmp_path)
    with shards._lock(tmp_path), pytest.raises(OutputError, match="another process is working"):
        sweep(tmp_path, resume=True)


def test_a_sweep_that_begins_anew_leaves_nothing_of_the_earlier_one(tmp_path: Path, small) -> None:
    sweep(tmp_path, design(40))
    (tmp_path / "shards" / "notes.nc").write_text("mine", encoding="utf-8")
    work, columns = read_request(
        RIG, TRIAL, jn.sobol({"sprung.mass": "5 %"}, 10), RunSettings(), METRICS, None, None
    )
    with shards._lock(tmp_path), pytest.raises(OutputError, match="another process is working"):
        shards.keep_in_shards(work, columns, tmp_path, force=True)
    assert len(files(tmp_path)) == 6
    found = shards.keep_in_shards(work, columns, tmp_path, force=True)
    assert found.sizes["variant"] == found.attrs["variants"] == 10
    assert [name[:6] for name in files(tmp_path)] == ["000000", "000001", "notes."]


def test_a_zarr_group_that_begins_anew_leaves_what_is_not_its_own(tmp_path: Path, small) -> None:
    out = tmp_path / "out.zarr"
    sweep(out)
    (out / "notes").mkdir()
    (out / "notes" / "mine.txt").write_text("mine", encoding="utf-8")
    work, columns = read_request(
        RIG, TRIAL, jn.sobol({"sprung.mass": "5 %"}, 10), RunSettings(), METRICS[:1], None, None
    )
    found = shards.keep_in_shards(work, columns, out, force=True)
    assert found.sizes["variant"] == 10
    assert (out / "notes" / "mine.txt").read_text(encoding="utf-8") == "mine"
    assert not (out / "strut.damper.coefficient").exists()
    assert not (out / METRICS[1]).exists()


MEMORY = """
import resource, sys, tempfile
import jounce as jn
rig = jn.load("audi-a6-quarter-car")
trial = jn.Trial(road=jn.Iso8608(**{"class": "B"}, length="60 m", seed=1), speed="20 m/s", duration="0.2 s")
spreads = {"strut.damper.coefficient": "40 %", "sprung.mass": ["400 kg", "520 kg"]}
with tempfile.TemporaryDirectory() as out:
    many = jn.simulate_many(rig, trial, jn.sobol(spreads, int(sys.argv[1])), metrics=["rms sprung.az"], out=out)
assert many.attrs["side_by_side"] == int(sys.argv[1])
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="sizes of processes in kB")
def test_memory_hardly_grows_with_variants() -> None:
    """Four numbers of each variant are kept, twice while they are read; what a shard works with is that of any."""
    few, many = (
        int(
            subprocess.run(
                [sys.executable, "-c", MEMORY, str(count)], capture_output=True, check=True
            ).stdout
        )
        for count in (65_536, 524_288)
    )
    assert 1024 * (many - few) < 200 * (524_288 - 65_536)


def test_a_normal_distribution_that_strays_says_how_much_of_it_is_cut_off(
    tmp_path: Path, small
) -> None:
    stray = jn.sobol({"sprung.mass": {"mean": "300 kg", "sd": "200 kg"}}, 64, seed=1)
    found = sweep(tmp_path / "out", stray)
    below = int(np.sum(found["sprung.mass"].values <= 0.0))
    assert below == 4  # 64 times the normal distribution at -1.5: 4.3
    assert found.attrs["outside"] == below == int(np.sum(found["reason"].values != ""))
    (said,) = (one for one in summarise(found).findings if one.place == "spreads")
    assert said.value == pytest.approx(below / 64)
    assert "truncated" in said.message


def test_a_range_that_no_mass_can_have_runs_nothing(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match=r"sprung\.mass: the spread exceeds .* above 0 kg"):
        sweep(tmp_path / "out", jn.latin_hypercube({"sprung.mass": ["-1 kg", "2 kg"]}, 8))
    with pytest.raises(DescriptionError, match=r"trial\.speed: the spread exceeds"):
        sweep(tmp_path / "out", jn.sobol({"trial.speed": "150 %"}, 8))
    assert not (tmp_path / "out").exists()
