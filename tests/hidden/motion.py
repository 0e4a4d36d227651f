"""A hull on two lines with what the simple theory leaves out: equations of motion at finite amplitude.

Newton's and Euler's equations by virtual power, the lines as two constraints (or as springs), steps of fourth order.
Written apart from the analysis and apart from its simulation. Without extras the motion is that of
`tests/blind/rigid_body.py`; the extras are held to closed forms (`test_generator.py`).

# Conventions
World and hull axes: x forward, y to port, z up. State, 24 numbers: centre of the rigid part (world), quaternion w x y z
(`world_from_hull`), velocity of the centre (world), rotation rate (hull), then displacement and speed of two sliders and of the
support (world x, y), and three presliding contacts (along y, about y, about z). Accelerations, ten: centre (hull axes), rotation
(hull axes), sliders, support.
"""

from __future__ import annotations

import numpy as np
from compiled import njit
from forces import (
    CREEP_SPAN,
    RIG,
    add,
    blow,
    contacts,
    cross,
    dot,
    drag,
    entrain,
    rise,
    scale,
    slide,
    strike,
    turned,
    turned_back,
    twist,
    vec,
)  # fmt: skip

STATE, SLIDERS, SUPPORT, CONTACTS = 24, 13, 17, 21  # size, and where the extras begin
OUT = 16  # centre, quaternion, rate (hull), acceleration of the centre (world), angular acceleration (hull)


@njit
def crept(p, t):
    """By how much a line has crept, its rate and its acceleration: by the logarithm of time, or by a power of it."""
    late, n = p.creep[1] + t, p.creep_power
    if n == 0:
        size = p.creep[0] / np.log1p(CREEP_SPAN / p.creep[1])
        return size * np.log(late / p.creep[1]), size / late, -size / late**2
    size = p.creep[0] / ((p.creep[1] + CREEP_SPAN) ** n - p.creep[1] ** n)
    return size * (late**n - p.creep[1] ** n), size * n * late ** (n - 1), size * n * (n - 1) * late ** (n - 2)


@njit
def length(p, i, t):
    """Length of a line at a time, its rate and its acceleration: creep, and a slip."""
    l, dl, ddl = p.line[i], 0.0, 0.0
    if p.creep[0] != 0 and t > 0:
        more, dl, ddl = crept(p, t)
        l += more
    if p.slip[i] != 0:
        s, ds, dds = rise((t - p.slip[2]) / p.slip[3])
        l, dl, ddl = l + p.slip[i] * s, dl + p.slip[i] * ds / p.slip[3], ddl + p.slip[i] * dds / p.slip[3] ** 2
    return l, dl, ddl


@njit
def matrix(y):
    """`world_from_hull`, rows."""
    w, a, b, c = y[3], y[4], y[5], y[6]
    return (
        (1 - 2 * (b * b + c * c), 2 * (a * b - w * c), 2 * (a * c + w * b)),
        (2 * (a * b + w * c), 1 - 2 * (a * a + c * c), 2 * (b * c - w * a)),
        (2 * (a * c - w * b), 2 * (b * c + w * a), 1 - 2 * (a * a + b * b)),
    )


@njit
def solve(m, n, b):
    """Cholesky of the symmetric m in place, then its solutions for the rows of b in place."""
    for j in range(n):
        for i in range(j, n):
            total = m[i, j]
            for k in range(j):
                total -= m[i, k] * m[j, k]
            m[i, j] = np.sqrt(total) if i == j else total / m[j, j]
    for row in range(b.shape[0]):
        for i in range(n):
            for k in range(i):
                b[row, i] -= m[i, k] * b[row, k]
            b[row, i] /= m[i, i]
        for i in range(n - 1, -1, -1):
            for k in range(i + 1, n):
                b[row, i] -= m[k, i] * b[row, k]
            b[row, i] /= m[i, i]


@njit
def line_vector(p, y, r, i):
    """From the upper to the lower end of a line, world axes."""
    d = add(add(vec(y), turned(r, vec(p.point[i]))), scale(-1.0, vec(p.anchor[i])))
    return (d[0] - y[SUPPORT], d[1] - y[SUPPORT + 2], d[2])


@njit
def pull(p, y, r, i, jac):
    """Row of the constraint d·d'/dt = l l' against the ten speeds; returns d (world)."""
    d = line_vector(p, y, r, i)
    in_hull = turned_back(r, d)
    arm = cross(vec(p.point[i]), in_hull)
    for k in range(3):
        jac[k], jac[3 + k] = in_hull[k], arm[k]
    yields = p.support[0] != 0
    jac[6], jac[7], jac[8], jac[9] = 0.0, 0.0, -d[0] if yields else 0.0, -d[1] if yields else 0.0
    return d


@njit
def size(p):
    """How many accelerations are to be solved for."""
    return 10 if p.slider_mass[0] != 0 or p.support[0] != 0 else 6


@njit
def assemble(p, t, y, r, m, f, dz):
    """Inertia and forces of everything but the lines."""
    m[:], f[:], dz[:] = 0.0, 0.0, 0.0
    v, w = turned_back(r, vec(y[7:10])), vec(y[10:13])
    spin = cross(w, (dot(vec(p.inertia[0]), w), dot(vec(p.inertia[1]), w), dot(vec(p.inertia[2]), w)))
    for i in range(3):
        m[i, i] = p.mass
        f[i] = -p.mass * p.gravity * r[2][i]
        f[3 + i] = -spin[i]
        for j in range(3):
            m[3 + i, 3 + j] = p.inertia[i, j]
    drag(p, v, w, f)
    blow(p, t, r, v, f)
    strike(p, t, r, f)
    twist(p, r, w, f)
    contacts(p, y[CONTACTS:], v, w, f, dz)
    entrain(p, y[1], r, v, w, m)
    for k in range(2):
        if p.slider_mass[k] != 0:
            slide(p, k, y[SLIDERS + 2 * k], y[SLIDERS + 2 * k + 1], r, w, m, f)
        else:
            m[6 + k, 6 + k] = 1.0
        m[8 + k, 8 + k] = p.support[0] if p.support[0] != 0 else 1.0
        f[8 + k] = -p.support[1] * y[SUPPORT + 2 * k] - p.support[2] * y[SUPPORT + 2 * k + 1]


@njit
def accelerations(p, t, y, m, b, dz):
    """The ten accelerations in b[0]; b is (3, 10) working space, as is m (10, 10)."""
    r, w, n = matrix(y), vec(y[10:13]), size(p)
    f = b[0]
    assemble(p, t, y, r, m, f, dz)
    j = np.empty((2, 10))
    wanted = np.empty(2)
    for i in range(2):
        point = vec(p.point[i])
        d = pull(p, y, r, i, j[i])
        rate = add(vec(y[7:10]), turned(r, cross(w, point)))
        rate = (rate[0] - y[SUPPORT + 1], rate[1] - y[SUPPORT + 3], rate[2])
        if p.stiffness != 0:
            l = np.sqrt(dot(d, d))
            tension = p.stiffness * (l - p.natural[i]) + p.line_damping * dot(d, rate) / l
            for k in range(10):
                f[k] -= tension / l * j[i, k]
        l, dl, ddl = length(p, i, t)
        wanted[i] = dl * dl + l * ddl - dot(rate, rate) - dot(turned_back(r, d), cross(w, cross(w, point)))
    if p.stiffness != 0:
        solve(m, n, b[:1])
        return
    b[1], b[2] = j[0], j[1]
    solve(m, n, b)
    g00, g01, g11, e0, e1 = 0.0, 0.0, 0.0, wanted[0], wanted[1]
    for k in range(n):
        g00, g01, g11 = g00 + j[0, k] * b[1, k], g01 + j[0, k] * b[2, k], g11 + j[1, k] * b[2, k]
        e0, e1 = e0 - j[0, k] * b[0, k], e1 - j[1, k] * b[0, k]
    det = g00 * g11 - g01 * g01
    first, second = (g11 * e0 - g01 * e1) / det, (g00 * e1 - g01 * e0) / det
    for k in range(n):
        b[0, k] += first * b[1, k] + second * b[2, k]


@njit
def derivative(p, t, y, dy, m, b, dz):
    """Time derivative of the state."""
    accelerations(p, t, y, m, b, dz)
    w, r = vec(y[10:13]), matrix(y)
    acceleration = turned(r, vec(b[0]))
    dy[3] = -0.5 * (y[4] * w[0] + y[5] * w[1] + y[6] * w[2])
    turn = add(scale(y[3], w), cross(vec(y[4:7]), w))
    for i in range(3):
        dy[i], dy[4 + i], dy[7 + i], dy[10 + i] = y[7 + i], 0.5 * turn[i], acceleration[i], b[0, 3 + i]
        dy[CONTACTS + i] = dz[i]
    for k in range(4):  # two sliders, two directions of the support
        moves = (k < 2 and p.slider_mass[k % 2] != 0) or (k >= 2 and p.support[0] != 0)
        dy[SLIDERS + 2 * k] = y[SLIDERS + 2 * k + 1] if moves else 0.0
        dy[SLIDERS + 2 * k + 1] = b[0, 6 + k] if moves else 0.0


@njit
def normalise(y):
    """A unit quaternion."""
    norm = np.sqrt(y[3] ** 2 + y[4] ** 2 + y[5] ** 2 + y[6] ** 2)
    for i in range(4):
        y[3 + i] /= norm


@njit
def correct(p, t, y, m, b, dz, speeds):
    """Put the state (or its speeds) back on the lines, by the smallest move in the sense of the kinetic energy."""
    r, n = matrix(y), size(p)
    assemble(p, t, y, r, m, b[0], dz)
    j, e = np.empty((2, 10)), np.empty(2)
    for i in range(2):
        d = pull(p, y, r, i, j[i])
        l, dl, _ = length(p, i, t)
        e[i] = l * dl if speeds else 0.5 * (l * l - dot(d, d))
        if speeds:
            v = turned_back(r, vec(y[7:10]))
            for k in range(3):
                e[i] -= j[i, k] * v[k] + j[i, 3 + k] * y[10 + k]
            e[i] -= j[i, 8] * y[SUPPORT + 1] + j[i, 9] * y[SUPPORT + 3]
    b[1], b[2] = j[0], j[1]
    solve(m, n, b[1:])
    g00, g01, g11 = 0.0, 0.0, 0.0
    for k in range(n):
        g00, g01, g11 = g00 + j[0, k] * b[1, k], g01 + j[0, k] * b[2, k], g11 + j[1, k] * b[2, k]
    det = g00 * g11 - g01 * g01
    first, second = (g11 * e[0] - g01 * e[1]) / det, (g00 * e[1] - g01 * e[0]) / det
    for k in range(n):
        b[0, k] = first * b[1, k] + second * b[2, k]
    move = turned(r, vec(b[0]))
    at = 7 if speeds else 0
    for i in range(3):
        y[at + i] += move[i]
        if speeds:
            y[10 + i] += b[0, 3 + i]
    for k in range(6, n):
        y[SLIDERS + 2 * (k - 6) + (1 if speeds else 0)] += b[0, k]
    if not speeds:
        half = scale(0.5, vec(b[0, 3:6]))
        q = vec(y[4:7])
        q0 = y[3]
        y[3] = q0 - dot(q, half)
        q = add(add(q, scale(q0, half)), cross(q, half))
        y[4], y[5], y[6] = q[0], q[1], q[2]
        normalise(y)


@njit
def settle(p, t, y, m, b, dz, rounds):
    """Onto the lines, which hold their length."""
    for _ in range(rounds):
        correct(p, t, y, m, b, dz, False)
    correct(p, t, y, m, b, dz, True)


@njit
def swing(rig, start, begin_s, times_s, longest_step_s):
    """The motion (N, OUT) at increasing times after `begin_s`, from a start (STATE,) then."""
    p, y, t = rig[0], start.copy(), begin_s
    out = np.empty((times_s.size, OUT))
    k, dy, at = np.empty((4, STATE)), np.empty(STATE), np.empty(STATE)
    m, b, dz = np.empty((10, 10)), np.empty((3, 10)), np.empty(3)
    settle(p, t, y, m, b, dz, 6)  # springs begin at the length that they have at rest
    for sample in range(times_s.size):
        steps = int(np.ceil((times_s[sample] - t) / longest_step_s))
        h = (times_s[sample] - t) / max(steps, 1)
        for _ in range(steps):
            derivative(p, t, y, k[0], m, b, dz)
            at[:] = y + 0.5 * h * k[0]
            derivative(p, t + 0.5 * h, at, k[1], m, b, dz)
            at[:] = y + 0.5 * h * k[1]
            derivative(p, t + 0.5 * h, at, k[2], m, b, dz)
            at[:] = y + h * k[2]
            derivative(p, t + h, at, k[3], m, b, dz)
            y += h / 6 * (k[0] + 2 * k[1] + 2 * k[2] + k[3])
            t += h
            if p.stiffness == 0:
                settle(p, t, y, m, b, dz, 1)
            normalise(y)
        t = times_s[sample]
        derivative(p, t, y, dy, m, b, dz)
        out[sample, :7], out[sample, 7:10] = y[:7], y[10:13]
        out[sample, 10:13], out[sample, 13:16] = dy[7:10], dy[10:13]
    return out


def blank() -> np.ndarray:
    """A rig with every effect off, (1,)."""
    return np.zeros(1, RIG)
