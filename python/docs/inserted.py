"""What the pages take from elsewhere: chapters of README files, options of the commands, cells of notebooks."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import typer

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
INCLUDE = re.compile(r'^<!-- include: (\S+) from "([^"]+)"(?: to "([^"]+)")? -->$', re.M)
OPTIONS = re.compile(r"^<!-- options -->$", re.M)
CODE = re.compile(r"`[^`\n]+`")
PICTURE = re.compile(r'savefig\("([^"/]+\.png)"')
NOTEBOOK = re.compile(r"^<!-- notebook: (\S+) -->$", re.M)


class MissingError(Exception):
    """Something that a page includes is not there."""


def insert(text: str) -> str:
    """The text of a page with all that its comments ask for."""
    text = INCLUDE.sub(lambda found: chapters(*found.groups()), text)
    text = OPTIONS.sub(lambda _: option_tables(), text)
    return NOTEBOOK.sub(lambda found: cells(HERE / "notebooks" / found[1]), text)


def chapters(file: str, start: str, end: str | None = None) -> str:
    """The part of a Markdown file after the heading that begins with ``start``, up to the one with ``end``."""
    lines = (ROOT / file).read_text(encoding="utf-8").splitlines()
    first = _heading(lines, start, file)
    last = len(lines) if end is None else _heading(lines, end, file)
    text = "\n".join(lines[first + 1 : last]).strip() + "\n"
    # A bar in code divides no cells here, and would be shown with its backslash.
    return CODE.sub(lambda found: found[0].replace("\\|", "|"), text)


def _heading(lines: list[str], text: str, file: str) -> int:
    for number, line in enumerate(lines):
        if line.startswith(text):
            return number
    raise MissingError(f"{file}: a heading that begins with `{text}` was expected, found none")


def option_tables() -> str:
    """Every command with its arguments and options, as it says them itself."""
    from gyradius.cli import app

    commands: dict[str, Any] = typer.main.get_command(app).commands  # type: ignore[attr-defined]
    return "\n".join(_command(name, command) for name, command in commands.items())


def _command(name: str, command: Any) -> str:
    rows = [_row(option) for option in command.params]
    table = ["| option | meaning |", "|---|---|", *rows]
    return "\n".join([f"### gyradius {name}", "", (command.help or "").strip(), "", *table, ""])


def _row(option: Any) -> str:
    names = ", ".join(f"`{name}`" for name in (*option.opts, *option.secondary_opts))
    value = f" `{option.metavar}`" if option.metavar else ""
    if option.param_type_name == "argument":
        names, value = f"`{option.metavar or option.name.upper()}`", ""
    meaning = (getattr(option, "help", None) or "").replace("|", "\\|")
    return f"| {names}{value} | {meaning} |"


def cells(notebook: Path) -> str:
    """A notebook as Markdown: its text, its code in blocks that are run, and below them the pictures that they save."""
    shown = []
    for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]:
        text = "".join(cell["source"])
        shown.append(text if cell["cell_type"] == "markdown" else f"```python run\n{text}\n```")
        pictures = PICTURE.findall(text) if cell["cell_type"] == "code" else []
        shown += [f"![{Path(name).stem}](notebook/{name})" for name in pictures]
    return "\n\n".join(shown) + "\n"
