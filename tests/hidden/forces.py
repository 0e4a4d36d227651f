"""What acts on a hull beside its lines: drag, friction, wind, knocks, twisted lines, air and water that move along.

Called by `motion.py` at every stage of a step. Vectors are tuples of three, matrices tuples of rows; `f` gathers generalised
forces and `m` inertia, in the order of `motion.py`.
"""

from __future__ import annotations

import numpy as np
from compiled import inlined, njit

F8 = np.float64
BREEZE_SIZE = 1264  # wind samples of a swing: 632 s in steps of half a second
BREEZE_FROM_S = -8.0
# One swing's rig. A field left at zero switches its effect off.
RIG = np.dtype(
    [
        ("mass", F8),  # kg, the rigid part
        ("inertia", F8, (3, 3)),  # kg m2, about its centre
        ("gravity", F8),  # m/s2
        ("point", F8, (2, 3)),  # m, lower ends of the lines from the centre, hull axes
        ("anchor", F8, (2, 3)),  # m, upper ends, world axes
        ("line", F8, 2),  # m, when the recording begins
        ("linear", F8, 6),  # N s/m and N m s by hull axis
        ("quadratic", F8, 6),  # N s2/m2 and N m s2: -q v √(v² + crossover²)
        ("crossover", F8, 6),  # m/s and rad/s: drag is linear well below, quadratic well above
        ("power", F8, 6),  # N and N m at POWER_REFERENCE (m/s, rad/s): -p |v/v0|^n sign v
        ("exponent", F8),
        ("coulomb", F8, 6),  # N and N m: -c tanh(v / SLIDING) (1 + dip exp(-(v / dip_speed)²))
        ("dip", F8),  # Stribeck: by how much slow sliding holds more than fast
        ("dip_speed", F8, 6),  # m/s and rad/s
        ("contact", F8, 3),  # N, N m, N m: Dahl's friction along y, about y, about z once it slides
        ("contact_give", F8, 3),  # m, rad, rad: displacement over which it begins to slide
        ("added", F8, 3),  # kg/m, kg m2/rad, kg m2/rad: inertia along y, about y, about z, per amplitude
        ("added_omega", F8, 3),  # rad/s: turns a rate into an amplitude
        ("torsion", F8),  # N m/rad, both lines together
        ("torsion_cubic", F8),  # N m/rad3
        ("torsion_one_sided", F8),  # N m/rad, at positive headings only
        ("rub", F8, 2),  # N m, and the heading (rad) beyond which it rubs
        ("creep", F8, 2),  # m in CREEP_SPAN, and its time constant (with a power: the time since loading), s
        ("creep_power", F8),  # exponent of the time since loading; zero: logarithmic
        ("slip", F8, 4),  # m by line; when, and how long it takes, s
        ("stiffness", F8),  # N/m of each line; zero: inextensible
        ("line_damping", F8),  # N s/m
        ("natural", F8, 2),  # m, unloaded
        ("support", F8, 3),  # kg, N/m, N s/m of the beam that holds both anchors
        ("slider_mass", F8, 2),
        ("slider_place", F8, (2, 3)),  # m, at rest, from the centre of the rigid part
        ("slider_way", F8, (2, 3)),  # unit vector, hull axes
        ("slider_rod", F8, 2),  # m; not zero: a pendulum of this length that swings in the plane of the way and hull z
        ("slider_spring", F8, 2),
        ("slider_damping", F8, 2),
        ("slider_start", F8, (2, 2)),  # m and m/s at the release
        ("wind_area", F8, 2),  # m2, drag area to wind along hull x and along hull y
        ("wind_arm", F8),  # m, centre of pressure forward of the centre of mass
        ("wind", F8, 2),  # m/s, mean, world
        ("gust", F8, (4, 3)),  # share of the mean, rad/s, phase
        ("breeze", F8, (BREEZE_SIZE, 2)),  # m/s on top of the mean, world, at even times from BREEZE_FROM_S on
        ("breeze_step", F8),  # s
        ("knock", F8, 3),  # N s, world
        ("knock_arm", F8, 3),  # m, hull
        ("knock_time", F8, 2),  # s: when, and how long
    ]
)
AIR = 1.2  # kg/m3
POWER_REFERENCE = 0.1
SLIDING = 5e-4  # m/s and rad/s: a Coulomb contact is viscous below
CREEP_SPAN = 120.0
EDGE = 1e-3  # rad over which a rubbing rope takes hold


@inlined
def vec(a):
    return (a[0], a[1], a[2])


@inlined
def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@inlined
def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inlined
def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


@inlined
def scale(s, a):
    return (s * a[0], s * a[1], s * a[2])


@inlined
def turned(m, v):
    """Matrix times vector."""
    return (dot(m[0], v), dot(m[1], v), dot(m[2], v))


@inlined
def turned_back(m, v):
    """Transpose times vector."""
    return add(add(scale(v[0], m[0]), scale(v[1], m[1])), scale(v[2], m[2]))


@njit
def rise(x):
    """From 0 to 1 with two continuous derivatives: value, slope, curvature."""
    if x <= 0 or x >= 1:
        return (0.0 if x <= 0 else 1.0), 0.0, 0.0
    return x**3 * (10 - 15 * x + 6 * x * x), 30 * x * x * (1 - x) ** 2, 60 * x * (1 - x) * (1 - 2 * x)


@njit
def push(f, force, arm):
    """A force on the hull at an arm from the centre, both in hull axes."""
    torque = cross(arm, force)
    for i in range(3):
        f[i] += force[i]
        f[3 + i] += torque[i]


@njit
def drag(p, v, w, f):
    """Linear, quadratic, power-law and Coulomb, each hull axis by itself."""
    for i in range(6):
        u = v[i] if i < 3 else w[i - 3]
        f[i] -= p.linear[i] * u + p.quadratic[i] * np.sqrt(u * u + p.crossover[i] ** 2) * u
        if p.power[i] != 0:
            f[i] -= p.power[i] * abs(u / POWER_REFERENCE) ** p.exponent * np.sign(u)
        if p.coulomb[i] != 0:
            hold = 1.0 + p.dip * np.exp(-((u / p.dip_speed[i]) ** 2)) if p.dip != 0 else 1.0
            f[i] -= p.coulomb[i] * hold * np.tanh(u / SLIDING)


@njit
def breeze(p, t, way):
    """Wind on top of the mean: a Catmull-Rom cubic through its samples."""
    if p.breeze_step == 0:
        return 0.0
    x = (t - BREEZE_FROM_S) / p.breeze_step
    i = min(max(int(x), 1), BREEZE_SIZE - 3)
    u = x - i
    a, b, c, d = p.breeze[i - 1, way], p.breeze[i, way], p.breeze[i + 1, way], p.breeze[i + 2, way]
    return b + 0.5 * u * (c - a + u * (2 * a - 5 * b + 4 * c - d + u * (3 * (b - c) + d - a)))


@njit
def blow(p, t, r, v, f):
    """Wind's drag over that of still air, ½ ρ C A (|u| u + |v| v), u being the wind as the hull meets it."""
    if p.wind_area[1] == 0:
        return
    gust = 1.0
    for k in range(4):
        gust += p.gust[k, 0] * np.sin(p.gust[k, 1] * t + p.gust[k, 2])
    air = turned_back(r, (gust * p.wind[0] + breeze(p, t, 0), gust * p.wind[1] + breeze(p, t, 1), 0.0))
    ux, uy = air[0] - v[0], air[1] - v[1]
    along = 0.5 * AIR * p.wind_area[0] * (abs(ux) * ux + abs(v[0]) * v[0])
    abeam = 0.5 * AIR * p.wind_area[1] * (abs(uy) * uy + abs(v[1]) * v[1])
    push(f, (along, abeam, 0.0), (p.wind_arm, 0.0, 0.0))


@njit
def strike(p, t, r, f):
    """A knock: half a sine of force that carries the impulse."""
    if p.knock_time[1] == 0:
        return
    x = (t - p.knock_time[0]) / p.knock_time[1]
    if 0 < x < 1:
        size = 0.5 * np.pi / p.knock_time[1] * np.sin(np.pi * x)
        push(f, turned_back(r, scale(size, vec(p.knock))), vec(p.knock_arm))


@njit
def heading(r):
    """Turn about the vertical, rad."""
    return np.arctan2(r[1][0] - r[0][1], r[0][0] + r[1][1])


@njit
def twist(p, r, w, f):
    """What resists the heading: lines that twist, springs that harden or hold one side, a rope that rubs on one side."""
    psi = heading(r)
    torque = -p.torsion * psi - p.torsion_cubic * psi**3 - p.torsion_one_sided * max(psi, 0.0)
    if p.rub[0] != 0:
        hold = rise((psi * np.sign(p.rub[1]) - abs(p.rub[1])) / EDGE + 0.5)[0]
        torque -= p.rub[0] * hold * np.tanh(w[2] / SLIDING)
    for i in range(3):
        f[3 + i] += torque * r[2][i]


@njit
def contacts(p, z, v, w, f, dz):
    """Dahl's presliding friction: dz/dt = u - |u| z / give, force contact z / give."""
    for k in range(3):
        if p.contact[k] != 0:
            u = v[1] if k == 0 else w[k]
            share = z[k] / p.contact_give[k]
            dz[k] = u - abs(u) * share
            f[1 if k == 0 else 3 + k] -= p.contact[k] * share


@njit
def entrain(p, along, r, v, w, m):
    """Air that moves along: inertia in proportion to the amplitude √(q² + (q'/ω)²) of each motion."""
    if p.added_omega[2] == 0:
        return
    pitch, psi = np.arcsin(-r[2][0]), heading(r)
    m[1, 1] += p.added[0] * np.hypot(along, v[1] / p.added_omega[0])
    m[4, 4] += p.added[1] * np.hypot(pitch, w[1] / p.added_omega[1])
    m[5, 5] += p.added[2] * np.hypot(psi, w[2] / p.added_omega[2])


@njit
def track(p, k, s):
    """Where a slider is at the arc s, which way it goes, and its track's curvature: a straight line, or a circle with its centre above."""
    place, way, rod = vec(p.slider_place[k]), vec(p.slider_way[k]), p.slider_rod[k]
    if rod == 0:
        return add(place, scale(s, way)), way, (0.0, 0.0, 0.0)
    sine, cosine = np.sin(s / rod), np.cos(s / rod)
    at = add(place, add(scale(rod * sine, way), (0.0, 0.0, rod * (1 - cosine))))
    return at, add(scale(cosine, way), (0.0, 0.0, sine)), scale(1 / rod, add(scale(-sine, way), (0.0, 0.0, cosine)))


@njit
def slide(p, k, s, ds, r, w, m, f):
    """A mass on a spring along a way in the hull, or a pendulum's bob: its inertia J'mJ, and J' times its forces."""
    mass, (place, way, bend) = p.slider_mass[k], track(p, k, s)
    spun = add(cross(w, cross(w, place)), add(scale(2 * ds, cross(w, way)), scale(ds * ds, bend)))
    force = scale(-mass, add(scale(p.gravity, r[2]), spun))
    # Columns of J, the slider's velocity in hull axes: translation, rotation e_i x place, the way.
    columns = (
        (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0),
        (0.0, -place[2], place[1]), (place[2], 0.0, -place[0]), (-place[1], place[0], 0.0), way,
    )  # fmt: skip
    for a in range(7):
        row = a if a < 6 else 6 + k
        f[row] += dot(columns[a], force)
        for b in range(7):
            m[row, b if b < 6 else 6 + k] += mass * dot(columns[a], columns[b])
    f[6 + k] -= p.slider_spring[k] * s + p.slider_damping[k] * ds
