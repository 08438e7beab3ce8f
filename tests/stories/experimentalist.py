#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""experimentalist.py SETAE: a folder of measurements and loops becomes the figure of the paper in at most six commands."""
import csv
import json
import re
import shutil

from terminal import require, require_close, terminal

# the instruments, small enough for a test
RECIPE = """
seed = 3
work_of_adhesion = "37 mJ/m2"
[rough_solid]
youngs_modulus = "1100 GPa"
poisson_ratio = 0.06
[protocols.few]
stylus = { lengths = ["200 um", "200 um", "200 um"], step = "0.2 um", tip_radius = "5 ± 0.2 um", noise = "0.1 nm" }
afm = { sizes = ["5 um", "1 um", "250 nm"], pixels = 128, tip_radius = "10 ± 0.5 nm", noise = "0.02 nm" }
tem = { lengths = ["100 nm", "50 nm", "50 nm"], step = "0.2 nm" }
[surfaces.rough]
protocol = "few"
spectrum = { model = "self_affine", hurst_exponent = 0.8, rolloff_wavelength = "1 um", short_wavelength = "4 angstrom", rms_slope = 0.6 }
[elastomers.soft]
youngs_modulus = "0.7 MPa"
surface_energy = "25 ± 1 mJ/m2"
sphere_radius = "1.25 mm"
[elastomers.stiff]
youngs_modulus = "1.9 MPa"
surface_energy = "25 ± 1 mJ/m2"
sphere_radius = "1.25 mm"
[loops]
force_noise = "0.1 uN"
displacement_noise = "0.5 nm"
radius_noise = "0.1 um"
"""


ANSWERS = {
    r'# tip_radius = "\?" *# such as "10.*': 'tip_radius = "10 ± 0.5 nm"',
    r'# tip_radius = "\?" *# such as "5.*': 'tip_radius = "5 ± 0.2 um"',
    r'# (\[|[a-z_]* = )': r"\1",
    r"power_spectrum.*": "",
    r'youngs_modulus = "\?"': 'youngs_modulus = "1100 GPa"',
    r'poisson_ratio = "\?"': "poisson_ratio = 0.06",
    r'surface_energy = "\?"': 'surface_energy = "25 ± 1 mJ/m2"',
    r'sphere_radius = "\?"': 'sphere_radius = "1.25 mm"',
}


def answer(draft):
    """Fills in what the draft asks, as an experimenter does who knows tips and constants."""
    text = draft.read_text(encoding="utf-8").split("\n# Left out:")[0]
    for asked, known in ANSWERS.items():
        text = re.sub("^" + asked, known, text, flags=re.MULTILINE)
    draft.write_text(text, encoding="utf-8")


def main():
    with terminal() as user:
        (user.folder / "recipe.toml").write_text(RECIPE, encoding="utf-8")
        user.types("setae lab make recipe.toml -o made")
        shutil.copytree(user.folder / "made", user.folder / "mine", ignore=shutil.ignore_patterns("truth.*", "study.toml"))
        truth = json.loads((user.folder / "made/truth.json").read_text(encoding="utf-8"))

        user.typed = 0  # the files are there
        listing = user.types("setae info mine")
        require(listing.count("\n") >= 9, f"info lists {listing.count(chr(10))} lines for nine files")
        user.types("setae study init mine -o mine/study.toml")
        answer(user.folder / "mine/study.toml")
        user.types("setae study mine/study.toml --dry-run")  # exit code 1 where a file is missing
        screen = user.types("setae study mine/study.toml --no-figures")
        require(len(screen.splitlines()) <= 40, f"the screen has {len(screen.splitlines())} lines")
        user.types("setae plot mine/study.toml --figure 4 --width single -o figure_4.pdf")
        user.types("setae plot mine/study.toml --figure 4 -o figure_4.csv")
        require(user.typed <= 6, f"{user.typed} commands")

        require((user.folder / "figure_4.pdf").read_bytes().startswith(b"%PDF-"), "figure_4.pdf is no PDF")
        with open(user.folder / "figure_4.csv", encoding="utf-8") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        require(len(rows) >= 1 + len(truth["pairs"]), f"the figure's table has {len(rows)} rows")
        study = json.loads((user.folder / "mine/study_results/study.json").read_text(encoding="utf-8"))
        require_close(study["work_of_adhesion"]["value"], truth["work_of_adhesion"], 0.02, "W_int")
        require_close(study["surfaces"]["rough"]["rms_slope"]["value"], truth["surfaces"]["rough"]["rms_slope"], 0.15, "slope")


if __name__ == "__main__":
    main()
