"""How a command ends: its exit status, its JSON, and never a traceback."""

from __future__ import annotations

import errno
import json
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NoReturn

import typer
from rich.console import Console
from rich.text import Text

from ._core import GyradiusError, NoResultError
from .console import silence_standard_output
from .files import can_be_written, write_whole
from .interrupt import INTERRUPTED, unwinding, was_interrupted
from .measurement import FORMAT, Measurement

NO_RESULT = 1
BAD_INPUT = 2
# Not one of the statuses of the contract: an internal error (EX_SOFTWARE of sysexits.h).
INTERNAL = 70
# What the core raises when one of its own assertions fails; the class cannot be imported.
PANIC = "PanicException"
# A bare recording gives modes, and is not asked for more.
BARE_RECORDING = "inertia.bare_recording"
NO_ESTIMATE = "inertia.no_joint_estimate"


@contextmanager
def reported(errors: Console, json_to: str | None = None, form: str = FORMAT) -> Iterator[None]:
    """Turn what goes wrong inside into a message, the JSON (of format ``form``) and an exit status."""
    try:
        with unwinding():
            try:
                if json_to not in (None, "-"):
                    can_be_written(Path(str(json_to)))
                yield
                # What does not fit on the disk must be known before the end.
                _flushed()
            except BaseException as error:
                _end(error, errors, json_to, form)
    except KeyboardInterrupt:
        # The line that says so is printed where threads that still work are ended.
        raise typer.Exit(INTERRUPTED) from None


def _end(error: BaseException, errors: Console, json_to: str | None, form: str) -> NoReturn:
    if isinstance(error, KeyboardInterrupt) or (was_interrupted() and isinstance(error, Exception)):
        raise KeyboardInterrupt from None
    if isinstance(error, BrokenPipeError):
        silence_standard_output()
        raise typer.Exit(0) from None
    if isinstance(error, typer.BadParameter) and json_to is not None:
        write_json(error_json(form, error.message, BAD_INPUT, None, None), json_to)
    if isinstance(error, typer.Exit | typer.Abort | typer.BadParameter):
        raise error
    if isinstance(error, GyradiusError):
        status = NO_RESULT if isinstance(error, NoResultError) else BAD_INPUT
        _fail(errors, json_to, form, str(error), status, error.file, error.line)
    if isinstance(error, OSError):
        if error.filename is None:
            silence_standard_output()
        # A JSON file that could not be written stays what it was.
        _fail(errors, None if error.filename == json_to else json_to, form, _of_system(error), BAD_INPUT)
    is_panic = type(error).__name__ == PANIC
    if not (is_panic or isinstance(error, Exception)) or os.environ.get("GYRADIUS_TRACEBACK"):
        raise error
    found = f"the core failed: {error}" if is_panic else f"{type(error).__name__}: {error}"
    _fail(errors, json_to, form, f"internal error; please report it: {found}", INTERNAL)


def _of_system(error: OSError) -> str:
    where = "standard output" if error.filename is None else error.filename
    return f"{os.fsdecode(where) if isinstance(where, bytes) else where}: {error.strerror or error}"


def reason_without_result(measurement: Measurement) -> str | None:
    """Why a session gave no quantity; None where it did, and for a bare recording, which gives its modes."""
    said = json.loads(measurement.to_json()).get("warnings_said", [])
    keys: dict[str, str] = {message["key"]: message["english"] for message in said}
    if measurement.quantities or BARE_RECORDING in keys:
        return None
    return keys.get(NO_ESTIMATE, f"{measurement.title}: these swings determine no quantity")


def with_reason(text: str, reason: str) -> str:
    """A result's JSON with the reason why there is no more in it; every number stays as it is written."""
    body = text.rstrip().removesuffix("}").rstrip()
    return f'{body},\n  "error": {json.dumps(_error(reason, NO_RESULT), ensure_ascii=False)}\n}}\n'


def end_without_result(errors: Console, reason: str) -> NoReturn:
    """End with the status of data that allow no result, after what they do give was shown and written."""
    _say(errors, reason)
    raise typer.Exit(NO_RESULT)


def write_json(text: str, target: str) -> None:
    """Write JSON to a file, or to standard output for ``-``; JSON is UTF-8 whatever the terminal's encoding."""
    text = text if text.endswith("\n") else text + "\n"
    if target == "-":
        typer.echo(text.encode("utf-8", "replace"), nl=False)
    else:
        write_whole(Path(target), text)


def error_json(form: str, message: str, status: int, file: str | None, line: int | None) -> str:
    """The JSON in place of a result: the reason why there is none."""
    return json.dumps({"format": form, "error": _error(message, status, file, line)}, ensure_ascii=False, indent=2)


def _error(message: str, status: int, file: str | None = None, line: int | None = None) -> dict[str, str | int | None]:
    kind = {NO_RESULT: "no_result", BAD_INPUT: "input"}.get(status, "internal")
    return {"kind": kind, "message": message, "file": file, "line": line}


def _fail(
    errors: Console,
    json_to: str | None,
    form: str,
    message: str,
    status: int,
    file: str | None = None,
    line: int | None = None,
) -> NoReturn:
    if json_to is not None:
        try:
            write_json(error_json(form, message, status, file, line), json_to)
            _flushed()
        except OSError as error:
            if error.errno != errno.EPIPE and _of_system(error) not in message:
                message, status = f"{message}; {_of_system(error)}", BAD_INPUT
            silence_standard_output()
    _say(errors, message)
    raise typer.Exit(status) from None


def _say(errors: Console, message: str) -> None:
    # Where nobody listens the status must do.
    with suppress(OSError):
        errors.print(Text(f"gyradius: {message}"), soft_wrap=True)


def _flushed() -> None:
    if sys.stdout is not None:
        sys.stdout.flush()
