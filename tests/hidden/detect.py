"""How far a hidden effect stands out of what the base model can absorb, and from the other causes: linearised about the truth.

The measurement is every reading over its noise, and every stated dimension over its uncertainty. The base model may change its
inertia, centre of mass, dimensions, gravity, the phone's pose, and for each swing its release (eight numbers), five
linear damping rates, biases and steady drifts of both sensors: more freedom than most fits take, so the figures are on the
careful side. What of an effect's sensitivity is orthogonal to all that, times its strength, is its signal in standard
deviations; 1/signal is the Cramér-Rao bound of its relative strength.

A cause of several parameters (drag along four axes) is a plane: the cosine is that of the angle between the hidden signal and
the plane. A steady drift belongs to the base, except where `bias_drift` itself is hidden.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
from borrowed import rb
from effects import ALL, EFFECTS, OUTSIDE, Session
from scene import move, sense

KEPT_HZ = 20.0  # rate of the samples taken for sensitivities; each counts as all that it stands for
STEP_S = 0.05
BACK = 0.02  # share of the hidden strength over which its sensitivity is taken, to both sides
MOMENT_S = 0.05  # by which a moment is taken to be off: readings kept are so far apart
START_M = 0.01  # by which a slider is taken to be let go elsewhere
SLIDER_STEPS = {"mass_share": 0.02, "frequency_hz": 0.01, "damping_ratio": 0.05}  # shares of themselves by which they are taken to be off
SAME = 1e-12  # squared sine below which two directions are one
FAINT = 1e-3  # of a cause's strongest direction: weaker ones are not counted as directions
CAUSES_IN_BASE = ("bias_drift",)
LOOSE = {"inertia": 1.0, "depth": 1.0, "place": 2.0}  # priors (1 is 100 %, or a metre) that only keep the solution finite


@dataclass
class Change:
    """A small change of a session. `unit` is what it is divided by; `own` the swing it concerns, None for all."""

    put: Callable  # session -> None
    unit: float
    own: int | None = None
    phone_only: bool = False
    prior: float | None = None  # its standard uncertainty, in units


@dataclass
class Study:
    """A session linearised: motions and readings of the truth, kept for differences."""

    session: Session
    motions: list = field(default_factory=list)
    looks: list = field(default_factory=list)
    within: list = field(default_factory=list)

    def __post_init__(self) -> None:
        self.motions = [move(s, STEP_S, every(s)) for s in self.session.scenes]
        self.looks = [look(s, m) for s, m in zip(self.session.scenes, self.motions)]
        self.within = [np.abs(v) < limits(s, v.size) for s, v in zip(self.session.scenes, self.looks)]

    def rows(self) -> list[int]:
        """Readings by swing, then stated dimensions and gravity."""
        return [v.size for v in self.looks] + [len(self.session.tapes) + 1]

    def difference(self, change: Change) -> list[np.ndarray]:
        """What a unit of the change does to each swing's readings and to the stated figures."""
        other = self.session.copy()
        change.put(other)
        parts = []
        for n, scene in enumerate(other.scenes):
            if change.own not in (None, n):
                parts.append(np.zeros(self.looks[n].size))
                continue
            at = self.motions[n] if change.phone_only else move(scene, STEP_S, every(scene))
            parts.append(self.changed(n, scene, look(scene, at)) / change.unit)
        parts.append((stated(other) - stated(self.session)) / change.unit)
        return parts

    def changed(self, n: int, scene, there: np.ndarray) -> np.ndarray:
        """Readings of a swing less the truth's. At a sensor's limit nothing changes, beside it all does: which readings are there is taken
        from the truth, or where a step moves some across the edge that would stand out by itself. Another limit moves the edge."""
        mine, other = limits(self.session.scenes[n], there.size), limits(scene, there.size)
        if np.array_equal(mine, other):
            return np.where(self.within[n], there - self.looks[n], 0.0)
        return np.clip(there, -other, other) - np.clip(self.looks[n], -mine, mine)

    def central(self, more: Change, less: Change) -> list[np.ndarray]:
        """The same from a change to either side: what bends cancels."""
        return [(a + b) / 2 for a, b in zip(self.difference(more), self.difference(less))]


def every(scene) -> int:
    """One sample in so many is taken."""
    return max(1, round(scene.phone.gyro_rate_hz / KEPT_HZ))


def look(scene, at: np.ndarray) -> np.ndarray:
    """Readings over their noise, as one row, of sensors without limits; each stands for `every` of them."""
    gyro, acc = sense(scene, at, every(scene))
    return np.sqrt(every(scene)) * np.concatenate([np.ravel(gyro) / scene.phone.gyro_noise, np.ravel(acc) / scene.phone.acc_noise])


def limits(scene, size: int) -> np.ndarray:
    """The sensors' limits, reading by reading, as `look` has them."""
    of_each = [scene.flaws.gyro_limit / scene.phone.gyro_noise, scene.flaws.acc_limit / scene.phone.acc_noise]
    return np.sqrt(every(scene)) * np.repeat(of_each, size // 2)


def stated(session: Session) -> np.ndarray:
    """Stated figures less the true ones, over their uncertainty."""
    tapes = [(t.offset_m - t.true_m) / t.stated["u"] for t in session.tapes]
    return np.array([*tapes, -session.scenes[0].gravity_m_s2 / 5e-4])


def each(edit: Callable) -> Callable:
    """The same edit in every swing."""

    def put(session: Session) -> None:
        for scene in session.scenes:
            edit(scene)

    return put


def base_changes(session: Session) -> list[Change]:
    """What all swings share: body, dimensions, gravity, the phone's pose."""
    changes, tiny = [], 1e-5
    size = session.hull.mass_kg * session.hull.k_yaw_m**2
    for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)):
        tensor = np.zeros((3, 3))
        tensor[i, j] = tensor[j, i] = size * tiny
        put = lambda s, t=tensor: setattr(s, "inertia_kg_m2", s.inertia_kg_m2 + t)
        changes.append(Change(each(put), tiny, prior=LOOSE["inertia"]))
    changes.append(Change(each(lambda s: s.centre_m.__iadd__([0, 0, -tiny])), tiny, prior=LOOSE["depth"]))
    changes.append(Change(each(lambda s: setattr(s, "gravity_m_s2", s.gravity_m_s2 + tiny)), tiny))
    changes += [Change(lambda s, n=n: lengthen(s, n, tiny), tiny) for n in range(len(session.tapes))]
    for way in tiny * np.eye(3):
        put = lambda s, w=way: setattr(s.phone, "position_m", s.phone.position_m + w)
        changes.append(Change(each(put), tiny, phone_only=True, prior=LOOSE["place"]))
        changes.append(Change(lambda s, w=way: turn_phone(s, w), tiny, phone_only=True))
    return changes


def lengthen(session: Session, number: int, by: float) -> None:
    """A dimension is another than thought, in all swings that share it."""
    tape = session.tapes[number]
    tape.true_m += by
    for n in tape.scenes:
        scene = session.scenes[n]
        if tape.what == "line":
            scene.line_m = scene.line_m + by
        else:
            ratio = scene.top_spacing_m / scene.spacing_m
            scene.spacing_m += by
            scene.top_spacing_m = scene.spacing_m * ratio


def turn_phone(session: Session, way: np.ndarray) -> None:
    """The phone is taped on otherwise."""
    for scene in session.scenes:
        scene.phone.phone_from_hull = rb.product(rb.turn(way[:, None]), scene.phone.phone_from_hull)


def swing_changes(session: Session, n: int) -> list[Change]:
    """A swing's release along its four small motions, and its six damping rates."""
    changes, tiny = [], 1e-5

    def released(name: str, shape: np.ndarray) -> Callable:
        return lambda s: setattr(s.scenes[n], name, getattr(s.scenes[n], name) + shape)

    def damped(axis: int, amount: float) -> Callable:
        return lambda s: s.scenes[n].extras["linear"].__setitem__((0, axis), s.scenes[n].extras["linear"][0, axis] + amount)

    for mode in session.hungs[n].modes.values():
        shape = mode.shape / np.abs(mode.shape).max()
        changes.append(Change(released("move", tiny * shape), tiny, n))
        changes.append(Change(released("rate", tiny * shape), tiny, n))
    for axis in range(6):
        amount = 1e-3 * session.scenes[n].extras["linear"][0, axis]
        changes.append(Change(damped(axis, amount), 1e-3, n))
    return changes


def biases(session: Session, n: int, size: int, drift: bool) -> np.ndarray:
    """Columns of a constant, and of a line in time, on each channel of both sensors."""
    times = session.scenes[n].shown_s[:: every(session.scenes[n])]
    shapes = [np.ones_like(times)] + ([times - times.mean()] if drift else [])
    columns = []
    for sensor in (0, 1):
        for axis in range(3):
            for shape in shapes:
                block = np.zeros((2, times.size, 3))
                block[sensor, :, axis] = shape
                columns.append(block.ravel())
    return np.array(columns).T.reshape(size, -1)


def basis(columns: np.ndarray) -> np.ndarray:
    """Orthonormal columns of the same span, by way of the columns' products; directions without effect are left out."""
    norms = np.linalg.norm(columns, axis=0)
    kept = columns[:, norms > 0] / norms[norms > 0]
    values, vectors = np.linalg.eigh(kept.T @ kept)
    strong = values > SAME * values[-1]
    once = kept @ (vectors[:, strong] / np.sqrt(values[strong]))
    return np.linalg.qr(once)[0]


class Reduced:
    """Readings with everything that the base model absorbs taken away."""

    def __init__(self, study: Study, drift_in_base: bool):
        session = study.session
        self.own = []
        for n, size in enumerate(study.rows()[:-1]):
            columns = np.array([study.difference(c)[n] for c in swing_changes(session, n)]).T
            self.own.append(basis(np.hstack([columns, biases(session, n, size, drift_in_base)])))
        shared = base_changes(session)
        self.padding = sum(c.prior is not None for c in shared)
        columns, row = [], 0
        for change in shared:
            prior = np.zeros(self.padding)
            if change.prior is not None:
                prior[row], row = 1 / change.prior, row + 1
            columns.append(np.concatenate([self.stripped(study.difference(change)), prior]))
        self.shared = basis(np.array(columns).T)

    def stripped(self, parts: list[np.ndarray]) -> np.ndarray:
        """Less what each swing's own parameters absorb."""
        left = [part - own @ (own.T @ part) for part, own in zip(parts, self.own)]
        return np.concatenate([*left, parts[-1]])

    def orthogonal(self, parts: list[np.ndarray]) -> np.ndarray:
        """Less what the whole base model absorbs."""
        v = np.concatenate([self.stripped(parts), np.zeros(self.padding)])
        v = v - self.shared @ (self.shared.T @ v)
        return v - self.shared @ (self.shared.T @ v)


def probe_change(name: str, parameters: dict) -> Change:
    """A weak sample of a cause."""
    effect = EFFECTS[name]
    share = 1.0 if effect.whole else effect.weak
    return Change(lambda s: effect.put(s, parameters, share), share, phone_only=effect.phone_only)


def exchanged(other: Session, unit: float) -> Change:
    """Another session in place of the one that is studied."""

    def put(session: Session) -> None:
        session.scenes[:], session.tapes[:] = other.scenes, other.tapes

    return Change(put, unit)


def tangent(study: Study, make: Callable, n: int, hidden: list) -> list[np.ndarray]:
    """The hidden effect's whole strength, from BACK of it more and less; a threshold's from with and without.

    To one side only, what bends would be left: of an effect that the base absorbs but for a thousandth more than that."""
    at = lambda share: make([share if k == n else 1.0 for k in range(len(hidden))])
    if ALL[hidden[n].name].whole:
        return study.difference(exchanged(at(0.0), -1.0))
    return study.central(exchanged(at(1.0 + BACK), BACK), exchanged(at(1.0 - BACK), -BACK))


def ways(study: Study, reduced: Reduced, make: Callable, hidden: list, k: int) -> list[np.ndarray]:
    """How a hidden effect may change: by each number that it has. Beside the other effect all of them are open."""
    other = lambda changed: make([*hidden[:k], replace(hidden[k], parameters=changed), *hidden[k + 1 :]])
    both = zip(neighbours(hidden[k].parameters, 1.0), neighbours(hidden[k].parameters, -1.0))
    changes = [study.central(exchanged(other(more), 1.0), exchanged(other(less), -1.0)) for more, less in both]
    return [reduced.orthogonal(change) for change in changes]


def neighbours(parameters: dict, way: float) -> list[dict]:
    """Parameters with one number in turn a little off, one way (1) or the other (-1): by BACK of itself (of its vector's length), a
    moment by one sample kept."""
    found = []
    for key, value in parameters.items():
        if isinstance(value, float) and np.isfinite(value):
            found.append({**parameters, key: value + way * (MOMENT_S if key == "at_s" else BACK * value)})
        elif isinstance(value, list) and all(isinstance(v, float) for v in value):
            size = way * BACK * np.linalg.norm([v for v in value if np.isfinite(v)])
            changed = lambda k, v=value, by=size: [*v[:k], v[k] + by, *v[k + 1 :]]
            found += [{**parameters, key: changed(k)} for k, v in enumerate(value) if np.isfinite(v)]
    return found


def planes(study: Study, reduced: Reduced, hidden: list) -> dict[str, np.ndarray]:
    """Each other cause's directions (columns), what the base absorbs taken away."""
    found = {}
    for name, effect in EFFECTS.items():
        if name in CAUSES_IN_BASE or any(h.name == name for h in hidden):
            continue
        if name == "internal_motion" and any("sliders" in h.parameters for h in hidden):
            continue
        columns = [reduced.orthogonal(study.difference(probe_change(name, p))) for p in effect.probes(study.session)]
        found[name] = np.array(columns).T
    return found


def span(columns: np.ndarray) -> np.ndarray:
    """Orthonormal columns of a cause's directions that are not faint."""
    u, s, _ = np.linalg.svd(columns, full_matrices=False)
    return u[:, s > max(FAINT * s[0], 1e-9)] if s[0] > 0 else u[:, :0]


def one_slider(study: Study, reduced: Reduced, hidden, k: int) -> np.ndarray:
    """How a single slosh may change: the one of two sliders that it explains, in mass, frequency, damping, way and place, and in each swing
    where it is and how fast at the release, which nobody states. To both sides, like what it stands beside: what bends cancels. Each is one
    long: by its step alone the mass of a slider that hardly moves would be faint beside its start."""
    slider = hidden.parameters["sliders"][k]
    way = slider["way"]
    across = np.array([-way[1], way[0], 0.0])
    steps = [(key, share * slider[key]) for key, share in SLIDER_STEPS.items()]
    steps += [("way", 0.02 * across), *(("place_m", 0.02 * axis) for axis in np.eye(3))]
    pairs = [[with_slider(hidden, k, key, np.array(slider[key]) + sign * step, sign) for sign in (1, -1)] for key, step in steps]
    starts = np.diag([START_M, 2 * np.pi * slider["frequency_hz"] * START_M])
    pairs += [[started(n, k, sign * s, sign) for sign in (1, -1)] for n in range(len(study.session.scenes)) for s in starts]
    columns = np.array([reduced.orthogonal(study.central(*pair)) for pair in pairs]).T
    return columns / np.linalg.norm(columns, axis=0)


def with_slider(hidden, k: int, key: str, value: np.ndarray, unit: float) -> Change:
    """Another value of one of a slider's parameters."""
    sliders = [dict(s) for s in hidden.parameters["sliders"]]
    sliders[k][key] = value
    return Change(lambda s: OUTSIDE["second_slosh"].put(s, {"sliders": sliders}, 1.0), unit)


def started(swing: int, k: int, start: np.ndarray, unit: float) -> Change:
    """A slider that is let go in a swing from elsewhere, or with a speed."""
    return Change(lambda s: s.scenes[swing].extras["slider_start"][0].__setitem__(k, start), unit, swing)


def beyond(signal: np.ndarray, columns: np.ndarray) -> float:
    """What is left of a signal beside a cause's directions."""
    u = span(columns)
    return float(np.linalg.norm(signal - u @ (u.T @ signal)))


def standing_out(session: Session, hidden: list) -> tuple[Study, Reduced, list[np.ndarray]]:
    """The session linearised, the base model's freedoms, and each hidden effect's signal beside these."""
    from sessions import spoiled

    make = lambda shares: spoiled(session, hidden, shares)
    linear = Study(make([1.0] * len(hidden)))
    reduced = Reduced(linear, not any(h.name in CAUSES_IN_BASE for h in hidden))
    return linear, reduced, [reduced.orthogonal(tangent(linear, make, n, hidden)) for n in range(len(hidden))]


def study(session: Session, hidden: list) -> dict:
    """Signals in standard deviations and cosines, for the truth file."""
    from sessions import spoiled

    drawn = lambda other: spoiled(session, other)
    linear, reduced, signals = standing_out(session, hidden)
    others = planes(linear, reduced, hidden)
    report = {"others": {name: float(np.linalg.norm(c, 2)) for name, c in others.items()}, "effects": []}
    for n, signal in enumerate(signals):
        beside = [k for k in range(len(hidden)) if k != n]
        rivals = others | {
            hidden[k].name: np.column_stack([signals[k], *ways(linear, reduced, drawn, hidden, k)]) for k in beside
        }
        report["effects"].append(confusable(signal, hidden[n].name, rivals))
        report["effects"][n]["beside_others_sigma"] = min([beyond(signal, rivals[hidden[k].name]) for k in beside], default=None)
        if hidden[n].name == "second_slosh":
            single = [beyond(signal, one_slider(linear, reduced, hidden[n], k)) for k in (0, 1)]
            report["effects"][n]["beyond_best_cause_sigma"] = min(single)
    return report


def confusable(signal: np.ndarray, name: str, rivals: dict[str, np.ndarray]) -> dict:
    """An effect's signal beside all causes that it may be taken for."""
    size = float(np.linalg.norm(signal))
    left = {rival: beyond(signal, columns) for rival, columns in rivals.items()}
    cosines = {rival: float(np.sqrt(max(0.0, 1 - (v / size) ** 2))) if size > 0 else 0.0 for rival, v in left.items()}
    nearest = max(cosines, key=cosines.get)
    return {"name": name, "signal_sigma": size, "largest_cosine": cosines[nearest], "nearest": nearest,
            "beyond_best_cause_sigma": left[nearest], "cosines": cosines}  # fmt: skip
