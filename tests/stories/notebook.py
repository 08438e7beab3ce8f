#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""notebook.py SETAE: a user of Python runs verbs, takes their JSON as arrays and gets the verbs' own numbers out of them.

Nothing but the standard library; docs/guides/from-python.md does the same with NumPy, SciPy and xarray.
"""
import csv
import math

from terminal import require, require_close, terminal

AMPLITUDE, PERIODS, LENGTH, POINTS = 3e-9, 8, 2e-6, 512  # a wave of 3 nm


def by_name(quantities):
    return {quantity["quantity"]: quantity for quantity in quantities}


def integral(spectrum, power):
    """∫ q^power C1D dq as the sum over equidistant modes."""
    q, density = spectrum["wavevector"], spectrum["C1D"]
    return math.fsum(x**power * c for x, c in zip(q, density)) * (q[1] - q[0])


def a_wave_has_its_closed_forms(user):
    """One line scan of a wave: C1D holds A² L/4 in one mode, and two verbs agree about the slope."""
    step = LENGTH / POINTS
    heights = [AMPLITUDE * math.cos(2 * math.pi * PERIODS * k / POINTS) for k in range(POINTS)]
    lines = [f"{k * step * 1e9!r},{height * 1e9!r}" for k, height in enumerate(heights)]
    (user.folder / "wave.csv").write_text("\n".join(["x [nm],h [nm]", *lines]) + "\n", encoding="utf-8")
    spectrum = user.reads("setae psd wave.csv --window none --trend mean")
    require(spectrum["units"]["wavevector"] == "1/m" and spectrum["units"]["C1D"] == "m3", f"units are {spectrum['units']}")
    highest = max(range(len(spectrum["C1D"])), key=lambda k: spectrum["C1D"][k])
    require_close(spectrum["wavevector"][highest], 2 * math.pi * PERIODS / LENGTH, 1e-9, "wavevector of the wave")
    require_close(spectrum["C1D"][highest], AMPLITUDE**2 * LENGTH / 4, 1e-9, "C1D of the wave")
    require_close(math.sqrt(integral(spectrum, 0) / math.pi), AMPLITUDE / math.sqrt(2), 1e-9, "rms height of the wave")


def a_map_agrees_with_itself(user):
    """Of a rough map: integrals of the PSD are params' numbers, slopes between points those of the autocorrelation."""
    user.types('setae synthesize --hurst 0.8 --rolloff 1um --short-cutoff 40nm --rms-height 15nm --pixels 256 --size "5 um" --seed 4 -o map.nc')
    spectrum = user.reads("setae psd map.nc --window none --trend none")
    own = by_name(user.reads("setae params map.nc --window none --trend none"))
    height, slope = own["rms_height_from_spectrum"], own["rms_slope_from_spectrum"]
    require_close(math.sqrt(integral(spectrum, 0) / math.pi), height["value"], 1e-3, "rms height")
    # isotropic surfaces: <|∇h|²> = (2/π) ∫ q² C1D dq
    require_close(math.sqrt(2 * integral(spectrum, 2) / math.pi), slope["value"], 5e-3, "rms slope")
    require(slope["interval"]["lower"] < slope["value"] < slope["interval"]["upper"], f"interval {slope['interval']}")
    require(slope["standard_error"] > 0 and slope["interval"]["level"] == 0.95, f"± of the slope: {slope}")

    lags = user.reads("setae acf map.nc --trend none --all")
    steps = lags["distance"][:20]
    slopes = user.reads("setae sdrp map.nc --trend none --along x --all --distance " + ",".join(f"{d * 1e9!r}nm" for d in steps))
    for distance, difference, correlation in zip(steps, slopes["rms_slope"], lags["autocorrelation"]):
        require_close(difference**2, 2 * correlation / distance**2, 1e-9, f"mean square slope over {distance} m")


def tables_and_json_are_the_same(user):
    """What -o writes as CSV is what --json prints, to the last bit."""
    printed = user.reads("setae psd map.nc")
    user.types("setae psd map.nc -o psd.csv")
    with open(user.folder / "psd.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    for name in ("wavevector", "C1D", "standard_error"):
        column = f"{name} [{printed['units'][name]}]"
        require([float(row[column]) for row in rows] == printed[name], f"column {column} differs")


def errors_are_told(user):
    """A notebook learns of a failure by the exit code and reads the reason."""
    said = user.types("setae psd missing.csv --json > out.json 2> reason.txt; echo $?")
    require(said.strip() == "2", f"exit code {said}")
    reason = (user.folder / "reason.txt").read_text(encoding="utf-8")
    require("missing.csv" in reason, f"the reason does not name the file: {reason}")
    require((user.folder / "out.json").read_text(encoding="utf-8") == "", "something stands on standard output")


def main():
    with terminal() as user:
        a_wave_has_its_closed_forms(user)
        a_map_agrees_with_itself(user)
        tables_and_json_are_the_same(user)
        errors_are_told(user)


if __name__ == "__main__":
    main()
