#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""words.py [--write] [--all] [--folders]: expressions of tools/words.toml in pages, in texts of the program and in docstrings.

A file may have as many findings as tools/words_allowed.txt has for it, none where it has no line there: the number can only fall.
--write    lower the allowances to what was found
--all      print allowed findings, too, and sentences of more than 40 words, which are only counted otherwise
--folders  only print the pages and words of every folder of docs; a word is what stands between blanks, in tables and code, too
"""

import argparse
import ast
import bisect
import os
import pathlib
import re
import subprocess
import sys
import tomllib

LIST, ALLOWED = "tools/words.toml", "tools/words_allowed.txt"
MAX_WORDS = 40
GENERATED = re.compile(
    r"docs/reference/(?:json|study-keys|alerts|figures|processing-steps)\.md|docs/reference/(?:commands|formats)/|docs/development/adr/")
TESTS = re.compile(r"(?:^|/)(?:tests|benchmarks)/")
# what is no text: comments, literals with a prefix or of one character, then literals
CPP = re.compile(r'//[^\n]*|/\*.*?\*/|#include[^\n]*|\'(?:\\.|[^\'\\\n])+\'|R"(\w*)\((?P<raw>.*?)\)\1"|"(?P<text>(?:\\.|[^"\\\n])*)"', re.S)
CODE = re.compile(r"^ *(`{3,})(?s:.*?)^ *\1[^\n]*|(?s:<!--.*?-->)|(`+)(?!`)(?:[^\n]|\n(?!\s*\n))+?(?<!`)\2(?!`)|(?<=\])\([^()\s]*(?:\([^()\s]*\))?\)"
                  r"|^\*[^\n]*all documents.*$|https?://\S+", re.M)
GAP = "\x01"  # for what is between two texts, so that no expression reaches across


def blank(text, fill=" "):
    """As many characters, lines kept."""
    return re.sub(r"[^\n]", fill, text)


def pages(text):
    """A page without its code, links' targets and what the program makes of it."""
    text = re.sub(r"\A.*?<!--[^\n]*\babove\b[^\n]*made by[^\n]*-->", lambda found: blank(found[0], GAP), text, flags=re.S)
    text = CODE.sub(lambda found: blank(found[0], GAP), text)
    return re.sub(r"(?<=\n\n)(?: {4}[^\n]*\n)+", lambda found: blank(found[0], GAP), text)


def segments(text):
    """(line, text) of every part between gaps."""
    line, end = 1, 0
    for found in re.finditer(f"[^{GAP}\\s][^{GAP}]*", text):
        line += text.count("\n", end, found.start())
        end = found.start()
        yield line, found[0]


def program(text):
    """(line, text) of what is between quotation marks, adjacent literals together; those without a blank are names."""
    parts, line, counted, literal_end = [], 1, 0, -1
    for found in CPP.finditer(text):
        inner = found["text"] if found["raw"] is None else found["raw"]
        if inner is None or not re.search("[A-Za-z] ", inner):
            continue
        inner = " " + re.sub(r"\\[nt\"]", "  ", inner) + " "
        between = text[literal_end : found.start()]
        if literal_end >= 0 and not between.strip():
            parts[-1] = parts[-1][0], parts[-1][1] + between + inner
        else:
            line += text.count("\n", counted, found.start())
            counted = found.start()
            parts.append((line, inner))
        literal_end = found.end()
    return parts


def python(text):
    """Docstrings without their examples."""
    lines, kept = text.splitlines(keepends=True), set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) and ast.get_docstring(node) is not None:
            kept.update(range(node.body[0].lineno - 1, node.body[0].end_lineno))
    kept = {i for i in kept if not re.match(r"\s*(?:>>>|\.\.\. )", lines[i])}
    return CODE.sub(lambda found: blank(found[0], GAP), "".join(line if i in kept else blank(line, GAP) for i, line in enumerate(lines)))


def notebook(text):
    """Cells of text."""
    cells = re.split(r"^(?=# %%)", text, flags=re.M)
    return pages("".join(re.sub(r"^# ?", lambda found: " " * len(found[0]), cell, flags=re.M) if cell.startswith("# %% [markdown]") else blank(cell, GAP)
                         for cell in cells))


def reader(name):
    """Where a file's text counts, and how it is read; None for a file that is left out."""
    if TESTS.search(name) or GENERATED.match(name):
        return None
    if name in ("README.md", "CONTRIBUTING.md") or name.startswith("docs/") and name.endswith(".md"):
        return "docs", pages
    if name.startswith("docs/notebooks/") and name.endswith(".py"):
        return "docs", notebook
    if name.startswith(("src/", "apps/", "lab/")) and name.endswith((".cpp", ".hpp")):
        return "program", program
    if name.startswith("python/") and name.endswith(".py"):
        return "python", python
    return None


def expressions(file):
    """(pattern, exception or None, what to use, places) of every entry."""
    def compiled(pattern):
        return re.compile(pattern.replace(" ", r"(?:[ \t]+\n?|\n)[ \t]*"), re.I | re.M)

    with open(file, "rb") as entries:
        for entry in tomllib.load(entries)["expression"]:
            if unknown := set(entry) - {"find", "use", "except", "where"}:
                raise ValueError(f"{file}: unknown key {', '.join(unknown)}; expected find, use, except, where")
            yield (compiled(entry["find"]), compiled(entry["except"]) if "except" in entry else None, entry["use"],
                   entry.get("where", ["docs", "program", "python"]))


def findings(parts, place, rules):
    """(line, what was found, what to use) in the order of the text, of parts that begin on a line each."""
    begins, length = [], 0
    for line, part in parts:
        begins.append((length, line))
        length += len(part) + 2
    text, found = f"{GAP}\n".join(part for _, part in parts), []
    for pattern, exception, use, places in rules:
        if place not in places:
            continue
        for match in pattern.finditer(text):
            near = max(0, match.start() - 40)
            if exception and any(e.start() <= match.start() and match.end() <= e.end() for e in exception.finditer(text, near, match.end() + 40)):
                continue
            at = match.start() + len(match[0]) - len(match[0].lstrip())
            begin, line = begins[bisect.bisect(begins, (at, float("inf"))) - 1]
            found.append((line + text.count("\n", begin, at), " ".join(match[0].split()), use))
    return sorted(found)


def long_sentences(text):
    """(line, number of words) of every sentence of more than MAX_WORDS words in paragraphs and items; tables are left out."""
    paragraph = re.compile(r"(?:^(?![ \t]*$|\||#|\x01+$).*\n?)+", re.M)
    for found in paragraph.finditer(text):
        for sentence in re.finditer(r"(?:[^.!?;]|[.!?;](?!\s))+", re.sub(r"(?m)^\s*(?:[-*]|\d+\.) ", lambda mark: " " * (len(mark[0]) - 2) + ". ", found[0])):
            words = len(re.findall(r"[^\W\d_][\w'’-]*|\x01+", sentence[0]))
            if words > MAX_WORDS:
                yield text.count("\n", 0, found.start() + sentence.start()) + 1, words


def allowances(file):
    if not file.exists():
        return {}
    return {name: int(count) for name, count in (line.split("\t") for line in file.read_text(encoding="utf-8").splitlines())}


def check(names, write=False, everything=False):
    """Prints findings; whether a file has more of them than it may."""
    rules = list(expressions(LIST))
    allowed_file = pathlib.Path(ALLOWED)
    allowed, first = allowances(allowed_file), not allowed_file.exists()
    counts, sentences, failed = {}, 0, False
    for name in names:
        if not (kind := reader(name)) or not pathlib.Path(name).is_file():
            continue
        place, read = kind
        text = read(pathlib.Path(name).read_text(encoding="utf-8"))
        parts = text if place == "program" else list(segments(text))
        found = findings(parts, place, rules)
        if found:
            counts[name] = len(found)
        too_many = len(found) > allowed.get(name, 0) and not (write and first)
        if everything or too_many:
            for line, words, use in found:
                print(f"{name}:{line}: found \"{words}\"; expected: {use}")
        if too_many:
            failed = True
            print(f"{name}: {len(found)} found, {allowed.get(name, 0)} allowed")
        if place == "docs":
            long = list(long_sentences(text))
            sentences += len(long)
            if everything:
                for line, words in long:
                    print(f"{name}:{line}: a sentence of {words} words; expected: at most {MAX_WORDS}")
    if write:
        kept = counts if first else {name: min(count, allowed[name]) for name, count in counts.items() if name in allowed}
        allowed_file.write_text("".join(f"{name}\t{count}\n" for name, count in sorted(kept.items())), encoding="utf-8")
    print(f"words: {sum(counts.values())} expressions to replace in {len(counts)} files; {sentences} sentences of more than {MAX_WORDS} words in pages")
    return failed


def folder_sizes(names):
    """A line per folder of docs with its pages, words and words per page, and their sum."""
    sizes = {}
    for name in names:
        if name.startswith("docs/") and name.endswith(".md") and os.path.exists(name):
            folder = str(pathlib.PurePath(name).parent)
            sizes.setdefault(folder, []).append(len(pathlib.Path(name).read_text(encoding="utf-8").split()))
    rows = [(folder, len(counts), sum(counts)) for folder, counts in sorted(sizes.items())]
    rows.append(("all", sum(row[1] for row in rows), sum(row[2] for row in rows)))
    lines = [f"{folder:<28}{pages:>6}{count:>9}{count / pages:>16.0f}" for folder, pages, count in rows]
    return "\n".join([f"{'folder':<28}{'pages':>6}{'words':>9}{'words per page':>16}", *lines])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--folders", action="store_true")
    given = parser.parse_args()
    os.chdir(pathlib.Path(__file__).resolve().parents[1])
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], capture_output=True, text=True, check=True)
    names = sorted(set(listed.stdout.splitlines()))
    if given.folders:
        print(folder_sizes(names))
        return 0
    return int(check(names, given.write, given.all))


if __name__ == "__main__":
    sys.exit(main())
