# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of fits: the model at the measured points beside formulas written here, residuals beside the JSON, and plots with two panels."""

from __future__ import annotations

import pickle

import matplotlib
import numpy as np
import pytest
import setae

from conftest import ROOT

matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402

RADIUS = 1.25e-3
CURVES = ROOT / "tests/cli/data/map.jpk-force-map"


@pytest.fixture(scope="module")
def fit(data):
    return setae.loop(data / "loops/rougher_soft.csv", radius=f"{RADIUS} m").fit(models=["jkr", "hertz"])


def jkr_force(radius, modulus, work):
    return 4.0 * modulus * radius**3 / (3.0 * RADIUS) - np.sqrt(8.0 * np.pi * modulus * work * radius**3)


def jkr_radius(force, modulus, work):
    adhesion = 3.0 * np.pi * RADIUS * work
    root = np.sqrt(np.maximum(2.0 * adhesion * force + adhesion**2, 0.0))
    return np.cbrt(0.75 * RADIUS / modulus * (force + adhesion + root))


def near(found, expected):
    assert np.sqrt(np.mean((found - expected) ** 2)) < 0.01 * np.ptp(expected)


def test_the_primary_fit_is_the_curve_of_jkr(fit):
    points = fit.points()
    assert (points.x, points.y, points.n) == ("contact_radius", "force", fit["loading"]["range"]["n"])
    near(fit.best_fit, jkr_force(points["contact_radius"], float(fit.E_star), float(fit.W)))
    assert np.allclose(points["force"] - fit.best_fit, fit.residuals, rtol=0.0, atol=1e-18)
    rms = fit["loading"]["fits"]["radius_force_effective_variance"]["rms_residual"]
    assert np.sqrt(np.mean(fit.residuals**2)) == pytest.approx(float(rms), rel=1e-6)


def test_every_route_has_its_residuals(fit):
    for branch in ("loading", "unloading"):
        for route, found in fit.data[branch]["fits"].items():
            if not found or "residuals" not in found:
                continue
            points = fit.points(branch=branch, route=route)
            assert points.n == found["n"] and np.isfinite(points.best_fit).all()
            if route != "linear_form":
                assert np.array_equal(points.residuals, found["residuals"])
    radii = fit.points(route="radius_force")
    found = fit["loading"]["fits"]["radius_force"]
    near(radii.best_fit, jkr_radius(radii["force"], float(found["contact_modulus"]), float(found["work_of_adhesion"])))
    straight = fit.points(route="linear_form")
    found = fit["loading"]["fits"]["linear_form"]
    near(straight.best_fit, jkr_force(straight["contact_radius"], float(found["contact_modulus"]), float(found["work_of_adhesion"])))


def test_models_have_their_residuals(fit):
    jkr, hertz = fit.points(model="jkr"), fit.points(model="hertz")
    assert jkr.n == hertz.n == fit["loading"]["range"]["n"]
    assert np.abs(hertz.residuals).max() > 3.0 * np.abs(jkr.residuals).max()
    with pytest.raises(setae.InvalidArgument, match="'dmt'; expected one of jkr, hertz"):
        fit.points(model="dmt")
    with pytest.raises(setae.InvalidArgument, match="branch: 'retraction'"):
        fit.points(branch="retraction")
    with pytest.raises(setae.InvalidArgument, match="route: 'linear'.*linear_form"):
        fit.points(route="linear")


def test_force_curves():
    fit = setae.force_curves(CURVES, radius="1 mm", curve_number=1)
    segment = next(s for s in fit.data["segments"] if s["name"] == fit["summary"]["fitted_segment"])
    points, point, modulus = fit.points(), segment["contact_point"]["value"], segment["contact_modulus"]["value"]
    assert np.allclose(fit.residuals, segment["residuals"], rtol=0.0, atol=1e-18) and points.n == segment["n"]
    depth = np.maximum(points["displacement"] - point, 0.0)
    near(fit.best_fit, 4.0 / 3.0 * modulus * np.sqrt(1e-3) * depth**1.5)
    assert fit.points("retract").n > 0
    with pytest.raises(setae.InvalidArgument, match="segment: 'pause'; expected one of extend, retract"):
        fit.points("pause")
    with pytest.raises(setae.InvalidArgument, match="curve_number"):
        setae.force_curves(CURVES, radius="1 mm").best_fit


def test_spectra(data):
    spectrum = setae.power_spectrum(data / "rougher/afm_1.txt", fit=True)
    fit = spectrum.fit
    low, high = (spectrum.data["fit"]["range"][end] for end in ("lower", "upper"))
    assert fit.q[0] >= low * (1.0 - 1e-12) and fit.q[-1] <= high * (1.0 + 1e-12)
    assert np.array_equal(fit.residuals, spectrum.data["fit"]["residuals"]["residual"])
    ratio = fit.points["C1D"] / fit.best_fit
    assert ((ratio > 1.0) == (fit.residuals > 0.0)).all() and 0.3 < np.exp(np.mean(np.log(ratio))) < 3.0
    assert fit["hurst_exponent"] == spectrum.fit["hurst_exponent"]
    with pytest.raises(setae.InvalidArgument, match="fit=True"):
        setae.power_spectrum(data / "rougher/afm_1.txt").fit.best_fit


def test_plots_have_a_panel_of_residuals_and_the_fitted_range(fit, data):
    plots = [
        lambda ax: fit.plot(ax, color="C2"),
        lambda ax: fit.plot(ax=ax, branch="unloading", route="joint"),
        lambda ax: fit.plot(ax=ax, model="hertz"),
        lambda ax: setae.force_curves(CURVES, radius="1 mm", curve_number=1).plot(ax=ax),
        lambda ax: setae.power_spectrum(data / "rougher/afm_1.txt", fit=True).fit.plot(ax=ax),
    ]
    for plot in plots:
        figure, given = plt.subplots()
        assert plot(given) is given
        below = next(panel for panel in figure.axes if panel is not given)
        assert below.get_ylabel().startswith("residual") and below.get_xlabel() and given.get_ylabel()
        assert {text.get_text() for text in given.get_legend().get_texts()} >= {"fitted points", "best fit"}
        assert given.patches and below.patches  # the shaded range
        plt.close(figure)
    assert fit.plot().figure is not None
    plt.close("all")


def test_points_are_a_table_and_pickle(fit):
    points = pickle.loads(pickle.dumps(fit)).points()
    assert list(points.to_pandas().columns) == ["contact_radius", "force", "best_fit", "residuals"]
    assert points.to_xarray().best_fit.attrs["units"] == "N" and points.json().startswith('{"contact_radius"')
