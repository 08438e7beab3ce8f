# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays, tables and quantities of other packages as arguments: the numbers of the same content in a file, and no temporary path in results."""

from __future__ import annotations

import gc
import os
import pathlib
import pickle
import tempfile

import numpy as np
import pytest
import setae

from conftest import ROOT

pandas, pint, xarray = pytest.importorskip("pandas"), pytest.importorskip("pint"), pytest.importorskip("xarray")

CLI_DATA = ROOT / "tests/cli/data"
UNITS = pint.UnitRegistry()
SIZE = "5 um x 3 um"


def rough(*shape: int) -> np.ndarray:
    return 1e-8 * np.random.default_rng(4).standard_normal(shape)


@pytest.fixture(autouse=True)
def no_file_is_left():
    """Files of content in memory exist only as long as the content."""
    before = set(pathlib.Path(tempfile.gettempdir()).glob("setae-given-*"))
    yield
    gc.collect()  # errors keep the content
    left = set(pathlib.Path(tempfile.gettempdir()).glob("setae-given-*")) - before
    assert not left


# heights


def test_heights_with_units_of_pint():
    heights = rough(16, 12)
    scan = setae.scan(UNITS.Quantity(1e9 * heights, "nm"), size=UNITS.Quantity([5.0, 3.0], "um"))
    np.testing.assert_allclose(scan.heights, heights, rtol=1e-15)
    np.testing.assert_allclose(scan.size, (5e-6, 3e-6), rtol=1e-15)
    with pytest.raises(setae.InvalidArgument, match="kilogram"):
        setae.scan(UNITS.Quantity(heights, "kg"), size=SIZE)


def test_the_size_of_a_scan_is_a_size():
    scan = setae.scan(rough(16, 12), size=SIZE, unit="m")
    again = setae.scan(scan.heights, size=scan.size, unit="m")
    assert again.size == scan.size and isinstance(scan.size[0], float)
    assert setae.power_spectrum(again).json() == setae.power_spectrum(scan).json()
    line = setae.scan(scan.heights[:, 0].copy(), size=scan.size[0], unit="m")
    assert line.size == scan.size[:1]
    with pytest.raises(setae.InvalidArgument, match="5e-06"):
        setae.scan(scan.heights, size=(5e-6, 3e-6), unit="m")


def test_dimensions_of_a_data_array_are_known_by_name():
    scan = setae.scan(rough(16, 12), size=SIZE, unit="m")
    turned = setae.scan(scan.to_xarray().transpose("y", "x"))
    np.testing.assert_array_equal(turned.heights, scan.heights)


# lines


def test_a_line_with_unequal_steps_is_a_traced_curve(tmp_path):
    x = np.sort(np.random.default_rng(1).uniform(0.0, 50.0, 200))
    z = np.sin(x)
    curve = setae.scan(z, x=x, unit="um, nm", name="trace")
    np.testing.assert_allclose(curve.positions, 1e-6 * x, rtol=1e-15)
    np.testing.assert_allclose(curve.heights, 1e-9 * z, rtol=1e-15)
    np.savetxt(tmp_path / "trace", np.column_stack([x, z]), header="x [um]\theight [nm]", delimiter="\t", fmt="%.17g", comments="")
    for call in (setae.power_spectrum, setae.parameters, setae.check):
        assert call(curve).json() == call(setae.read(tmp_path / "trace", keep_values=True)).json().replace(f"{tmp_path}/", "")


def test_a_line_with_equal_steps_is_on_a_grid():
    x = 0.25 * np.arange(64)
    on_grid = setae.scan(np.sin(x), x=x, unit="nm")
    assert on_grid.positions is None and on_grid.size == pytest.approx((16e-9,))


@pytest.mark.parametrize(
    "line",
    [
        lambda x, z: setae.scan(UNITS.Quantity(z, "nm"), x=UNITS.Quantity(x, "um")),
        lambda x, z: setae.scan(pandas.DataFrame({"x [um]": x, "height [nm]": z})),
        lambda x, z: setae.scan({"x": UNITS.Quantity(x, "um"), "z [nm]": z}),
        lambda x, z: setae.scan(xarray.DataArray(z, dims="x", coords={"x": ("x", x, {"units": "um"})}, attrs={"units": "nm"})),
        lambda x, z: setae.scan(np.ma.masked_array(z), x=x, unit="um, nm"),
    ],
    ids=["pint", "pandas", "dictionary", "xarray", "masked"],
)
def test_lines_of_other_packages(line):
    x, z = np.array([0.0, 1.0, 3.0, 4.0, 6.0]), np.array([0.0, 1.0, -1.0, 0.5, 2.0])
    found = line(x, z)
    np.testing.assert_allclose(found.positions, 1e-6 * x, rtol=1e-15, atol=1e-24)
    np.testing.assert_allclose(found.heights, 1e-9 * z, rtol=1e-15, atol=1e-24)


def test_heights_of_an_array_are_not_marks_of_missing_data():
    z = np.array([0.0, 1.0, -9999.0, 0.5, 2.0, 1.0])
    assert setae.scan(z, x=[0.0, 1.0, 3.0, 4.0, 6.0, 7.0], unit="nm").heights.min() == pytest.approx(-9999e-9)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"x": [0.0, 1.0, 3.0]}, "positions x have no unit"),
        ({"x": [0.0, 1.0], "unit": "nm"}, "equal length"),
        ({"x": [0.0, np.nan, 3.0], "unit": "nm"}, "trace: x of point 2 is undefined"),
        ({"x": [0.0, 1.0, 3.0], "unit": "kg"}, "kg"),
        ({"unit": "nm"}, "positions x"),
    ],
)
def test_wrong_lines_are_refused(arguments, words):
    with pytest.raises(setae.Error, match=words):
        setae.scan([0.0, 1.0, 0.0], name="trace", **arguments).heights


def test_a_line_is_pickled():
    curve = setae.scan([0.0, 1.0, 0.0, 2.0], x=[0.0, 1.0, 3.0, 4.0], unit="nm")
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(curve)).positions, curve.positions)


# spectra


@pytest.fixture(scope="module")
def psd() -> setae.PowerSpectrum:
    return setae.power_spectrum([setae.scan(rough(32, 32), size="5 um x 5 um", unit="m"), setae.scan(rough(64), size="20 um", unit="m")])


def spectra(psd: setae.PowerSpectrum) -> dict[str, object]:
    q, C1D, error = psd.q, psd.C1D, psd.standard_error
    return {
        "result": psd,
        "pandas": psd.to_pandas(),
        "xarray": psd.to_xarray(),
        "names": {"q [1/m]": q, "C1D [m3]": C1D, "standard_error [m3]": error},
        "pint": {"q": UNITS.Quantity(q, "1/m"), "C1D": UNITS.Quantity(C1D, "m**3"), "standard_error": UNITS.Quantity(error, "m**3")},
        "structured": np.rec.fromarrays([q, C1D, error], names=["q [1/m]", "C1D [m3]", "standard_error [m3]"]),
    }


@pytest.mark.parametrize("kind", ["result", "pandas", "xarray", "names", "pint", "structured"])
def test_spectra_in_memory_are_those_of_a_file(psd, kind, tmp_path):
    file = tmp_path / "table"
    psd.to_pandas().rename(columns=lambda name: f"{name} [{psd.units[name]}]").to_csv(file, index=False)
    table = spectra(psd)[kind]
    again = setae.power_spectrum(table)
    for name in ("wavevector", "C1D", "standard_error"):
        np.testing.assert_array_equal(again.columns[name], psd.columns[name])
    asked = {"contact_modulus": "1 MPa", "pressure": "10 kPa"}
    assert setae.persson(table, **asked).json() == setae.persson(file, **asked).json().replace(f"{tmp_path}/", "")


def test_units_of_a_spectrum_may_be_an_argument(psd):
    bare = {"first": 1e-6 * psd.q / (2 * np.pi), "second": 2e27 * psd.C1D}
    found = setae.power_spectrum(bare, unit="frequency 1/um, one-sided nm3")
    np.testing.assert_allclose(found.q, psd.q, rtol=1e-14)
    np.testing.assert_allclose(found.C1D, psd.C1D, rtol=1e-14)
    with pytest.raises(setae.InvalidArgument, match="no unit"):
        setae.power_spectrum(bare)


def test_isotropic_spectra_and_their_surfaces(psd):
    q = np.geomspace(1e5, 1e8, 60)
    C_iso = 1e-27 * (q / 1e6) ** -3.6
    surface = setae.surface({"q [1/m]": q, "C_iso [m4]": C_iso})
    assert surface.method == "given" and surface.C_iso == pytest.approx(C_iso, rel=1e-15)
    work = setae.work_of_adhesion({"q [1/m]": q, "C_iso [m4]": C_iso}, youngs_modulus="1 MPa", W_int="50 mJ/m2", surface_energy="25 mJ/m2")
    assert float(work) == float(setae.work_of_adhesion(surface, youngs_modulus="1 MPa", W_int="50 mJ/m2", surface_energy="25 mJ/m2"))
    made = setae.synthesize(spectrum={"q [1/m]": q, "C_iso [m4]": C_iso}, size="2 um", pixels=64)
    assert "/" not in made.data.get("spectrum_file", "") and made.scan.heights.std() > 0.0


# loops and force curves


@pytest.fixture(scope="module")
def loop_file(data) -> pathlib.Path:
    return data / "loops/rougher_soft.csv"


def loops(loop: setae.Loop) -> dict[str, object]:
    columns, units = loop.columns, loop.units
    return {
        "pandas": loop.to_pandas(),
        "xarray": loop.to_xarray(),
        "names": pandas.DataFrame({f"{name} [{units[name]}]": values for name, values in columns.items()}),
        "index": loop.to_pandas().set_index("time"),
        "pint": {name: UNITS.Quantity(values, units[name]) for name, values in columns.items()},
        "loop": loop,
    }


@pytest.mark.parametrize("kind", ["pandas", "xarray", "names", "index", "pint", "loop"])
def test_loops_in_memory_are_those_of_a_file(loop_file, kind):
    loop = setae.loop(loop_file, radius="1.25 ± 0.01 mm")
    given = setae.loop(loops(loop)[kind], radius="1.25 ± 0.01 mm")
    for name, values in loop.columns.items():
        np.testing.assert_array_equal(given[name], values)
    assert given.fit(models="jkr").json() == loop.fit(models="jkr").json().replace(str(loop_file), "loop")
    assert given.energy().json() == loop.energy().json().replace(str(loop_file), "loop")
    assert pickle.loads(pickle.dumps(given)).fit().json() == given.fit().json()


def test_units_of_a_loop_may_be_an_argument(loop_file):
    loop = setae.loop(loop_file, radius="1.25 mm")
    table = {"load": 1e3 * loop["force"], "displacement": 1e6 * loop["displacement"], "time": loop["time"]}
    given = setae.loop(table, units={"load": "mN", "displacement": "um", "time": "s"}, radius="1.25 mm")
    np.testing.assert_allclose(given["force"], loop["force"], rtol=1e-15)
    with pytest.raises(setae.FormatError, match="^loop: .*no unit"):
        setae.loop(table, radius="1.25 mm")
    with pytest.raises(setae.InvalidArgument, match="'force' is no column"):
        setae.loop(table, units={"force": "mN"}, radius="1.25 mm")
    with pytest.raises(TypeError, match="a file states its own units"):
        setae.loop(loop_file, units={"force": "mN"})


def test_the_table_of_a_camera_may_be_in_memory():
    arguments = {"radius": "1.25 mm", "clock_offset": "0 s"}
    camera = CLI_DATA / "radii_of_camera.csv"
    from_file = setae.loop(CLI_DATA / "force_beside_frames.csv", camera=camera, **arguments)
    table = pandas.read_csv(camera, comment="#")
    from_memory = setae.loop(CLI_DATA / "force_beside_frames.csv", camera=table, **arguments)
    np.testing.assert_array_equal(from_memory["contact_radius"], from_file["contact_radius"])


def test_force_curves_in_memory():
    rng = np.random.default_rng(2)
    depth = np.concatenate([np.linspace(-200.0, 300.0, 400), np.linspace(300.0, -200.0, 400)])
    force = 4 / 3 * 1e6 * np.sqrt(5e-6) * np.maximum(1e-9 * depth, 0.0) ** 1.5 + 1e-11 * rng.standard_normal(depth.size)
    curve = {"displacement": UNITS.Quantity(depth, "nm"), "force": UNITS.Quantity(1e9 * force, "nN")}
    fit = setae.force_curves(curve, radius="5 um", model="hertz", poisson_ratio=0.5)
    moduli = [q for q in fit["segments"][0].values() if isinstance(q, setae.Quantity) and q.quantity == "contact_modulus"]
    assert [float(q) for q in moduli] == pytest.approx([1e6], rel=5e-3)
    assert tempfile.gettempdir() not in fit.json()


# tables of fits, lenses, edges


def test_fits_of_many_loops_in_memory():
    file = CLI_DATA / "fits.csv"
    asked = {"branch": "loading", "group_by": ["surface", "lens"]}
    from_file, from_memory = setae.replicates(file, **asked), setae.replicates(pandas.read_csv(file), **asked)
    assert from_memory.json() == from_file.json().replace(str(file), "fits")


def test_a_lens_in_memory():
    file = CLI_DATA / "lens_profile.csv"
    table = pandas.read_csv(file)
    assert setae.lens(table).json() == setae.lens(file).json().replace(str(file), "lens")
    line = setae.scan(table["z [um]"], x=table["x [mm]"], unit="mm, um")
    assert float(setae.lens(line).radius) == pytest.approx(float(setae.lens(file).radius), rel=1e-9)


def test_edges_in_memory():
    file = CLI_DATA / "edge.csv"
    table = pandas.read_csv(file, comment="#")
    found = setae.contact_line(table)
    np.testing.assert_array_equal(found["mean_radius"], setae.contact_line(file)["mean_radius"])
    again = setae.contact_line(found)
    np.testing.assert_array_equal(again["mean_radius"], found["mean_radius"])
    np.testing.assert_array_equal(setae.contact_line(found.edge)["mean_radius"], found["mean_radius"])


# files behind the scenes


def test_numbers_keep_all_digits_and_shapes_of_tables_are_checked():
    from setae._tables import Table, table_of

    values = np.random.default_rng(0).standard_normal(1000) * 10.0 ** np.random.default_rng(1).integers(-300, 300, 1000)
    rows = Table({"a": values}).text().decode().splitlines()[1:]
    np.testing.assert_array_equal(np.array(rows, dtype=float), values)
    with pytest.raises(setae.InvalidArgument, match="equal length"):
        Table({"a": [1.0], "b": [1.0, 2.0]}).text()
    with pytest.raises(setae.InvalidArgument, match="2 dimensions"):
        Table({"a": np.ones((2, 2))}).text()
    frame = pandas.DataFrame({"a": pandas.array([1, None], dtype="Int64"), "b": ["x", None]})
    assert table_of(frame).text() == b"a\tb\n1\tx\n\t\n"


def test_errors_name_the_table_not_its_file():
    with pytest.raises(setae.FormatError) as raised:
        setae.loop({"force [kg]": [1.0, 2.0], "displacement [um]": [1.0, 2.0]}, radius="1 mm")
    assert str(raised.value).startswith("loop: ") and raised.value.file == "loop"
    assert tempfile.gettempdir() not in str(raised.value)


def test_a_forked_process_leaves_the_files_of_its_parent():
    given = setae.scan([0.0, 1.0, 0.0, 2.0], x=[0.0, 1.0, 3.0, 4.0], unit="nm")
    path = os.fspath(given.file)
    child = os.fork()
    if child == 0:
        del given
        os._exit(0)
    os.waitpid(child, 0)
    assert pathlib.Path(path).exists()
    del given
