# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages as MkDocs reads them: notebooks as pages, the list of all of them, blocks without the words that the tests read behind a fence."""

from __future__ import annotations

import pathlib
import posixpath
import re
import sys
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "tests/browser"))
from npm import IFRAME_WORKER, script

sys.path.insert(0, str(TOP / "packaging/site"))
from formulas import FONT, fence

SECTIONS = {  # in the order of the tabs, with their folders
    "Start": "docs/start/",
    "Guides": "docs/guides/",
    "Concepts": "docs/concepts/",
    "Reference": "docs/reference/",
    "Validation": "docs/validation/",
    "Notebooks": "docs/notebooks/",
    "Python": "python/",
    "C++": "cpp/",
    "Gallery": "gallery/",
    "Development": "docs/development/",
}
FIRST = ["README.md", "docs/README.md"]


def notebook_page(name: str, notebook: str) -> str:
    """A notebook's cells of text and of code as a page."""
    page = ""
    for cell in re.split(r"^# %%", notebook, flags=re.M)[1:]:
        kind, _, body = cell.partition("\n")
        if "[markdown]" in kind:
            page += re.sub(r"^# ?", "", body, flags=re.M).strip() + "\n\n"
        else:
            page += f"```python\n{body.strip()}\n```\n\n"
    title, _, rest = page.partition("\n")
    return f"{title}\n\n[The notebook]({name}) as a file: Jupyter opens it with jupytext, Python runs it.\n{rest}"


def links(files: Files, page: str) -> list[str]:
    """Pages that a page leads to, from the top."""
    file = files.get_file_from_path(page)
    assert file
    folder = page.rpartition("/")[0]
    return [posixpath.normpath(posixpath.join(folder, link)) for link in re.findall(r"\]\(([^()#:]+)", as_page(file.content_string))]


def is_index(page: str) -> bool:
    return page.endswith(("/README.md", "/index.md"))


def section(pages: list[str], folder: str) -> list[Any]:
    """Pages of a folder, and sections of the folders in it."""
    own = [page for page in pages if "/" not in page.removeprefix(folder)]
    rooms = sorted({page.removeprefix(folder).partition("/")[0] for page in pages if page not in own})
    return own + [
        {room.capitalize(): section([page for page in pages if page.startswith(f"{folder}{room}/")], f"{folder}{room}/")} for room in rooms
    ]


def navigation(pages: list[str], listed: list[str]) -> list[Any]:
    """Sections with their pages: a folder's own first page, then as they are listed, then by name."""
    pages = sorted(pages, key=lambda page: (not is_index(page), listed.index(page) if page in listed else len(listed), page))
    sections = {name: section([page for page in pages if page.startswith(folder)], folder) for name, folder in SECTIONS.items()}
    others = [page for page in pages if page not in FIRST and not page.startswith(tuple(SECTIONS.values()))]
    return [{"setae": FIRST + others}, *({name: found} for name, found in sections.items() if found)]


def on_config(config: MkDocsConfig, **_: Any) -> MkDocsConfig:
    """Blocks ```math are formulas."""
    config.mdx_configs.setdefault("pymdownx.superfences", {})["custom_fences"] = [{"name": "math", "class": "formula", "format": fence}]
    return config


def on_files(files: Files, config: MkDocsConfig, **_: Any) -> Files:
    for file in [file for file in files if file.src_uri.startswith("docs/notebooks/")]:
        page = notebook_page(file.name + ".py", file.content_string)
        files.append(File.generated(config, file.src_uri.replace(".py", ".md"), content=page))
    files.append(File.generated(config, f"assets/{FONT.name}", abs_src_path=str(FONT)))
    files.append(File.generated(config, "assets/iframe-worker.js", content=script(IFRAME_WORKER, TOP / "build/_deps")))
    pages = [file.src_uri for file in files.documentation_pages()]
    listing = ["docs/README.md", *filter(is_index, pages)]
    config.nav = navigation(pages, [link for page in listing for link in links(files, page)])
    return files


def as_page(markdown: str) -> str:
    """Links to notebooks lead to their pages, links to sources, which the site does not contain, become their words; a block keeps only
    its language after its fence."""
    markdown = re.sub(r"(notebooks/[\w-]+)\.py\)", r"\1.md)", markdown)
    markdown = re.sub(r"\[([^\[\]]+)\]\((?:\.\./)*(?:src|lab|apps|python|tests|tools)/[^()\s]*\)", r"\1", markdown)
    return re.sub(r"^(\s*```\w+) .*$", r"\1", markdown, flags=re.M)


def without_tags(markdown: str) -> str:
    """Outside code < is less than, and <z> a mean: documents hold no tags but comments."""
    return re.sub(r"(^```.*?^```|^ {4}[^\n]*|`(?:[^`\n]|\n(?!\n))*`|<!--)|<", lambda found: found[1] or "&lt;", markdown, flags=re.M | re.S)


NUMBERED = re.compile(r"^```(?s:.*?)^```|^\d+\. .*(?:\n(?:(?:\d+\.)? .*|(?=\n)))*", re.M)


def deep_items(found: re.Match[str]) -> str:
    """A numbered list as Python-Markdown expects it: lines of an item begin with four blanks, three in the documents, and an item after a
    paragraph of another begins after an empty line."""
    if found[0].startswith("`"):
        return found[0]
    deep = re.sub(r"^ {3}", " " * 4, found[0], flags=re.M)
    return re.sub(r"\n(?=\d+\. )", "\n\n", deep) if "\n\n    " in deep else deep


def on_page_markdown(markdown: str, page: Page, **_: Any) -> str:
    return as_page(markdown if page.file.src_uri.startswith("cpp/") else NUMBERED.sub(deep_items, without_tags(markdown)))


def on_page_content(html: str, **_: Any) -> str:
    """The corner of a table that names nothing is no heading."""
    return html.replace("<th></th>", "<td></td>")


def on_post_page(output: str, **_: Any) -> str:
    """The theme leaves its search without a name."""
    return output.replace('data-md-component="search" role="dialog"', 'data-md-component="search" role="dialog" aria-label="Search"')
