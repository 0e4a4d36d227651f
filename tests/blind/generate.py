"""Draws measurements that nobody has seen: a session in the session format, and beside it what is true.

    python tests/blind/generate.py --count 5 --out sessions [--seed N] [--kind a]

writes `sessions/<name>/session.toml` with its recordings and `sessions/<name>.truth.json`. Without `--seed` a fresh
seed is drawn and printed. Motion comes from `rigid_body.py` (bifilar) and from a pendulum integrated here (compound).

# Conventions
Hull axes: x forward, y to port, z up; psi and tilt positive bow up. `phone_from_hull` maps hull vectors to the
phone's axes. A phone's clock shows `true time * (1 + error) + offset`.
"""

from __future__ import annotations

import argparse
import json
import os
import secrets
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import rigid_body as rb
from scipy.integrate import solve_ivp

DURATION_S = 120.0
BATCH = 14  # sessions integrated together
KINDS = {
    "a": "yaw and sway together, then the pitch modes",
    "b": "one swing with everything excited",
    "c": "yaw, sway and pitch, each alone",
    "d": "as a, and a fore-and-aft suspension for roll",
    "e": "as a, at two line lengths",
    "f": "as d, and two tilted yaw swings for psi",
    "g": "as a, and a compound pendulum",
    "h": "as a, with attachments to be taken off",
    "i": "as a, and a yaw with masses added at the ends",
    "j": "as a, and a weight hung from bow and stern, the tilt recorded by the phone",
    "k": "as a, with another spacing above than on the hull",
    "l": "as c, one swing with the wrong motion said to be excited",
}


@dataclass
class Attachment:
    """A body that rides on the hull."""

    name: str
    mass_kg: float
    position_m: np.ndarray
    gyradii_m: np.ndarray


@dataclass
class Incline:
    """A weight at one end and the pitch that it makes."""

    end: str
    mass_kg: float
    arm_m: float
    depth_m: float
    bow_up_rad: float


@dataclass
class Hull:
    """What is true of everything that hangs."""

    mass_kg: float
    length_m: float
    beam_m: float
    k_roll_m: float  # about the hull's x axis
    k_pitch_m: float
    k_yaw_m: float  # about the hull's z axis
    psi_rad: float
    depth_m: float
    gravity_m_s2: float
    attachments: list[Attachment] = field(default_factory=list)
    inclines: list[Incline] = field(default_factory=list)

    def inertia(self) -> np.ndarray:
        """Tensor about the centre of mass, hull axes, kg m²; the product follows from psi."""
        difference = self.k_roll_m**2 - self.k_yaw_m**2
        i_xz = difference / 2 * np.tan(2 * self.psi_rad)
        tensor = np.diag([self.k_roll_m**2, self.k_pitch_m**2, self.k_yaw_m**2])
        tensor[0, 2] = tensor[2, 0] = i_xz
        return self.mass_kg * tensor

    def alone(self) -> tuple[float, np.ndarray, np.ndarray]:
        """Mass, centre of mass (hull axes, from the middle of the suspension points) and tensor without attachments."""
        parts = [(-a.mass_kg, a.position_m, -a.mass_kg * np.diag(a.gyradii_m**2)) for a in self.attachments]
        return together([(self.mass_kg, np.array([0, 0, -self.depth_m]), self.inertia()), *parts])


def together(bodies: list[tuple]) -> tuple[float, np.ndarray, np.ndarray]:
    """Several bodies (mass, centre, tensor about it) as one, by way of the tensor about the origin."""
    offset = lambda m, r: m * (r @ r * np.eye(3) - np.outer(r, r))
    mass = sum(m for m, _, _ in bodies)
    centre = sum(m * r for m, r, _ in bodies) / mass
    return mass, centre, sum(i + offset(m, r) for m, r, i in bodies) - offset(mass, centre)


@dataclass
class Phone:
    """A phone taped to the hull: where, how, and how well it measures."""

    position_m: np.ndarray  # hull axes, from the middle of the suspension points of a level swing
    phone_from_hull: np.ndarray  # quaternion (4, 1)
    gyro_noise: float
    acc_noise: float
    gyro_bias: np.ndarray
    acc_bias: np.ndarray
    clock_error: float
    gyro_rate_hz: float
    acc_rate_hz: float
    one_clock: bool


@dataclass
class Plan:
    """One swing to be made: how the hull hangs and what is set going."""

    id: str
    excited: tuple[str, ...]  # motions: yaw, sway, pitch
    line_m: float
    stated_line: dict
    spacing_m: float
    stated_spacing: dict
    fore_and_aft: bool = False
    bow_up_rad: float = 0.0
    stated_pitch: dict | None = None
    compound: bool = False
    axis_height_m: float = 0.0
    phone: Phone | None = None
    duration_s: float = DURATION_S
    extra: dict = field(default_factory=dict)
    top_spacing_m: float | None = None
    added: list = field(default_factory=list)  # (mass, position): masses that ride along in this swing alone
    said: list[str] | None = None  # what the operator wrote, where it is not what was set going

    def depth(self, hull: Hull) -> float:
        """Tilted, the points are moved along the deck until the centre of mass hangs below them."""
        return hull.depth_m / np.cos(self.bow_up_rad)

    def body(self, hull: Hull) -> tuple[float, np.ndarray, np.ndarray]:
        """Mass, centre of mass (hull axes, from the middle of the points of a level swing) and tensor as it swings."""
        points = [(m, np.array(r), np.zeros((3, 3))) for m, r in self.added]
        return together([(hull.mass_kg, np.array([0, 0, -hull.depth_m]), hull.inertia()), *points])


def uniform_rotation(rng) -> np.ndarray:
    """A quaternion, uniform over all orientations."""
    q = rng.normal(size=(4, 1))
    return q / np.linalg.norm(q)


def log_uniform(rng, low: float, high: float) -> float:
    """A number whose logarithm is uniform."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def draw_hull(rng, tilted: bool, mass_kg: tuple = (8, 700)) -> Hull:
    """A hull, between an 8 kg model and a 700 kg keelboat unless asked for otherwise."""
    mass = log_uniform(rng, *mass_kg)
    length = 1.87 * (mass / 13.18) ** 0.317 * np.exp(rng.normal(0, 0.12))  # through model hull and Yngling
    k_yaw = length * rng.uniform(0.18, 0.30)
    psi = np.radians(rng.uniform(-5, 5)) if tilted or rng.random() < 0.5 else 0.0
    while True:
        k_pitch, k_roll = k_yaw * rng.uniform(0.9, 1.1), k_yaw * rng.uniform(0.3, 0.7)
        hull = Hull(
            mass, length, length * rng.uniform(0.2, 0.38), k_roll, k_pitch, k_yaw, psi,
            float(np.clip(length * rng.uniform(0.05, 0.13), 0.1, 0.6)), rng.uniform(9.78, 9.83),
        )  # fmt: skip
        if possible(hull.inertia()):
            return hull


def draw_phone(rng, hull: Hull) -> Phone:
    """Anywhere on the hull, any way up."""
    gyro_rate = rng.uniform(98, 102)
    return Phone(
        np.array([rng.uniform(-0.4, 0.4) * hull.length_m, rng.uniform(-0.5, 0.5) * hull.beam_m, rng.uniform(-0.3, 0.3)]),
        uniform_rotation(rng),
        log_uniform(rng, 0.0005, 0.003),
        log_uniform(rng, 0.005, 0.03),
        rng.uniform(-0.02, 0.02, 3),
        rng.uniform(-0.1, 0.1, 3),
        rng.normal(0, 11e-6),
        gyro_rate,
        rng.uniform(98, 102),
        rng.random() < 0.3,
    )


def stated(rng, true: float, low_u: float, high_u: float, digits: int = 4) -> dict:
    """What the tape says of a true length, in metres to a tenth of a millimetre."""
    u = rng.uniform(low_u, high_u)
    return {"value": round(true + rng.normal(0, u), digits), "u": round(u, digits + 1)}


def draw_plans(rng, hull: Hull, kind: str) -> list[Plan]:
    """The swings of a session of this kind."""
    spacing = hull.k_yaw_m * rng.uniform(0.7, 1.8)
    line = log_uniform(rng, max(0.5, 0.25 * hull.length_m), 4.0)
    level = (line, stated(rng, line, 0.001, 0.003), spacing, stated(rng, spacing, 0.0005, 0.001))
    plans = []

    def add(name, excited, rig=level, **more):
        plans.append(Plan(name, excited, *rig, **more))

    if kind == "k":
        top = spacing * rng.uniform(0.8, 1.25)
        more = {"top_spacing_m": top, "extra": {"top_spacing": stated(rng, top, 0.0005, 0.001)}}
        add("yaw-sway-1", ("yaw", "sway"), **more)
        add("pitch-1", ("pitch",), **more)
    elif kind == "b":
        add("all-1", ("yaw", "sway", "pitch"))
    elif kind in "cl":
        for motion in ("yaw", "sway", "pitch"):
            add(f"{motion}-1", (motion,))
        if kind == "l":
            wrong = {"yaw": ["pitch"], "sway": ["yaw"], "pitch": ["yaw"]}
            liar = plans[rng.integers(3)]
            liar.said = wrong[liar.excited[0]]
    else:
        add("yaw-sway-1", ("yaw", "sway"))
        add("pitch-1", ("pitch",))
    if kind in "df":
        far = hull.k_yaw_m * rng.uniform(0.7, 1.8)
        rig = (line, stated(rng, line, 0.001, 0.003), far, stated(rng, far, 0.0005, 0.001))
        add("roll-1", ("pitch",) if rng.random() < 0.4 else ("pitch", "sway"), rig, fore_and_aft=True)
    if kind == "e":
        other = line
        while abs(np.log(other / line)) < 0.3:
            other = log_uniform(rng, max(0.5, 0.25 * hull.length_m), 4.0)
        rig = (other, stated(rng, other, 0.001, 0.003), spacing, level[3])
        add("yaw-sway-2", ("yaw", "sway"), rig)
        add("pitch-2", ("pitch",), rig)
    if kind == "f":
        for sign, end in ((1, "up"), (-1, "down")):
            tilt = sign * np.radians(rng.uniform(15, 30))
            note = {"value": round(float(np.degrees(tilt) + rng.normal(0, 0.2)), 2), "u": 0.2}
            add(f"bow-{end}", ("yaw", "sway") if rng.random() < 0.5 else ("yaw",), bow_up_rad=tilt, stated_pitch=note)
    if kind == "i":
        ends = np.array([rng.uniform(0.35, 0.48), -rng.uniform(0.35, 0.48)]) * hull.length_m
        mass = hull.mass_kg * rng.uniform(0.001, 0.006)
        height = rng.uniform(-0.05, 0.1)
        # The same weight at both ends: the trim changes a little.
        add("added-1", ("yaw",), added=[(round(mass, 4), [round(float(x), 4), 0.0, round(height, 4)]) for x in ends])
    if kind == "g":
        height = rng.uniform(0.25, 1.0) * hull.k_pitch_m
        tape = stated(rng, height, 0.001, 0.002)
        add(
            "compound-1", ("pitch",), compound=True, axis_height_m=height, extra={"axis_height": tape},
            fore_and_aft=rng.random() < 0.4,
        )  # fmt: skip
    return plans


def draw_attachments(rng, hull: Hull) -> list[Attachment]:
    """A cross beam at the points and a box somewhere along the keel line."""
    width = rng.uniform(0.3, 0.9) * hull.beam_m
    place = lambda x, z: np.round([x * hull.length_m, 0.0, z], 4)
    beam = Attachment(
        "cross beam", round(hull.mass_kg * rng.uniform(0.01, 0.06), 4), place(rng.uniform(-0.02, 0.02), rng.uniform(0, 0.05)),
        np.round([width / np.sqrt(12), 0.03, width / np.sqrt(12)], 4),
    )  # fmt: skip
    box = Attachment(
        "box", round(hull.mass_kg * rng.uniform(0.003, 0.02), 4), place(rng.uniform(-0.3, 0.3), rng.uniform(-0.2, 0)),
        np.round(rng.uniform(0.05, 0.15, 3), 4),
    )  # fmt: skip
    return [beam, box]


def draw_inclines(rng, hull: Hull) -> list[Incline]:
    """A weight that tilts the hull by 4 to 10 degrees, hung from each end in turn."""
    drop, arms = round(rng.uniform(0, 0.1), 4), np.round(rng.uniform(0.3, 0.48, 2) * hull.length_m, 4)
    tangent = np.tan(np.radians(rng.uniform(4, 10)))
    mass = round(hull.mass_kg * hull.depth_m * tangent / (arms.mean() - drop * tangent), 4)
    # Moments about the points: mass (arm cos a − drop sin a) = hull depth sin a.
    angle = lambda arm: np.arctan(mass * arm / (hull.mass_kg * hull.depth_m + mass * drop))
    return [
        Incline("bow", mass, float(arms[0]), drop, -angle(arms[0])),
        Incline("stern", mass, float(arms[1]), drop, angle(arms[1])),
    ]


def damping(rng, hull: Hull) -> tuple[tuple, tuple]:
    """Linear drag by axis that makes motions decay in 60 to 900 s."""
    inertia = np.diag(hull.inertia())
    taus = [log_uniform(rng, 60, 900) for _ in range(6)]
    return tuple(2 * hull.mass_kg / t for t in taus[:3]), tuple(2 * i / t for i, t in zip(inertia, taus[3:]))


def separations(modes: dict, excited: list[str]) -> tuple[float, float]:
    """Relative distance of the nearest two excited periods, and of pitch from the yaw-sway combinations (Kane-Tseng)."""
    omega = {m: modes[m].omega_rad_s for m in modes}
    pairs = [abs(omega[a] / omega[b] - 1) for a in excited for b in excited if a < b]
    tones = (omega["yaw"] + omega["sway"], abs(omega["yaw"] - omega["sway"]))
    tseng = min(abs(t / omega[p] - 1) for t in tones for p in ("in_phase", "out_of_phase"))
    return min(pairs, default=1.0), tseng


@dataclass
class Hung:
    """A plan with its drag, its rig and its small motions."""

    plan: Plan
    drag: tuple
    rig: rb.Rig | None = None
    rest: np.ndarray | None = None
    modes: dict = field(default_factory=dict)
    excited: list = field(default_factory=list)  # names of modes


def hang(rng, hull: Hull, plan: Plan, drag: tuple | None = None) -> Hung:
    """Hang the hull and work out its small motions; without `drag`, it is drawn."""
    hung = Hung(plan, drag or damping(rng, hull))
    if plan.compound:
        hung.excited = ["compound"]
        return hung
    mass, centre, tensor = plan.body(hull)
    # Weights at the ends pitch a hull that hangs free, until its centre is below the points again.
    bow_up, depth = plan.bow_up_rad, plan.depth(hull)
    if plan.added:
        bow_up, depth = -np.arctan2(centre[0], -centre[2]), np.hypot(centre[0], centre[2])
    hung.rig, hung.rest = rb.bifilar(
        mass, tensor, depth, plan.spacing_m, plan.line_m, hull.gravity_m_s2, top_spacing_m=plan.top_spacing_m,
        fore_and_aft=plan.fore_and_aft, bow_up_rad=bow_up, force_damping=hung.drag[0], torque_damping=hung.drag[1],
    )  # fmt: skip
    hung.modes = {m.name: m for m in rb.small_modes(hung.rig, hung.rest, fore_and_aft=plan.fore_and_aft)}
    for motion in plan.excited:
        hung.excited += ["in_phase", "out_of_phase"] if motion == "pitch" else [motion]
    return hung


def acceptable(hung: Hung, nearest: float, tseng: float) -> bool:
    """Whether the excited periods are as far apart as asked, and every motion has a clear name."""
    if hung.plan.compound:
        return True
    near, kane = separations(hung.modes, hung.excited)
    combined = {"yaw", "sway"} <= set(hung.excited)
    clear = all(m.purity > 0.8 for m in hung.modes.values())
    return clear and near >= nearest and (kane >= tseng or not combined)


def possible(tensor: np.ndarray) -> bool:
    """Whether a body may have this tensor."""
    principal = np.linalg.eigvalsh(tensor)
    return principal[0] > 0 and principal[2] < principal[0] + principal[1]


def draw_session(rng, kind: str) -> tuple[Hull, list[Hung]]:
    """A hull and its swings; half the rigs keep 4 % from the Kane-Tseng resonances, nearly all 3 % between periods."""
    tseng = 0.04 if rng.random() < 0.5 else 0.0
    nearest = 0.03 if rng.random() < 0.95 else 0.02
    while True:
        hull = draw_hull(rng, kind == "f")
        hull.attachments = draw_attachments(rng, hull) if kind == "h" else []
        hull.inclines = draw_inclines(rng, hull) if kind == "j" else []
        if not possible(hull.alone()[2]):
            continue
        hungs = [hang(rng, hull, plan) for plan in draw_plans(rng, hull, kind)]
        if all(acceptable(h, nearest, tseng) for h in hungs):
            break
    taped_once = kind in "fj" or rng.random() < 0.6
    phone = draw_phone(rng, hull)
    for h in hungs:
        h.plan.phone = phone if taped_once else draw_phone(rng, hull)
    return hull, hungs


SIZES = {"yaw": (3, 10), "sway": (2, 6), "pitch": (1, 5)}  # degrees, of the hull or of the lines, by motion


def modal_start(rng, hung: Hung, from_rest: bool, sizes: dict = SIZES) -> tuple[np.ndarray, dict]:
    """Displacement and rate (6,) of a start in the modes wanted, with parasites 30 to 45 dB down in energy."""
    line = hung.plan.line_m
    energy, amplitudes = 0.0, {}
    for name in hung.excited:
        shape = hung.modes[name].shape
        point = np.abs(shape[:3] + np.cross(shape[3:], [0, 0, hung.rig.points[2, 0, 0]])).max() / line
        size = {"yaw": abs(shape[5]), "sway": point}.get(name, max(point, np.abs(shape[3:]).max()))
        amplitudes[name] = np.radians(rng.uniform(*sizes.get(name, sizes["pitch"]))) / size
        energy = max(energy, (amplitudes[name] * hung.modes[name].omega_rad_s) ** 2)
    for name, mode in hung.modes.items():
        if name not in amplitudes and rng.random() < 0.7:
            amplitudes[name] = np.sqrt(energy * 10 ** (rng.uniform(-45, -30) / 10)) / mode.omega_rad_s
    move, rate = np.zeros(6), np.zeros(6)
    for name, a in amplitudes.items():
        mode = hung.modes[name]
        phase = rng.choice([0, np.pi]) if from_rest else rng.uniform(0, 2 * np.pi)
        move += a * np.cos(phase) * mode.shape
        rate -= a * np.sin(phase) * mode.omega_rad_s * mode.shape
    return np.concatenate([move, rate]), amplitudes


def simulate(sessions: list[tuple]) -> list[list]:
    """The motions of several sessions (rng, hull, swings), all bifilar swings in one batch."""
    motions = [[None] * len(hungs) for _, _, hungs in sessions]
    batch = []
    for number, (rng, hull, hungs) in enumerate(sessions):
        for i, h in enumerate(hungs):
            story = draw_story(rng, h.plan.duration_s)
            if h.plan.compound:
                motions[number][i] = CompoundMotion(rng, hull, h, story)
                continue
            start, amplitudes = modal_start(rng, h, story.release_s > 0)
            batch.append((number, i, h, story, amplitudes, rb.displaced(h.rest, start[:6], start[6:])))
    fastest = min(m.period_s for _, _, h, *_ in batch for m in h.modes.values())
    longest = max(h.plan.duration_s for _, _, h, *_ in batch) + 1
    rig, start = rb.Rig.stack([b[2].rig for b in batch]), np.concatenate([b[5] for b in batch], 1)
    t, states = rb.integrate(rig, start, longest, min(0.06, fastest / 14))
    for column, (number, i, h, story, amplitudes, _) in enumerate(batch):
        motions[number][i] = BifilarMotion(h, story, amplitudes, t, states[:, :, column])
    return motions


@dataclass
class Story:
    """The recording's course: the hull is held until the release, swings, and may be caught before the end."""

    release_s: float
    caught_s: float  # inf where it swings to the end
    catch_s: float = 0.5

    def clock(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Time along the free motion, its rate and its second derivative."""
        s = np.maximum(t - self.release_s, 0.0)
        rate = (t >= self.release_s).astype(float)
        second = np.zeros_like(s)
        if np.isfinite(self.caught_s):
            u = np.clip((t - self.caught_s) / self.catch_s, 0, 1)
            inside = t > self.caught_s
            fall = u**3 * (10 - 15 * u + 6 * u**2)  # smooth from 0 to 1
            area = u - (2.5 * u**4 - 3 * u**5 + u**6)
            slope = 30 * u**2 * (1 - u) ** 2 / self.catch_s
            s = np.where(inside, self.caught_s - self.release_s + self.catch_s * area, s)
            rate = np.where(inside, 1 - fall, rate)
            second = np.where(inside, -slope, second)
        return s, rate, second


def draw_story(rng, duration_s: float) -> Story:
    """Four in ten recordings begin with the hull held; one in ten ends with it caught."""
    release = rng.uniform(3, 12) if rng.random() < 0.4 else 0.0
    caught = duration_s - rng.uniform(2, 8) if rng.random() < 0.1 else np.inf
    return Story(release, caught)


class BifilarMotion:
    """Rotation rate and acceleration of the hull on its lines at any time."""

    def __init__(self, hung: Hung, story: Story, amplitudes: dict, t: np.ndarray, states: np.ndarray):
        self.hung, self.story, self.amplitudes = hung, story, amplitudes
        self.curve = rb.interpolant(t, states)

    def at(self, t: np.ndarray) -> tuple[np.ndarray, ...]:
        """`world_from_hull`, rate and angular acceleration (hull axes), acceleration of the centre of mass (world)."""
        s, rate, second = self.story.clock(t)
        state = np.ascontiguousarray(self.curve(s).T)
        state[3:7] /= np.sqrt((state[3:7] ** 2).sum(0))
        a, alpha, _ = rb.accelerations(self.hung.rig, state)
        v, w = state[7:10], state[10:]
        return state[3:7], rate * w, rate**2 * alpha + second * w, rate**2 * a + second * v


class CompoundMotion:
    """A pendulum about a fixed horizontal axis through the apexes of two inverted Vs."""

    def __init__(self, rng, hull: Hull, hung: Hung, story: Story):
        plan = hung.plan
        self.hung, self.story = hung, story
        self.arm = plan.axis_height_m + hull.depth_m
        self.axis = np.array([1.0, 0, 0]) if plan.fore_and_aft else np.array([0.0, 1, 0])
        about_centre = self.axis @ hull.inertia() @ self.axis
        about_axis = about_centre + hull.mass_kg * self.arm**2
        self.period_s = 2 * np.pi * np.sqrt(about_axis / (hull.mass_kg * hull.gravity_m_s2 * self.arm))
        self.tau_s = log_uniform(rng, 60, 900)
        stiffness = (2 * np.pi / self.period_s) ** 2
        self.law = lambda t, y: [y[1], -stiffness * np.sin(y[0]) - 2 / self.tau_s * y[1]]
        self.amplitudes = {"compound": np.radians(rng.uniform(2, 6))}
        phase = 0.0 if story.release_s > 0 else rng.uniform(0, 2 * np.pi)
        start = self.amplitudes["compound"] * np.array([np.cos(phase), -np.sin(phase) * np.sqrt(stiffness)])
        self.curve = solve_ivp(
            self.law, (0, plan.duration_s + 1), start, method="DOP853", rtol=1e-11, atol=1e-12, dense_output=True
        ).sol

    def at(self, t: np.ndarray) -> tuple[np.ndarray, ...]:
        """As `BifilarMotion.at`."""
        s, rate, second = self.story.clock(t)
        angle, omega = self.curve(s)
        alpha = np.array(self.law(0, (angle, omega))[1])
        omega, alpha = rate * omega, rate**2 * alpha + second * omega
        q = rb.turn(self.axis[:, None] * angle)
        w, dw = self.axis[:, None] * omega, self.axis[:, None] * alpha
        arm = np.array([[0.0], [0], [-self.arm]]) * np.ones_like(t)
        a = rb.rotate(q, rb.cross(dw, arm) + rb.cross(w, rb.cross(w, arm)))
        return q, w, dw, a


def stamps(rng, rate_hz: float, duration_s: float) -> np.ndarray:
    """True sampling times: a steady rate, a few per cent of jitter."""
    t = rng.uniform(0, 1 / rate_hz) + np.arange(int(duration_s * rate_hz)) / rate_hz
    return np.sort(t + rng.uniform(-0.03, 0.03, t.size) / rate_hz)


def record(rng, hull: Hull, motion, gyro_t: np.ndarray, acc_t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """What gyroscope and accelerometer say at their times: (N, 3) each, phone axes."""
    phone = motion.hung.plan.phone
    _, w, _, _ = motion.at(gyro_t)
    gyro = rb.rotate(phone.phone_from_hull, w) + phone.gyro_bias[:, None]
    q, w, dw, a = motion.at(acc_t)
    _, centre, _ = motion.hung.plan.body(hull)
    arm = (phone.position_m - centre)[:, None] * np.ones_like(acc_t)
    a = a + np.array([[0.0], [0], [hull.gravity_m_s2]])
    force = rb.rotate(rb.conjugate(q), a) + rb.cross(dw, arm) + rb.cross(w, rb.cross(w, arm))
    acc = rb.rotate(phone.phone_from_hull, force) + phone.acc_bias[:, None]
    gyro += rng.normal(0, phone.gyro_noise, gyro.shape)
    acc += rng.normal(0, phone.acc_noise, acc.shape)
    return gyro.T, acc.T


@dataclass(frozen=True)
class Decimals:
    """Decimals written of time, rate and specific force."""

    time: int = 6
    gyro: int = 7
    acc: int = 6


def write_recording(path: Path, phone: Phone, gyro_t, gyro, acc_t, acc, offset_s: float, decimals: Decimals) -> None:
    """CSV; a sensor on a clock of its own leaves the other's cells empty."""
    show = lambda t: f"{t * (1 + phone.clock_error) + offset_s:.{decimals.time}f}"
    rates = lambda row: ",".join(f"{x:.{decimals.gyro}f}" for x in row)
    forces = lambda row: ",".join(f"{x:.{decimals.acc}f}" for x in row)
    if phone.one_clock:
        rows = [f"{show(t)},{rates(g)},{forces(a)}" for t, g, a in zip(gyro_t, gyro, acc)]
    else:
        rows = [(t, f"{show(t)},{rates(g)},,,") for t, g in zip(gyro_t, gyro)]
        rows += [(t, f"{show(t)},,,,{forces(a)}") for t, a in zip(acc_t, acc)]
        rows = [row for _, row in sorted(rows)]
    path.write_text("t,gx,gy,gz,ax,ay,az\n" + "\n".join(rows) + "\n")


def toml_value(value) -> str:
    """Numbers, strings, lists and inline tables."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = {toml_value(v)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    if isinstance(value, str):
        return json.dumps(value)
    return repr(float(value)) if isinstance(value, float) else repr(value)


def toml_table(header: str, values: dict) -> str:
    """A table under its header."""
    return "\n".join([header, *(f"{k} = {toml_value(v)}" for k, v in values.items() if v is not None)]) + "\n"


def session_toml(title: str, hull: Hull, hungs: list[Hung], hints: bool) -> str:
    """The session as its operator wrote it down."""
    gravity = {"value": round(hull.gravity_m_s2, 5), "u": 5e-4}
    parts = [
        f'format = "gyradius-session/1"\ntitle = {toml_value(title)}\n',
        toml_table("[body]", {"name": title.split(":")[0], "mass": {"value": round(hull.mass_kg, 3), "u": round(hull.mass_kg * 5e-4, 4)},
                              "length_overall": round(hull.length_m, 2)}),
        toml_table("[site]", {"gravity": gravity, "air_density": 1.2}),
    ]  # fmt: skip
    for a in hull.attachments:
        body = {"name": a.name, "mass": a.mass_kg, "position": a.position_m.tolist(), "gyradii": a.gyradii_m.tolist()}
        parts.append(toml_table("[[attachment]]", body))
    readings = Readings([h.plan for h in hungs])
    for h in hungs:
        p = h.plan
        added = [{"mass": m, "position": r} for m, r in p.added] or None
        swing = {"id": p.id, "recording": f"{p.id}.csv", "excited": said(p) if hints or p.said else None, "added_mass": added}
        parts.append(toml_table("[[swing]]", swing))
        parts.append(toml_table("[swing.suspension]", readings.suspension(p)))
    for i in hull.inclines:
        weight = {"end": i.end, "mass": {"value": i.mass_kg, "u": round(1e-3 * i.mass_kg, 6)},
                  "arm": {"value": i.arm_m, "u": 0.001}, "depth": {"value": i.depth_m, "u": 0.001},
                  "recording": f"incline-{i.end}.csv"}  # fmt: skip
        parts.append(toml_table("[[incline]]", weight))
    parts += readings.instruments()
    return "\n".join(parts)


class Readings:
    """What the operator read once and wrote down for several swings: a figure is one object then.

    Swings of one hanging say `same_as`; a reading that several hangings share has an instrument, whose zero error is the
    reading's.
    """

    def __init__(self, plans: list[Plan]):
        self.first = {}
        for plan in plans:
            self.first.setdefault(self._hanging(plan), plan)
        users = {}
        for plan in self.first.values():
            for name, figure in self._figures(plan).items():
                users.setdefault(id(figure), []).append((name, figure))
        several = [(key, found[0]) for key, found in users.items() if len(found) > 1]
        self.shared = {key: (f"{name.replace('_', '-')}-{n}", figure) for n, (key, (name, figure)) in enumerate(several, 1)}

    @staticmethod
    def _figures(plan: Plan) -> dict:
        if plan.compound:
            return {}
        named = {"line_length": plan.stated_line, "spacing": plan.stated_spacing, "hull_pitch_deg": plan.stated_pitch}
        return {name: figure for name, figure in named.items() if figure is not None}

    def _hanging(self, plan: Plan) -> tuple:
        figures = tuple((name, id(figure)) for name, figure in self._figures(plan).items())
        return (plan.compound, orientation(plan), figures, repr(plan.extra))

    def suspension(self, plan: Plan) -> dict:
        """The table of a swing's suspension."""
        first = self.first[self._hanging(plan)]
        if first is not plan:
            return {"same_as": first.id}
        written = {"kind": "compound" if plan.compound else "bifilar", "orientation": orientation(plan)}
        for name, figure in self._figures(plan).items():
            shared = self.shared.get(id(figure))
            written[name] = {"value": figure["value"], "u": 0.0, "instrument": shared[0]} if shared else figure
        return written | plan.extra

    def instruments(self) -> list[str]:
        """The tables of the readings that hangings share."""
        return [toml_table("[[instrument]]", {"id": name, "kind": "tape", "zero_u": one["u"]}) for name, one in self.shared.values()]


def orientation(plan: Plan) -> str:
    """The format's word for how the hull hangs."""
    return "fore_and_aft" if plan.fore_and_aft else "athwartships"


def said(plan: Plan) -> list[str]:
    """The operator's words for what was set going."""
    if plan.said:
        return plan.said
    turned = plan.fore_and_aft
    words = {"yaw": ["yaw"], "sway": ["surge" if turned else "sway"], "pitch": ["roll"] if turned else ["surge", "pitch"]}
    if plan.compound:
        return ["roll" if turned else "pitch"]
    return [w for motion in plan.excited for w in words[motion]]


def mode_name(name: str, plan: Plan) -> str:
    """The format's name of a motion."""
    axis = "roll_" if plan.fore_and_aft else "pitch_"
    return axis + name if name in ("in_phase", "out_of_phase") else name


def swing_truth(motion) -> dict:
    """What is true of a swing: dimensions, the small motions, which of them were set going and how far."""
    h, p = motion.hung, motion.hung.plan
    truth = {"excited": [mode_name(n, p) for n in h.excited], "phone_position_m": p.phone.position_m.tolist(),
             "phone_from_hull_wxyz": p.phone.phone_from_hull[:, 0].tolist(), "clock_error": p.phone.clock_error,
             "gyro_noise": p.phone.gyro_noise, "acc_noise": p.phone.acc_noise,
             "release_s": motion.story.release_s,
             "caught_s": motion.story.caught_s if np.isfinite(motion.story.caught_s) else None,
             "hull_pitch_deg": float(np.degrees(p.bow_up_rad)), "wrong_hint": p.said is not None}  # fmt: skip
    if p.compound:
        period = motion.period_s
        damped = period / np.sqrt(1 - (period / (2 * np.pi * motion.tau_s)) ** 2)
        truth |= {"axis_height_m": p.axis_height_m, "modes": {"compound": {
            "period_s": period, "period_damped_s": damped, "decay_time_s": motion.tau_s,
            "amplitude_rad": motion.amplitudes["compound"]}}}  # fmt: skip
        return truth
    near, kane = separations(h.modes, h.excited)
    modes = {}
    for name, m in h.modes.items():
        size = motion.amplitudes.get(name, 0.0) * m.shape
        damped = m.period_s / np.sqrt(1 - (m.period_s / (2 * np.pi * m.decay_time_s)) ** 2)
        modes[mode_name(name, p)] = {
            "period_s": m.period_s, "period_damped_s": damped, "decay_time_s": m.decay_time_s,
            "start_translation_m": size[:3].tolist(), "start_rotation_rad": size[3:].tolist(), "purity": m.purity,
        }  # fmt: skip
    truth |= {"line_length_m": p.line_m, "spacing_m": p.spacing_m, "modes": modes, "period_separation": near,
              "kane_tseng_separation": kane, "depth_below_points_m": -float(h.rest[2, 0]) - p.line_m}  # fmt: skip
    return truth


def write_session(rng, folder: Path, title: str, hull: Hull, motions: list, *, hints: bool, decimals: Decimals = Decimals()) -> None:
    """The folder of a session."""
    folder.mkdir(parents=True, exist_ok=True)
    hungs = [m.hung for m in motions]
    (folder / "session.toml").write_text(session_toml(title, hull, hungs, hints))
    for motion in motions:
        plan = motion.hung.plan
        gyro_t = stamps(rng, plan.phone.gyro_rate_hz, plan.duration_s)
        acc_t = gyro_t if plan.phone.one_clock else stamps(rng, plan.phone.acc_rate_hz, plan.duration_s)
        gyro, acc = record(rng, hull, motion, gyro_t, acc_t)
        offset = rng.uniform(0, 1000) if rng.random() < 0.5 else 0.0
        write_recording(folder / f"{plan.id}.csv", plan.phone, gyro_t, gyro, acc_t, acc, offset, decimals)
    for incline in hull.inclines:
        write_incline(rng, folder, hull, hungs[0].plan.phone, incline, decimals)


def write_incline(rng, folder: Path, hull: Hull, phone: Phone, incline: Incline, decimals: Decimals) -> None:
    """Twenty seconds at rest with the weight on."""
    t = stamps(rng, phone.acc_rate_hz, 20.0)
    world_from_hull = rb.turn(np.array([[0.0], [-incline.bow_up_rad], [0.0]]))
    force = rb.rotate(rb.conjugate(world_from_hull), np.array([[0.0], [0.0], [hull.gravity_m_s2]]))
    acc = (rb.rotate(phone.phone_from_hull, force) + phone.acc_bias[:, None]).T + rng.normal(0, phone.acc_noise, (t.size, 3))
    gyro = phone.gyro_bias + rng.normal(0, phone.gyro_noise, (t.size, 3))
    write_recording(folder / f"incline-{incline.end}.csv", phone, t, gyro, t, acc, 0.0, decimals)


def truth_of(seed, kind: str, hull: Hull, motions: list) -> dict:
    """The truth beside a session."""
    mass, centre, tensor = hull.alone() if hull.attachments else (hull.mass_kg, [0, 0, -hull.depth_m], hull.inertia())
    roll, pitch, yaw = np.sqrt(np.diag(tensor) / mass)
    if not hull.attachments:
        roll, pitch, yaw = hull.k_roll_m, hull.k_pitch_m, hull.k_yaw_m
    psi = 0.5 * np.arctan2(-2 * tensor[0, 2], tensor[2, 2] - tensor[0, 0]) if hull.attachments else hull.psi_rad
    return {
        "seed": seed, "kind": kind, "k_yaw_m": float(yaw), "k_pitch_m": float(pitch), "k_roll_m": float(roll),
        "cm_depth_m": float(-centre[2]), "psi_deg": float(np.degrees(psi)), "mass_kg": hull.mass_kg,
        "length_overall_m": hull.length_m, "beam_m": hull.beam_m, "gravity_m_s2": hull.gravity_m_s2,
        "inertia_kg_m2": tensor.tolist(),
        "compound_axis": next((orientation(m.hung.plan) for m in motions if m.hung.plan.compound), None), "swings": {m.hung.plan.id: swing_truth(m) for m in motions},
    }  # fmt: skip


def fresh_seed() -> int:
    """A seed nobody chose."""
    return secrets.randbits(48)


def test_seed() -> int:
    """The seed of a test: the same in every run, unless ``GYRADIUS_SEED`` is ``random`` or a number."""
    wanted = os.environ.get("GYRADIUS_SEED", "20140101")
    return fresh_seed() if wanted == "random" else int(wanted)


def generate(out: Path, seed: int, count: int, kinds: str = "".join(KINDS)) -> list[str]:
    """Write `count` sessions drawn from the seed; returns their names."""
    names = []
    for first in range(0, count, BATCH):
        drawn = []
        for number in range(first, min(first + BATCH, count)):
            rng, kind = np.random.default_rng([seed, number]), kinds[number % len(kinds)]
            drawn.append((number, kind, rng, *draw_session(rng, kind)))
        swung = simulate([(rng, hull, hungs) for _, _, rng, hull, hungs in drawn])
        for (number, kind, rng, hull, _), motions in zip(drawn, swung):
            name, title = f"{number:03d}-{kind}", f"Blind hull {seed}/{number}"
            write_session(rng, out / name, title, hull, motions, hints=rng.random() < 0.9)
            truth = truth_of([seed, number], kind, hull, motions)
            (out / f"{name}.truth.json").write_text(json.dumps(truth, indent=1))
            names.append(name)
    return names


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--count", type=int, default=7)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--kinds", default="".join(KINDS), help="; ".join(f"{k}: {v}" for k, v in KINDS.items()))
    options = parser.parse_args()
    seed = fresh_seed() if options.seed is None else options.seed
    print(f"seed {seed}")
    for name in generate(options.out, seed, options.count, options.kinds):
        print(options.out / name)


if __name__ == "__main__":
    main()
