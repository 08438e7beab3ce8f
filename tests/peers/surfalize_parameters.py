#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of ISO 25178-2 by setae and by surfalize (PyPI) on the same heights, as the table at the end of docs/reference/parameters.md.

    python3 -m venv peers && peers/bin/pip install surfalize numpy
    peers/bin/python tests/peers/surfalize_parameters.py --setae build/bin/setae

Exits with 77 where surfalize is missing, with 1 where a parameter of equal definition differs by more than its tolerance.
"""
import argparse
import csv
import io
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

try:
    import numpy
    from surfalize import Surface
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

warnings.simplefilter("ignore")
PIXEL = 0.25  # µm
# against sorted points: rounding, but for the core's line, which setae fits to nodes between which the curve falls by at most 1/1024;
# where it ends, few points are many of the peaks
SORTED_TOLERANCE = {"Sk": 1e-4, "Spk": 1e-2, "Svk": 1e-3, "Smrk1": 1e-2, "Smrk2": 1e-4}


def by_sorting(heights):
    """The functional parameters straight from sorted points: material ratio (k + 1/2)/n of the k-th highest."""
    z = numpy.sort(heights.ravel() - heights.mean())[::-1] * 1e-6
    n = z.size
    ratio = (numpy.arange(n) + 0.5) / n
    width = round(0.4 * n)
    start = numpy.argmin(z[:-width] - z[width:])
    slope, upper = numpy.polyfit(ratio[start:start + width], z[start:start + width], 1)
    lower = upper + slope
    above, below = numpy.maximum(z - upper, 0).mean(), numpy.maximum(lower - z, 0).mean()
    first, last = (z >= upper).mean(), (z >= lower).mean()

    def height(p):
        return z[int(numpy.ceil(p * n)) - 1]

    def material(p):
        return numpy.maximum(z - height(p), 0).mean()

    def void(p):
        return numpy.maximum(height(p) - z, 0).mean()

    return {"Sk": upper - lower, "Spk": 2 * above / first, "Svk": 2 * below / (1 - last), "Smrk1": first, "Smrk2": last,
            "Vmp": material(0.1), "Vmc": material(0.8) - material(0.1), "Vvc": void(0.1) - void(0.8), "Vvv": void(0.8),
            "Sxp": height(0.025) - height(0.5), "Sdc": height(0.02) - height(0.98), "Smc(p)": height(0.5), "Smr(c)": (z >= 0).mean()}


def pixels(surface):
    """surfalize's area, between the outer points, over that of all pixels."""
    return surface.projected_area() / (surface.size.x * surface.size.y * PIXEL**2)


# symbol of setae: how surfalize says it, its unit in SI, largest relative difference where definitions are the same
SAME = {
    "Sq": (lambda s: s.Sq(), 1e-6, 1e-9), "Sa": (lambda s: s.Sa(), 1e-6, 1e-9), "Ssk": (lambda s: s.Ssk(), 1, 1e-8),
    "Sku": (lambda s: s.Sku(), 1, 1e-9), "Sp": (lambda s: s.Sp(), 1e-6, 1e-9), "Sv": (lambda s: s.Sv(), 1e-6, 1e-9),
    "Sz": (lambda s: s.Sz(), 1e-6, 1e-9), "Sdq": (lambda s: s.Sdq(), 1, 1e-9), "Sdr": (lambda s: s.Sdr(), 1e-2, 1e-9),
    "Sk": (lambda s: s.Sk(), 1e-6, 1e-4), "Spk": (lambda s: s.Spk(), 1e-6, 2e-2), "Svk": (lambda s: s.Svk(), 1e-6, 1e-3),
    "Smrk1": (lambda s: s.Smr1(), 1e-2, 5e-3), "Smrk2": (lambda s: s.Smr2(), 1e-2, 1e-4), "Vmp": (lambda s: s.Vmp(), 1e-6, 3e-3),
    "Vmc": (lambda s: s.Vmc(), 1e-6, 2e-3), "Vvc": (lambda s: s.Vvc(), 1e-6, 5e-4), "Vvv": (lambda s: s.Vvv(), 1e-6, 5e-4),
    "Sxp": (lambda s: s.Sxp(), 1e-6, 5e-4), "Sdc": (lambda s: s.Sdc(2, 98), 1e-6, 5e-4), "Spkx": (lambda s: s.Spkx(), 1e-6, 5e-4),
    "Svkx": (lambda s: s.Svkx(), 1e-6, 1e-4), "Sak1": (lambda s: s.Sak1(), 1e-8, 3e-2), "Sak2": (lambda s: s.Sak2(), 1e-8, 1e-3),
    "Smr(c)": (lambda s: s.Smr(0), 1e-2, 1e-4), "Smc(p)": (lambda s: s.Smc(50), 1e-6, 3e-3), "Sal": (lambda s: s.Sal(), 1e-6, 1e-2), "Str": (lambda s: s.Str(), 1, 2e-2),
    "Spd": (lambda s: s.Spd() * pixels(s), 1e12, 1e-9), "Svd": (lambda s: s.Svd() * pixels(s), 1e12, 5e-3), "Spc": (lambda s: s.Spc(), 1e6, 1e-9),
    "Svc": (lambda s: s.Svc(), 1e6, 1e-3), "S5p": (lambda s: s.S5p(), 1e-6, 1e-9), "S5v": (lambda s: s.S5v(), 1e-6, 1e-9),
    "S10z": (lambda s: s.S10z(), 1e-6, 1e-9),
}


def random_surface(n, hurst, stretch, seed):
    """Heights in µm with power-law spectrum above a roll-off, longer along x by `stretch`."""
    generator = numpy.random.default_rng(seed)
    k = numpy.fft.fftfreq(n) * n
    q = numpy.hypot(stretch * k[:, None], k[None, :])
    amplitude = numpy.where(q > 0, numpy.maximum(q, n / 24) ** -(1 + hurst), 0)
    heights = numpy.fft.ifft2(amplitude * numpy.fft.fft2(generator.standard_normal((n, n)))).real
    return heights / heights.std()


def surfaces():
    yield "isotropic, Gaussian", random_surface(256, 0.8, 1.0, 1) * 0.1
    yield "lay along x, Gaussian", random_surface(256, 0.8, 3.0, 2) * 0.1
    skewed = random_surface(256, 0.8, 1.0, 3)
    yield "plateaus with pits", -numpy.exp(-1.2 * skewed) * 0.02


def of_setae(program, heights, folder):
    """Parameters of points, as surfalize's are."""
    path = Path(folder) / "heights.npy"
    numpy.save(path, heights * 1e-6)
    size = f"{PIXEL * heights.shape[0]} um x {PIXEL * heights.shape[1]} um"
    command = [program, "params", str(path), "--size", size, "--unit", "m", "--trend", "none", "--standard", "iso25178", "--format", "tsv"]
    tables = {}
    for between in ("nothing", "linear"):
        text = subprocess.run(command + ["--between", between], check=True, capture_output=True, text=True).stdout
        tables[between] = {row["symbol"]: float(row["value"] or "nan") for row in csv.DictReader(io.StringIO(text), delimiter="\t")}
    return tables


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--setae", required=True)
    arguments = parser.parse_args()
    failures = []
    for name, heights in surfaces():
        heights = heights - heights.mean()
        theirs = Surface(heights.T, PIXEL, PIXEL)
        with tempfile.TemporaryDirectory() as folder:
            ours = of_setae(arguments.setae, heights, folder)
        print(f"\n### {name}\n\n| symbol | setae | surfalize | difference | sorted points | difference | setae on triangles |\n|---|---|---|---|---|---|---|")
        direct = by_sorting(heights)
        for symbol, (function, unit, tolerance) in SAME.items():
            expected, value = function(theirs) * unit, ours["nothing"][symbol]
            difference = abs(value - expected) / abs(expected) if value != expected else 0.0
            if not (difference <= tolerance or value != value and expected != expected):
                failures.append(f"{name}: {symbol} {value:.7g} against {expected:.7g}")
            plain = "| |"
            if symbol in direct:
                off = abs(value - direct[symbol]) / abs(direct[symbol])
                plain = f"| {direct[symbol]:.6g} | {off:.1g}"
                if not off <= SORTED_TOLERANCE.get(symbol, 1e-9):
                    failures.append(f"{name}: {symbol} {value:.7g} against {direct[symbol]:.7g} of sorted points")
            print(f"| {symbol} | {value:.6g} | {expected:.6g} | {difference:.1g} {plain} | {ours['linear'][symbol]:.6g} |")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
