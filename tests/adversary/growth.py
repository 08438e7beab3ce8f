#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How time and memory grow with what is counted: members, measurements, surfaces, experiments, rows, pixels.

    growth.py --program build/bin/setae [--largest 10000] [--only WHAT ...]

Each line of the table: what is counted, n, time, largest memory, the exponent of the time against the line before (1: linear)
and, for commands on a map, the time over that of `setae psd`. Times are those of one run; tests count operations instead.
"""
import argparse
import math
import shutil
import sys
import tempfile
import zipfile
from pathlib import Path

from laws import run
from samples import Samples

LIMIT_S = 300.0
SIDES = (256, 512, 1024, 2048, 4096)


class Growth:
    """Inputs of a given size, made in a folder of their own."""

    def __init__(self, samples, work):
        self.samples, self.work = samples, work

    def members(self, n):
        with zipfile.ZipFile(self.work / "c.zip", "w") as archive:
            archive.writestr("meta.yml", 'versions: {topobank: "1.0"}\nsurfaces: []\n')
            for i in range(n):
                archive.writestr(f"m{i}.txt", "")
        return "container", "check", "c.zip"

    def measurements(self, n):
        files = [self.samples.profile(self.work, f"m{i}.csv", points=200, seed=i).name for i in range(n)]
        return "study", self.samples.surface_study(self.work, files=files), "--no-figures", "--no-cache"

    def surfaces(self, n):
        names = [f"S{i}" for i in range(n)]
        files = [self.samples.profile(self.work, f"m{i}.csv", points=200, seed=i).name for i in range(n)]
        study = self.samples.surface_study(self.work, names=["A"], files=["m0.csv"])
        head = study.read_text().split("[surfaces")[0]
        study.write_text(head + "".join(f'[surfaces.{name}]\nmeasurements = [{{ file = "{file}", instrument = "stylus" }}]\n'
                                        for name, file in zip(names, files)))
        return "study", study, "--no-figures", "--no-cache"

    def experiments(self, n):
        """Loops of 100 rows, each fitted, on one surface and one elastomer."""
        return self.experiments_of([self.samples.small_loop(self.work, f"l{i}.csv", seed=i).name for i in range(n)])

    def missing(self, n):
        """Experiments whose files do not exist."""
        return self.experiments_of([f"missing{i}.csv" for i in range(n)])

    def experiments_of(self, files):
        study = self.samples.surface_study(self.work, names=["A"])
        text = study.read_text() + '[rough_solid]\nyoungs_modulus = "1e9 GPa"\npoisson_ratio = 0.2\n[elastomers.E]\n'
        text += 'surface_energy = "25 mJ/m2"\nsphere_radius = "1 mm"\n'
        study.write_text(text + "".join(f'[[experiments]]\nfile = "{file}"\nsurface = "A"\nelastomer = "E"\n' for file in files))
        return "study", study, "--no-figures", "--no-cache"

    def rows(self, n):
        return "psd", self.samples.profile(self.work, "rows.csv", points=n), "-o", "psd.csv"

    def loop_rows(self, n):
        """One loop of n rows, as JSON."""
        file = self.samples.small_loop(self.work, "l.csv", points=max(4, 2 * n // 5))
        return "jkr", "fit", file, "--radius", "1 mm", "--json"

    def map(self, side):
        path = self.work / "map.nc"
        run(self.samples.program, "synthesize", "--hurst", "0.8", "--rolloff", "2 um", "--short-cutoff", "20 nm", "--rms-height", "5 nm",
            "--size", "10 um", "--pixels", side, "-o", path, cwd=self.work, seconds=LIMIT_S)
        return path


COUNTED = ("members", "measurements", "surfaces", "experiments", "missing", "rows", "loop_rows")
ON_MAPS = ("psd", "params", "check")


def line(what, n, outcome, before, ratio=""):
    exponent = ""
    if before and outcome.seconds > 0.0:
        exponent = f"{math.log(outcome.seconds / before[1]) / math.log(n / before[0]):.2f}"
    end = "out of time" if outcome.timed_out else outcome.code
    print(f"| {what} | {n} | {outcome.seconds:.2f} | {outcome.peak_bytes / 2**20:.0f} | {exponent} | {ratio} | {end} |", flush=True)
    return n, outcome.seconds


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", required=True)
    options.add_argument("--largest", type=int, default=10000)
    options.add_argument("--only", nargs="*", choices=COUNTED + ("maps",), default=list(COUNTED) + ["maps"])
    given = options.parse_args()
    print("| what is counted | n | time [s] | memory [MiB] | exponent | over psd | exit code |\n|---|---|---|---|---|---|---|")
    samples = Samples.__new__(Samples)
    samples.program = Path(given.program).resolve()
    with tempfile.TemporaryDirectory(prefix="growth_") as folder:
        for what in (w for w in COUNTED if w in given.only):
            before, n = None, 10
            while n <= given.largest:
                work = Path(folder) / f"{what}_{n}"
                work.mkdir()
                words = getattr(Growth(samples, work), what)(n)
                before = line(what, n, run(samples.program, *words, cwd=work, seconds=LIMIT_S), before)
                shutil.rmtree(work)
                n *= 10
        before = {}
        for side in SIDES if "maps" in given.only else ():
            path, psd = Growth(samples, Path(folder)).map(side), None
            for verb in ON_MAPS:
                outcome = run(samples.program, verb, path, "--threads", "1", cwd=folder, seconds=LIMIT_S)
                psd = psd or outcome.seconds
                before[verb] = line(f"{verb}, pixels", side * side, outcome, before.get(verb), f"{outcome.seconds / psd:.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
