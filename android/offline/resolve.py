"""From the libraries of the catalog to every file that they need: the highest version of each module wins.

Modules that Gradle published say in their `.module` file which other module holds the code for Android (`ui` → `ui-android`);
a POM does not. Of the others the POM is read.
"""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field

from fetch import Artifact, fetch

Module = tuple[str, str]
MARK = "published-with-gradle-metadata"
# What a variant must be; first come, first served among those that fit.
PLATFORMS = {"android": ("androidJvm", "jvm", None), "jvm": ("jvm", "androidJvm", None)}


@dataclass
class Node:
    """What one version of a module needs and holds."""

    needs: list[tuple[Module, str]] = field(default_factory=list)
    floors: list[tuple[Module, str]] = field(default_factory=list)
    files: list[Artifact] = field(default_factory=list)


class Resolver:
    """Versions chosen so far, and what was read of them."""

    def __init__(self, platform: str, prefer_aar: frozenset[Module] = frozenset()) -> None:
        self.platform = platform
        self.prefer_aar = prefer_aar
        self.chosen: dict[Module, str] = {}
        self.floors: dict[Module, str] = {}
        self.nodes: dict[tuple[Module, str], Node] = {}

    def resolve(self, roots: list[tuple[Module, str]]) -> list[Artifact]:
        """Files of all that the roots need, each module in its highest version."""
        while True:
            reached = self._reach(roots)
            missing = [one for one in reached if one not in self.nodes]
            if not missing:
                break
            self.nodes.update(self._read(missing))
        files = sorted({file for one in reached for file in self.nodes[one].files})
        fetch(files)
        return files

    def _reach(self, roots: list[tuple[Module, str]]) -> list[tuple[Module, str]]:
        """Everything that the roots lead to through what was read, in the versions that win."""
        while True:
            before = dict(self.chosen)
            seen = self._walk(roots)
            if self.chosen == before:
                return seen

    def _walk(self, roots: list[tuple[Module, str]]) -> list[tuple[Module, str]]:
        todo, seen = list(roots), {}
        while todo:
            module, version = todo.pop(0)
            self._raise(module, version)
            if module in seen or module not in self.chosen:
                continue
            seen[module] = self.chosen[module]
            node = self.nodes.get((module, self.chosen[module]), Node())
            for other, floor in node.floors:
                self._raise(other, floor)
            todo += node.needs
        return [(module, self.chosen[module]) for module in seen]

    def _raise(self, module: Module, version: str) -> None:
        known = self.chosen.get(module)
        if version and (known is None or order(version) > order(known)):
            self.chosen[module] = version

    def _read(self, wanted: list[tuple[Module, str]]) -> dict[tuple[Module, str], Node]:
        poms = {one: pom_of(*one) for one in wanted}
        fetch(list(poms.values()))
        gradle = {one: of for one, of in poms.items() if MARK in of.path().read_text(encoding="utf-8")}
        fetch([of_kind(pom, "module") for pom in gradle.values()])
        fetch_parents([pom for one, pom in poms.items() if one not in gradle])
        return {
            one: self._gradle_node(of_kind(pom, "module")) if one in gradle else self._pom_node(pom)
            for one, pom in poms.items()
        }

    def _gradle_node(self, file: Artifact) -> Node:
        text = json.loads(file.path().read_text(encoding="utf-8"))
        variants = text["variants"]
        code = choose(variants, self.platform, "library")
        node = Node()
        for variant in [code] if code else [v for v in variants if category(v) == "platform"]:
            node.needs += [needed(one) for one in variant.get("dependencies", []) if category(one) in ("library", "platform")]
            node.floors += [needed(one) for one in variant.get("dependencyConstraints", [])]
            if "available-at" in variant:
                there = variant["available-at"]
                node.needs.append(((there["group"], there["module"]), there["version"]))
            node.files += [file_of(file, one["name"]) for one in variant.get("files", [])]
        return node

    def _pom_node(self, file: Artifact) -> Node:
        pom = Pom(file)
        kind = {"bundle": "jar", "pom": "", "maven-plugin": "jar"}.get(pom.packaging, pom.packaging)
        if (file.group, file.name) in self.prefer_aar:
            kind = "aar"
        # A platform (BOM) says which versions go together.
        floors = list(pom.managed.items()) if pom.packaging == "pom" else []
        return Node(pom.needs(), floors, [of_kind(file, kind)] if kind else [])


def category(one: dict) -> str:
    """Whether a variant or dependency is a library, a platform or documentation."""
    return one.get("attributes", {}).get("org.gradle.category", "library")


def choose(variants: list[dict], platform: str, kind: str) -> dict | None:
    """The variant to run with on a platform."""
    runtime = [
        one for one in variants
        if category(one) == kind and one["attributes"].get("org.gradle.usage") == "java-runtime"
    ]
    for wanted in PLATFORMS[platform]:
        for one in runtime:
            if one["attributes"].get("org.jetbrains.kotlin.platform.type") == wanted and fits(one, platform):
                return one
    return next((one for one in runtime if fits(one, platform)), None)


def fits(variant: dict, platform: str) -> bool:
    """Guava has one for each kind of virtual machine."""
    wanted = {"android": "android", "jvm": "standard-jvm"}[platform]
    return variant["attributes"].get("org.gradle.jvm.environment", wanted) in (wanted, "standard-jvm")


def needed(one: dict) -> tuple[Module, str]:
    """Module and version of a dependency."""
    version = one.get("version", {})
    return (one["group"], one["module"]), version.get("strictly") or version.get("requires") or ""


def file_of(module: Artifact, name: str) -> Artifact:
    """A file that a variant names; where its name is not that of the module, by its ending."""
    kind = name.rsplit(".", 1)[-1]
    return of_kind(module, kind)


def of_kind(one: Artifact, kind: str) -> Artifact:
    """Another file of the same version."""
    return Artifact(one.group, one.name, one.version, kind)


def pom_of(module: Module, version: str) -> Artifact:
    """The POM."""
    return Artifact(*module, version, "pom")


def fetch_parents(poms: list[Artifact]) -> None:
    """Fetches parents of POMs, and theirs."""
    while poms:
        parents = [parent for parent in (Pom.parent_of(one) for one in poms) if parent]
        fetch(parents)
        poms = parents


class Pom:
    """A POM with what it has from its parents."""

    def __init__(self, file: Artifact) -> None:
        parent = self.parent_of(file)
        above = Pom(parent) if parent else None
        root = read_xml(file)
        self.packaging = root.findtext("packaging", "jar")
        self.properties = {**(above.properties if above else {}), **texts(root.find("properties"))}
        if parent:
            self.properties |= {"project.parent.version": parent.version}
        self.properties |= {"project.version": file.version, "project.groupId": file.group, "version": file.version}
        self.managed = {**(above.managed if above else {}), **self._managed(root)}
        self.scopes = {**(above.scopes if above else {}), **self._managed(root, "scope")}
        self.own = [texts(one) for one in root.findall("dependencies/dependency")]
        self.own += above.own if above else []

    @staticmethod
    def parent_of(file: Artifact) -> Artifact | None:
        """The POM above."""
        parent = texts(read_xml(file).find("parent"))
        return Artifact(parent["groupId"], parent["artifactId"], parent["version"], "pom") if parent else None

    def _managed(self, root: ET.Element, what: str = "version") -> dict[Module, str]:
        listed = [texts(one) for one in root.findall("dependencyManagement/dependencies/dependency")]
        return {
            (self._fill(one["groupId"]), self._fill(one["artifactId"])): self._fill(one[what])
            for one in listed if what in one
        }

    def _fill(self, text: str) -> str:
        for _ in range(5):
            text = re.sub(r"\$\{([^}]+)\}", lambda m: self.properties.get(m[1], m[0]), text)
        return text

    def needs(self) -> list[tuple[Module, str]]:
        """What is needed to run."""
        found = []
        for one in self.own:
            module = (self._fill(one["groupId"]), self._fill(one["artifactId"]))
            scope = one.get("scope") or self.scopes.get(module, "compile")
            if scope in ("compile", "runtime") and one.get("optional") != "true":
                version = self._fill(one.get("version") or self.managed.get(module, ""))
                found.append((module, version.strip("[]").split(",")[0]))
        return found


def texts(element: ET.Element | None) -> dict[str, str]:
    """Texts of the children by name."""
    return {} if element is None else {one.tag: (one.text or "").strip() for one in element}


def read_xml(file: Artifact) -> ET.Element:
    """The root, names without their namespace."""
    root = ET.fromstring(file.path().read_bytes())
    for one in root.iter():
        if isinstance(one.tag, str):
            one.tag = one.tag.rsplit("}", 1)[-1]
    return root


def order(version: str) -> tuple:
    """For comparison: numbers by size, `alpha` and `rc` before the release."""
    parts = re.findall(r"\d+|[a-z]+", version.lower())
    weight = {"dev": -5, "alpha": -4, "beta": -3, "m": -2, "rc": -1}
    ranked = [(1, int(one)) if one.isdigit() else (0, weight.get(one, 0)) for one in parts]
    return tuple(ranked + [(0, 0.5)])
