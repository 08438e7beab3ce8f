#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""gallery.py PROGRAM FOLDER: a page of figures with the commands that draw them: one figure of each command that draws, then every figure that
`setae plot` draws of two studies of the examples."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
import sys
from typing import NamedTuple

TOP = pathlib.Path(__file__).resolve().parents[2]
SCAN = 'setae synthesize --hurst 0.8 --rolloff "2 um" --short-cutoff "1 nm" --rms-height "30 nm" --size "5 um" --pixels 512 --seed 1 -o scan.gwy'
SMALL = (
    'setae synthesize --hurst 0.8 --rolloff "64 nm" --short-cutoff "16 nm" --rms-height "12 nm" --exact-rms --pixels 64x64 --size "256 nm"'
    " -o small.gwy"
)
LOOP = 'mine/loops/rougher_soft.csv --radius "1.25 mm"'


class Drawing(NamedTuple):
    """A figure with the commands that draw it, and what it shows."""

    command: str
    figure: str
    shown: str
    lines: list[str]


SURFACES = [
    Drawing("psd", "psd.svg", "Power spectral density of an AFM map. The pale part is not reliable, because the tip does not follow it.",
            ['setae psd scan.gwy --instrument afm --tip-radius "10 nm" --fit -o psd.svg']),
    Drawing("params", "params.svg", "Shares of mean square height, slope and curvature, and of the stored energy, from waves longer than λ.",
            ['setae params scan.gwy --instrument afm --tip-radius "10 nm" -o params.svg']),
    Drawing("acf", "acf.svg", "Autocorrelation of height differences over all directions.", ["setae acf scan.gwy --area -o acf.svg"]),
    Drawing("sdrp", "sdrp.svg", "Rms slope as a function of scale.", ['setae sdrp scan.gwy --tip-radius "10 nm" -o sdrp.svg']),
    Drawing("vbw", "vbw.svg", "Rms height in cells of every size (variable bandwidth).", ["setae vbw scan.gwy -o vbw.svg"]),
    Drawing("level", "level.svg", "Heights before and after a plane and the offsets of the scan lines are removed.",
            ['setae level mine/rougher/afm_1.txt --step level_plane --step "level_lines" -o level.svg']),
    Drawing("profile", "profile.svg", "Heights along a straight line over a map, and the long waves of this line.",
            ["setae profile scan.gwy --from 0,0 --to 5,2.5 --unit-xy um -o line.csv", "cut -d, -f1,4 line.csv > heights.csv",
             'setae level heights.csv --step "gaussian_filter cutoff=1um" -o profile.svg']),
    Drawing("tip", "tip.svg", "Shape of the bluntest tip that could have made a map.",
            ["setae tip scan.gwy -o tip.x3p", "setae level tip.x3p --step level_mean -o tip.svg"]),
    Drawing("synthesize", "stretched.svg", "A random surface with features along one direction, and its waves longer than 1 µm.",
            ['setae synthesize --hurst 0.8 --rolloff "0.5 um" --short-cutoff "50 nm" --rms-height "20 nm" --stretch 4 --angle 30 --size "5 um"'
             " --pixels 256 -o stretched.gwy", 'setae level stretched.gwy --step "gaussian_filter cutoff=1um" -o stretched.svg']),
    Drawing("contour", "contour.svg", "Profile of a sample, traced in a picture, with its 95 % interval.",
            ['setae contour tests/cli/data/wave.png --pixel "0.1 nm" -o contour.svg']),
]  # fmt: skip
CONTACT = [
    Drawing("jkr fit", "loop.svg", "One loop with its JKR fits.", [f"setae jkr fit {LOOP} -o loop.svg"]),
    Drawing("jkr energy", "figures/rougher_soft_energy.svg", "Work, elastic energy, surface energy and loss along the loop.",
            [f"setae jkr energy {LOOP} --figures figures"]),
    Drawing("jkr line", "edge.svg", "Edge of a contact: its speed and its roughness.",
            ['setae jkr line tests/cli/data/edge.csv --ring-width "1 um" -o edge.svg']),
    Drawing("jkr summary", "forest.svg", "W of every replicate and the means of the surfaces.",
            ["setae jkr summary tests/cli/data/fits.csv --branch loading --figure forest.svg"]),
    Drawing("contact solve", "solve.svg", "Pressure and gap of a rough map on an elastic body under 20 kPa.",
            ['setae contact solve scan.gwy --contact-modulus "1 MPa" --pressure "20 kPa" -o solve.svg']),
    Drawing("contact solve, with adhesion", "attracting.svg", "Pressure and gap of a small map that attracts: almost full contact under 1 kPa.",
            ['setae contact solve small.gwy --contact-modulus "2 MPa" --w "50 mJ/m2" --range "15 nm" --pressure "1 kPa" -o attracting.svg']),
    Drawing("contact sweep", "sweep.svg", "Approach and separation of a small rough map that attracts.",
            ['setae contact sweep small.gwy --contact-modulus "2 MPa" --w "50 mJ/m2" --range "15 nm" -o sweep.svg']),
    Drawing("contact front", "front.svg", "A rough map under a sphere: the edge of the contact stops and jumps.",
            ['setae contact front scan.gwy --radius "10 um" --contact-modulus "1 MPa" --w "50 mJ/m2" --to-displacement "0.03 um"'
             ' --shortest-wavelength "0.5 um" -o front.svg']),
    Drawing("contact persson", "persson.svg", "Contact area and mean gap against pressure, from the spectrum (Persson's theory).",
            ['setae contact persson scan.gwy --tip-radius "10 nm" --contact-modulus 1MPa --pressure 1kPa:1MPa --w 50mJ/m2 -o persson.svg']),
]  # fmt: skip


def run(*command: object, cwd: pathlib.Path | None = None) -> str:
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, cwd=cwd, check=False)
    if done.returncode:
        sys.exit(f"{command[-1]}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def drawn(drawing: Drawing, work: pathlib.Path, folder: pathlib.Path) -> str:
    """A section of the page; its commands are run in the folder work."""
    for line in drawing.lines:
        run("bash", "-c", line, cwd=work)
    name = pathlib.Path(drawing.figure).name
    shutil.copyfile(work / drawing.figure, folder / name)
    lines = "\n".join(drawing.lines)
    return f"### setae {drawing.command}\n\n![Figure of setae {drawing.command}]({name})\n\n{drawing.shown}\n\n```\n{lines}\n```\n\n"


def plotted(study: str, work: pathlib.Path, folder: pathlib.Path) -> str:
    """Sections of all figures of a study."""
    page = ""
    for figure in json.loads(run("setae", "plot", study, "--list", "--json", cwd=work))["figures"]:
        if not figure["drawable"]:
            continue
        name = f"{pathlib.Path(study).stem}_{figure['identifier'].replace(':', '_')}.svg"
        run("setae", "plot", study, "--figure", figure["identifier"], "-o", folder.resolve() / name, cwd=work)
        title, command = figure["title"], f"setae plot {study} --figure {figure['identifier']}"
        page += f"### {title}\n\n![{title}]({name})\n\n{figure['caption']}\n\n```\n{command}\n```\n\n"
    return page


def main(program: str, folder: pathlib.Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    work = folder.parent.parent / "generated"  # beside the documents, of which it is no part
    shutil.rmtree(work, ignore_errors=True)
    (work / "bin").mkdir(parents=True)
    (work / "bin/setae").symlink_to(pathlib.Path(program).resolve())
    for name in ("examples", "tests"):
        (work / name).symlink_to(TOP / name)
    os.environ["PATH"] = f"{(work / 'bin').resolve()}:{os.environ['PATH']}"
    made = [SCAN, SMALL, "setae lab make examples/tutorial/recipe.toml -o mine"]
    for line in made:
        run("bash", "-c", line, cwd=work)
    lines = "\n".join(made)
    page = "# Gallery\n\nFigures with the commands that draw them. The folder of the checkout contains `examples` and `tests`. The other files are"
    page += f" made by three commands:\n\n```\n{lines}\n```\n\n## Surfaces\n\n"
    page += "".join(drawn(drawing, work, folder) for drawing in SURFACES)
    page += "`setae adhesion` draws no figure. `setae params` draws the scales that contribute to true area and stored energy.\n\n## Contact\n\n"
    page += "".join(drawn(drawing, work, folder) for drawing in CONTACT)
    page += "## Study of published data: nanodiamond and PDMS\n\n" + plotted("examples/nanodiamond/published.toml", work, folder)
    page += "## Study of simulated measurements\n\n" + plotted("mine/study.toml", work, folder)
    (folder / "index.md").write_text(page)


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
