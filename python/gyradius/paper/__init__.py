"""The paper that the method rests on, recomputed: its tables and figures, printed numbers beside computed ones.

P. F. Hinrichsen, "Bifilar suspension measurement of boat inertia parameters", Journal of Sailboat Technology 2014-01.
The core computes; this subpackage holds the printed numbers, compares and draws.
"""

from __future__ import annotations

from .checks import Check, Computed
from .contents import recompute
from .parts import Paper, PaperFigure, PaperTable
from .print_data import Erratum, Printed, errata, printed
from .writing import FORMAT, PAGE, paper_json, write_files, write_paper

__all__ = [
    "FORMAT",
    "PAGE",
    "Check",
    "Computed",
    "Erratum",
    "Paper",
    "PaperFigure",
    "PaperTable",
    "Printed",
    "errata",
    "paper_json",
    "printed",
    "recompute",
    "write_files",
    "write_paper",
]
