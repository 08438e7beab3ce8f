# SPDX-License-Identifier: GPL-3.0-or-later
"""Data and the program of the build tree."""

from __future__ import annotations

import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["SETAE_PROGRAM"]


@pytest.fixture(scope="session")
def data(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    """Simulated data of the tutorial: two surfaces, two elastomers, eight loops, with true values."""
    folder = tmp_path_factory.mktemp("laboratory") / "mine"
    subprocess.run([PROGRAM, "lab", "make", ROOT / "examples/tutorial/recipe.toml", "-o", folder], check=True, stdout=subprocess.DEVNULL)
    return folder


@pytest.fixture(scope="session")
def printed():
    """Runs the program with --json and returns its output."""

    def run(*arguments: object) -> str:
        done = subprocess.run([PROGRAM, *map(str, arguments), "--json"], capture_output=True, text=True)
        assert done.stdout, done.stderr
        return done.stdout

    return run
