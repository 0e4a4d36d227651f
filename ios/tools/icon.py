"""icon.py [--check]: draws the app's icon from Android's vector, and fails with ``--check`` where what is drawn is stale.

iOS wants one PNG of 1024 pixels without transparency, and rounds its corners itself. What of the vector format the icon does
not use, this does not know: straight strokes, fills, and the commands M, m, H, h, V, v, L, l, C, c and z.
"""

from __future__ import annotations

import re
import struct
import sys
import zlib
from pathlib import Path
from xml.etree import ElementTree

IOS = Path(__file__).resolve().parents[1]
VECTOR = IOS.parent / "android" / "app" / "src" / "main" / "res" / "drawable" / "ic_launcher.xml"
ICON = IOS / "App" / "Resources" / "Assets.xcassets" / "AppIcon.appiconset" / "icon.png"
ANDROID = "{http://schemas.android.com/apk/res/android}"
SIZE = 1024
# Rows of samples in each pixel, and pieces of a curve.
FINE, PIECES = 8, 64

Point = tuple[float, float]
Polygon = list[Point]


def paths(data: str) -> list[Polygon]:
    """The lines of a path, curves in pieces."""
    found: list[Polygon] = []
    x = y = 0.0
    for command, rest in re.findall(r"([MmHhVvLlCcZz])([^MmHhVvLlCcZz]*)", data):
        numbers = [float(one) for one in re.findall(r"-?[\d.]+", rest)]
        relative = command.islower()
        match command.lower():
            case "m":
                x, y = (x + numbers[0], y + numbers[1]) if relative else (numbers[0], numbers[1])
                found.append([(x, y)])
            case "h":
                x = numbers[0] + (x if relative else 0)
                found[-1].append((x, y))
            case "v":
                y = numbers[0] + (y if relative else 0)
                found[-1].append((x, y))
            case "l":
                x, y = (x + numbers[0], y + numbers[1]) if relative else (numbers[0], numbers[1])
                found[-1].append((x, y))
            case "c":
                for at in range(0, len(numbers), 6):
                    ends = [(numbers[at + k] + (x if relative else 0), numbers[at + k + 1] + (y if relative else 0)) for k in (0, 2, 4)]
                    found[-1] += [bezier([(x, y), *ends], k / PIECES) for k in range(1, PIECES + 1)]
                    x, y = ends[-1]
            case "z":
                x, y = found[-1][0]
    return found


def bezier(points: list[Point], t: float) -> Point:
    weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
    return (sum(w * p[0] for w, p in zip(weights, points)), sum(w * p[1] for w, p in zip(weights, points)))


def stroked(line: Polygon, width: float) -> Polygon:
    """A straight line as wide as it is drawn."""
    (x0, y0), (x1, y1) = line
    length = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
    across, along = ((y0 - y1) / length * width / 2, (x1 - x0) / length * width / 2)
    return [(x0 + across, y0 + along), (x1 + across, y1 + along), (x1 - across, y1 - along), (x0 - across, y0 - along)]


def covered(polygon: Polygon, scale: float) -> list[list[float]]:
    """How much of each pixel lies inside, by rows."""
    rows = [[0.0] * SIZE for _ in range(SIZE)]
    edges = list(zip(polygon, polygon[1:] + polygon[:1]))
    for fine in range(SIZE * FINE):
        y = (fine + 0.5) / FINE / scale
        crossings = sorted(x0 + (y - y0) * (x1 - x0) / (y1 - y0) for (x0, y0), (x1, y1) in edges if (y0 <= y) != (y1 <= y))
        for left, right in zip(crossings[::2], crossings[1::2]):
            span(rows[fine // FINE], left * scale, right * scale)
    return rows


def span(row: list[float], left: float, right: float) -> None:
    first, last = max(0, int(left)), min(SIZE - 1, int(right))
    for x in range(first, last + 1):
        row[x] += max(0.0, min(right, x + 1) - max(left, x)) / FINE


def pixels() -> bytes:
    """Rows of red, green and blue, each behind a filter of none, as a PNG packs them."""
    vector = ElementTree.parse(VECTOR).getroot()
    scale = SIZE / float(vector.attrib[f"{ANDROID}viewportWidth"])
    picture = [[(0, 0, 0)] * SIZE for _ in range(SIZE)]
    for path in vector.iter("path"):
        get = lambda name, path=path: path.attrib.get(ANDROID + name)
        lines = paths(get("pathData") or "")
        if stroke := get("strokeColor"):
            shapes = [(stroked(line, float(get("strokeWidth") or 1)), stroke) for line in lines]
        else:
            shapes = [(line, get("fillColor") or "") for line in lines]
        for polygon, colour in shapes:
            paint(picture, covered(polygon, scale), colour)
    return b"".join(b"\0" + bytes(part for pixel in row for part in pixel) for row in picture)


def paint(picture: list[list[tuple[int, int, int]]], cover: list[list[float]], colour: str) -> None:
    red, green, blue = (int(colour[at : at + 2], 16) for at in (3, 5, 7))
    for row, shares in zip(picture, cover):
        for x, share in enumerate(shares):
            if share > 0:
                share = min(share, 1.0)
                row[x] = tuple(round(old + share * (new - old)) for old, new in zip(row[x], (red, green, blue)))  # type: ignore[assignment]


def chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(rows: bytes) -> bytes:
    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def drawn() -> bytes:
    """What the committed icon shows: compressors differ, rows do not."""
    data = ICON.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        packed += data[at + 8 : at + 8 + length] if kind == b"IDAT" else b""
        at += length + 12
    return zlib.decompress(packed)


def main() -> None:
    rows = pixels()
    if "--check" not in sys.argv:
        ICON.write_bytes(png(rows))
    elif drawn() != rows:
        sys.exit("the icon is not what Android's vector draws: `ios/tools/icon.py` draws it anew")
    print(f"{ICON.name}: {SIZE} × {SIZE} pixels of {VECTOR.name}")


if __name__ == "__main__":
    main()
