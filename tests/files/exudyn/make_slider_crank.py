"""A spatial slider-crank in Exudyn: ``python tests/files/exudyn/make_slider_crank.py`` writes ``slider_crank.npz``.

A crank on a skew axis, a connecting rod on a ball joint (crank) and a universal joint (slider), a slider on a guide
and a spring-damper from it to the ground; gravity, started from rest. All numbers are in ``MODEL`` (m, kg, s, N; places
and axes in ground axes at the start). Exudyn steps implicitly with second order, so runs with 1, 2 and 4 times as fine
steps are extrapolated; what the last extrapolation still changed is stored as ``change``. Takes about a minute.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

MODEL: dict[str, Any] = {
    "gravity": 9.81,
    "duration": 1.0,
    "output_step": 0.005,
    "crank_axis": (1.0, 0.2, 0.1),
    "crank_pivot": (0.0, 0.0, 0.0),
    "ball": (0.02, 0.03, 0.12),
    "slider_axis": (0.1, 1.0, 0.15),
    "cross": (0.05, 0.5, 0.08),
    "spring_ground": (0.2, 0.95, 0.3),
    "spring_slider": (0.06, 0.52, 0.12),
    "spring": {"rate": 400.0, "damping": 6.0, "free_length": 0.9},
    # mass, centre of mass, tensor elements xx yy zz xy xz yz
    "crank": (2.0, (0.01, 0.01, 0.05), (0.004, 0.003, 0.002, 0.0002, -0.0003, 0.0004)),
    "rod": (1.2, (0.035, 0.27, 0.1), (0.02, 0.001, 0.0205, 0.0005, 0.0002, -0.0006)),
    "slider": (3.0, (0.055, 0.51, 0.09), (0.005, 0.004, 0.006, 0.0, 0.0, 0.0)),
}


def cross_axes() -> tuple[np.ndarray, np.ndarray]:
    """Axes of the universal joint: on the slider and on the rod, at right angles to each other."""
    first = np.cross(MODEL["slider_axis"], (0.0, 0.0, 1.0))
    first = first / np.linalg.norm(first)
    second = np.cross(np.subtract(MODEL["cross"], MODEL["ball"]), first)
    return first, second / np.linalg.norm(second)


def frame(axis, first=None) -> np.ndarray:
    """Rotation whose z axis is ``axis``, or whose x and y axes are ``first`` and ``axis``."""
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    if first is not None:
        return np.column_stack([first, axis, np.cross(first, axis)])
    side = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    side = side / np.linalg.norm(side)
    return np.column_stack([side, np.cross(axis, side), axis])


def run(substeps: int) -> dict[str, np.ndarray]:
    """Simulate with that many steps per output step; the ball joint's force is that on the crank."""
    import exudyn as exu
    import exudyn.itemInterface as items  # noqa: N813
    from exudyn.utilities import RigidBodyInertia

    container = exu.SystemContainer()
    mbs = container.AddSystem()
    ground = mbs.AddObject(items.ObjectGround())
    centres, bodies = {ground: np.zeros(3)}, {}
    for name in ("crank", "rod", "slider"):
        mass, centre, (xx, yy, zz, xy, xz, yz) = MODEL[name]
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        bodies[name] = mbs.CreateRigidBody(
            inertia=RigidBodyInertia(mass=mass, inertiaTensor=tensor, com=[0.0, 0.0, 0.0]),
            referencePosition=list(centre),
            gravity=[0.0, 0.0, -MODEL["gravity"]],
            nodeType=exu.NodeType.RotationEulerParameters,
        )
        centres[bodies[name]] = np.array(centre)

    def marker(body: int, point, turned=None) -> int:
        place = np.eye(4)
        place[:3, :3] = np.eye(3) if turned is None else turned
        place[:3, 3] = np.asarray(point) - centres[body]
        return mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localHT=place))

    def joint(first: int, second: int, point, turned, axes: list[int]) -> None:
        ends = [marker(first, point, turned), marker(second, point, turned)]
        mbs.AddObject(items.GenericJoint(markerNumbers=ends, constrainedAxes=axes))

    joint(
        ground,
        bodies["crank"],
        MODEL["crank_pivot"],
        frame(MODEL["crank_axis"]),
        [1, 1, 1, 1, 1, 0],
    )
    joint(ground, bodies["slider"], MODEL["cross"], frame(MODEL["slider_axis"]), [1, 1, 0, 1, 1, 1])
    first, second = cross_axes()
    joint(bodies["slider"], bodies["rod"], MODEL["cross"], frame(second, first), [1, 1, 1, 0, 0, 1])
    ends = [marker(bodies["crank"], MODEL["ball"]), marker(bodies["rod"], MODEL["ball"])]
    ball = mbs.AddObject(items.SphericalJoint(markerNumbers=ends))
    law, ends = (
        MODEL["spring"],
        [marker(ground, MODEL["spring_ground"]), marker(bodies["slider"], MODEL["spring_slider"])],
    )
    spring = mbs.AddObject(
        items.SpringDamper(
            markerNumbers=ends,
            stiffness=law["rate"],
            damping=law["damping"],
            referenceLength=law["free_length"],
        )
    )
    sensors = _sensors(mbs, marker, bodies, ball, spring)
    _solve(mbs, substeps)
    rows = {name: np.array(mbs.GetSensorStoredData(sensor)) for name, sensor in sensors.items()}
    return {"time": rows["ball"][:, 0]} | {name: row[:, 1:] for name, row in rows.items()}


def _sensors(mbs, marker, bodies: dict, ball: int, spring: int) -> dict[str, int]:
    """Sensors by name."""
    import exudyn as exu
    import exudyn.itemInterface as items  # noqa: N813

    kept, kind = {"storeInternal": True, "writeToFile": False}, exu.OutputVariableType
    sensors = {
        name: mbs.AddSensor(
            items.SensorMarker(
                markerNumber=marker(bodies[body], point), outputVariableType=what, **kept
            )
        )
        for name, body, point, what in (
            ("ball", "crank", MODEL["ball"], kind.Position),
            ("ball_velocity", "crank", MODEL["ball"], kind.Velocity),
            ("cross", "slider", MODEL["cross"], kind.Position),
            ("rod", "rod", MODEL["rod"][1], kind.Position),
            ("rod_spin", "rod", MODEL["rod"][1], kind.AngularVelocity),
        )
    }
    for name, of, what in (
        ("ball_force", ball, kind.Force),
        ("spring_length", spring, kind.Distance),
    ):
        sensors[name] = mbs.AddSensor(
            items.SensorObject(objectNumber=of, outputVariableType=what, **kept)
        )
    return sensors


def _solve(mbs, substeps: int) -> None:
    """Run the assembled system by the generalised alpha method with a full Newton iteration."""
    import exudyn as exu

    mbs.Assemble()
    settings = exu.SimulationSettings()
    count = round(MODEL["duration"] / MODEL["output_step"])
    settings.timeIntegration.numberOfSteps = count * substeps
    settings.timeIntegration.endTime = MODEL["duration"]
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
    settings.timeIntegration.newton.useModifiedNewton = False
    settings.timeIntegration.newton.relativeTolerance = 1e-11
    settings.timeIntegration.newton.absoluteTolerance = 1e-13
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = MODEL["output_step"]
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)


def extrapolated(substeps: int) -> tuple[dict[str, np.ndarray], dict[str, float]]:
    """Values with the terms in step^2 and step^3 removed, and how much the last removal changed each."""
    one, two, four = (run(count) for count in (substeps, 2 * substeps, 4 * substeps))
    values, change = {"time": one["time"]}, {}
    for name in [name for name in one if name != "time"]:
        first, second = (4.0 * two[name] - one[name]) / 3.0, (4.0 * four[name] - two[name]) / 3.0
        values[name] = second + (second - first) / 7.0
        change[name] = float(
            np.abs(values[name] - second).max() / np.ptp(values[name], axis=0).max()
        )
    return values, change


if __name__ == "__main__":
    values, change = extrapolated(50)
    np.savez_compressed(
        Path(__file__).parent / "slider_crank.npz",
        **values,
        **{f"change of {name}": c for name, c in change.items()},
    )
