#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""calls.py PROGRAM_OF_BARE_CALLS: how long the package takes beside the C++ library, as a table.

PROGRAM_OF_BARE_CALLS is build/bin/python_calls, which does the same by the library alone. Each time is the least of several runs,
alternating, and the sum of all threads' seconds of the processor where that is said.
"""

from __future__ import annotations

import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
import setae

RUNS = 5


def processor_seconds(call) -> float:
    before = resource.getrusage(resource.RUSAGE_SELF)
    call()
    after = resource.getrusage(resource.RUSAGE_SELF)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def wall_seconds(call) -> float:
    began = time.perf_counter()
    call()
    return time.perf_counter() - began


def import_seconds() -> float:
    code = "import time; began = time.perf_counter(); import setae; print(time.perf_counter() - began)"
    return min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout) for _ in range(2 * RUNS))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bare", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=4096)
    arguments = parser.parse_args()

    setae.limit_threads(1)
    heights = 1e-9 * np.random.default_rng(1).standard_normal((arguments.points, arguments.points))
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "map.npy"
        np.save(file, heights)

        def bare() -> tuple[float, float]:
            printed = subprocess.run([arguments.bare, file], capture_output=True, text=True, check=True).stdout
            wall, processor = map(float, printed.split())
            return wall, processor

        def by_package(call) -> tuple[float, float]:
            walls: list[float] = []
            processor = processor_seconds(lambda: walls.append(wall_seconds(call)))
            return walls[0], processor

        scan = setae.scan(heights, size="10 um x 10 um", unit="m")
        library, package = [], []
        for _ in range(RUNS):
            library.append(bare())
            package.append(by_package(lambda: setae.power_spectrum(scan)))
    rows = [("import setae", "–", f"{import_seconds():.3f} s", "–")]
    for which, name in enumerate(("wall", "processor")):
        of_library, of_package = min(times[which] for times in library), min(times[which] for times in package)
        rows.append((f"power_spectrum of {arguments.points}², {name}", f"{of_library:.3f} s", f"{of_package:.3f} s", f"{of_package / of_library:.3f}"))
    line = setae.scan(heights[0, :512].copy(), size="1 um", unit="m")
    one = min(wall_seconds(lambda: [setae.power_spectrum(line) for _ in range(1000)]) for _ in range(RUNS))
    rows.append(("power_spectrum of a line of 512 points", "–", f"{1e3 * one:.0f} µs", "–"))
    print("| | C++ | Python | ratio |\n|---|---|---|---|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
