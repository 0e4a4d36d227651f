"""The questions that turn recordings into a session: suspension, mass, position of the phone."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from . import _core
from .arguments import Figure, figure


@dataclass(frozen=True, slots=True)
class Question:
    """A figure to ask for: its name as an option, its kind, and the words of the question."""

    name: str
    of: str
    words: str
    without: str = "skip"

    @property
    def option(self) -> str:
        """``--line-length``."""
        return "--" + self.name.replace("_", "-")

    def fault(self, found: Figure) -> str | None:
        """What is wrong with an answer that no body can have; None if nothing is."""
        low, high = RANGES[self.of]
        if not low < found.value < high:
            return f"expected {self.of} above {low:g} and below {high:g}, found {found.value:g}"
        # An angle may be smaller than its uncertainty.
        if self.of != "degrees" and (found.u or 0.0) >= found.value:
            return f"expected an uncertainty below the figure itself, found {found.value:g} ± {found.u:g}"
        return None


# What an answer lies between: the session format's own limits, and no line or hull beyond them.
RANGES = {"metres": (0.0, 1e3), "kilograms": (0.0, 1e6), "degrees": (-90.0, 90.0), "m/s²": (1.0, 30.0)}
# The uncertainty of a reading for which none is stated, as the session format has it.
USUAL = {"metres": "2 mm + 0.05 %", "kilograms": "0.2 %", "degrees": "0.3°", "m/s²": "of the last digit"}
LINE_LENGTH = Question("line_length", "metres", "length of the lines, from pivot to pivot")
# The required figures, by suspension.
REQUIRED: Mapping[str, tuple[Question, ...]] = {
    "bifilar": (LINE_LENGTH, Question("spacing", "metres", "distance between the two suspension points on the body")),
    "trifilar": (LINE_LENGTH, Question("radius", "metres", "radius of the circle through the lower line ends")),
    "compound": (Question("axis_height", "metres", "height of the swing axis above the suspension points"),),
    "free": (),
}
OPTIONAL: Mapping[str, tuple[Question, ...]] = {
    "bifilar": (
        Question("top_spacing", "metres", "distance between the two points above, if different"),
        Question("hull_pitch", "degrees", "tilt of the body as it hung, bow up"),
    ),
    "trifilar": (Question("top_radius", "metres", "radius of the circle through the upper line ends, if different"),),
    "compound": (Question("hull_pitch", "degrees", "tilt of the body as it hung, bow up"),),
    "free": (),
}
MASS = Question("mass", "kilograms", "mass of everything that swings, phone included")
GRAVITY = Question("gravity", "m/s²", "gravity at the place", "standard gravity, 0.015 m/s²")
PHONE_MASS = Question("phone_mass", "kilograms", "mass of the phone")
KINDS = {
    "1": ("bifilar", "two lines"),
    "2": ("compound", "a fixed horizontal axis (two inverted Vs)"),
    "3": ("trifilar", "three lines"),
    "4": ("free", "anything else: periods and damping only"),
}
OF_SUSPENSIONS = {one.name: one for kinds in (REQUIRED, OPTIONAL) for kind in kinds.values() for one in kind}
QUESTIONS = OF_SUSPENSIONS | {one.name: one for one in (MASS, GRAVITY, PHONE_MASS)}
# Where the points, or the axis, have a direction, and a tilt shows.
DIRECTED = ("bifilar", "compound")
DIRECTIONS = {"1": ("athwartships", "across the body"), "2": ("fore_and_aft", "along the body")}
PHONE_PLACE = "position of the phone: forward, to port, up from the middle of the two points (metres, Enter: skip)"
SEPARATORS = re.compile(r"[;\s]+|,\s+")
Ask = Callable[[str], str]
Say = Callable[[str], None]


class Dialogue:
    """Asks until an answer can be read. If ``ask`` is None, nothing is asked and required figures must be given."""

    def __init__(self, ask: Ask | None, say: Say) -> None:
        """``ask`` shows a question and returns the answer, ``say`` shows a line."""
        self._ask, self._say = ask, say

    def choice(self, option: str, words: str, known: str | None, choices: Mapping[str, tuple[str, str]]) -> str:
        """One of the choices; the first if the answer is empty. Nothing is guessed where nothing is asked."""
        if known is not None:
            return known
        if self._ask is None:
            names = ", ".join(name for name, _ in choices.values())
            raise _core.InputError(f"{option}: required; state one of {names}")
        for key, (_, meaning) in choices.items():
            self._say(f"  {key}  {meaning}")
        while True:
            answer = self._ask(f"{words} [1]").strip() or "1"
            if answer in choices:
                return choices[answer][0]
            self._say(f"  expected {', '.join(choices)}, found `{answer}`")

    def figure(self, question: Question, known: Figure | None, is_required: bool) -> Figure | None:
        """A figure; None if it is optional and the answer is empty."""
        if known is not None:
            if (fault := question.fault(known)) is not None:
                raise _core.InputError(f"{question.option}: {fault}")
            return known
        if self._ask is None:
            if is_required:
                raise _core.InputError(f"{question.option}: required; state the {question.words} ({question.of})")
            return None
        return self._asked(self._ask, question, is_required)

    def _asked(self, ask: Ask, question: Question, is_required: bool) -> Figure | None:
        skip = "" if is_required else f", Enter: {question.without}"
        while True:
            answer = ask(f"{question.words} ({question.of}{skip})").strip()
            if not answer and not is_required:
                return None
            try:
                found = figure(answer, question.of)
            except ValueError as error:
                self._say(f"  {error}")
                continue
            fault = question.fault(found)
            self._say(f"  {fault or _shown(found, question.of)}")
            if fault is None:
                return found

    def position(self, known: tuple[float, float, float] | None) -> tuple[float, float, float] | None:
        """The position of the phone; None if the answer is empty."""
        if known is not None or self._ask is None:
            return known
        while True:
            answer = self._ask(PHONE_PLACE).strip()
            if not answer:
                return None
            try:
                return position(answer)
            except ValueError as error:
                self._say(f"  {error}")


def position(text: str) -> tuple[float, float, float]:
    """``0.3 0 -0.1`` or ``30cm 0 -10cm``; ValueError says what was expected."""
    words = SEPARATORS.split(text.strip())
    if len(words) != 3:
        raise ValueError(f"expected three numbers separated by spaces (forward, to port, up), found `{text}`")
    x, y, z = (figure(word, "metres").value for word in words)
    return x, y, z


def _shown(found: Figure, of: str) -> str:
    unit = {"metres": " m", "kilograms": " kg", "degrees": "°"}.get(of, f" {of}")
    return f"{found.value:g}{unit} ± " + (USUAL[of] if found.u is None else f"{found.u:g}{unit}")


def hanging(dialogue: Dialogue, kind: str, known: Mapping[str, Figure | None]) -> dict[str, Any]:
    """The figures of a suspension, for an import."""
    own = {question.name for question in (*REQUIRED[kind], *OPTIONAL[kind])}
    for name, question in OF_SUSPENSIONS.items():
        if known.get(name) is not None and name not in own:
            raise _core.InputError(f"{question.option}: a {kind} suspension has no such figure")
    wanted = [(question, True) for question in REQUIRED[kind]] + [(question, False) for question in OPTIONAL[kind]]
    found = {one.name: dialogue.figure(one, known.get(one.name), required) for one, required in wanted}
    return {name: value.stated() for name, value in found.items() if value is not None}
