"""Exudyn: rigid bodies with joints as constraints, generalised-alpha steps, tyre law in its compiled symbols.

The fastest tested settings are used: Tait-Bryan angles; trapezoidal (spectral radius 1) with modified Newton. Its
kinematic tree with loop constraints took three times as long a step, a full Newton twice as long.
"""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter
from typing import Any

import numpy as np
from mechanism_problem import DURATION, SAMPLES, Array, Case

UP = np.array(
    [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]
)  # turns x to z: a sliding mass slides along its x
HINGE = np.array(
    [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
)  # turns z to x: a generic joint turns about its z


class System:
    """The assembled system with the sensors of body and wheel; keeps objects alive that Exudyn only references."""

    def __init__(self, case: Case) -> None:
        import exudyn as exu
        import exudyn.itemInterface as items  # noqa: N813
        from exudyn.utilities import CreateSymbolicUserFunction

        self.exu, self.items, self.case = exu, items, case
        self.container = exu.SystemContainer()
        self.mbs = mbs = self.container.AddSystem()
        h, strut = case.points, case.model["strut"]
        self.centres: dict[int, Array] = {}
        chassis = self._chassis()
        lower, upper, upright = (self._body(name) for name in ("lower_arm", "upper_arm", "upright"))
        for arm, point in ((lower, "P_L"), (upper, "P_U")):
            ends = [
                self._marker(chassis, h[point], UP.T @ HINGE),
                self._marker(arm, h[point], HINGE),
            ]
            mbs.AddObject(
                items.GenericJoint(markerNumbers=ends, constrainedAxes=[1, 1, 1, 1, 1, 0])
            )
        for arm, point in ((lower, "BJ_L"), (upper, "BJ_U")):
            ends = [self._marker(arm, h[point]), self._marker(upright, h[point])]
            mbs.AddObject(items.SphericalJoint(markerNumbers=ends))
        ends = [self._marker(chassis, h["T_C"]), self._marker(upright, h["T_U"])]
        length = float(np.linalg.norm(h["T_U"] - h["T_C"]))
        mbs.AddObject(items.DistanceConstraint(markerNumbers=ends, distance=length))
        ends = [self._marker(chassis, h["S_C"]), self._marker(lower, h["S_A"])]
        law = {"stiffness": strut["k"], "damping": strut["c"], "referenceLength": strut["L0"]}
        mbs.AddObject(items.SpringDamper(markerNumbers=ends, **law))
        hub = self._marker(upright, h["W"])
        ends = [
            mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround()))),
            hub,
        ]
        tyre = mbs.AddObject(
            items.CartesianSpringDamper(markerNumbers=ends, stiffness=[0.0, 0.0, 1.0])
        )
        self.law = CreateSymbolicUserFunction(mbs, tyre_law(case), "springForceUserFunction", tyre)
        mbs.SetObjectParameter(tyre, "springForceUserFunction", self.law)
        kept, kind = {"storeInternal": True, "writeToFile": False}, exu.OutputVariableType
        node = items.SensorNode(nodeNumber=self.node, outputVariableType=kind.Coordinates, **kept)
        self.body = mbs.AddSensor(node)
        marker = items.SensorMarker(markerNumber=hub, outputVariableType=kind.Position, **kept)
        self.wheel = mbs.AddSensor(marker)
        mbs.Assemble()

    def _chassis(self) -> int:
        items, mass = self.items, self.case.model["bodies"]["chassis"]["mass"]
        start = {
            "referenceCoordinates": [0.0],
            "initialCoordinates": [0.0],
            "initialVelocities": [0.0],
        }
        self.node = self.mbs.AddNode(items.Node1D(**start))
        body = items.ObjectMass1D(mass=mass, nodeNumber=self.node, referenceRotation=UP.tolist())
        marker = self.mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=self.node, coordinate=0))
        self.mbs.AddLoad(
            items.LoadCoordinate(markerNumber=marker, load=-mass * self.case.model["gravity"])
        )
        self.chassis = self.mbs.AddObject(body)
        return self.chassis

    def _body(self, name: str) -> int:
        from exudyn.utilities import RigidBodyInertia

        mass, centre, tensor = self.case.inertia(name)
        number = self.mbs.CreateRigidBody(
            inertia=RigidBodyInertia(mass=mass, inertiaTensor=tensor, com=[0.0, 0.0, 0.0]),
            referencePosition=list(centre),
            gravity=[0.0, 0.0, -self.case.model["gravity"]],
            nodeType=self.exu.NodeType.RotationRxyz,
        )
        self.centres[number] = centre
        return number

    def _marker(self, body: int, point: Array, turned: Array | None = None) -> int:
        place = UP.T @ point if body == self.chassis else point - self.centres[body]
        frame = np.eye(4)
        frame[:3, :3] = np.eye(3) if turned is None else turned
        frame[:3, 3] = place
        return self.mbs.AddMarker(self.items.MarkerBodyRigid(bodyNumber=body, localHT=frame))


def tyre_law(case: Case) -> Callable[..., Any]:
    """Vertical force at the wheel centre; Exudyn turns it into its own compiled symbols."""
    import exudyn as exu

    symbolic = exu.symbolic
    height, wave, start = case.bump
    end, rate, radius = case.edges[1], case.model["tyre"]["k"], case.model["tyre"]["R0"]

    def force(_, t, itemNumber, displacement, velocity, stiffness, damping, offset):  # noqa: N803, ARG001, PLR0917
        zero, inside = symbolic.Real(0.0), symbolic.sin(wave * (t - start)) * height
        road = symbolic.IfThenElse(t > start, symbolic.IfThenElse(t < end, inside, zero), zero)
        push = rate * (radius + road - displacement[2])
        if case.unilateral:
            push = symbolic.max(push, zero)
        return symbolic.Vector([zero, zero, -1.0 * push])

    return force


def prepared(case: Case) -> Callable[[int], tuple[float, Array, Array]]:
    """``run(substeps) -> (seconds, zs, zu)``, with that many steps per millisecond."""
    import exudyn as exu

    def run(substeps: int) -> tuple[float, Array, Array]:
        system = System(case)
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = (SAMPLES - 1) * substeps
        settings.timeIntegration.endTime = DURATION
        settings.timeIntegration.verboseMode = 0
        settings.timeIntegration.generalizedAlpha.spectralRadius = 1.0
        settings.timeIntegration.newton.useModifiedNewton = True
        settings.timeIntegration.newton.relativeTolerance = 1e-9
        settings.timeIntegration.newton.absoluteTolerance = 1e-12
        settings.solution.file.write = False
        settings.solution.sensors.writePeriod = DURATION / (SAMPLES - 1)
        begin = perf_counter()
        system.mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
        seconds = perf_counter() - begin
        zs, zu = (system.mbs.GetSensorStoredData(sensor) for sensor in (system.body, system.wheel))
        return seconds, zs[:, 1], zu[:, 3] - case.points["W"][2]

    return run
