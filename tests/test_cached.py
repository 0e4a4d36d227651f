"""The cache of compiled results: what must be a hit, and what must not."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CACHED = Path(__file__).with_name("cached.py")
# Notes each run in a file that is no input, and makes an output of its input.
COMPILE = "echo run >> runs; echo compiled; mkdir -p out; cat in/* > out/made"


class Clone:
    """A folder to compile in, with a cache beside it."""

    def __init__(self, root: Path, cache: Path) -> None:
        self.root, self.cache = root, cache

    def write(self, name: str, text: str) -> None:
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text)

    def run(self, *options: str, command: str = COMPILE, inputs: str = "in") -> subprocess.CompletedProcess:
        every = [CACHED, "step", "--input", inputs, "--output", "out", *options, "--", "bash", "-c", command]
        environment = {**os.environ, "GYRADIUS_CACHE": str(self.cache)}
        return subprocess.run([sys.executable, *every], cwd=self.root, env=environment, capture_output=True, text=True, check=False)

    def runs(self) -> int:
        runs = self.root / "runs"
        return len(runs.read_text().splitlines()) if runs.exists() else 0

    def entries(self) -> int:
        return len(list((self.cache / "step").glob("*"))) if (self.cache / "step").exists() else 0


@pytest.fixture
def clone(tmp_path: Path) -> Clone:
    made = Clone(tmp_path / "clone", tmp_path / "cache")
    made.write("in/a", "one\n")
    return made


def test_the_same_inputs_are_a_hit(clone):
    first = clone.run()
    assert (first.returncode, first.stdout, clone.runs()) == (0, "compiled\n", 1)
    shutil.rmtree(clone.root / "out")
    second = clone.run()
    assert (second.returncode, clone.runs()) == (0, 1)
    assert second.stdout.startswith("step: unchanged since ")
    assert second.stdout.endswith("\ncompiled\n")
    assert (clone.root / "out/made").read_text() == "one\n"


def test_time_stamps_do_not_count(clone):
    clone.run()
    os.utime(clone.root / "in/a", (0, 0))
    clone.run()
    assert clone.runs() == 1


def test_a_fresh_clone_in_another_folder_is_a_hit(clone, tmp_path):
    clone.run()
    other = Clone(tmp_path / "other", clone.cache)
    other.write("in/a", "one\n")
    assert "unchanged since" in other.run().stdout
    assert other.runs() == 0
    assert (other.root / "out/made").read_text() == "one\n"


@pytest.mark.parametrize(
    ("name", "text"), [("in/a", "two\n"), ("in/b", "one\n"), ("in/deep/c", "")], ids=["content", "file added", "folder added"]
)
def test_a_changed_input_is_a_miss(clone, name, text):
    clone.run()
    clone.write(name, text)
    clone.run(command=COMPILE.replace("cat in/*", "cat in/a"))
    assert clone.runs() == 2
    assert (clone.root / "out/made").read_text() == (clone.root / "in/a").read_text()


def test_a_renamed_input_is_a_miss(clone):
    clone.run()
    (clone.root / "in/a").rename(clone.root / "in/b")
    clone.run()
    assert clone.runs() == 2


def test_a_missing_input_that_appears_is_a_miss(clone):
    clone.run("--input", "settings")
    clone.run("--input", "settings")
    assert clone.runs() == 1
    clone.write("settings", "")
    clone.run("--input", "settings")
    assert clone.runs() == 2


def test_another_text_command_or_output_is_a_miss(clone):
    clone.run("--text", "compiler 1")
    clone.run("--text", "compiler 2")
    clone.run("--text", "compiler 2", command=f"{COMPILE}; true")
    clone.run("--text", "compiler 2", "--output", "runs", command=f"{COMPILE}; true")
    assert clone.entries() == 4


def test_folders_that_are_left_out_do_not_count(clone):
    clone.run("--without", "docs")
    clone.write("in/docs/page", "text")
    clone.run("--without", "docs", command=COMPILE)
    assert clone.runs() == 1


def test_a_former_result_comes_back(clone):
    clone.run()
    clone.write("in/a", "two\n")
    clone.run()
    clone.write("in/a", "one\n")
    clone.run()
    assert clone.runs() == 2
    assert (clone.root / "out/made").read_text() == "one\n"


def test_outputs_of_another_key_do_not_stay(clone):
    clone.run()
    clone.write("out/left", "from another key")
    clone.run()
    assert not (clone.root / "out/left").exists()


def test_a_failure_leaves_no_entry(clone):
    failed = clone.run(command=f"{COMPILE}; exit 3")
    assert (failed.returncode, failed.stdout, clone.entries()) == (3, "compiled\n", 0)
    clone.run(command=f"{COMPILE}; exit 3")
    assert clone.runs() == 2


def test_a_killed_command_is_a_failure(clone):
    assert clone.run(command="kill -9 $$").returncode == 128 + 9
    assert clone.entries() == 0


def test_a_skip_leaves_no_entry(clone):
    skipped = clone.run(command=f"{COMPILE}; echo 'skipped: no network'")
    assert skipped.returncode == 0
    assert "not cached: something was skipped" in skipped.stdout
    assert clone.entries() == 0


def test_an_output_that_is_not_made_leaves_no_entry(clone):
    assert "not cached" in clone.run(command="true").stdout
    assert clone.entries() == 0


def test_an_input_that_changes_meanwhile_leaves_no_entry(clone):
    assert "changed meanwhile" in clone.run(command=f"{COMPILE}; echo more >> in/a").stdout
    assert clone.entries() == 0


def test_a_file_that_was_read_must_be_an_input(clone):
    clone.write("in/b c", "three\n")
    clone.write("secret", "two\n")
    rule = "printf '%s: in/a %s/in/b\\\\ c /etc/passwd {}\\n\\nin/a:\\n' out/made \"$PWD\" > out/made.d"
    seen = clone.run("--depfile", "out/made.d", command=f"{COMPILE}; {rule.format('secret')}")
    assert "secret was read and is no input" in seen.stdout
    assert clone.entries() == 0
    clone.run("--depfile", "out/made.d", command=f"{COMPILE}; {rule.format('')}")
    assert clone.entries() == 1


def test_a_damaged_entry_is_a_miss(clone):
    clone.run()
    (packed,) = clone.cache.glob("step/*/outputs.tar")
    packed.write_bytes(packed.read_bytes()[:-1] + b"x")
    clone.run()
    assert clone.runs() == 2
    clone.run()
    assert clone.runs() == 2


def test_the_last_four_entries_used_are_kept(clone):
    texts = [f"{number}\n" for number in range(5)]
    for at, text in enumerate(texts):
        clone.write("in/a", text)
        clone.run()
        newest = max((clone.cache / "step").iterdir(), key=lambda one: one.stat().st_ctime_ns)
        os.utime(newest, (at + 1, at + 1))
    assert clone.entries() == 4
    clone.write("in/a", texts[0])
    clone.run()
    assert clone.runs() == 6
    clone.write("in/a", texts[4])
    clone.run()
    assert clone.runs() == 6


def test_without_a_command_it_is_an_error(clone):
    told = subprocess.run([sys.executable, CACHED, "step"], cwd=clone.root, capture_output=True, text=True, check=False)
    assert told.returncode == 2
