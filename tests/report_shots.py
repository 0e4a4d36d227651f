"""The reports as a browser shows them, at desktop and phone width: pictures to look at before a release.

    tests/report_shots.py build/demo build/shots

Takes every HTML file of the first folder. Needs a Chromium on the path; says so and does nothing where there is none.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
# Widths in CSS pixels; the heights hold a whole report, what lies below its end is white.
SIZES = {"desktop": (1200, 9000), "phone": (360, 16000)}
# No browser window is narrower: a phone is a frame in it.
NARROWEST = 500
FRAME = '<body style="margin:0"><iframe src="{}" style="border:0;width:{}px;height:{}px"></iframe></body>'
SECONDS = 120


def main(arguments: list[str]) -> int:
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    reports, shots = Path(arguments[0]), Path(arguments[1])
    pages = sorted(reports.glob("**/*.html"))
    if not pages:
        print(f"no HTML report in {reports}", file=sys.stderr)
        return 1
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        print(f"SKIPPED: no Chromium on the path ({', '.join(BROWSERS)}); reports are in {reports}")
        return 0
    shots.mkdir(parents=True, exist_ok=True)
    failed = [name for page in pages for name in shoot(browser, page, reports, shots)]
    return 1 if failed else 0


def shoot(browser: str, page: Path, reports: Path, shots: Path) -> list[str]:
    """Takes one page at each width and on paper; answers what failed."""
    stem = "-".join(page.relative_to(reports).with_suffix("").parts)
    address = page.resolve().as_uri()
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for name, (width, height) in SIZES.items():
            frame = Path(folder) / f"{name}.html"
            frame.write_text(FRAME.format(address, width, height), encoding="utf-8")
            target = shots / f"{stem}-{name}.png"
            size = f"--window-size={max(width, NARROWEST)},{height}"
            options = [f"--screenshot={target.resolve()}", size, "--hide-scrollbars"]
            failed += run(browser, options, frame.as_uri(), target)
    paper = shots / f"{stem}-paper.pdf"
    failed += run(browser, [f"--print-to-pdf={paper.resolve()}", "--no-pdf-header-footer"], address, paper)
    return failed


def run(browser: str, options: list[str], address: str, target: Path) -> list[str]:
    # A profile of its own, so that a browser that is open does not take the page over.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        fixed = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}"]
        try:
            subprocess.run(
                [browser, *fixed, *options, address],
                check=True,
                timeout=SECONDS,
                capture_output=True,
            )
        except (subprocess.SubprocessError, OSError) as error:
            print(f"{target}: {error}", file=sys.stderr)
            return [str(target)]
    if not target.exists():
        print(f"{target}: the browser wrote nothing", file=sys.stderr)
        return [str(target)]
    print(target)
    return []


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
