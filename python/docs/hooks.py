"""What MkDocs calls while it builds the site: examples are run, equations set, files from elsewhere taken in."""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(HERE.parent)]
# Pictures are saved, never shown.
os.environ.setdefault("MPLBACKEND", "agg")

from equations import set_equations  # noqa: E402
from examples import ExampleError, Examples  # noqa: E402
from inserted import MissingError, insert  # noqa: E402

# Pictures and files that lie elsewhere, by their place in the site.
TAKEN = {
    "gallery/": sorted((ROOT / "core" / "docs" / "gallery").glob("*.png")),
    "notebooks/": sorted((HERE / "notebooks").glob("*.ipynb")),
    "images/": [ROOT / "python" / "first-picture.png"],
    "tutorial/": [HERE / "first-session.toml", HERE / "phyphox_export.py"],
}
# What examples make and pages may show.
MADE = {".html", ".png"}
_filled: dict[str, str] = {}


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Take in what lies elsewhere, and run the examples of every page: their files are part of the site."""
    for folder, sources in TAKEN.items():
        for source in sources:
            files.append(File.generated(config, folder + source.name, abs_src_path=str(source)))
    _filled.clear()
    for file in files.documentation_pages():
        _fill(file, files, config)
    return files


def _fill(file: File, files: Files, config: MkDocsConfig) -> None:
    with tempfile.TemporaryDirectory() as folder:
        try:
            _filled[file.src_uri] = Examples(file.src_uri, Path(folder)).fill(insert(file.content_string))
        except (ExampleError, MissingError) as error:
            raise PluginError(f"{file.src_uri}: {error}") from error
        for made in sorted(path for path in Path(folder).iterdir() if path.suffix in MADE):
            place = f"{Path(file.src_uri).with_suffix('').as_posix()}/{made.name}"
            files.append(File.generated(config, place, content=made.read_bytes()))


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """The page with the output of its examples."""
    return _filled[page.file.src_uri]


def on_post_build(config: MkDocsConfig) -> None:
    """Take out of the theme's script what it would fetch elsewhere: diagrams, and help for browsers of before 2020."""
    for script in sorted(Path(config.site_dir).glob("assets/javascripts/bundle.*.js")):
        text = script.read_text(encoding="utf-8")
        script.write_text(text.replace("https://unpkg.com/", "data:text/javascript,//"), encoding="utf-8")


def on_page_content(html: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """The page with its equations as MathML."""
    return set_equations(html)
