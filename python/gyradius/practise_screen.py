"""The command ``practise`` on a terminal: the procedure's instructions, live, and one key for each action."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from rich.console import Console, Group, RenderableType
from rich.live import Live as Screen
from rich.panel import Panel
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from .interrupt import heard_during
from .numbers import with_u
from .practice import Practice
from .progress import counted

# What a key does; Enter does what the book says, and a digit opens the step of that number again.
KEYS = {
    "a": "accept",
    "r": "repeat",
    "s": "skip",
    "l": "set_reference",
    "x": "stop_recording",
    "k": "keep",
    "t": "retry",
}
NAMES = {
    "accept": "accept",
    "repeat": "repeat",
    "skip": "skip",
    "set_reference": "level is here",
    "stop_recording": "stop recording",
    "keep": "keep what was recorded",
    "retry": "try once more",
}
# Nothing goes on by itself here.
ENDS = ("done", "failed")
FRAME_S = 0.1
# A careful operator looks at the simulated hull this often, s of its time.
LOOK_S = 5.0


class Left(Exception):
    """The operator left; the folder keeps everything."""


def play(console: Console, practice: Practice, *, speed: float | None, auto: bool, critique: bool) -> None:
    """Play the procedure to its end: automatically if ``auto`` is true, else by the operator's keys."""
    if auto:
        _by_itself(console, practice, speed, critique)
    else:
        _by_hand(console, practice, speed or 1.0, critique)


def _by_itself(console: Console, practice: Practice, speed: float | None, critique: bool) -> None:
    said = ""
    while (state := practice.state)["phase"] != "done":
        # A criticism that nobody asked for is left out before its sentence announces it.
        if state["work"] == "critique" and not critique:
            practice.handle("skip")
            continue
        sentence = state["instruction"]["english"]
        if state["phase"] not in ("level", "rest", "record") and sentence != said:
            _say(console, state, sentence)
            said = sentence
        if _worked(console, practice, state, critique):
            continue
        event = practice.by_the_book()
        if event is not None:
            practice.handle(event.pop("event"), **event)
            continue
        if state["phase"] == "failed":
            return
        gone_s = practice.advance(LOOK_S if speed is None else FRAME_S * speed)
        if speed is not None:
            time.sleep(gone_s / speed)


def _say(console: Console, state: dict[str, Any], sentence: str) -> None:
    console.print(Text(sentence), soft_wrap=True)
    judgement = state["judgement"]
    if judgement is not None:
        if judgement["swing"] is not None:
            console.print(Text(f"  period {_period(judgement['swing'])}"), soft_wrap=True)
        for kind, style in (("reasons", "yellow"), ("notes", "dim")):
            for text in judgement[kind]:
                console.print(Text(f"  {text['english']}", style=style), soft_wrap=True)


def _worked(console: Console, practice: Practice, state: dict[str, Any], critique: bool) -> bool:
    """Do the work that is wanted; the criticism is left out where nobody asked for it."""
    if state["work"] is None:
        return False
    if state["work"] == "critique" and not critique:
        practice.handle("skip")
        return True
    with counted(console, {"measure": "result", "critique": "criticism"}[state["work"]]) as told:
        heard_during(practice.work, told)
    return True


def _by_hand(console: Console, practice: Practice, speed: float, critique: bool) -> None:
    ended = False
    while not ended:
        if _worked(console, practice, practice.state, critique):
            continue
        with _keys() as pressed, Screen(console=console, auto_refresh=False, transient=True) as screen:
            ended = _frames(practice, screen, pressed, speed)
    _say(console, practice.state, practice.state["instruction"]["english"])


def _frames(practice: Practice, screen: Screen, pressed: Callable[[float], str], speed: float) -> bool:
    """Show the procedure until work is wanted; true where the operator ends it."""
    while (state := practice.state)["work"] is None:
        screen.update(_panel(practice, state, speed), refresh=True)
        before = time.monotonic()
        key = pressed(FRAME_S)
        if key == "q":
            raise Left
        if key in ("\r", "\n") and state["phase"] in ENDS:
            return True
        _pressed(practice, state, key)
        practice.advance(speed * (time.monotonic() - before))
    return False


def _pressed(practice: Practice, state: dict[str, Any], key: str) -> None:
    if key in ("\r", "\n"):
        event = practice.by_the_book()
        if event is not None:
            practice.handle(event.pop("event"), **event)
    elif KEYS.get(key) in state["actions"]:
        practice.handle(KEYS[key])
    elif key.isdecimal() and 1 <= int(key) <= _done(state):
        practice.handle("reopen", step=int(key) - 1)


def _done(state: dict[str, Any]) -> int:
    """So many steps from the first may be opened again."""
    if "reopen" not in state["actions"]:
        return 0
    step = state["step"]
    return int(state["progress"]["steps"] if step is None else step["index"])


def _panel(practice: Practice, state: dict[str, Any], speed: float) -> RenderableType:
    step = state["step"]
    title = state["phase"] if step is None else f"{state['phase']} · {step['id']} · {step['index'] + 1}/{step['count']}"
    parts: list[RenderableType] = [Text(state["instruction"]["english"], style="bold"), Text()]
    parts.extend(_figures(state))
    if state["phase"] in ENDS:
        parts.extend(Text(sentence) for sentence in _compared(practice))
    for text in state["warnings"]:
        parts.append(Text(text["english"], style="red"))
    # A bar ends no line of its own: in a table it does.
    bar = Table.grid(expand=True)
    bar.add_row(ProgressBar(total=1.0, completed=state["progress"]["share"]))
    parts.extend([Text(), bar, _offers(practice, state)])
    return Panel(Group(*parts), title=Text(title), subtitle=f"{speed:g} × real time", width=100)


def _figures(state: dict[str, Any]) -> Iterator[RenderableType]:
    grid = Table.grid(padding=(0, 2))
    recording, judgement, advice = state["recording"], state["judgement"], []
    if recording is not None:
        advice = recording["advice"]
        swing = (recording["live"] or {}).get("swing")
        grid.add_row("recorded", f"{recording['recorded_s']:.0f} s")
        if recording["left_s"] is not None:
            grid.add_row("to go", f"{recording['left_s']:.0f} s")
        if recording["amplitude_deg"] is not None:
            grid.add_row("amplitude", f"{recording['amplitude_deg']:.1f}° (wanted {recording['wanted_deg']:.1f}°)")
        if swing is not None:
            grid.add_row("period", _period(swing))
    if judgement is not None:
        advice = judgement["reasons"] + judgement["notes"]
        if judgement["swing"] is not None:
            grid.add_row("period", _period(judgement["swing"]))
    tilt = state["tilt"]
    if tilt is not None and tilt["angle_deg"] is not None:
        grid.add_row("tilt", f"{tilt['angle_deg']:.1f}°")
    yield grid
    for text in advice:
        yield Text(text["english"], style="yellow")


def _period(swing: dict[str, Any]) -> str:
    return f"{with_u(swing['period_s'], swing['period_u_s'])} s"


def _offers(practice: Practice, state: dict[str, Any]) -> Text:
    event = practice.by_the_book()
    offers = [f"Enter: {_named(event)}"] if event is not None else []
    if state["phase"] in ENDS:
        offers = ["Enter: end"]
    offers += [f"{key}: {NAMES[action]}" for key, action in KEYS.items() if action in state["actions"]]
    if done := min(_done(state), 9):
        offers.append(f"{'1' if done == 1 else f'1 to {done}'}: make that step again")
    return Text("   ".join([*offers, "q: leave"]), style="dim")


def _named(event: dict[str, Any]) -> str:
    name = event["event"]
    if name != "measured":
        return str(name).replace("_", " ")
    lengths = ("line_length_m", "spacing_m", "axis_height_m", "mass_kg", "arm_m", "depth_m")
    read = [f"{key} {with_u(event[key]['value'], event[key]['u'])}" for key in lengths if event.get(key)]
    return f"type in what the tape says ({', '.join(read)})"


@contextmanager
def _keys() -> Iterator[Callable[[float], str]]:
    """Keys as they are pressed: what is yielded waits so many seconds for one, and gives none as an empty text."""
    if sys.platform == "win32":
        import msvcrt

        def pressed(seconds: float) -> str:
            time.sleep(seconds)
            return msvcrt.getwch() if msvcrt.kbhit() else ""

        yield pressed
        return
    import select
    import termios
    import tty

    before = termios.tcgetattr(sys.stdin)

    def waited(seconds: float) -> str:
        ready, _, _ = select.select([sys.stdin], [], [], seconds)
        return sys.stdin.read(1) if ready else ""

    try:
        tty.setcbreak(sys.stdin)
        yield waited
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)


def show_compared(console: Console, practice: Practice) -> None:
    """Print the measured values beside the true ones."""
    for sentence in _compared(practice):
        console.print(Text(sentence), soft_wrap=True)


def _compared(practice: Practice) -> Iterator[str]:
    for row in practice.compared():
        figure = with_u(row["value"], row["u"])
        off = "" if row["sigma"] is None else f" ({abs(row['sigma']):.1f} u off)"
        yield f"{row['title']}: you measured {figure} {row['unit']}; the simulated hull has {row['true']:.4f}{off}"
