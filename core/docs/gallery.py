"""Draws the gallery: what each effect does to a swing (`make gallery`).

Of each effect of the hull and its rig: the swing less that of the same hull without the effect, and the period and the
logarithmic decrement of each swing against its amplitude. Of each effect of the sensors: a reading less that of sensors
without it.
"""

from __future__ import annotations

import io
from pathlib import Path

import gyradius
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image
from scipy.interpolate import make_interp_spline

HERE = Path(__file__).parent
SOURCES = HERE.parent / "src" / "dynamics"
COLOURS = 24
#: Every hull here swings in a little air, so that one swing shows all amplitudes: 2 % less from swing to swing.
AIR = {"id": "linear_damping", "yaw_n_m_s": 6.3, "surge_n_s_m": 6.6, "sway_n_s_m": 6.6}
Numbers = dict[str, float]
YAW, SWAY = {"yaw_deg": 10.0}, {"sway_m": 0.35}
#: Effect, its numbers at a strength that shows, the swing that shows it, and what to see.
HULL: list[tuple[str, Numbers, Numbers, str]] = [
    ("linear_damping", {"yaw_n_m_s": 4.0}, YAW, "The decrement grows by the same at every amplitude."),
    ("quadratic_drag", {"yaw_torque_coefficient": 30.0}, YAW, "The decrement grows in proportion to the amplitude."),
    ("power_law_damping", {"exponent": 0.3, "yaw_n_m_s": 4.0}, YAW, "The decrement grows with a power of it."),
    ("bearing_friction", {"yaw_n_m": 0.4, "transition_rad_s": 1e-3}, YAW, "Small swings die sooner."),
    ("presliding_bearing", {"yaw_n_m": 0.8, "give_rad": 0.01}, YAW, "Small swings are faster and die sooner."),
    ("added_mass", {"yaw_kg_m2": 3.0}, YAW, "The period is longer by the same part at every amplitude."),
    ("amplitude_added_mass", {"yaw_kg_m2_rad": 30.0}, YAW, "The period grows too fast with the amplitude."),
    ("line_creep", {"strain_per_decade": 1e-3, "loaded_before_s": 60.0}, SWAY, "The period grows with time."),
    ("line_stretch", {"force_per_strain_n": 4e5}, SWAY, "The lines are longer under the load: so is the period."),
    ("line_torsion", {"stiffness_n_m_rad": 10.0}, YAW, "The yaw is faster by the same part at every amplitude."),
    ("line_mass", {"linear_density_kg_m": 0.3}, SWAY, "The sway is faster by a trace."),
    ("nonparallel_lines", {"excess_m": 0.02}, YAW, "The yaw is faster; the sway hardly."),
    ("unequal_lines", {"difference_m": 0.03}, YAW, "The yaw feeds another mode, and is soon no swing of its own."),
    ("off_centre_cm", {"to_port_m": 0.03}, YAW, "Yaw and surge mix: the yaw is slower."),
    ("stated_length", {"excess_m": 0.01}, YAW, "Every swing on the lines is slower by half of the part."),
    ("stated_spacing", {"excess_m": 0.01}, YAW, "The yaw alone is faster."),
    (
        "support_compliance",
        {"mass_kg": 150.0, "stiffness_x_n_m": 1e5, "stiffness_y_n_m": 1e5, "damping_y_n_s_m": 400.0},
        SWAY,
        "The sway is slower, and dies in the gantry; the yaw is as it was.",
    ),
    (
        "internal_motion",
        {"mass_kg": 10.0, "place_z_m": -0.5, "along_y": 1.0, "stiffness_n_m": 80.0, "damping_n_s_m": 8.0},
        SWAY,
        "Water or gear moves along: it changes the period and takes the swing's energy.",
    ),
    (
        "wind",
        {"force_coefficient": 2.0, "gust_m_s": 1.0, "gust_time_s": 4.0, "seed": 7.0, "centre_x_m": 0.3},
        YAW,
        "Every swing is another: what is left over grows and shrinks at the hull's own period.",
    ),
    ("buoyancy", {"displaced_air_kg": 0.8}, SWAY, "Slower by half of the air's part of the mass."),
    ("knock", {"at_s": 30.0, "over_s": 0.1, "turn_z_n_m_s": 1.0}, YAW, "From one moment on it is another swing."),
    ("line_slip", {"at_s": 30.0, "over_s": 0.3, "positive_m": 0.01}, YAW, "From one moment on the hull hangs aslant."),
    (
        "learned_force",
        {"coordinate": 3.0, "scale_of_position": 0.1, "scale_of_rate": 0.1, "xxx": 0.3},
        YAW,
        "A force of any shape: here a spring that hardens.",
    ),
]
#: Effect, its numbers, whether the accelerometer shows it (else the gyroscope).
SENSORS: list[tuple[str, Numbers, bool]] = [
    ("phone_slip", {"at_s": 10.0, "over_s": 0.5, "turn_x_rad": 0.01}, True),
    ("phone_mount_resonance", {"turn_hz": 4.0, "damping_ratio": 0.05}, False),
    ("clock_scale", {"error": 1e-3}, False),
    ("jitter", {"stamp_s": 2e-3}, False),
    ("drop_outs", {"share": 0.3, "stall_at_s": 12.0, "stall_s": 4.0}, False),
    ("delay", {"gyro_s": 5e-3}, False),
    ("low_pass", {"gyro_time_constant_s": 0.02}, False),
    ("bias_drift", {"gyro_rate_z_rad_s2": 5e-5, "gyro_warm_z_rad_s": 2e-3, "warm_up_s": 6.0}, False),
    ("gyro_scale", {"z": 0.01}, False),
    ("acc_scale", {"y": 0.01}, True),
    ("cross_axis", {"acc_yz": 0.01}, True),
    ("white_noise", {"gyro_rad_s": 2e-3}, False),
    ("coloured_noise", {"gyro_rad_s": 1e-3}, False),
    ("saturation", {"gyro_rad_s": 0.2}, False),
    ("quantisation", {"gyro_rad_s": 0.01}, False),
]


def swing(start: Numbers, effects: list[dict], duration_s: float, seed: int | None = None) -> gyradius.Simulation:
    """The paper's keelboat, the phone half a metre forward and to port."""
    suspension = {"kind": "bifilar", "orientation": "athwartships", "line_length": 3.477, "spacing": 1.8}
    truth = {
        "k_roll_m": 0.625, "k_pitch_m": 1.156, "k_yaw_m": 1.0566, "cm_depth_m": 0.4,
        "position_x_m": 0.5, "position_y_m": 0.5, "duration_s": duration_s, "rate_hz": 50.0, **start,
    }  # fmt: skip
    one = {"id": "one", "recording": "one.csv", "suspension": suspension, "truth": truth}
    return gyradius.read_rig({"body": {"mass": 622.7}, "swing": [one], "effect": effects}).simulate(seed=seed)


def displacement(found: gyradius.Simulation, start: Numbers) -> tuple[np.ndarray, str, str]:
    """What swings: the heading, or the sideways place."""
    if start is YAW:
        w, x, y, z = found.attitude.T
        return np.degrees(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))), "yaw", "°"
    return 1e3 * found.position_m[:, 1], "sway", "mm"


def by_amplitude(t_s: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Amplitude, period and logarithmic decrement of each full swing, from zeros and extremes of a spline."""
    curve = make_interp_spline(t_s, x, k=5)
    slope = curve.derivative()
    i = np.flatnonzero(x[:-1] * x[1:] < 0)
    zeros = t_s[i] + (t_s[i + 1] - t_s[i]) * x[i] / (x[i] - x[i + 1])
    for _ in range(4):
        zeros -= curve(zeros) / slope(zeros)
    sizes = np.array([np.abs(curve(np.linspace(a, b, 400))).max() for a, b in zip(zeros[:-1], zeros[1:], strict=True)])
    return sizes[1:-1], zeros[2:-1] - zeros[:-3], np.log(sizes[:-2] / sizes[2:])


def draw(effect: str, numbers: Numbers, start: Numbers) -> None:
    """The picture of one effect of the hull and its rig."""
    base, found = swing(start, [AIR], 240.0), swing(start, [AIR, {"id": effect, **numbers}], 240.0)
    (without, what, unit), (x, _, _) = displacement(base, start), displacement(found, start)
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(9, 2.5), layout="constrained", width_ratios=[1.5, 1, 1])
    left.plot(found.t_s, x - without, lw=0.6)
    left.set(xlabel="time, s", ylabel=f"residual {what}, {unit}", xlim=(0, 240))
    for values, style in [(without, dict(color="0.8", lw=7, solid_capstyle="round")), (x, dict(ls="", marker=".", ms=3))]:
        size, period, decrement = by_amplitude(found.t_s, values)
        middle.plot(size, period, **style)
        right.plot(size, 100 * decrement, **style)
    figure.get_layout_engine().set(w_pad=0.1)
    for axes, label, least in [(middle, "period, s", 2e-3), (right, "log. decrement, %", 0.2)]:
        axes.set(xlabel=f"amplitude, {unit}", ylabel=label)
        axes.ticklabel_format(useOffset=False)
        at_least(axes, least)
    save(figure, effect)


def at_least(axes: plt.Axes, height: float) -> None:
    """An axis of values that are all alike does not magnify their rounding."""
    low, high = axes.get_ylim()
    if high - low < height:
        middle = 0.5 * (low + high)
        axes.set_ylim(middle - 0.5 * height, middle + 0.5 * height)


def draw_sensors() -> None:
    """One picture of all effects of the sensors."""
    figure, grid = plt.subplots(5, 3, figsize=(9, 8), layout="constrained", sharex=True)
    start = {"yaw_deg": 10.0, "sway_m": 0.1, "held_s": 4.0}
    base = swing(start, [], 24.0)
    for (effect, numbers, felt), axes in zip(SENSORS, grid.flat, strict=True):
        found = swing(start, [{"id": effect, **numbers}], 24.0, seed=3)
        axis, read = (1, lambda s: s.acc_m_s2) if felt else (2, lambda s: s.gyro_rad_s)
        without = make_interp_spline(base.t_s, read(base)[:, axis], k=1)
        kept = found.t_s <= base.t_s[-1]
        lone = dict(ls="", marker=".", ms=1.5) if effect in ("drop_outs", "jitter") else dict(lw=0.6)
        values = read(found)[:, axis] - (0 if effect == "drop_outs" else without(found.t_s))
        axes.plot(found.t_s[kept], 1e3 * values[kept], **lone)
        axes.set_title(effect, fontsize=9)
        axes.set_ylabel("acc. y, mm/s²" if felt else "gyro z, mrad/s", fontsize=8)
        axes.tick_params(labelsize=8)
    for axes in grid[-1]:
        axes.set(xlabel="time, s", xlim=(0, 24))
    save(figure, "sensors")


def save(figure: plt.Figure, name: str) -> None:
    """Few colours make a small file."""
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=80)
    plt.close(figure)
    image = Image.open(drawn).convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
    image.save(HERE / "gallery" / f"{name}.png", optimize=True)


def registered(room: str) -> list[str]:
    """The effects of a room's registry, as their files tell them."""
    lines = [line for file in (SOURCES / room).glob("*.rs") for line in file.read_text().splitlines()]
    return sorted(line.split('"')[1] for line in lines if line.strip().startswith("const ID: &'static str = "))


def listed(numbers: Numbers) -> str:
    """The numbers of an effect, as text."""
    return ", ".join(f"`{name} = {value:g}`" for name, value in numbers.items())


def page() -> str:
    """The text around the pictures."""
    lines = [
        "# What each effect looks like",
        "",
        "The paper's keelboat (622.7 kg, lines of 3.477 m, 1.8 m apart) for four minutes, from a yaw of 10 degrees or",
        "a sway of 0.35 m; a light linear damping lets the amplitude pass from there to a third. Left: the swing less",
        "that of the same hull without the effect. Middle and right: period and logarithmic decrement of each swing",
        "against its amplitude; the broad grey line is without the effect. The equations, their sources and the meaning of",
        "the numbers stand in `../crates/mechanics/src/effects/` and `../crates/mechanics/src/sensors/`. Made by `make gallery`.",
    ]
    for effect, numbers, start, text in HULL:
        kind = "yaw" if start is YAW else "sway"
        lines += [
            "",
            f"## {effect}",
            "",
            f"{text} A {kind} with {listed(numbers)}.",
            "",
            f"![{effect}](gallery/{effect}.png)",
        ]
    lines += [
        "",
        "## The sensors",
        "",
        "Yaw and sway together, held for four seconds and let go: a reading less that of sensors without the effect",
        "(of `drop_outs` the reading itself). Amplitudes and periods stay as they are, but for `clock_scale`.",
        "",
        "![sensors](gallery/sensors.png)",
        "",
        *(f"- `{effect}`: {listed(numbers)}" for effect, numbers, _ in SENSORS),
    ]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Draws all and writes the page."""
    for room, shown in [("effects", HULL), ("sensors", SENSORS)]:
        missing = set(registered(room)) ^ {one[0] for one in shown}
        if missing:
            raise SystemExit(f"not shown, or not there: {', '.join(sorted(missing))}")
    (HERE / "gallery").mkdir(exist_ok=True)
    for effect, numbers, start, _ in HULL:
        draw(effect, numbers, start)
    draw_sensors()
    (HERE / "gallery.md").write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
