# SPDX-License-Identifier: GPL-3.0-or-later
"""What may cost a user data: outputs over inputs, results over results, writes that fail."""
import os
import shutil
import signal
import subprocess
import time

from laws import DATE, digest, digests, done, found, lawful, no_leftovers, refused, require, run, started


def overwriting(samples, work, draw):
    """Every option that writes, pointed at an input: by its name, a symbolic and a hard link."""
    program = samples.program
    verbs = [
        ("psd", "{a}", "-o", "{out}"), ("sdrp", "{a}", "-o", "{out}"), ("acf", "{a}", "-o", "{out}"), ("vbw", "{a}", "-o", "{out}"),
        ("convert", "{a}", "{out}"), ("level", "{a}", "--step", "level_plane", "-o", "{out}"),
        ("container", "write", "{a}", "-o", "{out}"), ("params", "--documentation", "{out}", "{a}"),
        ("level", "{a}", "--documentation", "{out}"), ("man", "--documentation", "{out}"),
        ("jkr", "import", "{l}", "-o", "{out}"), ("jkr", "import", "{l}", "--save-map", "{out}"),
        ("jkr", "fit", "{l}", "--tidy", "{out}"), ("synthesize", "--help"),
    ]
    for number, words in enumerate(verbs):
        for link in ("itself", "symbolic", "hard"):
            folder = work / f"{number}_{link}"
            folder.mkdir()
            inputs = {"a": samples.profile(folder, "a.csv"), "l": samples.loop(folder, "l.csv")}
            for key, path in list(inputs.items()):
                target = inputs["l"] if "{l}" in words else inputs["a"]
            out = folder / "out.csv"
            if link == "itself":
                out = target
            elif link == "symbolic":
                out.symlink_to(target)
            else:
                os.link(target, out)
            before = digest(target)
            outcome = lawful(run(program, *[w.format(out=out, **inputs) for w in words], cwd=folder))
            require(digest(target) == before, outcome, f"an input is overwritten through {link}")
            no_leftovers(folder, outcome)


def overwriting_later_inputs(samples, work, draw):
    """Files into a folder where one output is an input that comes later."""
    samples.profile(work / "x", "b.csv")
    later = samples.profile(work, "b.csv", seed=2)
    before = digest(later)
    outcome = lawful(run(samples.program, "convert", "x/b.csv", "b.csv", "-o", ".", "--to", "csv", cwd=work))
    require(digest(later) == before, outcome, "an input that comes later is overwritten")


def results_over_inputs(samples, work, draw):
    """A study whose results would replace what it reads, or what else is there."""
    names = ["surfaces.csv", "measurements.csv"]
    for name in names:
        samples.profile(work, name)
    study = samples.surface_study(work, files=names, output=".")
    before = {n: digest(work / n) for n in names}
    outcome = lawful(run(samples.program, "study", study, "--no-figures", cwd=work))
    for name in names:
        require(digest(work / name) == before[name], outcome, f"a study overwrites its input {name}")
    other = work / "other"
    other.mkdir()
    (other / "surfaces.csv").write_text("notes of mine\n")
    study = samples.surface_study(other, output=".")
    outcome = lawful(run(samples.program, "study", study, "--no-figures", cwd=other))
    require((other / "surfaces.csv").read_text() == "notes of mine\n", outcome, "a study overwrites a file that is no result")


def names_that_share_files(samples, work, draw):
    """Surfaces whose names are alike as files: none may lose its spectrum."""
    names = ["A 1", "A_1", "A/B", "a_b", "Ä", "Ö", "α", "..", "con", "5'' wafer", "x" * 240, "名前", "='1'+1", "a\tb\x1b[31m"]
    study = samples.surface_study(work, names=names)
    outcome = done(run(samples.program, "study", study, "--no-figures", "--json", cwd=work))
    surfaces = outcome.json()["surfaces"]
    files = [surfaces[name]["spectrum_file"] for name in surfaces]
    require(len(set(f.lower() for f in files)) == len(names), outcome, f"surfaces share files: {sorted(files)}")
    for file in files:
        require((work / "study_results" / file).is_file(), outcome, f"{file} is named and missing")


def figures_of_any_name(samples, work, draw):
    """Names with gnuplot's own signs are drawn."""
    names = ["5'' wafer", "'A", "a'b'c", "`date`", "$(touch here)", "\\", "@x_{2}^{3}", '"', "%d %n", "line\nbreak"]
    study = samples.surface_study(work, names=names)
    outcome = done(run(samples.program, "study", study, cwd=work, seconds=120))
    drawn = list((work / "study_results" / "figures").glob("spectra_*.svg"))
    require(len(drawn) == len(names), outcome, f"{len(drawn)} of {len(names)} figures are drawn")
    require(not (work / "here").exists() and not (work / "study_results" / "here").exists(), outcome, "a name is run as a command")


def results_of_earlier_runs(samples, work, draw):
    """What a run no longer makes goes; what it never made stays; another study is refused."""
    study = samples.surface_study(work, names=["A", "B"])
    done(run(samples.program, "study", study, "--no-figures", cwd=work))
    folder = work / "study_results"
    (folder / "notes.txt").write_text("mine\n")
    require((folder / "psd_B.csv").exists(), done(run(samples.program, "--version")), "psd_B.csv is missing")
    study = samples.surface_study(work, names=["A"])
    outcome = done(run(samples.program, "study", study, "--no-figures", cwd=work))
    require(not (folder / "psd_B.csv").exists(), outcome, "the spectrum of a surface that is gone stays")
    require((folder / "notes.txt").exists(), outcome, "a file of the user is removed")
    other = work / "other.toml"
    shutil.copy(study, other)
    before = digests(folder)
    outcome = refused(run(samples.program, "study", other, "--output", folder, "--no-figures", cwd=work), "another")
    require(digests(folder) == before, outcome, "a refused study changes the folder")
    outside = work / "precious.txt"
    outside.write_text("precious\n")
    (folder / "files.txt").write_text("# study: ../study.toml\n../precious.txt\n" + str(outside) + "\nnotes.txt/../../precious.txt\n")
    for name in list(folder.iterdir()):
        if name.name != "files.txt":
            name.unlink()
    outcome = lawful(run(samples.program, "study", study, "--no-figures", cwd=work))
    require(outside.exists(), outcome, "a list of files removes what lies outside the folder")


def output_that_fails(samples, work, draw):
    """Standard output full or closed, files beyond a limit, folders that cannot be written."""
    path = samples.profile(work, "a.csv", points=3000)
    for words in (("info", path, "--json"), ("psd", path, "--json"), ("params", path), ("man",), ("formats",), ("--help",)):
        with open("/dev/full", "wb") as full:
            outcome = run(samples.program, *words, cwd=work, stdout=full)
        require(outcome.code != 0, outcome, "a full standard output and exit code 0")
        require(outcome.code > 0 and outcome.err.strip(), outcome, "a full standard output without a word")
    for limit in (0, 100, 4096, 20000):
        outcome = lawful(run(samples.program, "psd", path, "-o", "out.csv", cwd=work, file_bytes=limit))
        no_leftovers(work, outcome)
        require(outcome.code == 0 or not (work / "out.csv").exists(), outcome, "part of an output stays")
        (work / "out.csv").unlink(missing_ok=True)
    study = samples.surface_study(work, names=["A", "B"])
    for limit in (100, 3000, 30000):
        outcome = lawful(run(samples.program, "study", study, "--no-figures", cwd=work, file_bytes=limit))
        no_leftovers(work, outcome)
        results = work / "study_results"
        require(outcome.code != 0, outcome, "a study that could not be written and exit code 0")
        require(not (results / "report.html").exists(), outcome, "results that are not complete say that they are")
        shutil.rmtree(results, ignore_errors=True)


def killed(samples, work, draw):
    """kill -9 at any moment: no file that looks whole and is not, and the next run mends it all."""
    study = samples.surface_study(work, names=["A", "B", "C"])
    done(run(samples.program, "study", study, cwd=work, env={"SOURCE_DATE_EPOCH": "1700000000"}, seconds=120))
    whole = digests(work / "study_results")
    for _ in range(4):
        shutil.rmtree(work / "study_results")
        child = subprocess.Popen([str(samples.program), "study", str(study)], cwd=work, stdout=subprocess.DEVNULL,
                                 stderr=subprocess.DEVNULL, env={"PATH": os.environ["PATH"], "SETAE_CACHE": str(work / ".cache"),
                                                                 "SOURCE_DATE_EPOCH": "1700000000"})
        time.sleep(draw.uniform(0.0, 1.5))
        child.send_signal(signal.SIGKILL)
        child.wait()
        results = digests(work / "study_results")
        for name, value in results.items():
            if not name.endswith(b".part") and name != b"files.txt" and value != whole.get(name):
                found.add(f"killed: {name!r} is there and is not what a whole run writes")
        outcome = done(run(samples.program, "study", study, cwd=work, env={"SOURCE_DATE_EPOCH": "1700000000"}, seconds=120))
        no_leftovers(work / "study_results", outcome)
        require(digests(work / "study_results") == whole, outcome, "after a kill the next run gives other results")


def stopped(samples, work, draw):
    """SIGTERM at any moment, the conclusions included: the first one ends the run, and the next run goes on to the same bytes."""
    loops = [p for p in samples.loops if p.parent.name == "loops"][:4]
    words = ("study", samples.loop_study(work, loops), "--output", work / "out", "--no-cache")
    alone = done(run(samples.program, *words, cwd=work, env=DATE, seconds=120))
    whole = digests(work / "out")
    for part in (0.2, 0.5, 0.8, 0.95):
        shutil.rmtree(work / "out", ignore_errors=True)
        child = started(samples, work, *words)
        time.sleep(alone.seconds * part * draw.uniform(0.9, 1.05))
        child.send_signal(signal.SIGTERM)
        try:
            errors = child.communicate(timeout=20)[1]
        except subprocess.TimeoutExpired:
            child.kill()
            errors = child.communicate()[1]
            found.add(f"SIGTERM after {part:.2f} of a run does not end it within 20 s")
        if child.returncode not in (0, -signal.SIGTERM):
            found.add(f"SIGTERM after {part:.2f} of a run: exit code {child.returncode}, {errors[-300:]!r}")
        no_leftovers(work / "out", alone)
        outcome = done(run(samples.program, *words, cwd=work, env=DATE, seconds=120))
        require(digests(work / "out") == whole, outcome, "after a stop the next run gives other results")


def at_once(samples, work, draw):
    """Four runs of one study on one cache and one folder."""
    study = samples.surface_study(work, names=["A", "B"])
    children = [started(samples, work, "study", study, "--no-figures") for _ in range(4)]
    outputs = [child.communicate() for child in children]
    if any(child.returncode != 0 for child in children) or len({out for out, _ in outputs}) != 1:
        found.add(f"four runs at once: {[c.returncode for c in children]}, {[errors[-300:] for _, errors in outputs]!r}")
    alone = run(samples.program, "study", study, "--no-figures", cwd=work, env={"SOURCE_DATE_EPOCH": "1700000000"})
    if alone.out != outputs[0][0]:
        found.add("four runs at once print something else than one alone")


ATTACKS = [overwriting, overwriting_later_inputs, results_over_inputs, names_that_share_files, figures_of_any_name,
           results_of_earlier_runs, output_that_fails, killed, stopped, at_once]
