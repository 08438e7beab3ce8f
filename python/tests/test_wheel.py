# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel in a new environment, without a compiler and without the build tree on its paths."""

from __future__ import annotations

import json
import os
import pathlib
import subprocess
import sys
import tomllib

import pytest

from conftest import ROOT

WHEELS = sorted(pathlib.Path(os.environ["SETAE_WHEELS"]).glob("*.whl"))


def require_wheel() -> None:
    """A missing wheel is a failure if every test must run."""
    if WHEELS:
        return
    assert os.environ.get("SETAE_NO_SKIPS") != "1", "no wheel in build/wheels; ./setup python makes one"
    print("skipped: no wheel in build/wheels; ./setup python makes one")
    pytest.skip("no wheel")


@pytest.fixture(scope="module")
def python(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    """An interpreter with the wheel, and NumPy from the environment of the tests."""
    require_wheel()
    folder = tmp_path_factory.mktemp("environment")
    subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    python = folder / "bin/python"
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index", WHEELS[0]], check=True)
    (site,) = folder.glob("lib/python*/site-packages")
    import numpy

    for package in pathlib.Path(numpy.__file__).parents[1].glob("numpy*"):
        (site / package.name).symlink_to(package)
    return python


def run(*command: object, cwd: pathlib.Path) -> str:
    alone = {"PATH": "/usr/bin:/bin", "HOME": str(cwd), "SETAE_CACHE": str(cwd / "cache")}
    return subprocess.run([*map(str, command)], cwd=cwd, env=alone, check=True, capture_output=True, text=True).stdout


def test_size_and_platform_of_the_wheel():
    require_wheel()
    assert WHEELS[0].stat().st_size < 40e6
    assert "manylinux_2_" in WHEELS[0].name


def test_the_wheel_contains_the_licences_of_its_parts():
    require_wheel()
    told = subprocess.run([sys.executable, ROOT / "packaging/sbom.py", WHEELS[0]], capture_output=True, text=True, check=True).stdout
    packages = json.loads(told)["packages"]
    compatible = tomllib.loads((ROOT / "packaging/licences.toml").read_text())["compatible"]
    assert all(part in compatible for package in packages for part in package["licenseConcluded"].split(" AND "))
    assert {"libfftw3-double3", "libopencv-core-dev", "nanobind"} <= {package["name"] for package in packages}
    assert all(package["versionInfo"] for package in packages)


def test_the_notebook_runs_with_the_wheel(python, tmp_path):
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    shown = run(python, "-c", "import setae; print(setae.__file__, setae.version())", cwd=tmp_path)
    assert str(python.parents[1]) in shown
    run(python, ROOT / "docs/notebooks/from-files-to-figure.py", cwd=tmp_path)
    assert (tmp_path / "mine/report.html").exists()


def test_the_wheel_contains_the_program(python, tmp_path):
    version = run(python, "-c", "import setae; print(setae.version())", cwd=tmp_path)
    assert run(python.parent / "setae", "--version", cwd=tmp_path) == f"setae {version}"
    assert run(python, "-m", "setae", "--version", cwd=tmp_path) == f"setae {version}"


def test_the_wheel_contains_mappings(python, tmp_path):
    (tmp_path / "curve.txt").write_bytes((ROOT / "tests/cli/data/loop_eoh.txt").read_bytes())
    columns = run(python, "-c", "import setae; print(*setae.loop('curve.txt', mapping='eoh').columns)", cwd=tmp_path)
    assert "force" in columns
    run(python.parent / "setae", "jkr", "import", "curve.txt", "--mapping", "eoh", "-o", "sensor.csv", cwd=tmp_path)
    assert (tmp_path / "sensor.csv").exists()
