#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""survey.py SETAE [N] [SEED] [--write PAGE]: how often values that mark missing heights are found, and others taken for them.

N surfaces of each kind without marks, and 20 N with marks, are made by NumPy and read by `setae info`. --write PAGE writes the tables below
the line `<!-- survey -->` of PAGE.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import tempfile

import numpy as np

MARKER = "<!-- survey -->"
CODES = ("NO_DATA", "NO_DATA_SUSPECTED")


class Surfaces:
    """Random surfaces of many kinds; each method without underscore is a kind without marks."""

    def __init__(self, seed):
        self._rng = np.random.default_rng(seed)

    def _rough(self, nx=None, ny=None):
        """A self-affine surface with standard deviation 1."""
        rng = self._rng
        nx = nx or int(rng.choice([48, 64, 128, 256, 512]))
        ny = ny or int(rng.choice([40, 64, 128, 256]))
        qy = np.fft.fftfreq(ny)[None, :] if ny > 1 else np.zeros((1, 1))
        q = np.hypot(np.fft.fftfreq(nx)[:, None], qy)
        q[0, 0] = 1.0
        amplitude = q ** -((1.0 if ny > 1 else 0.5) + rng.uniform(0.0, 1.2))
        amplitude[0, 0] = 0.0
        heights = np.fft.ifft2(amplitude * np.fft.fft2(rng.standard_normal((nx, ny)))).real
        return heights / heights.std()

    def _grating(self, nx=200, ny=150):
        rng = self._rng
        angle, period = rng.choice([0.0, np.pi / 2, rng.uniform(0, np.pi)]), rng.uniform(6, 60)
        phase = (np.arange(nx)[:, None] * np.cos(angle) + np.arange(ny)[None, :] * np.sin(angle)) / period
        return (phase + rng.random()) % 1.0 < rng.uniform(0.15, 0.85)

    def _noise(self, shape):
        return self._rng.uniform(0.0005, 0.1) * self._rng.standard_normal(shape)

    def _discs(self, heights, count, radii):
        x, y = np.mgrid[: heights.shape[0], : heights.shape[1]]
        for _ in range(count):
            radius = self._rng.uniform(*radii)
            cx, cy = self._rng.uniform(0, heights.shape[0]), self._rng.uniform(0, heights.shape[1])
            yield (x - cx) ** 2 + (y - cy) ** 2, radius

    def self_affine(self):
        heights = self._rough() * 10 ** self._rng.uniform(-3, 2) + self._rng.uniform(-30, 30)
        return heights + self._rng.choice([0, 1]) * np.linspace(-3, 3, heights.shape[0])[:, None]

    def profiles(self):
        return self._rough(int(self._rng.choice([100, 500, 2000, 20000])), 1)[:, 0]

    def profiles_of_few_samples(self):
        return np.round(self._rough(int(self._rng.integers(8, 60)), 1)[:, 0], int(self._rng.integers(0, 3)))

    def quantised(self):
        heights = self._rough()
        return np.round(heights / np.ptp(heights) * self._rng.choice([2, 3, 5, 8, 16, 50, 256, 4096]))

    def integers_of_16_bits(self):
        heights = self._rough()
        return np.round(heights / np.ptp(heights) * self._rng.uniform(20, 60000)).clip(-32768, 32767).astype("<i2")

    def integers_saturated(self):
        return np.round(self._rough() * self._rng.uniform(5000, 40000)).clip(-32768, 32767).astype("<i2")

    def clipped_floor(self):
        heights = self._rough()
        return np.maximum(heights, np.quantile(heights, self._rng.uniform(0.05, 0.6)))

    def plateaus(self):
        heights = self._rough()
        return np.minimum(heights, np.quantile(heights, self._rng.uniform(0.4, 0.99)))

    def gratings_without_noise(self):
        return self._grating() * self._rng.uniform(1, 1000)

    def gratings(self):
        grating = self._grating() * 1.0
        return grating + self._noise(grating.shape)

    def gratings_quantised(self):
        grating = self._grating() * 1.0
        return np.round((grating + 0.1 * self._noise(grating.shape)) / self._rng.choice([0.001, 0.01, 0.05]))

    def gratings_with_one_exact_level(self):
        grating = self._grating()
        return np.where(grating, 1.0 + self._noise(grating.shape), 0.0)

    def pictures_of_two_levels(self):
        heights = self._rough(200, 200)
        return (heights > np.quantile(heights, self._rng.uniform(0.1, 0.9))) * self._rng.choice([1.0, 255.0, 0.3])

    def terraces(self):
        steps = np.floor(np.linspace(0, self._rng.uniform(2, 8), 256)[:, None] + 0.3 * self._rough(256, 200))
        return steps + self._noise(steps.shape)

    def spheres_on_a_plane(self):
        heights = np.zeros((256, 256))
        for squares, radius in self._discs(heights, int(self._rng.integers(3, 80)), (3, 25)):
            heights = np.maximum(heights, np.sqrt(np.maximum(radius**2 - squares, 0)))
        return heights

    def particles_on_a_rough_surface(self):
        heights = self._rng.uniform(0.01, 1) * self._rough(256, 256)
        for squares, radius in self._discs(heights, int(self._rng.integers(1, 20)), (2, 15)):
            heights = heights + np.sqrt(np.maximum(radius**2 - squares, 0)) * self._rng.uniform(0.5, 10)
        return heights

    def particles_saturated(self):
        heights = self.particles_on_a_rough_surface()
        return np.minimum(heights, heights.min() + np.ptp(heights) * self._rng.uniform(0.2, 0.9))

    def exact_mesas(self):
        heights = self._rng.uniform(0.01, 1) * self._rough(256, 256)
        (squares, radius), = self._discs(heights, 1, (5, 80))
        return np.where(squares < radius**2, self._rng.uniform(5, 100), heights)

    def masked(self):
        heights, mask = self._rough(200, 200), self._rough(200, 200)
        return np.where(mask > np.quantile(mask, self._rng.uniform(0.4, 0.98)), np.nan, heights)

    def spikes(self):
        heights = self._rough()
        at = self._rng.integers(0, heights.size, int(self._rng.integers(1, 30)))
        heights.flat[at] += self._rng.uniform(5, 1000, at.size)
        return heights

    def heavy_tails(self):
        return self._rng.standard_t(1.5, (128, 128))

    def waves(self):
        return np.add.outer(np.sin(2 * np.pi * np.arange(256) / self._rng.choice([16, 32, 50])), np.zeros(128))

    def planes(self):
        return np.add.outer(np.arange(100) * 0.5, np.arange(80) * self._rng.choice([0, 0.25]))

    def _marked(self):
        """Heights with a mark, the mark and how many there are."""
        rng = self._rng
        line = rng.random() < 0.35
        heights = self._rough(int(rng.choice([300, 2000, 10000])), 1) if line else self._rough()
        heights = heights * 10 ** rng.uniform(-3, 2) + rng.uniform(-20, 20)
        share, (nx, ny) = rng.choice([0.0005, 0.003, 0.02, 0.1, 0.3, 0.45]), heights.shape
        pattern = rng.integers(0, 4)
        if pattern == 0:
            mask = rng.random(heights.shape) < share
        elif pattern == 1:
            field = self._rough(nx, ny)
            mask = field > np.quantile(field, 1 - share)
        elif pattern == 2:
            mask = np.zeros(heights.shape, bool)
            mask[: max(1, int(share * nx / 2))] = True
        else:
            mask = np.zeros(heights.shape, bool)
            for _ in range(max(1, int(share * heights.size / 15))):
                x, y = int(rng.integers(0, nx)), int(rng.integers(0, ny))
                mask[x : x + int(rng.geometric(1 / 15)), y] = True
        if mask.sum() < 3:
            mask.flat[rng.integers(0, heights.size, 4)] = True
        mark = rng.choice([-9999, -25400, -32768, 0, 3.402823466e38, 1e30, 999.999, -1e10, 65535, -999])
        return np.where(mask, mark, heights)[:, 0] if line else np.where(mask, mark, heights), mark, int(mask.sum())


def read(program, folder, heights):
    path = pathlib.Path(folder) / "heights.npy"
    np.save(path, heights)
    size = "1 mm" if heights.ndim == 1 else "1 mm x 1 mm"
    done = subprocess.run([program, "info", path, "--unit", "um", "--size", size, "--json"], capture_output=True, text=True, check=True)
    channel = json.loads(done.stdout)["channels"][0]
    return {alert["code"] for alert in channel["alerts"]}, channel["undefined_count"]


def false_alarms(program, folder, surfaces, count):
    lines = ["| surfaces without marks | n | NO_DATA | NO_DATA_SUSPECTED |", "|---|---|---|---|"]
    kinds = [name for name in vars(Surfaces) if not name.startswith("_")]
    for kind in kinds:
        found = collections.Counter()
        for _ in range(count):
            codes, _ = read(program, folder, getattr(surfaces, kind)())
            found.update(codes & set(CODES))
        lines.append(f"| {kind.replace('_', ' ')} | {count} | {found[CODES[0]]} | {found[CODES[1]]} |")
    return lines


def recall(program, folder, surfaces, count):
    found = collections.defaultdict(collections.Counter)
    for _ in range(count):
        heights, mark, marked = surfaces._marked()
        codes, undefined = read(program, folder, heights)
        outcome = "all" if undefined == marked and CODES[0] in codes else "said" if codes & set(CODES) else "missed"
        found[f"{mark:g}"][outcome] += 1
    lines = ["| mark | files | all marks undefined | only suspected | missed |", "|---|---|---|---|---|"]
    for mark in sorted(found, key=float):
        n = found[mark]
        lines.append(f"| {mark} | {sum(n.values())} | {n['all']} | {n['said']} | {n['missed']} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("count", nargs="?", type=int, default=20)
    parser.add_argument("seed", nargs="?", type=int, default=1)
    parser.add_argument("--write", metavar="PAGE")
    arguments = parser.parse_args()
    program = str(pathlib.Path(arguments.program).resolve())
    surfaces = Surfaces(arguments.seed)
    with tempfile.TemporaryDirectory() as folder:
        lines = false_alarms(program, folder, surfaces, arguments.count)
        lines += [""] + recall(program, folder, surfaces, 20 * arguments.count)
    lines += ["", f"`tests/reference/no_data/survey.py build/bin/setae {arguments.count} {arguments.seed}`"]
    print("\n".join(lines))
    if arguments.write:
        page = pathlib.Path(arguments.write)
        before, after = page.read_text(encoding="utf-8").split(MARKER)
        rest = after[after.index("\n\nA false alarm") :]
        page.write_text(before + MARKER + "\n\n" + "\n".join(lines) + rest, encoding="utf-8")


if __name__ == "__main__":
    main()
