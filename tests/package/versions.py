#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""versions.py: what is handed out names the release that CMakeLists.txt names."""

import pathlib
import re
import sys

NAMED = {
    "CMakeLists.txt": r"project\(setae VERSION ([0-9.]+)",
    "CHANGELOG.md": r"^## ([0-9.]+)",  # the topmost section
    "CITATION.cff": r"^version: ([0-9.]+)",
    "packaging/conda/recipe.yaml": r"^  version: \"([0-9.]+)\"",
}

found = {}
for name, pattern in NAMED.items():
    match = re.search(pattern, pathlib.Path(name).read_text(encoding="utf-8"), re.MULTILINE)
    found[name] = match[1] if match else "no release"
print("\n".join(f"{name}: {release}" for name, release in found.items()))
sys.exit(len(set(found.values())) != 1)
