"""MuJoCo: Runge-Kutta steps in its own C loop; loops closed by its (soft) equality constraints, as stiff as they go.

The tyre is a position actuator between road and wheel centre (clamped to pushing if unilateral), the strut a spatial
tendon with spring and damper, the tie rod a tendon of fixed length. The half-sine is the swing of a very heavy mass on
a spring, so it is followed within the steps, too (inputs held over a step would make the method of second order); steps
land on its far edge.
"""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

import numpy as np
from mechanism_problem import DURATION, SAMPLES, Array, Case

HEAVY = 1e10  # kg


def description(case: Case, step: float) -> str:
    """The model as MJCF; violated constraints are pulled back at the rate of the steps."""
    h, model = case.points, case.model
    strut, tyre = model["strut"], model["tyre"]

    def text(values) -> str:
        return " ".join(repr(float(x)) for x in values)

    def inertial(name: str, origin: Array) -> str:
        mass, centre, i = case.inertia(name)
        six = (i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2])
        return f'<inertial pos="{text(centre - origin)}" mass="{mass}" fullinertia="{text(six)}"/>'

    soft = f'solref="{-(step**-2)!r} {-2.0 / step!r}" solimp="0.9999 0.9999 0.001"'
    push = f'forcelimited="true" forcerange="0 {1e9}"' if case.unilateral else ""
    rod = float(np.linalg.norm(h["T_U"] - h["T_C"]))
    return f"""<mujoco>
  <compiler autolimits="true" boundmass="0" boundinertia="0"/>
  <option timestep="{step!r}" gravity="0 0 {-model["gravity"]}" integrator="RK4" solver="Newton" tolerance="0"
          iterations="1" ls_tolerance="1e-12" jacobian="dense"><flag contact="disable"/></option>
  <worldbody>
    <body name="road" gravcomp="1">
      <joint name="road" type="slide" axis="0 0 1" stiffness="{HEAVY * case.bump[1] ** 2!r}"/>
      <inertial pos="0 0 0" mass="{HEAVY}" diaginertia="1 1 1"/> <site name="road"/>
    </body>
    <body name="chassis">
      <joint name="heave" type="slide" axis="0 0 1"/>
      <inertial pos="0 0 0" mass="{model["bodies"]["chassis"]["mass"]}" diaginertia="1 1 1"/>
      <site name="strut top" pos="{text(h["S_C"])}"/> <site name="rod inner" pos="{text(h["T_C"])}"/>
      <body name="lower" pos="{text(h["P_L"])}">
        <joint type="hinge" axis="1 0 0"/> {inertial("lower_arm", h["P_L"])}
        <site name="strut bottom" pos="{text(h["S_A"] - h["P_L"])}"/>
        <body name="upright" pos="{text(h["BJ_L"] - h["P_L"])}">
          <joint type="ball"/> {inertial("upright", h["BJ_L"])}
          <site name="rod outer" pos="{text(h["T_U"] - h["BJ_L"])}"/>
          <site name="hub" pos="{text(h["W"] - h["BJ_L"])}"/>
        </body>
      </body>
      <body name="upper" pos="{text(h["P_U"])}">
        <joint type="hinge" axis="1 0 0"/> {inertial("upper_arm", h["P_U"])}
      </body>
    </body>
  </worldbody>
  <tendon>
    <spatial name="strut" stiffness="{strut["k"]}" damping="{strut["c"]}" springlength="{strut["L0"]!r}">
      <site site="strut top"/> <site site="strut bottom"/></spatial>
    <spatial name="rod"><site site="rod inner"/> <site site="rod outer"/></spatial>
  </tendon>
  <equality>
    <connect body1="upright" body2="upper" anchor="{text(h["BJ_U"] - h["BJ_L"])}" {soft}/>
    <tendon tendon1="rod" polycoef="0 0 0 0 0" {soft}/> <!-- length as at design: {rod!r} -->
  </equality>
  <actuator>
    <general name="tyre" site="hub" refsite="road" gear="0 0 1 0 0 0" gaintype="fixed" gainprm="0"
             biastype="affine" biasprm="{tyre["k"] * tyre["R0"]!r} {-tyre["k"]} 0" {push}/>
  </actuator>
  <sensor> <jointpos joint="heave"/> <framepos objtype="site" objname="hub"/> </sensor>
</mujoco>"""


def prepared(case: Case) -> Callable[[int], tuple[float, Array, Array]]:
    """``run(substeps) -> (seconds, zs, zu)``, with that many steps per millisecond."""
    import mujoco
    from mujoco import rollout

    full = mujoco.mjtState.mjSTATE_FULLPHYSICS

    def run(substeps: int) -> tuple[float, Array, Array]:
        step = DURATION / (SAMPLES - 1) / substeps
        model = mujoco.MjModel.from_xml_string(description(case, step))
        data, none = mujoco.MjData(model), np.zeros((1, 1, model.nu))
        state = np.empty(mujoco.mj_stateSize(model, full))
        begin = perf_counter()

        def advance(count: int, length: float, swing: float | None = None) -> Array:
            """Sensors (body, wheel, ...) before each step; ``swing`` is a new velocity of the road."""
            if swing is not None:
                data.qpos[0], data.qvel[0] = 0.0, swing
            model.opt.timestep = length
            mujoco.mj_getState(model, data, state, full)
            after, sensors = rollout.rollout(
                model, data, state[None], np.repeat(none, count, axis=1), nstep=count
            )
            mujoco.mj_setState(model, data, after[0, -1], full)
            return sensors[0]

        height, wave, start = case.bump
        edge = case.edges[1]
        first, last = round(start / step), int(edge / step)
        rows = [
            advance(first, step),
            advance(last - first, step, height * wave),
            advance(1, edge - last * step),
        ]
        advance(1, (last + 1) * step - edge, 0.0)  # its sensors are those of the edge
        rows.append(advance((SAMPLES - 1) * substeps - last, step))
        z = np.concatenate(rows)[::substeps]
        seconds = perf_counter() - begin
        return seconds, z[:, 0], z[:, 3] - case.points["W"][2]

    return run
