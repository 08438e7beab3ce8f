#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""gallery.py PROGRAM FOLDER: every figure that `setae plot` draws of two studies of the examples, on a page with the commands that draw them."""

from __future__ import annotations

import json
import pathlib
import subprocess
import sys


def run(*command: object) -> str:
    return subprocess.run([*map(str, command)], check=True, capture_output=True, text=True).stdout


def drawn(program: str, study: pathlib.Path, shown: str, folder: pathlib.Path) -> str:
    """A section of the page; its figures lie in the folder. shown: the study as the reader names it."""
    page = ""
    for figure in json.loads(run(program, "plot", study, "--list", "--json"))["figures"]:
        if not figure["drawable"]:
            continue
        name = f"{study.stem}_{figure['identifier'].replace(':', '_')}.svg"
        run(program, "plot", study, "--figure", figure["identifier"], "-o", folder / name)
        title, command = figure["title"], f"setae plot {shown} --figure {figure['identifier']}"
        page += f"### {title}\n\n```\n{command}\n```\n\n![{title}]({name})\n\n{figure['caption']}\n\n"
    return page


def main(program: str, folder: pathlib.Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    published = pathlib.Path("examples/nanodiamond/published.toml")
    made = folder.parent.parent / "generated"  # beside the documents, of which it is no part
    run(program, "lab", "make", "examples/tutorial/recipe.toml", "-o", made)
    page = "# Gallery\n\nEvery figure that `setae plot` draws of two studies.\n\n## Nanodiamond and PDMS\n\n"
    page += drawn(program, published, str(published), folder)
    page += "## Generated measurements\n\n```\nsetae lab make examples/tutorial/recipe.toml -o mine\n```\n\n"
    page += drawn(program, made / "study.toml", "mine/study.toml", folder)
    (folder / "index.md").write_text(page)


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
