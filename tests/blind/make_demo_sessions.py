"""Writes the sessions that ship with the package: `python/gyradius/sessions/{keelboat,model-hull,boat-park}`.

    python tests/blind/make_demo_sessions.py

The first two are typed in from P. F. Hinrichsen, Journal of Sailboat Technology 2014-01; the third is simulated by
`generate.py` from the seed below, and its truth is kept in `tests/blind/boat-park.truth.json`.
"""

from __future__ import annotations

import json
from math import pi, sqrt
from pathlib import Path

import generate as gen
import numpy as np

HERE = Path(__file__).resolve().parent
SESSIONS = HERE.parents[1] / "python" / "gyradius" / "sessions"
BOAT_PARK_SEED = 20140101  # the paper's issue number; the first and only seed that was tried
G = 9.80665  # m/s2, as errata.md works the paper's figures


def q(value: float, u: float, digits: int = 4) -> dict:
    """A value with its standard uncertainty."""
    return {"value": round(value, digits), "u": u}


def head(title: str, body: dict, site: dict) -> list[str]:
    """The tables that open a session."""
    first = f'format = "gyradius-session/1"\ntitle = {gen.toml_value(title)}\n'
    return [first, gen.toml_table("[body]", body), gen.toml_table("[site]", site)]


def swing(name: str, periods: dict, suspension: dict, **more) -> str:
    """A swing with typed-in periods."""
    table = gen.toml_table("[[swing]]", {"id": name, "periods_s": periods} | more)
    return table + gen.toml_table("[swing.suspension]", suspension)


def write(name: str, parts: list[str], readme: str) -> None:
    """Session and README."""
    folder = SESSIONS / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "session.toml").write_text("\n".join(parts))
    (folder / "README.md").write_text(readme)


def keelboat() -> None:
    """Tables 1 and 2: periods as printed, u from the scatter of Table 1's three repeats (4.391, 4.390, 4.383 s)."""
    u = 0.004
    rig = {
        "kind": "bifilar", "orientation": "athwartships",
        "line_length": q(3.477, 0.006), "spacing": q(1.8, 0.001),
    }  # fmt: skip
    parts = head(
        "Yngling, 2014 paper, Tables 1 and 2: periods as printed",
        {"name": "Yngling", "mass": q(622.7, 0.5), "length_overall": 6.35},
        {"gravity": q(G, 0.005, 5), "air_density": 1.2},
    )
    again = {"same_as": "table-1-bare-1"}
    for n, period in enumerate((4.391, 4.390, 4.383), 1):
        parts.append(swing(f"table-1-bare-{n}", {"yaw": q(period, u)}, rig if n == 1 else again, excited=["yaw"]))
    for name, yaw, sway in (("table-2-ums-1", 4.394, 3.802), ("table-2-ums-4", 4.407, 3.820)):
        parts.append(swing(name, {"yaw": q(yaw, u), "sway": q(sway, u)}, again, excited=["yaw", "sway"]))
    added = (("1.2kg", 1.2, 4.446), ("2.4kg-1", 2.4, 4.504), ("2.4kg-2", 2.4, 4.496), ("3.6kg", 3.6, 4.555))
    for name, mass, period in added:
        masses = [{"mass": mass, "position": [x, 0.0, 0.0]} for x in (3.088, -2.717)]
        parts.append(swing(f"table-1-{name}", {"yaw": q(period, u)}, again, excited=["yaw"], added_mass=masses))
    write("keelboat", parts, KEELBOAT)


KEELBOAT = """# Keelboat

A full-size Yngling on two lines, from P. F. Hinrichsen, *Bifilar suspension measurement of boat inertia parameters*,
Journal of Sailboat Technology 2014-01: the photogate's yaw periods of Table 1, bare and with equal masses at bow and
stern, and the yaw and sway periods of Table 2. Periods, mass, line length and spacing are as printed. Ours are: the
uncertainty of a period, 0.004 s, from the scatter of the three bare repeats; that of the spacing; gravity, whose place
the paper does not name; and the height of the added masses, which it does not give either.

The sway periods do not fit the line length that the tape gave. That is in the paper, and the program must say so.
"""


def double_pendulum(line: float, depth: float, k: float) -> tuple[float, float]:
    """Periods in phase (long) and out of phase (short), eq. (16), named as in the errata."""
    b = line * depth + depth**2 + k**2
    root = sqrt(b * b - 4 * line * depth * k * k)
    return tuple(2 * pi / sqrt(G / (2 * line * k * k) * (b + sign * root)) for sign in (-1, 1))


def model_periods(line: float, d: float, k_yaw: float, pendulum: tuple | None = None) -> dict:
    """Yaw (5), sway (7) and, given (prefix, depth, gyradius), the two modes of (16)."""
    u = 0.004
    sway = 2 * pi * sqrt(line / G)
    periods = {"yaw": q(k_yaw / d * sway, u), "sway": q(sway, u)}
    if pendulum:
        prefix, depth, k = pendulum
        long, short = double_pendulum(line, depth, k)
        periods |= {f"{prefix}_in_phase": q(long, u), f"{prefix}_out_of_phase": q(short, u)}
    return periods


def model_hull() -> None:
    """Table 3 (first), row by row."""
    parts = head(
        "Model keelboat, 2014 paper: periods worked back from the gyradii of Table 3 by eqs. (5), (7), (16), (22)",
        {"name": "Model keelboat", "mass": q(13.18, 0.01), "length_overall": 1.87},
        {"gravity": q(G, 0.005, 5), "air_density": 1.2},
    )

    def rig(line, d, orientation="athwartships", pitch=None):
        # The points 0.56 m apart were marked and measured once: one reading, whose error is the same in every hanging.
        spacing = {"value": 0.56, "u": 0.0, "instrument": MARKS} if 2 * d == 0.56 else q(2 * d, 0.0005)
        values = {"kind": "bifilar", "orientation": orientation, "line_length": q(line, 0.001), "spacing": spacing}
        return values | ({"hull_pitch_deg": q(pitch, 0.2)} if pitch is not None else {})

    level = (
        (0.504, 0.280, 0.249, 0.309, 0.360),
        (1.006, 0.280, 0.244, 0.308, 0.353),
        (1.084, 0.260, 0.243, 0.313, 0.355),
        (1.560, 0.280, 0.244, 0.309, 0.357),
    )
    for line, d, depth, k_yaw, k_pitch in level:
        periods = model_periods(line, d, k_yaw, ("pitch", depth, k_pitch))
        parts.append(swing(f"level-{1000 * line:.0f}mm", periods, rig(line, d)))
    parts.append(swing("bow-down", model_periods(1.012, 0.280, 0.294), rig(1.012, 0.280, pitch=-31.1)))
    parts.append(swing("stern-down", model_periods(1.012, 0.280, 0.290), rig(1.012, 0.280, pitch=22.8)))
    periods = model_periods(1.012, 0.280, 0.310, ("roll", 0.251, 0.204))
    parts.append(swing("fore-and-aft", periods, rig(1.012, 0.280, "fore_and_aft")))
    for height in (0.441, 0.305):
        a = height + 0.251
        period = 2 * pi * sqrt((a * a + 0.205**2) / (a * G))  # (22)
        axis = {"kind": "compound", "orientation": "fore_and_aft", "axis_height": q(height, 0.001)}
        parts.append(swing(f"compound-{1000 * height:.0f}mm", {"compound": q(period, 0.002)}, axis))
    parts.append(gen.toml_table("[[instrument]]", {"id": MARKS, "kind": "tape", "zero_u": 0.0005}))
    write("model-hull", parts, MODEL_HULL)


MARKS = "marks"


MODEL_HULL = """# Model hull

The 13.18 kg model keelboat of P. F. Hinrichsen, *Bifilar suspension measurement of boat inertia parameters*, Journal of
Sailboat Technology 2014-01. The paper prints the gyradii and depths of each hanging (first Table 3), not the periods, so
`tests/blind/make_demo_sessions.py` works the periods back row by row: yaw by (5), sway by (7), the pitch and roll pairs
by (16), the compound pendulum of the text (205 mm at 441 and 305 mm) by (22), at g = 9.80665 m/s2. The rows differ by a
per cent or so, as the measurements did. `hull_pitch_deg` is positive bow up: "bow down" is -31.1, "stern down" +22.8.

The pitch pairs of the two tilted rows are left out: the paper does not say how the suspension points were moved.
Ours are the uncertainties: 0.004 s (0.002 s compound), 1 mm line, 0.5 mm spacing, 0.2 degrees. The fore-and-aft hanging
had some added cross pieces, which raised its yaw gyradius by a millimetre.
"""


def boat_park() -> None:
    """An open keelboat of 212 kg, five phone recordings."""
    rng = np.random.default_rng(BOAT_PARK_SEED)
    hull = gen.Hull(212.0, 5.05, 1.74, 0.53, 1.185, 1.142, np.radians(2.4), 0.335, 9.8127)
    line, spacing, along = 2.214, 1.652, 1.504
    tape, beam, keel = (gen.stated(rng, x, u, u, 3) for x, u in ((line, 0.002), (spacing, 0.0008), (along, 0.0008)))
    phone = gen.Phone(
        np.array([1.31, 0.22, -0.04]), gen.uniform_rotation(rng), 0.001, 0.01,
        rng.uniform(-0.01, 0.01, 3), rng.uniform(-0.05, 0.05, 3), rng.normal(0, 11e-6), 99.6, 100.7, False,
    )  # fmt: skip
    rig = (line, tape, spacing, beam)
    plans = [
        gen.Plan("yaw-sway", ("yaw", "sway"), *rig, phone=phone, duration_s=75.0),
        gen.Plan("surge-pitch", ("pitch",), *rig, phone=phone, duration_s=60.0),
        gen.Plan("roll", ("pitch",), line, tape, along, keel, fore_and_aft=True, phone=phone, duration_s=60.0),
    ]
    for name, tilt in (("bow-up", 21.4), ("bow-down", -18.7)):
        read = {"value": round(tilt + rng.normal(0, 0.2), 1), "u": 0.2}
        slow = gen.Phone(**vars(phone) | {"gyro_rate_hz": 49.8, "acc_rate_hz": 50.35})
        plans.append(
            gen.Plan(name, ("yaw",), *rig, bow_up_rad=np.radians(tilt), stated_pitch=read, phone=slow, duration_s=60.0)
        )
    hungs = [gen.hang(rng, hull, plan) for plan in plans]
    if not all(gen.acceptable(h, 0.04, 0.04) for h in hungs):
        raise SystemExit("periods too near one another: change the rig")
    [motions] = gen.simulate([(rng, hull, hungs)])
    folder, title = SESSIONS / "boat-park", f"Open keelboat in the boat park: simulated, seed {BOAT_PARK_SEED}"
    gen.write_session(rng, folder, title, hull, motions, hints=True, decimals=gen.Decimals(5, 5, 3))
    (folder / "README.md").write_text(BOAT_PARK)
    truth = gen.truth_of(BOAT_PARK_SEED, "boat-park", hull, motions)
    (HERE / "boat-park.truth.json").write_text(json.dumps(truth, indent=1) + "\n")


BOAT_PARK = f"""# Boat park

A simulated afternoon: an open keelboat of 212 kg on two lines of 2.2 m, a phone taped to the foredeck at an odd angle, five
recordings of a minute or so (yaw with sway, surge with pitch, a fore-and-aft suspension for roll, and yaw with the bow up and the
bow down). Made by `tests/blind/make_demo_sessions.py` with seed {BOAT_PARK_SEED}: a rigid body on two inextensible lines at
finite amplitude, linear drag, sensor noise, biases, each sensor on its own clock, tape readings with their errors. It shares no
code with the analysis. What is true of the hull is in `tests/blind/boat-park.truth.json`.
"""


def main() -> None:
    """All three."""
    keelboat()
    model_hull()
    boat_park()


if __name__ == "__main__":
    main()
