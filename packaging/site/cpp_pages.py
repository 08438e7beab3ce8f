#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cpp_pages.py FOLDER: what public headers declare and say, a page for each module, as Doxygen reads them. A warning of Doxygen's is an error."""

from __future__ import annotations

import functools
import html
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

# Comments are plain text, but for commands such as @throws, and lines that are set in: those are formulas.
SETTINGS = r"""
INPUT_FILTER = "sed 's,^\( *///\)   \(.*\),\1 @verbatim \2 @endverbatim,'"
MARKDOWN_SUPPORT = NO
AUTOLINK_SUPPORT = NO
EXTRACT_ALL = YES
BUILTIN_STL_SUPPORT = YES
INCLUDE_GRAPH = NO
INCLUDED_BY_GRAPH = NO
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
WARN_IF_INCOMPLETE_DOC = NO
WARN_AS_ERROR = FAIL_ON_WARNINGS
"""
WIDTH = 92  # of a signature; a longer one has a line for each argument
SIGNS = {"ndash": "–", "mdash": "—", "linebreak": " ", "zwj": ""}
SECTIONS = {"exception": "Throws", "return": "Returns", "param": "Arguments"}


def compounds(headers: list[pathlib.Path]) -> list[xml.Element]:
    """Namespaces and classes as Doxygen writes them."""
    with tempfile.TemporaryDirectory() as folder:
        settings = f"{SETTINGS}OUTPUT_DIRECTORY = {folder}\nINPUT = {' '.join(map(str, headers))}\n"
        if subprocess.run(["doxygen", "-"], input=settings, text=True).returncode:
            raise SystemExit("Doxygen cannot read what headers say, see above")
        written = [xml.parse(path).getroot()[0] for path in sorted(pathlib.Path(folder, "xml").glob("*.xml")) if path.stem != "index"]
    return [compound for compound in written if compound.get("kind") in ("namespace", "struct", "class")]


def plain(element: xml.Element | None) -> str:
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def place(element: xml.Element) -> tuple[str, int]:
    """Header and line."""
    at = element.find("location")
    return ("", 0) if at is None else (at.get("file", ""), int(at.get("line", 0)))


def described(element: xml.Element) -> bool:
    return bool(plain(element.find("briefdescription")) or plain(element.find("detaileddescription")))


class Entity:
    """What stands in a header by itself: a class, an enumeration, functions of one name, constants."""

    def __init__(self, element: xml.Element) -> None:
        self.elements = [element]
        self.header, self.line = place(element)
        self.is_class = element.get("kind") in ("struct", "class")
        self.is_type = self.is_class or element.get("kind") == "enum"
        self.name = plain(element.find("compoundname" if self.is_class else "qualifiedname")).removeprefix("setae::")
        self.anchor = re.sub(r"\W+", "-", self.name).strip("-")

    @property
    def module(self) -> str:
        folder = pathlib.Path(self.header.split("/include/")[0])
        return module_of(folder.parent if folder.name == "mpi" else folder)  # what needs MPI is shown with its module

    @property
    def shown(self) -> str:
        namespace = self.header.split("/include/setae/")[1].split("/")[0]
        return self.name.removeprefix(namespace + "::")

    def goes_with(self, other: Entity) -> bool:
        """An overload, or one more of several without a word."""
        if self.header != other.header or self.is_type or other.is_type:
            return False
        return self.name == other.name or not any(map(described, self.elements + other.elements))

    def identifiers(self) -> list[str]:
        own = self.elements if not self.is_class else [*self.elements, *self.elements[0].iter("memberdef")]
        return [element.get("id", "") for element in own]


def entities(found: list[xml.Element]) -> list[Entity]:
    """In the order of the headers' lines."""
    declared: dict[str, xml.Element] = {}  # by identifier: Doxygen repeats functions
    for compound in found:
        if compound.get("kind") == "namespace":
            declared.update({member.get("id", ""): member for member in compound.iter("memberdef")})
        elif compound.get("prot") == "public":
            declared[compound.get("id", "")] = compound
    together: list[Entity] = []
    for entity in sorted(map(Entity, declared.values()), key=lambda entity: (entity.header, entity.line)):
        if together and entity.goes_with(together[-1]):
            together[-1].elements += entity.elements
        else:
            together.append(entity)
    return together


def paragraphs(line: str) -> list[str]:
    """Names between backticks are code; where something is from and what it costs begins a line."""
    line = re.sub(r"`([^`]+)`", r"<code>\1</code>", line)
    return [f"<p>{part.strip()}</p>" for part in re.split(r"\s(?=(?:Sources?|Cost):)", line) if part.strip()]


class Writer:
    """Doxygen's elements as HTML, with links between the pages."""

    def __init__(self, known: list[Entity]) -> None:
        taken: set[tuple[str, str]] = set()
        self.target: dict[str, str] = {}
        self.exceptions: dict[str, str] = {}
        for entity in known:
            names = itertools.chain([entity.anchor], (f"{entity.anchor}-{number}" for number in itertools.count(2)))
            entity.anchor = next(name for name in names if (entity.module, name) not in taken)
            taken.add((entity.module, entity.anchor))
            if entity.is_class and entity.header.endswith("/errors.hpp"):
                self.exceptions[entity.name] = f"{entity.module}.html#{entity.anchor}"
            self.target.update(dict.fromkeys(entity.identifiers(), f"{entity.module}.html#{entity.anchor}"))

    def inside(self, element: xml.Element) -> str:
        return html.escape(element.text or "") + "".join(self.tagged(child) + html.escape(child.tail or "") for child in element)

    def tagged(self, element: xml.Element) -> str:
        tag, inside = element.tag, self.inside(element)
        if tag in SIGNS:
            return SIGNS[tag]
        if tag == "ref":
            return self.linked(element, inside)
        if tag == "ulink":
            return f'<a href="{html.escape(element.get("url", ""))}">{inside}</a>'
        raise ValueError(f"a comment holds <{tag}>, of which pages know nothing: {plain(element)}")

    def linked(self, element: xml.Element, inside: str) -> str:
        target = self.target.get(element.get("refid", ""))
        return f'<a href="{target}">{inside}</a>' if target else inside

    def named(self, name: str) -> str:
        """With a link where it is setae's: an exception."""
        word = name.rstrip(";,.")
        return f'<a href="{self.exceptions[word]}">{word}</a>{name.removeprefix(word)}' if word in self.exceptions else html.escape(name)

    def said(self, element: xml.Element) -> str:
        """What the comment says, as paragraphs and formulas."""
        paras = [para for name in ("briefdescription", "detaileddescription") for para in element.iterfind(f"{name}/para")]
        return "\n".join(block for para in paras for block in self.blocks(para)).replace("</code></pre>\n<pre><code>", "\n")

    def blocks(self, para: xml.Element, lead: str = "") -> list[str]:
        """A paragraph of Doxygen's holds formulas and sections such as @throws, too."""
        found, line = [], lead + html.escape(para.text or "")
        for child in para:
            if child.tag in ("verbatim", "simplesect", "parameterlist"):
                found += [*paragraphs(line), *self.section(child)]
                line = html.escape(child.tail or "")
            else:
                line += self.tagged(child) + html.escape(child.tail or "")
        return [*found, *paragraphs(line)]

    def section(self, element: xml.Element) -> list[str]:
        if element.tag == "verbatim":
            return [f"<pre><code>{self.inside(element).strip()}</code></pre>"]
        lead, items = f"<strong>{SECTIONS[element.get('kind', '')]}</strong> ", [element] if element.tag == "simplesect" else list(element)
        found = []
        for item in items:
            names = ", ".join(self.named(plain(name)) for name in item.iter("parametername"))
            found += [block for para in item.iter("para") for block in self.blocks(para, lead + names + " ")]
        return found

    def signature(self, element: xml.Element) -> str:
        """A declaration as the header has it, with links, in lines that are not too long."""
        kind = element.get("kind")
        if kind in ("struct", "class"):
            bases = ", ".join(self.linked(base, self.inside(base).replace("setae::", "")) for base in element.iterfind("basecompoundref"))
            return (
                self.template(element)
                + f"{kind} {plain(element.find('compoundname')).rpartition('::')[2]}"
                + (f" : {bases}" if bases else "")
            )
        name = plain(element.find("name"))
        if kind == "enum":
            return ("enum class " if element.get("strong") == "yes" else "enum ") + name
        if kind == "typedef":
            return f"{self.template(element)}using {name} = {self.part(element, 'type')}"
        start = self.template(element) + " ".join(filter(None, [self.part(element, "type"), html.escape(name)]))
        if kind == "variable":
            return " ".join(filter(None, [start, self.part(element, "initializer")]))
        arguments = [self.argument(param) for param in element.iterfind("param")]
        tail = html.escape(plain(element.find("argsstring")).rpartition(")")[2])
        line = f"{start}({', '.join(arguments)}){tail}"
        if len(re.sub(r"<[^>]*>", "", line)) > WIDTH:
            line = f"{start}(\n    " + ",\n    ".join(arguments) + f"){tail}"
        return line

    def part(self, element: xml.Element, name: str) -> str:
        found = element.find(name)
        line = " ".join(self.inside(found).split()) if found is not None else ""
        for spaced, tight in (("&lt; ", "&lt;"), (" &gt;", "&gt;"), (" &amp;", "&amp;"), (" *", "*")):
            line = line.replace(spaced, tight)
        return line

    def argument(self, param: xml.Element) -> str:
        name, default = self.part(param, "declname") + self.part(param, "array"), self.part(param, "defval")
        return " ".join(filter(None, [self.part(param, "type"), name, f"= {default}" if default else ""]))

    def template(self, element: xml.Element) -> str:
        given = element.find("templateparamlist")
        return f"template &lt;{', '.join(self.argument(param) for param in given)}&gt;\n" if given is not None else ""

    def entity(self, entity: Entity) -> str:
        """Its declarations with what is said of them; what has nothing said of it stands with the one before."""
        groups: list[list[xml.Element]] = []
        for element in entity.elements:
            if groups and not described(element):
                groups[-1].append(element)
            else:
                groups.append([element])
        has_heading = entity.is_type or described(entity.elements[0])
        lines = [f"### `{entity.shown}` {{#{entity.anchor}}}"] if has_heading else [f'<span id="{entity.anchor}"></span>']
        lines += [self.declared(group) for group in groups]
        if entity.is_type:
            lines += self.members(entity.elements[0])
        return "\n\n".join(lines)

    def declared(self, elements: list[xml.Element]) -> str:
        return f'<pre class="declared"><code>{chr(10).join(map(self.signature, elements))}</code></pre>\n{self.said(elements[0])}'.rstrip()

    def members(self, element: xml.Element) -> list[str]:
        if element.get("kind") == "enum":
            return [table("value", [(plain(value.find("name")), self.said(value)) for value in element.iterfind("enumvalue")])]
        public = [
            member
            for member in element.iter("memberdef")
            if member.get("prot") == "public" and member.get("kind") not in ("enum", "typedef")
        ]
        fields = [member for member in public if member.get("kind") == "variable"]
        functions = [self.declared([member]) for member in public if member not in fields]
        if not any(map(described, fields)):
            return ([self.declared(fields)] if fields else []) + functions
        return [table("member", [(self.signature(field), self.said(field)) for field in fields]), *functions]


def table(what: str, rows: list[tuple[str, str]]) -> str:
    """Names with what they are; the full stop behind some is Doxygen's."""
    lines = "\n".join(f"<tr><td><code>{name}</code></td><td>{re.sub('[.]</p>$', '</p>', said)}</td></tr>" for name, said in rows)
    return f"<table>\n<thead><tr><th>{what}</th><th>what it is</th></tr></thead>\n<tbody>\n{lines}\n</tbody>\n</table>"


@functools.cache
def module_of(folder: pathlib.Path) -> str:
    """Name of the module in a folder, as its CMakeLists.txt gives it; empty where there is none."""
    name = re.search(r"^setae_module\((\w+)", (folder / "CMakeLists.txt").read_text(), re.M)
    return name[1] if name else ""


def modules() -> dict[str, str]:
    """Meaning of each module by its name, in their order: the comment of its CMakeLists.txt."""
    folders = re.search(r"foreach\(module(.*?)\)", pathlib.Path("src/CMakeLists.txt").read_text(), re.S)
    assert folders
    found = {}
    for folder in (pathlib.Path("src", name) for name in folders[1].split()):
        comment = re.match(r"# SPDX.*\n((?:(?:#.*|include.*)\n)+)", (folder / "CMakeLists.txt").read_text())
        assert comment
        lines = [line.removeprefix("# ") for line in comment[1].splitlines() if line.startswith("#")]
        found[module_of(folder)] = " ".join(lines)
    return found


def page(module: str, said: str, entities: list[Entity], namespaces: list[xml.Element], writer: Writer) -> str:
    parts = [f"# setae::{module}", f"{said[:1].upper()}{said[1:]}."]
    for header, of_header in itertools.groupby(entities, key=lambda entity: entity.header):
        parts.append(f"## {header.split('/include/')[1]}")
        parts += [writer.said(namespace) for namespace in namespaces if described(namespace) and place(namespace)[0] == header]
        parts += map(writer.entity, of_header)
    return "\n\n".join(parts) + "\n"


def main(folder: pathlib.Path) -> None:
    found = compounds(sorted(path for path in pathlib.Path("src").rglob("*.hpp") if "include" in path.parts))
    known, all_modules = entities(found), modules()
    nowhere = {entity.header for entity in known if entity.module not in all_modules}
    if nowhere:
        raise SystemExit(f"src/CMakeLists.txt names no module of {', '.join(sorted(nowhere))}")
    namespaces, writer = [compound for compound in found if compound.get("kind") == "namespace"], Writer(known)
    folder.mkdir(parents=True, exist_ok=True)
    index = "# C++ reference\n\nWhat public headers declare, by module, in the order of the method: a module builds on those above it.\n\n"
    index += "| module | what it is |\n|---|---|\n"
    for module, said in all_modules.items():
        own = [entity for entity in known if entity.module == module]
        if own:
            index += f"| [{module}]({module}.md) | {said} |\n"
            (folder / f"{module}.md").write_text(page(module, said, own, namespaces, writer))
    (folder / "index.md").write_text(index)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
