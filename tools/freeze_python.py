#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What results of the Python package show: JSON, repr, HTML, table and figure of each; run by freeze.py.

    PYTHONPATH=build/python freeze_python.py FOLDER
"""
import inspect
import os
import pathlib
import subprocess
import sys

import setae

ROOT = pathlib.Path(__file__).resolve().parents[1]
SCANS = ["rougher/stylus_1.csv", "rougher/afm_1.txt", "rougher/tem_1.csv"]
SOLIDS = {"youngs_modulus": "0.7 ± 0.02 MPa", "W_int": "37 ± 2 mJ/m2", "surface_energy": "25 mJ/m2"}
ROUGH = {"hurst_exponent": 0.8, "rolloff": "2 um", "short_cutoff": "100 nm", "rms_height": "20 nm", "size": "8 um x 4 um", "pixels": "128x64"}
CALLS = {
    "info": lambda: setae.info("rougher", "loops"),
    "formats": setae.formats,
    "check": lambda: setae.check(SCANS[1], tip_radius="10 nm"),
    "power_spectrum": lambda: setae.power_spectrum(SCANS[1], tip_radius="10 ± 2 nm", instrument="afm"),
    "combined": lambda: setae.power_spectrum(SCANS, fit=True),
    "parameters": lambda: setae.parameters(SCANS),
    "scale_dependent_roughness": lambda: setae.scale_dependent_roughness(SCANS[1]),
    "autocorrelation": lambda: setae.autocorrelation(SCANS[1]),
    "variable_bandwidth": lambda: setae.variable_bandwidth(SCANS[1]),
    "work_of_adhesion": lambda: setae.work_of_adhesion(SCANS, **SOLIDS, radius="1.25 mm", preload="1 mN"),
    "synthesize": lambda: setae.synthesize(**ROUGH, seed=3),
    "loop": lambda: setae.loop("loops/rougher_soft.csv", radius="1.25 ± 0.01 mm"),
    "loop_fit": lambda: setae.loop("loops/rougher_soft.csv", radius="1.25 ± 0.01 mm").fit(models=["all"]),
    "loop_energy": lambda: setae.loop("loops/rougher_soft.csv", radius="1.25 ± 0.01 mm").energy(),
    "study": lambda: setae.study("study.toml").run(),
    "predict": lambda: setae.study("study.toml").run().predict(),
}


def shown(result):
    """Name and text of each form that the result has."""
    yield "repr", repr(result)
    yield "names", "\n".join(n for n in dir(result) if not n.startswith("_"))
    if hasattr(result, "json"):
        yield "json", result.json()
    if hasattr(result, "_repr_html_"):
        yield "html", result._repr_html_() or ""
    if hasattr(result, "to_pandas"):
        tables = result.to_pandas()
        for name, table in tables.items() if isinstance(tables, dict) else [("table", tables)]:
            yield f"{name}.csv", table.to_csv()


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    program = os.environ["SETAE"]
    data = folder / "data"
    subprocess.run([program, "lab", "make", ROOT / "examples/tutorial/recipe.toml", "-o", data], check=True, stdout=subprocess.DEVNULL)
    os.chdir(data)
    for name, call in CALLS.items():
        target = folder / name
        target.mkdir()
        try:
            for form, text in shown(call()):
                (target / form).write_text(text)
        except setae.Error as error:
            (target / "error").write_text(str(error))
    signatures = [f"{name}{inspect.signature(value)}\n{inspect.getdoc(value)}\n" for name, value in sorted(vars(setae).items())
                  if inspect.isroutine(value) and not name.startswith("_")]
    (folder / "signatures").write_text("\n".join(signatures))


if __name__ == "__main__":
    main()
