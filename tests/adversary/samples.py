# SPDX-License-Identifier: GPL-3.0-or-later
"""Files the attacks begin with: every format the tests can build, a small laboratory, and texts that users write."""
import math
import random
import shutil
import subprocess
from pathlib import Path

RECIPE_SEED = "7"


class Samples:
    """A folder of them; attacks copy what they change."""

    def __init__(self, program, make_corpus, source, folder):
        self.program, self.folder = Path(program), Path(folder)
        corpus = self.folder / "corpus"
        subprocess.run([str(make_corpus), str(corpus)], check=True, stdout=subprocess.DEVNULL)
        self.formats = sorted(p for p in corpus.rglob("*") if p.is_file() and p.stat().st_size <= 1 << 20)
        self.laboratory = self.folder / "laboratory"
        subprocess.run([str(program), "lab", "make", str(Path(source) / "examples/laboratory/recipe.toml"), "-o",
                        str(self.laboratory), "--seed", RECIPE_SEED], check=True, stdout=subprocess.DEVNULL)
        self.examples = Path(source) / "examples"
        self.loops = sorted(self.laboratory.rglob("*.csv"))
        self.study = self.laboratory / "study.toml"

    def profile(self, folder, name="a.csv", points=400, seed=1):
        """A line scan of two columns with units."""
        draw = random.Random(seed)
        path, height = Path(folder) / name, 0.0
        rows = ["x [um],z [nm]"]
        for i in range(points):
            height += draw.gauss(0.0, 1.0)
            rows.append(f"{0.01 * i:.3f},{height:.4f}")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join(rows) + "\n")
        return path

    def loop(self, folder, name="l.csv"):
        path = Path(folder) / name
        shutil.copy(self.loop_file(), path)
        return path

    def loop_file(self):
        return next(p for p in self.loops if "force" in p.read_text(errors="replace")[:2000])

    def small_loop(self, folder, name, seed=1, points=40):
        """A press and release by JKR of 1 mm, 1 MPa, 30 mJ/m2 in and 60 mJ/m2 out, with noise by the seed: so many rows on each branch."""
        draw, radius, modulus = random.Random(seed), 1e-3, 1e6
        rows = ["time [s],force [uN],displacement [nm],contact_radius [um]"]

        def add(a, work):
            deep = a * a / radius - math.sqrt(2.0 * math.pi * work * a / modulus) if work else a
            force = 4.0 * modulus * a**3 / (3.0 * radius) - math.sqrt(8.0 * math.pi * work * modulus * a**3) if work else 0.0
            rows.append(f"{0.1 * len(rows):.1f},{1e6 * force + draw.gauss(0.0, 0.2):.5f},{1e9 * deep + draw.gauss(0.0, 1.0):.4f},"
                        f"{1e6 * a + draw.gauss(0.0, 0.05) if work else 0.0:.5f}")

        def contact(work, share):  # a^(3/2) = share R sqrt(2 pi W/E*): 1 at no displacement, 1/4 at pull-off of fixed grips
            return (share * radius * math.sqrt(2.0 * math.pi * work / modulus)) ** (2.0 / 3.0)

        for i in range(points // 4):  # free flight: the displacement itself, no radius
            add(-2e-6 * (1.0 - 4.0 * i / points), 0.0)
        for work, first, last in ((0.03, contact(0.03, 1.0), 1.4e-4), (0.06, 1.4e-4, contact(0.06, 0.26))):
            for i in range(points):
                add(first + (last - first) * i / (points - 1), work)
        for i in range(points // 4):
            add(-2e-6 * (1.0 + 4.0 * i / points), 0.0)
        path = Path(folder) / name
        path.write_text("\n".join(rows) + "\n")
        return path

    def surface_study(self, folder, names=("A",), files=None, output=None, top=""):
        """A study of surfaces alone, each of two scans of its own or of `files`, averaged: it takes half a second."""
        folder = Path(folder)
        text = f'title = "adversary"\n{top}' + (f'output = "{output}"\n' if output else "")
        text += '[analysis]\nspectrum = "average"\nbootstrap_resamples = 0\n'
        for i, name in enumerate(names):
            listed = files or [self.profile(folder, f"scan_{i}_{k}.csv", seed=10 * i + k).name for k in range(2)]
            entries = ", ".join(f'{{ file = {toml_text(f)}, instrument = "stylus" }}' for f in listed)
            text += f"[surfaces.{toml_text(name)}]\nmeasurements = [{entries}]\n"
        path = folder / "study.toml"
        path.write_text(text)
        return path


    def loop_study(self, folder, files, keys=""):
        """A study of one surface and one loop on each of as many elastomers, whose tables hold `keys` as well."""
        path = self.surface_study(folder)
        text = path.read_text() + '[rough_solid]\nyoungs_modulus = "1100 GPa"\npoisson_ratio = 0.06\n'
        for i, file in enumerate(files):
            text += f'[elastomers.E{i}]\n{keys if i == 0 else ""}'
            text += "".join(f'{key} = "{value}"\n' for key, value in {"surface_energy": "25 mJ/m2", "sphere_radius": "1.25 mm"}.items()
                            if i > 0 or key not in keys)
            text += f'[[experiments]]\nfile = {toml_text(str(file))}\nsurface = "A"\nelastomer = "E{i}"\n'
        path.write_text(text)
        return path


def toml_text(text):
    return '"' + "".join(f"\\u{ord(c):04x}" if ord(c) < 32 or c in '"\\\x7f' else c for c in text) + '"'
