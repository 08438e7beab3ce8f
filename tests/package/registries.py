#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""registries.py: no file names the address of a package registry. Packages are fetched by npm, pip, apt and debootstrap from the registry
that the machine is set up with. Exit code 77 (skipped) outside a checkout."""

import shutil
import subprocess
import sys

HOSTS = (
    r"npmjs\.(org|com)", r"yarnpkg\.com", r"unpkg\.com", r"jsdelivr\.net", r"cdnjs\.", r"cdn\.[a-z]+\.[a-z]+", r"esm\.sh",
    r"pypi\.org", r"pythonhosted\.org", r"anaconda\.org",
    r"(deb|ftp\.[a-z]+|security|snapshot)\.debian\.org", r"(archive|security)\.ubuntu\.com",
    r"crates\.io", r"proxy\.golang\.org", r"maven\.org", r"(ghcr|quay|docker)\.io",
)  # fmt: skip

if not shutil.which("git") or subprocess.run(["git", "rev-parse", "--git-dir"], capture_output=True).returncode:
    print("skipped: the list of files takes git and a checkout")
    sys.exit(77)
# no hit is 1
found = subprocess.run(
    ["git", "grep", "--untracked", "-nIiE", r"(^|[^a-z0-9-])(" + "|".join(HOSTS) + r")([^a-z0-9]|$)"], capture_output=True, text=True
)
if found.returncode > 1:
    sys.exit(f"git grep: {found.stderr}")
for hit in found.stdout.splitlines():
    place, number, line = hit.split(":", 2)
    print(f"{place}:{number}: address of a package registry: {line.strip()[:120]}; expected a call of npm, pip, apt or debootstrap without one")
print(f"{len(found.stdout.splitlines())} addresses of package registries")
sys.exit(found.returncode == 0)
