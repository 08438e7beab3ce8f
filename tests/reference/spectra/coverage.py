#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard errors and intervals of C1D of one map against the scatter between maps, and false alarms of self-affine fits.

    coverage.py SETAE [MAPS]

Maps are made here, by numpy alone: Gaussian heights with a given C_iso on 512 x 512 points, of which 256 x 256 are kept,
5 um wide; for fits also on 1024 x 1024 points, of which every second is kept. Prints the tables of docs/validation/spectra.md. SETAE: the program; MAPS: of each kind, 400 by default.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy

POINTS, SIZE = 256, 5e-6
RANGES = ((1, 1), (2, 3), (4, 8), (9, 20), (21, 50), (51, 120))  # of modes


def gaussian(length):
    """Autocorrelation exp(-(r/length)^2)."""
    return lambda q: numpy.exp(-((q * length / 2) ** 2))


def self_affine(hurst, rolloff, longest=2 * numpy.pi / 1e-4):
    """Power law with a plateau beyond the roll-off wavelength; None: without plateau."""
    knee = 2 * numpy.pi / rolloff if rolloff else longest
    return lambda q: numpy.maximum(q / knee, 1.0) ** (-2 - 2 * hurst)


KINDS = {
    "Gaussian, 100 nm": gaussian(100e-9),
    "Gaussian, 250 nm": gaussian(250e-9),
    "Gaussian, 600 nm": gaussian(600e-9),
    "H = 0.8, roll-off 1 µm": self_affine(0.8, 1e-6),
    "H = 0.5, roll-off 0.3 µm": self_affine(0.5, 0.3e-6),
    "H = 0.8, no roll-off": self_affine(0.8, None),
}


def amplitudes(density, finer=1):
    """Square root of C_iso at the modes of a map twice as wide; finer: points per point that is kept, along each side."""
    points, size = 2 * POINTS * finer, 2 * SIZE
    along_x = 2 * numpy.pi * numpy.fft.fftfreq(points, size / points)
    along_y = 2 * numpy.pi * numpy.fft.rfftfreq(points, size / points)
    wavevector = numpy.hypot(along_x[:, None], along_y[None, :])
    result = numpy.sqrt(density(wavevector))
    result[0, 0] = 0.0
    return result


def drawn(amplitude, random):
    points = len(amplitude)
    finer = points // (2 * POINTS)
    noise = numpy.fft.rfft2(random.normal(size=(points, points)))
    heights = numpy.fft.irfft2(noise * amplitude, (points, points))[: finer * POINTS : finer, : finer * POINTS : finer]
    return 2e-9 * points * heights / numpy.sqrt(2 * (amplitude**2).sum())  # one factor for all maps of a kind


def answer(setae, heights, folder, *options):
    path = pathlib.Path(folder) / "map.npy"
    numpy.save(path, heights)
    command = [setae, "psd", path, "--size", "5um x 5um", "--unit", "m", "--json", *options]
    return json.loads(subprocess.run(command, check=True, capture_output=True).stdout)


def coverage(setae, maps, folder):
    print("| surface | levelled | modes | scatter between maps | stated | 95 % interval holds | C1D ± 1.96 SE holds |")
    print("|---|---|---|---|---|---|---|")
    for seed, (name, density) in enumerate(KINDS.items()):
        amplitude = amplitudes(density)
        for levelled in ("mean", "tilt"):
            random = numpy.random.default_rng([seed, levelled == "tilt"])
            found = []
            for _ in range(maps):
                heights = drawn(amplitude, random)
                psd = answer(setae, heights, folder, "--trend", levelled)
                found.append([psd[key] for key in ("C1D", "standard_error", "interval_low", "interval_high")])
            density_of, error, low, high = numpy.moveaxis(numpy.array(found), 1, 0)
            truth = density_of.mean(axis=0)
            for first, last in RANGES:
                at = slice(first - 1, last)
                if truth[at].min() < 1e-8 * truth.max():
                    continue  # below the window's and the rounding's floor
                scatter = numpy.sqrt((density_of[:, at].std(axis=0) ** 2 / truth[at] ** 2).mean())
                stated = numpy.sqrt(((error / density_of)[:, at] ** 2).mean())
                held = ((low < truth) & (high > truth))[:, at].mean()
                symmetric = (abs(density_of - truth) < 1.96 * error)[:, at].mean()
                print(
                    f"| {name} | {'yes' if levelled == 'tilt' else 'no'} | {first}–{last} | {scatter:.3f} | {stated:.3f} | "
                    f"{100 * held:.1f} % | {100 * symmetric:.1f} % |"
                )


def false_alarms(setae, maps, folder):
    print("\n| surface | waves | fits | MODEL_MISSES_BEYOND | FIT_AT_BOUND | MODEL_MISSES |")
    print("|---|---|---|---|---|---|")
    for seed, (name, density) in enumerate(KINDS.items()):
        for finer, waves in ((1, "end at the pixel"), (2, "end at half a pixel")):
            amplitude = amplitudes(density, finer)
            random = numpy.random.default_rng([7, seed])
            counts = dict.fromkeys(("MODEL_MISSES_BEYOND", "FIT_AT_BOUND", "MODEL_MISSES"), 0)
            for _ in range(maps):
                fit = answer(setae, drawn(amplitude, random), folder, "--trend", "tilt", "--fit")["fit"]
                codes = {alert["code"] for alert in fit["alerts"]}
                for code in counts:
                    counts[code] += code in codes
            shares = " | ".join(f"{100 * count / maps:.1f} %" for count in counts.values())
            print(f"| {name} | {waves} | {maps} | {shares} |", flush=True)


def main():
    setae = sys.argv[1]
    maps = int(sys.argv[2]) if len(sys.argv) > 2 else 400
    with tempfile.TemporaryDirectory() as folder:
        coverage(setae, maps, folder)
        false_alarms(setae, max(1, maps // 2), folder)


if __name__ == "__main__":
    main()
