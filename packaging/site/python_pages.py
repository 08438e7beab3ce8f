#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""python_pages.py FOLDER: a page for each module of the Python package, with the names that setae.__all__ has of it; mkdocstrings fills them."""

from __future__ import annotations

import ast
import pathlib
import re
import sys

PACKAGE = pathlib.Path("python/setae")


def public() -> dict[str, list[str]]:
    """Names by module, as __init__.py imports them; what it makes itself stands with the library's."""
    tree = ast.parse((PACKAGE / "__init__.py").read_text())
    names = next(
        ast.literal_eval(line.value) for line in tree.body if isinstance(line, ast.Assign) and ast.unparse(line.targets[0]) == "__all__"
    )
    imports = [line for line in tree.body if isinstance(line, ast.ImportFrom) and line.level == 1]
    found = {line.module: [name.name for name in line.names if name.name in names] for line in imports if line.module}
    found |= {name.name: [name.name] for line in imports if not line.module for name in line.names if name.name in names}
    found["_about"] += sorted(set(names) - {name for those in found.values() for name in those})
    return {module: listed for module, listed in found.items() if listed}


def says(module: str) -> str:
    """The first line of a module's docstring."""
    source = PACKAGE / f"{module}.py"
    docstring = ast.get_docstring(ast.parse(source.read_text())) if source.exists() else None
    return (docstring or "Functions of the compiled library.").partition("\n")[0]


def kinds_of_arguments() -> dict[str, str]:
    """Names in signatures that are short for others, and the comment above them."""
    sources = "\n".join(path.read_text() for path in sorted(PACKAGE.glob("*.py")))
    return {name: said for said, name in re.findall(r"^#: (.*)\n(\w+) = ", sources, re.M)}


def main(folder: pathlib.Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    index = "# Python reference\n\nWhat `import setae` gives. How it is used: [setae in Python](../docs/guides/python.md).\n\n"
    index += "| page | names |\n|---|---|\n"
    for module, names in public().items():
        title = module.removeprefix("_").replace("_", " ").capitalize() if module != "_about" else "Library"
        functions_first = sorted(names, key=lambda name: name[0].isupper())
        page = f"# {title}\n\n{says(module)}\n\n" + "".join(f"::: setae.{name}\n\n" for name in functions_first)
        file = title.lower().replace(" ", "_") + ".md"
        (folder / file).write_text(page)
        index += f"| [{title}]({file}) | {', '.join(f'[`{name}`][setae.{name}]' for name in functions_first)} |\n"
    index += "\nIn signatures these stand for:\n\n| name | what it is |\n|---|---|\n"
    index += "".join(f"| `{name}` | {said} |\n" for name, said in kinds_of_arguments().items())
    (folder / "index.md").write_text(index)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
