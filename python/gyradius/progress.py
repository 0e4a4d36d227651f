"""A sign of life on standard error for work longer than a second."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

# What takes less is done before it can be read.
SILENT_S = 1.0


@contextmanager
def working(console: Console, text: str) -> Iterator[None]:
    """Show ``text``, a spinner and the time gone by, on a terminal only and only after a second."""
    if not console.is_terminal:
        yield
        return
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    progress = Progress(*columns, console=console, transient=True)
    progress.add_task(text, total=None)
    timer = threading.Timer(SILENT_S, progress.start)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        progress.stop()
