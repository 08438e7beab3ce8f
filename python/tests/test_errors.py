# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions state what happened, where, the value and the expected value, and are subclasses of Python's own."""

from __future__ import annotations

import pickle

import pytest
import setae


def test_a_missing_file():
    with pytest.raises(setae.FileError) as caught:
        setae.read("no/such.spm")
    assert caught.value.file == "no/such.spm"
    assert isinstance(caught.value, OSError) and isinstance(caught.value, setae.Error)


def test_a_file_of_no_format(tmp_path):
    (tmp_path / "a.spm").write_bytes(bytes(range(256)) * 8)
    with pytest.raises(setae.FormatError) as caught:
        setae.read(tmp_path / "a.spm")
    assert caught.value.file == str(tmp_path / "a.spm") and isinstance(caught.value, ValueError)


def test_a_wrong_line(tmp_path):
    (tmp_path / "study.toml").write_text('title = "a"\n[analysis]\nspectrum = "avrage"\n')
    with pytest.raises(setae.FormatError) as caught:
        setae.study(tmp_path / "study.toml")
    assert caught.value.file == str(tmp_path / "study.toml") and caught.value.line == 3 and caught.value.expected


def test_a_truncated_file(tmp_path):
    np = pytest.importorskip("numpy")
    np.save(tmp_path / "map.npy", np.ones((16, 16)))
    content = (tmp_path / "map.npy").read_bytes()
    (tmp_path / "map.npy").write_bytes(content[:-100])
    with pytest.raises(setae.FormatError) as caught:
        setae.read(tmp_path / "map.npy", size="1 um x 1 um", unit="m")
    assert caught.value.file == str(tmp_path / "map.npy")


def test_an_error_of_one_measurement_is_its_own(tmp_path):
    """The error names the file of the measurement, which can be left out instead."""
    (tmp_path / "good.csv").write_text("x [um],h [nm]\n" + "".join(f"{i},{(i * 7) % 5}\n" for i in range(64)))
    (tmp_path / "bad.csv").write_text("x [um],h [nm]\n0,1\n1,two\n")
    files = [tmp_path / "good.csv", tmp_path / "bad.csv"]
    with pytest.raises(setae.FormatError, match="two") as caught:
        setae.power_spectrum(files)
    assert caught.value.file == str(tmp_path / "bad.csv") and caught.value.line == 3
    left = setae.power_spectrum(files, skip_failed=True)
    assert left.n == 1 and "FILES_LEFT_OUT" in [alert.code for alert in left.alerts]


def test_loops(tmp_path, data):
    with pytest.raises(setae.FileError):
        setae.loop("no/such.csv")
    with pytest.raises(setae.InvalidArgument, match="no unit"):
        setae.loop(data / "loops/rougher_soft.csv", radius="1.25")
    with pytest.raises(TypeError, match="unweighted"):
        setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm").fit(weighted=False)
    with pytest.raises(setae.InvalidArgument, match="kPa"):
        setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm").fit(models=["hertz"], model_contact_point="5 kPa")
    (tmp_path / "loop.csv").write_text("time [s],force [N],displacement [m]\n0,1e-6,0\n")
    with pytest.raises(setae.Error):
        setae.loop(tmp_path / "loop.csv", radius="1.25 mm").fit()


@pytest.mark.parametrize(
    ("argument", "words"),
    [
        ({"poisson_ratio": 0.7}, "0.5"), ({"youngs_modulus": "0.7"}, "0.7"), ({"youngs_modulus": "-1 MPa"}, "above 0"),
        ({"W_int": "37 mJ"}, "J"), ({"radius": "1 mm"}, "preload"),
    ],  # fmt: skip
)
def test_solids(argument, words, data):
    solids = {"youngs_modulus": "0.7 MPa", "W_int": "37 mJ/m2", "surface_energy": "25 mJ/m2", **argument}
    with pytest.raises(setae.InvalidArgument, match=words):
        setae.work_of_adhesion(data / "rougher/afm_1.txt", **solids)


def test_value_of_another_type(data):
    with pytest.raises(TypeError, match="points: str; expected a whole number"):
        setae.tip(data / "rougher/afm_1.txt", points="many")


@pytest.mark.parametrize(
    "argument",
    [
        {"window": "hamming"}, {"longest_wavelength": "1 kg"}, {"contours": "lines"}, {"conversion": "none"}, {"memory": -1.0},
        {"bootstrap_resamples": -1},
    ],  # fmt: skip
)
def test_analysis(argument, data):
    with pytest.raises(setae.InvalidArgument):
        setae.parameters(data / "rougher/afm_1.txt", **argument)


def test_functions_of_scale(data):
    for argument in ({"order": 4}, {"distance": "3 kg"}, {"statistic": "median"}, {"along": "z"}, {"bins_per_decade": 0}, {"weighting": "none"}):
        with pytest.raises(setae.InvalidArgument):
            setae.scale_dependent_roughness(data / "rougher/afm_1.txt", **argument)
    with pytest.raises(TypeError, match="bins"):
        setae.autocorrelation(data / "rougher/afm_1.txt", bins=3)


def test_errors_are_pickled():
    with pytest.raises(setae.InvalidArgument) as caught:
        setae.lengths("5 kg")
    other = pickle.loads(pickle.dumps(caught.value))
    assert str(other) == str(caught.value) and other.got == caught.value.got and type(other) is setae.InvalidArgument
