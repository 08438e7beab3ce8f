#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rough surfaces pressed on an elastic half-space without adhesion: setae beside ContactMechanics and Tamaas.

    ./setup peers                  installs the packages in an environment of their own, builds, and runs

or by hand, with a Python that has them:

    PYTHONPATH=build-bench/python python benchmarks/peers/contact.py --write docs/development/performance.md [--largest 2048]

The same periodic self-affine surfaces (H = 0.8, flat above a quarter of the side, waves down to 16 points, rms slope 0.1) under the same mean
pressure. Every measurement is a process of its own, bound to one core or two: the solver's call alone, heights in memory; time is the best
of as many runs as fit into five seconds, memory what the process holds at most beside its input. Error: rms difference of the
pressures from those that setae finds to a duality gap of 1e-13, over the mean pressure. Each solver ends by its own
measure: setae and Tamaas at 1e-8, ContactMechanics where nothing penetrates by more than 1e-6 of the rms height.
"""
import argparse
import datetime
import importlib.metadata
import json
import os
import resource
import sys
import tempfile
import time

import compare
import numpy as np

PRESSURES = (0.05, 0.5)  # mean pressure over h'_rms E*
SLOPE = 0.1


def surface(points):
    """Heights of a periodic map of 1 m x 1 m."""
    q = np.hypot(np.fft.fftfreq(points, 1 / points)[:, None], np.fft.rfftfreq(points, 1 / points)[None, :])
    amplitude = np.where((q > 0) & (q <= points / 16), np.maximum(q, 4.0) ** -1.8, 0.0)
    heights = np.fft.irfft2(amplitude * np.fft.rfft2(np.random.default_rng(1).standard_normal((points, points))), s=(points, points))
    spectrum = np.abs(np.fft.rfft2(heights)) ** 2 * (2 * np.pi * q) ** 2
    spectrum[:, 1:-1] *= 2
    return heights * (SLOPE / np.sqrt(spectrum.sum() / points**4))


def by_setae(heights, pressure, tolerance=1e-8):
    import setae

    scan = setae.scan(heights, size="1 m x 1 m", unit="m", periodic=True)

    def run():
        solved = setae.contact(scan, contact_modulus="1 Pa", pressure=f"{pressure!r} Pa", tolerance=tolerance)
        return solved.pressures, solved["iterations"]

    return run


def by_contact_mechanics(heights, pressure):
    import SurfaceTopography
    from ContactMechanics import PeriodicFFTElasticHalfSpace
    from ContactMechanics.Factory import make_system

    shape = heights.shape
    topography = SurfaceTopography.Topography(heights, (1.0, 1.0), periodic=True, unit="m")
    system = make_system(interaction="hardwall", substrate=PeriodicFFTElasticHalfSpace(shape, 1.0, (1.0, 1.0)), surface=topography)

    def run():
        found = system.minimize_proxy(external_force=pressure, pentol=1e-6 * float(heights.std()))
        return np.abs(system.force) * heights.size, int(found.nit)

    return run


def by_tamaas(heights, pressure):
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
    model.E, model.nu = 1.0, 0.0

    def run():
        model.traction[:] = 0
        solver = tamaas.PolonskyKeerRey(model, heights, 1e-8)
        solver.max_iter = 10000
        solver.solve(pressure)
        return np.array(model.traction), None

    return run


SOLVERS = {"setae": by_setae, "ContactMechanics": by_contact_mechanics, "Tamaas": by_tamaas}
LARGEST = {("ContactMechanics", 0.05): 1024, ("ContactMechanics", 0.5): 1024, ("Tamaas", 0.5): 1024}  # points a side; beyond, a run takes minutes


def one_process(solver, path, pressure, reference):
    """One solver in this process."""
    heights, expected = np.load(path), np.load(reference)
    run = SOLVERS[solver](heights, pressure)
    best, memory, begin = np.inf, 0.0, time.perf_counter()
    while best == np.inf or time.perf_counter() - begin < 5.0:
        with open("/proc/self/clear_refs", "w") as peak:
            peak.write("5")
        before = compare.held_memory()["VmRSS"]
        start = time.perf_counter()
        pressures, iterations = run()
        seconds = time.perf_counter() - start
        if best == np.inf:
            memory = compare.held_memory()["VmHWM"] - before
        best = min(best, seconds)
    error = float(np.sqrt(np.mean((pressures - expected) ** 2)) / pressure)
    print(json.dumps({"seconds": best, "memory": memory, "error": error, "area": float(np.mean(pressures > 0)), "iterations": iterations}))


def rows_of(folder, points):
    heights = surface(points)
    path = os.path.join(folder, f"{points}.npy")
    np.save(path, heights)
    for share in PRESSURES:
        pressure = share * SLOPE
        reference = os.path.join(folder, f"{points}_{share}.npy")
        np.save(reference, by_setae(heights, pressure, tolerance=1e-13)()[0])
        for solver in SOLVERS:
            if points > LARGEST.get((solver, share), points):
                continue
            found = [compare.run_json([sys.executable, __file__, "--solver", solver, "--input", path, "--pressure", repr(pressure), "--reference", reference], cores)
                     for cores in compare.CORES]
            row = {"points": points, "share": share, "solver": solver, "found": found}
            print(row, flush=True)
            yield row


def table(rows):
    lines = ["| points | pressure/h'E* | | 1 core | 2 cores | memory | iterations | area | error of pressures |", "|---|---|---|---|---|---|---|---|---|"]
    for row in rows:
        one, two = row["found"]
        iterations = "—" if two["iterations"] is None else str(two["iterations"])
        cells = [f"{row['points']}²", f"{row['share']:g}", row["solver"], compare.seconds(one["seconds"]), compare.seconds(two["seconds"]),
                 compare.megabytes(two["memory"]), iterations, f"{two['area']:.4f}", f"{two['error']:.0e}"]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", help="page whose table is replaced")
    parser.add_argument("--largest", type=int, default=2048, help="points a side of the largest surface")
    for hidden in ("--solver", "--input", "--reference"):
        parser.add_argument(hidden, help=argparse.SUPPRESS)
    parser.add_argument("--pressure", type=float, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.solver:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        return one_process(arguments.solver, arguments.input, arguments.pressure, arguments.reference)
    with tempfile.TemporaryDirectory() as folder:
        rows = [row for points in (512, 1024, 2048) if points <= arguments.largest for row in rows_of(folder, points)]
    packages = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in ("ContactMechanics", "tamaas"))
    lines = [f"Measured on {datetime.date.today()} with `./setup peers` on two cores ({compare.processor()}), {packages}.", "", *table(rows)]
    print("\n".join(lines))
    if arguments.write:
        compare.write(arguments.write, {"contact": lines})


if __name__ == "__main__":
    main()
