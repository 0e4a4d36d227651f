"""Words that this project used for itself are not in it any more: a reader knows the field's terms and no others."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from conftest import ROOT

# The old word and the term in its place. Only words that have no other use here.
RETIRED = {
    "court": "consistency tests",
    "glimpse": "score statistic",
    "aboard": "inside, internal mass",
    "pliant": "non-stiff",
    "intake": "import",
    "twin": "finite-amplitude correction",
    "valley": "local minimum",
    "rooms": "modules, crates",
}
KINDS = (".rs", ".py", ".md", ".ftl", ".kt", ".swift", ".toml", ".html", ".css")
# What quotes them on purpose.
THIS = "python/tests/test_words.py"
BUILT = {"target", "build", "node_modules", "site-packages", "__pycache__"}


def written() -> Iterator[Path]:
    """The files that people read: what is built, and what is installed, is passed over."""
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in BUILT and not name.startswith(".")]
        yield from (Path(folder) / name for name in names if name.endswith(KINDS))


def test_no_retired_word_is_in_the_tree() -> None:
    # In names too: `court_dots`, `Glimpse`.
    words = re.compile(r"(?<![A-Za-z])(" + "|".join(RETIRED) + r")(?![a-z])", re.IGNORECASE)
    found = []
    for file in written():
        name = file.relative_to(ROOT).as_posix()
        if name == THIS:
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found += [f"{name}:{number}: {word} (now: {RETIRED[word.lower()]})" for word in words.findall(line)]
    assert found == []
