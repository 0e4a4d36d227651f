"""How the command writes files, shows foreign text, heeds Ctrl-C and ends."""

from __future__ import annotations

import errno
import io
import json
import os
import resource
import signal
import stat
import subprocess
import sys
import textwrap
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pypdf
import pytest
from conftest import TYPED, assert_refused, parsed, run, swing_csv
from typer.testing import CliRunner

import gyradius
from gyradius import cli, practise_screen, tasks
from gyradius.console import lookalike, output_console
from gyradius.files import only_writer, write_whole

KEELBOAT = gyradius.shipped_session("keelboat")
COMMAND = [sys.executable, "-m", "gyradius"]
INTERRUPTED = "gyradius: interrupted\n"
# Longer than any machine takes: what waits so long hangs.
PATIENCE_S = 60


def partials(folder: Path) -> list[str]:
    return [path.name for path in folder.iterdir() if "partial" in path.name]


# Files.


def limited(*args: str | Path, size: int) -> subprocess.CompletedProcess[str]:
    """The command where no file may grow beyond so many bytes, as on a disk that is nearly full."""

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    return subprocess.run(
        [*COMMAND, *map(str, args)], capture_output=True, text=True, timeout=300, check=False, preexec_fn=limit
    )


@pytest.mark.parametrize(
    ("args", "name"),
    [
        (["report", KEELBOAT, "--no-critique", "-o"], "old.html"),
        (["report", KEELBOAT, "--no-critique", "-o"], "old.pdf"),
        (["measure", KEELBOAT, "--json"], "old.json"),
        (["plan", KEELBOAT, "--replace", "-o"], "session.toml"),
        (["plan", KEELBOAT, "--replace", "--rig"], "rig.toml"),
    ],
)
def test_a_full_disk_leaves_the_old_file_whole_and_is_named(tmp_path: Path, args: list[str | Path], name: str) -> None:
    old = tmp_path / name
    old.write_text("old")
    assert_refused(limited(*args, old, size=500), 2, f"{old}: ")
    assert old.read_text() == "old"
    assert partials(tmp_path) == []


def test_a_full_disk_names_standard_output() -> None:
    with open("/dev/full", "w") as full:
        for args in (["routes"], ["measure", str(KEELBOAT), "--json", "-"]):
            done = subprocess.run([*COMMAND, *args], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            assert done.returncode == 2
            assert done.stderr == f"gyradius: standard output: {os.strerror(errno.ENOSPC)}\n"


def test_a_failure_at_the_last_moment_removes_the_partial_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    target = tmp_path / "r.json"
    target.write_text("old")
    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left") as caught:
        write_whole(target, "new")
    assert caught.value.filename == str(target)
    assert target.read_text() == "old"
    assert partials(tmp_path) == []


def test_permissions_are_those_of_a_file_that_is_opened(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        new, old = tmp_path / "new", tmp_path / "old"
        write_whole(new, "new")
        old.write_text("old")
        old.chmod(0o604)
        write_whole(old, "new")
    finally:
        os.umask(before)
    assert stat.S_IMODE(new.stat().st_mode) == 0o640
    assert stat.S_IMODE(old.stat().st_mode) == 0o604


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "there").mkdir()
    link, target = tmp_path / "link", tmp_path / "there" / "target"
    target.write_text("old")
    link.symlink_to(target)
    write_whole(link, "new")
    assert link.is_symlink()
    assert target.read_text() == "new"


def test_devices_and_named_pipes_are_written_directly(tmp_path: Path) -> None:
    null, pipe = Path(os.devnull), tmp_path / "pipe"
    write_whole(null, "new")
    assert null.is_char_device()
    os.mkfifo(pipe)
    read: list[str] = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()))
    reader.start()
    write_whole(pipe, "new")
    reader.join()
    assert read == ["new"]


def test_json_to_the_file_that_is_standard_output(tmp_path: Path) -> None:
    with open(tmp_path / "both", "w+") as both:
        command = [*COMMAND, "routes", "--json", "/dev/stdout"]
        assert subprocess.run(command, stdout=both, check=False).returncode == 0
        both.seek(0)
        text = both.read()
    data, end = json.JSONDecoder().raw_decode(text)
    assert len(data) >= 10
    assert "yaw_period" in text[end:], "the table follows the JSON in the same file"


def test_a_folder_is_refused_before_the_work(tmp_path: Path) -> None:
    refused = run("measure", KEELBOAT, "--json", tmp_path)
    assert_refused(refused, 2, f"{tmp_path}: ")
    assert not refused.stdout


# Two programs that write one folder.


def test_a_folder_that_another_program_writes_is_refused_untouched(tmp_path: Path) -> None:
    folder, rig = tmp_path / "boat", gyradius.shipped_rigs()["keelboat"]
    assert run("simulate", rig, "-o", folder, "--seed", "1").returncode == 0
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    with only_writer(folder):
        refused = run("simulate", rig, "-o", folder, "--seed", "2", "--replace")
        assert_refused(refused, 2, str(folder), "another program")
        csv = folder / "yaw-sway.csv"
        assert_refused(run("import", csv, "-o", folder, "--replace"), 2, str(folder), "another program")
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before
    assert json.loads((tmp_path / "boat.truth.json").read_text())["seed"] == 1
    assert run("simulate", rig, "-o", folder, "--seed", "2", "--replace").returncode == 0


def test_a_program_that_was_killed_bars_nobody(tmp_path: Path) -> None:
    code = """
        import sys, time
        from pathlib import Path
        from gyradius.files import only_writer
        with only_writer(Path(sys.argv[1])):
            print("here", flush=True)
            time.sleep(600)
    """
    command = [sys.executable, "-c", textwrap.dedent(code), str(tmp_path / "boat")]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"here\n"
        with pytest.raises(gyradius.InputError, match="another program"), only_writer(tmp_path / "boat"):
            pass
        holder.kill()
    with only_writer(tmp_path / "boat"):
        pass


# Text of a session.

MARKUP = TYPED.replace("typed in", "t[/red] :smile: \\u001b[31m").replace("table-1", "a[/b] [red]x[/red] :boom:")


def test_markup_in_a_session_is_shown_as_it_stands(folder: Callable[..., Path]) -> None:
    done = run("measure", folder(MARKUP))
    assert done.returncode == 0, done.stderr
    assert "a[/b] [red]x[/red] :boom:" in done.stdout
    assert "t[/red] :smile:" in done.stdout
    assert "\x1b" not in done.stdout


def test_no_part_of_a_session_is_markup_or_a_control_character() -> None:
    console = output_console()
    console.file = io.StringIO()
    console.print("[b]bold[/b] :smile: \x1b[2J\u202e", soft_wrap=True)
    assert console.file.getvalue() == "[b]bold[/b] :smile: \ufffd[2J\ufffd\n"


def test_markup_in_messages_and_while_the_work_runs(folder: Callable[..., Path]) -> None:
    assert_refused(run("measure", "[/b]:smile:"), 2, "[/b]:smile:")
    assert_refused(run("report", folder(MARKUP), "-o", "x", "--language", "[/b]"), 2, "[/b]")


# Terminals and pipes.


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "cp437"])
def test_any_encoding_is_readable(encoding: str, folder: Callable[..., Path]) -> None:
    session = folder(TYPED.replace("typed in", "Jürgens Böt — ψ 船"))
    environment = {**os.environ, "PYTHONIOENCODING": encoding, "COLUMNS": "200"}
    done = subprocess.run([*COMMAND, "measure", "-v", str(session)], capture_output=True, env=environment, check=False)
    assert done.returncode == 0, done.stderr
    text = done.stdout.decode(encoding)
    assert "typed in" not in text
    assert ("4.3910 +/- 0.0040" if encoding == "ascii" else "4.3910 ± 0.0040") in text
    assert ("Jurgens Bot - psi ?" if encoding == "ascii" else "Jürgens Böt - psi ?") in text
    bad = subprocess.run([*COMMAND, "measure", "—\udcff"], capture_output=True, env=environment, check=False)
    assert bad.returncode == 2
    assert bad.stderr.startswith(b"gyradius: -")


def test_json_on_standard_output_is_utf_8_in_any_encoding(folder: Callable[..., Path]) -> None:
    session = folder(TYPED.replace("typed in", "Jürgen"))
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = subprocess.run([*COMMAND, "measure", str(session), "--json", "-"], capture_output=True, env=environment)
    assert json.loads(done.stdout.decode("utf-8"))["title"] == "Jürgen"


@pytest.mark.parametrize(("character", "shown"), [("±", "+/-"), ("χ", "chi"), ("é", "e"), ("²", "2"), ("船", "?")])
def test_lookalikes(character: str, shown: str) -> None:
    assert lookalike(character) == shown


@pytest.mark.parametrize("args", [["measure", KEELBOAT], ["measure", KEELBOAT, "--json", "-"], ["--help"]])
def test_a_reader_that_goes_away_gets_the_status_of_success(args: list[str | Path]) -> None:
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run([*COMMAND, *map(str, args)], stdout=write, stderr=subprocess.PIPE, check=False)
    os.close(write)
    assert (done.returncode, done.stderr) == (0, b"")


def test_version() -> None:
    assert run("--version").stdout == f"gyradius {gyradius.__version__}\n"


# Ctrl-C, and failures of the core.


def heed_ctrl_c() -> None:
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def interrupted_when_told(code: str, *args: str | Path, cwd: Path) -> tuple[int, str]:
    """Status and standard error of a program that gets Ctrl-C when it says ``here``."""
    command = [sys.executable, "-c", textwrap.dedent(code), *map(str, args)]
    environment = {**os.environ, "PYTHONPATH": str(cwd)}
    with subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=cwd,
        env=environment,
        # What a shell runs in the background ignores Ctrl-C, and all that it starts.
        preexec_fn=heed_ctrl_c,
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "here\n"
        process.send_signal(signal.SIGINT)
        try:
            _, errors = process.communicate(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            raise
        return process.returncode, errors


SLOW = 'import time\nprint("here", flush=True)\ntime.sleep(600)\n'


@pytest.mark.parametrize("module", ["numpy", "typer", "rich", "matplotlib", "reportlab"])
def test_ctrl_c_while_a_library_loads(module: str, tmp_path: Path) -> None:
    # Some libraries make an ImportError of it.
    slow = SLOW.replace(
        "time.sleep(600)", "\ntry:\n    time.sleep(600)\nexcept BaseException:\n    raise ImportError\n"
    )
    (tmp_path / f"{module}.py").write_text(slow)
    code = "import runpy; runpy.run_module('gyradius', run_name='__main__', alter_sys=True)"
    args = ("report", KEELBOAT, "--no-critique", "-o", tmp_path / "r.pdf")
    assert interrupted_when_told(code, *args, cwd=tmp_path) == (130, INTERRUPTED)
    assert not (tmp_path / "r.pdf").exists()


def test_ctrl_c_while_the_core_works_and_hears_nothing(tmp_path: Path) -> None:
    code = """
        import signal, time
        from gyradius import tasks
        from gyradius.__main__ import main

        def deaf(*_, **__):
            signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
            print("here", flush=True)
            time.sleep(600)

        tasks.load = deaf
        main()
    """
    assert interrupted_when_told(code, "measure", KEELBOAT, cwd=tmp_path) == (130, INTERRUPTED)


class PanicException(BaseException):
    """As the core raises it."""


def test_a_panic_of_the_core_is_one_line_and_status_70(monkeypatch: pytest.MonkeyPatch) -> None:
    def panics(*_: object, **__: object) -> None:
        raise PanicException("index out of bounds")

    monkeypatch.setattr(tasks, "load", panics)
    done = CliRunner().invoke(cli.app, ["measure", "x", "--json", "-"])
    assert done.exit_code == 70
    assert done.stderr.count("\n") == 1
    assert "report it: the core failed: index out of bounds" in done.stderr
    assert json.loads(done.stdout)["error"]["kind"] == "internal"


# Sessions without a result.

UNNAMED = """\
format = "gyradius-session/1"
title = "unnamed"
[body]
mass = 100.0
[[swing]]
id = "s"
recording = "s.csv"
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = 2.0
spacing = 1.0
"""
SWAY_ALONE = TYPED.replace("yaw = { value = 4.391, u = 0.004 }, ", "")


def gyroscope_alone() -> str:
    return "\n".join(",".join(row.split(",")[:4]) for row in swing_csv().splitlines()) + "\n"


def test_a_session_whose_modes_cannot_be_named_has_status_1_and_its_modes(folder: Callable[..., Path]) -> None:
    done = run("measure", folder(UNNAMED, s_csv=gyroscope_alone()), "--json", "-")
    assert_refused(done, 1, "no mode of any swing could be named")
    data = parsed(done.stdout)
    assert data["quantities"] == {}
    assert data["swings"][0]["modes"]
    assert data["error"] == {
        "kind": "no_result",
        "message": done.stderr.removeprefix("gyradius: ").strip(),
        "file": None,
        "line": None,
    }


def test_a_session_that_determines_nothing_has_status_1(folder: Callable[..., Path], tmp_path: Path) -> None:
    session, report = folder(SWAY_ALONE), tmp_path / "r.html"
    assert_refused(run("measure", session), 1, "determine no quantity")
    assert_refused(run("report", session, "-o", report, "--no-critique"), 1, "determine no quantity")
    assert report.exists()


def test_a_bare_recording_gives_its_modes_and_status_0(tmp_path: Path) -> None:
    recording = tmp_path / "r.csv"
    recording.write_text(swing_csv())
    done = run("measure", recording, "--json", "-")
    assert done.returncode == 0, done.stderr
    assert "error" not in parsed(done.stdout)


# What is said must be so.


def test_the_json_that_a_pdf_speaks_of_is_in_it(tmp_path: Path) -> None:
    report = tmp_path / "r.pdf"
    assert run("report", KEELBOAT, "--no-critique", "-o", report).returncode == 0
    pdf = pypdf.PdfReader(report)
    assert "as JSON" in "".join(page.extract_text() for page in pdf.pages)
    assert list(pdf.attachments) == ["gyradius-measurement.json"]
    (content,) = pdf.attachments["gyradius-measurement.json"]
    assert json.loads(content)["quantities"] == json.loads(gyradius.load(KEELBOAT).measure().to_json())["quantities"]


def test_a_criticism_that_is_not_made_is_not_announced(capsys: pytest.CaptureFixture[str]) -> None:
    phases = ["measure", "critique", "done"]

    def state() -> dict[str, object]:
        return {
            "phase": phases[0],
            "work": phases[0] if phases[0] == "critique" else None,
            "instruction": {"english": f"now: {phases[0]}"},
            "judgement": None,
        }

    class Procedure:
        state = property(lambda _: state())
        handle = staticmethod(lambda _event: phases.pop(0))
        by_the_book = staticmethod(lambda: {"event": "go on"})

    practise_screen.play(output_console(), Procedure(), speed=None, auto=True, critique=False)  # type: ignore[arg-type]
    assert capsys.readouterr().out == "now: measure\n"


# The package.


def test_the_package_loads_nothing_before_it_is_used() -> None:
    code = "import sys, gyradius; sys.exit(any(name in sys.modules for name in ('numpy', 'gyradius._core', 'signal')))"
    assert subprocess.run([sys.executable, "-S", "-c", code], env=_with_package(), check=False).returncode == 0


def _with_package() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(Path(gyradius.__file__).parents[1])}


def test_every_public_name_is_there_and_no_other() -> None:
    assert all(getattr(gyradius, name) is not None for name in gyradius.__all__)
    assert set(gyradius.__all__) <= set(dir(gyradius))
    with pytest.raises(AttributeError, match="nothing_of_ours"):
        _ = gyradius.nothing_of_ours  # type: ignore[attr-defined]


def test_the_online_estimator_may_be_fed_by_several_threads() -> None:
    live = gyradius.Live()
    failures: list[BaseException] = []

    def repeated(call: Callable[[int], object]) -> Callable[[], None]:
        def work() -> None:
            try:
                for block in range(40):
                    call(block)
            except BaseException as error:
                failures.append(error)

        return work

    def samples(block: int) -> tuple[np.ndarray, np.ndarray]:
        return np.arange(2000 * block, 2000 * (block + 1)) * 10_000_000, np.full((2000, 3), 0.01)

    calls = [
        repeated(lambda block: live.push_gyroscope(*samples(block))),
        repeated(lambda block: live.push_accelerometer(*samples(block))),
        repeated(lambda _: live.estimate),
        repeated(lambda _: live.advice),
    ]
    threads = [threading.Thread(target=call) for call in calls]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert failures == []
