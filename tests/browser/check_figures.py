#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_figures.py SETAE FOLDER [SVG...]: every text of every figure lies inside the picture, as Chromium draws it.

Figures: those of a tutorial's study with its loops, of the published study at both widths, of commands that draw, and docs/figures/*.svg;
with SVG only these. Exit code 77 where there is no Chromium.
"""

import glob
import os
import shutil
import subprocess
import sys

from check_report import tutorial_page
from devtools import Browser

TOLERANCE = 0.5  # px
TEXTS_OUTSIDE = """(() => {
  const picture = document.documentElement, all = picture.getBoundingClientRect();
  return [...picture.querySelectorAll('text')].filter(text => text.textContent.trim()).map(text => [text, text.getBoundingClientRect()])
    .filter(([, box]) => box.left < all.left - %(t)s || box.right > all.right + %(t)s || box.top < all.top - %(t)s || box.bottom > all.bottom + %(t)s)
    .map(([text, box]) => `"${text.textContent}" ends at ${box.right.toFixed(0)}, ${box.bottom.toFixed(0)} of ${all.right.toFixed(0)}, ${all.bottom.toFixed(0)}`);
})()""" % {"t": TOLERANCE}


def figures(setae, folder):
    """Draws them; the paths."""
    def run(*arguments, where="."):
        subprocess.run([setae, *arguments], check=True, stdout=subprocess.DEVNULL, cwd=where)

    tutorial = os.path.dirname(tutorial_page(setae, folder))
    run("study", os.path.join(folder, "mine", "adhesion.toml"), "--no-cache", "--progress", "none", "--output", tutorial)
    one = lambda name: os.path.join(folder, name + ".svg")  # noqa: E731
    for width in ("single", "double"):
        for figure in ("1", "4", "hysteresis", "losses", "balances", "budget"):
            run("plot", "examples/nanodiamond/published.toml", "--cache", os.path.join(folder, "cache"), "--progress", "none", "--figure", figure, "--width", width,
                "-o", one(f"published_{figure}_{width}"))
    scan = next(iter(sorted(glob.glob(os.path.join(folder, "mine", "**", "*.x3p"), recursive=True))), None)
    for command in ("psd", "acf", "sdrp", "vbw") if scan else ():
        run(command, scan, "-o", one(command))
    return [*glob.glob(os.path.join(folder, "**", "*.svg"), recursive=True), *glob.glob("docs/figures/*.svg")]


def main():
    setae, folder, *given = sys.argv[1:]
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if not chromium:
        print("skipped: no Chromium; apt-get install chromium")
        return 77
    os.makedirs(folder, exist_ok=True)
    pictures = sorted(given or figures(setae, folder))
    bad = 0
    page = Browser(chromium)
    try:
        for picture in pictures:
            page.open(picture)
            for text in page.run(TEXTS_OUTSIDE):
                bad += 1
                print(f"{picture}: {text}")
    finally:
        page.close()
    print(f"{len(pictures)} figures, {bad} texts outside")
    return bad > 0 or len(pictures) < 10 and not given


if __name__ == "__main__":
    sys.exit(main())
