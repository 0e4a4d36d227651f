"""All effects that may be hidden: those that the critique has names for, and those that it has none for."""

import bodies_inside  # noqa: F401  each module enters its effects in the lists
import friction  # noqa: F401
import on_phone  # noqa: F401
import rigging  # noqa: F401
from effect import EFFECTS, OUTSIDE, Effect, Session, Tape

ALL = EFFECTS | OUTSIDE

__all__ = ["ALL", "EFFECTS", "OUTSIDE", "Effect", "Session", "Tape"]
