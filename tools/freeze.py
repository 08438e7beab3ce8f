#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps everything the program and the package print and write, so that `diff -r BEFORE AFTER` shows what a change changes.

    tools/freeze.py FOLDER [--program build/bin/setae] [--package build/python] [--only TEXT] [--jobs 2]

Runs every case of tests/cli, the examples with their figures and reports, and calls of the Python package; each has a folder of its
own with `command`, `exit_code`, `stdout`, `stderr` and `files`. The program's version is written as VERSION and the folders of the
machine as WORK and SOURCE, so that two checkouts can be compared. Where the package is not built, that part is left out with a line.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1]
WORK = Path("/tmp/setae_frozen")  # the same for every run: paths stand in outputs
VERSION = re.compile(rb"\b\d+\.\d+\.\d+\+[0-9a-f]{8}\b")
EXAMPLES = {
    "published": "$SETAE study examples/nanodiamond/published.toml --output $WORK/results && $SETAE predict examples/nanodiamond/published.toml",
    "uncd": "$SETAE study examples/uncd/uncd.toml --output $WORK/results",
    "tutorial": "$SETAE lab make examples/tutorial/recipe.toml -o $WORK/data && $SETAE study $WORK/data/study.toml --output $WORK/results"
                " && $SETAE predict $WORK/data/study.toml",
    "laboratory": "$SETAE lab make examples/laboratory/recipe.toml -o $WORK/data && $SETAE study $WORK/data/study.toml --output $WORK/results",
    "closure": "$SETAE lab closure examples/closure/fewer.toml --runs 1 -o $WORK/closure",
    "references": "mkdir $WORK/pages && $SETAE study --documentation $WORK/pages && $SETAE man --documentation $WORK/pages/commands"
                  " && $SETAE schema --documentation $WORK/pages && $SETAE formats --documentation $WORK/pages/formats",
    "help": "for shell in bash zsh fish; do $SETAE completion $shell; done; $SETAE man; $SETAE --help;"
            " sed -n 's/^# setae //p' docs/reference/commands/*.md | while read verb; do $SETAE $verb --help; $SETAE $verb --explain; done",
}


def cases():
    """Name and shell command of every case of tests/cli."""
    for path in sorted((SOURCE / "tests/cli").glob("*.toml")):
        for name, case in tomllib.loads(path.read_text()).items():
            yield name, case["command"]


def neutral(content):
    """Without what differs from checkout to checkout."""
    content = content.replace(str(SOURCE).encode(), b"SOURCE").replace(str(WORK).encode(), b"WORK")
    return VERSION.sub(b"VERSION", content)


def kept(folder, line, code, out, err, work):
    folder.mkdir(parents=True)
    for name, content in (("command", line.encode()), ("exit_code", str(code).encode()), ("stdout", out), ("stderr", err)):
        (folder / name).write_bytes(neutral(content))
    for path in sorted(p for p in work.rglob("*") if p.is_file() and not p.is_symlink() and ".cache" not in p.parts):
        target = folder / "files" / path.relative_to(work)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(neutral(path.read_bytes()))


def frozen(name, line, given):
    work = WORK / name
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    environment = {**os.environ, "SETAE": str(given.program.resolve()), "WORK": str(work), "DATA": str(SOURCE / "tests/cli/data"),
                   "REAL_DATA": os.environ.get("SETAE_REFERENCE_DATA", "../shared/data"), "SETAE_CACHE": str(work / ".cache"),
                   "SOURCE_DATE_EPOCH": "1700000000", "PYTHON": str(given.python), "PYTHONPATH": str(given.package.resolve())}
    done = subprocess.run(["sh", "-c", line], cwd=SOURCE, env=environment, capture_output=True, stdin=subprocess.DEVNULL)
    kept(given.folder / name, line, done.returncode, done.stdout, done.stderr, work)
    shutil.rmtree(work)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=Path)
    options.add_argument("--program", type=Path, default=SOURCE / "build/bin/setae")
    options.add_argument("--package", type=Path, default=SOURCE / "build/python")
    options.add_argument("--python", type=Path, default=Path.home() / ".cache/setae/python/bin/python")
    options.add_argument("--only", default="", help="names that hold this text")
    options.add_argument("--jobs", type=int, default=os.cpu_count())
    given = options.parse_args()
    if given.folder.exists() and any(given.folder.iterdir()):
        sys.exit(f"{given.folder} is not empty; give a new folder")
    runs = [(f"cli_{name}", line) for name, line in cases()] + [(f"example_{name}", line) for name, line in EXAMPLES.items()]
    if (given.package / "setae").is_dir():
        runs.append(("python", "$PYTHON tools/freeze_python.py $WORK"))
    else:
        print(f"no package in {given.package}: the Python part is left out")
    runs = [run for run in runs if given.only in run[0]]
    with ThreadPoolExecutor(given.jobs) as pool:
        list(pool.map(lambda run: frozen(*run, given), sorted(runs, key=lambda run: run[0].startswith("cli_"))))
    print(f"{len(runs)} runs are kept in {given.folder}")


if __name__ == "__main__":
    main()
