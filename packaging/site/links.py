#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""links.py FOLDER: every link and picture of the pages in a folder leads to a file in it, and to the place in a page that it names."""

from __future__ import annotations

import functools
import html.parser
import pathlib
import sys
import urllib.parse

LINKS = {"a": "href", "link": "href", "img": "src", "script": "src", "object": "data", "source": "src", "iframe": "src"}


class Page(html.parser.HTMLParser):
    """What a page links to, and the places that can be linked to."""

    def __init__(self, path: pathlib.Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.places: list[str] = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        link = given.get(LINKS.get(tag, ""))
        if link is not None:
            self.links.append(link)
        place = given.get("id") or (given.get("name") if tag == "a" else None)
        if place:
            self.places.append(place)


page_of = functools.cache(Page)


def problems(path: pathlib.Path, top: pathlib.Path) -> set[str]:
    page, found = page_of(path), set()
    for link in page.links:
        parts = urllib.parse.urlsplit(link)
        if parts.scheme in ("http", "https", "mailto", "data"):
            continue
        file = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
        place = urllib.parse.unquote(parts.fragment)
        if file.is_dir():
            file /= "index.html"
        if not file.is_file() or top not in file.parents:
            found.add(f"{link}: no such file")
        elif place and not place.startswith("__") and file.suffix == ".html" and place not in page_of(file).places:
            found.add(f"{link}: no such place")
    return found | {f"#{place}: stands twice" for place in page.places if page.places.count(place) > 1}


def main(top: pathlib.Path) -> int:
    pages = [path for path in sorted(top.rglob("*.html")) if path.name != "404.html"]
    lost = [f"{path.relative_to(top)}: {problem}" for path in pages for problem in sorted(problems(path, top))]
    print("\n".join(lost) or f"{len(pages)} pages, {sum(len(page_of(path).links) for path in pages)} links")
    return 1 if lost or not pages else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
