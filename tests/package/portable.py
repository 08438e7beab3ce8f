#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""portable.py: what POSIX alone has is called in src/base/core/platform and nowhere else."""

import pathlib
import re
import sys

POSIX = re.compile(
    r"#include <(sys/\w+|unistd|fcntl|spawn|dlfcn|pthread|poll|dirent|pwd|sched|signal|termios)\.h>"
    r"|\b(getpid|isatty|popen|fork|waitpid|mkdtemp|gmtime_r|localtime_r|setenv|usleep)\("
)

found = []
for folder in ("src", "lab", "apps", "python/bindings"):
    for path in sorted(pathlib.Path(folder).rglob("*.[ch]pp")):
        if {"tests", "benchmarks"} & set(path.parts) or path.parts[:4] == ("src", "base", "core", "platform"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if POSIX.search(line.partition("//")[0]):
                found.append(f"{path}:{number}: {line.strip()}")
print("\n".join(found) or "none outside src/base/core/platform")
sys.exit(bool(found))
