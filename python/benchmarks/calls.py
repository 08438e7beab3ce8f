#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""calls.py FOLDER_OF_PROGRAMS: times of the package, the C++ library, the program and SurfaceTopography as a table.

FOLDER_OF_PROGRAMS is build/bin, with python_calls, which does the same by the library alone, and setae. Each time is the least of several
runs, alternating, and the sum of all threads' seconds of the processor where that is said. SurfaceTopography is called where it is there.
"""

from __future__ import annotations

import argparse
import importlib.util
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


def import_seconds(package: str) -> float:
    code = f"import time; began = time.perf_counter(); import {package}; print(time.perf_counter() - began)"
    return min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout) for _ in range(2 * RUNS))


def written_maps(folder: pathlib.Path, count: int) -> list[str]:
    """Maps of 128 x 128 points in nanometres as text."""
    files = []
    for seed in range(count):
        heights = np.random.default_rng(seed).standard_normal((128, 128))
        files.append(str(folder / f"map_{seed}.txt"))
        np.savetxt(files[-1], heights, fmt="%.6e")
    return files


def least(call) -> float:
    return min(wall_seconds(call) for _ in range(RUNS))


def row_of_files(program: pathlib.Path, files: list[str], field) -> tuple[str, ...]:
    """Times for listing the content of files, and for reading each file."""
    about = {"size": "1 um x 1 um", "unit": "nm", "layout": "matrix"}
    typed = ["--size", "1 um x 1 um", "--unit", "nm", "--as", "matrix"]

    def by_program() -> None:
        subprocess.run([program, "info", *files, *typed, "--json"], capture_output=True, check=True)

    def by_package() -> None:
        for file in files:
            setae.read(file, **about).heights.sum()

    def by_field() -> None:
        for file in files:
            field.read_topography(file, physical_sizes=(1e-6, 1e-6), unit="m").heights().sum()

    listed, read = [], []
    for _ in range(RUNS):
        listed.append(wall_seconds(by_program))
        read.append(wall_seconds(by_package))
    theirs = f"{least(by_field):.3f} s" if field else "–"
    ratio = f"{min(read) / min(listed):.3f}"
    return f"{len(files)} maps of 128² read from text", f"{min(listed):.3f} s (setae info)", f"{min(read):.3f} s", ratio, theirs


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=4096)
    arguments = parser.parse_args()
    field = importlib.import_module("SurfaceTopography") if importlib.util.find_spec("SurfaceTopography") else None

    setae.limit_threads(1)
    heights = 1e-9 * np.random.default_rng(1).standard_normal((arguments.points, arguments.points))
    with tempfile.TemporaryDirectory() as folder:
        of_map, of_line = (pathlib.Path(folder) / name for name in ("map.npy", "line.npy"))
        np.save(of_map, heights)
        np.save(of_line, heights[0, :512])

        def bare(file: pathlib.Path, calls: int) -> tuple[float, float]:
            command = [arguments.programs / "python_calls", file, str(calls)]
            wall, processor = map(float, subprocess.run(command, capture_output=True, text=True, check=True).stdout.split())
            return wall, processor

        def by_package(call) -> tuple[float, float]:
            walls: list[float] = []
            processor = processor_seconds(lambda: walls.append(wall_seconds(call)))
            return walls[0], processor

        scan = setae.scan(heights, size="10 um x 10 um", unit="m")
        library, package = [], []
        for _ in range(RUNS):
            library.append(bare(of_map, 1))
            package += [by_package(lambda: setae.power_spectrum(scan)) for _ in range(RUNS)]
        bare_line = min(bare(of_line, 1000)[0] for _ in range(RUNS))
        of_files = row_of_files(arguments.programs / "setae", written_maps(pathlib.Path(folder), 200), field)
    theirs = {"wall": "–", "processor": "–"}
    if field:
        topography = field.Topography(heights, (1e-5, 1e-5), unit="m")
        theirs["wall"] = f"{least(topography.power_spectrum_from_profile):.3f} s"
    rows = [("import", "–", f"{import_seconds('setae'):.3f} s", "–", f"{import_seconds('SurfaceTopography'):.3f} s" if field else "–")]
    for which, name in enumerate(("wall", "processor")):
        of_library, of_package = min(times[which] for times in library), min(times[which] for times in package)
        ratio = f"{of_package / of_library:.3f}"
        rows.append((f"power_spectrum of {arguments.points}², {name}", f"{of_library:.3f} s", f"{of_package:.3f} s", ratio, theirs[name]))
    rows.append(of_files)
    line = setae.scan(heights[0, :512].copy(), size="1 um", unit="m")
    one = least(lambda: [setae.power_spectrum(line) for _ in range(1000)]) / 1000
    their_line = "–"
    if field:
        their_scan = field.UniformLineScan(heights[0, :512].copy(), 1e-6, unit="m")
        their_line = f"{1e3 * least(lambda: [their_scan.power_spectrum_from_profile() for _ in range(1000)]):.0f} µs"
    rows.append(
        ("power_spectrum of a line of 512 points", f"{1e6 * bare_line:.0f} µs", f"{1e6 * one:.0f} µs", f"{one / bare_line:.3f}", their_line)
    )
    print("| | C++ | Python | ratio | SurfaceTopography |\n|---|---|---|---|---|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
