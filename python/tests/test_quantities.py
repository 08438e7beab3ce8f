# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities calculate: units, correlated errors, comparison, formats, functions of NumPy, values of other packages."""

from __future__ import annotations

import copy
import math
import operator
import pickle
import subprocess
import sys

import numpy as np
import pytest
import setae
from setae import quantity

pint = pytest.importorskip("pint")
uncertainties = pytest.importorskip("uncertainties")

W = quantity("37.0 ± 3.7 mJ/m2", name="work_of_adhesion", symbol="W")
E = quantity("0.7 ± 0.02 MPa")
R = quantity("1.25 mm")


def relative_error(q: setae.Quantity) -> float:
    return q.standard_error / abs(q.value)


def test_sums_keep_the_unit_of_the_first_term():
    total = quantity("3 ± 0.3 nm") + quantity("0.004 ± 0.0004 um")
    assert total.unit == "nm" and total.value == pytest.approx(7.0) and total.standard_error == pytest.approx(0.5)
    assert (quantity("1 um") - quantity("100 nm")).value == pytest.approx(0.9)
    assert sum([R, R]).value == 2.5 and (0 - R).value == -1.25


def test_products_are_in_si_with_the_shorter_unit():
    force = 1.5 * math.pi * R * W
    assert force.unit == "N" and force.value == pytest.approx(1.5 * math.pi * 1.25e-3 * 37e-3)
    assert relative_error(force) == pytest.approx(0.1)
    length = W / E
    assert length.unit == "m" and relative_error(length) == pytest.approx(math.hypot(0.1, 0.02 / 0.7))
    assert (quantity("1 mN") / quantity("2 um")).unit == "N/m"
    assert (quantity("5 nm") / quantity("1 um")) == 0.005
    assert (W * 2).unit == (2 * W).unit == (W / 2).unit == "mJ/m2"
    assert (1 / R).unit == "1/m" and (1 / R).value == pytest.approx(800.0)


def test_powers_and_roots():
    assert (R**2).unit == "m2" and (R**2).value == pytest.approx(1.25e-3**2)
    root = (W * R**2 / E) ** (1 / 3)
    assert root.unit == "m" and root.value == pytest.approx((37e-3 * 1.25e-3**2 / 0.7e6) ** (1 / 3))
    assert np.sqrt(W).unit == "J0.5/m" and (np.sqrt(W) ** 2) == pytest.approx(W.to("J/m2"))
    assert (2.0 ** quantity("0.5 ± 0.1")).standard_error == pytest.approx(math.sqrt(2) * math.log(2) * 0.1)
    with pytest.raises(setae.InvalidArgument, match="exponent of mJ/m²"):
        E**W
    with pytest.raises(setae.InvalidArgument, match="uncertain exponent"):
        E ** quantity("0.5 ± 0.1")


def test_errors_of_one_quantity_are_one_error():
    assert (W - W).standard_error == 0.0 and (W / W).standard_error == 0.0
    assert (W + W).standard_error == pytest.approx(7.4)
    assert (W.to("J/m2") - W).standard_error == pytest.approx(0.0, abs=1e-18)
    assert (2 * W - W - W.to("J/m2")).standard_error == pytest.approx(0.0, abs=1e-15)
    assert (quantity("37.0 ± 3.7 mJ/m2") - W).standard_error == pytest.approx(math.hypot(3.7, 3.7))


def test_named_inputs_are_one_error():
    lens, again = quantity("lens_3 = 1.25 ± 0.01 mm"), quantity("1.25e-3 ± 1e-5 m", input_name="lens_3")
    assert lens.input_name == "lens_3" and (lens - again).standard_error == pytest.approx(0.0, abs=1e-15)
    other = pickle.loads(pickle.dumps(lens))
    assert (other - lens).standard_error == (pickle.loads(pickle.dumps(2 * lens)) - 2 * lens).standard_error == 0.0
    assert (lens - quantity("lens_4 = 1.25 ± 0.01 mm")).standard_error == pytest.approx(0.01 * math.sqrt(2))


def test_parameters_of_a_fit_are_correlated(data):
    """E* and W from a³ = R/K (√F …): the error of the radius moves both; their product has the error of the fit."""
    loop = setae.loop(data / "loops/rougher_soft.csv", radius="1.25 ± 0.01 mm")
    fit = loop.fit()
    joint = fit["loading"]["fits"]["joint"]
    product = joint["contact_modulus"] / joint["work_of_adhesion"]
    (a, b), rho = map(relative_error, (joint["contact_modulus"], joint["work_of_adhesion"])), joint["correlation"]
    assert abs(rho) > 0.9
    assert relative_error(product) == pytest.approx(math.sqrt(a**2 + b**2 - 2 * rho * a * b), rel=1e-6)
    assert (fit.E_star - fit["loading"]["contact_modulus"]).standard_error == 0.0
    primary = fit["loading"]["fits"][fit["loading"]["method"]]
    assert (fit.E_star - primary["contact_modulus"]).standard_error == 0.0
    ratio = fit["loading"]["youngs_modulus"] / fit.E_star
    assert ratio.value == pytest.approx(0.75) and ratio.standard_error < 1e-9
    model = loop.fit(models="maugis_dugdale")["models"]["fits"][0]
    a, b = relative_error(model["contact_modulus"]), relative_error(model["work_of_adhesion"])
    rho = model["correlations"][0][1]
    found = relative_error(model["contact_modulus"] * model["work_of_adhesion"])
    assert found == pytest.approx(math.sqrt(a**2 + b**2 + 2 * rho * a * b), rel=1e-6)


def test_parameters_of_a_spectrum_are_correlated():
    made = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="80 nm", rms_height="10 nm", size="5 um", pixels=64)
    psd = setae.power_spectrum(made.scan, fit=True)
    hurst, rolloff = psd.fit["hurst_exponent"], psd.fit["rolloff_wavelength"]
    rho = psd.data["fit"]["correlation"][1][2]
    expected = math.sqrt(sum(relative_error(q) ** 2 for q in (hurst, rolloff)) + 2 * rho * relative_error(hurst) * relative_error(rolloff))
    assert relative_error(hurst * rolloff) == pytest.approx(expected, rel=1e-6)


def test_an_unknown_error_stays_unknown():
    unknown = setae.Quantity("rms_height", "Sq", 1e-8, "m")
    assert math.isnan((2 * unknown).standard_error) and math.isnan((unknown + R).standard_error)
    assert str(2 * unknown) == "20.00 nm" and f"{unknown.to('nm'):.1f}" == "10.0 nm"
    assert quantity("5 nm").standard_error == 0.0 and str(quantity("5 nm")) == "5.000 nm"


@pytest.mark.parametrize("operation", [operator.lt, operator.le, operator.gt, operator.ge, operator.eq, operator.ne])
def test_comparison_is_by_value(operation):
    assert operation(quantity("1 um"), quantity("900 nm")) == operation(1000, 900)
    assert operation(quantity("1 um"), quantity("1000 nm")) == operation(1, 1)
    assert operation(quantity("0.4"), 0.4) == operation(0.4, 0.4)
    assert operation(W, 0) == operation(37, 0)


def test_quantities_of_different_dimensions():
    assert W != E and W != 37.0 and W != "37 mJ/m2" and quantity("0 m") == 0
    for operation in (operator.lt, operator.add, operator.sub):
        with pytest.raises(setae.InvalidArgument, match="MPa has no value in mJ/m²"):
            operation(W, E)
    with pytest.raises(setae.InvalidArgument, match="a number without unit has no value in mJ/m²"):
        W + 1.0
    with pytest.raises(TypeError):
        W + "1 mJ/m2"
    with pytest.raises(setae.InvalidArgument, match="furlongs_per_fortnight"):
        W.to("furlongs_per_fortnight")
    with pytest.raises(setae.InvalidArgument, match="zero of its own"):
        quantity("293 K").to("degC")


def test_equal_quantities_have_equal_hashes():
    assert len({quantity("1 um"), quantity("1000 nm"), quantity("1e-6 m")}) == 1
    assert hash(quantity("0.5")) == hash(0.5)


def test_other_units():
    assert W.to("J/m2").value == pytest.approx(0.037) and W.to("J/m²").unit == "J/m2"
    assert str(W.to("J/m2")) == str(W) == repr(W) == "37.0 ± 3.7 mJ/m²"
    known = setae.Quantity("work_of_adhesion", "W", 0.037, "J/m2", 0.002, setae.Interval(0.033, 0.041, 0.9), n=4)
    shown = known.to("mJ/m2")
    assert shown.interval.lower == pytest.approx(33.0) and shown.interval.level == 0.9
    assert (shown.symbol, shown.n, shown.quantity) == ("W", 4, "work_of_adhesion")
    assert float(shown) == pytest.approx(37.0)


@pytest.mark.parametrize(
    ("spec", "text"),
    [(".2f", "37.00 ± 3.70 mJ/m²"), (".3g", "37 ± 3.7 mJ/m²"), ("", "37.0 ± 3.7 mJ/m²"), (">18", "  37.0 ± 3.7 mJ/m²"), ("8.1f", "    37.0 ± 3.7 mJ/m²")],
)
def test_formats(spec, text):
    assert format(W, spec) == text


def test_alerts_of_operands_are_kept():
    alert = setae.Alert("CODE", "subject", "message", "action")
    warned = setae.Quantity("a", "a", 1.0, "m", 0.1, alerts=(alert,))
    assert (warned * W).alerts == (alert,) and (warned + warned).alerts == (alert,)


def test_functions_of_numpy():
    share = quantity("0.25 ± 0.05")
    assert np.sqrt(share).standard_error == pytest.approx(0.05)
    assert np.log(share).standard_error == pytest.approx(0.2) and np.exp(np.log(share)) == pytest.approx(0.25)
    assert np.cbrt(quantity("8 mm3")).to("mm").value == pytest.approx(2.0)
    assert np.hypot(quantity("3 nm"), quantity("4 nm")).to("nm").value == pytest.approx(5.0)
    assert np.maximum(W, E * quantity("1 um")).unit == "Pa m" and np.isfinite(W) and not np.isnan(W) and np.sign(-W) == -1
    assert np.log(quantity("10 nm") / quantity("1 um")) == pytest.approx(math.log(0.01))
    with pytest.raises(setae.InvalidArgument, match="log of mJ/m²"):
        np.log(W)
    with pytest.raises(TypeError):
        np.bitwise_and(W, W)


def test_arrays_of_quantities():
    radii = np.array([1.0, 2.0, 4.0])
    forces = radii * quantity("1 mm") * W
    assert forces.shape == (3,) and forces[2].unit == "N" and forces[2].value == pytest.approx(4e-3 * 37e-3)
    assert (forces[1] - 2 * forces[0]).standard_error == pytest.approx(0.0, abs=1e-15)
    np.testing.assert_allclose(np.asarray(forces, dtype=float), radii * 37e-6)
    assert np.mean(forces).value == pytest.approx(7 / 3 * 37e-6) and np.sqrt(forces)[0].value == pytest.approx(math.sqrt(37e-6))
    assert list(forces > 50e-6 * quantity("1 N")) == [False, True, True]
    assert float(np.float64(2.0) * W) == 74.0


def test_values_of_pint():
    ureg = pint.UnitRegistry()
    assert quantity(ureg("10 nm")).value == 10.0 and quantity(ureg("10 nm")).unit == "nm"
    assert (W + ureg.Quantity(1.0, "mJ/m**2")).value == pytest.approx(38.0)
    assert (W * ureg("2 mm")).to("uN").value == pytest.approx(74.0)
    measured = ureg.Quantity(uncertainties.ufloat(5.0, 0.5), "kPa")
    given = quantity(measured)
    assert (given.value, given.standard_error, given.unit) == (5.0, 0.5, "kPa")
    assert quantity(ureg("1 furlong")).unit == "m" and quantity(ureg("1 furlong")).value == pytest.approx(201.168, rel=1e-5)
    back = W.to_pint()
    assert back.value.to("J/m**2").magnitude == pytest.approx(0.037) and back.error.magnitude == pytest.approx(3.7)
    assert (W.to_pint() - W.to_pint()).error.magnitude == 0.0


def test_numbers_of_uncertainties():
    factor = uncertainties.ufloat(2.0, 0.1)
    assert (factor * W).standard_error == pytest.approx(math.hypot(0.1 * 37, 2 * 3.7))
    assert ((W * factor) / factor - W).standard_error == pytest.approx(0.0, abs=1e-12)
    assert (W.to_uncertainties() - W.to_uncertainties()).std_dev == 0.0
    assert quantity(factor, "nm").standard_error == 0.1


@pytest.mark.parametrize(
    ("text", "value", "error", "unit"),
    [
        ("10 nm", 10.0, 0.0, "nm"),
        ("1.25±0.01mm", 1.25, 0.01, "mm"),
        ("37 +- 3.7 mJ/m²", 37.0, 3.7, "mJ/m2"),
        ("1e-8 +/- 1e-9 m", 1e-8, 1e-9, "m"),
        ("0.5", 0.5, 0.0, "1"),
        ("-3 nm", -3.0, 0.0, "nm"),
    ],
)
def test_quantities_of_texts(text, value, error, unit):
    given = quantity(text)
    assert (given.value, given.standard_error, given.unit) == (value, error, unit)


@pytest.mark.parametrize("text", ["", "nm", "ten nm", "1 ± nm", "1 ± 2 ± 3 nm", "3 to 2 nm", "1 ± -2 nm", "1 blubb ± 2 nm"])
def test_wrong_texts(text):
    with pytest.raises(setae.InvalidArgument):
        quantity(text)


def test_wrong_values():
    with pytest.raises(setae.InvalidArgument, match="a unit 'nm' for a value in mm"):
        quantity(R, "nm")
    for value in ([1.0], None, True):
        with pytest.raises(TypeError, match="expected a text"):
            quantity(value)


def test_copies_share_the_error_and_pickles_keep_it():
    assert copy.copy(W) is W and copy.deepcopy([W])[0] is W
    double = 2 * W
    first, second = pickle.loads(pickle.dumps((W, double)))
    assert (second - 2 * first).standard_error == pytest.approx(0.0, abs=1e-12)
    assert first == W and second.standard_error == pytest.approx(7.4)


def test_other_packages_are_loaded_at_the_first_calculation():
    code = (
        "import setae, sys; q = setae.quantity('1.25 ± 0.01 mm'); str(q); f'{q:.2f}'; q.to('mm'); q == q; hash(setae.quantity('1 m'));"
        "q > 0; q.to_html(); print('pint' in sys.modules, 'uncertainties' in sys.modules); q * q; print('pint' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "False", "True"]
