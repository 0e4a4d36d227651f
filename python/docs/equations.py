"""Equations: LaTeX in the pages becomes MathML, which browsers set without any script."""

from __future__ import annotations

import html
import re

from latex2mathml.converter import convert

BLOCK = re.compile(r'<div class="arithmatex">\s*\\\[(.*?)\\\]\s*</div>', re.DOTALL)
INLINE = re.compile(r'<span class="arithmatex">\\\((.*?)\\\)</span>', re.DOTALL)
TAG = re.compile(r"\\tag\{([^}]*)\}")


def set_equations(page: str) -> str:
    """The HTML of a page with its equations as MathML, their numbers at the right."""
    page = BLOCK.sub(lambda found: _block(html.unescape(found[1])), page)
    return INLINE.sub(lambda found: convert(html.unescape(found[1])), page)


def _block(latex: str) -> str:
    tag = TAG.search(latex)
    number = f'<span class="number">({html.escape(tag[1])})</span>' if tag else ""
    return f'<div class="equation"><div>{convert(TAG.sub("", latex).strip(), display="block")}</div>{number}</div>'
