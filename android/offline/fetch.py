"""Files from Maven Central by the ordinary Maven client, kept in Maven's layout outside of the tree."""

from __future__ import annotations

import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape

USER = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
CACHE = Path(os.environ.get("GYRADIUS_ANDROID_CACHE") or USER / "gyradius-android")
REPOSITORY = CACHE / "repository"
# A read that stands still for this long is given up and tried again, ms.
PATIENCE = ["-Dmaven.wagon.rto=30000", "-Daether.connector.requestTimeout=30000"]
COPY = "org.apache.maven.plugins:maven-dependency-plugin:3.8.1:copy"


@dataclass(frozen=True, order=True)
class Artifact:
    """One file of one version of a module."""

    group: str
    name: str
    version: str
    kind: str = "jar"
    classifier: str = ""

    def path(self) -> Path:
        """Where it is kept."""
        tail = f"-{self.classifier}" if self.classifier else ""
        folder = REPOSITORY / self.group.replace(".", "/") / self.name / self.version
        return folder / f"{self.name}-{self.version}{tail}.{self.kind}"

    def xml(self) -> str:
        """As an item of the dependency plugin."""
        fields = {"groupId": self.group, "artifactId": self.name, "version": self.version, "type": self.kind}
        fields["outputDirectory"] = str(self.path().parent)
        if self.classifier:
            fields["classifier"] = self.classifier
        inner = "".join(f"<{key}>{escape(value)}</{key}>" for key, value in fields.items())
        return f"<artifactItem>{inner}</artifactItem>"


def fetch(artifacts: list[Artifact]) -> None:
    """Has every file in the cache; one run of Maven for all that are missing."""
    missing = sorted({one for one in artifacts if not one.path().exists()})
    if not missing:
        return
    print(f"fetching {len(missing)} files, {missing[0].name} first", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        pom = Path(folder, "pom.xml")
        pom.write_text(_pom(missing), encoding="utf-8")
        subprocess.run(["mvn", "--batch-mode", "--quiet", "-Dstyle.color=never", "--no-transfer-progress", *PATIENCE, "--file", str(pom), COPY], check=True)


def _pom(items: list[Artifact]) -> str:
    listed = "".join(one.xml() for one in items)
    plugin = "<artifactId>maven-dependency-plugin</artifactId><version>3.8.1</version>"
    configuration = f"<artifactItems>{listed}</artifactItems>"
    return (
        '<project xmlns="http://maven.apache.org/POM/4.0.0"><modelVersion>4.0.0</modelVersion>'
        "<groupId>local</groupId><artifactId>fetch</artifactId><version>1</version><packaging>pom</packaging>"
        f"<build><plugins><plugin>{plugin}<configuration>{configuration}</configuration></plugin></plugins></build>"
        "</project>"
    )
