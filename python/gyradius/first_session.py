"""From recordings to a session, its result and its report, in one step."""

from __future__ import annotations

import json
import os
import shutil
import webbrowser
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import _core
from .arguments import Figure
from .dialogue import DIRECTED, DIRECTIONS, GRAVITY, KINDS, MASS, PHONE_MASS, Dialogue, Question, hanging
from .files import write_whole
from .imports import SESSION_FILE, ImportPlan, describe_exports, import_files, import_into
from .interrupt import heard_during
from .session import Session, load

FORMAT = "gyradius-new/1"
REPORT = "report.html"


@dataclass(frozen=True, slots=True)
class Phone:
    """The phone as an attachment of the body; m, kg."""

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
    """What is stated by options, before any question is asked."""

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
        """The options of an import."""
        return {"mapping": list(self.mapping), "trial": self.trial, "platform": self.platform}


def make_session(
    dialogue: Dialogue,
    recordings: Recordings,
    folder: Path,
    known: Known,
    *,
    title: str,
    replace: bool,
) -> tuple[Session, list[str]]:
    """Ask for what is not known and write the session; returns it with notes for the user."""
    kind = dialogue.choice("--suspension", "How did the body hang", known.suspension, KINDS)
    direction = None
    if kind in DIRECTED:
        direction = dialogue.choice("--orientation", "The points lie", known.orientation, DIRECTIONS)
    hung: dict[str, Any] = {"suspension": kind, "orientation": direction, **hanging(dialogue, kind, known.figures)}
    mass = dialogue.figure(MASS, known.figures.get("mass"), False)
    gravity = dialogue.figure(GRAVITY, known.figures.get("gravity"), False)
    phone = _phone(dialogue, known, mass)
    first, *others = recordings.files
    tilts = [_tilt(dialogue, file, kind) for file in others]
    alike = [file for file, tilt in zip(others, tilts, strict=True) if tilt is None]
    of_body: dict[str, Any] = {
        "mass": mass and mass.stated(),
        "gravity": gravity and gravity.stated(),
        "title": title,
        "replace": replace,
    }
    with _whole_or_nothing(folder):
        found = import_files([first, *alike], folder, **hung, **of_body, **recordings.options())
        tilted = [(file, tilt) for file, tilt in zip(others, tilts, strict=True) if tilt is not None]
        like = load(folder).swing_ids[0] if tilted else None
        for file, tilt in tilted:
            found += import_into([file], folder, like=like, hull_pitch=tilt.stated(), **recordings.options())
        if phone is not None:
            _append(folder / SESSION_FILE, phone.toml())
        return heard_during(load, folder), found


def check_before(recordings: Recordings, folder: Path, known: Known, is_asked: bool, replace: bool) -> None:
    """Refuse what cannot end well before anything is asked: files, folder, a tilt that would hold for all."""
    files = [os.path.realpath(file) for file in recordings.files]
    for place, file in enumerate(files):
        if file in files[:place]:
            raise _core.InputError(f"{recordings.files[place]}: named twice; name each recording once")
    if folder == Path():
        raise _core.InputError("-o: expected the name of a new folder")
    is_taken = folder.is_file() or (folder.is_dir() and any(folder.iterdir()))
    if is_taken and (folder.is_file() or not replace):
        raise _core.InputError(f"{folder}: it exists already; name another folder with -o (or --replace)")
    if len(files) > 1 and known.figures.get("hull_pitch") is not None and not is_asked:
        raise _core.InputError(
            "--hull-pitch: it would hold for every recording; give recordings of one tilt, and add the others with"
            " `gyradius import FILE --into SESSION --like SWING --hull-pitch DEGREES`"
        )
    describe_exports(recordings.files, ImportPlan(**recordings.options()))


@contextmanager
def _whole_or_nothing(folder: Path) -> Iterator[None]:
    """A folder that was not there before is removed where it does not become a session."""
    was_there = folder.exists()
    try:
        yield
    except BaseException:
        if not was_there:
            shutil.rmtree(folder, ignore_errors=True)
        raise


def _tilt(dialogue: Dialogue, file: str, kind: str) -> Figure | None:
    """The tilt of a further recording, if it differs from that of the first."""
    if kind not in DIRECTED:
        return None
    words = f"{os.path.basename(file)}: tilt of the body, bow up, if different from the first"
    return dialogue.figure(Question("hull_pitch", "degrees", words, "same as the first"), None, False)


def _phone(dialogue: Dialogue, known: Known, body: Figure | None) -> Phone | None:
    """The phone, to be taken off the result; this needs the body's mass."""
    mass, place = known.figures.get("phone_mass"), known.phone_position_m
    is_stated = mass is not None or place is not None
    if body is None:
        if is_stated:
            raise _core.InputError("--phone-mass, --phone-position: these options also need --mass")
        return None
    weight = dialogue.figure(PHONE_MASS, mass, False)
    where = None if weight is None else dialogue.position(place)
    if weight is not None and weight.value >= body.value:
        raise _core.InputError(f"--phone-mass: {weight.value:g} kg is not less than everything that swings")
    if weight is not None and where is not None:
        return Phone(weight, where)
    if is_stated:
        raise _core.InputError("--phone-mass, --phone-position: state both or neither")
    return None


def _append(file: Path, text: str) -> None:
    write_whole(file, file.read_text(encoding="utf-8") + text)


def open_in_browser(file: Path) -> bool:
    """Show a page; False if there is no browser."""
    return webbrowser.open(file.resolve().as_uri())


def made_json(folder: Path, report: Path, notes: list[str], measurement: str) -> str:
    """Where everything was written, and the measurement's own JSON."""
    places = {"format": FORMAT, "session": str(folder), "report": str(report), "notes": notes}
    head = json.dumps(places, ensure_ascii=False, indent=2).removesuffix("}").rstrip()
    return f'{head},\n  "measurement": {measurement.strip()}\n}}\n'
