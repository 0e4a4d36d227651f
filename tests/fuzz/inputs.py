"""An input of the fuzz: files, and what is done with them. On disk it is one JSON file."""

from __future__ import annotations

import base64
import io
import json
import warnings
import zipfile
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Input:
    """Files by name, and the way they go into the program.

    ``session``: a folder that is loaded and measured; ``zip``: the same, zipped; ``bare``: the one file is loaded and measured;
    ``import``: the files are imported and the session is measured; ``describe``: ``gyradius import`` without ``-o``;
    ``recorder``: the file is read as the recorder's.
    """

    name: str
    action: str
    files: dict[str, bytes]
    mapping: list[str] = field(default_factory=list)
    #: Members that a zip holds beside the files: a name may come twice, or lead out of the archive.
    members: list[tuple[str, bytes]] = field(default_factory=list)
    #: Where the bytes of a zip are damaged: place and new byte; a negative place cuts there.
    damage: list[tuple[int, int]] = field(default_factory=list)

    def write(self, folder: Path) -> list[str]:
        """Writes the files and answers the paths that the program is given."""
        folder.mkdir(parents=True, exist_ok=True)
        if self.action == "zip":
            (folder / "session.zip").write_bytes(self._zip())
            return [str(folder / "session.zip")]
        for name, content in self.files.items():
            (folder / name).write_bytes(content)
        return [str(folder)] if self.action == "session" else [str(folder / name) for name in self.files]

    def _zip(self) -> bytes:
        out = io.BytesIO()
        with warnings.catch_warnings(), zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
            # A name that comes twice is wanted here.
            warnings.simplefilter("ignore")
            for name, content in [*self.files.items(), *self.members]:
                archive.writestr(zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0)), content)
        content = bytearray(out.getvalue())
        for place, byte in self.damage:
            if place < 0:
                del content[place:]
            elif content:
                content[place % len(content)] = byte
        return bytes(content)

    def to_json(self, why: str = "") -> str:
        """One text: files that are UTF-8 stay readable."""
        return json.dumps(
            {
                "why": why,
                "name": self.name,
                "action": self.action,
                "files": {name: _text(content) for name, content in self.files.items()},
                "mapping": self.mapping,
                "members": [[name, _text(content)] for name, content in self.members],
                "damage": self.damage,
            },
            indent=1,
        )

    @classmethod
    def from_json(cls, text: str) -> Input:
        """The input of a text of `to_json`."""
        data = json.loads(text)
        return cls(
            data["name"],
            data["action"],
            {name: _bytes(content) for name, content in data["files"].items()},
            data["mapping"],
            [(name, _bytes(content)) for name, content in data["members"]],
            [(place, byte) for place, byte in data["damage"]],
        )


def _text(content: bytes) -> str | dict[str, str]:
    try:
        return content.decode()
    except UnicodeDecodeError:
        return {"base64": base64.b64encode(content).decode()}


def _bytes(text: str | dict[str, str]) -> bytes:
    return text.encode() if isinstance(text, str) else base64.b64decode(text["base64"])
