# SPDX-License-Identifier: GPL-3.0-or-later
"""Other threads run during a call, Ctrl-C interrupts a call, no memory leaks."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import setae


def large(points: int) -> setae.Scan:
    heights = 1e-9 * np.random.default_rng(1).standard_normal((points, points))
    return setae.scan(heights, size="10 um x 10 um", unit="m")


def test_other_threads_run_during_a_call():
    scan, beats, over = large(1024), [], threading.Event()

    def beat() -> None:
        while not over.is_set():
            beats.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=beat)
    thread.start()
    began = time.monotonic()
    setae.power_spectrum(scan)
    ended = time.monotonic()
    over.set()
    thread.join()
    inside = [b for b in beats if began < b < ended]
    assert len(inside) > 3


def test_threads_of_python_get_the_same():
    scan = large(128)
    expected = setae.power_spectrum(scan).json()
    found: list[str] = []
    threads = [threading.Thread(target=lambda: found.append(setae.power_spectrum(scan).json())) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 8


INTERRUPTED = """
import os, signal, sys, threading, time
import numpy as np, setae
heights = 1e-9 * np.random.default_rng(1).standard_normal((6144, 6144))
scan = setae.scan(heights, size="10 um x 10 um", unit="m")
print("begun", flush=True)
try:
    for _ in range(100):
        setae.parameters(scan)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    small = setae.scan(heights[:64, :64].copy(), size="1 um x 1 um", unit="m")
    print(len(setae.power_spectrum(small).q), flush=True)
"""


def test_ctrl_c():
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    time.sleep(0.5)
    os.kill(process.pid, signal.SIGINT)
    assert process.stdout.readline() == "interrupted\n"
    assert int(process.stdout.readline()) > 10  # the process continues
    assert process.wait() == 0


def resident() -> int:
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_ten_thousand_calls_leak_no_memory():
    heights = 1e-9 * np.random.default_rng(1).standard_normal((32, 32))

    def call(i: int) -> None:
        scan = setae.scan(heights, size="1 um x 1 um", unit="m")
        assert len(setae.power_spectrum(scan).q) > 10
        if i % 10 == 0:
            assert scan.level().heights.shape == (32, 32) and setae.parameters(scan)["rms_height"].value > 0
        with pytest.raises(setae.InvalidArgument):
            setae.lengths("5 kg")

    setae.limit_threads(1)  # for a short test
    for i in range(1000):
        call(i)
    before = resident()
    for i in range(10_000):
        call(i)
    setae.limit_threads(0)
    # an array of 8 KiB per call would be 80 MB
    assert resident() - before < 4 << 20


def test_simulated_maps_leak_no_memory():
    def call(seed: int) -> None:
        made = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="80 nm", rms_height="20 nm", size="5 um", pixels=256, seed=seed)
        small = setae.scan(made.scan.heights[::8, ::8], size="5 um x 5 um", unit="m", periodic=True)
        assert setae.contact(small, contact_modulus="1 GPa", pressure="10 MPa").pressures.max() > 0

    for seed in range(20):
        call(seed)
    before = resident()
    for seed in range(100):
        call(seed)
    # a map of 512 KiB per call would be 50 MB
    assert resident() - before < 8 << 20


def test_the_end_of_python_has_no_output():
    """Scans and results in modules are released without messages."""
    source = """
import setae
made = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="80 nm", rms_height="20 nm", size="5 um", pixels=32)
levelled = made.scan.level()
solved = setae.contact(levelled, contact_modulus="1 GPa", pressure="1 MPa")
found = setae.persson(made.scan, contact_modulus="1 GPa", pressure="1 MPa")
"""
    done = subprocess.run([sys.executable, "-c", source], capture_output=True, text=True, check=True)
    assert done.stderr == ""


def test_threads_are_limited():
    scan = large(256)
    expected = setae.power_spectrum(scan).json()
    setae.limit_threads(1)
    try:
        assert setae.power_spectrum(scan).json() == expected
    finally:
        setae.limit_threads(0)
