"""The version catalog, as Gradle reads it."""

from __future__ import annotations

from pathlib import Path

try:
    import tomllib
except ModuleNotFoundError:  # Python 3.10
    import tomli as tomllib

ANDROID = Path(__file__).resolve().parent.parent


class Catalog:
    """`gradle/libs.versions.toml`."""

    def __init__(self) -> None:
        text = tomllib.loads((ANDROID / "gradle/libs.versions.toml").read_text(encoding="utf-8"))
        self.versions: dict[str, str] = text["versions"]
        self._libraries: dict[str, dict] = text["libraries"]
        self._bundles: dict[str, list[str]] = text["bundles"]

    def library(self, name: str) -> tuple[tuple[str, str], str]:
        """Module and version; the version is empty where the platform (BOM) gives it."""
        one = self._libraries[name]
        group, module = one["module"].split(":")
        return (group, module), self.versions.get(one.get("version", {}).get("ref", ""), "")

    def bundle(self, name: str) -> list[tuple[tuple[str, str], str]]:
        """All libraries of a bundle."""
        return [self.library(one) for one in self._bundles[name]]
