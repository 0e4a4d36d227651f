"""Words that this project used for itself are not in it any more: a reader knows the field's terms and no others."""

from __future__ import annotations

import re
import subprocess

import pytest
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


def tracked() -> list[str]:
    """The files of the repository that people read."""
    done = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.skip("this is no git repository")
    return [name for name in done.stdout.splitlines() if name.endswith(KINDS) and name != THIS]


def test_no_retired_word_is_in_the_tree() -> None:
    # In names too: `court_dots`, `Glimpse`.
    words = re.compile(r"(?<![A-Za-z])(" + "|".join(RETIRED) + r")(?![a-z])", re.IGNORECASE)
    found = []
    for name in tracked():
        file = ROOT / name
        if not file.is_file():
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found += [f"{name}:{number}: {word} (now: {RETIRED[word.lower()]})" for word in words.findall(line)]
    assert found == []
