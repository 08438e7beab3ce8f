# ---
# jupyter:
#   SPDX-License-Identifier: GPL-3.0-or-later
#   jupytext:
#     formats: py:percent
# ---
# %% [markdown]
# # A Dask run
#
# This notebook predicts the work of adhesion of many pairs of surface and elastomer on a Dask cluster. The cluster here consists of two local
# processes. On a cluster of several machines, only the address of the cluster changes (`pip install dask distributed`).

# %%
from typing import Any

import distributed
import matplotlib.pyplot as plt

import setae

moduli = ("0.3 MPa", "1 MPa", "3 MPa", "10 MPa")
slopes = (0.05, 0.1, 0.2, 0.4, 0.8)
surfaces = [
    setae.synthesize(hurst_exponent=0.8, rolloff="2 um", short_cutoff="80 nm", rms_slope=slope, size="10 um", pixels=256, seed=seed).scan
    for seed, slope in enumerate(slopes)
]

# %% [markdown]
# The function below computes one pair. Each worker uses one thread of setae, because every core has its own worker.


# %%
def pair(scan: setae.Scan, modulus: str) -> setae.WorkOfAdhesion:
    setae.limit_threads(1)
    return setae.work_of_adhesion(scan, youngs_modulus=modulus, W_int="50 mJ/m2", surface_energy="25 mJ/m2")


# %% [markdown]
# Scans travel to the workers and results travel back. The results are the same as in one process, to the last bit.


# %%
def run() -> dict[str, list[setae.WorkOfAdhesion]]:
    cluster_of: Any = distributed.LocalCluster
    client_of: Any = distributed.Client
    with cluster_of(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, client_of(cluster) as client:
        futures: dict[str, Any] = {modulus: [client.submit(pair, scan, modulus) for scan in surfaces] for modulus in moduli}
        found: dict[str, list[setae.WorkOfAdhesion]] = client.gather(futures)
    return found


if __name__ == "__main__":
    works = run()
    print("equal bytes:", works["1 MPa"][0].json() == pair(surfaces[0], "1 MPa").json())
    axes = plt.subplots()[1]
    for modulus, row in works.items():
        axes.plot(slopes, [1e3 * float(work) for work in row], "o-", label=f"E = {modulus}")
    axes.set(xlabel="rms slope", ylabel="W_app [mJ/m²]")
    axes.legend()
    plt.savefig("dask.png")
