"""What several commands do: read a session, measure and criticise it, write what was found."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from . import _core
from .arguments import Language
from .console import error_console
from .critique import Critique
from .files import write_whole
from .interrupt import heard_during
from .measurement import Measurement
from .outcome import reason_without_result, with_reason, write_json
from .progress import counted, working
from .session import Session, load

# Forms of a report, by the end of its name.
FORMS = (".html", ".htm", ".pdf")


def report_form(output: Path) -> str:
    """The end of a report's name; InputError where it is that of another document."""
    if str(output) == "-":
        raise _core.InputError("-o: a report goes to a file whose name ends in .html or .pdf")
    form = output.suffix.lower()
    if form and form not in FORMS:
        raise _core.InputError(f"{output}: expected a name that ends in .html or .pdf")
    return form


def write_report(
    measurement: Measurement,
    output: Path,
    critique: Critique | str | None = None,
    language: Language = Language.en,
) -> None:
    """Write a report as HTML, or as PDF where the name ends so; with a criticism, or why there is none."""
    html = measurement.to_html(critique, language.value)
    if report_form(output) == ".pdf":
        from .pdf import laid_out

        # Layout takes seconds, and reportlab may swallow Ctrl-C.
        write_whole(output, heard_during(laid_out, html))
    else:
        write_whole(output, html)


def written(measurement: Measurement, json: str | None, critique: Critique | None = None) -> str | None:
    """Write the JSON where it is wanted; answers why there is no result, where there is none."""
    reason = reason_without_result(measurement)
    if json is not None:
        text = measurement.to_json(critique)
        write_json(text if reason is None else with_reason(text, reason), json)
    return reason


def loaded(path: str, mapping: list[str] | None = None) -> Session:
    """Read a session, with what is being done shown."""
    with working(error_console(), f"reading {path}"):
        return heard_during(load, path, mapping=mapping or [])


def measured(session: Session, limits: list[str] | None = None) -> Measurement:
    """Measure it."""
    with working(error_console(), f"measuring {session.title}"):
        return heard_during(session.measure, limits or [])


def criticised(session: Session, by_sets: bool = False) -> Critique:
    """Criticise it."""

    def work(progress: Callable[[float, str], object]) -> Critique:
        return session.critique(progress, by_sets=by_sets)

    with counted(error_console(), "criticising") as told:
        return heard_during(work, told)


def critique_or_reason(session: Session) -> Critique | str:
    """Its criticism, or why there is none."""
    try:
        return criticised(session)
    except _core.GyradiusError as error:
        error_console().print(f"no criticism: {error}", soft_wrap=True)
        return str(error)
