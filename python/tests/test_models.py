# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed-form models against formulas of their own, at limits, in shapes of arrays, and in a fit."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
import pytest
import setae
from setae import models

R, E, W, H = 1e-3, 1e6, 0.05, 1e-4
ADHESIVE = (R, E, W)
K = 4 * E / 3


def jkr_state(a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Force and displacement of the JKR theory at contact radii."""
    return 4 * E * a**3 / (3 * R) - np.sqrt(8 * np.pi * E * W * a**3), a**2 / R - np.sqrt(2 * np.pi * a * W / E)


def maugis_state(m: Any, transition: float) -> tuple[Any, Any, Any]:
    """Contact radius, displacement and force of Maugis' model for ratios m of the radii, in SI [Maugis 1992, eq. 6.24 to 6.26]."""
    s, angle = np.sqrt(m**2 - 1), np.arccos(1 / m)
    first, second = transition / 2 * (s + (m**2 - 2) * angle), 4 * transition**2 / 3 * (s * angle - m + 1)
    A = (-second + np.sqrt(second**2 + 4 * first)) / (2 * first)
    force = A**3 - transition * A**2 * (s + m**2 * angle)
    displacement = A**2 - 4 / 3 * transition * A * s
    length, height = (np.pi * W * R**2 / K) ** (1 / 3), (np.pi**2 * W**2 * R / K**2) ** (1 / 3)
    return A * length, displacement * height, force * np.pi * R * W


def cohesive_stress(transition: float) -> float:
    return transition * (np.pi * W * K**2 / R) ** (1 / 3) / 2


def test_hertz():
    depth = np.array([0.0, 1e-7, 1e-6])
    force = models.hertz(depth, R, E)
    np.testing.assert_allclose(force, 4 / 3 * E * np.sqrt(R) * depth**1.5, rtol=1e-14)
    np.testing.assert_allclose(models.hertz_contact_radius(force, R, E) ** 2, R * depth, rtol=1e-12, atol=1e-30)


def test_dmt():
    depth = np.array([0.0, 1e-7, 1e-6])
    force = models.dmt(depth, *ADHESIVE)
    np.testing.assert_allclose(force, 4 / 3 * E * np.sqrt(R) * depth**1.5 - 2 * np.pi * W * R, rtol=1e-13)
    assert models.dmt_pull_off(R, W) == pytest.approx(-2 * np.pi * W * R, rel=1e-15) and force[0] == pytest.approx(models.dmt_pull_off(R, W))
    np.testing.assert_allclose(models.dmt_contact_radius(force, *ADHESIVE) ** 2, R * depth, rtol=1e-9, atol=1e-18)


def test_jkr():
    smallest = (np.pi * W * R**2 / (8 * E)) ** (1 / 3)  # pull-off under fixed grips
    radius = smallest * np.linspace(1.001, 10.0, 50)
    force, displacement = jkr_state(radius)
    np.testing.assert_allclose(models.jkr(displacement, *ADHESIVE), force, rtol=1e-8, atol=1e-12 * abs(force).max())
    inner = smallest * np.linspace(0.3, 0.99, 20)
    np.testing.assert_allclose(models.jkr(jkr_state(inner)[1], *ADHESIVE, branch="inner"), jkr_state(inner)[0], rtol=1e-7)
    stable = radius[radius > (9 * np.pi * W * R**2 / (8 * E)) ** (1 / 3)]
    np.testing.assert_allclose(models.jkr_contact_radius(jkr_state(stable)[0], *ADHESIVE), stable, rtol=1e-8)


def test_jkr_pull_off():
    force = models.jkr_pull_off(R, W)
    assert force == pytest.approx(-1.5 * np.pi * W * R, rel=1e-15)
    assert models.jkr_pull_off(R, W, control="fixed_grips") == pytest.approx(-5 / 6 * np.pi * W * R, rel=1e-15)
    radii = models.jkr_contact_radius(np.array([0.999999, 1.000001]) * force, *ADHESIVE)
    assert radii[0] == pytest.approx((9 * np.pi * W * R**2 / (8 * E)) ** (1 / 3), rel=2e-3) and np.isnan(radii[1])
    with pytest.raises(setae.InvalidArgument, match="control: 'grip'; expected one of fixed_load, fixed_grips"):
        models.jkr_pull_off(R, W, control="grip")


@pytest.mark.parametrize("transition", [0.3, 1.0, 3.0])
def test_maugis_dugdale(transition):
    stress = cohesive_stress(transition)
    for m in (1.02, 1.05, 1.1):
        radius, displacement, force = maugis_state(m, transition)
        assert maugis_state(m + 1e-4, transition)[1] < displacement  # the outer branch
        assert models.maugis_dugdale(displacement, *ADHESIVE, stress) == pytest.approx(force, rel=1e-7)
        if maugis_state(m + 1e-4, transition)[2] < force:  # stable under a dead load, too
            assert models.maugis_dugdale_contact_radius(force, *ADHESIVE, stress) == pytest.approx(radius, rel=1e-6)
    pull_off = models.maugis_dugdale_pull_off(*ADHESIVE, stress)
    forces = maugis_state(1 + np.geomspace(1e-3, 1e2, 200_000), transition)[2]
    assert pull_off == pytest.approx(forces.min(), rel=2e-6)


def test_limits_of_maugis_dugdale():
    """DMT for short zones of weak attraction, JKR for strong attraction."""
    depth = np.array([5e-7, 2e-6])
    np.testing.assert_allclose(models.maugis_dugdale(depth, *ADHESIVE, cohesive_stress(1e-8)), models.dmt(depth, *ADHESIVE), rtol=1e-3)
    np.testing.assert_allclose(models.maugis_dugdale(depth, *ADHESIVE, cohesive_stress(1e3)), models.jkr(depth, *ADHESIVE), rtol=1e-3)
    assert models.maugis_dugdale_pull_off(*ADHESIVE, cohesive_stress(1e-5)) == pytest.approx(models.dmt_pull_off(R, W), rel=1e-4)
    assert models.maugis_dugdale_pull_off(*ADHESIVE, cohesive_stress(1e3)) == pytest.approx(models.jkr_pull_off(R, W), rel=1e-4)


def test_layer():
    """A thick layer is a half-space; a thinner incompressible one is stiffer, to first order as by Dimitriadis et al. 2002, eq. 12."""
    depth = np.array([1e-7, 1e-6])
    np.testing.assert_allclose(models.layer(depth, *ADHESIVE, 1.0, 0.5), models.jkr(depth, *ADHESIVE), rtol=1e-3)
    np.testing.assert_allclose(models.layer(depth, R, E, 0.0, 1.0, 0.5), models.hertz(depth, R, E), rtol=1e-3)
    small = 1e-9  # χ = √(Rδ)/h = 0.01
    ratio = models.layer(small, R, E, 0.0, H, 0.5) / models.hertz(small, R, E)
    assert ratio - 1 == pytest.approx(1.133 * np.sqrt(R * small) / H, rel=0.02)
    force = models.layer(depth, R, E, 0.0, H, 0.5)
    radius = models.layer_contact_radius(force, R, E, 0.0, H, 0.5)
    assert (radius < models.hertz_contact_radius(force, R, E)).all() and (np.diff(radius) > 0).all()


def test_flat_punch():
    a = 1e-4
    assert models.flat_punch(1e-6, a, E, W) == pytest.approx(2 * E * a * 1e-6, rel=1e-15)
    pull_off = models.flat_punch_pull_off(a, E, W)
    assert pull_off == pytest.approx(-np.sqrt(8 * np.pi * E * W * a**3), rel=1e-15)
    before, after = models.flat_punch(np.array([0.999, 1.001]) * pull_off / (2 * E * a), a, E, W)
    assert before == pytest.approx(0.999 * pull_off) and np.isnan(after)
    assert models.flat_punch(1.001 * pull_off / (2 * E * a), a, E, W, zero_outside=True) == 0.0


CURVES = {
    "hertz": (R, E),
    "hertz_contact_radius": (R, E),
    "dmt": ADHESIVE,
    "dmt_contact_radius": ADHESIVE,
    "jkr": ADHESIVE,
    "jkr_contact_radius": ADHESIVE,
    "maugis_dugdale": (*ADHESIVE, 1e4),
    "maugis_dugdale_contact_radius": (*ADHESIVE, 1e4),
    "layer": (*ADHESIVE, H, 0.45),
    "layer_contact_radius": (*ADHESIVE, H, 0.45),
    "flat_punch": ADHESIVE,
}


@pytest.mark.parametrize("name", CURVES)
def test_shapes_and_ends(name):
    """Results have the shape of the first argument; where there is no contact they are NaN, or 0."""
    curve, parameters = getattr(models, name), CURVES[name]
    x = 1e-6 * np.arange(1.0, 7.0).reshape(2, 3)
    found = curve(x, *parameters)
    assert found.shape == (2, 3) and np.isfinite(found).all()
    np.testing.assert_array_equal(curve(x.T, *parameters), found.T)
    np.testing.assert_array_equal(curve(x.astype(np.float32).astype(float)[0].tolist(), *parameters), curve(x.astype(np.float32)[0], *parameters))
    assert isinstance(curve(1e-6, *parameters), float) and curve(1e-6, *parameters) == found[0, 0]
    far = -1.0
    assert np.isnan(curve(far, *parameters)) and curve(far, *parameters, zero_outside=True) == 0.0
    assert np.isnan(curve(np.nan, *parameters))


@pytest.mark.parametrize("name", CURVES)
def test_signatures_are_those_of_models_of_fits(name):
    """The first argument is the variable, further ones without a default are parameters: what lmfit makes of a function."""
    parameters = list(inspect.signature(getattr(models, name)).parameters.values())
    positional = [p.name for p in parameters if p.default is p.empty]
    assert positional[0] in ("displacement", "force") and positional[1:3] == ["radius", "contact_modulus"]
    assert all(isinstance(p.default, (str, bool)) and p.kind is p.KEYWORD_ONLY for p in parameters[len(positional):])


def test_parameters_may_have_units():
    pint = pytest.importorskip("pint")
    ureg = pint.UnitRegistry()
    radius, work = setae.Quantity("radius", "R", 1e-3, "m", 1e-5), ureg.Quantity(50.0, "mJ/m**2")
    assert models.jkr(1e-6, radius, ureg.Quantity(1.0, "MPa"), work) == pytest.approx(models.jkr(1e-6, *ADHESIVE), rel=1e-12)
    with pytest.raises(setae.InvalidArgument, match="contact_modulus: .*expected a quantity in Pa"):
        models.jkr(1e-6, radius, work, work)
    with pytest.raises(TypeError, match="radius: str"):
        models.hertz(1e-6, "1 mm", 1e6)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: models.hertz(1e-6, -R, E), "radius"),
        (lambda: models.jkr(1e-6, R, E, -W), "work"),
        (lambda: models.jkr(1e-6, *ADHESIVE, branch="upper"), "branch: 'upper'; expected one of outer, inner"),
        (lambda: models.maugis_dugdale(1e-6, *ADHESIVE, 0.0), "stress"),
    ],
)
def test_values_outside_the_domain_are_refused(call, words):
    with pytest.raises(setae.InvalidArgument, match=words):
        call()


def test_a_fit_finds_the_parameters():
    """Of a noisy JKR curve, by least squares as in lmfit."""
    depth = np.linspace(-2e-7, 2e-6, 200)
    force = models.jkr(depth, *ADHESIVE) + 1e-7 * np.random.default_rng(1).standard_normal(depth.size)
    E_found, W_found = 0.8e6, 0.04
    for _ in range(20):  # Gauss–Newton
        model = models.jkr(depth, R, E_found, W_found)
        by_E = (models.jkr(depth, R, E_found * 1.0001, W_found) - model) / (1e-4 * E_found)
        by_W = (models.jkr(depth, R, E_found, W_found * 1.0001) - model) / (1e-4 * W_found)
        step = np.linalg.lstsq(np.column_stack([by_E * E_found, by_W * W_found]), force - model, rcond=None)[0]
        E_found, W_found = E_found * (1 + step[0]), W_found * (1 + step[1])
    assert E_found == pytest.approx(E, rel=5e-3) and W_found == pytest.approx(W, rel=5e-3)


def test_lmfit():
    lmfit = pytest.importorskip("lmfit")
    depth = np.linspace(-3e-6, 2e-6, 200)  # 0 before contact
    model = lmfit.Model(models.jkr, independent_vars=["displacement"], zero_outside=True)
    assert model.param_names == ["radius", "contact_modulus", "work_of_adhesion"]
    parameters = model.make_params(radius={"value": R, "vary": False}, contact_modulus={"value": 0.8e6, "min": 0.0}, work_of_adhesion={"value": 0.04, "min": 0.0})
    fit = model.fit(models.jkr(depth, *ADHESIVE, zero_outside=True), parameters, displacement=depth)
    assert fit.best_values["contact_modulus"] == pytest.approx(E, rel=1e-4) and fit.best_values["work_of_adhesion"] == pytest.approx(W, rel=1e-3)
