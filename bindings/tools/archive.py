"""archive.py ARCHIVE HEADER: is this a static library for iPhones, and does it hold every function that the header declares?

Every object must be Mach-O for arm64, and say that it is made for iOS.
"""

import pathlib
import re
import struct
import sys
from collections.abc import Iterator

MACH_O_64, ARM64, OBJECT = 0xFEEDFACF, 0x0100000C, 1
SYMTAB, BUILD_VERSION, IPHONEOS_MINIMUM, IOS = 0x2, 0x32, 0x25, 2
# Bits of a symbol's type: debugger's, private to its library, where it is defined, visible outside of its object.
STAB, PRIVATE, TYPE, EXTERNAL = 0xE0, 0x10, 0x0E, 0x01


def demand(held: bool, otherwise: str) -> None:
    """Ends the check where something does not hold."""
    if not held:
        sys.exit(otherwise)


def members(archive: bytes) -> Iterator[tuple[str, bytes]]:
    """The files in an archive as BSD and Apple write it, but for its index."""
    demand(archive.startswith(b"!<arch>\n"), "this is no archive")
    at = 8
    while at < len(archive):
        name, size = archive[at : at + 16].decode().strip(), int(archive[at + 48 : at + 58])
        start, at = at + 60, at + 60 + size + size % 2
        content = archive[start : start + size]
        if name.startswith("#1/"):
            long = int(name[3:])
            name, content = content[:long].rstrip(b"\0").decode(), content[long:]
        if not name.startswith("__.SYMDEF"):
            yield name, content


def commands(name: str, content: bytes) -> dict[int, int]:
    """Where each load command of an object lies, by its kind."""
    magic, processor, _, kind, count, *_ = struct.unpack_from("<8I", content)
    demand((magic, processor, kind) == (MACH_O_64, ARM64, OBJECT), f"{name} is no Mach-O object for arm64")
    found, at = {}, 32
    for _ in range(count):
        command, size = struct.unpack_from("<2I", content, at)
        found[command] = at
        at += size
    return found


def defined(content: bytes, at: int) -> Iterator[str]:
    """What an object lets others link to."""
    symbols, count, strings, _ = struct.unpack_from("<4I", content, at + 8)
    for symbol in range(count):
        name, kind = struct.unpack_from("<IB", content, symbols + 16 * symbol)
        if kind & EXTERNAL and kind & TYPE and not kind & (STAB | PRIVATE):
            start = strings + name
            # The underscore before every name of C is Apple's.
            yield content[start + 1 : content.index(b"\0", start)].decode()


def main(archive: pathlib.Path, header: pathlib.Path) -> None:
    wanted = set(re.findall(r"^\S.*?\b((?:uniffi|ffi)_gyradius_ffi_\w+)\(", header.read_text(), re.MULTILINE))
    found: set[str] = set()
    objects = 0
    for name, content in members(archive.read_bytes()):
        of_kind = commands(name, content)
        if BUILD_VERSION in of_kind:
            (platform,) = struct.unpack_from("<I", content, of_kind[BUILD_VERSION] + 8)
            demand(platform == IOS, f"{name} is made for Apple's platform {platform}, not for iOS")
        else:
            demand(IPHONEOS_MINIMUM in of_kind, f"{name} does not say that it is made for iOS")
        if SYMTAB in of_kind:
            found.update(defined(content, of_kind[SYMTAB]))
        objects += 1
    missing = sorted(wanted - found)
    demand(bool(wanted), f"{header} declares no function")
    demand(not missing, f"{len(missing)} of {len(wanted)} functions are missing, {missing[:3]} among them")
    size = archive.stat().st_size / 1e6
    print(f"{archive}: {size:.1f} MB, {objects} object files for iOS on arm64, with all {len(wanted)} functions of the header")


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
