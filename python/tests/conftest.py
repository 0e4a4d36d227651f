"""What the tests share: sessions made on the spot, and the command as a user runs it."""

from __future__ import annotations

import json
import math
import os
import random
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

import gyradius

ROOT = Path(__file__).resolve().parents[2]
SHARED = ROOT.parent / "shared"

# The paper's keelboat in figures: Tables 1 and 2 of Hinrichsen, "Bifilar suspension measurement of boat inertia".
TYPED = """\
format = "gyradius-session/1"
title = "typed in"

[body]
name = "keelboat"
mass = { value = 622.7, u = 0.5 }

[[swing]]
id = "table-1"
periods_s = { yaw = { value = 4.391, u = 0.004 }, sway = { value = 3.802, u = 0.004 } }
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = { value = 3.477, u = 0.006 }
spacing = { value = 1.800, u = 0.001 }
"""


def seed() -> int:
    """The same in every run, unless ``GYRADIUS_SEED`` is ``random`` or a number."""
    wanted = os.environ.get("GYRADIUS_SEED", "20140101")
    drawn = time.time_ns() if wanted == "random" else int(wanted)
    print("seed", drawn, file=sys.stderr)
    return drawn


def run(*args: str | Path, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """The command as a user runs it: another process, no terminal."""
    command = [sys.executable, "-m", "gyradius", *map(str, args)]
    environment = {**os.environ, "COLUMNS": "200", "NO_COLOR": "1"}
    return subprocess.run(command, capture_output=True, text=True, cwd=cwd, timeout=300, env=environment, check=False)


def assert_refused(done: subprocess.CompletedProcess[str], status: int, *words: str) -> None:
    """A clear message on standard error, the right status, and never a traceback."""
    assert done.returncode == status, done.stdout + done.stderr
    assert "Traceback" not in done.stderr + done.stdout
    assert "internal error" not in done.stderr
    for word in words:
        assert word in done.stderr


def swing_csv(period_s: float = 2.0, seconds: float = 60.0, rate_hz: float = 50.0) -> str:
    """A phone on a hull that yaws: gyroscope about z, gravity on the accelerometer."""
    rows = ["t,gx,gy,gz,ax,ay,az"]
    # White noise as phones have it; a computed ripple would hold lines of its own, which are found.
    noise = random.Random(seed()).gauss
    for i in range(int(seconds * rate_hz)):
        t = i / rate_hz
        gx, gy, gz, ax, ay, az = (noise(0.0, 1e-3) for _ in range(6))
        gz += 0.2 * math.exp(-t / 200.0) * math.cos(2.0 * math.pi * t / period_s)
        rows.append(f"{t:.4f},{gx:.6f},{gy:.6f},{gz:.6f},{ax:.5f},{ay:.5f},{9.81 + az:.5f}")
    return "\n".join(rows) + "\n"


@pytest.fixture
def folder(tmp_path: Path) -> Callable[..., Path]:
    """Writes a session folder: the text of session.toml and the files beside it."""

    def write(text: str = TYPED, **files: str) -> Path:
        path = tmp_path / "session"
        path.mkdir(exist_ok=True)
        (path / "session.toml").write_text(text, encoding="utf-8")
        for name, content in files.items():
            (path / name.replace("_csv", ".csv")).write_text(content, encoding="utf-8")
        return path

    return write


@pytest.fixture(scope="session")
def keelboat() -> gyradius.Measurement:
    """The paper's keelboat, measured once for all tests."""
    return gyradius.load(gyradius.shipped_session("keelboat")).measure(limits=["k_yaw_m>=1.000"])


@pytest.fixture
def copy_of(tmp_path: Path) -> Callable[[str], Path]:
    """A copy of a shipped session that a test may break."""

    def copy(name: str) -> Path:
        return Path(shutil.copytree(gyradius.shipped_session(name), tmp_path / name))

    return copy


def parsed(text: str) -> dict[str, object]:
    """The JSON of a command, as strictly as another program reads it."""

    def refuse(word: str) -> object:
        raise AssertionError(f"{word} is not JSON")

    result = json.loads(text, parse_constant=refuse)
    assert isinstance(result, dict)
    return result
