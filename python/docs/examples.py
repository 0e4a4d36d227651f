"""Examples: what the pages show of commands and of Python is run while the site is built, and its output shown.

A fenced block may say after its language, on one line:

- ``console run``: each command after ``$`` is run, in one folder for each page; the output follows the commands.
  ``part=0`` shows the output up to its first table only, ``part=2`` its second table. ``quiet`` shows none.
- ``text part=2``: that part of the output of the last command, without the command.
- ``toml append=FILE``: the text is put at the end of a file in that folder.
- ``python run``: the code is run; what it prints follows it. The blocks of a page share their names.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
# What a page finds in the folder that its commands run in.
GIVEN = ("first-session.toml", "phyphox_export.py")
FENCE = re.compile(r"^```(?P<language>\w+)(?P<options>(?: +[\w.-]+(?:=\S+)?)+)\n(?P<text>.*?)^```$", re.M | re.S)
# A command, which goes on after a backslash at a line's end.
COMMAND = re.compile(r"^\$ (?:.*\\\n)*.*$", re.M)
# A table's title: text at the margin, and an empty line below it.
TITLE = re.compile(r"^[A-Z][^\n]*\n\s*\n", re.M)
COLUMNS = 84
SECONDS = 300


class ExampleError(Exception):
    """An example that does not run."""


@dataclass
class Examples:
    """The examples of one page, run in ``folder`` in the order of the page."""

    page: str
    folder: Path
    output: str = ""
    names: dict[str, object] = field(default_factory=dict)

    def fill(self, text: str) -> str:
        """The text of the page with the output of its examples."""
        for name in GIVEN:
            shutil.copy(HERE / name, self.folder / name)
        return FENCE.sub(self._block, text)

    def _block(self, found: re.Match[str]) -> str:
        language, text = found["language"], found["text"]
        words = found["options"].split()
        options = dict(word.partition("=")[::2] for word in words)
        if language == "console" and "run" in options:
            return self._commands(text, options)
        if language == "python" and "run" in options:
            return self._code(text)
        if language == "toml" and "append" in options:
            with (self.folder / options["append"]).open("a", encoding="utf-8") as file:
                file.write("\n" + text)
            return _fenced("toml", text)
        if language == "text" and "part" in options:
            return _fenced("text", part(self.output, options["part"]))
        return found[0]

    def _commands(self, text: str, options: dict[str, str]) -> str:
        shown = []
        for command in COMMAND.findall(text):
            self.output = self._run(command[2:].replace("\\\n", " "))
            shown.append(command)
            if "quiet" not in options:
                shown.append(part(self.output, options.get("part")).rstrip("\n"))
        return _fenced("console", "\n".join(filter(None, shown)) + "\n")

    def _run(self, command: str) -> str:
        words = shlex.split(command, comments=True)
        program = {"gyradius": [sys.executable, "-m", "gyradius"], "python": [sys.executable]}.get(words[0])
        if program is None:
            raise ExampleError(f"{self.page}: `{command}`: gyradius or python was expected")
        search = os.pathsep.join(filter(None, (str(HERE.parent), os.environ.get("PYTHONPATH"))))
        surroundings = {**os.environ, "COLUMNS": str(COLUMNS), "PYTHONIOENCODING": "utf-8", "PYTHONPATH": search}
        done = subprocess.run(
            [*program, *words[1:]],
            cwd=self.folder,
            env=surroundings,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            timeout=SECONDS,
            check=False,
        )
        if done.returncode != 0:
            raise ExampleError(f"{self.page}: `{command}` ended with {done.returncode}:\n{done.stdout}")
        return "\n".join(fold(line.rstrip()) for line in done.stdout.splitlines())

    def _code(self, text: str) -> str:
        printed = io.StringIO()
        before = Path.cwd()
        os.chdir(self.folder)
        try:
            with contextlib.redirect_stdout(printed):
                exec(compile(text, self.page, "exec"), self.names)
        except Exception as error:
            raise ExampleError(f"{self.page}: {error!r} in\n{text}") from error
        finally:
            os.chdir(before)
        shown = _fenced("python", text)
        return f"{shown}\n{_fenced('text', printed.getvalue())}" if printed.getvalue() else shown


def fold(line: str) -> str:
    """A line as a narrow terminal shows it; what it holds between spaces is left whole."""
    if len(line) <= COLUMNS:
        return line
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    return textwrap.fill(line, COLUMNS, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def part(output: str, wanted: str | None) -> str:
    """One part of a command's output: 0 is what stands before its first table."""
    if wanted is None:
        return output
    starts = [0, *(found.start() for found in TITLE.finditer(output)), len(output)]
    number = int(wanted)
    if not number < len(starts) - 1:
        raise ExampleError(f"part {number} was expected in {len(starts) - 1} parts of\n{output}")
    return output[starts[number] : starts[number + 1]].strip("\n") + "\n"


def _fenced(language: str, text: str) -> str:
    return f"```{language}\n{text}```"
