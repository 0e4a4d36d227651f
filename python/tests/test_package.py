"""What is installed: the licence texts, and no dependency under a licence that the package may not ask for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

LICENCES = {"LICENSE-APACHE", "LICENSE-MIT"}
ROOT = Path(__file__).resolve().parents[2]


def test_the_licence_texts_are_installed_and_named() -> None:
    package = distribution("gyradius")
    assert package.metadata["License-Expression"] == "MIT OR Apache-2.0"
    assert set(package.metadata.get_all("License-File", [])) == LICENCES
    installed = {f.name: f for f in package.files or [] if f.parent.name == "licenses"}
    assert set(installed) == LICENCES
    for name, file in installed.items():
        # A link that was copied as a link, or as its target's name, is no licence text.
        assert file.read_text(encoding="utf-8") == (ROOT / name).read_text(encoding="utf-8")


def test_no_dependency_is_under_the_gpl_or_lgpl() -> None:
    found = {one.metadata["Name"]: licence_of(one) for one in needed_by("gyradius")}
    assert "reportlab" in found
    assert not {name: licence for name, licence in found.items() if re.search("GPL|GNU", licence)}


def needed_by(name: str) -> Iterator[Distribution]:
    """What a package needs to run here, and what that needs."""
    seen, waiting = {canonicalize_name(name)}, [name]
    while waiting:
        for requirement in map(Requirement, distribution(waiting.pop()).requires or []):
            key = canonicalize_name(requirement.name)
            if key in seen or (requirement.marker and not requirement.marker.evaluate({"extra": ""})):
                continue
            seen.add(key)
            waiting.append(key)
            yield distribution(key)


def licence_of(package: Distribution) -> str:
    """The licence that a package states; the whole text, which some state, may name others."""
    stated = [package.metadata["License-Expression"] or "", *package.metadata.get_all("Classifier", [])]
    first = (package.metadata["License"] or "").strip().splitlines()[:1]
    return " ".join([one for one in stated if not one.startswith("Programming")] + first)
