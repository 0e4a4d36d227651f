"""The routes once more, in mpmath, by other ways than the core's wherever there is another way.

Each function takes the named numbers of a vector and returns all outputs. Nothing here reads the core.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from mpmath import mp, mpf

mp.dps = 40
N = dict[str, Any]
ORACLES: dict[str, Callable[[N], N]] = {}


def oracle(f: Callable[[N], N]) -> Callable[[N], N]:
    ORACLES[f.__name__] = f
    return f


TWO_PI = 2 * mp.pi


@oracle
def moment(v: N) -> N:
    return {"moment_kg_m2": v["mass_kg"] * v["gyradius_m"] ** 2}


def tensor(v: N) -> Any:
    """2 × 2 tensor over the mass in hull axes (x, z), by turning the principal one."""
    c, s = mp.cos(v["psi_rad"]), mp.sin(v["psi_rad"])
    turn = mp.matrix([[c, -s], [s, c]])
    return turn * mp.diag([v["k_px_m"] ** 2, v["k_pz_m"] ** 2]) * turn.T


@oracle
def principal_to_hull(v: N) -> N:
    t = tensor(v)
    return {"k_roll_m": mp.sqrt(t[0, 0]), "k_yaw_m": mp.sqrt(t[1, 1]), "xz_m2": t[0, 1]}


@oracle
def tilted_gyradius(v: N) -> N:
    n = mp.matrix([mp.sin(v["pitch_rad"]), mp.cos(v["pitch_rad"])])
    return {"gyradius_m": mp.sqrt((n.T * tensor(v) * n)[0])}


def axes(xx: Any, zz: Any, xz: Any) -> N:
    """Principal values by the eigenvectors; principal x is the one within 45° of x."""
    values, vectors = mp.eigsy(mp.matrix([[xx, xz], [xz, zz]]))
    x = 0 if abs(vectors[0, 0]) > abs(vectors[1, 0]) else 1
    psi = mp.atan(vectors[1, x] / vectors[0, x])
    return {"psi_rad": psi, "k_px_m": mp.sqrt(values[x]), "k_pz_m": mp.sqrt(values[1 - x])}


@oracle
def principal_from_one_tilt(v: N) -> N:
    s, c = mp.sin(v["pitch_rad"]), mp.cos(v["pitch_rad"])
    xx, zz = v["k_roll_m"] ** 2, v["k_yaw_m"] ** 2
    return axes(xx, zz, (v["k_tilted_m"] ** 2 - xx * s**2 - zz * c**2) / (2 * s * c))


def height(v: N) -> Any:
    return mp.sqrt(v["line_length_m"] ** 2 - (top(v) - v["half_spacing_m"]) ** 2)


def top(v: N) -> Any:
    return v.get("top_half_spacing_m", v["half_spacing_m"])


def stiffness(v: N) -> Any:
    """Torque per angle over the mass: second derivative of g z(θ) at rest, numerically."""
    b, t, length = v["half_spacing_m"], top(v), v["line_length_m"]
    z = lambda a: -mp.sqrt(length**2 - t**2 - b**2 + 2 * t * b * mp.cos(a))  # noqa: E731
    return v["gravity_m_s2"] * mp.diff(z, 0, 2)


@oracle
def yaw_period(v: N) -> N:
    return {"yaw_period_s": TWO_PI * v["gyradius_m"] / mp.sqrt(stiffness(v))}


@oracle
def yaw_gyradius(v: N) -> N:
    return {"gyradius_m": v["yaw_period_s"] * mp.sqrt(stiffness(v)) / TWO_PI}


@oracle
def sway_period(v: N) -> N:
    return {"sway_period_s": TWO_PI * mp.sqrt(v["line_length_m"] / v["gravity_m_s2"])}


@oracle
def line_length_from_sway(v: N) -> N:
    return {"line_length_m": v["gravity_m_s2"] * v["sway_period_s"] ** 2 / (4 * mp.pi**2)}


@oracle
def ratio_gyradius(v: N) -> N:
    return {"gyradius_m": v["yaw_period_s"] * v["half_spacing_m"] / v["sway_period_s"]}


@oracle
def beat(v: N) -> N:
    yaw, sway = 1 / v["yaw_period_s"], 1 / v["sway_period_s"]
    average, beats = (yaw + sway) / 2, abs(yaw - sway)
    return {"average_period_s": 1 / average, "beat_period_s": 1 / beats, "oscillations_per_beat": average / beats}


@oracle
def beat_gyradius(v: N) -> N:
    # n + 1/2 oscillations of the faster fall on n − 1/2 of the slower.
    n, half = v["oscillations_per_beat"], mpf(1) / 2
    ratio = (n + half) / (n - half) if v["yaw_is_slower"] == 1 else (n - half) / (n + half)
    return {"period_ratio": ratio, "gyradius_m": ratio * v["half_spacing_m"]}


def two_periods(k: Any, l2: Any, l1: Any, g: Any) -> tuple[Any, Any]:
    """Eigenvalues of M⁻¹K of the linearised double pendulum, angles of the lines and of the hull."""
    mass = mp.matrix([[l1**2, l1 * l2], [l1 * l2, l2**2 + k**2]])
    squares = mp.eig(mp.inverse(mass) * mp.diag([g * l1, g * l2]), left=False, right=False)
    periods = sorted(TWO_PI / mp.sqrt(mp.re(s)) for s in squares)
    return periods[1], periods[0]


def named_periods(pair: tuple[Any, Any]) -> N:
    return {"in_phase_period_s": pair[0], "out_of_phase_period_s": pair[1]}


@oracle
def double_pendulum_periods(v: N) -> N:
    return named_periods(two_periods(v["gyradius_m"], v["cm_depth_m"], v["line_length_m"], v["gravity_m_s2"]))


@oracle
def double_pendulum_from_length(v: N) -> N:
    # Sum and product of the roots of the quadratic, solved for k² and l2.
    g, l1 = v["gravity_m_s2"], v["line_length_m"]
    a, b = ((TWO_PI / v[key]) ** 2 for key in ("in_phase_period_s", "out_of_phase_period_s"))
    # a b = g² l2 / (l1 k²); a + b = g (l1 l2 + l2² + k²) / (l1 k²)
    share = a * b * l1 / g**2  # l2 / k²
    l2 = ((a + b) * l1 / g - 1) / share - l1
    return {"gyradius_m": mp.sqrt(l2 / share), "cm_depth_m": l2}


@oracle
def double_pendulum(v: N) -> N:
    return double_pendulum_from_length({**v, **line_length_from_sway(v)})


@oracle
def double_pendulum_dimensionless(v: N) -> N:
    slow, fast = two_periods(v["k_over_l2"], mpf(1), v["l1_over_l2"], mpf(1))
    return {"in_phase": slow, "out_of_phase": fast}


def sensitivity(k: Any, l2: Any, l1: Any, g: Any, known: bool) -> Any:
    h = mpf(10) ** -12
    near = [two_periods(k + h, l2, l1, g), two_periods(k - h, l2, l1, g)]
    by_k = [(near[0][i] - near[1][i]) / (2 * h) for i in (0, 1)]
    if known:
        return mp.sqrt(sum(1 / x**2 for x in by_k))
    near = [two_periods(k, l2 + h, l1, g), two_periods(k, l2 - h, l1, g)]
    by_l2 = [(near[0][i] - near[1][i]) / (2 * h) for i in (0, 1)]
    inverse = mp.inverse(mp.matrix([[by_k[0], by_l2[0]], [by_k[1], by_l2[1]]]))
    return mp.sqrt(inverse[0, 0] ** 2 + inverse[0, 1] ** 2)


@oracle
def double_pendulum_sensitivity(v: N) -> N:
    body = v["gyradius_m"], v["cm_depth_m"], v["line_length_m"], v["gravity_m_s2"]
    return {"sensitivity_m_s": sensitivity(*body, v["depth_known"] == 1)}


@oracle
def double_pendulum_best_length(v: N) -> N:
    k, l2, g, known = v["gyradius_m"], v["cm_depth_m"], v["gravity_m_s2"], v["depth_known"] == 1
    lengths = [l2 * mpf(10) ** (mpf(i) / 20 - 2) for i in range(81)]
    values = [sensitivity(k, l2, x, g, known) for x in lengths]
    i = values.index(min(values))
    a, b = lengths[i - 1], lengths[i + 1]
    for _ in range(70):
        p, q = a + (b - a) / 3, b - (b - a) / 3
        if sensitivity(k, l2, p, g, known) < sensitivity(k, l2, q, g, known):
            b = q
        else:
            a = p
    return {"line_length_m": (a + b) / 2}


@oracle
def incline_one_end(v: N) -> N:
    # Moments about the suspension points, root found in l2.
    s, c = mp.sin(v["angle_rad"]), mp.cos(v["angle_rad"])
    return {"cm_depth_m": v["mass_ratio"] * (v["arm_m"] * c - v["depth_m"] * s) / s}


@oracle
def incline_both_ends(v: N) -> N:
    # Unknowns l2 and the arm to the stern: l2 t_s = r (L_s − b_s t_s), l2 t_b = r (L_0 − L_s − b_b t_b).
    ts, tb, r = mp.tan(v["stern_angle_rad"]), mp.tan(v["bow_angle_rad"]), v["mass_ratio"]
    left = mp.matrix([[ts, -r], [tb, r]])
    right = mp.matrix([-r * v["stern_depth_m"] * ts, r * (v["length_m"] - v["bow_depth_m"] * tb)])
    return {"cm_depth_m": mp.lu_solve(left, right)[0]}


@oracle
def suspension_shift(v: N) -> N:
    return {"cm_depth_m": v["shift_m"] * mp.cos(v["angle_rad"]) / mp.sin(v["angle_rad"])}


@oracle
def tilt_from_gravity(v: N) -> N:
    a, b = ([v[f"{name}_{axis}"] for axis in "xyz"] for name in ("before", "after"))
    norm = lambda w: mp.sqrt(sum(x**2 for x in w))  # noqa: E731
    return {"angle_rad": mp.acos(sum(x * y for x, y in zip(a, b, strict=True)) / norm(a) / norm(b))}


@oracle
def compound_period(v: N) -> N:
    a, k = v["axis_to_cm_m"], v["gyradius_m"]
    return {"period_s": TWO_PI * mp.sqrt((a + k**2 / a) / v["gravity_m_s2"])}


@oracle
def compound_gyradius(v: N) -> N:
    a = v["axis_to_cm_m"]
    return {"gyradius_m": mp.sqrt(v["period_s"] ** 2 * v["gravity_m_s2"] * a / (4 * mp.pi**2) - a**2)}


@oracle
def compound_slopes(v: N) -> N:
    g, a, period = v["gravity_m_s2"], v["axis_to_cm_m"], compound_period(v)["period_s"]
    k = lambda a, t: mp.sqrt(t**2 * g * a / (4 * mp.pi**2) - a**2)  # noqa: E731
    return {"by_axis_to_cm": mp.diff(k, (a, period), (1, 0)), "by_period_m_s": mp.diff(k, (a, period), (0, 1))}


@oracle
def lamboley(v: N) -> N:
    # I/m g T² … both swings linear in (l2, k² + l2²): c (h + l2) = h² + 2 h l2 + (l2² + k²).
    rows, right = [], []
    for n in "12":
        h, c = v[f"axis_height_{n}_m"], v["gravity_m_s2"] * (v[f"period_{n}_s"] / TWO_PI) ** 2
        rows.append([c - 2 * h, -1])
        right.append(h**2 - c * h)
    l2, about_mark = mp.lu_solve(mp.matrix(rows), mp.matrix(right))
    return {"gyradius_m": mp.sqrt(about_mark - l2**2), "cm_depth_m": l2}


def plane(points: list[tuple[Any, Any]]) -> Any:
    """(xx, zz, xz) from three (pitch, gyradius)."""
    rows = [[mp.sin(p) ** 2, mp.cos(p) ** 2, mp.sin(2 * p)] for p, _ in points]
    return mp.lu_solve(mp.matrix(rows), mp.matrix([k**2 for _, k in points]))


@oracle
def roll_from_tilts(v: N) -> N:
    points = [(mpf(0), v["k_yaw_m"]), (v["pitch_a_rad"], v["k_a_m"]), (v["pitch_b_rad"], v["k_b_m"])]
    return {"k_roll_m": mp.sqrt(plane(points)[0])}


@oracle
def roll_from_right_angle(v: N) -> N:
    return {"k_roll_m": mp.sqrt(v["k_a_m"] ** 2 + v["k_b_m"] ** 2 - v["k_yaw_m"] ** 2)}


@oracle
def tilt_fit(v: N) -> N:
    count = sum(key.startswith("pitch_") and "_u_" not in key for key in v)
    pitch = [v[f"pitch_{n + 1}_rad"] for n in range(count)]
    k = [v[f"gyradius_{n + 1}_m"] for n in range(count)]
    pitch_u = [v.get(f"pitch_u_{n + 1}_rad", mpf(0)) for n in range(count)]
    k_u = [v[f"gyradius_u_{n + 1}_m"] for n in range(count)]
    rows = mp.matrix([[mp.sin(p) ** 2, mp.cos(p) ** 2, mp.sin(2 * p)] for p in pitch])
    right = mp.matrix([x**2 for x in k])
    slopes = [mpf(0)] * count
    for _ in range(4):
        # Weights from the u of gyradius and angle; the slope of k² against the angle from the round before.
        variance = [(2 * k[i] * k_u[i]) ** 2 + (slopes[i] * pitch_u[i]) ** 2 for i in range(count)]
        weight = mp.diag([1 / x for x in variance])
        covariance = mp.inverse(rows.T * weight * rows)
        x = covariance * (rows.T * weight * right)
        slopes = [(x[0] - x[1]) * mp.sin(2 * p) + 2 * x[2] * mp.cos(2 * p) for p in pitch]
    variance = [(2 * k[i] * k_u[i]) ** 2 + (slopes[i] * pitch_u[i]) ** 2 for i in range(count)]
    residual = right - rows * x
    chi2 = sum(residual[i] ** 2 / variance[i] for i in range(count))
    covariance += x * x.T * (2 * v.get("common_relative_u", mpf(0))) ** 2
    out = axes(x[0], x[1], x[2])
    # Figures whose gradient is taken numerically.
    figures = {
        "psi_u_rad": lambda a, b, c: mp.atan(2 * c / (a - b)) / 2,
        "k_px_u_m": lambda a, b, c: axes(a, b, c)["k_px_m"],
        "k_pz_u_m": lambda a, b, c: axes(a, b, c)["k_pz_m"],
        "k_roll_u_m": lambda a, b, c: mp.sqrt(a),
        "k_yaw_u_m": lambda a, b, c: mp.sqrt(b),
    }
    for name, figure in figures.items():
        h = mpf(10) ** -14
        steps = [[h if i == j else 0 for i in range(3)] for j in range(3)]
        up = [figure(*(x[i] + step[i] for i in range(3))) for step in steps]
        down = [figure(*(x[i] - step[i] for i in range(3))) for step in steps]
        gradient = mp.matrix([(a - b) / (2 * h) for a, b in zip(up, down, strict=True)])
        out[name] = mp.sqrt((gradient.T * covariance * gradient)[0])
    low, high = fieller(x, covariance)
    return {**out, "psi_low_rad": low, "psi_high_rad": high, "k_roll_m": mp.sqrt(x[0]), "k_yaw_m": mp.sqrt(x[1]), "chi_squared": chi2}


def fieller(x: Any, covariance: Any) -> tuple[Any, Any]:
    """ψ where 2 xz cos 2ψ − (xx − zz) sin 2ψ is 1.96 of its own standard deviations from 0, found by bisection."""
    z = mp.sqrt(2) * mp.erfinv(mpf("0.95"))

    def score(psi: Any) -> Any:
        w = mp.matrix([-mp.sin(2 * psi), mp.sin(2 * psi), 2 * mp.cos(2 * psi)])
        return (w.T * x)[0] ** 2 - z**2 * (w.T * covariance * w)[0]

    centre, quarter = axes(*x)["psi_rad"], mp.pi / 4
    if score(quarter) <= 0:
        return -quarter, quarter
    ends = []
    for end in (-quarter, quarter):
        inner, outer = centre, end
        for _ in range(130):
            middle = (inner + outer) / 2
            inner, outer = (middle, outer) if score(middle) < 0 else (inner, middle)
        ends.append(inner)
    return ends[0], ends[1]


@oracle
def square_frame(v: N) -> N:
    # Four thin rods by integration, unit mass each.
    d, l2 = v["half_spacing_m"], v["cm_depth_m"]
    level = mp.quad(lambda s: s**2, [-d, d]) / (2 * d) * 2 + 2 * d**2
    yaw = mp.quad(lambda s: s**2 + d**2, [-d, d]) / (2 * d)
    k = mp.sqrt(level / 4 + l2**2)
    return {"k_roll_m": k, "k_pitch_m": k, "k_yaw_m": mp.sqrt(yaw)}


@oracle
def end_masses(v: N) -> N:
    m = v["added_kg"]
    total = v["mass_kg"] * v["gyradius_m"] ** 2 + m * v["fore_m"] ** 2 + m * v["aft_m"] ** 2
    return {"gyradius_m": mp.sqrt(total / (v["mass_kg"] + 2 * m))}


@oracle
def offset_moment(v: N) -> N:
    a, b, d = v["mass_1_kg"], v["mass_2_kg"], v["distance_m"]
    centre = b * d / (a + b)
    return {"moment_kg_m2": a * centre**2 + b * (d - centre) ** 2}


@oracle
def joined_gyradius(v: N) -> N:
    a, b = v["mass_1_kg"], v["mass_2_kg"]
    own = a * v["gyradius_1_m"] ** 2 + b * v["gyradius_2_m"] ** 2
    return {"gyradius_m": mp.sqrt((own + offset_moment(v)["moment_kg_m2"]) / (a + b))}


@oracle
def rest_gyradius(v: N) -> N:
    rest = v["mass_1_kg"] - v["mass_2_kg"]
    own = v["mass_1_kg"] * v["gyradius_1_m"] ** 2 - v["mass_2_kg"] * v["gyradius_2_m"] ** 2
    off = offset_moment({**v, "mass_1_kg": rest})["moment_kg_m2"]
    return {"gyradius_m": mp.sqrt((own - off) / rest)}


def about_mark(v: N, n: str) -> tuple[Any, Any, Any]:
    """Mass, first moments and tensor about the mark: additive, which makes joining a sum."""
    m, r = v[f"mass_{n}_kg"], mp.matrix([v[f"{c}_{n}_m"] for c in "xyz"])
    j = {c: v[f"i{c}_{n}_kg_m2"] for c in ("xx", "yy", "zz", "xy", "xz", "yz")}
    own = mp.matrix([[j["xx"], j["xy"], j["xz"]], [j["xy"], j["yy"], j["yz"]], [j["xz"], j["yz"], j["zz"]]])
    return m, m * r, own + m * ((r.T * r)[0] * mp.eye(3) - r * r.T)


def about_centre(m: Any, first: Any, tensor_: Any) -> N:
    r = first / m
    own = tensor_ - m * ((r.T * r)[0] * mp.eye(3) - r * r.T)
    places = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    return {"mass_kg": m} | {f"{c}_m": r[i] for i, c in enumerate("xyz")} | {
        f"i{c}_kg_m2": own[place] for c, place in places.items()
    }


@oracle
def body_joined(v: N) -> N:
    a, b = about_mark(v, "1"), about_mark(v, "2")
    return about_centre(*(x + y for x, y in zip(a, b, strict=True)))


@oracle
def body_without(v: N) -> N:
    a, b = about_mark(v, "1"), about_mark(v, "2")
    return about_centre(*(x - y for x, y in zip(a, b, strict=True)))


@oracle
def levelling(v: N) -> N:
    # (28) as printed, term by term.
    tp, tr = mp.tan(v["pitch_rad"]) ** 2, mp.tan(v["roll_rad"]) ** 2
    cp, cr = mp.cos(v["pitch_rad"]) ** 2, mp.cos(v["roll_rad"]) ** 2
    x = v["k_px_m"] ** 2 * tp * cr / (1 + tp * cr)
    y = v["k_py_m"] ** 2 * tr * cp / (1 + tr * cp)
    return {"gyradius_m": mp.sqrt(x + y + v["k_pz_m"] ** 2 / (1 + tp + tr))}


@oracle
def buoyant_gravity(v: N) -> N:
    return {"gravity_m_s2": v["gravity_m_s2"] - v["gravity_m_s2"] * v["air_density_kg_m3"] / v["density_kg_m3"]}


@oracle
def normal_gravity(v: N) -> N:
    # The other form of Somigliana's formula, from the polar and equatorial values; TR8350.2 tables 3.1, 3.3, 3.4.
    a, b = mpf("6378137"), mpf("6356752.3142")
    equator, pole = mpf("9.7803253359"), mpf("9.8321849378")
    f, m = 1 / mpf("298.257223563"), mpf("0.00344978650684")
    s2 = mp.sin(mp.radians(v["latitude_deg"])) ** 2
    ground = (a * equator * (1 - s2) + b * pole * s2) / mp.sqrt(a**2 * (1 - s2) + b**2 * s2)
    h = v["altitude_m"]
    return {"gravity_m_s2": ground * (1 - 2 / a * (1 + f + m - 2 * f * s2) * h + 3 * h**2 / a**2)}


@oracle
def undamped_period(v: N) -> N:
    return {"period_s": TWO_PI / mp.sqrt((TWO_PI / v["period_s"]) ** 2 + 1 / v["decay_time_s"] ** 2)}


@oracle
def pendulum_period_ratio(v: N) -> N:
    return {"period_ratio": 2 * mp.ellipk(mp.sin(v["amplitude_rad"] / 2) ** 2) / mp.pi}


@oracle
def pendulum_small_period(v: N) -> N:
    return {"period_s": v["period_s"] / pendulum_period_ratio(v)["period_ratio"]}


@oracle
def yaw_period_at_amplitude(v: N) -> N:
    # Energy integral in θ = A cos w (another substitution than the core's), Gauss–Legendre quadrature.
    b, t, length, a = v["half_spacing_m"], top(v), v["line_length_m"], v["amplitude_rad"]
    k, g = v["gyradius_m"], v["gravity_m_s2"]
    h = lambda q: mp.sqrt(length**2 - t**2 - b**2 + 2 * t * b * mp.cos(q))  # noqa: E731

    def f(w: Any) -> Any:
        q = a * mp.cos(w)
        slope = t * b * mp.sin(q) / h(q)
        # h(q) − h(a) without cancellation: cos q − cos a = 2 sin((a+q)/2) sin((a−q)/2), a − q = 2 a sin²(w/2).
        fall = 4 * t * b * mp.sin((a + q) / 2) * mp.sin(a * mp.sin(w / 2) ** 2) / (h(q) + h(a))
        return mp.sqrt((k**2 + slope**2) / (2 * g * fall)) * a * mp.sin(w)

    return {"yaw_period_s": 4 * mp.quad(f, [0, mp.pi / 4, mp.pi / 2], method="gauss-legendre")}


@oracle
def yaw_small_period(v: N) -> N:
    guess = yaw_gyradius(v)["gyradius_m"]
    miss = lambda k: yaw_period_at_amplitude({**v, "gyradius_m": k})["yaw_period_s"] - v["yaw_period_s"]  # noqa: E731
    k = mp.findroot(miss, (guess * mpf("0.99"), guess), solver="secant", tol=mpf(10) ** -66)
    return {"yaw_period_s": yaw_period({**v, "gyradius_m": k})["yaw_period_s"], "gyradius_m": k}


@oracle
def equivalent_ellipsoid(v: N) -> N:
    # k² = (sum of the squares of the other two semi-axes) / 5, solved as a linear system.
    left = mp.matrix([[0, 1, 1], [1, 0, 1], [1, 1, 0]])
    squares = mp.lu_solve(left, mp.matrix([5 * v[f"k_p{c}_m"] ** 2 for c in "xyz"]))
    return {f"{name}_m": mp.sqrt(squares[i]) for i, name in enumerate("abc")}


@oracle
def inertia_ellipsoid(v: N) -> N:
    return {name: 1 / (mp.sqrt(v["mass_kg"]) * v[f"k_p{c}_m"]) for name, c in zip("abc", "xyz", strict=True)}


@oracle
def guard_band(v: N) -> N:
    factor = v.get("guard_factor", mp.sqrt(2) * mp.erfinv(mpf("0.9")))
    margin = (v["value"] - v["limit"]) * (1 if v["at_least"] == 1 else -1)
    band = factor * v["u"]
    probability = mp.ncdf(margin / v["u"]) if v["u"] else mpf(margin >= 0)
    # The interval of acceptance is closed: an exact value on the limit meets both and conforms, as its probability says.
    verdict = 1 if margin >= band else -1 if margin <= -band else 0
    return {"conformance_probability": probability, "guard_band": band, "verdict": mpf(verdict)}


@oracle
def core_motion(v: N) -> N:
    # The conventional value of standard gravity (3rd CGPM, 1901); specific force points away from the pull.
    forces = {f"force_{axis}_m_s2": -v[f"acceleration_{axis}_g"] * 980665 / 10**5 for axis in "xyz"}
    return {**forces, "stamp_ns": mp.nint(v["timestamp_s"] * 10**9)}
