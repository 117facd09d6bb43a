"""Sweeps of solid axles and twist beams: closed forms of guides, exact slopes, attitudes of the body, refusals."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.parts import SolidAxle, TwistBeam

POINTS = {
    "wheel_centre": [0.0, 0.75, 0.3],
    "strut_bottom": [0.0, 0.5, 0.3],
    "strut_top": [0.0, 0.5, 0.7],
    "lower_link_axle": [0.0, 0.5, 0.2],
    "lower_link_body": [0.5, 0.5, 0.2],
    "upper_link_axle": [0.0, 0.0, 0.4],
    "upper_link_body": [0.5, 0.0, 0.4],
}
PANHARD = {"panhard_axle": [-0.1, 0.55, 0.26], "panhard_body": [-0.1, -0.45, 0.34]}
WATT = {
    "watt_pivot": [-0.1, 0.0, 0.33],
    "watt_upper_axle": [-0.1, 0.0, 0.39],
    "watt_upper_body": [-0.1, 0.5, 0.39],
    "watt_lower_axle": [-0.1, 0.0, 0.27],
    "watt_lower_body": [-0.1, -0.5, 0.27],
}
CAR = jn.AxleLayout(axle="rear", wheelbase="2.6 m", centre_of_mass_height="0.55 m", brake_share=0.4)


def solid(guide: dict[str, list[float]], **points: list[float]) -> SolidAxle:
    return SolidAxle.from_table(
        {
            "schema": "jounce.rig/1",
            "model": "solid-axle",
            "hardpoints": POINTS | guide | points,
            "wheel": {"radius": 0.3},
            "strut": {"spring": {"rate": 3e4, "preload": 3e3}, "damper": {"coefficient": 1e3}},
        }
    )


def ideal_beam(**changes: object) -> TwistBeam:
    ideal = {"bushings": {}, "wheel.toe": 0.0, "wheel.camber": 0.0}
    return jn.load("twist-beam").with_changes(ideal | changes)  # type: ignore[return-value]


def at_design(rig: jn.Rig, **options: object) -> xr.Dataset:
    return jn.sweep_travel(rig, [0.0], **options).isel(wheel_travel=0)  # type: ignore[arg-type]


# closed forms ---------------------------------------------------------------------------------------------------------


def test_the_roll_centre_is_where_the_panhard_rod_crosses_the_centre_plane() -> None:
    start, end = (np.array(point) for point in PANHARD.values())
    height = start[2] - start[1] * (end - start)[2] / (end - start)[1]
    assert height == pytest.approx(0.304)
    assert float(at_design(solid(PANHARD))["roll_centre_height"]) == pytest.approx(
        height, abs=1e-12
    )


def test_the_panhard_rod_shifts_the_axle_on_its_circle() -> None:
    """The rod keeps its length, and so do equal parallel links, which only shift the axle."""
    travel = np.linspace(-0.07, 0.07, 15)
    sweep = jn.sweep_travel(solid(PANHARD), travel)
    start, end = (np.array(point) for point in PANHARD.values())
    rod, y = end - start, np.zeros_like(travel)
    for _ in range(40):  # links and rod share both shifts
        x = 0.5 - np.sqrt(0.25 - travel**2 - y**2)
        y = rod[1] + np.sqrt(rod @ rod - x**2 - (rod[2] - travel) ** 2)
    assert sweep["longitudinal_shift"].values == pytest.approx(x, abs=1e-11)
    assert sweep["lateral_shift"].values == pytest.approx(y, abs=1e-11)
    assert sweep["axle_steer"].values == pytest.approx(0.0, abs=1e-11)


def test_a_watt_linkage_guides_its_pivot_on_a_straight_line() -> None:
    sweep = jn.sweep_travel(solid(WATT), "-60 mm:60 mm:10 mm")
    assert np.abs(sweep["lateral_shift"]).max() < 1e-3 * 0.06
    assert float(at_design(solid(WATT))["roll_centre_height"]) == pytest.approx(0.33, abs=1e-12)
    rod = jn.sweep_travel(solid(PANHARD), "-60 mm:60 mm:10 mm")
    assert np.ptp(rod["lateral_shift"].values) > 100.0 * np.ptp(sweep["lateral_shift"].values)


@pytest.mark.parametrize("rise", [0.04, -0.06])
def test_parallel_links_steer_the_axle_by_their_slope(rise: float) -> None:
    """The axle rolls about an axis along its links: the roll steer is their slope, against the roll."""
    links = {"lower_link_body": [0.5, 0.5, 0.2 + rise], "upper_link_body": [0.5, 0.0, 0.4 + rise]}
    guide = {"panhard_axle": [0.0, 0.55, 0.3], "panhard_body": [0.0, -0.55, 0.3]}
    row = at_design(solid(guide, **links), vehicle=CAR)
    assert float(row["roll_axis_inclination"]) == pytest.approx(np.arctan(rise / 0.5), abs=1e-12)
    assert float(row["roll_steer"]) == pytest.approx(-rise / 0.5, abs=1e-12)
    assert float(row["left.roll_camber"]) == pytest.approx(1.0, abs=1e-12)
    assert float(row["anti_squat"]) == pytest.approx(2.6 / 0.55 * rise / 0.5, rel=1e-11)


def test_anti_squat_follows_from_the_side_view_instant_centre() -> None:
    """Its tangent from the contact point: the lines of the links meet at x, z."""
    links = {"lower_link_body": [0.5, 0.5, 0.24], "upper_link_body": [0.5, 0.0, 0.36]}
    guide = {"panhard_axle": [0.0, 0.55, 0.3], "panhard_body": [0.0, -0.55, 0.3]}
    x = (0.4 - 0.2) / (0.08 + 0.08)  # 0.2 + 0.08 x = 0.4 - 0.08 x
    z = 0.2 + 0.08 * x
    row = at_design(solid(guide, **links), vehicle=CAR)
    assert float(row["anti_squat"]) == pytest.approx(2.6 / 0.55 * z / x, rel=1e-11)
    assert float(row["anti_lift"]) == pytest.approx(0.4 * 2.6 / 0.55 * z / x, rel=1e-11)


@pytest.mark.parametrize("height", [0.25, 0.33, 0.4])
def test_a_twist_beam_rolls_about_the_lines_from_its_pivots_to_the_shear_centre(
    height: float,
) -> None:
    rig = ideal_beam(**{"hardpoints.shear_centre[2]": height})
    points = rig.hardpoints
    pivot, wheel = np.array(points.pivot), np.array(points.wheel_centre)
    turn = np.array(points.shear_centre) - pivot
    patch = np.cross(turn, wheel - [0.0, 0.0, rig.wheel.radius] - pivot)
    road = patch[2] / wheel[1]  # turn of the road under both wheels
    row = at_design(rig)
    assert float(row["roll_centre_height"]) == pytest.approx(patch[1] / road, abs=1e-11)
    assert float(row["roll_steer"]) == pytest.approx(-turn[2] / road, abs=1e-11)
    assert float(row["left.roll_camber"]) == pytest.approx(turn[0] / road, abs=1e-11)


def test_a_twist_beam_swings_about_its_pivots() -> None:
    rig = ideal_beam()
    points = rig.hardpoints
    pivot, wheel = np.array(points.pivot), np.array(points.wheel_centre)
    arm = np.hypot(*(wheel - pivot)[[0, 2]])
    travel = np.linspace(-0.06, 0.06, 7)
    sweep = jn.sweep_travel(rig, travel)
    z = wheel[2] - pivot[2] + travel
    x = pivot[0] - np.sqrt(arm**2 - z**2)
    assert sweep["longitudinal_shift"].values == pytest.approx(x - wheel[0], abs=1e-11)
    assert sweep["left.camber"].values == pytest.approx(0.0, abs=1e-11)


# agreement ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "rig", [solid(PANHARD), solid(WATT), ideal_beam()], ids=["rod", "watt", "beam"]
)
@pytest.mark.parametrize("travel", [-0.05, 0.0, 0.05])
def test_roll_centre_and_anti_effects_are_those_of_forces_on_the_rig(
    rig: SolidAxle | TwistBeam, travel: float
) -> None:
    changes: dict[str, object] = {"strut.spring.rate": 1.0, "strut.spring.preload": 0.0}
    if isinstance(rig, TwistBeam):
        changes |= {"strut.bump_stop": None, "beam.torsional_stiffness": 1e-3}
    soft = rig.with_changes(changes)  # then the links carry all that the wheel loads change
    row = jn.sweep_travel(soft, [travel]).isel(wheel_travel=0)
    found = jn.kc_centres(soft, travel=travel).sel(source="forces")
    assert float(found["roll_centre_height"]) == pytest.approx(
        float(row["roll_centre_height"]), abs=2e-7
    )
    angle = np.arctan(float(row["left.contact_patch_recession"]))
    assert float(found["braking"]) == pytest.approx(angle, abs=2e-7)


@pytest.mark.parametrize("rig", [solid(PANHARD), jn.load("solid-axle"), jn.load("twist-beam")])
def test_slopes_are_those_of_the_curves(rig: SolidAxle | TwistBeam) -> None:
    step = 1e-4
    travel = jn.sweep_travel(rig, [0.02 - step, 0.02, 0.02 + step])
    roll = jn.sweep_roll(rig, [0.02 - step, 0.02, 0.02 + step])
    pairs = (
        (travel, "left.camber", "left.camber_gain", 1.0),
        (travel, "right.steer", "right.bump_steer", 1.0),
        (travel, "left.spring_length", "left.motion_ratio", -1.0),
        (travel, "left.half_track_change", "left.half_track_gradient", 1.0),
        (roll, "left.steer", "left.roll_steer", 1.0),
        (roll, "right.camber", "right.roll_camber", 1.0),
        (roll, "axle_steer", "roll_steer", 1.0),
    )
    for sweep, value, slope, sign in pairs:
        change = sign * np.diff(sweep[value].values[[0, 2]])[0] / (2.0 * step)
        assert float(sweep[slope][1]) == pytest.approx(change, abs=1e-7), slope


def test_forces_are_those_of_springs_and_beam() -> None:
    row = jn.sweep_travel(ideal_beam(), [-0.02, 0.0, 0.02])
    force = 3200.0 + 24e3 * (row["left.spring_length"][1] - row["left.spring_length"])
    assert row["left.wheel_force"].values == pytest.approx(
        (force * row["left.motion_ratio"]).values, rel=1e-10
    )
    change = np.diff(row["left.wheel_force"].values[[0, 2]])[0] / 0.04
    assert float(row["left.wheel_rate"][1]) == pytest.approx(change, rel=2e-3)
    assert (row["left.wheel_rate_roll"] > 5.0 * row["left.wheel_rate"]).all()  # the beam twists


def test_an_attitude_gives_its_travels_back() -> None:
    rig = solid(PANHARD)
    placed = jn.sweep_axle(rig, heave=["-10 mm", "5 mm"], roll=["2 deg", "-1 deg"], pitch="0.5 deg")
    pair = {f"{side}_travel": placed[f"{side}.wheel_travel"].values for side in ("left", "right")}
    back = jn.sweep_axle(rig, pitch="0.5 deg", **pair)
    for name in ("heave", "roll_angle", "track", "roll_centre_height", "left.steer_to_ground"):
        assert back[name].values == pytest.approx(placed[name].values, abs=1e-10), name


def test_one_wheel_moves_the_other_with_a_solid_axle() -> None:
    rig = solid(PANHARD)
    one = jn.sweep_axle(rig, left_travel="0 mm:50 mm:10 mm")
    lean = np.arctan(one["left.wheel_travel"] / 1.5)
    assert one["axle_roll"].values == pytest.approx(lean.values, abs=2e-4)
    assert one["right.camber"].values == pytest.approx(one["axle_roll"].values, abs=1e-3)
    assert one["left.camber_to_ground"].values == pytest.approx(0.0, abs=1e-12)


def test_a_whole_sweep_of_a_solid_axle_stands_upright_on_the_road() -> None:
    roll = jn.sweep_roll(solid(WATT), "-4 deg:4 deg:1 deg")
    assert roll["left.camber_to_ground"].values == pytest.approx(0.0, abs=1e-12)
    assert roll["left.wheel_travel"].values == pytest.approx(-roll["right.wheel_travel"].values)


# ends, findings and refusals ------------------------------------------------------------------------------------------


def test_a_sweep_beyond_the_links_keeps_the_poses_before() -> None:
    sweep = jn.sweep_travel(solid(PANHARD), "-100 mm:600 mm:50 mm")
    assert sweep.attrs["status"] == "end_of_travel"
    assert 8 < sweep.sizes["wheel_travel"] < 15
    assert "reaches the end of its travel at wheel travel" in sweep.attrs["stopped"]
    pairs = jn.sweep_axle(
        solid(PANHARD), left_travel=[0.0, 0.9, 0.02], right_travel=[0.0, 0.9, 0.02]
    )
    assert np.isfinite(pairs["track"].values).tolist() == [True, False, True]


@pytest.mark.parametrize("rig", [solid(PANHARD), jn.load("twist-beam")], ids=["rod", "beam"])
def test_poses_that_are_lost_on_the_way_to_the_road_are_reported(
    rig: SolidAxle | TwistBeam,
) -> None:
    roll = jn.sweep_roll(rig, [0.0, 0.4, 0.8, 1.1])
    assert roll.sizes["roll_angle"] < 4
    assert roll.attrs["status"] == "end_of_travel"
    assert "reaches the end of its travel" in roll.attrs["stopped"]
    placed = jn.sweep_axle(rig, heave=[0.0, -0.9, 0.02])
    assert np.isfinite(placed["track"].values).tolist() == [True, False, True]
    assert placed.attrs["status"] == "end_of_travel"
    assert "reaches the end of its travel" in placed.attrs["stopped"]


def test_an_attitude_in_which_no_pair_of_travels_touches_the_road_is_left_out() -> None:
    attitude = {"heave": [-0.2135, 0.0], "roll": [0.2914, 0.0], "pitch": [0.2718, 0.0]}
    placed = jn.sweep_axle(solid(PANHARD), **attitude)  # type: ignore[arg-type]
    assert np.isfinite(placed["left.camber"].values).tolist() == [False, True]
    assert placed.attrs["stopped"].count("reaches the end of its travel") == 1


def test_a_bar_does_not_bend_an_axle_on_its_bushings() -> None:
    bare = jn.load("solid-axle")
    points = {"arb_pivot": [0.2, 0.4, 0.3], "arb_arm_end": [0.0, 0.45, 0.28]}
    points["arb_link_end"] = [0.0, 0.45, 0.2]
    changes = {f"hardpoints.{name}": point for name, point in points.items()}
    barred = bare.with_changes({**changes, "anti_roll_bar": {"stiffness": 5e4}})
    sweeps = [jn.sweep_roll(rig, [0.05]) for rig in (bare, barred)]
    for name in ("lateral_shift", "axle_steer", "roll_centre_height"):
        assert float(sweeps[0][name][0]) == pytest.approx(float(sweeps[1][name][0]), abs=1e-12)


def test_a_solid_axle_rolls_as_far_as_its_links_reach() -> None:
    """Its wheels are on one line: they travel by half of the track times the sine of the roll."""
    roll = jn.sweep_roll(solid(WATT), [0.0, 0.6])
    assert float(roll["right.wheel_travel"][1]) == pytest.approx(0.75 * np.sin(0.6), rel=1e-2)


def test_an_axle_that_binds_moves_on_its_bushings_and_says_so() -> None:
    sweep = jn.sweep_roll(jn.load("solid-axle"), "-2 deg:2 deg:1 deg")
    assert "bushings yield" in sweep.attrs["findings"]
    assert "left.wheel_rate" not in sweep
    assert "findings" not in jn.sweep_roll(jn.load("twist-beam"), [0.0]).attrs


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda rig: jn.sweep_travel(rig, [0.0], 0.01), "no steering rack"),
        (lambda rig: jn.sweep_roll(rig, [0.0], 0.01), "no steering rack"),
        (lambda rig: jn.sweep_axle(rig, handwheel=0.1), "no steering rack"),
        (lambda rig: jn.sweep_axle(rig, right=rig, roll=0.0), "has both wheels"),
        (lambda rig: jn.sweep_travel(rig, [0.0], points=True), "hardpoints are not available"),
        (lambda rig: jn.sweep_rack(rig, [0.0]), "is not a corner.*sweep_travel"),
        (lambda rig: jn.sweep_roll(rig, [1.3]), "too steep"),
    ],
)
def test_what_an_axle_has_not_is_refused(call, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        call(jn.load("twist-beam"))


def test_parts_of_both_sides_lie_beside_the_centre_plane() -> None:
    middle = {"lower_link_axle": [0.0, 0.0, 0.2], "lower_link_body": [0.5, 0.0, 0.2]}
    with pytest.raises(DescriptionError, match=r"lower_link_axle: lies in the centre plane"):
        solid(PANHARD, **middle)
    with pytest.raises(DescriptionError, match=r"pivot: lies in the centre plane"):
        ideal_beam(**{"hardpoints.pivot": [0.4, 0.0, 0.31]})


def test_links_that_coincide_are_refused() -> None:
    lower = {name.replace("lower", "upper"): POINTS[name] for name in POINTS if "lower" in name}
    with pytest.raises(DescriptionError, match=r"twice in the same way.*2 equations"):
        jn.sweep_travel(solid(PANHARD, **lower), [0.0])


def test_command_figures_and_page_take_dependent_axles(tmp_path) -> None:
    from jounce.plots.kinematics import write_swept
    from jounce.report.swept import swept_page

    found = jn.sweep_kinematics("twist-beam", "-40 mm:40 mm:20 mm", vehicle=CAR)
    assert found.to_dict()["anti_squat"]["units"] == "1"
    assert {file.name for file in write_swept(found, tmp_path)} >= {"wheel.png", "centres.png"}
    titles = [section.title for section in swept_page(found, title="Rear axle").sections]
    assert titles == ["Extremes", "Curves", "Mechanism", "Poses"]
    rolled = jn.sweep_kinematics("solid-axle", roll="-2 deg:2 deg:1 deg")
    assert "bushings yield" in rolled.remark


def test_hardpoints_of_an_axle_are_written(tmp_path) -> None:
    table = jn.write_hardpoints(jn.load("solid-axle"), tmp_path / "points.csv").read_text()
    assert "panhard_body,-100,-610,350" in table
    drawing = jn.write_hardpoints(jn.load("twist-beam"), tmp_path / "points.dxf").read_text()
    assert drawing.count("LINE\n") == 2  # half and strut
    assert "shear_centre" in drawing


# variants -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["twist-beam", "solid-axle"])
def test_variants_are_sweeps_of_changed_axles(name: str) -> None:
    base, heights = jn.load(name), [0.28, 0.3]
    path = "hardpoints.wheel_centre[2]"
    over_roll = jn.sweep_variants(base, {path: heights}, roll="-2 deg:2 deg:2 deg")
    bumped = jn.sweep_variants(base, {path: heights}, [0.0, 0.03], quantities=["left.toe"])
    assert list(bumped.data_vars) == ["left.toe", "reached"]
    for k, height in enumerate(heights):
        rig = base.with_changes({path: height})
        rolled = jn.sweep_roll(rig, "-2 deg:2 deg:2 deg")
        for row in ("roll_steer", "roll_centre_height", "right.wheel_travel"):
            assert over_roll[row][k].values == pytest.approx(rolled[row].values, abs=1e-12)
        toe = jn.sweep_travel(rig, [0.0, 0.03])["left.toe"].values
        assert bumped["left.toe"][k].values == pytest.approx(toe, abs=1e-12)


def test_a_variant_that_ends_early_has_gaps() -> None:
    lengths = {"hardpoints.lower_link_body[0]": [0.5, 0.02]}
    swept = jn.sweep_variants(solid(PANHARD), lengths, [0.0, 0.04])
    assert swept["reached"].values.tolist() == [2, 1]
    assert np.isfinite(swept["left.toe"].values).tolist() == [[True, True], [True, False]]


@pytest.mark.parametrize(
    ("changes", "options", "message"),
    [
        ({"tyre.stiffness": [2e5]}, {}, "no effect on the kinematics"),
        ({"hardpoints.pivot[2]": [0.3]}, {"rack": 0.01}, "no steering rack"),
        ({"hardpoints.pivot[2]": [0.3]}, {"quantities": ["camber"]}, "no such quantity"),
    ],
)
def test_variants_refuse_what_an_axle_has_not(changes, options, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        jn.sweep_variants(jn.load("twist-beam"), changes, **options)
