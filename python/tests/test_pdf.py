"""The report on paper."""

from __future__ import annotations

from pathlib import Path

from reportlab.lib.fonts import tt2ps

from gyradius.pdf import BOLD, FONT, write_pdf

DRAWING = """<figure><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 20" font-family="system-ui">
<text x="0" y="12">drawn</text></svg></figure>"""


def test_a_drawing_does_not_cost_the_bold_letters_after_it(tmp_path: Path) -> None:
    write_pdf(f"<html><body><h2>before</h2>{DRAWING}<h2>after</h2></body></html>", tmp_path / "r.pdf")
    assert tt2ps(FONT, 1, 0) == BOLD
