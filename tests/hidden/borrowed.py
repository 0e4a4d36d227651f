"""What the blind sessions lend: hulls, rigs, phones, releases, how a session is written down and how a program is asked."""

import sys
from pathlib import Path

import numba  # noqa: F401  before the path: numba looks for a module `coverage`, and must not find the blind sessions' one

sys.path.append(str(Path(__file__).resolve().parent.parent / "blind"))

import generate as blind  # noqa: E402
import promises  # noqa: E402
import rigid_body as rb  # noqa: E402

__all__ = ["blind", "promises", "rb"]
