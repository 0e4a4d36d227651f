"""Draws sessions with something hidden in them that the simple theory leaves out, and the truth beside each.

    python tests/hidden/sessions.py --count 5 --out DIR [--seed N] [--effect line_creep] [--detect]

writes `DIR/<name>/session.toml` with its recordings and `DIR/<name>.truth.json`, which holds what is hidden. Without
`--seed` a fresh seed is drawn and printed. `--detect` adds how many standard deviations the effect stands out (`detect.py`).

On top of a rigid body on two inextensible lines, linearly damped, recorded with a constant bias and white noise, a session hides
nothing (`none`), one cause of the catalogue, two of them, or something that the catalogue lacks.
"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from borrowed import blind
from effects import ALL, EFFECTS, OUTSIDE, Session, Tape
from scene import Scene, clipped, readings

SHARES = {"none": 0.15, "one": 0.5, "two": 0.15, "outside": 0.2}
DECIMALS = blind.Decimals()


@dataclass
class Hidden:
    """An effect and its strength."""

    name: str
    parameters: dict

    def put(self, session: Session, share: float = 1.0) -> None:
        """Into the session."""
        ALL[self.name].put(session, self.parameters, share)


def draw_names(rng, wanted: str | None) -> list[str]:
    """What is hidden: nothing, one, two, or something outside the catalogue."""
    if wanted:
        return [] if wanted == "none" else wanted.split("+")
    sort = rng.choice(list(SHARES), p=list(SHARES.values()))
    pool = list(OUTSIDE if sort == "outside" else EFFECTS)
    return rng.choice(pool, {"none": 0, "one": 1, "outside": 1, "two": 2}[sort], replace=False).tolist()


@dataclass(frozen=True)
class Kind:
    """What sort of session is drawn."""

    styles: tuple  # of one rig: for each swing what is set going
    lasting_s: tuple = (110, 130)
    one_rig: bool = False  # else some are swung at two line lengths or at two spacings
    lines_differ: float = 0.5  # how often two rigs differ in their lines; else in their spacing
    on_two_rigs: tuple = (("yaw", "sway"), ("pitch",))  # what is set going at each of the two
    mass_kg: tuple = (8, 700)


def draw_plans(rng, hull: blind.Hull, two_rigs: bool, kind: Kind) -> list[blind.Plan]:
    """The swings; where wanted, at two line lengths or at two spacings."""
    spacing, line = hull.k_yaw_m * rng.uniform(0.7, 1.8), draw_line(rng, hull)
    lines = blind.stated(rng, line, 0.001, 0.003)
    rigs = [(line, lines, spacing, blind.stated(rng, spacing, 0.0005, 0.001))]
    if two_rigs and rng.random() < kind.lines_differ:
        other = line
        while abs(np.log(other / line)) < 0.3:
            other = draw_line(rng, hull)
        rigs.append((other, blind.stated(rng, other, 0.001, 0.003), *rigs[0][2:]))
    elif two_rigs:
        other = spacing * rng.choice([rng.uniform(0.6, 0.8), rng.uniform(1.25, 1.6)])
        rigs.append((line, lines, other, blind.stated(rng, other, 0.0005, 0.001)))
    swings = kind.on_two_rigs if two_rigs else kind.styles[rng.integers(len(kind.styles))]
    plans = []
    for rig in rigs:
        for excited in swings:
            name = "-".join(excited) if len(excited) < 3 else "all"
            count = sum(p.id.startswith(name) for p in plans) + 1
            plans.append(blind.Plan(f"{name}-{count}", tuple(excited), *rig, duration_s=rng.uniform(*kind.lasting_s)))
    return plans


# Two to four swings, all motions among them.
USUAL = Kind(
    (
        (("yaw", "sway"), ("pitch",)),
        (("yaw",), ("sway",), ("pitch",)),
        (("yaw", "sway", "pitch"), ("yaw", "sway", "pitch")),
        (("yaw", "sway"), ("pitch",), ("yaw", "sway", "pitch")),
        (("yaw",), ("yaw",), ("sway",), ("pitch",)),
    )
)


def draw_line(rng, hull: blind.Hull) -> float:
    """Length of the lines."""
    return blind.log_uniform(rng, max(0.5, 0.25 * hull.length_m), 4.0)


def draw_hung(rng, two_rigs: bool, kind: Kind) -> tuple[blind.Hull, list]:
    """A hull and its swings; half keep 4 % from the Kane-Tseng resonances."""
    kane = 0.04 if rng.random() < 0.5 else 0.0
    while True:
        hull = blind.draw_hull(rng, False, kind.mass_kg)
        drag = blind.damping(rng, hull)
        hungs = [blind.hang(rng, hull, plan, drag) for plan in draw_plans(rng, hull, two_rigs, kind)]
        if all(blind.acceptable(h, 0.03, kane) for h in hungs):
            return hull, hungs


def draw_scene(rng, hull: blind.Hull, hung, phone: blind.Phone, sizes: dict = blind.SIZES) -> tuple[Scene, dict]:
    """A swing of the base model, and the size of each motion set going."""
    plan = hung.plan
    start, amplitudes = blind.modal_start(rng, hung, bool(rng.random() < 0.5), sizes)
    true_s = blind.stamps(rng, phone.gyro_rate_hz, plan.duration_s)
    scene = Scene(
        hull.mass_kg, np.array([0.0, 0.0, -hull.depth_m]), hull.inertia(), hull.gravity_m_s2,
        np.full(2, plan.line_m), plan.spacing_m, plan.spacing_m, start[:6], start[6:], true_s * (1 + phone.clock_error), phone,
    )  # fmt: skip
    scene.extras["linear"] = np.concatenate(hung.drag)
    return scene, amplitudes


def tapes_of(hungs: list) -> list[Tape]:
    """The figures that the operator read off, each with the swings that share it."""
    found: dict[int, Tape] = {}
    for n, hung in enumerate(hungs):
        p = hung.plan
        for what, true, stated in (("line", p.line_m, p.stated_line), ("spacing", p.spacing_m, p.stated_spacing)):
            found.setdefault(id(stated), Tape(what, true, stated, [])).scenes.append(n)
    return list(found.values())


def draw(rng, wanted: str | None = None, kind: Kind = USUAL) -> tuple[Session, list[Hidden]]:
    """A session of the base model, and what is to be hidden in it."""
    names = draw_names(rng, wanted)
    two_rigs = rng.random() < (0.85 if any(ALL[n].two_rigs for n in names) else 0.3) and not kind.one_rig
    hull, hungs = draw_hung(rng, two_rigs, kind)
    phone = blind.draw_phone(rng, hull)
    phone.one_clock = True
    for hung in hungs:
        hung.plan.phone = phone
    scenes, amplitudes = zip(*(draw_scene(rng, hull, h, phone) for h in hungs))
    session = Session(hull, hungs, list(scenes), tapes_of(hungs), list(amplitudes))
    return session, [Hidden(n, ALL[n].draw(rng, session)) for n in names]


def spoiled(session: Session, hidden: list[Hidden], shares: list[float] | None = None) -> Session:
    """The session with a share of each effect in it."""
    out = session.copy()
    for effect, share in zip(hidden, shares or [1.0] * len(hidden)):
        effect.put(out, share)
    return out


def write(rng, folder: Path, title: str, session: Session) -> None:
    """The folder of a session: what the operator wrote down, and the recordings."""
    folder.mkdir(parents=True)
    for tape in session.tapes:
        tape.stated["value"] = round(tape.stated["value"] + tape.offset_m, 4)
    (folder / "session.toml").write_text(blind.session_toml(title, session.hull, session.hungs, bool(rng.random() < 0.9)))
    for hung, scene in zip(session.hungs, session.scenes):
        gyro, acc = readings(scene)
        noisy = lambda clean, sigma: clean + rng.normal(0, sigma, clean.shape)
        gyro, acc = clipped(scene, noisy(gyro, scene.phone.gyro_noise), noisy(acc, scene.phone.acc_noise))
        write_csv(folder / f"{hung.plan.id}.csv", scene, gyro, acc)


def write_csv(path: Path, scene: Scene, gyro: np.ndarray, acc: np.ndarray) -> None:
    """All six channels at the phone's own times; a sensor with times of its own leaves the other's cells empty."""
    if scene.acc_shown_s is not None:
        phone = replace(scene.phone, one_clock=False, clock_error=0.0)  # the times are the shown ones
        return blind.write_recording(path, phone, scene.shown_s, gyro, scene.acc_shown_s, acc, 0.0, DECIMALS)
    formats = [f"%.{DECIMALS.time}f"] + [f"%.{DECIMALS.gyro}f"] * 3 + [f"%.{DECIMALS.acc}f"] * 3
    table = np.column_stack([scene.shown_s, gyro, acc])
    np.savetxt(path, table, formats, ",", header="t,gx,gy,gz,ax,ay,az", comments="")


@dataclass
class Swung:
    """What the blind sessions' truth asks of a motion."""

    hung: object
    amplitudes: dict
    story: blind.Story


def truth_of(seed: list, session: Session, hidden: list[Hidden]) -> dict:
    """The truth beside a session."""
    motions = [Swung(h, a, blind.Story(0.0, np.inf)) for h, a in zip(session.hungs, session.amplitudes)]
    truth = blind.truth_of(seed, "hidden", session.hull, motions)
    outside = any(h.name in OUTSIDE for h in hidden)
    truth["sort"] = "outside" if outside else ("none", "one", "two")[len(hidden)]
    truth["hidden"] = [{"name": h.name, "parameters": h.parameters} for h in hidden]
    return truth


def make(out: Path, seed: int, number: int, wanted: str | None = None, detect: bool = False) -> str:
    """Write one session and its truth; returns its name, which gives nothing away."""
    rng = np.random.default_rng([seed, number])
    session, hidden = draw(rng, wanted)
    return save(rng, out, [seed, number], session, hidden, studied(session, hidden) if detect else None)


def studied(session: Session, hidden: list[Hidden]) -> dict:
    """How far the hidden stands out."""
    import detect

    return detect.study(session, hidden)


def save(rng, out: Path, seed: list, session: Session, hidden: list[Hidden], detection: dict | None) -> str:
    """Write a session that was drawn from `seed`, whose last number names it, and its truth; returns the name."""
    name = f"{seed[-1]:04d}"
    truth = truth_of(seed, session, hidden) | ({"detection": detection} if detection else {})
    write(rng, out / name, f"Hull {seed[0]}/{seed[-1]}", spoiled(session, hidden))
    (out / f"{name}.truth.json").write_text(json.dumps(truth, indent=1, default=float))
    return name


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--count", type=int, default=5)
    parser.add_argument("--first", type=int, default=0, help="number of the first session")
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--effect", default=None, help="none, a name, or two joined by +: " + ", ".join(ALL))
    parser.add_argument("--detect", action="store_true", help="also how far the effect stands out (slower)")
    options = parser.parse_args()
    seed = blind.fresh_seed() if options.seed is None else options.seed
    print(f"seed {seed}")
    for number in range(options.first, options.first + options.count):
        print(options.out / make(options.out, seed, number, options.effect, options.detect), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
