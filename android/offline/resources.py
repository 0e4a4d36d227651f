"""Manifest, resources and R classes, by the manifest merger and aapt2."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

from fetch import Artifact


class Resources:
    """Makes `AndroidManifest.xml`, `resources.apk`, `R.txt` and `r-classes` in a folder."""

    def __init__(
        self, out: Path, package: str, aapt2: Path, framework: Path, merger: list[Artifact], versions: dict[str, str]
    ) -> None:
        self.out = out
        self.package = package
        self.aapt2 = aapt2
        self.framework = framework
        self.merger = merger
        self.versions = versions

    def link(self, main: Path, aars: list[Path], assets: list[Path]) -> None:
        """Does all of it."""
        compiled = [zipped for zipped in (self._compiled(one) for one in aars) if zipped]
        own = self.out / "res.zip"
        self._run([str(self.aapt2), "compile", "--dir", str(main / "res"), "-o", str(own)])
        self._merge(main / "AndroidManifest.xml", [one / "AndroidManifest.xml" for one in aars])
        self._copy_assets(assets)
        self._link([*compiled, own], aars)
        self._compile_r()

    def _compiled(self, aar: Path) -> Path | None:
        """An AAR's resources, compiled once by each version of aapt2."""
        zipped = aar / f"compiled-by-{self.aapt2.name}.zip"
        if not (aar / "res").exists() or not any((aar / "res").iterdir()):
            return None
        if not zipped.exists():
            partly = aar / "partly.zip"
            self._run([str(self.aapt2), "compile", "--dir", str(aar / "res"), "-o", str(partly)])
            partly.rename(zipped)
        return zipped

    def _merge(self, main: Path, libraries: list[Path]) -> None:
        stated = self.out / "stated-manifest.xml"
        text = main.read_text(encoding="utf-8").replace("<manifest ", f'<manifest package="{self.package}" ', 1)
        stated.write_text(text, encoding="utf-8")
        command = ["java", "-cp", os.pathsep.join(str(one.path()) for one in self.merger), "com.android.manifmerger.Merger"]
        command += ["--main", str(stated), "--libs", os.pathsep.join(map(str, libraries))]
        for name, value in self._properties().items():
            command += ["--property", f"{name}={value}"]
        command += ["--out", str(self.out / "AndroidManifest.xml")]
        self._run(command)

    def _properties(self) -> dict[str, str]:
        sdk = {"MIN_SDK_VERSION": self.versions["minSdk"], "TARGET_SDK_VERSION": self.versions["targetSdk"]}
        own = {"VERSION_NAME": self.versions["appVersion"], "VERSION_CODE": self.versions["appCode"]}
        return {"PACKAGE": self.package, **sdk, **own}

    def _copy_assets(self, folders: list[Path]) -> None:
        assets = self.out / "assets"
        shutil.rmtree(assets, ignore_errors=True)
        for folder in folders:
            shutil.copytree(folder, assets, dirs_exist_ok=True)

    def _link(self, compiled: list[Path], aars: list[Path]) -> None:
        packages = sorted({ET.parse(one / "AndroidManifest.xml").getroot().get("package", "") for one in aars} - {""})
        java = self.out / "r"
        shutil.rmtree(java, ignore_errors=True)
        command = [str(self.aapt2), "link", "-o", str(self.out / "resources.apk"), "-I", str(self.framework)]
        command += ["--manifest", str(self.out / "AndroidManifest.xml"), "--auto-add-overlay", "--no-version-vectors"]
        command += ["--java", str(java), "--extra-packages", ":".join(packages), "-A", str(self.out / "assets")]
        command += ["--output-text-symbols", str(self.out / "R.txt")]
        for one in compiled:
            command += ["-R", str(one)]
        self._run(command)

    def _compile_r(self) -> None:
        classes = self.out / "r-classes"
        shutil.rmtree(classes, ignore_errors=True)
        files = sorted(str(one) for one in (self.out / "r").rglob("*.java"))
        self._run(["javac", "-nowarn", "-source", "11", "-target", "11", "-d", str(classes), *files])

    def _run(self, command: list[str]) -> None:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            sys.exit(f"{Path(command[0]).name} failed with {done.returncode}:\n{done.stdout}{done.stderr}")
