"""numba's compiler, its cache kept apart for every state of the sources.

numba notices a change in a function's own file only, not in what the function calls.
"""

import hashlib
from functools import partial
from pathlib import Path

import numba

HERE = Path(__file__).resolve().parent
STATE = hashlib.sha256(b"".join((HERE / name).read_bytes() for name in ("compiled.py", "forces.py", "motion.py"))).hexdigest()[:12]
numba.config.CACHE_DIR = str(HERE.parents[1] / "build" / "numba" / STATE)
njit = partial(numba.njit, cache=True, error_model="numpy")
inlined = partial(numba.njit, cache=True, inline="always")
