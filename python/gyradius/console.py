"""The terminal: text of a session is shown as it stands, in whatever encoding the terminal has.

A title, a name or a message may hold anything: square brackets are no markup here, words between colons no pictures,
and control characters do not reach the terminal.
"""

from __future__ import annotations

import codecs
import io
import os
import re
import sys
import unicodedata
from collections.abc import Iterable
from contextlib import suppress
from typing import Any

from rich.console import Console, ConsoleOptions, ConsoleRenderable, RenderHook, RenderResult
from rich.segment import Segment

# Control characters, and those that turn the direction of what follows.
UNSEEN = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
# What stands for a character that the encoding lacks; others lose their accents.
LOOKALIKES = {
    "±": "+/-",
    "–": "-",
    "—": "-",
    "−": "-",
    "‑": "-",
    "…": "...",
    "·": "*",
    "×": "x",
    "•": "*",
    "°": "deg",
    "′": "'",
    "‘": "'",
    "’": "'",
    "“": '"',
    "”": '"',
    "„": '"',
    "≥": ">=",
    "≤": "<=",
    "≈": "~",
    "→": "->",
    "√": "sqrt",
    "∞": "inf",
    "ß": "ss",
    "µ": "u",
    "⁻": "-",
}
GREEK = {"μ": "u"}
# Columns that a terminal may have, and those that it has where what is stated is none of them.
LEAST_COLUMNS, USUAL_COLUMNS, MOST_COLUMNS = 1, 80, 1000
LOOKALIKE_ERRORS = "gyradius.lookalike"


def output_console(json_to: str | None = None) -> Console:
    """Standard output; ``--json -`` leaves it to the JSON alone."""
    return _Console(stderr=json_to == "-", quiet=json_to == "-")


def error_console() -> Console:
    """Standard error."""
    return _Console(stderr=True)


class _Console(Console):
    def __init__(self, **options: Any) -> None:
        super().__init__(markup=False, emoji=False, highlight=False, width=_stated_width(), **options)
        self.push_render_hook(_Plain())

    def on_broken_pipe(self) -> None:
        # Nobody reads on: how the command ends is decided in one place.
        raise BrokenPipeError


def _stated_width() -> int | None:
    """The width that ``COLUMNS`` states where nothing, or next to nothing, could be shown in it."""
    stated = os.environ.get("COLUMNS", "")
    if not (stated.isascii() and stated.isdigit()):
        return None
    columns = int(stated[:9])
    return None if LEAST_COLUMNS <= columns <= MOST_COLUMNS else min(max(columns, USUAL_COLUMNS), MOST_COLUMNS)


class _Plain(RenderHook):
    def process_renderables(self, renderables: list[ConsoleRenderable]) -> list[ConsoleRenderable]:
        return [_Visible(renderable) for renderable in renderables]


class _Visible:
    """What is shown, without control characters."""

    def __init__(self, shown: ConsoleRenderable) -> None:
        self._shown = shown

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        for segment in console.render(self._shown, options):
            yield segment if segment.control else Segment(UNSEEN.sub("\ufffd", segment.text), segment.style)


def prepare_streams() -> None:
    """For the command alone: characters that an encoding lacks are replaced, and a reader may go away."""
    codecs.register_error(LOOKALIKE_ERRORS, _replaced)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=LOOKALIKE_ERRORS)
    # Help is printed by typer, on a console of its own.
    setattr(Console, "on_broken_pipe", _nobody_reads)  # noqa: B010


def _nobody_reads(_console: Console) -> None:
    silence_standard_output()
    raise SystemExit(0)


def silence_standard_output() -> None:
    """What is still buffered, and cannot be written, must not raise again at exit."""
    with suppress(OSError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)


def _replaced(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(lookalike, error.object[error.start : error.end])), error.end


def lookalike(character: str) -> str:
    """ASCII in place of a character: ``±`` becomes ``+/-``, ``ü`` ``u``; a question mark where there is none."""
    known = LOOKALIKES.get(character) or _greek(character)
    if known:
        return known
    # A byte of a file's name that is no text.
    if "\udc80" <= character <= "\udcff":
        return f"\\x{ord(character) - 0xDC00:02x}"
    return _ascii(unicodedata.normalize("NFKD", character)) or "?"


def _ascii(characters: Iterable[str]) -> str:
    return "".join(character for character in characters if character.isascii())


def _greek(character: str) -> str:
    """The name of a Greek letter."""
    words = unicodedata.name(character, "").split(" ")
    if words[:1] != ["GREEK"] or "LETTER" not in words:
        return ""
    return GREEK.get(character) or words[words.index("LETTER") + 1].lower()
