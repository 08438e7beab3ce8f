#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""real_files.py SETAE: a container of three instruments and a sensor's loops become figures in at most six commands.

Skipped where the files are missing; published numbers of them stand in the folder's own DATA.md.
"""
import os
import pathlib
import shutil
import sys

from terminal import require, require_close, terminal

STUDY = """
work_of_adhesion = "37.0 ± 3.7 mJ/m2"
rough_solid = { youngs_modulus = "1100 GPa", poisson_ratio = 0.06 }
[surfaces.UNCD]
measurements = [
  { file = "container-2.zip", channel = 0, instrument = "tem" },
  { file = "container-2.zip", channel = 1, instrument = "afm", tip_radius = "21.5 ± 4.5 nm" },
  { file = "container-2.zip", channel = 2, instrument = "stylus", tip_radius = "5 ± 1 um" },
]
[elastomers.PDMS]
youngs_modulus = "0.69 ± 0.02 MPa"
surface_energy = "25 ± 5 mJ/m2"
sphere_radius = "1.25 mm"
"""
DATA = pathlib.Path(os.environ.get("SETAE_REFERENCE_DATA", "../shared/data")).resolve()
FILES = ("topography/surfacetopography/container-2.zip", "jkr/pdms_a.txt", "jkr/pdms_b.txt", "jkr/pdms_c.txt")


def main():
    for file in FILES:
        if not (DATA / file).is_file():
            print(f"skipped: no {DATA / file}; set SETAE_REFERENCE_DATA to the folder with the real files")
            sys.exit(77)
    examples = pathlib.Path("examples").resolve()
    with terminal() as user:
        for file in FILES:
            shutil.copy(DATA / file, user.folder)
        shutil.copy(examples / "mappings/eoh.toml", user.folder)

        listing = user.types("setae info container-2.zip")
        require("512 × 512" in listing and "3001" in listing, listing)
        (user.folder / "uncd.toml").write_text(STUDY, encoding="utf-8")
        user.types("setae study uncd.toml --no-figures")
        user.types("setae plot uncd.toml --figure 1 -o roughness.svg")
        fits = user.reads('setae jkr fit pdms_a.txt pdms_b.txt pdms_c.txt --map eoh.toml --radius "7.5 um" --figures loops')
        require(user.typed <= 6, f"{user.typed} commands")

        require("<svg" in (user.folder / "roughness.svg").read_text(encoding="utf-8"), "roughness.svg is no picture")
        for name in ("pdms_a_loop.svg", "pdms_b_loop.svg", "pdms_c_loop.svg", "ranges.svg"):
            require((user.folder / "loops" / name).is_file(), f"no loops/{name}")
        # 2|F_po|/(3 pi R) by an independent analysis of the same files, mJ/m²
        for loop, published in zip(fits, (59.6, 59.1, 59.8)):
            require_close(1e3 * loop["pull_off"]["work_of_adhesion"]["value"], published, 0.002, f"W of the pull-off of {loop['file']}")


if __name__ == "__main__":
    main()
