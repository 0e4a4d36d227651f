"""What an effect is, the session that it changes, and the two lists of effects.

Each effect has `draw` (a strength of everyday size, log-uniform, from barely detectable to strong), `put` (change a session by a
share of it; shares near 0 and 1 give sensitivities) and `probes`, weak samples of a cause with which another may be confused.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from borrowed import blind
from scene import Scene


@dataclass
class Tape:
    """A dimension read off a tape: true, stated, and which scenes share it."""

    what: str  # line or spacing
    true_m: float
    stated: dict
    scenes: list[int]
    offset_m: float = 0.0  # a mistake on top of the stated uncertainty


@dataclass
class Session:
    """One hull's swings as they truly are."""

    hull: blind.Hull
    hungs: list
    scenes: list[Scene]
    tapes: list[Tape]
    amplitudes: list[dict] = field(default_factory=list)

    def copy(self) -> "Session":
        """For changing: scenes and tapes are new, the rest is shared."""
        tapes = [Tape(t.what, t.true_m, t.stated, t.scenes, t.offset_m) for t in self.tapes]
        return Session(self.hull, self.hungs, [s.copy() for s in self.scenes], tapes, self.amplitudes)

    def omega(self, mode: str) -> float:
        """Of a small motion in the first swing, rad/s."""
        return self.hungs[0].modes[mode].omega_rad_s

    def weight_n(self) -> float:
        """All that hangs."""
        return self.hull.mass_kg * self.hull.gravity_m_s2

    def line_m(self) -> float:
        """Of the first swing."""
        return self.scenes[0].line_m.mean()

    def spacing_m(self) -> float:
        """Of the first swing."""
        return self.scenes[0].spacing_m

    def yaw_stiffness(self) -> float:
        """m g d²/l of the first swing, N m/rad."""
        return self.weight_n() * self.spacing_m() ** 2 / (4 * self.line_m())


@dataclass
class Effect:
    """A way to be wrong."""

    name: str
    draw: Callable
    put: Callable  # (session, parameters, share)
    probes: Callable  # session -> list of parameters
    two_rigs: bool = False  # one geometry cannot show it
    phone_only: bool = False  # the hull moves as without it
    whole: bool = False  # not proportional: compare with and without
    weak: float = 0.02  # share of a probe that is small enough; more where a small share means stiff


EFFECTS: dict[str, Effect] = {}  # by the critique's names of causes
OUTSIDE: dict[str, Effect] = {}  # for which it has no name


def register(into: dict, *args, **more) -> None:
    """Add an effect to a list."""
    effect = Effect(*args, **more)
    into[effect.name] = effect


def none_of(_: Session) -> list[dict]:
    """No probes."""
    return []


def sign(rng) -> float:
    """Up or down."""
    return float(rng.choice([-1.0, 1.0]))


def everywhere(session: Session, name: str, value, share: float) -> None:
    """Add a share to a field of every swing's rig."""
    for scene in session.scenes:
        scene.extras[name] += share * np.asarray(value)


def relative(low: float, high: float, either: bool = True) -> Callable:
    """A relative strength, of either sign."""
    return lambda rng, _: {"relative": blind.log_uniform(rng, low, high) * (sign(rng) if either else 1.0)}
