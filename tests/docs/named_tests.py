#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""named_tests.py: every test that a page names as `Suite.Case`, and every suite that a page names as `Suite.*`, exists in the sources."""

import pathlib
import re
import sys

TEST = re.compile(r"\b(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP)\(\s*(\w+)\s*,\s*(\w+)")
MENTION = re.compile(r"`([A-Z]\w*)\.([A-Z]\w*|\*)`")
PAGES = ("*.md", "docs/**/*.md", "tests/**/*.md")
SOURCES = ("src/**/tests/**/*.cpp", "lab/**/tests/**/*.cpp", "tests/**/*.cpp")


def files(top, patterns):
    return sorted(path for pattern in patterns for path in top.glob(pattern))


def known_tests(top):
    """Names of all tests, with Suite.* for every suite."""
    tests = {test for path in files(top, SOURCES) for test in TEST.findall(path.read_text(encoding="utf-8"))}
    return tests | {(suite, "*") for suite, _ in tests}


def unknown_tests(top):
    """Mentions of tests that do not exist: page, line, name."""
    known = known_tests(top)
    for page in files(top, PAGES):
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
            for name in MENTION.findall(line):
                if name not in known:
                    yield page.relative_to(top), number, ".".join(name)


def main():
    unknown = list(unknown_tests(pathlib.Path(__file__).resolve().parents[2]))
    for page, number, name in unknown:
        print(f"{page}:{number}: {name} is not a test")
    return 1 if unknown else 0


if __name__ == "__main__":
    sys.exit(main())
