"""What is wrong with the phone, or with how it sits."""

from __future__ import annotations

import numpy as np
from borrowed import blind, rb
from effect import EFFECTS, Session, none_of, register, relative
from scene import Mount, Slip, move, sense


def put_drift(session: Session, p: dict, share: float) -> None:
    """A sensor that warms up, anew in each swing."""
    for scene in session.scenes:
        scene.flaws.gyro_drift = scene.flaws.gyro_drift + share * np.array(p["gyro_rad_s"])
        scene.flaws.acc_drift = scene.flaws.acc_drift + share * np.array(p["acc_m_s2"])
        scene.flaws.drift_s = p["time_s"]


def draw_drift(rng, session: Session) -> dict:
    way = lambda: rng.normal(size=3) / np.sqrt(3)
    strength = blind.log_uniform(rng, 3e-5, 3e-3)
    return {"gyro_rad_s": (strength * way()).tolist(), "acc_m_s2": (10 * strength * way()).tolist(),
            "time_s": blind.log_uniform(rng, 40, 600)}  # fmt: skip


def put_clock(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        scene.flaws.clock += share * p["relative"]


def put_gyro_scale(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        scene.flaws.gyro_scale += share * p["relative"]


def peaks(session: Session) -> dict[str, tuple[float, float]]:
    """By sensor: the largest reading of any axis in the session, and what that axis mostly reads."""
    both = [sense(s, move(s, 0.05, 5), 5) for s in session.scenes]
    found = {}
    for sensor, k in (("gyro", 0), ("acc", 1)):
        size = np.abs(np.concatenate([pair[k] for pair in both]))
        axis = int(size.max(0).argmax())
        found[sensor] = float(size[:, axis].max()), float(np.median(size[:, axis]))
    return found


def put_saturation(session: Session, p: dict, share: float) -> None:
    if share == 0:
        return
    for scene in session.scenes:
        setattr(scene.flaws, f"{p['sensor']}_limit", p["limit"])


def draw_saturation(rng, session: Session) -> dict:
    """A range that cuts the upper part of what goes beyond the usual."""
    sensor = str(rng.choice(["gyro", "acc"]))
    peak, usual = peaks(session)[sensor]
    return {"sensor": sensor, "limit": peak - rng.uniform(0.05, 0.6) * (peak - usual)}


def probe_saturation(session: Session) -> list[dict]:
    return [{"sensor": sensor, "limit": peak - 0.2 * (peak - usual)} for sensor, (peak, usual) in peaks(session).items()]


def put_slip(session: Session, p: dict, share: float) -> None:
    """In one swing; later swings begin with the phone as it then is."""
    turn, shift = share * np.array(p["turn_rad"]), share * np.array(p["shift_m"])
    session.scenes[p["swing"]].flaws.slips.append(Slip(p["at_s"], turn, shift))
    for scene in session.scenes[p["swing"] + 1 :]:
        scene.phone.phone_from_hull = rb.product(rb.turn(-turn[:, None]), scene.phone.phone_from_hull)
        scene.phone.position_m = scene.phone.position_m + shift


def draw_slip(rng, session: Session) -> dict:
    swing, way = int(rng.integers(len(session.scenes))), rng.normal(size=3)
    angle = blind.log_uniform(rng, 5e-4, 5e-2)
    when, turn = session.scenes[swing].shown_s[-1] * rng.uniform(0.15, 0.85), angle * way / np.linalg.norm(way)
    return {"swing": swing, "at_s": when, "turn_rad": turn.tolist(), "shift_m": (0.1 * angle * rng.normal(size=3)).tolist()}


def probe_slip(session: Session) -> list[dict]:
    return [
        {"swing": n, "at_s": 60.0, "turn_rad": (1e-3 * way).tolist(), "shift_m": [0.0] * 3}
        for n in range(len(session.scenes)) for way in np.eye(3)
    ]  # fmt: skip


def put_mount(session: Session, p: dict, share: float) -> None:
    for scene in session.scenes:
        om = 2 * np.pi * p["frequency_hz"]
        scene.flaws.mount = Mount(om, p["damping_ratio"], np.array(p["axis"]), np.array(p["lever_per_m"]), share)


def draw_mount(rng, session: Session) -> dict:
    """A phone on foam or on a stick; the lever is across the axis."""
    axis = rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    lever = np.cross(axis, rng.normal(size=3))
    lever *= blind.log_uniform(rng, 0.5, 5) / np.linalg.norm(lever)
    return {"frequency_hz": blind.log_uniform(rng, 2, 15), "damping_ratio": blind.log_uniform(rng, 0.02, 0.15),
            "axis": axis.tolist(), "lever_per_m": lever.tolist()}  # fmt: skip


def probe_mount(session: Session) -> list[dict]:
    return [
        {"frequency_hz": 5.0, "damping_ratio": 0.05, "axis": axis.tolist(), "lever_per_m": lever.tolist()}
        for axis, lever in zip(np.eye(3), np.roll(np.eye(3), 1, 0))
    ]


register(EFFECTS, "bias_drift", draw_drift, put_drift, none_of, phone_only=True)
register(EFFECTS, "clock_scale", relative(3e-4, 2e-2), put_clock, lambda _: [{"relative": 1e-3}])
register(EFFECTS, "gyro_scale", relative(1e-3, 3e-2), put_gyro_scale, lambda _: [{"relative": 1e-3}], phone_only=True)
register(EFFECTS, "saturation", draw_saturation, put_saturation, probe_saturation, phone_only=True, whole=True)
register(EFFECTS, "phone_slip", draw_slip, put_slip, probe_slip, phone_only=True)
register(EFFECTS, "phone_mount_resonance", draw_mount, put_mount, probe_mount, phone_only=True)
