#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Young's moduli from force curves: setae against nanite, same file, model, range and contact point.

    python3 -m venv nanite-env && nanite-env/bin/pip install nanite
    cmake --build build --target peers_fit_force_curve
    nanite-env/bin/python tests/peers/nanite.py --program build/bin/peers_fit_force_curve --curves ../shared/data/force_curves

Model: nanite's "hertz_para", E, contact point and force baseline free, every sample alike (weight_cp = 0). Two fits a curve: all
of the approach with the contact point free; up to half of the largest indentation with the contact point held at the sample
nearest to the one nanite found. Radius, Poisson's ratio and the constants a file does not hold are
invented and the same for both. Prints a table in Markdown; exit status 1 where a modulus differs by more than 1 %.
"""
import argparse, json, logging, pathlib, subprocess, sys, warnings

sys.path = [entry for entry in sys.path if pathlib.Path(entry or ".").resolve() != pathlib.Path(__file__).resolve().parent]
import nanite  # the package, not this file
import numpy as np

RADIUS, POISSON_RATIO = 5e-6, 0.5
CONSTANTS = {  # by a part of the file's name: spring constant [N/m], sensitivity [m/A], where the file states none
    "afm-workshop": (2.0, None),
    "ntmdt": (0.1, 60.0),
}


def constants_of(path):
    return next((pair for part, pair in CONSTANTS.items() if part in path.name), (None, None))


def fit_by_nanite(curve, contact, range_x):
    initial = curve.get_initial_fit_parameters(model_key="hertz_para")
    for name, value in {"R": RADIUS, "nu": POISSON_RATIO}.items():
        initial[name].value, initial[name].vary = value, False
    initial["E"].value = 1e3
    if contact is not None:
        initial["contact_point"].value, initial["contact_point"].vary = contact, False
    curve.fit_model(model_key="hertz_para", params_initial=initial, range_x=range_x, range_type="absolute", segment="approach",
                    weight_cp=0, optimal_fit_edelta=False)
    fitted = curve.fit_properties["params_fitted"]
    return fitted["E"].value, fitted["contact_point"].value, int(np.sum(curve["fit range"]))


def fit_by_setae(program, path, constants, contact, share):
    words = [program, path, RADIUS, POISSON_RATIO, constants[0] or "-", constants[1] or "-", contact, share]
    return json.loads(subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout)


def compare(program, path):
    constants = constants_of(path)
    names = ("spring constant", "sensitivity")
    override = {name: value for name, value in zip(names, constants) if value is not None}
    curve = nanite.load_group(path, meta_override=override)[0]
    curve.apply_preprocessing(["compute_tip_position", "correct_force_offset", "correct_tip_offset"])
    tip = np.asarray(curve["tip position"])[np.asarray(curve["segment"]) == 0]
    deepest, free = tip.min(), tip.max() + 1e-12

    def row(label, ours, theirs, point, n):
        return {"curve": path.name, "contact point": label, "n": (ours["n"], n), "setae": ours["youngs_modulus"], "nanite": theirs,
                "difference": ours["youngs_modulus"] / theirs - 1.0,
                "shift": (ours["contact_point"] - ours["first_displacement"]) - (tip[0] - point)}

    theirs, point, n = fit_by_nanite(curve, None, (deepest - 1e-12, free))
    yield row("free", fit_by_setae(program, path, constants, "free", 1.0), theirs, point, n)
    contact = int(np.argmin(np.abs(tip - point)))
    # the middle between two samples, so that rounding decides nothing
    depths = np.sort(tip[contact] - tip)
    share = depths[np.searchsorted(depths, 0.5 * depths[-1]) - 1:][:2].mean() / depths[-1]
    theirs, point, n = fit_by_nanite(curve, tip[contact], (tip[contact] - share * depths[-1], free))
    yield row(f"sample {contact}", fit_by_setae(program, path, constants, contact, share), theirs, point, n)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--curves", required=True, type=pathlib.Path)
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    logging.disable(logging.CRITICAL)
    print("| curve | contact point | samples (setae, nanite) | E setae / Pa | E nanite / Pa | difference | contact point apart / nm |")
    print("|---|---|---|---|---|---|---|")
    worst = 0.0
    for path in sorted(arguments.curves.glob("fmt-*")):
        for row in compare(arguments.program, path):
            worst = max(worst, abs(row["difference"]))
            print(f"| {row['curve'][4:24]} | {row['contact point']} | {row['n'][0]}, {row['n'][1]} | {row['setae']:.6g} | {row['nanite']:.6g} | "
                  f"{100 * row['difference']:+.4f} % | {1e9 * row['shift']:+.3f} |")
    return 0 if worst < 0.01 else 1


sys.exit(main())
