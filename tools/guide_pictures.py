#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""guide_pictures.py SETAE: draws pictures of guides into docs/figures, SVG of at most 60 kB and PNG of at most 120 kB. Needs gnuplot, which
SETAE calls, and Pillow.

force_curve       a simulated curve of a colloidal probe with its fit
scale_bar         a picture with a scale bar, its trace and the bar that was found
tip               a map, and its points that are certainly the surface
budget_tutorial   contributions to W_int of the tutorial's study
budget_published  contributions to W_int of the published study
preloads          energy loss of loops with four preloads against the contact area
"""

import pathlib
import re
import subprocess
import sys
import tempfile

from PIL import Image

TOP = pathlib.Path(__file__).resolve().parents[1]
PICTURES = TOP / "docs/figures"
TUTORIAL = TOP / "examples/tutorial/recipe.toml"
MAX_BYTES = {".svg": 60_000, ".png": 120_000}
PROBE = """
seed = 3
work_of_adhesion = "37 mJ/m2"

[rough_solid]
youngs_modulus = "1100 GPa"
poisson_ratio = 0.06

[protocols.short]
afm = { sizes = ["1 um"], pixels = 64, tip_radius = "10 nm" }

[surfaces.plate]
protocol = "short"
spectrum = { model = "self_affine", hurst_exponent = 0.8, rolloff_wavelength = "0.3 um", short_wavelength = "4 angstrom", rms_slope = 0.3 }

[elastomers.soft]
youngs_modulus = "1 MPa"
surface_energy = "25 mJ/m2"
sphere_radius = "10 um"

[loops]
maximum_force = "2 uN"
speed = "200 nm/s"
force_rate = "9 Hz"
force_noise = "10 nN"
displacement_noise = "1 nm"
"""


class Pictures:
    """Commands in a folder of their own."""

    def __init__(self, program, folder):
        self.program, self.folder = program, pathlib.Path(folder)

    def setae(self, *words):
        subprocess.run([self.program, *map(str, words)], cwd=self.folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def make(self, recipe, name):
        """A data set of a recipe."""
        (self.folder / f"{name}.toml").write_text(recipe, encoding="utf-8")
        self.setae("lab", "make", f"{name}.toml", "-o", name)

    def reduced(self, name, colours, method, box=None, width=None):
        """A PNG, or a box of it, with few colours in docs/figures."""
        picture = Image.open(self.folder / name).convert("RGB").crop(box)
        if width:
            picture = picture.resize((width, round(picture.height * width / picture.width)), Image.Resampling.LANCZOS)
        picture.quantize(colours, method, dither=Image.Dither.NONE).save(PICTURES / name, optimize=True)

    def force_curve(self):
        self.make(PROBE, "probe")
        rows = (self.folder / "probe/loops/plate_soft.csv").read_text(encoding="utf-8").splitlines()
        curve = "\n".join(",".join(row.split(",")[1:3]) for row in rows)  # force and displacement, as an AFM records them
        (self.folder / "curve.csv").write_text(curve + "\n", encoding="utf-8")
        self.setae("jkr", "fit", "curve.csv", "--radius", "10 um", "--width", "double", "-o", PICTURES / "force_curve.svg")

    def scale_bar(self):
        self.setae("contour", TOP / "tests/cli/data/scale_bar.png", "-o", "scale_bar.csv")
        self.reduced("scale_bar.png", 200, Image.Quantize.MAXCOVERAGE, box=(0, 290, 640, 720))

    def tip(self):
        """The map plus the difference of reconstruction and map, which is undefined where the surface is not certain."""
        self.setae("level", "mine/rougher/afm_2.txt", "--step", "level_plane", "-o", "map.x3p")
        self.setae("tip", "map.x3p", "--points", "31", "--threshold", "0.2 nm", "--reconstruction", "surface.x3p")
        self.setae("level", "surface.x3p", "--step", "subtract_map file=map.x3p", "-o", "certain.x3p")
        self.setae("level", "map.x3p", "--step", "add_map file=certain.x3p", "--width", "double", "-o", "tip.png")
        self.reduced("tip.png", 160, Image.Quantize.MEDIANCUT, width=1000)

    def budgets(self):
        for name, study in (("tutorial", "mine/study.toml"), ("published", TOP / "examples/nanodiamond/published.toml")):
            self.setae("plot", study, "--figure", "budget", "--progress", "none", "-o", PICTURES / f"budget_{name}.svg")

    def preloads(self):
        recipe = re.sub(r'^retraction = .*\n', 'retraction = "opening"\nopening_work = "59 mJ/m2"\n', TUTORIAL.read_text(encoding="utf-8"), flags=re.M)
        recipe = re.sub(r"^loss_factor.*\n", "", recipe, flags=re.M)
        loops = []
        for force in ("0.1", "0.3", "1", "3"):
            name = f"preload_{force}"
            self.make(re.sub(r'^maximum_force = .*', f'maximum_force = "{force} mN"', recipe, flags=re.M), name)
            loops.append((self.folder / f"{name}/loops/rougher_soft.csv").rename(self.folder / f"{name}.csv").name)
        self.setae("jkr", "energy", *loops, "--radius", "1.25 mm", "--area-ratio", "1.318", "--figures", "preloads")
        (PICTURES / "preloads.svg").write_bytes((self.folder / "preloads/losses.svg").read_bytes())


def main():
    with tempfile.TemporaryDirectory() as folder:
        pictures = Pictures(str(pathlib.Path(sys.argv[1]).resolve()), folder)
        pictures.make(TUTORIAL.read_text(encoding="utf-8"), "mine")
        for draw in (pictures.force_curve, pictures.scale_bar, pictures.tip, pictures.budgets, pictures.preloads):
            draw()
    made = [PICTURES / name for name in ("force_curve.svg", "scale_bar.png", "tip.png", "budget_tutorial.svg", "budget_published.svg", "preloads.svg")]
    print("\n".join(f"{path.name}: {path.stat().st_size} bytes" for path in made))
    return int(any(path.stat().st_size > MAX_BYTES[path.suffix] for path in made))


if __name__ == "__main__":
    sys.exit(main())
