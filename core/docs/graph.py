"""Which crate of the core uses which, drawn into ARCHITECTURE.md from `cargo metadata`; with --check fails where it is stale."""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "ARCHITECTURE.md"
BEGIN, END = "<!-- graph: make graph -->\n", "<!-- end of graph -->"


def uses() -> dict[str, set[str]]:
    """By crate: the crates of this workspace that it uses, tests left out."""
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps"]
    found = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    packages = {p["name"]: p for p in json.loads(found)["packages"]}
    return {
        name: {d["name"] for d in package["dependencies"] if d["name"] in packages and d["kind"] is None}
        for name, package in packages.items()
        if name != "gyradius-test-support"
    }


def reduced(arrows: dict[str, set[str]]) -> list[tuple[str, str]]:
    """Arrows that no longer way stands for."""

    def reach(name: str) -> set[str]:
        return arrows[name].union(*(reach(used) for used in arrows[name]))

    return sorted(
        (name, used)
        for name, all_used in arrows.items()
        for used in all_used
        if not any(used in reach(other) for other in all_used - {used})
    )


def drawn() -> str:
    """The graph in Mermaid: an arrow points at the crate that is used."""
    short = lambda name: name.removeprefix("gyradius-")  # noqa: E731
    lines = [f"    {short(name)} --> {short(used)}" for name, used in reduced(uses())]
    return "\n".join(["```mermaid", "flowchart TD", *lines, "```", ""])


def main() -> None:
    """Writes or checks."""
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    old, after = rest.split(END)
    new = drawn()
    if "--check" in sys.argv:
        if old != new:
            sys.exit("ARCHITECTURE.md shows an old graph: `make graph` draws it anew")
        return
    PAGE.write_text(before + BEGIN + new + END + after)


if __name__ == "__main__":
    main()
