"""The questions that make a session of recordings: how the body hung, what it weighs, where the phone was."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from . import _core
from .arguments import Figure, figure


@dataclass(frozen=True, slots=True)
class Question:
    """A figure that is asked for: the option that states it as well, its kind, the words."""

    name: str
    of: str
    words: str
    without: str = "leave out"

    @property
    def option(self) -> str:
        """``--line-length``."""
        return "--" + self.name.replace("_", "-")


LINE_LENGTH = Question("line_length", "metres", "length of the lines, point to point")
# What cannot be done without, by suspension.
REQUIRED: Mapping[str, tuple[Question, ...]] = {
    "bifilar": (LINE_LENGTH, Question("spacing", "metres", "distance of the two suspension points on the body")),
    "trifilar": (LINE_LENGTH, Question("radius", "metres", "radius of the circle through the line ends below")),
    "compound": (Question("axis_height", "metres", "height of the swing axis above the suspension points"),),
    "free": (),
}
OPTIONAL: Mapping[str, tuple[Question, ...]] = {
    "bifilar": (
        Question("top_spacing", "metres", "distance of the two points above, where it differs"),
        Question("hull_pitch", "degrees", "tilt of the body as it hung, bow up"),
    ),
    "trifilar": (Question("top_radius", "metres", "radius of the circle above, where it differs"),),
    "compound": (Question("hull_pitch", "degrees", "tilt of the body as it hung, bow up"),),
    "free": (),
}
MASS = Question("mass", "kilograms", "mass of everything that swings, phone included")
PHONE_MASS = Question("phone_mass", "kilograms", "mass of the phone")
KINDS = {
    "1": ("bifilar", "two lines"),
    "2": ("compound", "a fixed horizontal axis (two inverted Vs)"),
    "3": ("trifilar", "three lines"),
    "4": ("free", "anything else: periods and damping alone"),
}
DIRECTIONS = {"1": ("athwartships", "across the body"), "2": ("fore_and_aft", "along the body")}
PHONE_PLACE = "place of the phone: forward, to port, up from the middle of the points (metres, Enter: leave out)"
Ask = Callable[[str], str]
Say = Callable[[str], None]


class Dialogue:
    """Asks until an answer can be read. With ``ask`` None nothing is asked, and what is required must be given."""

    def __init__(self, ask: Ask | None, say: Say) -> None:
        """``ask`` shows a question and returns the answer, ``say`` shows a line."""
        self._ask, self._say = ask, say

    def choice(self, words: str, known: str | None, choices: Mapping[str, tuple[str, str]]) -> str:
        """One of a few; the first where nothing is answered or asked."""
        if known is not None or self._ask is None:
            return known or choices["1"][0]
        for key, (_, meaning) in choices.items():
            self._say(f"  {key}  {meaning}")
        while True:
            answer = self._ask(f"{words} [1]").strip() or "1"
            if answer in choices:
                return choices[answer][0]
            self._say(f"  expected {', '.join(choices)}, found `{answer}`")

    def figure(self, question: Question, known: Figure | None, is_required: bool) -> Figure | None:
        """A figure; None where it is optional and nothing is answered."""
        if known is not None:
            return known
        if self._ask is None:
            if is_required:
                raise _core.InputError(f"{question.option}: expected the {question.words} ({question.of})")
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
            self._say(f"  {_shown(found, question.of)}")
            return found

    def position(self, known: tuple[float, float, float] | None) -> tuple[float, float, float] | None:
        """Where the phone is; None where nothing is answered."""
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
    words = text.replace(";", " ").split()
    if len(words) != 3:
        raise ValueError(f"expected three numbers with spaces between (forward, to port, up), found `{text}`")
    x, y, z = (figure(word, "metres").value for word in words)
    return x, y, z


def _shown(found: Figure, of: str) -> str:
    unit = {"metres": " m", "kilograms": " kg", "degrees": "°"}.get(of, f" {of}")
    u = "the usual uncertainty of its kind" if found.u is None else f"± {found.u:g}{unit}"
    return f"{found.value:g}{unit}, {u}"


def hanging(dialogue: Dialogue, kind: str, known: Mapping[str, Figure | None]) -> dict[str, Any]:
    """The figures of a suspension, as an import takes them."""
    wanted = [(question, True) for question in REQUIRED[kind]] + [(question, False) for question in OPTIONAL[kind]]
    found = {one.name: dialogue.figure(one, known.get(one.name), required) for one, required in wanted}
    return {name: value.stated() for name, value in found.items() if value is not None}
