"""A sign of life on standard error for work longer than a second."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import (
    BarColumn,
    Progress,
    SpinnerColumn,
    TaskProgressColumn,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

# What takes less is done before it can be read.
SILENT_S = 1.0
# The time left follows from all that was done so far, not from the last half minute alone: shares come unevenly.
SPEED_OVER_S = 3600.0


@contextmanager
def working(console: Console, text: str) -> Iterator[None]:
    """Show ``text``, a spinner and the time gone by, on a terminal only and only after a second."""
    columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), TimeElapsedColumn())
    progress = Progress(*columns, console=console, transient=True)
    progress.add_task(text, total=None)
    with _shown(progress):
        yield


@contextmanager
def counted(console: Console, text: str) -> Iterator[Callable[[float, str], None]]:
    """Show a bar and the time left, in the same way; what is yielded takes the share done and what is being done."""
    columns = (TextColumn("{task.description}", markup=False), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
    progress = Progress(*columns, console=console, transient=True, speed_estimate_period=SPEED_OVER_S)
    task = progress.add_task(text, total=1.0)
    with _shown(progress):
        yield lambda share, doing: progress.update(task, completed=share, description=f"{text}: {doing}")


@contextmanager
def _shown(progress: Progress) -> Iterator[None]:
    if not progress.console.is_terminal:
        yield
        return
    timer = threading.Timer(SILENT_S, progress.start)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        progress.stop()
