"""The command ``gyradius paper``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .arguments import Json
from .console import error_console, output_console
from .outcome import reported, write_json
from .progress import counted

# The format of its JSON, known before the paper is loaded, which takes a while.
PAPER = "gyradius-paper/1"


def paper(
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="Folder for the page, the figures and the tables.")
    ] = Path("gyradius-paper"),
    json: Json = None,
) -> None:
    """Recompute the tables and figures of the paper, printed numbers beside computed ones."""
    with reported(error_console(), json, PAPER):
        # Its figures need matplotlib, which no other command waits for.
        from .paper import PAGE, paper_json, write_paper
        from .paper.rows import summary

        with counted(error_console(), "recomputing the paper") as told:
            found = write_paper(output, told)
        if json is not None:
            write_json(paper_json(found), json)
        console = output_console(json)
        for sentence in summary(found):
            console.print(sentence, soft_wrap=True)
        console.print(f"Page: {output / PAGE}", soft_wrap=True)
