#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user waits for: whole commands from the shell to their last line, on data they make themselves.

    benchmarks/commands/time_commands.py PROGRAM [--beside OTHER_PROGRAM] [--repeat 5] [--write docs/development/performance.md]

Every command runs `repeat` times after one run that is not counted; the median stands in the table, with the processor time of both cores and the
most memory. The yardstick is `cat` of the same input. With --beside a second program (an older build) runs in turn with the first. The
table replaces what stands between "<!-- commands: begin -->" and "<!-- commands: end -->" of the page.
"""
import argparse
import datetime
import os
import pathlib
import random
import re
import resource
import statistics
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def picture(path, side=2000):
    """An edge with noise as an uncompressed TIFF of 8 bits, 0.1 nm a pixel in its description."""
    random.seed(1)
    noise = [random.gauss(0, 20) for _ in range(65521)]
    pixels = bytearray()
    for y in range(side):
        level = 60 if y < side // 2 else 160
        pixels += bytes(min(255, max(0, int(level + noise[(y * side + x) % 65521]))) for x in range(side))
    tags = [(256, 4, side), (257, 4, side), (258, 3, 8), (259, 3, 1), (262, 3, 1), (273, 4, 8), (277, 3, 1), (278, 4, side), (279, 4, len(pixels))]
    directory = struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in tags) + bytes(4)
    path.write_bytes(b"II*\0" + struct.pack("<I", 8 + len(pixels)) + bytes(pixels) + directory)


def make_inputs(program, folder):
    def run(*words):
        subprocess.run([program, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    run("synthesize", "--pixels", "4096", "--size", "5 um", "--hurst", "0.8", "--rolloff", "1 um", "--short-cutoff", "5 nm", "--rms-height", "20 nm", "--seed", "1", "-o", "map.npy")
    run("lab", "make", str(ROOT / "examples/laboratory/recipe.toml"), "-o", "laboratory")
    picture(folder / "edge.tif")


# words of the command, its input
MAP = ("map.npy", "--size", "5 um x 5 um", "--unit", "m")
COMMANDS = [
    ("--version", ("--version",), None),
    ("info map.npy", ("info", *MAP), "map.npy"),
    ("psd map.npy", ("psd", *MAP), "map.npy"),
    ("psd map.npy --iso", ("psd", *MAP, "--iso"), "map.npy"),
    ("params map.npy", ("params", *MAP), "map.npy"),
    ("sdrp map.npy", ("sdrp", *MAP), "map.npy"),
    ("adhesion map.npy", ("adhesion", *MAP, "--E", "0.7MPa", "--w", "37mJ/m2", "--gamma", "25mJ/m2"), "map.npy"),
    ("jkr fit loop.csv", ("jkr", "fit", "laboratory/loops/rough_E07.csv", "--radius", "1.25 mm"), "laboratory/loops/rough_E07.csv"),
    ("contour edge.tif", ("contour", "edge.tif", "--pixel", "0.1 nm", "-o", "edge.csv"), "edge.tif"),
    ("study laboratory, everything kept", ("study", "laboratory/study.toml"), None),
]


def once(words, folder, environment):
    """Seconds on the clock, seconds of processors, most memory [MB]."""
    begin = time.perf_counter()
    process = subprocess.Popen(words, cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    message = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - begin
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"{' '.join(words)}: {message.decode(errors='replace')}")
    return seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def timed(words, folder, repeat, environment):
    once(words, folder, environment)
    runs = [once(words, folder, environment) for _ in range(repeat)]
    return [statistics.median(column) for column in zip(*runs)]


def spelled(seconds):
    return f"{1e3 * seconds:.0f} ms" if seconds < 1 else f"{seconds:.2f} s"


def table(programs, folder, repeat):
    heads = ["", "before: "] if len(programs) > 1 else [""]
    lines = ["| `setae …` | " + " | ".join(f"{head}time | {head}processors | {head}memory" for head in heads) + " | `cat` of its input |",
             "|---" * (2 + 3 * len(programs)) + "|"]
    for name, words, source in COMMANDS:
        cells = []
        for index, program in enumerate(programs):
            environment = {**os.environ, "SETAE_CACHE": str(folder / f"cache{index}")}
            seconds, processors, memory = timed([program, *words], folder, repeat, environment)
            cells += [spelled(seconds), spelled(processors), f"{memory:.0f} MB"]
        yardstick = spelled(timed(["cat", source], folder, repeat, None)[0]) if source else ""
        lines.append(f"| {name} | " + " | ".join(cells) + f" | {yardstick} |")
        print(lines[-1], flush=True)
    return lines


def compared(description, repeat):
    """What is asked for, and the programs to time: PROGRAM, and the one that --beside gives."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--beside")
    parser.add_argument("--repeat", type=int, default=repeat)
    parser.add_argument("--write")
    arguments = parser.parse_args()
    return arguments, [str(pathlib.Path(program).resolve()) for program in (arguments.program, arguments.beside) if program]


def write_table(page, marker, measured, lines):
    """Puts the lines, below how they were measured, between the markers of a page."""
    page = pathlib.Path(page)
    text = f"Measured on {datetime.date.today()} {measured}on {os.cpu_count()} cores.\n\n" + "\n".join(lines) + "\n"
    page.write_text(re.sub(rf"(?<=<!-- {marker}: begin -->\n).*?(?=<!-- {marker}: end -->)", lambda _: text, page.read_text(), flags=re.S))


def main():
    arguments, programs = compared(__doc__, 5)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_inputs(programs[0], folder)
        lines = table(programs, folder, arguments.repeat)
    if arguments.write:
        write_table(arguments.write, "commands", "", lines)


if __name__ == "__main__":
    main()
