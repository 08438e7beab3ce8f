# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages as MkDocs reads them: notebooks as pages, the list of all of them, blocks without the words that the tests read behind a fence."""

from __future__ import annotations

import re
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

SECTIONS = {  # in the order of the tabs; a page belongs to the first whose folder it lies in
    "Tutorials": "docs/tutorials/",
    "Guides": "docs/guides/",
    "Theory": "docs/theory/",
    "Measured": "docs/measured/",
    "Reference": "docs/reference/",
    "Notebooks": "docs/notebooks/",
    "Python": "python/",
    "C++": "cpp/",
    "Gallery": "gallery/",
    "Decisions": "docs/adr/",
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


def order(page: str, listed: list[str]) -> tuple[bool, int, str]:
    """A section's own first page, then as docs/README.md lists them, then by name."""
    index = page.endswith(("/README.md", "/index.md"))
    return (not index, listed.index(page) if page in listed else len(listed), page)


def navigation(pages: list[str], listed: list[str]) -> list[Any]:
    rest = sorted((page for page in pages if page not in FIRST), key=lambda page: order(page, listed))
    sections: dict[str, list[Any]] = {"setae": [*FIRST], **{name: [] for name in SECTIONS}}
    for page in rest:
        name = next((name for name, folder in SECTIONS.items() if page.startswith(folder)), "setae")
        sections[name].append(page)
    return [{name: pages} for name, pages in sections.items() if pages]


def on_files(files: Files, config: MkDocsConfig, **_: Any) -> Files:
    for file in [file for file in files if file.src_uri.startswith("docs/notebooks/")]:
        page = notebook_page(file.name + ".py", file.content_string)
        files.append(File.generated(config, file.src_uri.replace(".py", ".md"), content=page))
    top = files.get_file_from_path("docs/README.md")
    assert top
    listed = ["docs/" + link for link in re.findall(r"\]\(([^()#:]+)", as_page(top.content_string))]
    config.nav = navigation([file.src_uri for file in files.documentation_pages()], listed)
    return files


def as_page(markdown: str) -> str:
    """Links to notebooks lead to their pages; a block's language alone stands behind its fence."""
    markdown = re.sub(r"(notebooks/[\w-]+)\.py\)", r"\1.md)", markdown)
    return re.sub(r"^(\s*```\w+) .*$", r"\1", markdown, flags=re.M)


def on_page_markdown(markdown: str, **_: Any) -> str:
    return as_page(markdown)
