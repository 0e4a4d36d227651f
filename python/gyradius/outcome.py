"""How a command ends: its exit status, its JSON, and never a traceback."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import typer
from rich.console import Console
from rich.text import Text

from ._core import GyradiusError, NoResultError
from .measurement import FORMAT

NO_RESULT = 1
BAD_INPUT = 2
# Not one of the statuses of the contract: a mistake of this program (EX_SOFTWARE of sysexits.h).
INTERNAL = 70
INTERRUPTED = 130


@contextmanager
def reported(errors: Console, json_to: str | None = None, form: str = FORMAT) -> Iterator[None]:
    """Turn what goes wrong inside into a message, the JSON (of format ``form``) and an exit status."""
    try:
        if json_to not in (None, "-"):
            can_be_written(Path(str(json_to)))
        yield
    except GyradiusError as error:
        status = NO_RESULT if isinstance(error, NoResultError) else BAD_INPUT
        _fail(errors, json_to, form, str(error), status, error.file, error.line)
    except BrokenPipeError:
        _silence_standard_output()
        raise typer.Exit(0) from None
    except OSError as error:
        _fail(errors, json_to, form, f"{error.filename or 'output'}: {error.strerror or error}", BAD_INPUT)
    except KeyboardInterrupt:
        raise typer.Exit(INTERRUPTED) from None
    except (typer.Exit, typer.Abort, typer.BadParameter):
        raise
    except Exception as error:
        if os.environ.get("GYRADIUS_TRACEBACK"):
            raise
        say = f"a mistake of this program, please report it: {type(error).__name__}: {error}"
        _fail(errors, json_to, form, say, INTERNAL)


def can_be_written(target: Path) -> None:
    """Refuse at once what could not be written after minutes of work: the folder is not there."""
    if not target.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target))


def write_json(text: str, target: str) -> None:
    """Write JSON to a file, or to standard output for ``-``."""
    text = text if text.endswith("\n") else text + "\n"
    if target == "-":
        typer.echo(text, nl=False)
    else:
        Path(target).write_text(text, encoding="utf-8")


def error_json(form: str, message: str, status: int, file: str | None, line: int | None) -> str:
    """The result that there is not: the reason in its place."""
    kind = {NO_RESULT: "no_result", BAD_INPUT: "input"}.get(status, "internal")
    error = {"kind": kind, "message": message, "file": file, "line": line}
    return json.dumps({"format": form, "error": error}, ensure_ascii=False, indent=2)


def _fail(
    errors: Console,
    json_to: str | None,
    form: str,
    message: str,
    status: int,
    file: str | None = None,
    line: int | None = None,
) -> None:
    if json_to is not None:
        try:
            write_json(error_json(form, message, status, file, line), json_to)
        except OSError as error:
            message, status = f"{message}; {json_to}: {error.strerror}", BAD_INPUT
    errors.print(Text(f"gyradius: {message}"), soft_wrap=True)
    raise typer.Exit(status) from None


def _silence_standard_output() -> None:
    # The reader of the pipe went away: what is still buffered must not raise again at exit.
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
