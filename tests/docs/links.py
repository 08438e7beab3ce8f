#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""links.py: every link of a document leads somewhere: the file is there, and the section it names; docs/README.md leads to every page.

--measured PAGE    of this page, besides: every paragraph, item and row of a table has a link to a section that holds a table or a figure
"""
import argparse
import functools
import pathlib
import re
import sys
import unicodedata

LINK = re.compile(r"\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^()\s]+(?:\([^()\s]*\))?)\)")
TABLE_LINES = 5  # a fenced block that is a table has more than a command or two
PAGES = ("*.md", "docs/**/*.md", "examples/**/*.md", "tests/**/*.md", "src/**/*.md", "lab/**/*.md")


def without_code(text):
    """The text with fenced blocks and inline code blanked, lines kept."""
    text = re.sub(r"^```.*?^```", lambda found: "\n" * found[0].count("\n"), text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "", text)


def anchor(heading):
    """The name GitHub gives a heading: letters, digits, - and _ in lower case, blanks as -."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower().replace(" ", "-")
    return "".join(c for c in plain if c in "-_" or unicodedata.category(c)[0] in "LN")


@functools.cache
def sections(page):
    """Text of every section by its anchor, without those below it."""
    found, current, fenced = {"": []}, "", False
    for line in page.read_text(encoding="utf-8").splitlines():
        fenced ^= line.startswith("```")
        heading = re.match(r"#+ +(.*?) *#*$", line)
        if heading and not fenced:
            name, number = anchor(heading[1]), 1
            current = name
            while current in found:
                current, number = f"{name}-{number}", number + 1
            found[current] = []
        else:
            found[current].append(line)
    return found


def target_of(page, link):
    file, _, section = link.partition("#")
    return (page.parent / file).resolve() if file else page.resolve(), section


def broken(page):
    """Links of a page that lead nowhere, with their lines; a link's words may go over the end of a line."""
    text = without_code(page.read_text(encoding="utf-8"))
    for found in LINK.finditer(text):
        link, number = found[1], text.count("\n", 0, found.start(1)) + 1
        if re.match(r"[a-z]+:", link):
            continue
        file, section = target_of(page, link)
        if not file.exists():
            yield f"{page}:{number}: {link}: no such file"
        elif section and file.suffix == ".md" and section not in sections(file):
            yield f"{page}:{number}: {link}: no such section; there are {', '.join(name for name in sections(file) if name)}"


def unlisted():
    """Pages of docs that its list leads to neither itself nor by one page more."""
    top = pathlib.Path("docs/README.md")
    near = linked(top) | {page for first in linked(top) if first.suffix == ".md" for page in linked(first)}
    for page in sorted(pathlib.Path("docs").glob("**/*.md")):
        if page.resolve() not in near | {top.resolve()} and page.parts[1] != "adr":
            yield f"{page}: docs/README.md does not lead to it"


def linked(page):
    return {target_of(page, link)[0] for link in LINK.findall(without_code(page.read_text(encoding="utf-8")))}


def claims(page):
    """Paragraphs, items and rows of a page, each with the line where it begins."""
    lines = without_code(page.read_text(encoding="utf-8")).splitlines()
    text, begin = "", 0
    for number, line in enumerate(lines + [""], 1):
        starts = re.match(r"(- |\d+\. |\|)", line)
        if (not line.strip() or starts or line.startswith("#")) and text:
            yield begin, text
            text = ""
        if line.strip() and not line.startswith("#"):
            if not text:
                begin = number
            text += line + "\n"


def is_measured(page, link):
    file, section = target_of(page, link)
    if file.suffix != ".md" or not file.is_file():
        return False
    body = sections(file).get(section, []) if section else file.read_text(encoding="utf-8").splitlines()
    return any(line.startswith(("|", "![")) for line in body) or fenced_lines(body) >= TABLE_LINES


def fenced_lines(body):
    """Lines of the longest fenced block: tables as a program prints them stand in one."""
    longest, begin = 0, None
    for number, line in enumerate(body):
        if line.startswith("```"):
            longest, begin = (longest, number) if begin is None else (max(longest, number - begin - 1), None)
    return longest


def unmeasured(page):
    """Claims without a table behind them."""
    for number, text in claims(page):
        if text.startswith(("*", "![", "| ---", "|---")) or re.match(r"\|[^\[]*\|\n$", text) and number + 1 in rules(page):
            continue
        if not any(is_measured(page, link) for link in LINK.findall(text)):
            yield f"{page}:{number}: no link to a table: {text.splitlines()[0][:80]}"


def rules(page):
    """Lines that part a table's head from its rows."""
    return {number for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1) if re.match(r"\|[-| :]+\|$", line)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measured", type=pathlib.Path, action="append", default=[])
    given = parser.parse_args()
    pages = sorted({page for pattern in PAGES for page in pathlib.Path().glob(pattern)})
    problems = [problem for page in pages for problem in broken(page)]
    problems += unlisted()
    problems += [problem for page in given.measured for problem in unmeasured(page)]
    print("\n".join(problems) or f"{len(pages)} pages")
    return 1 if problems or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
