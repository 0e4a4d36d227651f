#!/usr/bin/env python3
"""cached.py NAME [OPTION…] -- COMMAND…: runs a command, unless it succeeded before with the same key.

Then its outputs and its log are restored from the cache. The key is a SHA-256 over the command, the texts, and the path and content of
every input. Time stamps do not count: a fresh clone finds the results of an older one. All paths are relative to the
current folder.

  --input PATH      a file or folder that the command reads; where it is missing, that is part of the key
  --without FOLDER  a name of folders to leave out of the inputs
  --text TEXT       anything else that changes the result: the version of a tool, a variable of the environment
  --output PATH     a file or folder that the command makes; it is removed before
  --depfile FILE    a rule for make that the command writes: the files it has read

Nothing is kept if the command fails, prints a line that begins with "skipped", changes an input, or reads a file of the current
folder that is no input (as told by its depfiles).

The cache is $GYRADIUS_CACHE, or `gyradius-compiled` in the user's cache folder. It keeps the last four entries used of each NAME.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

KEPT = 4
SKIPPED = re.compile(r"^(skipped|skipping)\b", re.IGNORECASE | re.MULTILINE)
# Never inputs: Python writes them on its own.
NEVER = {"__pycache__"}


def user_cache() -> Path:
    """Where programs keep what they can make again."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def default_folder() -> Path:
    """Where the entries are."""
    return Path(os.environ.get("GYRADIUS_CACHE") or user_cache() / "gyradius-compiled")


@dataclass
class Step:
    """What is compiled, and everything that its result depends on."""

    name: str
    inputs: list[Path] = field(default_factory=list)
    without: set[str] = field(default_factory=set)
    texts: list[str] = field(default_factory=list)
    outputs: list[Path] = field(default_factory=list)
    depfiles: list[Path] = field(default_factory=list)


class Cache:
    """Results by key, for steps that work in one folder (`root`)."""

    def __init__(self, root: Path, folder: Path | None = None) -> None:
        self.root = root.resolve()
        self.folder = folder or default_folder()
        self._hashes: dict[tuple, str] = {}

    def run(self, step: Step, work: Callable[[], str]) -> None:
        """Has the outputs of a step, from the cache or by `work`, which returns its log."""
        manifest = self._manifest(step)
        if self._restore(step, key_of(manifest)):
            return
        for output in step.outputs:
            remove(self.root / output)
        log = work()
        reason = self._not_to_keep(step, manifest, log)
        if reason:
            print(f"{step.name}: not cached: {reason}", flush=True)
            return
        try:
            self._store(step, manifest, log)
        except OSError as error:
            print(f"{step.name}: not cached: {error}", flush=True)

    def _manifest(self, step: Step) -> list[str]:
        """Everything that the key is made of, in lines that a reader can compare."""
        lines = [f"name {step.name}", *(f"text {text}" for text in step.texts), *(f"output {one}" for one in step.outputs)]
        for one in [Path(__file__), *step.inputs]:
            lines += self._lines(self.root / one, step.without)
        return lines

    def _lines(self, path: Path, without: set[str]) -> Iterator[str]:
        if not path.exists():
            yield f"missing {self._label(path)}"
        for file in files_of(path, without | NEVER):
            yield f"input {self._label(file)} {self._hash(file)}"

    def _label(self, path: Path) -> str:
        """A path as it is in every clone."""
        if path == Path(__file__):
            return path.name
        return (path.relative_to(self.root) if path.is_relative_to(self.root) else path).as_posix()

    def _hash(self, file: Path) -> str:
        """Of a file's content. Large libraries are inputs of several steps: each is read once, as long as nobody writes to it."""
        state = file.stat()
        known = (file, state.st_ino, state.st_size, state.st_mtime_ns, state.st_ctime_ns)
        if known not in self._hashes:
            self._hashes[known] = hash_of(file)
        return self._hashes[known]

    def _not_to_keep(self, step: Step, manifest: list[str], log: str) -> str:
        """Why a result must not be taken for that of its key; empty where it may."""
        if SKIPPED.search(log):
            return "something was skipped"
        if self._manifest(step) != manifest:
            return "an input changed meanwhile"
        listed = {line.removeprefix("input ").rpartition(" ")[0] for line in manifest if line.startswith("input ")}
        for depfile in step.depfiles:
            unlisted = [one for one in self._read_by(self.root / depfile) if one not in listed]
            if unlisted:
                return f"{unlisted[0]} was read and is no input"
        return ""

    def _read_by(self, depfile: Path) -> Iterator[str]:
        """The files in `root` that a rule for make names."""
        rule = depfile.read_text(encoding="utf-8").replace("\\\n", " ")
        for one in re.findall(r"(?:\\ |\S)+", re.sub(r"^.*?:(\s|$)", " ", rule, flags=re.MULTILINE)):
            path = (self.root / one.replace("\\ ", " ")).resolve()
            if path.is_relative_to(self.root):
                yield self._label(path)

    def _entry(self, step: Step, key: str) -> Path:
        return self.folder / step.name / key

    def _restore(self, step: Step, key: str) -> bool:
        entry = self._entry(step, key)
        try:
            told = json.loads((entry / "entry.json").read_text(encoding="utf-8"))
            whole = hash_of(entry / "outputs.tar") == told["outputs"]
        except (OSError, ValueError, KeyError):
            return False
        if not whole:
            shutil.rmtree(entry, ignore_errors=True)
            return False
        for output in step.outputs:
            remove(self.root / output)
        with tarfile.open(entry / "outputs.tar") as packed:
            # Older Python has no filters; what is unpacked was packed here.
            packed.extractall(self.root, **({"filter": "data"} if hasattr(tarfile, "data_filter") else {}))
        os.utime(entry)
        print(f"{step.name}: unchanged since {told['made']}, key {key[:12]}", flush=True)
        print(told["log"], end="", flush=True)
        return True

    def _store(self, step: Step, manifest: list[str], log: str) -> None:
        entry = self._entry(step, key_of(manifest))
        entry.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".new-", dir=entry.parent) as folder:
            new = Path(folder, "entry")
            new.mkdir()
            with tarfile.open(new / "outputs.tar", "w") as packed:
                for output in step.outputs:
                    packed.add(self.root / output, output.as_posix())
            made = time.strftime("%Y-%m-%d %H:%M:%S")
            told = {"made": made, "log": log, "outputs": hash_of(new / "outputs.tar"), "manifest": manifest}
            (new / "entry.json").write_text(json.dumps(told, indent=0, ensure_ascii=False), encoding="utf-8")
            # Only a whole entry gets its name.
            remove(entry)
            new.rename(entry)
        self._prune(entry.parent)

    def _prune(self, entries: Path) -> None:
        """Keeps the last ones used, and what other processes may be writing."""
        by_use = sorted((one for one in entries.iterdir() if not one.name.startswith(".")), key=changed_at, reverse=True)
        left_behind = [one for one in entries.glob(".new-*") if changed_at(one) < time.time() - 86400]
        for one in by_use[KEPT:] + left_behind:
            shutil.rmtree(one, ignore_errors=True)


def files_of(path: Path, without: set[str]) -> list[Path]:
    """A file, or all files of a folder and its folders, in a fixed order."""
    if path.is_file():
        return [path]
    found = []
    for folder, names, files in os.walk(path):
        names[:] = [name for name in names if name not in without]
        found += [Path(folder, file) for file in files]
    return sorted(found)


def hash_of(file: Path) -> str:
    """SHA-256 of a file's content."""
    total = hashlib.sha256()
    with file.open("rb") as opened:
        while block := opened.read(1 << 20):
            total.update(block)
    return total.hexdigest()


def key_of(manifest: list[str]) -> str:
    return hashlib.sha256(json.dumps(manifest).encode()).hexdigest()


def changed_at(path: Path) -> float:
    """Zero for what another process has just removed."""
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0


def remove(path: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def logged(command: list[str], root: Path) -> str:
    """Runs a command, shows what it prints, and returns it. Its failure ends this program."""
    lines = []
    with subprocess.Popen(command, cwd=root, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace") as running:
        assert running.stdout is not None
        for line in running.stdout:
            print(line, end="", flush=True)
            lines.append(line)
    if running.returncode:
        sys.exit(running.returncode if running.returncode > 0 else 128 - running.returncode)
    return "".join(lines)


def main(arguments: list[str]) -> None:
    split = arguments.index("--") if "--" in arguments else len(arguments)
    command = arguments[split + 1 :]
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("name")
    for option, kind in [("input", Path), ("without", str), ("text", str), ("output", Path), ("depfile", Path)]:
        parser.add_argument(f"--{option}", action="append", default=[], type=kind)
    told = parser.parse_args(arguments[:split])
    if not command:
        parser.error("a command is missing, after --")
    texts = [*told.text, json.dumps(command)]
    step = Step(told.name, told.input, set(told.without), texts, told.output, told.depfile)
    Cache(Path.cwd()).run(step, lambda: logged(command, Path.cwd()))


if __name__ == "__main__":
    main(sys.argv[1:])
