"""Ctrl-C: heard at once whatever runs, and answered with one line.

Only the standard library may be imported here: this is the first that the command loads.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType
from typing import Any, Generic, TypeVar

Result = TypeVar("Result")

INTERRUPTED = 130
MESSAGE = "gyradius: interrupted"
# How often a thread that waits looks for Ctrl-C where the system does not wake it (Windows).
LISTENING_S = 0.1
# As much as a main thread has.
STACK_BYTES = 8 << 20


class _Heard:
    """Whether Ctrl-C was heard: an import or a library may have made another error of it."""

    anything = False


def leave_at_once() -> None:
    """Let Ctrl-C end the program from here on; nothing is at stake yet, or any more."""
    # Whoever starts a program in the background may have it ignore Ctrl-C.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _leave)


def _leave(_number: int, _frame: FrameType | None) -> None:
    leave()


def leave() -> None:
    """End with the line and the status of a program that was interrupted; threads that still work end with it."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (AttributeError, OSError, RuntimeError, ValueError):
            # Closed, broken or interrupted in the middle of a write.
            continue
    with suppress(OSError):
        os.write(2, f"{MESSAGE}\n".encode())
    os._exit(INTERRUPTED)


def deaf() -> None:
    """Ignore Ctrl-C from here on: all is done, and Python is about to end."""
    if signal.getsignal(signal.SIGINT) is _leave:
        signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextmanager
def unwinding() -> Iterator[None]:
    """Let Ctrl-C raise ``KeyboardInterrupt`` meanwhile, so that what was begun is put away."""
    before = signal.getsignal(signal.SIGINT)
    is_ours = before is _leave and threading.current_thread() is threading.main_thread()
    if is_ours:
        signal.signal(signal.SIGINT, _raise)
    try:
        yield
    finally:
        if is_ours:
            signal.signal(signal.SIGINT, before)


def _raise(_number: int, _frame: FrameType | None) -> None:
    _Heard.anything = True
    raise KeyboardInterrupt


def was_interrupted() -> bool:
    """Whether Ctrl-C was heard, whatever was made of it."""
    return _Heard.anything


def heard_during(work: Callable[..., Result], *arguments: Any, **options: Any) -> Result:
    """Do work that cannot hear Ctrl-C in a thread, and wait for it: ``KeyboardInterrupt`` ends the wait at once."""
    if threading.current_thread() is not threading.main_thread():
        return work(*arguments, **options)
    job = _Job(lambda: work(*arguments, **options))
    before = threading.stack_size(STACK_BYTES)
    try:
        threading.Thread(target=job.run, daemon=True).start()
    finally:
        threading.stack_size(before)
    return job.wait()


class _Job(Generic[Result]):
    def __init__(self, work: Callable[[], Result]) -> None:
        self._work = work
        self._done = threading.Event()
        self._results: list[Result] = []
        self._error: BaseException | None = None

    def run(self) -> None:
        try:
            self._results.append(self._work())
        except BaseException as error:
            self._error = error
        self._done.set()

    def wait(self) -> Result:
        while not self._done.wait(LISTENING_S):
            pass
        if self._error is not None:
            raise self._error
        return self._results[0]
