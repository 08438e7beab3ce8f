#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""look.py FOLDER CACHE: opens every page of the site in a headless Chromium, wide and narrow, light and dark: nothing on the console, nothing asked
of the network, no page wider than its window, nothing that axe-core finds, and a search that finds a word where no server is."""

from __future__ import annotations

import concurrent.futures
import os
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/browser"))
from devtools import Browser
from npm import AXE, script

WINDOWS = ((1366, 900), (390, 844))
SCHEMES = {"light": "default", "dark": "slate"}
COLOURS = ["color-contrast", "link-in-text-block"]  # what a second scheme can change
STILL = "document.head.insertAdjacentHTML('beforeend', '<style>* { transition: none !important }</style>')"
WIDE = "[...document.querySelectorAll('main *')].filter(e => e.getBoundingClientRect().right > innerWidth)"
WIDER = f"{WIDE}.slice(0, 2).map(e => e.outerHTML.slice(0, 120))"
VIOLATIONS = "r.violations.map(v => `${v.id} × ${v.nodes.length}: ${v.nodes[0].html.slice(0, 160)}`)"


def looked_at(browser: Browser, path: pathlib.Path, width: int, axe: str) -> list[str]:
    """What is wrong with a page at one width."""
    found = []
    for scheme, name in SCHEMES.items():
        browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        if scheme == "light":
            browser.open(path)
            found += [f"the console says {line}" for line in browser.console[:2]]
            found += [f"asks for {url}" for url in browser.requests if not url.startswith(("file:", "data:", "blob:"))][:2]
            if browser.run("document.documentElement.scrollWidth > innerWidth"):
                found.append(f"wider than the window: {browser.run(WIDER)}")
            browser.run(f"{axe}; {STILL}")
        browser.frames(2)
        if browser.run("document.body.dataset.mdColorScheme") != name:
            found.append(f"is not {scheme} where the system is")
        rules = "undefined" if scheme == "light" else str(COLOURS)
        found += browser.run(
            f"axe.run(document, {{resultTypes: ['violations'], preload: false, runOnly: {rules}}}).then(r => {VIOLATIONS})"
        )
    return [f"{width} px: {problem}" for problem in found]


def look(program: str, paths: list[pathlib.Path], axe: str) -> dict[pathlib.Path, list[str]]:
    found: dict[pathlib.Path, list[str]] = {path: [] for path in paths}
    browser = Browser(program)
    try:
        for width, height in WINDOWS:
            browser.resize(width, height)
            for path in paths:
                found[path] += looked_at(browser, path, width, axe)
    finally:
        browser.close()
    return found


def search(program: str, top: pathlib.Path) -> list[str]:
    """Opened as a file, the site finds a word."""
    browser = Browser(program)
    try:
        browser.open(top / "index.html")
        browser.run("document.querySelector('[data-md-toggle=search]').click()")
        browser.run("document.querySelector('.md-search__input').focus()")
        browser.run("document.activeElement.value = 'maugis'; document.activeElement.dispatchEvent(new Event('keyup'))")
        shown = "document.querySelectorAll('.md-search-result__item').length"
        browser.run(f"new Promise(done => {{ const look = n => {shown} || n === 0 ? done(0) : setTimeout(look, 100, n - 1); look(100); }})")
        return [] if browser.run(shown) else ["search finds nothing"]
    finally:
        browser.close()


def main(top: pathlib.Path, cache: str) -> int:
    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if not program:
        raise SystemExit("the pages cannot be looked at without Chromium: apt-get install chromium")
    axe = script(AXE, cache)
    pages = [path for path in sorted(top.rglob("*.html")) if path.name != "404.html"]  # that one is a server's, its links begin at the top
    workers = os.cpu_count() or 1
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        parts = list(pool.map(lambda n: look(program, pages[n::workers], axe), range(workers)))
    problems = [f"{path.relative_to(top)}: {problem}" for part in parts for path, found in part.items() for problem in found]
    problems += search(program, top)
    print("\n".join(problems) or f"{len(pages)} pages looked at")
    return 1 if problems or not pages else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]))
