"""Files that are written whole: beside their place, then renamed into it."""

from __future__ import annotations

import errno
import os
import secrets
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from ._core import InputError

# Owner, group and all; the umask takes from it, as from any file that is made.
NEW_FILE = 0o666
STANDARD_OUTPUTS = (1, 2)


def can_be_written(target: Path) -> None:
    """Refuse at once what could not be written after minutes of work: no such folder, a folder, a protected file."""
    if not target.parent.is_dir():
        raise _error(errno.ENOENT, target)
    if target.is_dir():
        raise _error(errno.EISDIR, target)
    if target.exists() and not os.access(target, os.W_OK):
        raise _error(errno.EACCES, target)


def write_whole(target: Path, content: str | bytes) -> None:
    """Write a file so that its place holds the old one or the new one, never a part; errors name the file.

    A device, a named pipe and what is standard output already are written directly, a link's file in its own place.
    """
    block = content.encode("utf-8", "replace") if isinstance(content, str) else content
    can_be_written(target)
    try:
        _write(target, block)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(target)) from None


def _write(target: Path, block: bytes) -> None:
    there = target.stat() if target.exists() else None
    for stream in STANDARD_OUTPUTS:
        if there is not None and _is_open(stream, there):
            _flush()
            with open(stream, "wb", closefd=False) as out:
                out.write(block)
            return
    if there is not None and not stat.S_ISREG(there.st_mode):
        _write_directly(target, block)
        return
    place = Path(os.path.realpath(target))
    try:
        partial = _partial(place)
    except PermissionError:
        # The file may be written and its folder may not.
        if there is None:
            raise
        _write_directly(target, block)
        return
    with _removed_on_failure(partial):
        with open(partial, "wb", opener=lambda path, _: os.open(path, os.O_WRONLY)) as out:
            out.write(block)
            out.flush()
            os.fsync(out.fileno())
        if there is not None:
            partial.chmod(stat.S_IMODE(there.st_mode))
        os.replace(partial, place)


def _partial(place: Path) -> Path:
    """A new, empty file in the same folder, under a name that no other program has."""
    while True:
        partial = place.with_name(f".gyradius-{secrets.token_hex(8)}.partial")
        with suppress(FileExistsError):
            os.close(os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL, NEW_FILE))
            return partial


@contextmanager
def _removed_on_failure(partial: Path) -> Iterator[None]:
    try:
        yield
    except BaseException:
        partial.unlink(missing_ok=True)
        raise


def _write_directly(target: Path, block: bytes) -> None:
    with open(target, "wb") as out:
        out.write(block)


def _is_open(stream: int, there: os.stat_result) -> bool:
    """Whether a file is a standard stream: writing it anew would lose what is printed before or after."""
    try:
        return os.path.samestat(os.fstat(stream), there)
    except OSError:
        return False


def _flush() -> None:
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.flush()


def _error(number: int, target: Path) -> OSError:
    return OSError(number, os.strerror(number), str(target))


@contextmanager
def only_writer(folder: Path) -> Iterator[None]:
    """Make a folder and keep other programs from writing a session there; one that is at it already is not disturbed.

    The lock is the operating system's: it ends with the program, however that ends.
    """
    is_new = not folder.exists()
    lock = _locked(folder)
    try:
        yield
    finally:
        if is_new:
            # A folder in which nothing came to be.
            with suppress(OSError):
                folder.rmdir()
        os.close(lock)


def _locked(folder: Path) -> int:
    while True:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            lock = _lock(folder)
        except FileExistsError:
            raise _error(errno.ENOTDIR, folder) from None
        except OSError as error:
            raise OSError(error.errno, error.strerror, str(folder)) from None
        # The one who was here before may have removed the empty folder.
        with suppress(OSError):
            if sys.platform == "win32" or os.path.samestat(os.fstat(lock), folder.stat()):
                return lock
        os.close(lock)


if sys.platform == "win32":

    def _lock(folder: Path) -> int:
        # The system removes the file when it is closed, by a crash too.
        name = f"{os.path.normpath(folder)}.lock"
        try:
            return os.open(name, os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_TEMPORARY)
        except (FileExistsError, PermissionError):
            raise _busy(folder) from None

else:
    import fcntl

    def _lock(folder: Path) -> int:
        # Of the folder itself: nothing is left behind.
        lock = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno in (errno.EWOULDBLOCK, errno.EACCES):
                os.close(lock)
                raise _busy(folder) from None
            # Some network file systems cannot lock a folder.
        return lock


def _busy(folder: Path) -> InputError:
    return InputError(f"{folder}: another program is writing there; try again when it has finished, or name another")
