"""The typed stubs say what the native module has, both ways, and the package passes the type checker."""

from __future__ import annotations

import inspect
import subprocess
import sys
from pathlib import Path

from gyradius import _core

PYTHON = Path(__file__).resolve().parents[1]


def test_stubs_agree_with_the_module() -> None:
    command = [
        sys.executable,
        "-m",
        "mypy.stubtest",
        "gyradius._core",
        "--mypy-config-file",
        "pyproject.toml",
    ]
    done = subprocess.run(command, capture_output=True, text=True, cwd=PYTHON, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_public_name_has_a_docstring() -> None:
    missing = [name for name, thing in vars(_core).items() if name[0] != "_" and not inspect.getdoc(thing)]
    assert missing == []
