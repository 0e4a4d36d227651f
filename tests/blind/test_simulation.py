"""The package's simulation against MuJoCo, which nobody here wrote: its step is halved until the two agree."""

import generate
import gyradius
import mujoco
import numpy as np
import pytest

MODEL = """
<mujoco>
  <compiler autolimits="true" balanceinertia="false" boundinertia="0" boundmass="0"/>
  <option timestep="{step}" gravity="0 0 -{gravity}" integrator="RK4" solver="Newton" iterations="200"
          tolerance="1e-14"><flag contact="disable"/></option>
  <worldbody>
    <site name="a0" pos="{a0}"/><site name="a1" pos="{a1}"/>
    <body name="hull" pos="{position}" quat="{quaternion}">
      <freejoint/>
      <inertial pos="{cm}" mass="{mass}" fullinertia="{inertia}"/>
      <site name="p0" pos="{p0}"/><site name="p1" pos="{p1}"/>
      {inside}
    </body>
  </worldbody>
  <tendon>
    <spatial name="t0"><site site="a0"/><site site="p0"/></spatial>
    <spatial name="t1"><site site="a1"/><site site="p1"/></spatial>
  </tendon>
  <equality>
    <tendon tendon1="t0" polycoef="0 0 0 0 0" solref="{stiff} 1" solimp="0.9999 0.9999 0.001"/>
    <tendon tendon1="t1" polycoef="0 0 0 0 0" solref="{stiff} 1" solimp="0.9999 0.9999 0.001"/>
  </equality>
</mujoco>
"""
SLIDER = """
      <body name="slider" pos="{place}">
        <joint type="slide" axis="{along}" stiffness="{stiffness}" damping="{damping}"/>
        <inertial pos="0 0 0" mass="{mass}" diaginertia="1e-9 1e-9 1e-9"/>
      </body>
"""
DURATION_S, EVERY_S = 8.0, 0.02


def words(values) -> str:
    return " ".join(f"{x:.17g}" for x in np.ravel(values))


def point_inertia(mass: float, arm: np.ndarray) -> np.ndarray:
    return mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))


def drawn(seed: int, effects: list[dict]) -> dict:
    """A model hull, its mass off the centre, moved in every way at once."""
    rng = np.random.default_rng(seed)
    between = lambda low, high: float(rng.uniform(low, high))
    truth = {
        "k_yaw_m": between(0.28, 0.33), "k_pitch_m": between(0.33, 0.37), "k_roll_m": between(0.27, 0.3),
        "cm_depth_m": between(0.2, 0.3), "cm_x_m": between(-0.02, 0.02), "cm_y_m": between(-0.03, 0.03),
        "inertia_xz_kg_m2": between(-0.05, 0.05), "inertia_xy_kg_m2": between(-0.03, 0.03),
        "along_m": between(-0.08, 0.08), "across_m": between(-0.06, 0.06), "yaw_rad": between(-0.15, 0.15),
        "turn_rad": between(-0.06, 0.06), "along_m_s": between(-0.1, 0.1), "yaw_rad_s": between(-0.2, 0.2),
    }  # fmt: skip
    suspension = {
        "kind": "bifilar", "orientation": "athwartships",
        "line_length": between(0.7, 1.2), "spacing": 0.56, "top_spacing": between(0.5, 0.62),
    }  # fmt: skip
    swing = {"id": "one", "recording": "one.csv", "suspension": suspension, "truth": truth}
    return {"body": {"mass": 13.18}, "swing": [swing], "effect": effects}


def ours(rig: dict) -> gyradius.Simulation:
    return gyradius.simulate(rig, t_s=np.arange(round(DURATION_S / EVERY_S) + 1) * EVERY_S)


def witness(found: gyradius.Simulation, step_s: float, force=None) -> np.ndarray:
    """MuJoCo's positions and quaternions (N, 7) from the same start; `force(turn, v, w)` acts in hull axes."""
    n = found.numbers
    top, low = n["top_spacing_m"] / 2, n["spacing_m"] / 2
    tilt = n.get("unequal_lines.difference_m", 0.0) / 2
    lengths = n["line_length_m"] + np.array([-tilt, tilt])
    cm = np.array([n["cm_x_m"], n["cm_y_m"], n["cm_z_m"]])
    mass, arm, inside = n["mass_kg"], np.zeros(3), ""
    xx, yy, zz, xy, xz, yz = (n[f"inertia_{k}_kg_m2"] for k in ("xx", "yy", "zz", "xy", "xz", "yz"))
    inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if "internal_motion.mass_kg" in n:
        part = lambda name: n[f"internal_motion.{name}"]
        place = np.array([part(f"place_{k}_m") for k in "xyz"]) - cm
        inside = SLIDER.format(
            place=words(place), along=words([part(f"along_{k}") for k in "xyz"]),
            stiffness=part("stiffness_n_m"), damping=part("damping_n_s_m"), mass=part("mass_kg"),
        )  # fmt: skip
        # The hull without the slider: its centre and its inertia about that.
        rest = mass - part("mass_kg")
        arm = -part("mass_kg") * place / rest
        inertia = inertia - point_inertia(part("mass_kg"), place) - point_inertia(rest, arm)
        mass = rest
    text = MODEL.format(
        step=step_s, gravity=n["gravity_m_s2"], mass=mass, stiff=2 * step_s, cm=words(arm), inside=inside,
        a0=words([0, -top, 0]), a1=words([0, top, 0]),
        p0=words(np.array([0, -low, 0]) - cm), p1=words(np.array([0, low, 0]) - cm),
        position=words(found.position_m[0]), quaternion=words(found.attitude[0]),
        inertia=words([inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1], inertia[0, 2], inertia[1, 2]]),
    )  # fmt: skip
    model = mujoco.MjModel.from_xml_string(text)
    model.tendon_length0[:] = lengths  # the tendons' rest is the lines' length
    data = mujoco.MjData(model)
    data.qvel[:3], data.qvel[3:6] = found.velocity_m_s[0], found.rate_rad_s[0]
    out, every = [data.qpos[:7].copy()], round(EVERY_S / step_s)
    turn = np.empty(9)

    def passive(_model, data) -> None:
        mujoco.mju_quat2Mat(turn, data.qpos[3:7])
        matrix = turn.reshape(3, 3)
        along, about = force(matrix.T @ data.qvel[:3], data.qvel[3:6])
        data.qfrc_passive[:3] += matrix @ along
        data.qfrc_passive[3:6] += about

    mujoco.set_mjcb_passive(passive if force else None)
    try:
        for _ in range(len(found.t_s) - 1):
            for _ in range(every):
                mujoco.mj_step(model, data)
            out.append(data.qpos[:7].copy())
    finally:
        mujoco.set_mjcb_passive(None)
    return np.array(out)


def converges(found: gyradius.Simulation, force=None) -> None:
    """MuJoCo's step is halved until what parts it from us is below 1e-5 of the motion; its constraint is of second order,
    so that each halving nears us fourfold."""
    mine = np.hstack([found.position_m, found.attitude])
    moved = np.abs(mine - mine.mean(0)).max()
    errors = []
    for step in 0.004 / 2.0 ** np.arange(7):
        errors.append(np.abs(witness(found, step, force) - mine).max() / moved)
        if len(errors) >= 3 and errors[-1] < 1e-5:
            break
    print("errors", errors)
    assert errors[-1] < 1e-5
    assert errors[-2] / errors[-1] == pytest.approx(4, rel=0.25)


def seeded(effects: list[dict]) -> gyradius.Simulation:
    seed = generate.test_seed()
    print("seed", seed)
    return ours(drawn(seed, effects))


def test_yaw_sway_and_surge_with_the_mass_off_centre():
    converges(seeded([]))


def test_unequal_lines():
    converges(seeded([{"id": "unequal_lines", "difference_m": 0.04}]))


def test_quadratic_drag():
    along, about = np.array([0.8, 1.5, 0.5]), np.array([0.01, 0.04, 0.06])
    names = ["surge_force", "sway_force", "heave_force", "roll_torque", "pitch_torque", "yaw_torque"]
    numbers = {f"{name}_coefficient": c for name, c in zip(names, [*along, *about])}
    found = seeded([{"id": "quadratic_drag", **numbers}])
    converges(found, lambda v, w: (-along * np.abs(v) * v, -about * np.abs(w) * w))


def test_dry_friction():
    torque = np.array([0.01, 0.02, 0.04])
    numbers = dict(zip(["roll_n_m", "pitch_n_m", "yaw_n_m"], torque))
    found = seeded([{"id": "bearing_friction", **numbers, "transition_rad_s": 0.02}])
    converges(found, lambda v, w: (np.zeros(3), -torque * np.tanh(w / 0.02)))


def test_a_slider_inside():
    slider = {
        "mass_kg": 1.5, "place_x_m": 0.2, "place_y_m": -0.05, "place_z_m": -0.2,
        "along_x": 0.8, "along_y": 0.6, "along_z": 0.0, "stiffness_n_m": 40.0, "damping_n_s_m": 0.5,
    }  # fmt: skip
    converges(seeded([{"id": "internal_motion", **slider}]))
