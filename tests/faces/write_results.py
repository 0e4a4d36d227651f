"""What Python makes of the shared vectors and of the sessions that ship, for another language to be compared with.

``write_results.py FOLDER`` writes everything anew, bit for bit: floats as the hexadecimal digits of their 64 bits, JSON as the
core writes it, arrays as little-endian 64-bit numbers. What is compared is two faces of one core, never a result with a
truth: for that there are the vectors' own expected values and the blind tests.
"""

from __future__ import annotations

import json
import shutil
import struct
import sys
from pathlib import Path

import gyradius
import numpy as np
from gyradius import _core

ROOT = Path(__file__).resolve().parents[2]
AT_UTC = "2026-05-04T09:30:00Z"
SEED = 20140101
LIMITS = ["k_yaw_m>=1.000", "k_pitch_m<=1.2"]
# Sessions without samples, whose criticism takes a moment.
TYPED = ("keelboat", "model-hull")


def bits(value: float) -> str:
    return struct.pack(">d", value).hex()


def vectors() -> dict[str, dict[str, object]]:
    """Outputs of every case by its id, or the kind of error that refuses it."""
    found = {}
    for path in sorted((ROOT / "tests" / "vectors").glob("*.json")):
        if path.stem == "schema":
            continue
        for case in json.loads(path.read_text(encoding="utf-8"))["tests"]:
            try:
                outputs = gyradius.evaluate_route(path.stem, case["inputs"])
                found[case["id"]] = {"outputs": {name: bits(value) for name, value in outputs.items()}}
            except gyradius.NoResultError as error:
                found[case["id"]] = {"error": "no_result", "text": str(error)}
            except gyradius.InputError as error:
                found[case["id"]] = {"error": "argument", "text": str(error)}
    return found


def sessions(folder: Path) -> None:
    for name, path in gyradius.shipped_sessions().items():
        session = gyradius.load(path)
        measured = session.core.measure(LIMITS)
        (folder / f"measure-{name}.json").write_text(measured.to_json(), encoding="utf-8")
        (folder / f"report-{name}.html").write_text(measured.to_html(None, None, "en"), encoding="utf-8")
        if name in TYPED:
            criticism = session.core.critique(None)
            (folder / f"critique-{name}.json").write_text(criticism.to_json(), encoding="utf-8")
    recording = gyradius.shipped_session("boat-park") / "yaw-sway.csv"
    (folder / "measure-bare.json").write_text(gyradius.load(recording).measure().to_json(), encoding="utf-8")


def plan(folder: Path) -> None:
    hull = {"mass_kg": 212.0, "length_m": 5.05, "beam_m": 1.6, "boat_type": "keelboat"}
    request = json.dumps({"title": "faces", "hull": hull, "wanted": ["k_yaw=0.5%"]})
    made = _core.plan_swings(request)
    (folder / "plan-request.json").write_text(request, encoding="utf-8")
    (folder / "plan.json").write_text(made.to_json(), encoding="utf-8")
    (folder / "plan-session.toml").write_text(made.session_toml(), encoding="utf-8")
    (folder / "plan-rig.toml").write_text(made.rig_toml(), encoding="utf-8")


def simulation(folder: Path) -> None:
    """A swing with noise and lost samples; what the live estimator and the decomposition make of it."""
    rig = gyradius.read_rig(gyradius.shipped_rigs()["keelboat"])
    numbers = list(rig.numbers("surge-pitch"))[:2]
    swung = rig.simulate("surge-pitch", derivatives=numbers, seed=SEED)
    readings = np.hstack([swung.gyro_rad_s, swung.acc_m_s2])
    for name, array in (("t_s", swung.t_s), ("readings", readings), ("derivatives", swung.derivatives)):
        np.ascontiguousarray(array, dtype="<f8").tofile(folder / f"simulation-{name}.bin")
    (folder / "simulation-numbers.json").write_text(json.dumps(numbers), encoding="utf-8")
    part = slice(1000, 5000)
    found = _core.decompose(swung.t_s[part].copy(), [swung.gyro_rad_s[part, axis].copy() for axis in range(3)])
    (folder / "decomposition.json").write_text(found.to_json(), encoding="utf-8")
    live = _core.Live(1e-4, None, None)
    stamps_ns = np.rint(swung.t_s * 1e9).astype(np.int64)
    stamps_ns.astype("<i8").tofile(folder / "live-stamps_ns.bin")
    for start in range(0, len(stamps_ns), 100):
        rows = slice(start, start + 100)
        live.push("gyroscope", stamps_ns[rows].copy(), swung.gyro_rad_s[rows].copy())
        live.push("accelerometer", stamps_ns[rows].copy(), swung.acc_m_s2[rows].copy())
    (folder / "live.json").write_text(live.estimate(), encoding="utf-8")


def practice(folder: Path) -> None:
    """A practice by the book as far as the work, and its recordings."""
    rig = gyradius.read_rig(gyradius.shipped_rigs()["keelboat"])
    core = _core.Practice(rig._core, str(folder / "practice"), SEED, False)
    core.mishap("yaw-sway", 1, "slip")
    states = [core.state()]
    while json.loads(states[-1])["work"] is None:
        event = core.by_the_book(AT_UTC)
        if event is None:
            core.advance(5.0)
        else:
            core.handle(event)
            states.append(core.state())
    (folder / "practice-states.json").write_text(json.dumps(states), encoding="utf-8")
    for take in sorted((folder / "practice" / "takes").glob("*.gyr")):
        recorded = gyradius.read_recorder(take)
        assert recorded.gyroscope is not None
        recorded.gyroscope.stamps_ns.astype("<i8").tofile(folder / f"{take.name}-stamps_ns.bin")
        recorded.gyroscope.values.astype("<f8").tofile(folder / f"{take.name}-values.bin")


def imports(folder: Path) -> None:
    """An export of a phone and a recorder's file that was cut, in one session."""
    export = ROOT / "core/crates/recording/tests/fixtures" / "import" / "phyphox-android.zip"
    cut = folder / "cut.gyr"
    cut.write_bytes(sorted((folder / "practice" / "takes").glob("*.gyr"))[0].read_bytes()[:100_000])
    sizes = {"line_length": (3.477, 0.003), "spacing": (1.8, 0.001), "mass": (622.7, 0.5)}
    notes = gyradius.import_files([export, cut], folder / "imported", title="faces", **sizes)  # type: ignore[arg-type]
    (folder / "import-notes.json").write_text(json.dumps(notes), encoding="utf-8")


def main() -> None:
    folder = Path(sys.argv[1]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    sessions(folder)
    plan(folder)
    simulation(folder)
    practice(folder)
    imports(folder)
    (folder / "routes.json").write_text(_core.routes(), encoding="utf-8")
    # Last, so that it is there only where all of it is.
    (folder / "vectors.json").write_text(json.dumps(vectors(), indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
