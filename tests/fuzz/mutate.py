"""Mutations of an input: keys, values and units of the session, cells and stamps of tables, bytes, members of zips, names of files."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from random import Random

from inputs import Input

NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e-?\d+)?(?![\w.])")
NUMBERS = (
    "nan inf -inf 0 0.0 -0.0 1 -1 2 1e300 -1e300 1e308 1.7976931348623157e308 5e-324 1e-310 1e-300 1e-30 1e-12 1e-6 1e-3 1e3 1e6 1e9 "
    "1e12 1e15 9007199254740993 9223372036854775807 9223372036854775808 0x10 1_000 90 89.9 180 360 45 0.5 3.14159 299792458 1700000000"
).split()
NOT_NUMBERS = [
    '"1.0"',
    "true",
    "[]",
    "{}",
    "[1.0, 2.0]",
    "1979-05-27",
    '""',
    "{ value = 1.0 }",
    "{ u = 1.0 }",
    "{ value = 2.0, u = 0.0 }",
]
# Units that people write in place of m, kg, s, rad/s, m/s² and degrees.
FACTORS = [
    1e-3,
    1e-2,
    1e2,
    1e3,
    0.3048,
    0.0254,
    1 / 0.3048,
    57.29578,
    1 / 57.29578,
    9.80665,
    1 / 9.80665,
    60.0,
    0.5,
    2.0,
    -1.0,
    1e-9,
    1e9,
]
KEYS = (
    "format title name mass length_overall density gravity latitude_deg altitude air_density position gyradii id recording displacement "
    "periods at periods_s amplitude_deg excited added_mass suspension kind orientation line_length spacing top_spacing hull_pitch_deg hull_roll_deg points_m same_as "
    "points_moved axis_height end arm depth angle_deg value u yaw sway surge pitch roll pitch_in_phase pitch_out_of_phase "
    "roll_in_phase roll_out_of_phase compound other measured_on"
).split()
WORDS = (
    KEYS
    + (
        "bifilar athwartships fore_and_aft bow stern body site attachment swing swing.suspension incline recorded gyradius-session/1 "
        "gyradius-session/2 yaw.csv pitch.csv"
    ).split()
)
PATHS = [
    "../yaw.csv",
    "/etc/hostname",
    "a/../../yaw.csv",
    "C:\\yaw.csv",
    "..",
    ".",
    "",
    "yaw.csv\0",
    "YAW.CSV",
    "session.toml",
    "./yaw.csv",
]
STAMPS: list[Callable[[float], float]] = [
    lambda t: t * 1e3,
    lambda t: t * 1e-3,
    lambda t: t * 1e9,
    lambda t: t + 1.7e9,
    lambda t: 1e3 * t + 1.7e12,
    lambda t: -t,
    lambda t: float(int(t)),
    lambda t: t + 1e5,
    lambda t: t - 1e5,
    lambda t: t + 0.5,
    lambda t: t % 8.0,
    lambda t: 0.0,
    lambda t: 1e300,
    lambda t: -1e300,
    lambda t: 5e-324,
    lambda t: float("nan"),
    lambda t: float("inf"),
    lambda t: t + 86400.0,
    lambda t: t * t,
    lambda t: t * 1.01,
    lambda t: round(t, 1),
]


def mutated(rng: Random, given: Input) -> Input:
    """The input after one to three mutations."""
    found = replace(given, files=dict(given.files), members=list(given.members), damage=list(given.damage))
    if rng.random() < 0.5:
        return _plausible(rng, found)
    for _ in range(rng.choice([1, 1, 1, 2, 2, 3])):
        found = _once(rng, found)
    return found


def _plausible(rng: Random, given: Input) -> Input:
    """What is well formed still, so that it gets as far as the estimate: other numbers in the session, other stamps and cells."""
    names = [name for name in sorted(given.files) if name.endswith((".toml", ".csv"))]
    if not names:
        return _once(rng, given)
    files = dict(given.files)
    for name in rng.choices(names, k=rng.choice([1, 1, 2])):
        text = files[name].decode("latin-1")
        try:
            changed = _figures(rng, text) if name.endswith(".toml") else _cells(rng, text)
            files[name] = changed.encode("latin-1", "replace")
        except (OverflowError, ValueError):
            # No table of numbers, or not of finite ones.
            files[name] = content(rng, name, files[name])
    return replace(given, files=files)


def _figures(rng: Random, text: str) -> str:
    """A session with one to three other figures."""
    for _ in range(rng.choice([1, 1, 2, 3])):
        found = list(NUMBER.finditer(text))
        if not found:
            return text
        one = rng.choice(found)
        factor = rng.choice([rng.choice(FACTORS), 1 + rng.gauss(0, 0.1), 10 ** rng.uniform(-3, 3), 0.0])
        text = text[: one.start()] + f"{float(one.group()) * factor:.7g}" + text[one.end() :]
    return text


def _cells(rng: Random, text: str) -> str:
    """A table with other stamps, with a column that is constant, clipped, noisy or of another size, or with rows lost."""
    lines = text.rstrip("\n").split("\n")
    separator = max(",;\t", key=lines[0].count)
    rows = [line.split(separator) for line in lines[1:]]
    width = len(lines[0].split(separator))
    columns = [list(map(float, column)) for column in zip(*rows, strict=True)]
    if len(columns) != width:
        raise ValueError("no table")
    n, one = len(rows), rng.randrange(width)
    first, last = sorted(rng.randrange(n + 1) for _ in range(2))
    t, kind = columns[0], rng.randrange(9)
    if kind == 0:
        jitter = rng.choice([1e-4, 1e-2, 0.1])
        columns[0] = [s + rng.gauss(0, jitter) for s in t]
    elif kind == 1:
        by = rng.choice([-5.0, -0.1, 0.1, 3.0, 30.0, 1e3])
        columns[0] = [s + by if i >= first else s for i, s in enumerate(t)]
    elif kind == 2:
        size = rng.choice([0.05, 0.5, 1.0, 2.0])
        columns[0] = [size * int(s / size) for s in t]
    elif kind == 3:
        columns[one] = [columns[one][first % n]] * n
    elif kind == 4:
        most = rng.uniform(0.1, 1.0) * max(map(abs, columns[one]))
        columns[one] = [max(-most, min(most, value)) for value in columns[one]]
    elif kind == 5:
        size = rng.choice([1e-3, 0.1, 1.0, 30.0])
        columns[one] = [value + rng.gauss(0, size) for value in columns[one]]
    elif kind == 6:
        factor = rng.choice([*FACTORS, 0.0, 1.1])
        for place in rng.choice([[one], [*range(1, 4)], [*range(4, width)]]):
            if place < width:
                columns[place] = [value * factor for value in columns[place]]
    elif kind == 7:
        columns = [column[:first] + column[last:] for column in columns]
    else:
        columns = [column[:first] + column[first:last] + column[first:last] + column[last:] for column in columns]
    changed = [separator.join(f"{value:.9g}" for value in row) for row in zip(*columns, strict=True)]
    return "\n".join([lines[0], *changed, ""])


def _once(rng: Random, given: Input) -> Input:
    if given.action == "zip" and rng.random() < 0.4:
        return _zip(rng, given)
    if given.mapping and rng.random() < 0.2:
        return replace(given, mapping=_mapping(rng, given.mapping))
    if rng.random() < 0.03:
        return _files(rng, given)
    names = sorted(given.files)
    if not names:
        return given
    # The session's own text half of the time.
    name = "session.toml" if "session.toml" in names and rng.random() < 0.5 else rng.choice(names)
    return replace(given, files={**given.files, name: content(rng, name, given.files[name])})


def content(rng: Random, name: str, block: bytes) -> bytes:
    """A file's bytes after one mutation of its kind."""
    text = block.decode("latin-1")
    is_text = name.endswith((".toml", ".csv", ".txt", ".gcsv", ".json"))
    if not is_text or rng.random() < 0.1:
        return damaged(rng, block)
    try:
        changed = toml(rng, text) if name.endswith(".toml") else table(rng, text)
        # A big cell may be no float.
    except (OverflowError, ValueError):
        changed = text[: rng.randrange(len(text) + 1)]
    return changed.encode("latin-1", "replace")


def damaged(rng: Random, block: bytes) -> bytes:
    """Bytes flipped, cut, put in, doubled, or in another encoding."""
    if not block:
        return bytes(rng.randrange(256) for _ in range(rng.randrange(64)))
    place, end = sorted(rng.randrange(len(block)) for _ in range(2))
    cut = min(end, place + 2 ** rng.randrange(12))

    def flipped() -> bytes:
        found = bytearray(block)
        for _ in range(2 ** rng.randrange(6)):
            found[rng.randrange(len(found))] = rng.choice([0, 255, 10, 44, rng.randrange(256)])
        return bytes(found)

    def encoded(encoding: str) -> bytes:
        return block.decode("latin-1").encode(encoding, "replace")

    return rng.choice(
        [
            flipped,
            flipped,
            lambda: block[:place],
            lambda: block[place:],
            lambda: block[:place] + block[cut:],
            lambda: block[:cut] + block[place:cut] + block[cut:],
            lambda: block[:place] + bytes(rng.randrange(256) for _ in range(2 ** rng.randrange(7))) + block[place:],
            lambda: b"\xef\xbb\xbf" + block,
            lambda: encoded("utf-16"),
            lambda: encoded("utf-32"),
            lambda: block.replace(b"\n", b"\r\n"),
            lambda: block.replace(b"\n", b"\r"),
            lambda: block + block,
            lambda: b"",
            lambda: block[:place] + b"A" * 100_000 + block[place:],
            lambda: block[:place] + b"\0" * 4096 + block[place:],
        ]
    )()


def toml(rng: Random, text: str) -> str:
    """A session's text with another value, key, unit, line or table."""
    lines = text.split("\n")
    at = rng.randrange(len(lines))

    def number(change: Callable[[str], str]) -> str:
        found = list(NUMBER.finditer(text))
        if not found:
            return text
        one = rng.choice(found)
        return text[: one.start()] + change(one.group()) + text[one.end() :]

    def word() -> str:
        found = [one for one in re.finditer(r"[a-z_][\w./-]*", text) if one.group() in WORDS]
        if not found:
            return text
        one = rng.choice(found)
        return text[: one.start()] + rng.choice(WORDS) + text[one.end() :]

    def without_u() -> str:
        found = list(re.finditer(r", u = [\d.e-]+", text))
        if not found:
            return text
        one = rng.choice(found)
        return (
            text[: one.start()]
            + rng.choice(["", ", u = 0", ", u = 1e-300", ", u = 1e6", ", u = -1", ", u = nan"])
            + text[one.end() :]
        )

    def line() -> str:
        other = rng.randrange(len(lines))
        changed = rng.choice(
            [
                lines[:at] + lines[at + 1 :],
                [*lines[: at + 1], lines[at], *lines[at + 1 :]],
                [*lines[:at], lines[other], *lines[at:]],
                [*lines[:at], f"{rng.choice(KEYS)} = {rng.choice(NUMBERS + NOT_NUMBERS)}", *lines[at:]],
            ]
        )
        return "\n".join(changed)

    def tables() -> str:
        parts = re.split(r"(?m)^(?=\[\[)", text)
        place = rng.randrange(len(parts))
        many = rng.choice([0, 2, 2, 3, 30])
        copies = [re.sub(r'id = "', f'id = "{i}', parts[place], count=1) if i else parts[place] for i in range(many)]
        return "".join(parts[:place] + copies + parts[place + 1 :])

    def path() -> str:
        return re.sub(r"\w+\.csv", lambda _: rng.choice(PATHS).replace("\\", "\\\\").replace("\0", "\\u0000"), text, count=1)

    def titled() -> str:
        odd = rng.choice(["", "[red]x[/red]", "\\u0000", "x" * 5000, "\\u202e\\ud7ff", "`", "<script>", "\\n", "{0}", "%s"])
        return re.sub(r'(title|name|id) = "[^"]*"', lambda one: f'{one.group(1)} = "{odd}"', text, count=rng.choice([1, 2, 9]))

    return rng.choice(
        [
            lambda: number(lambda _: rng.choice(NUMBERS)),
            lambda: number(lambda _: rng.choice(NOT_NUMBERS)),
            lambda: number(lambda old: f"{float(old) * rng.choice(FACTORS):.7g}"),
            lambda: number(lambda old: f"{float(old) * rng.choice(FACTORS):.7g}"),
            lambda: number(lambda old: f"{float(old) * (1 + rng.gauss(0, 0.2)):.7g}"),
            lambda: number(lambda old: f"{float(old) * 10 ** rng.uniform(-6, 6):.7g}"),
            word,
            word,
            without_u,
            line,
            line,
            tables,
            path,
            titled,
        ]
    )()


def table(rng: Random, text: str) -> str:
    """A table with other stamps, cells, rows, columns or header."""
    lines = text.rstrip("\n").split("\n")
    separator = max(",;\t", key=lines[0].count)
    rows = [line.split(separator) for line in lines]
    header, rows = rows[0], rows[1:]
    if not rows:
        return text + text
    width = len(header)
    first, last = sorted(rng.randrange(len(rows) + 1) for _ in range(2))
    if rng.random() < 0.3:
        last = len(rows)
    column = rng.randrange(width)

    def cells(where: int, start: int, end: int, change: Callable[[float], float]) -> None:
        for row in rows[start:end]:
            if where < len(row):
                try:
                    row[where] = f"{change(float(row[where])):.10g}"
                except ValueError:
                    row[where] = "1"

    def stamps() -> None:
        start, end = rng.choice([(first, last), (0, len(rows)), (first, first + 1), (len(rows) - 1, len(rows))])
        cells(0, start, end, rng.choice(STAMPS))

    def odd_cells() -> None:
        for _ in range(2 ** rng.randrange(5)):
            row = rng.choice(rows)
            row[rng.randrange(len(row))] = rng.choice([*NUMBERS, "", " ", "x", "1,5", '"', "NA", "1e", "--1", "+1", "NaN", "INF"])

    def constant() -> None:
        value = rng.choice(["0", "1", "9.81", "nan", "", "1e300", "1e-320", "17.45"])
        for row in rows[first:last] if rng.random() < 0.3 else rows:
            if column < len(row):
                row[column] = value

    def scaled() -> None:
        columns = rng.choice([[column], list(range(1, width)), list(range(1, min(4, width))), list(range(4, width))])
        factor = rng.choice(FACTORS + [1e-150, 1e150, 1e20, 1e-20, 100.0, 0.0])
        for one in columns:
            cells(one, 0, len(rows), lambda value: value * factor)

    def clipped() -> None:
        most = rng.choice([0.01, 0.05, 0.5, 9.0])
        for one in range(1, width):
            cells(one, 0, len(rows), lambda value: max(-most, min(most, value)))

    def columns() -> None:
        other = rng.randrange(width)
        kind = rng.randrange(4)
        for row in [header, *rows]:
            if max(column, other) >= len(row):
                continue
            if kind == 0:
                del row[column]
            elif kind == 1:
                row.insert(other, row[column])
            elif kind == 2:
                row[column], row[other] = row[other], row[column]
            elif row is not header:
                row[column] = row[other]

    def head() -> None:
        names = [
            "t",
            "gx",
            "gy",
            "gz",
            "ax",
            "ay",
            "az",
            "y",
            "period",
            "angle",
            "rate",
            "time",
            "",
            "seconds_elapsed",
            "lx",
            "ly",
            "lz",
        ]
        header[column] = rng.choice(names)

    def swapped() -> None:
        rows[first:last] = rng.choice(
            [
                [],
                rows[first:last] * 2,
                rows[first:last][::-1],
                rng.sample(rows[first:last], last - first),
                rows[first:last:2],
                rows[first:last:10],
                [row[: rng.randrange(width + 1)] for row in rows[first:last]],
                [[]] * (last - first),
                rows[first : first + 3],
            ]
        )

    def steps() -> None:
        by = rng.choice([1e-9, 0.01, 1.0, 30.0, -1.0, -30.0, 1e4, 1e9, 1e17])
        cells(0, first, len(rows), lambda t: t + by)

    rng.choice(
        [stamps, stamps, stamps, steps, odd_cells, odd_cells, constant, scaled, scaled, clipped, columns, head, swapped, swapped]
    )()
    between = separator if rng.random() < 0.95 else rng.choice([",", ";", "\t", " ", "|", ", "])
    return "\n".join(between.join(row) for row in [header, *rows]) + "\n"


def _zip(rng: Random, given: Input) -> Input:
    names = sorted(given.files)
    kind = rng.randrange(5)
    if kind == 0:
        return replace(
            given, damage=[*given.damage, *((rng.randrange(1 << 16), rng.randrange(256)) for _ in range(rng.randrange(1, 9)))]
        )
    if kind == 1:
        return replace(given, damage=[*given.damage, (-rng.randrange(1, 2000), 0)])
    if kind == 2 and names:
        name = rng.choice(names)
        return replace(
            given, members=[*given.members, (rng.choice([name, f"{name}/x", f"x/{name}", name.upper()]), given.files[name])]
        )
    if kind == 3:
        odd = rng.choice([*PATHS, "__MACOSX/._yaw.csv", "a/" * 200 + "b", "x" * 1000])
        return replace(given, members=[*given.members, (odd or "x", b"t,gx\n0,1\n")])
    return replace(given, members=[*given.members, ("zeros.csv", bytes(rng.choice([10, 1_000_000, 30_000_000])))])


def _mapping(rng: Random, mapping: list[str]) -> list[str]:
    found = list(mapping)
    place = rng.randrange(len(found))
    units = ["deg/s", "rad/s", "m/s^2", "g", "ms", "s", "us", "ns", "rad", "deg", "m", "mm", "x", ""]
    fields = ["t", "gx", "gz", "az", "angle", "rate", "y", "period", "lx", ""]
    found[place] = rng.choice(
        [
            f"{rng.choice(fields)}={found[place].partition('=')[2]}",
            f"{found[place].partition(':')[0]}:{rng.choice(units)}",
            f"{rng.choice(fields)}={rng.choice(['1', '2', '99', '0', '-1', 'wx', ''])}:{rng.choice(units)}",
            found[place][: rng.randrange(len(found[place]) + 1)],
            found[place - 1],
        ]
    )
    return found


def _files(rng: Random, given: Input) -> Input:
    names = sorted(given.files)
    if not names:
        return given
    files = dict(given.files)
    name = rng.choice(names)
    if rng.random() < 0.5 and len(names) > 1:
        del files[name]
    else:
        files[rng.choice(["x.csv", "x.zip", "x.json", "x.gyr", "x.mat", "x.sqlite", "x.xlsx", "x", name + ".txt"])] = files.pop(
            name
        )
    return replace(given, files=files)
