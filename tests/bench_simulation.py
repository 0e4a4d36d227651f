"""How long the package's simulation and MuJoCo take for the same 120 s at equal accuracy, in one run.

A keelboat in pure yaw of 5 degrees, whose period is known exactly (quadrature of its energy, heave included). MuJoCo's
step is halved until its period is right to 0.1 ppm; ours is right to far better at its own step. Then ours in yaw, sway,
surge and pitch at once, read by a phone, and with derivatives by twenty numbers; a model hull, whose pitch is three times
as fast, takes as many more steps. Times are the processor's, the least of nine, so that whatever else runs on the machine
counts little. Exit status 1 below 30 times, above 10 ms (the keelboat) or above 200 ms with derivatives (either).
"""

import sys
import time

import gyradius
import mujoco
import numpy as np
from scipy.integrate import quad
from scipy.interpolate import make_interp_spline
from scipy.optimize import brentq

MASS, GYRADII, HALF, LINE, G, YAW = 622.7, (0.625, 1.156, 1.0566), 0.9, 3.477, 9.80665, np.radians(5)
TIMES = np.arange(12001) * 0.01
TWENTY = [
    "mass_kg", "inertia_xx_kg_m2", "inertia_yy_kg_m2", "inertia_zz_kg_m2", "inertia_xz_kg_m2", "cm_x_m", "cm_y_m", "cm_z_m",
    "line_length_m", "spacing_m", "top_spacing_m", "along_m", "across_m", "turn_rad", "yaw_rad", "linear_damping.sway_n_s_m",
    "linear_damping.yaw_n_m_s", "phone.position_x_m", "phone.turn_z_rad", "phone.gyro_bias_z_rad_s",
]  # fmt: skip
MODEL = """
<mujoco>
  <compiler balanceinertia="false"/>
  <option timestep="{step}" gravity="0 0 -{g}" integrator="RK4" solver="Newton" iterations="200" tolerance="1e-14">
    <flag contact="disable"/></option>
  <worldbody>
    <site name="a0" pos="0 -{half} 0"/><site name="a1" pos="0 {half} 0"/>
    <body pos="{place}" quat="{turn}">
      <freejoint/><inertial pos="0 0 0" mass="{mass}" diaginertia="{inertia}"/>
      <site name="p0" pos="0 -{half} 0.4"/><site name="p1" pos="0 {half} 0.4"/>
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


def exact_s() -> float:
    """½ (k² + z'²) θ̇² = g (z(θ0) − z(θ)), z = −√(l² − 4 d² sin²(θ/2)), with θ = θ0 sin u."""
    h = lambda a: np.sqrt(LINE**2 - 4 * HALF**2 * np.sin(a / 2) ** 2)

    def integrand(u: float) -> float:
        a = YAW * np.sin(u)
        drop = 4 * HALF**2 * np.sin((YAW + a) / 2) * np.sin((YAW - a) / 2) / (h(a) + h(YAW))
        rise = HALF**2 * np.sin(a) / h(a)
        return np.sqrt((GYRADII[2] ** 2 + rise**2) / (2 * G * drop)) * YAW * np.cos(u)

    return 4 * quad(integrand, 0, np.pi / 2, epsabs=1e-13)[0]


def period_s(heading: np.ndarray) -> float:
    curve = make_interp_spline(TIMES, heading, k=5)
    at = [brentq(curve, TIMES[i], TIMES[i + 1], xtol=1e-14) for i in np.flatnonzero(heading[:-1] * heading[1:] < 0)]
    return 2 * (at[-1] - at[0]) / (len(at) - 1)


# Mass, roll, pitch and yaw gyradius, depth, line length, spacing: the paper's keelboat and its model hull (Fig. 15).
KEELBOAT = (MASS, *GYRADII, 0.4, LINE, 2 * HALF)
MODEL_HULL = (13.18, 0.204, 0.352, 0.303, 0.253, 1.006, 0.56)


def hung(hull: tuple[float, ...], start: dict[str, float], effects: list[dict]) -> gyradius.Rig:
    mass, roll, pitch, yaw, depth, length, spacing = hull
    suspension = {"kind": "bifilar", "orientation": "athwartships", "line_length": length, "spacing": spacing}
    gyradii = {"k_roll_m": roll, "k_pitch_m": pitch, "k_yaw_m": yaw}
    truth = {**gyradii, "cm_depth_m": depth, "gravity_m_s2": G, **start}
    swing = {"id": "yaw", "recording": "yaw.csv", "suspension": suspension, "truth": truth}
    return gyradius.read_rig({"body": {"mass": mass}, "swing": [swing], "effect": effects})


def fastest(rig: gyradius.Rig, derivatives: list[str]) -> tuple[float, gyradius.Simulation]:
    took = []
    for _ in range(9):
        start = time.process_time()
        found = rig.simulate(t_s=TIMES, derivatives=derivatives)
        took.append(time.process_time() - start)
    return min(took), found


def full_motion_s(hull: tuple[float, ...]) -> tuple[float, float]:
    """How long a swing in every mode at once takes, alone and with derivatives."""
    mass, _, _, yaw, _, length, _ = hull
    start = {"yaw_deg": 6.0, "sway_m": 0.06 * length, "surge_m": 0.04 * length, "pitch_deg": 3.0}
    damping = {"id": "linear_damping", "sway_n_s_m": 0.008 * mass, "yaw_n_m_s": 0.01 * mass * yaw**2}
    rig = hung(hull, start, [damping])
    return fastest(rig, [])[0], fastest(rig, TWENTY)[0]


def mujocos(step_s: float) -> tuple[float, np.ndarray]:
    drop = np.sqrt(LINE**2 - 4 * HALF**2 * np.sin(YAW / 2) ** 2)
    text = MODEL.format(
        step=step_s, g=G, half=HALF, mass=MASS, stiff=2 * step_s, place=f"0 0 {-drop - 0.4:.17g}",
        turn=f"{np.cos(YAW / 2):.17g} 0 0 {np.sin(YAW / 2):.17g}",
        inertia=" ".join(f"{MASS * k * k:.17g}" for k in GYRADII),
    )  # fmt: skip
    model = mujoco.MjModel.from_xml_string(text)
    model.tendon_length0[:] = LINE
    data = mujoco.MjData(model)
    headings, every = np.empty(len(TIMES)), round(0.01 / step_s)
    start = time.process_time()
    for n in range(len(TIMES)):
        headings[n] = 2 * np.arctan2(data.qpos[6], data.qpos[3])
        mujoco.mj_step(model, data, nstep=every)
    return time.process_time() - start, headings


def main() -> int:
    exact = exact_s()
    ppm = lambda heading: 1e6 * (period_s(heading) / exact - 1)
    seconds, found = fastest(hung(KEELBOAT, {"yaw_rad": YAW}, []), [])
    heading = 2 * np.arctan2(found.attitude[:, 3], found.attitude[:, 0])
    print(f"gyradius          {1e3 * seconds:9.1f} ms  period off by {ppm(heading):+.5f} ppm")
    for step_s in 0.005 / 2.0 ** np.arange(8):
        theirs, heading = mujocos(step_s)
        off = ppm(heading)
        print(f"MuJoCo {1e3 * step_s:7.4f} ms {1e3 * theirs:9.1f} ms  period off by {off:+.5f} ppm")
        if abs(off) < 0.1:
            break
    print(f"at a period right to 0.1 ppm MuJoCo takes {theirs / seconds:.0f} times as long")
    fast_enough = seconds <= 0.01
    for name, hull in [("keelboat", KEELBOAT), ("model hull", MODEL_HULL)]:
        plain, slopes = full_motion_s(hull)
        fast_enough &= slopes <= 0.2
        print(f"{name:10} 120 s at 100 Hz {1e3 * plain:9.1f} ms  with twenty derivatives {1e3 * slopes:.1f} ms", end="")
        print(f", {slopes / plain:.0f} times as long")
    return 0 if theirs > 30 * seconds and abs(off) < 0.1 and fast_enough else 1


if __name__ == "__main__":
    sys.exit(main())
