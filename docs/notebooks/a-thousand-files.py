# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # A thousand files
#
# This notebook computes the parameters of many files on all cores. One file takes milliseconds, so the start of a process would take longer
# than the computation. Threads avoid this, because setae releases Python's lock while it computes. joblib avoids it, because it reuses its
# processes. Both give the same numbers.

# %%
import concurrent.futures
import os
import pathlib
import time

import setae

count = int(os.environ.get("SETAE_NOTEBOOK_FILES", "1000"))
folder = pathlib.Path("scans")
folder.mkdir(exist_ok=True)
for seed in range(count):
    made = setae.synthesize(hurst_exponent=0.8, rolloff="1 um", short_cutoff="80 nm", rms_height="20 nm", size="5 um", pixels=128, seed=seed)
    made.scan.save(folder / f"scan_{seed:04}.npy")
files = sorted(folder.glob("*.npy"))

# %% [markdown]
# The function below returns the results of one file. A file that cannot be read gives a row with the reason, and the other files are still
# computed.


# %%
def row(file: pathlib.Path) -> dict[str, object]:
    setae.limit_threads(1)  # as many files at once as cores, each on one
    try:
        scan = setae.read(file, size="5 um x 5 um", unit="m").level()
        found = setae.parameters(scan, bootstrap_resamples=0)
    except setae.Error as error:
        return {"file": file.name, "error": str(error)}
    return {"file": file.name, "Sq": float(found["rms_height"]), "slope": float(found["rms_slope_from_spectrum"])}


(folder / "scan_9999.npy").write_bytes(b"no array")
files.append(folder / "scan_9999.npy")

# %%
began = time.perf_counter()
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    rows = list(pool.map(row, files))
print(f"threads: {len(rows)} files in {time.perf_counter() - began:.1f} s")
print(rows[0], rows[-1])

# %% [markdown]
# The same computation with joblib, if it is installed (`pip install joblib`).

# %%
try:
    from joblib import Parallel, delayed
except ImportError:
    print("joblib is not installed")
else:
    began = time.perf_counter()
    same = list(Parallel(n_jobs=os.cpu_count())(delayed(row)(file) for file in files))
    print(f"joblib: {len(same)} files in {time.perf_counter() - began:.1f} s; the same numbers: {same == rows}")
setae.limit_threads(0)
