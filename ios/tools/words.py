"""words.py [--check]: writes the app's words from Android's, and fails with ``--check`` where what is written is stale.

Both apps say the same, so the texts stand once, in ``android/app/src/main/res``; what iOS alone says stands in ``ios/words``.
Only what the app's sources ask for is taken over: a key of Android's that is asked for and not there fails here.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

IOS = Path(__file__).resolve().parents[1]
ANDROID = IOS.parent / "android" / "app" / "src" / "main" / "res"
LANGUAGES = {"en": "values", "de": "values-de"}
PLACE = re.compile(r"%(\d)\$([-+.\d]*)([sdfg])")
SWIFT = {"s": "String", "d": "Int", "f": "Double", "g": "Double"}
NAMES = ["first", "second", "third", "fourth"]
# What iOS itself shows, by the key of Info.plist.
INFO = {"NSMotionUsageDescription": "motion_usage"}

Words = dict[str, str]


def read(path: Path) -> Words:
    """The texts of one file, as they are shown."""
    root = ElementTree.parse(path).getroot()
    return {one.attrib["name"]: unescaped(one.text or "") for one in root.iter("string")}


def unescaped(text: str) -> str:
    text = re.sub(r"\\u([0-9A-Fa-f]{4})", lambda code: chr(int(code[1], 16)), text)
    return text.replace("\\n", "\n").replace("\\'", "'").replace('\\"', '"')


def words_of(language: str) -> Words:
    """Android's, and over them those of iOS."""
    return read(ANDROID / LANGUAGES[language] / "strings.xml") | read(IOS / "words" / f"{language}.xml")


def camel(key: str) -> str:
    head, *rest = key.split("_")
    return head + "".join(part.capitalize() for part in rest)


def asked_for() -> set[str]:
    """The Swift names of the words that the sources use."""
    sources = [path for path in (IOS / "App").rglob("*.swift") if path.parent.name != "Generated"]
    return {name for path in sources for name in re.findall(r"\bWords\.(\w+)", path.read_text(encoding="utf-8"))}


def touched() -> set[str]:
    """What the UI tests look for on the screen; numbers are no words."""
    tests = "".join(path.read_text(encoding="utf-8") for path in (IOS / "UITests").glob("*.swift"))
    return {text for text in re.findall(r'\[\"([^\"]+)\"\]', tests) if text[0].isalpha()}


def chosen(all_words: dict[str, Words]) -> list[str]:
    """The keys to write, in the order of their names."""
    by_name = {camel(key): key for key in all_words["en"]}
    unknown = asked_for() - by_name.keys()
    if unknown:
        sys.exit(f"no text for {', '.join(sorted(unknown))}")
    own = read(IOS / "words" / "en.xml").keys()
    unused = own - {by_name[name] for name in asked_for()} - set(INFO.values())
    if unused:
        sys.exit(f"nobody asks for {', '.join(sorted(unused))}")
    return sorted(by_name[name] for name in asked_for())


def kinds(text: str) -> list[str]:
    """The Swift types of a text's places, in their order."""
    found = {int(at): SWIFT[kind] for at, _, kind in PLACE.findall(text)}
    return [found[at] for at in sorted(found)]


def for_apple(text: str) -> str:
    """A text with places as Foundation's formats have them."""
    return PLACE.sub(lambda m: f"%{m[1]}$" + {"s": "@", "d": "lld"}.get(m[3], m[2] + m[3]), text)


def catalog(entries: dict[str, dict[str, str]]) -> str:
    """A string catalog of Xcode."""
    strings = {
        key: {
            "extractionState": "manual",
            "localizations": {
                language: {"stringUnit": {"state": "translated", "value": text}} for language, text in texts.items()
            },
        }
        for key, texts in entries.items()
    }
    whole = {"sourceLanguage": "en", "strings": strings, "version": "1.0"}
    return json.dumps(whole, ensure_ascii=False, indent=2, separators=(",", " : ")) + "\n"


def swift_of(keys: list[str], english: Words) -> str:
    """A name for each text, with its places as arguments, so that the compiler checks both."""
    return "\n".join([SWIFT_HEAD, *(declared(key, english[key]) for key in keys), "}", ""])


def declared(key: str, text: str) -> str:
    types = kinds(text)
    if not types:
        return f'  static var {camel(key)}: String {{ plain("{key}") }}'
    names = NAMES[: len(types)]
    takes = ", ".join(f"_ {name}: {kind}" for name, kind in zip(names, types))
    return f'  static func {camel(key)}({takes}) -> String {{ filled("{key}", {", ".join(names)}) }}'


SWIFT_HEAD = """// Written by ios/tools/words.py from the texts of both apps. Never by hand.
import Foundation

/// Everything that the app says itself, in the language of the phone.
enum Words {
  private static func plain(_ key: String) -> String { Bundle.main.localizedString(forKey: key, value: nil, table: nil) }

  private static func filled(_ key: String, _ places: any CVarArg...) -> String {
    String(format: plain(key), locale: .current, arguments: places)
  }
"""


def written() -> dict[Path, str]:
    """Every file that is derived, with what belongs into it."""
    all_words = {language: words_of(language) for language in LANGUAGES}
    keys = chosen(all_words)
    for key in keys:
        if kinds(all_words["en"][key]) != kinds(all_words["de"].get(key, "")):
            sys.exit(f"{key}: the languages differ in their places, or one lacks it")
    shown = {words[key] for words in all_words.values() for key in keys}
    if touched() - shown:
        sys.exit(f"the UI tests look for {', '.join(sorted(touched() - shown))}, and nothing says so")
    said = {key: {language: for_apple(words[key]) for language, words in all_words.items()} for key in keys}
    asked = {plist: {language: words[key] for language, words in all_words.items()} for plist, key in INFO.items()}
    return {
        IOS / "App" / "Generated" / "Words.swift": swift_of(keys, all_words["en"]),
        IOS / "App" / "Resources" / "Localizable.xcstrings": catalog(said),
        IOS / "App" / "Resources" / "InfoPlist.xcstrings": catalog(asked),
    }


def main() -> None:
    files = written()
    if "--check" not in sys.argv:
        for path, text in files.items():
            path.write_text(text, encoding="utf-8")
        return
    stale = [path.name for path, text in files.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    if stale:
        sys.exit(f"stale: {', '.join(stale)}; ios/tools/words.py writes them anew")
    print(f"{len(files)} files of words are fresh")


if __name__ == "__main__":
    main()
