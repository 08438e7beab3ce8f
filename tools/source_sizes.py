#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""source_sizes.py [CHECKOUT] [--built FOLDER SECONDS]: what there is to read, and what it takes to build.

Lines and files of every part of src, of the program and of the tests, public headers, the longest and the median file. With --built the
processor seconds of a build, SECONDS in all (user and system, of `bash -c time`), are shared out by the times in FOLDER/.ninja_log.
"""
import argparse
import collections
import pathlib
import statistics


def group(path):
    parts = path.parts
    if "tests" in parts:
        return "tests"
    return parts[1] if parts[0] == "src" and len(parts) > 2 else parts[0]


def sources(root):
    for top in ("src", "lab", "apps", "python", "benchmarks", "tests"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".cpp", ".hpp"):
                yield path.relative_to(root)


def build_seconds(folder, total):
    """By group: the wall times of the last run of each object, scaled to the processor seconds of the whole."""
    last = {}
    for line in (folder / ".ninja_log").read_text().splitlines()[1:]:
        begin, end, _, output, *_ = line.split("\t")
        last[output] = int(end) - int(begin)
    shares = collections.Counter()
    for output, duration in last.items():
        parts = pathlib.PurePath(output.replace("_tests", "/tests/"))
        shares["tests" if "tests" in parts.parts or output.startswith("tests") else group(parts)] += duration
    scale = total / sum(shares.values())
    return {name: share * scale for name, share in shares.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkout", nargs="?", default=pathlib.Path(__file__).resolve().parent.parent, type=pathlib.Path)
    parser.add_argument("--built", nargs=2, metavar=("FOLDER", "SECONDS"))
    arguments = parser.parse_args()
    lines = {path: (arguments.checkout / path).read_text().count("\n") for path in sources(arguments.checkout)}
    own = {path: count for path, count in lines.items() if group(path) != "tests"}
    seconds = build_seconds(pathlib.Path(arguments.built[0]), float(arguments.built[1])) if arguments.built else {}
    print("| folder | files | lines |" + (" build, processor s |" if seconds else "") + "\n|---|---|---|" + ("---|" if seconds else ""))
    for name in sorted({group(path) for path in lines} | {name for name in seconds if seconds[name] > 0.5}):
        counts = [count for path, count in lines.items() if group(path) == name]
        print(f"| {name} | {len(counts)} | {sum(counts)} |" + (f" {seconds.get(name, 0):.0f} |" if seconds else ""))
    longest = max(own, key=own.get)
    public = [path for path in own if "include" in path.parts]
    print(f"\n{sum(own.values())} lines in {len(own)} files without tests; {len(public)} public headers; "
          f"longest file {own[longest]} lines ({longest}), median {statistics.median(own.values()):.0f}")


if __name__ == "__main__":
    main()
