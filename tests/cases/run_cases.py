#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_cases.py SETAE [KIND...] [--write PAGE]: small inputs that once went wrong, and what is right for each.

KIND.toml beside this file lists the cases of one kind; their files are in data/KIND. Without KIND all are run.

    [[case]]
    file = "dropout_9999.dat"                     # or a list: one case for each; {file} in `run` is its path
    run = "params {file} --unit um --json"        # what is typed after `setae`; {folder} is an empty folder
    exit = 0                                      # default 0
    value = { at = "measurements.0.Rq.value", is = 92.33e-6, within = 1e-3 }   # or a list; within is relative
    says = ["504 of 2000 heights are undefined"]  # parts of what is printed (both streams, white space as one blank)
    never = ["3.5 mm"]                            # parts that must not be printed
    before = "Rq 11 mm, no warning"               # what the program printed on 2026-11-26, for the table

A path `at` is split at dots: an integer is an index, KEY=VALUE takes the first object of a list in which KEY is VALUE.
--write PAGE writes the table (case, before, now) into PAGE below its line `<!-- cases -->`.
"""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE / "data"
MARKER = "<!-- cases -->"


def step(node, key):
    """The part of a JSON value that one segment of a path names."""
    if isinstance(node, list) and "=" in key:
        name, wanted = key.split("=", 1)
        for item in node:
            if isinstance(item, dict) and str(item.get(name)) == wanted:
                return item
        raise KeyError(f"no object with {key}")
    return node[int(key)] if isinstance(node, list) else node[key]


def found(printed, path):
    node = json.loads(printed)
    for key in path.split("."):
        node = step(node, key)
    return node


def as_list(value):
    return value if isinstance(value, list) else [value]


def one_line(text):
    return " ".join(text.split())


class Run:
    """One case run once: what was printed, and what of it is wrong."""

    def __init__(self, program, kind, case, file, folder):
        self.case, self.file, self.wrong, self.values = case, file, [], []
        path = DATA / kind / file
        words = [word.format(file=path, folder=folder, data=DATA / kind) for word in shlex.split(case["run"])]
        self.typed = "setae " + case["run"].format(file=file, folder=".", data=".")
        done = subprocess.run([program, *words], capture_output=True, text=True, cwd=folder, timeout=300, check=False)
        self.output, self.messages, self.code = done.stdout, done.stderr, done.returncode
        self.check()

    def check(self):
        case = self.case
        if self.code != case.get("exit", 0):
            self.wrong.append(f"exit code {self.code}, expected {case.get('exit', 0)}: {one_line(self.messages)[:400]}")
            return
        for wanted in as_list(case.get("value", [])):
            try:
                value = found(self.output, wanted["at"])
                self.values.append(value)
                if not abs(value - wanted["is"]) <= wanted["within"] * abs(wanted["is"]):
                    self.wrong.append(f"{wanted['at']} is {value}, expected {wanted['is']} within {wanted['within']:g} of it")
            except (KeyError, IndexError, TypeError, ValueError) as error:
                self.wrong.append(f"{wanted['at']}: not in what is printed ({error})")
        printed = one_line(self.output + " " + self.messages)
        for part in as_list(case.get("says", [])):
            if one_line(part) not in printed:
                self.wrong.append(f"does not print '{part}'; prints: {printed[:600]}")
        for part in as_list(case.get("never", [])):
            if one_line(part) in printed:
                self.wrong.append(f"prints '{part}'")

    def now(self):
        """What the table shows: the values checked, else the message checked, else that it is refused."""
        if self.values:
            return ", ".join(f"{value:.5g}" for value in self.values)
        parts = as_list(self.case.get("says", []))
        return "; ".join(parts) if parts else f"exit code {self.code}"


def kinds():
    return sorted(path.stem for path in HERE.glob("*.toml"))


def run_kind(program, kind):
    with open(HERE / f"{kind}.toml", "rb") as file:
        cases = tomllib.load(file)["case"]
    runs = []
    for case in cases:
        for file in as_list(case["file"]):
            with tempfile.TemporaryDirectory() as folder:
                runs.append(Run(program, kind, case, file, folder))
    return runs


def table(runs_by_kind):
    lines = ["", "| kind | input | typed | before | now |", "|---|---|---|---|---|"]
    for kind, runs in runs_by_kind.items():
        for run in runs:
            cells = [kind, f"`{run.file}`", f"`{run.typed}`", run.case.get("before", ""), run.now()]
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("kind", nargs="*")
    parser.add_argument("--write", metavar="PAGE")
    arguments = parser.parse_args()
    program = str(pathlib.Path(arguments.program).resolve())
    runs_by_kind = {kind: run_kind(program, kind) for kind in arguments.kind or kinds()}
    failed = 0
    for kind, runs in runs_by_kind.items():
        for run in runs:
            for wrong in run.wrong:
                print(f"{kind}/{run.file}: {run.typed}\n    {wrong}")
            failed += bool(run.wrong)
    print(f"{sum(len(runs) for runs in runs_by_kind.values())} cases, {failed} wrong")
    if arguments.write and not failed:
        page = pathlib.Path(arguments.write)
        text = page.read_text(encoding="utf-8")
        page.write_text(text[: text.index(MARKER) + len(MARKER)] + "\n" + table(runs_by_kind), encoding="utf-8")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
