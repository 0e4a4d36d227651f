"""Fails where the project's plists cannot be read, lack a key, or name files that are not there."""

from __future__ import annotations

import plistlib
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

IOS = Path(__file__).resolve().parents[1]
INFO = {"CFBundleIdentifier", "NSMotionUsageDescription", "UIFileSharingEnabled", "LSSupportsOpeningDocumentsInPlace"}
PRIVACY = {"NSPrivacyTracking", "NSPrivacyCollectedDataTypes", "NSPrivacyAccessedAPITypes"}


def read(name: str, wanted: set[str]) -> dict[str, object]:
    whole = plistlib.loads((IOS / name).read_bytes())
    lacking = wanted - whole.keys()
    if lacking:
        sys.exit(f"{name} lacks {', '.join(sorted(lacking))}")
    return whole


def motion_usage() -> str | None:
    """Why the app reads the sensors, as its English words have it."""
    words = ElementTree.parse(IOS / "words" / "en.xml").getroot().iter("string")
    return next(((word.text or "").replace("\\'", "'") for word in words if word.attrib["name"] == "motion_usage"), None)


def main() -> None:
    info = read("App/Info.plist", INFO)
    read("App/Resources/PrivacyInfo.xcprivacy", PRIVACY)
    if info["NSMotionUsageDescription"] != motion_usage():
        sys.exit("Info.plist and ios/words say different things of why the sensors are read")
    spec = (IOS / "project.yml").read_text(encoding="utf-8")
    named = re.findall(r"(?<![A-Z_])(?:path|INFOPLIST_FILE): (\S+)|sources:\n +- (\w+)$", spec, re.MULTILINE)
    gone = [path for pair in named for path in pair if path and not (IOS / path).exists()]
    if gone:
        sys.exit(f"project.yml names what is not there: {', '.join(gone)}")
    print("the plists are whole, and the project's files are there")


if __name__ == "__main__":
    main()
