#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""readme_pictures.py SETAE: draws the three pictures of README.md into docs/figures, each of at most 150 kB: the spectrum of the tutorial's
rougher surface, figure 4 of the published study, and the top of the tutorial's report (in Chromium). Needs gnuplot, which SETAE calls."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TOP / "tests/browser"))
from devtools import Browser  # noqa: E402

PICTURES = TOP / "docs/figures"
MAX_BYTES = 150_000


def picture_of_report(report, picture):
    """The top of a report, its figures drawn, without the bar that scrolls."""
    page = Browser(shutil.which("chromium"), 1200, 1022)
    try:
        page.open(report)
        page.run("document.documentElement.style.scrollbarWidth = 'none'")
        page.run("(async () => { for (const s of document.querySelectorAll('section.figure')) { s.scrollIntoView();"
                 " await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))); } scrollTo(0, 0); })()")
        page.frames(5)
        page.picture(picture)
    finally:
        page.close()


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    study = re.search(r"```toml file=mine/adhesion.toml\n(.*?)```", (TOP / "docs/start/from-files-to-the-figure.md").read_text(encoding="utf-8"), re.S)[1]
    with tempfile.TemporaryDirectory() as folder:

        def setae(*words):
            subprocess.run([program, *map(str, words)], cwd=folder, check=True, stdout=subprocess.DEVNULL)

        setae("lab", "make", TOP / "examples/tutorial/recipe.toml", "-o", "mine")
        (pathlib.Path(folder) / "mine/adhesion.toml").write_text(study, encoding="utf-8")
        setae("study", "mine/adhesion.toml", "--no-figures", "--progress", "none")
        setae("plot", "mine/adhesion.toml", "--figure", "spectra:rougher", "--width", "single", "-o", PICTURES / "readme_spectrum.png")
        setae("plot", TOP / "examples/nanodiamond/published.toml", "--figure", "4", "-o", PICTURES / "readme_published.png")
        picture_of_report(f"{folder}/mine/adhesion_results/report.html", PICTURES / "readme_report.png")
    sizes = {path.name: path.stat().st_size for path in sorted(PICTURES.glob("readme_*.png"))}
    print("\n".join(f"{name}: {size} bytes" for name, size in sizes.items()))
    return int(max(sizes.values()) > MAX_BYTES)


if __name__ == "__main__":
    sys.exit(main())
