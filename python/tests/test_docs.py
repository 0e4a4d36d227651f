"""The documentation site: it builds without a warning, loads nothing from elsewhere, and shows commands that exist."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typer
from conftest import swing_csv

import gyradius
from gyradius.cli import app

DOCS = Path(__file__).resolve().parents[1] / "docs"
PAGES = sorted((DOCS / "pages").rglob("*.md"))
NOTEBOOKS = sorted((DOCS / "notebooks").glob("*.ipynb"))
NEEDED = ("mkdocs", "material", "mkdocstrings", "mkdocstrings_handlers.python", "griffe_sphinx", "latex2mathml")
# README files whose chapters are pages too.
README = DOCS.parent / "README.md"
FENCE = re.compile(r"^ *```(\w+)[^\n]*\n(.*?)^ *```", re.M | re.S)
# What makes a browser fetch something.
FETCHED = {
    "script": ("src",),
    "img": ("src", "srcset"),
    "source": ("src", "srcset"),
    "iframe": ("src",),
    "video": ("src", "poster"),
    "audio": ("src",),
    "object": ("data",),
    "embed": ("src",),
    "image": ("href", "xlink:href"),
    "use": ("href", "xlink:href"),
}
RELATIONS = {"stylesheet", "icon", "preload", "prefetch", "preconnect", "dns-prefetch", "manifest", "modulepreload"}
ELSEWHERE = re.compile(r"^\s*(?:https?:)?//", re.I)
IN_STYLE = re.compile(r"""(?:url\(\s*['"]?|@import\s+['"])\s*((?:https?:)?//[^'")\s]+)""", re.I)


def lacking() -> list[str]:
    found = []
    for name in NEEDED:
        try:
            is_there = find_spec(name) is not None
        except ModuleNotFoundError:
            is_there = False
        if not is_there:
            found.append(name)
    return found


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    missing = lacking()
    if missing:
        pytest.skip(f"{', '.join(missing)} not installed (python/docs/requirements.txt; `make docs` installs it)")
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "-f", DOCS / "mkdocs.yml", "-d", folder]
    surroundings = {**os.environ, "NO_MKDOCS_2_WARNING": "1", "PYTHONPATH": str(DOCS.parent)}
    done = subprocess.run(
        [*map(str, command)], capture_output=True, encoding="utf-8", env=surroundings, check=False, timeout=300
    )
    assert done.returncode == 0, done.stderr[-4000:]
    assert "WARNING" not in done.stderr, done.stderr
    return folder


class Loads(HTMLParser):
    """What the elements of a page load."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.addresses: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.addresses += [given[name] for name in FETCHED.get(tag, ()) if name in given]
        if tag == "link" and RELATIONS & set(given.get("rel", "").split()):
            self.addresses.append(given.get("href", ""))


def loaded(file: Path) -> list[str]:
    text = file.read_text(encoding="utf-8")
    return [*Loads(text).addresses, *IN_STYLE.findall(text)] if file.suffix == ".html" else IN_STYLE.findall(text)


def test_every_page_of_the_sources_is_in_the_site(site: Path) -> None:
    for page in PAGES:
        assert (site / page.relative_to(DOCS / "pages").with_suffix(".html")).is_file(), page


def test_no_page_loads_from_another_host(site: Path) -> None:
    files = [path for path in sorted(site.rglob("*")) if path.suffix in {".html", ".css"}]
    assert len(files) > len(PAGES)
    foreign = {str(file.relative_to(site)): [a for a in loaded(file) if ELSEWHERE.match(a)] for file in files}
    assert {file: addresses for file, addresses in foreign.items() if addresses} == {}


def test_what_a_page_loads_is_there(site: Path) -> None:
    for page in sorted(site.rglob("*.html")):
        if page.name == "404.html":  # Its addresses begin at the root of a server.
            continue
        for address in Loads(page.read_text(encoding="utf-8")).addresses:
            if not re.match(r"(data|blob):|#|$", address):
                assert (page.parent / re.split(r"[?#]", address)[0]).exists(), (page, address)


def test_no_script_holds_an_address_that_it_could_load_from(site: Path) -> None:
    scripts = sorted(site.glob("assets/javascripts/*.js"))
    assert scripts
    # A name in a comment; and what is asked about a repository, which the pages do not name.
    harmless = re.compile(r"https://(?:clipboardjs\.com/|api\.github\.com/(?:repos|users)/)")
    for script in scripts:
        text = script.read_text(encoding="utf-8")
        found = re.findall(r"https?://[\w.-]+\.\w+[\w./-]*", text)
        assert [address for address in found if not harmless.match(address)] == [], script
    for page in sorted(site.rglob("*.html")):
        assert 'data-md-component="source"' not in page.read_text(encoding="utf-8"), page


@pytest.mark.parametrize(
    "foreign",
    [
        '<script src="https://a.example/x.js"></script>',
        '<link rel="stylesheet" href="//a.example/x.css">',
        '<img src="http://a.example/x.png">',
        '<p style="background: url(https://a.example/x.png)">',
        "<style>@import 'https://a.example/x.css'</style>",
    ],
)
def test_what_is_loaded_from_elsewhere_is_seen(tmp_path: Path, foreign: str) -> None:
    page = tmp_path / "page.html"
    page.write_text(f'<a href="https://a.example">a link loads nothing</a>{foreign}', encoding="utf-8")
    assert [bool(ELSEWHERE.match(address)) for address in loaded(page)] == [True]


def test_equations_are_mathml(site: Path) -> None:
    for page in PAGES:
        source = page.read_text(encoding="utf-8")
        made = (site / page.relative_to(DOCS / "pages").with_suffix(".html")).read_text(encoding="utf-8")
        assert made.count("<math ") >= source.count("$$") // 2, page
        assert "arithmatex" not in made, page
        assert "merror" not in made, page
        assert not re.search(r"<m[oi]>(?:&amp;|&#x00026;|\\\\)", made), page
    text = (site / "theory" / "yaw.html").read_text(encoding="utf-8")
    for number in ("5", "6", "7", "8", "10", "11", "12", "13", "14", "15"):
        assert f'<span class="number">({number})</span>' in text, number


def test_examples_give_what_the_paper_prints(site: Path) -> None:
    """Outputs in the pages against the paper's numbers, or those that follow from them by hand."""
    expected = {
        # Table 1 at the standard gravity; Fig. 3; Fig. 7.
        "theory/yaw.html": ["1.05629", "4.09", "30.02", "7.34", "1069.9 mm", "1082.9 mm", "1095.6 mm"],
        # Fig. 15.
        "theory/pitch.html": ["2.006", "0.997", "2.37", "1.192", "2.766", "1.272"],
        # Eq. (4) with the numbers of Table 3, and eq. (25).
        "theory/axes.html": ["5.72°", "5.55°", "0.2048"],
        # Pure yaw at finite amplitude, heave included, by quadrature.
        "theory/two-lines.html": ["19 ppm", "76 ppm", "473 ppm", "1211 ppm", "1893 ppm", "4263 ppm"],
    }
    for page, numbers in expected.items():
        text = re.sub(r"<[^>]+>", "", (site / page).read_text(encoding="utf-8"))
        for number in numbers:
            assert number in text, (page, number)


def test_the_tutorial_ends_in_its_report(site: Path) -> None:
    report = (site / "tutorial" / "report.html").read_text(encoding="utf-8")
    assert "Practice dinghy" in report
    assert 'class="sign"' in report


def test_public_names_are_in_the_reference(site: Path) -> None:
    text = "".join(path.read_text(encoding="utf-8") for path in (site / "api").glob("*.html"))
    for name in sorted(set(gyradius.__all__) - {"__version__"}):
        assert re.search(rf'id="gyradius\.\w+\.{name}"|<code>{name}</code>', text), name


def commands(text: str) -> Iterator[str]:
    for language, block in FENCE.findall(text):
        if language in {"console", "bash", "sh"}:
            lines = block.replace("\\\n", " ").splitlines()
            bare = (line.strip().removeprefix("$ ") for line in lines)
            yield from (line for line in bare if line.startswith("gyradius "))


def shown() -> list[Any]:
    found = []
    for page in [*PAGES, README]:
        text = page.read_text(encoding="utf-8")
        found += [pytest.param(line, id=f"{page.stem}: {line[:60]}") for line in commands(text)]
    return found


def refusals(line: str) -> list[str]:
    """What in a line the command would not know."""
    words = shlex.split(line, comments=True)[1:]
    known = typer.main.get_command(app)
    if words[0] in {"--version", "--help", "--install-completion", "--show-completion"}:
        return []
    if words[0] not in known.commands:  # type: ignore[attr-defined]
        return [words[0]]
    command = known.commands[words[0]]  # type: ignore[attr-defined]
    options = {name for one in command.params for name in (*one.opts, *one.secondary_opts)} | {"--help", "-h"}
    given = (word.partition("=")[0] for word in words[1:] if re.match(r"--?[a-z]", word))
    return [word for word in given if word not in options]


@pytest.mark.parametrize("line", shown())
def test_commands_that_are_shown_exist(line: str) -> None:
    assert refusals(line) == []


def test_commands_are_found_and_wrong_ones_seen() -> None:
    lines = list(commands("```console run\n$ gyradius measure x --json -\noutput\n```\n\n```text\ngyradius no\n```\n"))
    assert lines == ["gyradius measure x --json -"]
    assert refusals("gyradius measure x --json -") == []
    assert refusals("gyradius measure x --jsn -") == ["--jsn"]
    assert refusals("gyradius mesure x") == ["mesure"]
    assert refusals("gyradius import a.zip -o b --hull-pitch=-12:0.2") == []
    assert len(shown()) > 20


def test_phyphox_export_keeps_the_samples(tmp_path: Path) -> None:
    """What the tutorial's script packs is what `import` unpacks."""
    (tmp_path / "session").mkdir()
    (tmp_path / "session" / "swing.csv").write_text(swing_csv(), encoding="utf-8")
    script = DOCS / "phyphox_export.py"
    packed = tmp_path / "phone"
    done = subprocess.run(
        [sys.executable, str(script), str(tmp_path / "session"), str(packed)],
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    assert done.stdout.split() == [str(packed / "swing.zip")]
    gyradius.import_files([packed / "swing.zip"], tmp_path / "back", line_length=2.0, spacing=1.0)
    before, after = (
        np.genfromtxt(path, delimiter=",", names=True)
        for path in (tmp_path / "session" / "swing.csv", tmp_path / "back" / "swing.csv")
    )
    assert before.dtype.names == after.dtype.names
    for name in before.dtype.names:
        np.testing.assert_allclose(after[name], before[name], rtol=1e-8, atol=1e-8)
    assert 'phone = "Practice phone"' in (tmp_path / "back" / "session.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs(notebook: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    for number, cell in enumerate(cells):
        assert not cell.get("outputs"), f"cell {number}: outputs are made when it is run, and not kept"
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"{notebook.name}, cell {number}", "exec"), names)
    # The rig's true yaw gyradius is 1.0566 m.
    assert abs(names["k"].value - 1.0566) < 3 * names["k"].u
    assert names["by_hand"]["gyradius_m"] == pytest.approx(1.0566, rel=2e-3)
    assert (tmp_path / "yaw-sway.png").stat().st_size > 10_000


def test_every_page_begins_with_a_paragraph_that_can_stand_alone() -> None:
    for page in PAGES:
        blocks = page.read_text(encoding="utf-8").split("\n\n")
        assert re.match(r"# \S", blocks[0]), page
        assert "\n" not in blocks[0].strip(), page
        assert re.match(r"[A-Z`g]", blocks[1]), page
        assert len(blocks[1]) > 60, page


def test_nothing_of_the_workplace_is_in_the_sources() -> None:
    for path in sorted(DOCS.rglob("*")):
        if path.suffix in {".md", ".py", ".yml", ".toml", ".txt", ".ipynb", ".css", ".svg"}:
            assert not re.search(r"/(?:tmp|work|home|root)/", path.read_text(encoding="utf-8")), path
