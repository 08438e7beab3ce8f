# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies and pickles of everything that the package returns; joblib, Dask and processes give the bytes of one process; Ctrl-C; fork."""

from __future__ import annotations

import copy
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
import parallel_tasks
import pytest
import setae
from parallel_tasks import file_task, loop_task, pair_task
from test_result_family import MAKERS
from test_round_trips import CLI_DATA, PRODUCERS, front, line_of_contact, rough_map, study

HERE = pathlib.Path(__file__).parent
PRODUCED = [pytest.param(make, id=name) for kind in PRODUCERS.values() for name, make in kind.items()]
#: Results of other functions, made from a map and the folder of the tutorial.
MADE = [
    pytest.param(lambda data, folder, make=make: make(rough_map(), data), id=name)
    for name, make in MAKERS.items()
    if name not in ("ContactFront", "ContainerReport")  # among the producers, and below
]
OTHERS = [
    pytest.param(lambda data, folder: setae.check_container(setae_container(folder)), id="ContainerReport"),
    pytest.param(lambda data, folder: setae.loop(data / "loops/rougher_soft.csv", radius="1.25 mm").fit()["loading"], id="part of a fit"),
    pytest.param(lambda data, folder: study().run(output=folder / "results"), id="StudyResult"),
    pytest.param(lambda data, folder: study().run(output=folder / "results").figures["4"], id="Figure"),
    pytest.param(lambda data, folder: study().run(output=folder / "results").predict(), id="prediction"),
    pytest.param(lambda data, folder: setae.read(data / "rougher/afm_1.txt").level().processing.steps[0], id="Step"),
    pytest.param(lambda data, folder: setae.quantity("1.25 ± 0.01 mm"), id="quantity"),
    pytest.param(lambda data, folder: setae.Study().surface("A", rough_map()), id="study of a map"),
]
MOVED: dict[str, Callable[[Any], Any]] = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    "pickle": lambda value: pickle.loads(pickle.dumps(value)),
}


def setae_container(folder: pathlib.Path) -> pathlib.Path:
    setae.write_container(folder / "container.zip", [rough_map()])
    return folder / "container.zip"


def content(value: Any, folder: pathlib.Path) -> list[Any]:
    """What a user reads from a value, as texts and arrays."""
    if isinstance(value, setae.Study):
        file = folder / "content/study.toml"
        value = value.to_toml(file) if value._file is None else value
        return [pathlib.Path(value._file or "").read_text(), repr(value)]
    if isinstance(value, setae.StudyResult):
        return [value.json(), value.file, repr(value), value.budget(), {name: figure.csv() for name, figure in value.figures.items() if not figure.reason}]
    if isinstance(value, setae.Figure):
        return [repr(value), value.caption, value.csv()]
    if isinstance(value, setae.Scan):
        return [value.heights, value.positions, value.size, value.pixel_size, value.periodic, value.unit, str(value.alerts), value.steps, repr(value)]
    if isinstance(value, setae.Loop):
        return [*value.columns.values(), value.units, value.metadata, repr(value.bodies)]
    if isinstance(value, setae.Result):
        return [value.json(), repr(value), list(value), value._repr_html_(), *arrays(value), *written(value, folder)]
    if hasattr(value, "attrs"):  # of pandas and xarray
        return [np.asarray(value.to_array() if hasattr(value, "data_vars") else value), dict(value.attrs)]
    if isinstance(value, dict):
        return [*value.values(), list(value), getattr(value, "units", None)]
    return [repr(value), getattr(value, "unit", None), str(getattr(value, "standard_error", None))]


def arrays(value: Any) -> Iterator[np.ndarray]:
    """Arrays in the attributes of a result, and in scans, mappings and tuples among these."""
    if isinstance(value, np.ndarray):
        yield value
    elif isinstance(value, (setae.Result, setae.Scan)):
        for entry in (value.heights,) if isinstance(value, setae.Scan) else vars(value).values():
            yield from arrays(entry) if not isinstance(entry, setae.Result) else ()
    elif isinstance(value, (Mapping, tuple)):
        for entry in value.values() if isinstance(value, Mapping) else value:
            yield from arrays(entry)


def written(value: setae.Result, folder: pathlib.Path) -> list[bytes]:
    """The table that a recording or a simulated contact writes."""
    write = getattr(value, "save_edge", None) if getattr(value, "edge", None) else None
    write = write or (value.save if isinstance(value, (setae.ContactRadii, setae.ContactLine)) else None)
    if write is None:
        return []
    write(folder / "written.csv")
    return [(folder / "written.csv").read_bytes()]


def require_equal(found: list[Any], expected: list[Any]) -> None:
    assert len(found) == len(expected)
    for one, other in zip(found, expected):
        if isinstance(other, np.ndarray):
            np.testing.assert_array_equal(one, other)
            assert one.dtype == other.dtype
        else:
            assert one == other


@pytest.mark.parametrize("make", [*PRODUCED, *MADE, *OTHERS])
def test_copies_and_pickles_have_equal_content(make, data, tmp_path):
    value = make(data, tmp_path)
    expected = content(value, tmp_path)
    for move in MOVED.values():
        require_equal(content(move(value), tmp_path), expected)


def test_pickles_are_small(data, tmp_path):
    """Arrays are in a pickle once; of a file only the path and the steps."""
    scan = rough_map()
    file = setae.read(data / "rougher/afm_1.txt").level().despike()
    assert file.heights.nbytes > 100_000 and len(pickle.dumps(file)) < 1000
    of_files = setae.surface([setae.read(data / f"rougher/afm_{i}.txt") for i in (1, 2, 3)], spectrum="average")
    of_arrays = setae.surface([scan, scan], spectrum="average")
    for result, given in ((of_files, 0), (of_arrays, scan.heights.nbytes), *((make(scan, data), 0) for make in sized())):
        own = sum(array.nbytes for array in arrays(result))
        size = len(pickle.dumps(result))
        assert size < own + given + len(result.json().encode()) + 8000, type(result).__name__
    done = study().run(output=tmp_path)
    assert len(pickle.dumps(done)) < len(done.json().encode()) + 1000


def sized() -> Iterator[Callable[[setae.Scan, pathlib.Path], Any]]:
    yield from (MAKERS[name] for name in ("Contact", "ContactSweep", "PowerSpectrum", "Synthesis", "FunctionOfScale", "PerssonContact", "LoopFit"))


def test_a_pickled_study_continues_and_refuses_other_results(tmp_path):
    done = study().run(output=tmp_path)
    moved, changed = (pickle.loads(pickle.dumps(done)) for _ in range(2))
    assert moved.next_measurements().json() == done.next_measurements().json()
    file = tmp_path / "study.toml"
    file.write_text(file.read_text().replace('title = "', 'title = "Another '))
    with pytest.raises(setae.InvalidArgument, match="expected unchanged files"):
        changed.summary()
    assert changed.json() == done.json()


def test_the_edge_of_a_front_is_an_argument_after_pickling():
    for edge in (front(), line_of_contact()):
        moved = pickle.loads(pickle.dumps(edge))
        assert setae.contact_line(moved).json() == setae.contact_line(edge).json()


@pytest.fixture(scope="module")
def tasks(data, tmp_path_factory) -> list[tuple[Callable[[Any], Any], list[Any]]]:
    """Tasks over files, over pairs of surface and elastomer, and over loops."""
    folder = tmp_path_factory.mktemp("maps")
    files = []
    for seed in range(4):
        made = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="126 nm", rms_height="10 nm", size="2 um", pixels=32, seed=seed)
        files.append(folder / f"map_{seed}.npy")
        made.scan.save(files[-1])
    surfaces = [setae.surface([rough_map(), rough_map().level()], spectrum="average"), rough_map()]
    pairs = [(surface, modulus) for surface in surfaces for modulus in ("0.7 ± 0.02 MPa", setae.quantity("2 MPa"))]
    loops = [setae.loop(data / f"loops/{name}.csv", radius="1.25 ± 0.01 mm") for name in ("rougher_soft", "rougher_stiff")]
    return [(file_task, files), (pair_task, pairs), (loop_task, [*loops, setae.loop(loops[0].to_pandas(), radius="1.25 mm")])]


def texts(results: list[Any]) -> list[str]:
    return [result if isinstance(result, str) else result.json() for result in results]


@pytest.mark.parametrize("backend", ["loky", "threading", "multiprocessing"])
def test_joblib_gives_the_same_bytes(backend, tasks):
    joblib = pytest.importorskip("joblib")
    with joblib.Parallel(n_jobs=2, backend=backend) as parallel:
        for task, given in tasks:
            assert texts(parallel(joblib.delayed(task)(one) for one in given)) == texts([task(one) for one in given])


def test_dask_gives_the_same_bytes(tasks, tmp_path):
    distributed = pytest.importorskip("distributed")
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, local_directory=str(tmp_path))
    with cluster, distributed.Client(cluster) as client:
        for task, given in tasks:
            assert texts(client.gather(client.map(task, given))) == texts([task(one) for one in given])


@pytest.mark.parametrize("method", ["fork", "forkserver", "spawn"])
def test_processes_of_python_give_the_same_bytes(method):
    """The parent has used the threads of the library before."""
    done = subprocess.run([sys.executable, parallel_tasks.__file__, method], capture_output=True, text=True, timeout=120)
    assert done.stdout == "equal\n", done.stderr


def test_a_child_of_a_fork_during_calls_computes():
    """Forks while threads are in the library, which hold its locks at any moment."""
    done = subprocess.run([sys.executable, "-c", FORKS], capture_output=True, text=True, timeout=120)
    assert done.stdout == "ended [0]\n", (done.stdout, done.stderr)


FORKS = """
import os, signal, threading
import numpy as np, setae
heights = 1e-9 * np.random.default_rng(1).standard_normal((400, 400))
def spectrum(points):
    setae.power_spectrum(setae.scan(heights[:points, :points].copy(), size="1 um x 1 um", unit="m"), isotropic=True)
def work():
    while True:
        for points in range(100, 400):
            spectrum(points)
for _ in range(2):
    threading.Thread(target=work, daemon=True).start()
spectrum(99)
statuses = set()
for points in range(30, 70):
    child = os.fork()
    if child == 0:
        signal.alarm(20)
        spectrum(points)
        os._exit(0)
    statuses.add(os.waitpid(child, 0)[1])
print("ended", sorted(statuses), flush=True)
os._exit(0)
"""

LONG_CALLS = {
    "power_spectrum": "setae.power_spectrum(large, isotropic=True)",
    "parameters": "setae.parameters(large)",
    "contact": "setae.contact(rough, contact_modulus='1 MPa', pressure='1 kPa', tolerance=1e-14)",
    "contact_front": "setae.contact_front(rough, radius='1 um', contact_modulus='1 MPa', W_int='50 mJ/m2', to_displacement='50 nm',"
                     " shortest_wavelength='1 um', steps=5000)",
    "synthesize": "setae.synthesize(hurst_exponent=0.8, rolloff='1 um', short_cutoff='20 nm', rms_height='30 nm', size='5 um', pixels=6000)",
    "patch_survey": "setae.patch_survey(energy_shares=[0.3], points=[256], points_per_wave=[8], realisations=20, loops=True)",
}

INTERRUPTED = """
import os, signal, threading, time
import numpy as np, setae
large = setae.scan(1e-9 * np.random.default_rng(1).standard_normal((3000, 3000)), size="10 um x 10 um", unit="m")
rough = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="20 nm", rms_height="30 nm", size="5 um", pixels=512).scan
for name, call in CALLS.items():
    def interrupt():
        global sent
        sent = time.monotonic()
        os.kill(os.getpid(), signal.SIGINT)
    threading.Timer(0.3, interrupt).start()
    try:
        while True:
            eval(call)
    except KeyboardInterrupt:
        print(name, time.monotonic() - sent, flush=True)
print(len(setae.power_spectrum(setae.scan([0.0, 1.0, 0.0, 2.0] * 8, size="1 um", unit="nm")).q) > 3)
"""


def test_ctrl_c_ends_long_calls_within_a_second():
    done = subprocess.run([sys.executable, "-c", f"CALLS = {LONG_CALLS!r}" + INTERRUPTED], capture_output=True, text=True, timeout=120)
    *lines, after = done.stdout.splitlines()
    assert after == "True" and [line.split()[0] for line in lines] == list(LONG_CALLS), (done.stdout, done.stderr)
    slow = max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))  # other programs on the same processors
    assert max(float(line.split()[1]) for line in lines) < slow, done.stdout


POOL = """
import sys
import numpy as np, setae, parallel_tasks
from joblib import Parallel, delayed
if __name__ == "__main__":
    heights = 1e-9 * np.random.default_rng(1).standard_normal((1500, 1500))
    scan = setae.scan(heights, size="10 um x 10 um", unit="m")
    print("begun", flush=True)
    try:
        Parallel(n_jobs=2, backend=sys.argv[1])(delayed(setae.parameters)(scan) for _ in range(100))
    except KeyboardInterrupt:
        print("interrupted", flush=True)
"""


@pytest.mark.parametrize("backend", ["loky", "multiprocessing", "threading"])
def test_ctrl_c_leaves_no_process(backend, tmp_path):
    pytest.importorskip("joblib")
    (tmp_path / "pool.py").write_text(POOL)
    own = {**os.environ, "PYTHONPATH": os.pathsep.join([str(HERE), os.environ.get("PYTHONPATH", "")])}
    process = subprocess.Popen([sys.executable, tmp_path / "pool.py", backend], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               start_new_session=True, env=own)
    assert process.stdout is not None and process.stdout.readline() == "begun\n"
    time.sleep(1.0)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    shown, problems = process.communicate(timeout=60)
    assert shown == "interrupted\n", problems
    ended = time.monotonic() + 20.0
    while members(process.pid) and time.monotonic() < ended:
        time.sleep(0.1)
    assert not members(process.pid)


def members(session: int) -> list[str]:
    """Commands of the processes of a session that have not ended."""
    found = []
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            state, _, _, number = (folder / "stat").read_text().rpartition(")")[2].split()[:4]
        except OSError:
            continue  # the process has ended
        if int(number) == session and state != "Z":
            found.append((folder / "cmdline").read_text())
    return found


def test_a_counter_advances_during_calls():
    """The lock of the interpreter is free during long calls."""
    scan = setae.scan(1e-9 * np.random.default_rng(1).standard_normal((1024, 1024)), size="10 um x 10 um", unit="m")
    loop = setae.loop(CLI_DATA / "loop_on_glass.csv", radius="1 mm")
    counted, over = [0], threading.Event()

    def count() -> None:
        while not over.wait(0.001):
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    try:
        for call in (lambda: setae.power_spectrum(scan), lambda: setae.parameters(scan), lambda: scan.level("polynomial", degree=4).heights,
                     lambda: setae.patch_survey(energy_shares=[0.05], points=[128], points_per_wave=[8], realisations=2)):
            began, before = time.monotonic(), counted[0]
            call()
            seconds = time.monotonic() - began
            assert counted[0] - before >= min(10, 20 * seconds)
        assert loop.columns["force"].size
    finally:
        over.set()
        thread.join()
