"""The process that runs inputs: one line of JSON in (what to run), one out (how it ended).

It is ended and started again by `runner` where it takes too long or dies.
"""

from __future__ import annotations

import io
import json
import math
import os
import re
import shutil
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import gyradius
from gyradius import _core
from gyradius.critique import Critique
from gyradius.imports import ImportPlan, describe_exports
from gyradius.measurement import Measurement
from gyradius.tables import show
from rich.console import Console

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]

#: Well above what is allowed, so that an allocation without end is stopped and not the machine.
ADDRESS_SPACE = 3 << 30
NOT_A_NUMBER = re.compile(r"(?<![\w.])(?:nan|-?inf|infinity)(?![\w.])", re.IGNORECASE)


class Bad(Exception):
    """A result that may not be."""


def peak_bytes() -> int:
    """The largest resident size since the last `forget_peak`, or since the start where the system cannot forget."""
    try:
        status = Path("/proc/self/status").read_text()
        return 1024 * int(re.search(r"VmHWM:\s+(\d+)", status).group(1))  # type: ignore[union-attr]
    except (OSError, AttributeError):
        scale = 1 if sys.platform == "darwin" else 1024
        return scale * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def forget_peak() -> None:
    """Lets the peak start anew (Linux)."""
    with suppress(OSError):
        Path("/proc/self/clear_refs").write_text("5")


def run(job: dict[str, Any]) -> str:
    """Does what a job says; answers what came of it."""
    action, paths, out = job["action"], job["paths"], job["out"]
    if action == "recorder":
        gyradius.read_recorder(paths[0])
        return "read"
    if action == "describe":
        describe_exports(paths, ImportPlan(mapping=[]))
        return "described"
    target = paths[0]
    if action == "import":
        gyradius.import_files(paths, out, mapping=job["mapping"], mass=100.0, line_length=1.0, spacing=1.0)
        target = out
    mapping = job["mapping"] if action == "bare" else []
    session = gyradius.load(target, mapping=mapping)
    measurement = session.measure(limits=["k_yaw_m>=0.9"])
    check(measurement)
    if job.get("critique"):
        check_critique(session.critique())
    return "measured" if measurement.quantities else "no quantity"


def check(measurement: Measurement) -> None:
    """Refuses a result with a number that is none, or with an uncertainty that is none."""
    data = strictly(measurement.to_json())
    check_quantities(data["quantities"])
    for swing in data["swings"]:
        for mode in swing["modes"]:
            where = f"swing {swing['id']}, {mode['mode']}"
            if not is_positive(mode["period_s"]) or not is_number(mode["period_se_s"]):
                raise Bad(f"{where}: period {mode['period_s']} ± {mode['period_se_s']}")
            if mode["period_se_s"] < 0 or mode["decay_time_s"] is not None and not is_number(mode["decay_time_se_s"]):
                raise Bad(f"{where}: decay {mode['decay_time_s']} ± {mode['decay_time_se_s']}, period_se {mode['period_se_s']}")
    for name, routes in data["alternatives"].items():
        for route in routes:
            if not is_number(route["value"]) or not is_number(route["u"]) or None in route["interval_95"]:
                raise Bad(f"route {route['method']} to {name}: {route['value']} ± {route['u']}, {route['interval_95']}")
    for claim in data["consistency"]:
        if not all(is_number(claim[key]) for key in ("stated", "stated_u", "implied", "implied_u", "sigma")):
            raise Bad(f"claim {claim['claim']}: {claim}")
    for name, lines in data["budget"].items():
        if not all(is_number(line["u_contribution"]) for line in lines):
            raise Bad(f"budget of {name}: {lines}")
    for finding in data["findings"]:
        if not all(map(is_number, finding["numbers"].values())):
            raise Bad(f"finding {finding['kind']}: {finding['numbers']}")
    for _, _, r in data["correlations"]:
        if not is_number(r) or abs(r) > 1 + 1e-9:
            raise Bad(f"correlation {r}")
    for verdict in data["verdicts"]:
        if not all(is_number(verdict[key]) for key in ("guard_band", "conformance_probability")):
            raise Bad(f"verdict {verdict}")
    check_words(measurement, data)


def check_words(measurement: Measurement, data: dict[str, Any]) -> None:
    """The same of what people read: messages, the terminal, the report."""
    said = [*data["warnings"], *(f["text"] for f in data["findings"]), *(c["text"] for c in data["consistency"])]
    said += [text for swing in data["swings"] for text in (*swing["warnings"], *(r["text"] for r in swing["repairs"]))]
    # Ids, titles and names of files stand in messages: what is read in quotes may be any word.
    for text in said:
        if NOT_A_NUMBER.search(re.sub(r"`[^`]*`|\"[^\"]*\"", "", text)):
            raise Bad(f"message: {text}")
    console = Console(file=io.StringIO(), width=100)
    show(console, measurement)
    measurement.to_html()


def check_critique(critique: Critique) -> None:
    """A criticism's numbers."""
    data = strictly(critique.to_json())
    for model in ("baseline", "extended"):
        check_quantities(data[model]["quantities"])
    for cause in data["causes"]:
        if not is_number(cause["probability"]):
            raise Bad(f"cause {cause['id']}: probability {cause['probability']}")
        for name, parameter in cause["parameters"].items():
            if not is_number(parameter["value"]) or not is_number(parameter["u"]):
                raise Bad(f"cause {cause['id']}, {name}: {parameter}")


def check_quantities(quantities: dict[str, Any]) -> None:
    """Every quantity is a number with an uncertainty."""
    for name, quantity in quantities.items():
        values, us = flat(quantity["value"]), flat(quantity["u"])
        wrong = not all(map(is_number, values + us)) or len(values) != len(us) or any(u < 0 for u in us)
        # A product of inertia that is nought by definition has no uncertainty.
        wrong = wrong or any(u == 0 and value != 0 for value, u in zip(values, us))
        if wrong:
            raise Bad(f"{name}: {quantity['value']} ± {quantity['u']}")


def strictly(text: str) -> dict[str, Any]:
    """JSON without the words that are no JSON."""

    def refuse(word: str) -> object:
        raise Bad(f"{word} in the JSON")

    return dict(json.loads(text, parse_constant=refuse))


def flat(value: Any) -> list[Any]:
    """All numbers of a number, a vector or a matrix."""
    return [number for item in value for number in flat(item)] if isinstance(value, list) else [value]


def is_number(value: Any) -> bool:
    """Finite, and there."""
    return isinstance(value, int | float) and math.isfinite(value)


def is_positive(value: Any) -> bool:
    """A finite number above nought."""
    return is_number(value) and value > 0


def outcome(job: dict[str, Any]) -> tuple[str, str]:
    """How a job ended: ``ok`` or ``refused``, or a kind of failure, with what was said."""
    try:
        return "ok", run(job)
    except gyradius.GyradiusError as error:
        return "refused", str(error)
    except Bad as error:
        return "bad_result", str(error)
    except BaseException as error:
        kind = "panic" if type(error).__name__ == "PanicException" else "exception"
        return kind, f"{type(error).__name__}: {error}"


def main() -> None:
    """Runs jobs until there are no more."""
    # The core's own messages go to the log; what is answered goes to the pipe alone.
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    if resource is not None and sys.platform != "darwin":
        resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    _core.silence_panics()
    print(json.dumps({"ready": peak_bytes()}), file=answers)
    for line in sys.stdin:
        job = json.loads(line)
        forget_peak()
        start = time.process_time()
        kind, text = outcome(job)
        took = time.process_time() - start
        print(json.dumps({"kind": kind, "text": text[:2000], "s": took, "bytes": peak_bytes()}), file=answers)
        shutil.rmtree(job["out"], ignore_errors=True)


if __name__ == "__main__":
    with suppress(BrokenPipeError):
        main()
