# SPDX-License-Identifier: GPL-3.0-or-later
"""Tasks for other processes, as a user would write them; as a program it maps them in processes that Python starts.

parallel_tasks.py METHOD: METHOD is fork, forkserver or spawn.
"""

from __future__ import annotations

import hashlib
import multiprocessing
import pathlib
import sys
from typing import Any

import numpy as np
import setae

SOLIDS: dict[str, Any] = {"W_int": "50 mJ/m2", "gamma": "25 mJ/m2"}


def file_task(file: pathlib.Path) -> str:
    """A file: heights, spectrum and parameters as bytes."""
    levelled = setae.read(file, size="2 um x 2 um", unit="m").level()
    psd = setae.power_spectrum(levelled)
    return digest(levelled.heights, psd.C1D, psd.json(), setae.parameters(levelled).json())


def pair_task(pair: tuple[setae.Surface | setae.Scan, setae.Quantity | str]) -> setae.WorkOfAdhesion:
    """A pair of surface and elastomer."""
    surface, modulus = pair
    return setae.work_of_adhesion(surface, youngs_modulus=modulus, **SOLIDS)


def loop_task(loop: setae.Loop) -> setae.LoopFit:
    return loop.fit()


def digest(*parts: Any) -> str:
    found = hashlib.sha256()
    for part in parts:
        found.update(part.encode() if isinstance(part, str) else np.ascontiguousarray(part).tobytes())
    return found.hexdigest()


def array_task(seed: int) -> str:
    """Heights large enough for several threads."""
    heights = 1e-9 * np.random.default_rng(seed).standard_normal((256, 256))
    psd = setae.power_spectrum(setae.scan(heights, size="10 um x 10 um", unit="m"), isotropic=True)
    return digest(psd.C1D, psd.json())


def main() -> None:
    expected = [array_task(seed) for seed in range(4)]  # threads of the library exist in this process
    with multiprocessing.get_context(sys.argv[1]).Pool(2) as pool:
        found = pool.map_async(array_task, range(4)).get(60)
    assert found == expected
    print("equal")


if __name__ == "__main__":
    main()
