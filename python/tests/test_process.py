# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes with the package: end while a thread computes, repeated import, fork."""

from __future__ import annotations

import subprocess
import sys

MAKE = """
import numpy as np, setae, sys, os, threading, time
heights = 1e-9 * np.random.default_rng(1).standard_normal((1500, 1500))
scan = setae.scan(heights, size="10 um x 10 um", unit="m")
"""

DAEMON = MAKE + """
def work():
    while True:
        setae.power_spectrum(scan)
for _ in range(3):
    threading.Thread(target=work, daemon=True).start()
time.sleep(0.7)
print("end", flush=True)
"""

IMPORTED_ANEW = """
import sys, setae
first = setae.version()
for name in [name for name in sys.modules if name.split(".")[0] == "setae"]:
    del sys.modules[name]
import setae as again
assert again is not setae and again.version() == first
try:
    again.read("/nowhere/scan.x3p")
except again.FileError as error:
    print("end", error)
"""

FORKED = MAKE + """
thread = threading.Thread(target=lambda: [setae.power_spectrum(scan) for _ in range(20)], daemon=True)
thread.start()
time.sleep(0.2)
child = os.fork()
if child == 0:
    sys.exit(0)  # runs the functions registered for the end
_, status = os.waitpid(child, 0)
print("end", os.waitstatus_to_exitcode(status), flush=True)
"""


def run(program: str) -> str:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, (done.returncode, done.stderr)
    assert "leaked" not in done.stderr and "registered" not in done.stderr, done.stderr
    return done.stdout


def test_ends_while_daemon_threads_compute():
    for _ in range(3):
        assert run(DAEMON).strip() == "end"


def test_can_be_imported_anew():
    assert run(IMPORTED_ANEW).startswith("end ")


def test_a_forked_child_ends():
    assert run(FORKED).strip() == "end 0"
