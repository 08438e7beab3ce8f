# SPDX-License-Identifier: GPL-3.0-or-later
"""Keywords, their types and the sections "Parameters" agree with the descriptions of options in the library."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_what_is_generated_is_current() -> None:
    run = subprocess.run([sys.executable, str(ROOT / "tools/python_keywords.py"), "--check"], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr + "; make them again: PYTHONPATH=build/python tools/python_keywords.py"
