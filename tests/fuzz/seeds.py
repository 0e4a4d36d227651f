"""Sessions and exports that are whole: what the fuzz starts from.

Motions are closed forms of small swings, sampled for some fifteen seconds, so that each is measured in a fraction of a second.
"""

from __future__ import annotations

import io
import math
import random
import struct
import zipfile
import zlib
from pathlib import Path

from inputs import Input

FIXTURES = Path(__file__).resolve().parents[2] / "core/crates/recording/tests/fixtures/import"

GRAVITY = 9.81
LINE_LENGTH, SPACING, K_YAW, K_PITCH, DEPTH = 1.0, 1.0, 0.9, 1.0, 0.3
Columns = list[list[float]]


def recording(seed: int, seconds: float, rate_hz: float, yaw: float = 0.1, sway: float = 0.05, pitch: float = 0.0) -> Columns:
    """Columns t, gx, gy, gz, ax, ay, az of a phone that lies level on a hull in small swings."""
    noise = random.Random(seed).gauss
    w_yaw = SPACING / 2 / K_YAW * math.sqrt(GRAVITY / LINE_LENGTH)
    w_sway = math.sqrt(GRAVITY / LINE_LENGTH)
    w_pitch = math.sqrt(GRAVITY * (DEPTH + 1.0) / (K_PITCH**2 + (DEPTH + 1.0) ** 2))
    rows = []
    for i in range(int(seconds * rate_hz)):
        t = i / rate_hz
        turn, shift, nod = (
            a * math.exp(-t / 150)
            for a in (yaw * math.cos(w_yaw * t), sway * math.cos(w_sway * t), pitch * math.cos(w_pitch * t))
        )
        nod_rate = -pitch * w_pitch * math.sin(w_pitch * t) * math.exp(-t / 150)
        turn_rate = -yaw * w_yaw * math.sin(w_yaw * t) * math.exp(-t / 150)
        values = [0.0, nod_rate, turn_rate, -GRAVITY * nod, -(w_sway**2) * shift - 0.5 * w_yaw**2 * turn, GRAVITY]
        rows.append([t, *(value + noise(0, 2e-3 if j < 3 else 2e-2) for j, value in enumerate(values))])
    return [list(column) for column in zip(*rows)]


def table(header: str, columns: Columns, separator: str = ",") -> bytes:
    """A CSV."""
    rows = [separator.join(f"{value:.7g}" for value in row) for row in zip(*columns)]
    return "\n".join([separator.join(header.split(",")), *rows, ""]).encode()


NATIVE = "t,gx,gy,gz,ax,ay,az"
HEAD = """\
format = "gyradius-session/1"
title = "fuzz"

[body]
name = "hull"
mass = { value = 100.0, u = 0.1 }
length_overall = 4.0
density = 750.0

[site]
gravity = { value = 9.81, u = 5e-4 }
air_density = 1.20
"""
BIFILAR = """\
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = { value = 1.0, u = 0.003 }
spacing = { value = 1.0, u = 0.001 }
"""
TILTED = BIFILAR + "top_spacing = { value = 1.05, u = 0.002 }\nhull_pitch_deg = { value = 30.0, u = 0.2 }\n"
COMPOUND = """\
[swing.suspension]
kind = "compound"
orientation = "athwartships"
axis_height = { value = 1.0, u = 0.002 }
"""
ATTACHMENTS = """
[[attachment]]
name = "beam"
mass = 1.2
position = [0.05, 0.0, 0.02]
gyradii = [0.60, 0.05, 0.60]

[[attachment]]
name = "phone"
mass = { value = 0.2, u = 0.005 }
position = [0.5, 0.1, 0.0]
gyradii = [0.04, 0.04, 0.05]
"""
INCLINES = """
[[incline]]
end = "stern"
mass = { value = 1.0, u = 0.001 }
arm = { value = 1.5, u = 0.002 }
depth = { value = 0.03, u = 0.002 }
angle_deg = { value = 2.87, u = 0.05 }

[[incline]]
end = "bow"
mass = 1.0
arm = 1.5
depth = 0.03
angle_deg = 2.87
"""
TYPED = """
[[swing]]
id = "typed"
periods_s = { yaw = { value = 3.611, u = 0.004 }, sway = { value = 2.006, u = 0.004 } }
amplitude_deg = { yaw = 5.0 }
"""
PITCH = """
[[swing]]
id = "pitch"
periods_s = { pitch_in_phase = { value = 3.0, u = 0.004 }, pitch_out_of_phase = 1.6 }
"""
ROLL = """
[[swing]]
id = "roll"
periods_s = { roll_in_phase = 2.9, roll_out_of_phase = { value = 1.2, u = 0.01 } }
"""


def swing(name: str, data: str, more: str = "") -> str:
    """The head of a swing's table."""
    return f'\n[[swing]]\nid = "{name}"\n{data}\n{more}'


def recorder_file(columns: Columns) -> bytes:
    """The recorder's own file, by `core/docs/recorder-file.md`."""

    def text(word: str) -> bytes:
        return struct.pack("<I", len(word)) + word.encode()

    def block(kind: int, number: int, payload: bytes) -> bytes:
        head = struct.pack("<BII", kind, number, len(payload))
        whole = b"\x89GR1" + head + struct.pack("<I", zlib.crc32(head)) + payload
        return whole + struct.pack("<I", zlib.crc32(whole))

    stamps = [1_000_000_000 + round(1e9 * t) for t in columns[0]]
    sensors = [(0, "gyro", "rad/s", 17.45), (1, "acc", "m/s^2", math.nan)]
    described = b"".join(struct.pack("<B", s) + text(n) + text(u) + struct.pack("<d", f) for s, n, u, f in sensors)
    header = text("gyradius-recorder/1") + text("phone") + struct.pack("<I", 2) + described
    blocks = [(1, header + struct.pack("<I", 1) + text("operator") + text("fuzz"))]
    for first in range(0, len(stamps), 100):
        part = slice(first, first + 100)
        for stream in (0, 1):
            rows = list(zip(*(column[part] for column in columns[1 + 3 * stream : 4 + 3 * stream])))
            payload = struct.pack("<BI", stream, len(rows)) + struct.pack(f"<{len(rows)}q", *stamps[part])
            blocks.append((2, payload + b"".join(struct.pack("<3d", *row) for row in rows)))
    blocks += [(3, struct.pack("<q", stamps[10]) + text("release")), (3, struct.pack("<q", stamps[-1]) + text("end"))]
    return b"".join(block(kind, number, payload) for number, (kind, payload) in enumerate(blocks))


def zipped(files: dict[str, bytes]) -> bytes:
    """A zip with dates that are always the same."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0)), content)
    return out.getvalue()


def seeds() -> list[Input]:
    """Every whole input."""
    yaw_sway = recording(1, 14.0, 25.0)
    short = recording(2, 12.0, 20.0, yaw=0.05, sway=0.0)
    pitch = recording(3, 16.0, 20.0, yaw=0.0, sway=0.0, pitch=0.1)
    csv, csv2, csv3 = (table(NATIVE, columns) for columns in (yaw_sway, short, pitch))
    track = table("t,y", [yaw_sway[0], [0.05 * math.cos(3.1321 * t) for t in yaw_sway[0]]])
    listed = random.Random(5)
    periods = [2.006 + listed.gauss(0, 1e-3) for _ in range(24)]
    gate = table("t,period", [[2.006 * i for i in range(24)], periods])
    hung = 'excited = ["yaw", "sway"]\n'
    added = "added_mass = [ { mass = 1.2, position = [1.5, 0.0, 0.0] }, { mass = 1.2, position = [-1.5, 0.0, 0.0] } ]\n"

    def session(name: str, toml: str, **files: bytes) -> Input:
        named = {key.replace("_csv", ".csv"): content for key, content in files.items()}
        return Input(name, "session", {"session.toml": toml.encode(), **named})

    recorded = HEAD + swing("yaw", 'recording = "yaw.csv"', hung) + BIFILAR
    with_phone = (
        HEAD
        + ATTACHMENTS
        + swing("yaw", 'recording = "yaw.csv"', hung)
        + BIFILAR
        + TYPED.replace("3.611", "3.6855")
        + added
        + BIFILAR
    )
    compound = HEAD + swing("pendulum", 'recording = "pitch.csv"', 'excited = ["pitch"]\n') + COMPOUND
    compound += swing("pendulum-2", "periods_s = { compound = { value = 2.845, u = 0.003 } }") + COMPOUND.replace("1.0", "0.6")
    gates = HEAD + swing("track", 'displacement = "track.csv"\nat = [0.0, 0.0, 0.0]') + BIFILAR
    gates += (
        swing("gate", 'periods = "gate.csv"', "amplitude_deg = { sway = 3.0 }\n" + 'excited = ["sway"]\n')
        + BIFILAR
        + TYPED
        + BIFILAR
    )
    inclined = HEAD + INCLINES + swing("short", 'recording = "short.csv"', 'excited = ["yaw"]\n') + BIFILAR
    angle = INCLINES.replace("angle_deg = 2.87\n", 'recording = "rest.csv"\n', 1)
    rest = recording(4, 5.0, 20.0, yaw=0.0, sway=0.0)
    tilted = HEAD + TYPED + BIFILAR + TYPED.replace('"typed"', '"up"') + TILTED
    tilted += TYPED.replace('"typed"', '"down"').replace("amplitude_deg = { yaw = 5.0 }", "") + TILTED.replace("30.0", "-30.0")
    moved = HEAD + TYPED + BIFILAR + PITCH + BIFILAR + "points_moved = 0.1\nhull_pitch_deg = 4.0\n"
    whole = HEAD + ATTACHMENTS + INCLINES + TYPED + BIFILAR + PITCH + BIFILAR
    whole += ROLL + BIFILAR.replace("athwartships", "fore_and_aft")
    found = [
        session("recorded", recorded, yaw_csv=csv),
        session("with-phone", with_phone, yaw_csv=csv),
        session("compound", compound, pitch_csv=csv3),
        session("gates", gates, track_csv=track, gate_csv=gate),
        session("inclined", inclined, short_csv=csv2),
        session("incline-recorded", HEAD + angle + TYPED + BIFILAR, rest_csv=table(NATIVE, rest)),
        session("typed", HEAD + TYPED + BIFILAR),
        session("tilted", tilted),
        session("moved", moved),
        session("whole", whole),
        Input("zip", "zip", {"session.toml": recorded.encode(), "yaw.csv": csv}),
        Input("bare", "bare", {"yaw.csv": csv}),
        Input("bare-rate", "bare", {"gz.csv": table("t,gz", [yaw_sway[0], yaw_sway[3]])}),
        Input("recorder", "import", {"swing.gyr": recorder_file(short)}),
        Input("read-recorder", "recorder", {"swing.gyr": recorder_file(short)}),
    ]
    return found + exports(short)


def exports(columns: Columns) -> list[Input]:
    """What other programs write, by hand here and from the fixtures of the reader's own tests."""
    t, gx, gy, gz, ax, ay, az = columns
    both = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s),Gyroscope z (rad/s),Acceleration x (m/s^2),"
    phyphox = table(both + "Acceleration y (m/s^2),Acceleration z (m/s^2)", columns)
    unix = [1_700_000_000_000_000_000 + round(1e9 * s) for s in t]

    def logged(x: list[float], y: list[float], z: list[float]) -> bytes:
        rows = [f"{n},{s:.6f},{c:.6g},{b:.6g},{a:.6g}" for n, s, a, b, c in zip(unix, t, x, y, z)]
        return "\n".join(["time,seconds_elapsed,z,y,x", *rows, ""]).encode()

    logger = {"Gyroscope.csv": logged(gx, gy, gz), "TotalAcceleration.csv": logged(ax, ay, az)}
    metadata = b"version,device name,platform\n3,phone,android\n"
    degrees = table("time_ms,wx,wy,wz", [[1e3 * s for s in t], *([57.29578 * v for v in c] for c in (gx, gy, gz))])
    mapping = ["t=time_ms:ms", "gx=wx:deg/s", "gy=wy:deg/s", "gz=wz:deg/s"]
    semicolons = table("t,gx,gy,gz,ax,ay,az", columns, ";").replace(b".", b",")
    found = [
        Input("phyphox", "bare", {"phyphox.csv": phyphox}),
        Input("phyphox-import", "import", {"phyphox.csv": phyphox}),
        Input("sensor-logger", "import", {"log.zip": zipped({**logger, "Metadata.csv": metadata})}),
        Input("sensor-logger-loose", "import", logger),
        Input("mapped", "import", {"own.csv": degrees}, mapping),
        Input("mapped-bare", "bare", {"own.csv": degrees}, mapping),
        Input("decimal-comma", "bare", {"comma.csv": semicolons}),
        Input("described", "describe", {"own.csv": degrees}),
    ]
    for path in sorted(FIXTURES.glob("*.*")):
        content = path.read_bytes()
        if len(content) < 200_000:
            found.append(Input(f"fixture-{path.name}", "import", {path.name: content}))
            found.append(Input(f"described-{path.name}", "describe", {path.name: content}))
    return found
