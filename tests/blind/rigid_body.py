"""A rigid body on two inextensible lines, in three dimensions, at finite amplitude.

Written from Newton's and Euler's equations alone; it shares no code and no closed form with the analysis it tests.
MuJoCo, which nobody here wrote, is its witness (`test_rigid_body.py`).

# Conventions
World and hull axes: x forward, y to port, z up. State, 13 rows, one column per body of a batch: position of the
centre of mass (world), quaternion w, x, y, z (`world_from_hull`), velocity (world), rotation rate (hull axes).
A hull pitched bow up by `phi` is turned by *minus* `phi` about +y. Angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as dop853
from scipy.interpolate import make_interp_spline
from scipy.linalg import eigh, null_space

YAW, SWAY, IN_PHASE, OUT_OF_PHASE = "yaw", "sway", "in_phase", "out_of_phase"


@dataclass
class Rig:
    """A batch of bodies, each on its two lines; every array ends in the batch axis."""

    mass_kg: np.ndarray  # (B,)
    inertia_kg_m2: np.ndarray  # (3, 3, B), hull axes, about the centre of mass
    point_hull_m: np.ndarray  # (2, 3, B): suspension points from the centre of mass, hull axes
    anchor_m: np.ndarray  # (2, 3, B): upper ends of the lines, world axes
    line_m: np.ndarray  # (2, B)
    gravity_m_s2: np.ndarray  # (B,)
    force_damping_n_s_m: np.ndarray  # (3, B), hull axes, at the centre of mass
    torque_damping_n_m_s: np.ndarray  # (3, B), hull axes
    inverse_inertia: np.ndarray = field(init=False, repr=False)
    points: np.ndarray = field(init=False, repr=False)  # (3, 2, B)
    anchors: np.ndarray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.inverse_inertia = np.moveaxis(np.linalg.inv(np.moveaxis(self.inertia_kg_m2, -1, 0)), 0, -1)
        self.points = np.ascontiguousarray(np.swapaxes(self.point_hull_m, 0, 1))
        self.anchors = np.ascontiguousarray(np.swapaxes(self.anchor_m, 0, 1))

    def single(self, index: int) -> "Rig":
        """The rig of one body of the batch."""
        return Rig(**{f.name: getattr(self, f.name)[..., index : index + 1] for f in fields(self) if f.init})

    @staticmethod
    def stack(rigs: list["Rig"]) -> "Rig":
        """One batch of several."""
        return Rig(
            **{f.name: np.concatenate([getattr(r, f.name) for r in rigs], -1) for f in fields(Rig) if f.init}
        )


def bifilar(
    mass_kg: float,
    inertia_kg_m2: np.ndarray,
    depth_m: float,
    spacing_m: float,
    line_m: float,
    gravity_m_s2: float = 9.80665,
    *,
    top_spacing_m: float | None = None,
    fore_and_aft: bool = False,
    bow_up_rad: float = 0.0,
    force_damping: tuple = (0.0, 0.0, 0.0),
    torque_damping: tuple = (0.0, 0.0, 0.0),
) -> tuple[Rig, np.ndarray]:
    """A rig and its state of rest. `depth_m` is the vertical distance of the centre of mass below the points."""
    along = np.array([1.0, 0, 0]) if fore_and_aft else np.array([0.0, 1, 0])
    half, top_half = spacing_m / 2, (top_spacing_m or spacing_m) / 2
    drop = np.sqrt(line_m**2 - (top_half - half) ** 2)
    rest_turn = turn(np.array([[0.0], [-bow_up_rad], [0.0]]))
    points = np.array([half * along + [0, 0, depth_m], -half * along + [0, 0, depth_m]])
    in_hull = np.array([rotate(conjugate(rest_turn), p[:, None])[:, 0] for p in points])
    anchors = np.array([top_half * along, -top_half * along])
    column = lambda values: np.asarray(values, float)[..., None]
    rig = Rig(
        column(mass_kg), column(inertia_kg_m2), column(in_hull), column(anchors), column([line_m, line_m]),
        column(gravity_m_s2), column(force_damping), column(torque_damping),
    )  # fmt: skip
    state = np.concatenate([[[0.0], [0.0], [-drop - depth_m]], rest_turn, np.zeros((6, 1))])
    return rig, state


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Vector product of arrays whose first axis is the component."""
    a0, a1, a2 = a
    b0, b1, b2 = b
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    np.subtract(a1 * b2, a2 * b1, out=out[0])
    np.subtract(a2 * b0, a0 * b2, out=out[1])
    np.subtract(a0 * b1, a1 * b0, out=out[2])
    return out


def conjugate(q: np.ndarray) -> np.ndarray:
    """The inverse of a unit quaternion."""
    return q * np.array([1.0, -1, -1, -1])[:, None]


def product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Quaternion product: first `q`, then `p`."""
    return np.concatenate(
        [(p[0] * q[0] - (p[1:] * q[1:]).sum(0))[None], p[0] * q[1:] + q[0] * p[1:] + cross(p[1:], q[1:])]
    )


def rotate(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """A vector in world axes from hull axes."""
    twice = 2 * cross(q[1:], v)
    return v + q[0] * twice + cross(q[1:], twice)


def turn(rotation_vector: np.ndarray) -> np.ndarray:
    """Quaternion of a rotation vector, rad."""
    angle = np.sqrt((rotation_vector**2).sum(0))
    return np.concatenate([np.cos(angle / 2)[None], rotation_vector * np.sinc(angle / (2 * np.pi)) / 2])


def rotation_vector(q: np.ndarray) -> np.ndarray:
    """Rotation vector of a quaternion, rad."""
    q = np.where(q[0] < 0, -q, q)
    sine = np.sqrt((q[1:] ** 2).sum(0))
    return q[1:] * np.where(sine > 1e-12, 2 * np.arctan2(sine, q[0]) / np.maximum(sine, 1e-300), 2.0)


def matrix(q: np.ndarray) -> np.ndarray:
    """Rotation matrices (3, 3, B), `world_from_hull`."""
    w, x, y, z = q
    wx, wy, wz, xx, xy, xz, yy, yz, zz = w * x, w * y, w * z, x * x, x * y, x * z, y * y, y * z, z * z
    return np.array(
        [
            [1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy)],
            [2 * (xy + wz), 1 - 2 * (xx + zz), 2 * (yz - wx)],
            [2 * (xz - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)],
        ]
    )


def apply(m: np.ndarray, v: np.ndarray) -> np.ndarray:
    """(3, 3, B) times (3, …, B)."""
    return np.einsum("ijb,j...b->i...b", m, v)


def unapply(m: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Transpose of (3, 3, B) times (3, …, B)."""
    return np.einsum("jib,j...b->i...b", m, v)


@dataclass
class _Lines:
    """Both lines at one state: vectors (3, 2, B), world; arms of their pull, hull axes; and their 2 x 2 inertia."""

    turn: np.ndarray
    line: np.ndarray
    arm: np.ndarray
    turned: np.ndarray
    g: np.ndarray  # (2, 2, B)

    def multipliers(self, wanted: np.ndarray) -> np.ndarray:
        """(2, B) multipliers that change the constraints' rates by `wanted` (2, B)."""
        g = self.g
        determinant = g[0, 0] * g[1, 1] - g[0, 1] * g[1, 0]
        return np.stack([g[1, 1] * wanted[0] - g[0, 1] * wanted[1], g[0, 0] * wanted[1] - g[1, 0] * wanted[0]]) / determinant


def _lines(rig: Rig, p: np.ndarray, q: np.ndarray) -> _Lines:
    to_world = matrix(q)
    line = p[:, None] + apply(to_world, rig.points) - rig.anchors
    arm = cross(rig.points, unapply(to_world, line))
    turned = apply(rig.inverse_inertia, arm)
    g = np.einsum("kib,kjb->ijb", line, line) / rig.mass_kg + np.einsum("kib,kjb->ijb", arm, turned)
    return _Lines(to_world, line, arm, turned, g)


def accelerations(rig: Rig, state: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Acceleration of the centre of mass (world), angular acceleration (hull axes), tensions (2, B), N."""
    p, q, v, w = state[:3], state[3:7], state[7:10], state[10:]
    lines = _lines(rig, p, q)
    force = -apply(lines.turn, rig.force_damping_n_s_m * unapply(lines.turn, v))
    force[2] -= rig.mass_kg * rig.gravity_m_s2
    torque = -rig.torque_damping_n_m_s * w - cross(w, apply(rig.inertia_kg_m2, w))
    free_v, free_w = force / rig.mass_kg, apply(rig.inverse_inertia, torque)
    w2 = w[:, None]
    spin = cross(w2, rig.points)
    speed = v[:, None] + apply(lines.turn, spin)
    free = free_v[:, None] + apply(lines.turn, cross(free_w[:, None], rig.points) + cross(w2, spin))
    lam = lines.multipliers(-((speed**2).sum(0) + (lines.line * free).sum(0)))  # |d|²/2 keeps its value
    acceleration = free_v + (lam * lines.line).sum(1) / rig.mass_kg
    angular = free_w + (lam * lines.turned).sum(1)
    return acceleration, angular, -lam * rig.line_m


def derivative(rig: Rig, state: np.ndarray) -> np.ndarray:
    """Time derivative of the state."""
    q, w = state[3:7], state[10:]
    out = np.empty_like(state)
    out[:3] = state[7:10]
    out[3] = -0.5 * (q[1:] * w).sum(0)
    out[4:7] = 0.5 * (q[0] * w + cross(q[1:], w))
    out[7:10], out[10:], _ = accelerations(rig, state)
    return out


def project(rig: Rig, state: np.ndarray, rounds: int = 1) -> np.ndarray:
    """Put the state back on the constraints, by the smallest move in the sense of the kinetic energy."""
    state = state.copy()
    state[3:7] /= np.sqrt((state[3:7] ** 2).sum(0))
    for _ in range(rounds):
        lines = _lines(rig, state[:3], state[3:7])
        lam = lines.multipliers((rig.line_m**2 - (lines.line**2).sum(0)) / 2)
        state[:3] += (lam * lines.line).sum(1) / rig.mass_kg
        state[3:7] = product(state[3:7], turn((lam * lines.turned).sum(1)))
    lines = _lines(rig, state[:3], state[3:7])
    lam = lines.multipliers(-((lines.line * state[7:10, None]).sum(0) + (lines.arm * state[10:, None]).sum(0)))
    state[7:10] += (lam * lines.line).sum(1) / rig.mass_kg
    state[10:] += (lam * lines.turned).sum(1)
    return state


def integrate(rig: Rig, state: np.ndarray, duration_s: float, step_s: float = 0.04) -> tuple[np.ndarray, np.ndarray]:
    """Times (N,) and states (N, 13, B): eighth-order steps (Dormand-Prince) of fixed length, projected."""
    stages = dop853.N_STAGES
    steps = int(np.ceil(duration_s / step_s))
    state = project(rig, state, rounds=3)
    out = np.empty((steps + 1, *state.shape))
    out[0] = state
    slopes = np.empty((stages, *state.shape))
    flat = slopes.reshape(stages, -1)
    for n in range(steps):
        for s in range(stages):
            increment = (dop853.A[s, :s] @ flat[:s]).reshape(state.shape) if s else 0.0
            slopes[s] = derivative(rig, state + step_s * increment)
        state = project(rig, state + step_s * (dop853.B @ flat).reshape(state.shape))
        out[n + 1] = state
    return np.arange(steps + 1) * step_s, out


def interpolant(t_s: np.ndarray, states: np.ndarray):
    """A function of time through the states (N, 13): quintic spline."""
    return make_interp_spline(t_s, states, k=5)


@dataclass
class Mode:
    """A small free motion about rest."""

    name: str  # yaw, sway, in_phase, out_of_phase
    omega_rad_s: float  # undamped
    period_s: float  # undamped
    decay_time_s: float
    shape: np.ndarray  # (6,): translation (m, world), rotation vector (rad, world axes at rest), of unit kinetic mass
    purity: float  # share of the kinetic energy in the motion that names it


def small_modes(rig: Rig, rest: np.ndarray, *, fore_and_aft: bool = False) -> list[Mode]:
    """The four small motions of the first body of the batch, from the second variation of the energy at rest."""
    rig = rig.single(0)
    q = rest[3:7, :1]
    inertia = matrix(q)[..., 0] @ rig.inertia_kg_m2[..., 0] @ matrix(q)[..., 0].T
    mass = np.zeros((6, 6))
    mass[:3, :3] = rig.mass_kg[0] * np.eye(3)
    mass[3:, 3:] = inertia
    damping = np.zeros((6, 6))
    damping[:3, :3] = matrix(q)[..., 0] @ np.diag(rig.force_damping_n_s_m[:, 0]) @ matrix(q)[..., 0].T
    damping[3:, 3:] = matrix(q)[..., 0] @ np.diag(rig.torque_damping_n_m_s[:, 0]) @ matrix(q)[..., 0].T
    _, _, tension = accelerations(rig, rest[:, :1])
    jacobian, stiffness = np.zeros((2, 6)), np.zeros((6, 6))
    for i in (0, 1):
        r = rotate(q, rig.point_hull_m[i])[:, 0]
        d = rest[:3, 0] + r - rig.anchor_m[i, :, 0]
        map_ = np.hstack([np.eye(3), -_skew(r)])  # displacement of the point
        jacobian[i] = d @ map_
        bend = np.zeros((6, 6))  # d . (half the squared rotation) r
        bend[3:, 3:] = (np.outer(d, r) + np.outer(r, d)) / 2 - (d @ r) * np.eye(3)
        stiffness += tension[i, 0] / rig.line_m[i, 0] * (map_.T @ map_ + bend)
    free = null_space(jacobian)
    values, vectors = eigh(free.T @ stiffness @ free, free.T @ mass @ free)
    shapes = (free @ vectors).T
    shapes *= np.sign([shape[np.argmax(np.abs(shape))] for shape in shapes])[:, None]  # eigh leaves the sign open
    along = 0 if fore_and_aft else 1
    share = {YAW: [], SWAY: []}
    for shape in shapes:
        kinetic = shape * (mass @ shape)
        share[YAW].append(kinetic[5])
        share[SWAY].append(kinetic[along])
    yaw = int(np.argmax(share[YAW]))
    sway = int(np.argmax([s if k != yaw else -1 for k, s in enumerate(share[SWAY])]))
    names = {yaw: (YAW, share[YAW][yaw]), sway: (SWAY, share[SWAY][sway])}
    rest_of = [k for k in range(4) if k not in names]  # eigh: ascending frequency
    for k, name in zip(rest_of, (IN_PHASE, OUT_OF_PHASE)):
        names[k] = (name, 1 - share[YAW][k] - share[SWAY][k])
    modes = []
    for k in range(4):
        omega = float(np.sqrt(values[k]))
        loss = float(shapes[k] @ damping @ shapes[k])
        modes.append(Mode(names[k][0], omega, 2 * np.pi / omega, 2 / loss if loss > 0 else np.inf, shapes[k], names[k][1]))
    return modes


def displaced(rest: np.ndarray, move: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """The state of rest moved by a small translation and rotation (6,) and given their rates (6,), world axes."""
    state = rest.copy()
    state[:3, 0] += move[:3]
    state[3:7] = product(turn(move[3:, None]), rest[3:7])
    state[7:10, 0] = rate[:3]
    state[10:] = rotate(conjugate(state[3:7]), rate[3:, None])
    return state


def _skew(r: np.ndarray) -> np.ndarray:
    return np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])
