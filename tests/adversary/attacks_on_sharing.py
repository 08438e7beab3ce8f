# SPDX-License-Identifier: GPL-3.0-or-later
"""What is shared: one folder of results, cache or figures for two runs, and files that change while they are read."""
import os
import shutil
import stat
import subprocess
import threading
import time
from pathlib import Path

from laws import DATE, digests, done, found, lawful, no_leftovers, refused, require, run, started

def two_studies(samples, work):
    """a.toml and b.toml in one folder, of other surfaces."""
    for name in "ab":
        samples.surface_study(work, names=[name]).rename(work / f"{name}.toml")


def results_of_two_studies(samples, work, draw):
    """Two studies with one folder: the second is refused, by whatever path and from whatever folder."""
    two_studies(samples, work)
    (work / "below").mkdir()
    for place, first, second, output in ((work, "a.toml", "b.toml", "results"), (work / "below", "../a.toml", "../b.toml", "../other"),
                                         (work, work / "a.toml", "b.toml", "third")):
        done(run(samples.program, "study", first, "--output", output, cwd=place, seconds=120))
        before = digests(place / output)
        outcome = refused(run(samples.program, "study", second, "--output", output, cwd=place, seconds=120), "another output")
        require(digests(place / output) == before, outcome, "a second study changes the results of the first")
        here = work if place != work else work / "below"
        again = os.path.relpath((Path(place) / first).resolve(), here)
        done(run(samples.program, "study", again, "--output", os.path.relpath((place / output).resolve(), here), cwd=here, seconds=120))
    nameless = work / "results" / "files.txt"
    nameless.write_text("\n".join(line if not line.startswith("# study") else "# study: " for line in nameless.read_text().splitlines()))
    refused(run(samples.program, "study", "b.toml", "--output", "results", "--no-figures", cwd=work), "whose results")


def studies_at_once(samples, work, draw):
    """Two studies that begin at once with one folder: one is refused, the results are those of the other."""
    two_studies(samples, work)
    whole = {}
    for name in "ab":
        done(run(samples.program, "study", work / f"{name}.toml", "--output", "results", cwd=work, env=DATE, seconds=120))
        whole[name] = digests(work / "results")
        shutil.rmtree(work / "results")
    for _ in range(4):
        shutil.rmtree(work / "results", ignore_errors=True)
        shutil.rmtree(work / ".cache", ignore_errors=True)
        children = {name: started(samples, work, "study", work / f"{name}.toml", "--output", "results") for name in "ab"}
        errors = {name: child.communicate()[1] for name, child in children.items()}
        winners = [name for name, child in children.items() if child.returncode == 0]
        if len(winners) != 1:
            found.add(f"of two studies at once {winners} end well: {errors!r}")
            continue
        results, alone = digests(work / "results"), whole[winners[0]]
        if results != alone:
            different = sorted(n for n in set(results) | set(alone) if results.get(n) != alone.get(n))
            found.add(f"two studies at once mix their results: {different}")


class Changing:
    """A file that takes turns between two contents: replaced, or written in place."""

    def __init__(self, path, contents, in_place, pause):
        self.path, self.contents, self.in_place, self.pause = Path(path), contents, in_place, pause
        self.ended = threading.Event()
        self.thread = threading.Thread(target=self.change)

    def put(self, content):
        if self.in_place:
            self.path.write_bytes(content)
            return
        other = self.path.with_suffix(".new")
        other.write_bytes(content)
        os.replace(other, self.path)

    def change(self):
        turn = 0
        while not self.ended.wait(self.pause):
            turn += 1
            self.put(self.contents[turn % 2])

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.ended.set()
        self.thread.join()
        self.put(self.contents[0])


def files_that_change(samples, work, draw):
    """A file that changes all the time is read as one of its contents or refused, and never kept for another one."""
    path = samples.profile(work, "scan_0_0.csv", points=60000)
    small = path.read_bytes()
    path.write_bytes(b"x [um],z [um]\n" + small.split(b"\n", 1)[1])  # a thousand times as high
    contents = [small, path.read_bytes()]
    alone = []
    for content in contents:
        path.write_bytes(content)
        alone.append(done(run(samples.program, "psd", path, "--json", cwd=work)).out)
    study = samples.surface_study(work, files=["scan_0_0.csv"])
    path.write_bytes(small)
    fresh = done(run(samples.program, "study", study, "--no-figures", "--json", "--no-cache", cwd=work, env=DATE)).json()["surfaces"]
    for in_place in (False, True):
        with Changing(path, contents, in_place, draw.uniform(0.0005, 0.01)):
            for _ in range(6):
                outcome = lawful(run(samples.program, "psd", path, "--json", cwd=work))
                require(outcome.code != 0 or in_place or outcome.out in alone, outcome, "a replaced file is read as neither content")
                require(outcome.code == 0 or in_place or outcome.says("another program"), outcome, "no word of the change")
                lawful(run(samples.program, "study", study, "--no-figures", "--json", cwd=work, env=DATE))
                shutil.rmtree(work / "study_results", ignore_errors=True)
        outcome = done(run(samples.program, "study", study, "--no-figures", "--json", cwd=work, env=DATE))
        require(outcome.json()["surfaces"] == fresh, outcome, "the cache has results of another content")
        shutil.rmtree(work / "study_results", ignore_errors=True)
    # between the digest and the reading: at every moment of a run once
    for k in range(8):
        path.write_bytes(small)
        shutil.rmtree(work / ".cache", ignore_errors=True)
        child = started(samples, work, "study", study, "--no-figures")
        time.sleep(draw.uniform(0.0, 0.12))
        os.utime(path)
        status = path.stat()
        path.write_bytes(contents[1])
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
        child.communicate()
        path.write_bytes(small)
        outcome = done(run(samples.program, "study", study, "--no-figures", "--json", cwd=work, env=DATE))
        require(outcome.json()["surfaces"] == fresh, outcome, "the cache has results of a content that came later")


def temporary_names(samples, work, draw):
    """Links under every name that could be foreseen: nothing is written through one."""
    target = work / "precious"
    target.write_text("precious\n")
    places = work / "tmp"
    places.mkdir()
    samples.profile(work, "a.csv")
    done(run(samples.program, "container", "write", "a.csv", "-o", "c.zip", cwd=work))
    child = subprocess.Popen(["true"])
    child.wait()
    first = child.pid
    for process in range(first, first + 3000):
        (places / f"setae_check_{process}.zip").symlink_to(target)
        (work / f"o.csv.{process}.0.part").symlink_to(target)
    for words in (("container", "check", "c.zip"), ("psd", "a.csv", "-o", "o.csv")):
        outcome = done(run(samples.program, *words, cwd=work, env={"TMPDIR": str(places)}))
        require(target.read_bytes() == b"precious\n", outcome, "a file is written through a link in the place of a temporary one")


def what_is_anothers(samples, work, draw):
    """Files of the user beside results, foreign folders behind links, permissions, names of studies with line feeds."""
    study = samples.surface_study(work, names=["A"])
    done(run(samples.program, "study", study, cwd=work, seconds=120))
    folder = work / "study_results"
    mine = [folder / name for name in ("x.999999.1.part", "surfaces.csv.999999.1.part", "notes.txt")]
    for path in mine:
        path.write_text("mine\n")
    outcome = done(run(samples.program, "study", study, cwd=work, seconds=120))
    require(all(path.exists() for path in mine), outcome, "a file of the user beside the results is removed")
    foreign = work / "foreign"
    shutil.move(folder / "figures", foreign)
    (foreign / "x.999999.1.part").write_text("mine\n")
    (folder / "figures").symlink_to(foreign)
    before = digests(foreign)
    outcome = lawful(run(samples.program, "study", study, cwd=work, seconds=120))
    require(digests(foreign) == before, outcome, "files behind a link in the results are changed")
    strange = work / "study\nnotes.txt\n.toml"
    shutil.copy(study, strange)
    other = work / "other"
    other.mkdir()
    (other / "notes.txt").write_text("mine\n")
    for _ in range(2):
        outcome = done(run(samples.program, "study", strange, "--output", "other", "--no-figures", cwd=work))
        require((other / "notes.txt").exists(), outcome, "the name of a study removes a file of the user")
    private = work / "private.csv"
    private.touch(mode=0o600)
    private.chmod(0o600)
    outcome = done(run(samples.program, "psd", "scan_0_0.csv", "-o", private, cwd=work))
    require(stat.S_IMODE(private.stat().st_mode) == 0o600, outcome, "an output has more readers than the file it replaces")
    no_leftovers(work / "other", outcome)


def constant_scan(samples, work, draw):
    """One constant scan of several costs itself, with its name, in averages and fits."""
    (work / "flat.csv").write_text("x [um],z [nm]\n" + "".join(f"{0.01 * i:.3f},5\n" for i in range(400)))
    samples.profile(work, "good.csv")
    samples.profile(work, "better.csv", seed=2)
    study = samples.surface_study(work, files=["good.csv", "flat.csv", "better.csv"])
    average = study.read_text()
    for text in (average, average.replace('spectrum = "average"\n', "")):
        study.write_text(text)
        outcome = lawful(run(samples.program, "study", study, "--no-figures", "--json", cwd=work))
        surface = outcome.json()["surfaces"]["A"]
        require(outcome.code == 1 and "error" not in surface, outcome, "one constant scan costs the whole surface")
        require(outcome.says("flat.csv"), outcome, "the constant scan is not named")


def figures_at_once(samples, work, draw):
    """Two processes that write one figure, one table, one scan: it is that of one of them, whole."""
    two_studies(samples, work)
    orders = {"spectra.svg": [("plot", f"{n}.toml", "--figure", f"spectra:{n}", "--width", width, "-o", "spectra.svg")
                              for n, width in (("a", "single"), ("b", "double"))],
              "spectra.csv": [("plot", f"{n}.toml", "--figure", f"spectra:{n}", "-o", "spectra.csv") for n in "ab"],
              "psd.csv": [("psd", f"scan_0_{k}.csv", "-o", "psd.csv") for k in range(2)],
              "c.zip": [("container", "write", f"scan_0_{k}.csv", "-o", "c.zip") for k in range(2)]}
    for name, runs in orders.items():
        alone = set()
        for words in runs:
            outcome = done(run(samples.program, *words, cwd=work, env=DATE, seconds=120))
            alone.add(digests(work)[name.encode()])
        require(len(alone) == 2, outcome, f"{name}: the two runs write the same, which tests nothing")
        for _ in range(5):
            (work / name).unlink()
            children = [started(samples, work, *words) for words in runs]
            errors = [child.communicate()[1] for child in children]
            if any(child.returncode != 0 for child in children):
                found.add(f"two runs that write {name} at once: {[c.returncode for c in children]}, {errors!r}")
            elif digests(work)[name.encode()] not in alone:
                found.add(f"two runs that write {name} at once leave a file that neither writes alone")
    no_leftovers(work, outcome)


def power_failures(samples, work, draw):
    """Every file is on the disk before it takes its name, and its folder is behind: what a power failure leaves is whole."""
    study = samples.surface_study(work)
    log = work / "calls"
    shim = samples.program.parent / "recorded_calls.so"
    for words in (("study", study, "--output", "results"), ("psd", "scan_0_0.csv", "-o", "psd.csv"),
                  ("synthesize", "--hurst", "0.8", "--pixels", "64", "--size", "5 um", "--rms-height", "5 nm", "--rolloff", "1 um", "--short-cutoff", "200 nm", "-o", "map.nc"), ("container", "write", "scan_0_0.csv", "-o", "c.zip")):
        log.unlink(missing_ok=True)
        before = digests(work)
        outcome = done(run(samples.program, *words, cwd=work, seconds=120,
                           env={"LD_PRELOAD": str(shim), "RECORDED_CALLS": str(log), "OMP_NUM_THREADS": "1"}))
        calls = [line.split(" ", 2) for line in log.read_text().splitlines()] if log.exists() else []
        flushed, placed, waiting = set(), set(), {}
        for call, inode, path in calls:
            if call == "fsync":
                flushed.add(inode)
                waiting = {folder: paths for folder, paths in waiting.items() if folder != inode}
                continue
            target = work / path
            if target.suffix == ".part":  # libraries place their content under the temporary name
                continue
            if target.is_relative_to(work) and ".cache" not in target.parts:
                placed.add(str(target.relative_to(work)))
                require(inode in flushed, outcome, f"{path} takes its name before it is on the disk")
                parent = os.stat(target.parent)
                waiting.setdefault(f"{parent.st_dev}:{parent.st_ino}", []).append(path)
        require(not waiting, outcome, f"folders that are not flushed behind their files: {waiting}")
        new = {os.fsdecode(n) for n, value in digests(work).items() if before.get(n) != value} - {"calls"}
        direct = sorted(n for n in new - placed if not n.startswith(".cache/"))
        require(not direct, outcome, f"written under their own names: {direct}")


ATTACKS = [results_of_two_studies, studies_at_once, figures_at_once, power_failures, files_that_change, temporary_names, what_is_anothers,
           constant_scan]
