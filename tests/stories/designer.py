#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""designer.py SETAE: from a table of a spectrum to the work of adhesion, the loss and the pull-off with their ±, in one command.

Every number is compared with closed forms written here: moments of a self-affine spectrum, [D19] (7), (9), (10), JKR and its jumps.
"""
import math

from terminal import require, require_close, terminal

# the surface: C_iso = PLATEAU below q_r, falling as q^(-2 - 2H) from there to q_s
HURST, PLATEAU = 0.8, 1.2e-28  # 1, m⁴
Q_L, Q_R, Q_S = (2 * math.pi / wavelength for wavelength in (1e-4, 2e-6, 1e-9))
# the soft sphere, and what is known of it: value, standard error
E, GAMMA, W_INT = (1.1e6, 0.05e6), (0.025, 0.002), (0.037, 0.001)
RADIUS, PRELOAD = 1.25e-3, 1e-3
COMMAND = ('setae adhesion {} --E "1.1 ± 0.05 MPa" --w "37 ± 1 mJ/m2" --gamma "25 ± 2 mJ/m2" --radius 1.25mm --preload 1mN')


def moment(n):
    """∫ qⁿ C_iso dq from q_L to q_s."""
    exponent = n - 1 - 2 * HURST
    plateau = PLATEAU * (Q_R ** (n + 1) - Q_L ** (n + 1)) / (n + 1)
    return plateau + PLATEAU * Q_R ** (2 + 2 * HURST) * (Q_S**exponent - Q_R**exponent) / exponent


SLOPE = math.sqrt(moment(3) / (2 * math.pi))
AREA_RATIO = 1 + math.sqrt(math.pi) / 2 * SLOPE * math.exp(1 / SLOPE**2) * math.erfc(1 / SLOPE)


def contact_modulus(youngs_modulus):
    return youngs_modulus / 0.75  # Poisson ratio 1/2 on a rigid body


def work_of_approach(youngs_modulus, gamma, w_int):
    """[D19] (7)."""
    return w_int * AREA_RATIO - gamma * (AREA_RATIO - 1) - contact_modulus(youngs_modulus) / (8 * math.pi) * moment(2)


def radius_under_preload(work, modulus):
    """[D19] (1)."""
    pull = 3 * math.pi * RADIUS * work
    return (3 * RADIUS / (4 * modulus) * (PRELOAD + pull + math.sqrt(2 * pull * PRELOAD + pull**2))) ** (1 / 3)


def jkr_energy(a, work, modulus):
    """Elastic and surface energy of a contact of radius a in equilibrium."""
    depth = a**2 / RADIUS - math.sqrt(2 * math.pi * a * work / modulus)
    return modulus * (depth**2 * a - 2 / 3 * depth * a**3 / RADIUS + a**5 / (5 * RADIUS**2)) - math.pi * work * a**2


def jump_in(work, modulus):
    """At depth 0 between fixed grips."""
    return -jkr_energy((2 * math.pi * work * RADIUS**2 / modulus) ** (1 / 3), work, modulus)


def jump_out(work, modulus):
    """Where the depth is least."""
    return jkr_energy((math.pi * work * RADIUS**2 / (8 * modulus)) ** (1 / 3), work, modulus)


def work_of_retraction(work, modulus, loss, area):
    """W_ret of loss = (W_ret − W) area + jump in (W) + jump out (W_ret), by bisection."""
    low, high = work, 100 * work
    for _ in range(200):
        middle = (low + high) / 2
        if (middle - work) * area + jump_in(work, modulus) + jump_out(middle, modulus) < loss:
            low = middle
        else:
            high = middle
    return low


def predicted(youngs_modulus=E[0], gamma=GAMMA[0], w_int=W_INT[0]):
    """Everything the command is asked for, by JSON key."""
    modulus, work = contact_modulus(youngs_modulus), work_of_approach(youngs_modulus, gamma, w_int)
    radius = radius_under_preload(work, modulus)
    loss = w_int * AREA_RATIO * math.pi * radius**2
    retraction = work_of_retraction(work, modulus, loss, math.pi * radius**2)
    return {
        "rms_slope": SLOPE,
        "work_of_adhesion_modified": work,
        "contact_radius": radius,
        # the least: retraction without hysteresis of W
        "energy_loss": jump_in(work, modulus) + jump_out(work, modulus),
        "pull_off_force": 1.5 * math.pi * RADIUS * work,
        "conformal_energy_loss": loss,
        "conformal_pull_off_force": 1.5 * math.pi * RADIUS * retraction,
    }


def error_of(key):
    """± of a prediction whose spectrum is exact: one standard error of each input either way."""
    changes = []
    for name, (value, error) in (("youngs_modulus", E), ("gamma", GAMMA), ("w_int", W_INT)):
        changes.append((predicted(**{name: value + error})[key] - predicted(**{name: value - error})[key]) / 2)
    return math.hypot(*changes)


def write_table(path, relative_error=None):
    """q and C_iso in micrometres, as a colleague sends it: a row at the roll-off and at either end, some between."""
    nodes = [Q_L * (Q_R / Q_L) ** (k / 20) for k in range(20)] + [Q_R * (Q_S / Q_R) ** (k / 60) for k in range(61)]
    lines = ["q [1/um],C_iso [um4]" + (",standard_error [um4]" if relative_error else "")]
    for q in nodes:
        density = PLATEAU * max(1, q / Q_R) ** (-2 - 2 * HURST) * 1e24
        lines.append(f"{q * 1e-6!r},{density!r}" + (f",{relative_error * density!r}" if relative_error else ""))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    with terminal() as user:
        write_table(user.folder / "exact.csv")
        found = user.reads(COMMAND.format("exact.csv"))
        require(user.typed == 1, "one command")
        for key, value in predicted().items():
            require_close(found[key]["value"], value, 1e-6, key)
        for key in ("work_of_adhesion_modified", "contact_radius", "energy_loss", "pull_off_force", "conformal_energy_loss", "conformal_pull_off_force"):
            require_close(found[key]["standard_error"], error_of(key), 0.01, f"± of {key}")
        require("SPECTRUM_WITHOUT_ERROR" in [alert["code"] for alert in found["alerts"]], "nothing says that the table has no errors")

        write_table(user.folder / "measured.csv", relative_error=0.2)
        measured = user.reads(COMMAND.format("measured.csv"))
        for key in ("work_of_adhesion_modified", "conformal_energy_loss", "conformal_pull_off_force"):
            require_close(measured[key]["value"], found[key]["value"], 1e-6, key)
            require(measured[key]["standard_error"] > found[key]["standard_error"], f"± of {key} knows nothing of the spectrum's")

        answer = "\n".join(user.types(COMMAND.format("measured.csv")).splitlines()[:3])
        require(all(word in answer for word in ("W_app", "loss", "pull-off", "±")), f"the answer does not come first:\n{answer}")


if __name__ == "__main__":
    main()
