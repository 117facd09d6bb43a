"""Road files, the named roads of a campaign, and the shipped courses."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from jounce.core.description import read_toml
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.roads import ROADS, Crg, HalfSine, Table, Train, load_road, read_roads, road_library

FILES = Path(__file__).parents[2] / "files" / "road_crg"
A = {"kind": "half-sine", "height": "10 mm", "length": "60 mm", "start": "0.2 m"}


def from_text(folder: Path, text: str) -> dict:
    file = folder / "campaign.toml"
    file.write_text(text)
    table, content = read_toml(file)
    return read_roads(table["roads"], where=str(file), text=content, folder=folder)


def test_named_roads_in_any_order(tmp_path) -> None:
    roads = from_text(
        tmp_path,
        """
        [roads.B10]
        kind = "train"
        of = "A"
        count = 5
        pitch = "0.10 m"
        [roads.double]
        kind = "train"
        of = {kind = "train", of = "A", count = 2, pitch = "0.2 m"}
        count = 2
        pitch = "1 m"
        [roads.A]
        kind = "half-sine"
        height = "10 mm"
        length = "60 mm"
        start = "0.2 m"
        """,
    )
    assert list(roads) == ["B10", "double", "A"]
    assert roads["A"] == HalfSine(height=0.01, length=0.06, start=0.2)
    assert roads["B10"] == Train(of=roads["A"], count=5, pitch=0.1)
    assert roads["double"].end() == pytest.approx(0.2 + 1.0 + 0.2 + 0.06, abs=1e-12)


def test_files_are_found_from_the_folder_of_the_description(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir("/")
    (tmp_path / "profiles").mkdir()
    (tmp_path / "profiles" / "lane.csv").write_text("x [m],z [mm]\n0,0\n1,5\n2,0\n")
    shutil.copy(FILES / "halfround_4in.crg", tmp_path / "profiles")
    roads = from_text(
        tmp_path,
        """
        [roads.lane]
        kind = "table"
        file = "profiles/lane.csv"
        [roads.bar]
        kind = "crg"
        file = "profiles/halfround_4in.crg"
        [roads.lanes]
        kind = "train"
        of = {kind = "table", file = "profiles/lane.csv"}
        count = 3
        pitch = "2 m"
        """,
    )
    assert roads["lane"].height_at(1.0) == pytest.approx(0.005, abs=1e-15)
    assert roads["bar"].end() == pytest.approx(100.0, abs=1e-9)
    assert roads["lanes"].end() == 6.0


def test_load_road_takes_every_kind_of_file(tmp_path) -> None:
    road = tmp_path / "road.toml"
    road.write_text(
        'kind = "train"\nof = {kind = "half-sine", height = "10 mm", length = "60 mm"}\ncount = 5\npitch = 0.1\n'
    )
    assert load_road(road).end() == pytest.approx(0.46, abs=1e-12)
    road.write_text(
        'schema = "jounce.road/1"\nkind = "half-sine"\nheight = "10 mm"\nlength = "60 mm"\n'
    )
    assert load_road(str(road)) == HalfSine(height=0.01, length=0.06)
    (tmp_path / "lane.csv").write_text("x [m],z [mm]\n0,0\n1,5\n")
    assert isinstance(load_road(tmp_path / "lane.csv"), Table)
    assert isinstance(load_road(FILES / "halfround_4in.crg"), Crg)
    assert load_road("detrended_rms_course_1in") == Crg(
        file=road_library()["detrended_rms_course_1in"]
    )


def test_every_shipped_course_loads_and_has_source_and_licence() -> None:
    assert road_library()
    for name, file in road_library().items():
        assert load_road(name).end() > 0
        assert file.name in (file.parent / "SOURCE.md").read_text()
        assert (file.parent / "LICENSE.txt").is_file()


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            'kind = "half-sin"\n',
            r"road\.toml, line 1: kind: unknown kind of road 'half-sin'; allowed: .*Did you mean 'half-sine'\?",
        ),
        (
            'height = "10 mm"\n',
            r"road\.toml: the key 'kind' is missing; allowed: circular-segment, crg",
        ),
        ('kind = "half-sine"\nheight = "10 mm"\n', r"road\.toml: length: the key is missing"),
        (
            'kind = "half-sine"\nheight = "10 mm"\nlength = 0\n',
            r"road\.toml, line 3: length: out of range",
        ),
        (
            'kind = "train"\nof = "A"\ncount = 2\npitch = 1\n',
            r"road\.toml, line 2: of: a road file cannot refer to other roads",
        ),
        (
            'kind = "train"\nof = 3\ncount = 2\npitch = 1\n',
            r"road\.toml, line 2: of: not a road; found 3",
        ),
        ('kind = "train"\ncount = 2\npitch = 1\n', r"of: the key is missing"),
        (
            'schema = "jounce.rig/1"\nkind = "flat"\n',
            r'not a road file; found \'jounce\.rig/1\'; allowed: schema = "jounce\.road/1"',
        ),
        ('kind = "table"\nfile = "none.csv"\n', r"none\.csv: no such file"),
        ('kind = "table"\nfile = 3\n', r"road\.toml, line 2: file: "),
        ("kind = \n", "not valid TOML"),
        ("", "the file is empty"),
    ],
)
def test_road_files_with_mistakes(tmp_path, text, says) -> None:
    (tmp_path / "road.toml").write_text(text)
    with pytest.raises(JounceError, match=says):
        load_road(tmp_path / "road.toml")


def test_files_that_are_no_roads(tmp_path) -> None:
    with pytest.raises(
        DescriptionError,
        match=r"no such file, and no road.*Did you mean 'detrended_rms_course_1in'",
    ):
        load_road("detrended_rms_course_1inch")
    (tmp_path / "photo.png").write_bytes(b"\x89PNG")
    with pytest.raises(DescriptionError, match=r"not a road file; found '\.png'"):
        load_road(tmp_path / "photo.png")
    (tmp_path / "road.crg").write_text("nothing")
    with pytest.raises(RecordingError, match="not a readable OpenCRG file"):
        load_road(tmp_path / "road.crg")


@pytest.mark.parametrize(
    ("tables", "says"),
    [
        (
            {"bump": A, "B": {"kind": "train", "of": "bumb", "count": 2, "pitch": 1}},
            r"^roads\.B\.of: unknown road 'bumb'; allowed: B, bump\. Did you mean 'bump'\?$",
        ),
        (
            {"B": {"kind": "train", "of": "B", "count": 2, "pitch": 1}},
            r"^roads\.B\.of: the train contains itself: 'B' of 'B'\.",
        ),
        (
            {
                "B": {"kind": "train", "of": "C", "count": 2, "pitch": 1},
                "C": {
                    "kind": "train",
                    "of": {"kind": "train", "of": "B", "count": 1, "pitch": 1},
                    "count": 2,
                    "pitch": 9,
                },
            },
            r"the train contains itself: 'B' of 'C' of 'B'\.",
        ),
        ({"B": "half-sine"}, r"^roads\.B: not a road table; found 'half-sine'"),
        ({"B": {**A, "hight": 1}}, r"^roads\.B\.hight: unknown key"),
        (
            {"A": A, "B": {"kind": "train", "of": "A", "count": 5, "pitch": "50 mm"}},
            r"^roads\.B: the obstacles overlap",
        ),
        ({"B": {"kind": 3}}, r"^roads\.B\.kind: unknown kind of road '3'"),
    ],
)
def test_named_roads_with_mistakes(tables, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        read_roads(tables)


def test_mistakes_name_file_and_line(tmp_path) -> None:
    text = (
        '[roads.A]\nkind = "step"\nheight = "10 mm"\n[roads.B]\nkind = "step"\nheight = "ten mm"\n'
    )
    with pytest.raises(
        DescriptionError,
        match=r"campaign\.toml, line 6: roads\.B\.height: not a number with a unit",
    ):
        from_text(tmp_path, text)


def test_every_kind_is_registered_under_its_own_name() -> None:
    assert {name: kind.model_fields["kind"].default for name, kind in ROADS.items()} == {
        name: name for name in ROADS
    }
    assert len(ROADS) == 20
