#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How time and memory of a command grow with the data: maps and profiles of several sizes, made by this script.

    benchmarks/commands/cost_by_size.py PROGRAM [--beside OTHER_PROGRAM] [--repeat 3] [--write docs/development/performance.md]

Maps are self-affine .npy files of n² heights, profiles text files of n rows "x, z" of a random walk. Every command runs `repeat` times; the table
holds the least time on the clock, the least processor time and the most memory. "Memory over data": the memory beyond that of
`setae --version`, divided by the size of the file. With --beside a second program (an older build) runs in turn with the first, for sizes up to a
tenth of the largest profile. The table replaces what stands between "<!-- sizes: begin -->" and "<!-- sizes: end -->" of the page.
"""
import os
import pathlib
import random
import subprocess
import tempfile

from time_commands import compared, once, spelled, write_table

MAPS = (512, 1024, 2048, 4096)
PROFILES = (10_000, 100_000, 1_000_000, 2_000_000)
MAP_COMMANDS = (("psd",), ("psd", "--iso"), ("params",), ("params", "--standard", "iso25178", "--only", "Sq"), ("params", "--standard", "iso25178"), ("check",))
PROFILE_COMMANDS = (("psd",), ("params",), ("params", "--standard", "iso21920"), ("check",))


def make_map(program, folder, n):
    subprocess.run([program, "synthesize", "--pixels", str(n), "--size", "5 um", "--hurst", "0.8", "--rolloff", "1 um", "--short-cutoff", "5 nm",
                    "--rms-height", "20 nm", "--seed", "1", "-o", f"map{n}.npy"], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return f"map{n}.npy"


def make_profile(folder, n):
    """A walk that returns to its mean over a thousandth of its length, a point per 0.1 µm."""
    engine, height, memory = random.Random(1), 0.0, 1.0 - 1000.0 / n if n > 1000 else 0.0
    with open(folder / f"profile{n}.csv", "w", encoding="utf-8") as file:
        file.write("x (um),z (um)\n")
        for k in range(n):
            height = memory * height + engine.gauss(0.0, 0.01)
            file.write(f"{0.1 * k:.1f},{height:.7f}\n")
    return f"profile{n}.csv"


def cases(program, folder):
    """Label of the size, file, words behind its name, command, whether the older program runs too."""
    for n in MAPS:
        name = make_map(program, folder, n)
        for command in MAP_COMMANDS:
            yield f"{n}²", name, ("--size", "5 um x 5 um", "--unit", "m"), command, "--only" not in command
    for n in PROFILES:
        name = make_profile(folder, n)
        for command in PROFILE_COMMANDS:
            yield f"{n:,}".replace(",", " "), name, (), command, 10 * n <= PROFILES[-1]


def measured(words, folder, repeat, environment):
    runs = [once(words, folder, environment) for _ in range(repeat)]
    seconds, processors, memory = zip(*runs)
    return min(seconds), min(processors), max(memory)


def table(programs, folder, repeat):
    heads = ["", "before: "][: len(programs)]
    lines = ["| n | `setae …` | " + " | ".join(f"{head}time | {head}processors | {head}memory | {head}memory over data" for head in heads) + " |",
             "|---" * (2 + 4 * len(programs)) + "|"]
    for label, name, options, command, both in cases(programs[0], folder):
        cells = []
        data = (folder / name).stat().st_size / 2**20
        for index, program in enumerate(programs):
            if index > 0 and not both:
                cells += [""] * 4
                continue
            environment = {**os.environ, "SETAE_CACHE": str(folder / f"cache{index}")}
            alone = measured([program, "--version"], folder, 1, environment)[2]
            seconds, processors, memory = measured([program, command[0], name, *options, *command[1:]], folder, repeat, environment)
            cells += [spelled(seconds), spelled(processors), f"{memory:.0f} MB", f"{max(0.0, memory - alone) / data:.1f}"]
        lines.append(f"| {label} | {' '.join(command)} | " + " | ".join(cells) + " |")
        print(lines[-1], flush=True)
    return lines


def main():
    arguments, programs = compared(__doc__, 3)
    with tempfile.TemporaryDirectory() as name:
        lines = table(programs, pathlib.Path(name), arguments.repeat)
    if arguments.write:
        beside = " --beside BEFORE" if arguments.beside else ""
        command = f"benchmarks/commands/cost_by_size.py build/bin/setae{beside} --write docs/development/performance.md"
        write_table(arguments.write, "sizes", f"with `{command}` ", lines)


if __name__ == "__main__":
    main()
