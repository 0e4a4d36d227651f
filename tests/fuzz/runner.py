"""Runs inputs in a process of its own, with a limit on time and memory, and starts that anew where it has died."""

from __future__ import annotations

import json
import math
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

from inputs import Input

#: Of processor time, so that other programs do not count.
MOST_S = 10.0
#: Of waiting, as a multiple of that.
PATIENCE = 5.0
MOST_BYTES = 500 << 20
LISTENING_S = 0.5
#: For the start of the process.
START_S = 120.0
FINE = ("ok", "refused")


@dataclass
class Outcome:
    """How an input ended: ``ok``, ``refused``, or a failure."""

    kind: str
    text: str
    seconds: float
    megabytes: float

    @property
    def failed(self) -> bool:
        """Whether it may not end so."""
        return self.kind not in FINE


def processor_s(pid: int) -> float:
    """Processor time of a process so far (Linux), s."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    except OSError:
        return 0.0


class Runner:
    """One worker, kept alive from input to input."""

    def __init__(self, python: str = sys.executable) -> None:
        """The worker starts with the first input."""
        self._python = python
        self._folder = Path(tempfile.mkdtemp(prefix="gyradius-fuzz-"))
        self._worker: subprocess.Popen[bytes] | None = None
        self._rest = b""

    def __enter__(self) -> Runner:
        """For ``with``."""
        return self

    def __exit__(self, *_: type[BaseException] | BaseException | TracebackType | None) -> None:
        """Ends the worker and removes its folder."""
        self._stop()
        shutil.rmtree(self._folder, ignore_errors=True)

    def run(self, given: Input, critique: bool = False, most_s: float = MOST_S) -> Outcome:
        """Runs an input to its end, or to the end of its time."""
        worker = self._started()
        place = self._folder / "in"
        shutil.rmtree(place, ignore_errors=True)
        out = self._folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        paths = given.write(place)
        job = {"action": given.action, "paths": paths, "out": str(out), "mapping": given.mapping, "critique": critique}
        try:
            worker.stdin.write(json.dumps(job).encode() + b"\n")  # type: ignore[union-attr]
            worker.stdin.flush()  # type: ignore[union-attr]
        except BrokenPipeError:
            pass
        answer = self._line(PATIENCE * most_s, most_s)
        if answer is None:
            code = worker.poll()
            self._stop()
            if code is None:
                return Outcome("too_slow", f"no end after {most_s:g} s", most_s, 0.0)
            return Outcome("crash", f"the process ended with status {worker.returncode}", 0.0, 0.0)
        found = Outcome(answer["kind"], answer["text"], answer["s"], answer["bytes"] / 2**20)
        if answer["s"] > most_s and not found.failed:
            found = Outcome("too_slow", f"{answer['s']:.0f} s of processor time ({found.text})", found.seconds, found.megabytes)
        if answer["bytes"] > MOST_BYTES:
            found = Outcome("too_large", f"{found.megabytes:.0f} MB ({found.text})", found.seconds, found.megabytes)
        if found.failed:
            # What is left of it shall not fall on the next.
            self._stop()
        return found

    def _started(self) -> subprocess.Popen[bytes]:
        if self._worker is not None and self._worker.poll() is None:
            return self._worker
        environment = {**os.environ, "MALLOC_ARENA_MAX": "2", "PYTHONDONTWRITEBYTECODE": "1"}
        command = [self._python, str(Path(__file__).with_name("worker.py"))]
        self._rest = b""
        self._worker = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment)
        if self._line(START_S) is None:
            raise RuntimeError("the worker does not start")
        return self._worker

    def _line(self, wait_s: float, most_s: float = math.inf) -> dict[str, Any] | None:
        """A line of the worker; None where there is none in time, or none any more."""
        assert self._worker is not None and self._worker.stdout is not None
        start, before = time.monotonic(), processor_s(self._worker.pid)
        while b"\n" not in self._rest:
            ready, _, _ = select.select([self._worker.stdout], [], [], LISTENING_S)
            if ready:
                block = os.read(self._worker.stdout.fileno(), 1 << 16)
                if not block:
                    self._worker.wait()
                    return None
                self._rest += block
            elif time.monotonic() - start > wait_s or processor_s(self._worker.pid) - before > most_s:
                return None
        line, self._rest = self._rest.split(b"\n", 1)
        return dict(json.loads(line))

    def _stop(self) -> None:
        if self._worker is not None:
            self._worker.kill()
            self._worker.wait()
            for pipe in (self._worker.stdin, self._worker.stdout):
                if pipe is not None:
                    try:
                        pipe.close()
                    except BrokenPipeError:
                        pass
        self._worker = None
