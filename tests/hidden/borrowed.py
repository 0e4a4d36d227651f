"""What the blind sessions' generator lends: hulls, rigs, phones, releases, and how a session is written down."""

import sys
from pathlib import Path

import numba  # noqa: F401  before the path: numba looks for a module `coverage`, and must not find the blind sessions' one

sys.path.append(str(Path(__file__).resolve().parent.parent / "blind"))

import generate as blind  # noqa: E402
import rigid_body as rb  # noqa: E402

__all__ = ["blind", "rb"]
