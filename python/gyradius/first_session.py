"""From recordings to a session, its result and its report, in one go."""

from __future__ import annotations

import json
import os
import webbrowser
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import _core
from .arguments import Figure
from .dialogue import DIRECTIONS, KINDS, MASS, PHONE_MASS, Dialogue, Question, hanging
from .files import write_whole
from .imports import SESSION_FILE, import_files, import_into
from .session import load

REPORT = "report.html"


@dataclass(frozen=True, slots=True)
class Phone:
    """The phone as it rides on the body; lengths in m, kg."""

    mass: Figure
    position_m: tuple[float, float, float]

    def toml(self) -> str:
        """The attachment as the session states it."""
        value, u = self.mass.value, self.mass.u
        mass = repr(value) if u is None else f"{{ value = {value!r}, u = {u!r} }}"
        place = ", ".join(repr(float(x)) for x in self.position_m)
        return (
            f'\n[[attachment]]\nname = "phone"\nmass = {mass}  # kg\nposition = [{place}]  # m, forward, to port, up\n'
        )


@dataclass(frozen=True, slots=True)
class Known:
    """What is stated before anything is asked."""

    suspension: str | None
    orientation: str | None
    figures: Mapping[str, Figure | None]
    phone_position_m: tuple[float, float, float] | None


@dataclass(frozen=True, slots=True)
class Recordings:
    """The files of a session, and how to read them."""

    files: tuple[str, ...]
    mapping: tuple[str, ...] = ()
    trial: str | None = None
    platform: Any = None

    def options(self) -> dict[str, Any]:
        """As an import takes them."""
        return {"mapping": list(self.mapping), "trial": self.trial, "platform": self.platform}


def make_session(
    dialogue: Dialogue,
    recordings: Recordings,
    folder: Path,
    known: Known,
    *,
    title: str,
    replace: bool,
) -> list[str]:
    """Ask for what is not known and write the session; returns what a reader must know."""
    kind = dialogue.choice("How did it hang", known.suspension, KINDS)
    has_direction = kind in ("bifilar", "compound")
    direction = dialogue.choice("The points lie", known.orientation, DIRECTIONS) if has_direction else None
    hung: dict[str, Any] = {"suspension": kind, "orientation": direction, **hanging(dialogue, kind, known.figures)}
    mass = dialogue.figure(MASS, known.figures.get("mass"), False)
    phone = _phone(dialogue, known, mass)
    first, *others = recordings.files
    tilts = [_tilt(dialogue, file, kind, known.figures) for file in others]
    alike = [file for file, tilt in zip(others, tilts, strict=True) if tilt is None]
    of_body: dict[str, Any] = {"mass": mass and mass.stated(), "title": title, "replace": replace}
    found = import_files([first, *alike], folder, **hung, **of_body, **recordings.options())
    for file, tilt in zip(others, tilts, strict=True):
        if tilt is not None:
            like = load(folder).swing_ids[0]
            found += import_into([file], folder, like=like, hull_pitch=tilt.stated(), **recordings.options())
    if phone is not None:
        _append(folder / SESSION_FILE, phone.toml())
    return found


def _tilt(dialogue: Dialogue, file: str, kind: str, known: Mapping[str, Figure | None]) -> Figure | None:
    """The tilt of a further recording, where it hung otherwise than the first."""
    if kind not in ("bifilar", "compound") or known.get("hull_pitch") is not None:
        return None
    words = f"{os.path.basename(file)}: tilt of the body, bow up, if it was another"
    return dialogue.figure(Question("hull_pitch", "degrees", words, "hung as the first"), None, False)


def _phone(dialogue: Dialogue, known: Known, body: Figure | None) -> Phone | None:
    """What is taken off the result; without the body's mass nothing can be."""
    mass, place = known.figures.get("phone_mass"), known.phone_position_m
    is_stated = mass is not None or place is not None
    if body is None:
        if is_stated:
            raise _core.InputError("--phone-mass, --phone-position: expected --mass beside them")
        return None
    weight = dialogue.figure(PHONE_MASS, mass, False)
    where = None if weight is None else dialogue.position(place)
    if weight is not None and where is not None:
        return Phone(weight, where)
    if is_stated:
        raise _core.InputError("--phone-mass, --phone-position: expected both")
    return None


def _append(file: Path, text: str) -> None:
    write_whole(file, file.read_text(encoding="utf-8") + text)


def open_in_browser(file: Path) -> bool:
    """Show a page; False where there is no browser."""
    return webbrowser.open(file.resolve().as_uri())


def made_json(folder: Path, report: Path, notes: list[str], measurement: str) -> str:
    """Where everything was written, and the measurement's own JSON."""
    places = json.dumps({"session": str(folder), "report": str(report), "notes": notes}, ensure_ascii=False, indent=2)
    return f'{places.removesuffix("}").rstrip()},\n  "measurement": {measurement.strip()}\n}}\n'
