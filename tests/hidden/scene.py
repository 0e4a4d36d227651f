"""One swing as it truly is, and what the phone makes of it.

A scene is the base model (rigid body, inextensible lines, linear damping, phone with bias) plus whatever an effect has put
into it: fields of the rig, or flaws of the phone. `readings` are without noise; noise is added when a session is written.

# Conventions
Positions in hull axes from the mid-point of the suspension points. `phone_from_hull` maps hull vectors to the phone's axes.
A phone shows `true time * (1 + clock)`.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass, field

import motion
import numpy as np
from borrowed import blind, rb
from scipy.interpolate import CubicSpline
from scipy.signal import lsim

WARM_UP_S = 6.0  # between release and recording: what is stiff rings when let go, and has died away
ROCK_S = 0.01  # step of a rocking phone, exact for what drives it along straight lines
STIFF_SHARE = 0.25  # of the fastest motion's radian, the longest step


@dataclass
class Slip:
    """The phone turns and shifts on its tape, and stays so."""

    at_s: float
    turn_rad: np.ndarray  # (3,), phone axes
    shift_m: np.ndarray  # (3,), hull axes
    takes_s: float = 0.15


@dataclass
class Mount:
    """A phone that rocks about one axis on something springy."""

    omega_rad_s: float
    damping_ratio: float
    axis: np.ndarray  # (3,), phone axes
    lever_per_m: np.ndarray  # (3,): the height of its mass over its gyradius squared, phone axes
    share: float = 1.0


@dataclass
class Flaws:
    """What is wrong with the phone."""

    gyro_scale: float = 0.0
    gyro_drift: np.ndarray = field(default_factory=lambda: np.zeros(3))  # rad/s gained in DRIFT_SPAN_S
    acc_drift: np.ndarray = field(default_factory=lambda: np.zeros(3))
    drift_s: float = 1e9  # time constant of warming up
    clock: float = 0.0  # on top of the phone's own error of some ppm
    gyro_limit: float = np.inf
    acc_limit: float = np.inf
    mount: Mount | None = None
    slips: list[Slip] = field(default_factory=list)


DRIFT_SPAN_S = 120.0


@dataclass
class Scene:
    """A swing: body, lines, release, phone."""

    mass_kg: float
    centre_m: np.ndarray
    inertia_kg_m2: np.ndarray
    gravity_m_s2: float
    line_m: np.ndarray  # (2,), +y and -y
    spacing_m: float
    top_spacing_m: float
    move: np.ndarray  # (6,): the release's translation and rotation from rest, world axes
    rate: np.ndarray  # (6,)
    shown_s: np.ndarray  # times as the phone shows them, from the start of the recording
    phone: blind.Phone
    extras: np.ndarray = field(default_factory=motion.blank)  # a rig's fields that effects fill
    flaws: Flaws = field(default_factory=Flaws)
    acc_shown_s: np.ndarray | None = None  # the accelerometer's own times; None: the gyroscope's

    def copy(self) -> "Scene":
        """For changing; times are shared."""
        other = copy.copy(self)
        for name in ("centre_m", "inertia_kg_m2", "line_m", "move", "rate", "extras", "flaws", "phone"):
            setattr(other, name, copy.deepcopy(getattr(self, name)))
        return other

    def true_s(self) -> np.ndarray:
        """When the samples were truly taken."""
        return self.shown_s / (1 + self.phone.clock_error + self.flaws.clock)


def rigid_part(scene: Scene) -> tuple[float, np.ndarray, np.ndarray]:
    """Mass, centre and tensor without what slides in it; with it at rest they are the scene's."""
    e = scene.extras[0]
    sliders = [(-e["slider_mass"][k], e["slider_place"][k], np.zeros((3, 3))) for k in (0, 1) if e["slider_mass"][k]]
    return blind.together([(scene.mass_kg, scene.centre_m, scene.inertia_kg_m2), *sliders])


def rig_of(scene: Scene) -> np.ndarray:
    """The rig record of `motion.py`."""
    rig = scene.extras.copy()
    mass, centre, tensor = rigid_part(scene)
    half, top = scene.spacing_m / 2, scene.top_spacing_m / 2
    rig["mass"], rig["inertia"], rig["gravity"], rig["line"] = mass, tensor, scene.gravity_m_s2, scene.line_m
    rig["point"] = np.array([[0, half, 0], [0, -half, 0]]) - centre
    rig["anchor"] = [[0, top, 0], [0, -top, 0]]
    rig["slider_place"] -= centre
    if rig["stiffness"][0] > 0:  # the stated length is that of the line as it hangs at rest
        rig["natural"] = scene.line_m - scene.mass_kg * scene.gravity_m_s2 / 2 / rig["stiffness"]
    return rig


def start_of(scene: Scene, rig: np.ndarray) -> np.ndarray:
    """State at the release: rest, displaced; a support that yields is already bent, and what slides is where it is put."""
    line = scene.line_m.mean()
    drop = np.sqrt(line**2 - (scene.top_spacing_m - scene.spacing_m) ** 2 / 4)
    centre = -rig["point"][0].mean(0)
    rest = np.concatenate([centre - [0, 0, drop], [1.0], np.zeros(9)])[:, None]
    state = np.zeros(motion.STATE)
    state[:13] = rb.displaced(rest, scene.move, scene.rate)[:, 0]
    state[motion.SLIDERS : motion.SUPPORT] = np.ravel(rig["slider_start"])
    if rig["support"][0, 0] > 0:
        aside = scene.move[:2] - np.cross(scene.move[3:], centre)[:2]
        bent = scene.mass_kg * scene.gravity_m_s2 / line * aside / rig["support"][0, 1]
        state[[motion.SUPPORT, motion.SUPPORT + 2]] = bent
        state[:2] += bent
    return state


def longest_step_s(scene: Scene, smooth_s: float) -> float:
    """A step for this rig: shorter where something is stiff or has a kink."""
    e, step = scene.extras[0], smooth_s
    if e["coulomb"].any() or e["rub"][0]:
        step = smooth_s / 4
    elif e["contact"].any():
        step = smooth_s / 2
    if e["knock_time"][1]:
        step = min(step, e["knock_time"][1] / 8)
    if e["stiffness"]:  # the roll that elastic lines allow is faster than the heave
        half = scene.spacing_m / 2
        lightest = min(scene.mass_kg, scene.inertia_kg_m2[0, 0] / half**2)
        step = min(step, STIFF_SHARE / np.sqrt(2 * e["stiffness"] / lightest))
    if e["support"][0]:
        step = min(step, STIFF_SHARE / np.sqrt(e["support"][1] / e["support"][0]))
    for mass, spring, rod in zip(e["slider_mass"], e["slider_spring"], e["slider_rod"]):
        if mass:
            step = min(step, STIFF_SHARE / np.sqrt(scene.gravity_m_s2 / rod if rod else spring / mass))
    return step


def move(scene: Scene, smooth_s: float = 0.005, every: int = 1) -> np.ndarray:
    """The motion (N, motion.OUT) at every so-manieth of the scene's times."""
    rig, times = rig_of(scene), np.ascontiguousarray(scene.true_s()[::every])
    return motion.swing(rig, start_of(scene, rig), -WARM_UP_S, times, longest_step_s(scene, smooth_s))


def tensions(scene: Scene, at: np.ndarray) -> np.ndarray:
    """Pull of each line (N, 2), N, that a motion needs: Newton's and Euler's equations by least squares, drag and the like left out."""
    rig = rig_of(scene)[0]
    q, w, a, dw = at[:, 3:7].T, at[:, 7:10].T, at[:, 10:13].T, at[:, 13:16].T
    force = rig["mass"] * rb.rotate(rb.conjugate(q), a + np.array([[0.0], [0], [scene.gravity_m_s2]]))
    torque = rig["inertia"] @ dw + rb.cross(w, rig["inertia"] @ w)
    arms = [np.repeat(point[:, None], len(at), 1) for point in rig["point"]]
    ways = [rb.rotate(rb.conjugate(q), anchor[:, None] - at[:, :3].T) - arm for anchor, arm in zip(rig["anchor"], arms)]
    ways = [way / np.linalg.norm(way, axis=0) for way in ways]
    per_newton = np.array([np.concatenate([way, rb.cross(arm, way) / scene.spacing_m]) for way, arm in zip(ways, arms)])
    wanted = np.concatenate([force, torque / scene.spacing_m])
    normal, side = np.einsum("jin,kin->njk", per_newton, per_newton), np.einsum("jin,in->nj", per_newton, wanted)
    return np.linalg.solve(normal, side[:, :, None])[:, :, 0]


def held(scene: Scene, at: np.ndarray, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rate and specific force (3, N), phone axes, where the phone is, slips included."""
    q, w, a, dw = at[:, 3:7].T, at[:, 7:10].T, at[:, 10:13].T, at[:, 13:16].T
    arm = (scene.phone.position_m - rigid_part(scene)[1])[:, None] * np.ones_like(times)
    for slip in scene.flaws.slips:
        arm = arm + slip.shift_m[:, None] * gone(slip, times)
    f = rb.rotate(rb.conjugate(q), a + np.array([[0.0], [0], [scene.gravity_m_s2]]))
    f = f + rb.cross(dw, arm) + rb.cross(w, rb.cross(w, arm))
    rate, force = rb.rotate(scene.phone.phone_from_hull, w), rb.rotate(scene.phone.phone_from_hull, f)
    for slip in scene.flaws.slips:
        back = rb.turn(-slip.turn_rad[:, None] * gone(slip, times))
        rate, force = rb.rotate(back, rate), rb.rotate(back, force)
        rate = rate + slip.turn_rad[:, None] * np.gradient(gone(slip, times), times)
    return rate, force


def gone(slip: Slip, times: np.ndarray) -> np.ndarray:
    """How far a slip has gone, from 0 to 1."""
    x = np.clip((times - slip.at_s) / slip.takes_s, 0, 1)
    return x**3 * (10 - 15 * x + 6 * x**2)


def rock(mount: Mount, scene: Scene, times: np.ndarray, rate: np.ndarray, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rate and force on a phone that rocks: φ'' + 2 ζ Ω φ' + Ω² φ = -n·ω' - n·(h x (f - f at rest))."""
    level = rb.rotate(scene.phone.phone_from_hull, np.array([[0.0], [0], [scene.gravity_m_s2]]))
    turning = mount.axis @ CubicSpline(times, rate, axis=1)(times, 1)
    drive = -mount.share * (turning + mount.axis @ np.cross(mount.lever_per_m, (force - level).T).T)
    even = np.arange(times[0], times[-1] + ROCK_S, ROCK_S)
    u = CubicSpline(times, drive)(even)
    om, zeta = mount.omega_rad_s, mount.damping_ratio
    system = ([[0, 1], [-(om**2), -2 * zeta * om]], [[0], [1]], np.eye(2), np.zeros((2, 1)))
    _, phi, _ = lsim(system, u, even - even[0], X0=[u[0] / om**2, (u[1] - u[0]) / ROCK_S / om**2])
    angle, speed = CubicSpline(even, phi)(times).T
    n = mount.axis[:, None]
    rock_of = lambda v: v - angle * rb.cross(n * np.ones_like(times), v)
    return rock_of(rate) + n * speed, rock_of(force)


def sense(scene: Scene, at: np.ndarray, every: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """What gyroscope and accelerometer say (N, 3) of a motion, noise and range apart."""
    times, flaws, phone = scene.true_s()[::every], scene.flaws, scene.phone
    rate, force = held(scene, at, times)
    if flaws.mount:
        rate, force = rock(flaws.mount, scene, times, rate, force)
    warmed = np.expm1(-times / flaws.drift_s) / np.expm1(-DRIFT_SPAN_S / flaws.drift_s)
    gyro = (1 + flaws.gyro_scale) * rate + (phone.gyro_bias[:, None] + flaws.gyro_drift[:, None] * warmed)
    acc = force + (phone.acc_bias[:, None] + flaws.acc_drift[:, None] * warmed)
    return gyro.T, acc.T


def clipped(scene: Scene, gyro: np.ndarray, acc: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Readings within the sensors' range."""
    bound = lambda x, limit: np.clip(x, -limit, limit)
    return bound(gyro, scene.flaws.gyro_limit), bound(acc, scene.flaws.acc_limit)


def readings(scene: Scene, smooth_s: float = 0.005, every: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Gyroscope and accelerometer (N, 3), without noise."""
    gyro, acc = sense(scene, move(scene, smooth_s, every), every)
    if scene.acc_shown_s is not None:
        other = scene.copy()
        other.shown_s = scene.acc_shown_s
        acc = sense(other, move(other, smooth_s, every), every)[1]
    return clipped(scene, gyro, acc)
