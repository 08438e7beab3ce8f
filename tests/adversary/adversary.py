#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tries to make setae lose, overwrite or believe something, and says where it did.

    adversary.py --program build/bin/setae --make-corpus build/bin/make_corpus [--minutes M] [--seed N] [--only ATTACK …]

Without --minutes each attack runs once. With it they go on, each with another seed, on every core until the time is up.
Exit code 0: nothing found, 1: findings, which are printed with the command and the seed that make them again.
"""
import argparse
import os
import random
import shutil
import sys
import tempfile
import time
import traceback
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from dataclasses import dataclass, field
from pathlib import Path

import attacks_on_data
import attacks_on_input
import attacks_on_sharing
import laws
from samples import Samples

ATTACKS = {a.__name__: a for a in attacks_on_data.ATTACKS + attacks_on_input.ATTACKS + attacks_on_sharing.ATTACKS}


@dataclass
class Score:
    runs: int = 0
    seconds: float = 0.0
    findings: list = field(default_factory=list)


def attacked(name, samples, seed):
    """One attack in a folder of its own; what it found, and how long it took."""
    begun = time.monotonic()
    folder = Path(tempfile.mkdtemp(prefix=f"adversary_{name}_"))
    laws.found.texts.clear()
    try:
        ATTACKS[name](samples, folder, random.Random(f"{name} {seed}"))
    except Exception:  # what an attack needs of a run that broke a law
        laws.found.add(traceback.format_exc())
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return name, seed, list(laws.found.texts), time.monotonic() - begun


def rounds(names, samples, seed, minutes):
    """Every attack once with the first seed, then on until the minutes are over."""
    end = time.monotonic() + 60.0 * minutes
    scores = {name: Score() for name in names}
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        waiting = [(name, seed) for name in names]
        running = set()
        while waiting or running:
            while waiting and len(running) < os.cpu_count():
                name, s = waiting.pop(0)
                running.add(pool.submit(attacked, name, samples, s))
            finished, running = wait(running, return_when=FIRST_COMPLETED)
            for future in finished:
                name, s, findings, seconds = future.result()
                scores[name].runs += 1
                scores[name].seconds += seconds
                for finding in findings:
                    scores[name].findings.append((s, finding))
                    print(f"FOUND {name} (seed {s}): {finding}\n", flush=True)
            if not waiting and time.monotonic() < end:
                seed += 1
                waiting = [(name, seed) for name in names]
            if time.monotonic() >= end and minutes > 0:
                waiting = []
    return scores


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", required=True)
    options.add_argument("--make-corpus", required=True)
    options.add_argument("--source", default=str(Path(__file__).resolve().parents[2]))
    options.add_argument("--minutes", type=float, default=0.0)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--only", nargs="*", choices=sorted(ATTACKS), default=list(ATTACKS))
    given = options.parse_args()
    with tempfile.TemporaryDirectory(prefix="adversary_samples_") as folder:
        samples = Samples(Path(given.program).resolve(), Path(given.make_corpus).resolve(), given.source, folder)
        scores = rounds(given.only, samples, given.seed, given.minutes)
    print(f"{'attack':<26} {'runs':>5} {'found':>6} {'s':>8}")
    for name, score in scores.items():
        print(f"{name:<26} {score.runs:>5} {len(score.findings):>6} {score.seconds:>8.1f}")
    return 1 if any(score.findings for score in scores.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
