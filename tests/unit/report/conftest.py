"""A small campaign, made with jounce itself, once for all tests of the report."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.campaign.result import CampaignResult
from jounce.campaign.run import run_campaign
from jounce.identify.free_response import DecayParameters, decay_response
from jounce.recordings import recording, write_recording

RIG = """schema = "jounce.rig/1"
model = "quarter-car"
source = "made up"
[sprung]
mass = "16 kg"
[unsprung]
mass = "5 kg"
[strut]
angle = "26 deg"
spring = {rate = "22.73 N/mm"}   # as <described> & checked
damper = {coefficient = "150 N*s/m"}
[tyre]
stiffness = "138468 N/m"
"""
CAMPAIGN = """schema = "jounce.campaign/1"
title = "Tests <b>& more</b>"
synthetic = "Made by a test."
rig = "rig.toml"
[bench.spring]
files = ["spring_*.csv"]
[bench.tyre."0.31 MPa"]
files = ["tyre_*.csv"]
discard_below = "2 mm"
[bench.decay]
files = ["decay_*.csv"]
[roads.A]
kind = "half-sine"
height = "5 mm"
length = "60 mm"
start = "0.2 m"
[roads.B]
kind = "train"
of = "A"
count = 3
pitch = "0.1 m"
[[trial]]
number = 1
speed = "1.95 m/s"
road = "A"
recording = "1.csv"
use = "fit"
[[trial]]
number = 2
speed = "2.5 m/s"
road = "B"
recording = "2.csv"
[[trial]]
number = 3
speed = "3 m/s"
road = "A"
recording = "3.csv"
[[update]]
name = "Strategy A/1"
free = {"strut.spring.rate" = "10 %", "strut.damper.coefficient" = "30 %"}
method = "bfgs"
trials = [1]
[[update]]
name = "strategy a 1"
start_from = "Strategy A/1"
free = {"tyre.stiffness" = "2 %"}
method = "bfgs"
trials = "fit"
"""


def write_inputs(folder: Path) -> None:
    """Bench files and recordings of a rig that differs from the described one."""
    random = np.random.default_rng(3)
    x = np.linspace(0.0, 0.012, 40)
    for k in range(3):
        for name, rate in (("spring", 22500.0), ("tyre", 130000.0)):
            force = rate * (1.0 + 0.004 * k) * x + 0.05 * random.standard_normal(len(x))
            rows = "".join(f"{1e3 * a:.5f}, {b:.4f}\n" for a, b in zip(x, force, strict=True))
            (folder / f"{name}_{k}.csv").write_text(
                f"displacement [mm], force [N]\n{rows}", encoding="utf-8"
            )
    time = np.arange(0.0, 1.5, 2e-3)
    for k in range(2):
        parameters = DecayParameters(32.0, 0.10, 0.3e-3, -8e-3, 0.2, 0.015 + 0.002 * k)
        record = decay_response(time, parameters, "displacement") + 1e-5 * random.standard_normal(
            len(time)
        )
        write_recording(recording(time, {"sprung.z": (record, "m", "")}), folder / f"decay_{k}.csv")
    described = jn.load(folder / "rig.toml")
    rig = described.with_changes({"strut.damper.coefficient": 165.0, "tyre.stiffness": 125000.0})
    one = jn.HalfSine(height="5 mm", length="60 mm", start="0.2 m")
    train = jn.Train(of=one, count=3, pitch="0.1 m")
    for number, road, speed in ((1, one, 1.95), (2, train, 2.5), (3, one, 3.0)):
        run = jn.simulate(rig, jn.Trial(road=road, speed=speed, duration="1 s"))
        noisy = {
            name: (
                run[name].to_numpy() + 0.1 * random.standard_normal(run.sizes["time"]),
                "m/s^2",
                "",
            )
            for name in ("sprung.az", "unsprung.az")
        }
        write_recording(recording(run["time"].to_numpy(), noisy), folder / f"{number}.csv")


@pytest.fixture(scope="session")
def campaign_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("campaign")
    (folder / "rig.toml").write_text(RIG, encoding="utf-8")
    (folder / "campaign.toml").write_text(CAMPAIGN, encoding="utf-8")
    write_inputs(folder)
    return folder


@pytest.fixture(scope="session")
def result(campaign_folder: Path) -> CampaignResult:
    return run_campaign(campaign_folder / "campaign.toml")


@pytest.fixture(scope="session")
def damaged(campaign_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> CampaignResult:
    """The same without a usable tyre bench, third recording and second update, and not synthetic."""
    import shutil

    folder = tmp_path_factory.mktemp("damaged") / "campaign"
    shutil.copytree(campaign_folder, folder)
    (folder / "3.csv").write_text("time [s], sprung.az [m/s^2]\n0, nan\n", encoding="utf-8")
    (folder / "tyre_0.csv").write_text("displacement [mm]\n1\n2\n", encoding="utf-8")
    text = CAMPAIGN.replace('synthetic = "Made by a test."\n', "").replace(
        'trials = "fit"', "trials = [3]"
    )
    (folder / "campaign.toml").write_text(text, encoding="utf-8")
    return run_campaign(folder / "campaign.toml")


@pytest.fixture(scope="session")
def written(result: CampaignResult, tmp_path_factory: pytest.TempPathFactory) -> Path:
    from jounce.report import write_campaign

    out = tmp_path_factory.mktemp("written") / "report"
    write_campaign(result, out, figures=("svg", "png"))
    return out
