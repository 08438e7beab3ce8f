# SPDX-License-Identifier: GPL-3.0-or-later
"""Examples in docstrings and guides give the printed output, notebooks run, types are correct."""

from __future__ import annotations

import doctest
import importlib
import inspect
import os
import pathlib
import pkgutil
import re
import shutil
import subprocess
import sys

import pytest
import setae

from conftest import ROOT

MODULES = [module.name for module in pkgutil.iter_modules(setae.__path__) if module.name not in ("_setae", "__main__")]
GUIDES = ["python", "python-arrays", "study-from-python"]
TYPED_USE = ROOT / "python/tests/typed_use.py"
NOTEBOOKS = sorted((ROOT / "docs/notebooks").glob("*.py"))


@pytest.mark.parametrize("name", ["__init__", *MODULES])
def test_examples_in_docstrings(name, monkeypatch):
    monkeypatch.chdir(ROOT / "tests/cli/data")  # with the files that examples read
    module = setae if name == "__init__" else importlib.import_module(f"setae.{name}")
    assert doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE).failed == 0


def test_every_public_name_has_a_docstring():
    silent = [name for name in setae.__all__ if name != "__version__" and not (getattr(setae, name).__doc__ or "").strip()]
    assert not silent


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks_run(notebook, tmp_path):
    """Runs in a folder with examples, as the notebook describes."""
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    few = {**os.environ, "SETAE_NOTEBOOK_FILES": "20"}
    subprocess.run([sys.executable, notebook], cwd=tmp_path, check=True, stdout=subprocess.DEVNULL, env=few)
    if notebook.stem == "from-files-to-figure":
        assert (tmp_path / "mine/report.html").stat().st_size > 100_000
        assert (tmp_path / "mine/figure_4.csv").read_text().startswith("#")


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_the_licence_of_a_notebook_is_no_cell(notebook):
    """jupytext takes lines before the first cell as metadata if the file begins with them."""
    head = notebook.read_text().split("# %%")[0].splitlines()
    assert head[0] == head[-1] == "# ---" and "#   SPDX-License-Identifier: GPL-3.0-or-later" in head


def blocks(page: pathlib.Path) -> str:
    return "\n".join(re.findall(r"^```python\n(.*?)^```", page.read_text(), re.S | re.M))


@pytest.mark.parametrize("guide", GUIDES)
def test_the_guide_runs(guide, data, tmp_path):
    """Runs the blocks one after the other in the folder of the tutorial files."""
    shutil.copytree(data, tmp_path / "mine")
    source = blocks(ROOT / f"docs/guides/{guide}.md")
    assert "import setae" in source
    subprocess.run([sys.executable, "-c", source], cwd=tmp_path, check=True, stdout=subprocess.DEVNULL, env={**os.environ, "MPLBACKEND": "svg"})


def test_types(tmp_path):
    """mypy --strict for the package, the notebooks, the guides, and a use of all functions."""
    pytest.importorskip("mypy")
    guides = [tmp_path / f"{guide.replace('-', '_')}.py" for guide in GUIDES]
    for guide, written in zip(GUIDES, guides):
        written.write_text(blocks(ROOT / f"docs/guides/{guide}.md"))
    package = pathlib.Path(setae.__file__).parent
    command = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir", tmp_path / "cache", package]
    done = subprocess.run([*command, *guides, *NOTEBOOKS, TYPED_USE], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 0, done.stdout


def test_every_public_function_is_used_with_its_types():
    used = set(re.findall(r"setae\.(\w+)", TYPED_USE.read_text()))
    assert {name for name in setae.__all__ if inspect.isroutine(getattr(setae, name))} <= used


def test_the_module_is_the_program(tmp_path):
    typed = subprocess.run([sys.executable, "-m", "setae", "--version"], capture_output=True, text=True, check=True)
    assert typed.stdout == f"setae {setae.version()}\n"
    failed = subprocess.run([sys.executable, "-m", "setae", "psd", "no/such"], capture_output=True, text=True)
    assert failed.returncode == 2 and "no/such" in failed.stderr
