# SPDX-License-Identifier: GPL-3.0-or-later
"""What comes in: damaged and special files, hostile texts, impossible numbers, odd names and environments."""
import csv
import gzip
import json
import os
import re
import shutil
import struct
import xml.dom.minidom
import xml.parsers.expat
import zipfile
from pathlib import Path

from laws import digest, digests, done, lawful, refused, require, run


def readers(path):
    """Verbs that a file of this kind may be given to."""
    common = [("info", path, "--json"), ("check", path, "--json"), ("psd", path, "--json"), ("params", path, "--json")]
    name = str(path)
    if "/text_" in name:
        return [("study", path, "--dry-run", "--json"), ("lab", "make", path, "-o", path.parent / "made"), ("jkr", "fit", path, "--json"),
                ("jkr", "import", path, "--json"), ("info", path, "--json"), ("jkr", "fit", path, "--map", path),
                ("psd", path, "--pipeline", path), ("contour", path, "--anchors", path)]
    if any(kind in name for kind in ("/dm/", "/ser/", "/emd/", "/mrc/", "/picture/", "/tiff/", "/avi/")):
        return [("contour", path, "--json"), ("info", path, "--json"), ("jkr", "radius", path, "--um-per-px", "1", "--json")]
    if name.endswith(".zip"):
        common.append(("container", "check", path, "--json"))
    return common


def damaged(data, draw):
    """A file as it comes out of broken disks, transfers and minds."""
    data = bytearray(data)
    for _ in range(draw.choice((1, 1, 2, 8, 64))):
        if not data:
            break
        at = draw.randrange(len(data))
        kind = draw.randrange(7)
        if kind == 0:
            data[at] = draw.randrange(256)
        elif kind == 1:
            data[at:at + 4] = draw.choice((b"\xff\xff\xff\xff", b"\x00\x00\x00\x00", b"\x00\x00\x00\x80", b"\xff\xff\xff\x7f"))
        elif kind == 2:
            del data[at:]
        elif kind == 3:
            del data[at:at + draw.randrange(1, 64)]
        elif kind == 4:
            data[at:at] = bytes(draw.randrange(256) for _ in range(draw.randrange(1, 32)))
        elif kind == 5:
            data[at:at] = data[draw.randrange(len(data)):][:draw.randrange(1, 256)]
        else:
            data[at:at + 8] = struct.pack("<d", draw.choice((float("nan"), float("inf"), -1e308, 1e308, 5e-324)))
    return bytes(data)


def mutation(samples, work, draw, count=40):
    """Samples of every format, damaged at random, through the verbs that read them."""
    inputs = samples.formats + samples.loops[:20]
    for i in range(count):
        source = draw.choice(inputs)
        endings = {"text_pipeline_yaml": ".yml", "text_loop": ".csv", "text_calibration": ".json", "text_trace": ".json"}
        kind = source.parent.name
        ending = endings.get(kind, ".toml") if kind.startswith("text_") else source.suffix
        path = work / kind / f"{i}{ending}"
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(damaged(source.read_bytes(), draw))
        before = digest(path)
        choices = [("jkr", "fit", path, "--json"), ("info", path)] if source in samples.loops else readers(path)
        words = draw.choice(choices)
        outcome = lawful(run(samples.program, *words, cwd=work), data="json" if "--json" in words else None)
        require(digest(path) == before, outcome, "an input is changed")
        path.unlink()


def special_files(samples, work, draw):
    """Pipes, devices, folders, circles of links, holes of 200 GB, files without permission, no name at all."""
    os.mkfifo(work / "pipe")
    (work / "circle").symlink_to(work / "circle")
    (work / "dangling").symlink_to(work / "nowhere")
    (work / "empty").touch()
    with open(work / "hole.csv", "wb") as file:
        file.truncate(200 << 30)
    with open(work / "hole.sur", "wb") as file:
        file.write(b"DIGITAL SURF")
        file.truncate(200 << 30)
    good = samples.profile(work, "good.csv")
    things = {"pipe": "regular file", "/dev/zero": "regular file", "/dev/stdin": "", "/dev/full": "regular file", "circle": "circle",
              "dangling": "no such file", "empty": "", ".": "", "hole.csv": "", "hole.sur": "", "no such\nfile": "no such file",
              "x" * 300: "too long", "good.csv/below": ""}
    verbs = [("info", "{}"), ("psd", "{}"), ("check", "{}"), ("convert", "{}", "out.csv"), ("contour", "{}"), ("jkr", "fit", "{}"),
             ("study", "{}"), ("container", "check", "{}"), ("jkr", "fit", "good.csv", "--map", "{}"),
             ("psd", "good.csv", "--pipeline", "{}"), ("lab", "make", "{}", "-o", "made")]
    for thing, reason in things.items():
        for verb in verbs:
            words = [w.format(thing) for w in verb]
            outcome = lawful(run(samples.program, *words, cwd=work, seconds=20))
            require(not reason or outcome.says(reason) or outcome.code == 0, outcome, f"the reason is not \"{reason}\"")
    for thing in ("pipe", "circle", "/dev/zero"):
        study = samples.surface_study(work, files=["good.csv", thing])
        outcome = lawful(run(samples.program, "study", study, "--no-figures", cwd=work, seconds=20))
        require(outcome.code == 1, outcome, f"{thing} costs the whole study")
    for place in ("pipe", "/dev/null", "/dev/stdout", ".", "circle"):
        before = os.lstat(place if place.startswith("/") else work / place).st_ino
        outcome = lawful(run(samples.program, "psd", good, "-o", place, cwd=work, seconds=20))
        require(os.lstat(place if place.startswith("/") else work / place).st_ino == before, outcome, f"{place} is replaced")


def deep_text(samples, work, draw):
    """Texts that are deep, cyclic, or grow when they are read."""
    depth = 200_000
    texts = {"deep.json": "[" * depth, "deep.toml": "a = " + "[" * depth, "deep.yaml": "[" * depth, "flow.yaml": "{a: " * depth,
             "cycle.yaml": "x: &a [*a]", "laughs.yaml": "a0: &a0 [x]\n" + "".join(
                 f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]\n" for i in range(1, 12)),
             "deep.xml": "<a>" * depth, "keys.toml": "a" + ".a" * depth + " = 1", "quotes.csv": '"' * depth,
             "parts.toml": "".join(f"[{'a.' * 500}b{i}]\n" for i in range(100))}
    for name, text in texts.items():
        path = work / name
        path.write_text(text)
        for verb in (("info", path), ("study", path), ("jkr", "fit", samples.loop(work), "--map", path),
                     ("psd", samples.profile(work), "--pipeline", path), ("lab", "make", path, "-o", "made")):
            lawful(run(samples.program, *verb, cwd=work))
        for member in ("meta.yml", "meta.yaml", "index.json"):
            container = work / "c.zip"
            with zipfile.ZipFile(container, "w", zipfile.ZIP_DEFLATED) as archive:
                archive.writestr(member, text)
            for verb in (("info", container), ("container", "check", container)):
                lawful(run(samples.program, *verb, cwd=work))
    with gzip.open(work / "bomb.txt.gz", "wb", compresslevel=9) as file:
        for _ in range(1024):
            file.write(b"0 " * (1 << 19))
    outcome = lawful(run(samples.program, "info", work / "bomb.txt.gz", cwd=work))
    require(outcome.peak_bytes < 512 << 20, outcome, f"a bomb of {(work / 'bomb.txt.gz').stat().st_size >> 20} MB takes {outcome.peak_bytes >> 20} MiB")


def impossible_numbers(samples, work, draw):
    """Quantities outside their domain are refused with the key and the line, or with the option."""
    path, loop = samples.profile(work), samples.loop(work)
    options = [
        ("psd", path, "--resolution", "-1nm"), ("psd", path, "--resolution", "nan nm"), ("psd", path, "--tip-radius", "10 ± nan nm"),
        ("psd", path, "--tip-radius", "-10 nm"), ("psd", path, "--tip-radius", "inf nm"), ("psd", path, "--tip-radius", "0 nm"),
        ("info", path, "--channel", "-1"), ("convert", path, "out.csv", "--channel", "-1"), ("psd", path, "--threads", "-3"),
        ("jkr", "fit", loop, "--lens-height", "-1mm", "--radius", "1.25 mm"), ("jkr", "fit", loop, "--radius", "1.25 mm", "--contact-point", "nan"),
        ("jkr", "fit", loop, "--radius=-1.25 mm"), ("jkr", "fit", loop, "--radius", "0 mm"), ("jkr", "fit", loop, "--radius", "nan mm"),
        ("adhesion", path, "--E", "-0.7MPa"), ("adhesion", path, "--E", "0 MPa"), ("adhesion", path, "--E", "nan MPa"),
        ("psd", path, "--memory", "nan"), ("psd", path, "--memory", "inf"),
    ]
    for words in options:
        outcome = refused(run(samples.program, *words, cwd=work))
        bad = next(w for w in words[1:] if isinstance(w, str) and re.search(r"-\d|nan|inf|^0 ", w))
        number = re.search(r"-?(\d[\d.]*|nan|inf)", bad.split("±")[-1]).group(0)
        require(outcome.says(number) and not outcome.says("missing") and not outcome.says("1844674407"), outcome,
                f"the reason does not say what is wrong with {number}")
    keys = {
        "longest_wavelength": ("analysis", ['"-1 nm"', '"nan m"', '"inf m"', '"0 m"']),
        "shortest_wavelength": ("analysis", ['"-1 nm"', '"0 m"']), "surface_shortest_wavelength": ("analysis", ['"-4e-10 m"', '"nan m"']),
        "cutoff_scan": ("analysis", ['["-1 nm"]', '["nan m"]']), "tip_percentile": ("analysis", ["-1", "1e9", "nan", "inf"]),
        "bootstrap_resamples": ("analysis", ["-5", "1000000000000"]), "youngs_modulus": ('elastomers."E"', ['"-0.69 MPa"', '"0 MPa"', '"nan MPa"', '"inf MPa"', '"1 ± nan MPa"', '"1 ± -1 MPa"']),
        "poisson_ratio": ('elastomers."E"', ["-2", "0.51", "nan", "inf"]),
        "surface_energy": ('elastomers."E"', ['"-25 mJ/m2"', '"nan mJ/m2"', '"inf mJ/m2"']),
        "sphere_radius": ('elastomers."E"', ['"-1 mm"', '"0 mm"', '"nan mm"']),
        "sphere_height": ('elastomers."E"', ['"-1 mm"', '"0 mm"']),
    }
    for key, (table, values) in keys.items():
        for value in values:
            study = samples.surface_study(work, files=["a.csv"])
            text = study.read_text()
            elastomer = {"youngs_modulus": '"1 MPa"', "poisson_ratio": "0.5", "surface_energy": '"25 mJ/m2"'}
            if table == "analysis":
                text = text.replace("[analysis]\n", f"[analysis]\n{key} = {value}\n")
                if key == "bootstrap_resamples":
                    text = text.replace("bootstrap_resamples = 0\n", "")
            else:
                elastomer[key] = value
                text += f"[{table}]\n" + "".join(f"{k} = {v}\n" for k, v in elastomer.items())
            study.write_text(text)
            line = next(i for i, row in enumerate(text.splitlines(), 1) if row == f"{key} = {value}")
            outcome = refused(run(samples.program, "study", study, "--no-figures", cwd=work))
            require(outcome.says(key) and outcome.says(f"study.toml:{line}"), outcome, f"{key} = {value}: without its key or line")
            shutil.rmtree(work / "study_results", ignore_errors=True)
    for entry in ('size = ["1 um", "1 um", "1 um"]', 'size = ["-1 um", "1 um"]', 'tip_radius = "-1 nm"', 'resolution = "nan m"',
                  "channel = -1", 'tip_half_angle = "95 deg"', "numerical_aperture = -0.5", 'light_wavelength = "0 nm"'):
        study = samples.surface_study(work, files=["a.csv"])
        study.write_text(study.read_text().replace('instrument = "stylus" }', f'instrument = "stylus", {entry} }}'))
        refused(run(samples.program, "study", study, "--no-figures", cwd=work), entry.split()[0], "study.toml:")


def the_same_twice(samples, work, draw):
    """One file listed twice, or a copy of it, is no second measurement."""
    samples.profile(work, "a.csv")
    shutil.copy(work / "a.csv", work / "copy.csv")
    for files in (["a.csv", "a.csv"], ["a.csv", "copy.csv"], ["a.csv", "./a.csv"]):
        study = samples.surface_study(work, files=files)
        outcome = lawful(run(samples.program, "study", study, "--no-figures", "--json", cwd=work))
        require(any(a["code"] == "SAME_MEASUREMENT" for a in outcome.json()["surfaces"]["A"]["alerts"]), outcome,
                f"{files} without a word")


def odd_names(samples, work, draw):
    """File names with quotes, control bytes and bytes that are no UTF-8: shown harmlessly, kept where they are paths."""
    names = [b"\xff\xfe.csv", b"a\x1b[31mred.csv", b"new\nline.csv", b"quote'\".csv", b"=1+1.csv", "ünï cödé 測定.csv".encode(),
             b"%n%s.csv", b"-o.csv", b"`id`.csv", b"$(id).csv", b"\xe2\x80\xae.csv"]
    root = os.fsencode(str(work))
    samples.profile(work, "plain.csv")
    for name in names:
        shutil.copy(work / "plain.csv", os.path.join(root, name))
    for name in names:
        path = os.path.join(root, name)
        for words in (("info", path, "--json"), ("psd", path, "--json"), ("check", path), ("params", path), ("convert", path, work / "o.csv")):
            outcome = lawful(run(samples.program, *words, cwd=work), data="json" if "--json" in words else None)
            require(outcome.code == 0 or words[0] == "check", outcome, "a name costs a file")
    everything = [os.path.join(root, name) for name in names]
    done(run(samples.program, "info", *everything, "--json", cwd=work))
    folder = os.path.join(root, b"sub\xffdir")
    os.mkdir(folder)
    samples.profile(work / "s", "a.csv")
    study = samples.surface_study(work / "s", files=["a.csv"])
    for file in (study, work / "s" / "a.csv"):
        shutil.copy(file, os.path.join(folder, os.fsencode(file.name)))
    done(run(samples.program, "study", os.path.join(folder, b"study.toml"), "--no-figures", "--json", cwd=work))
    text = samples.profile(work, "latin.csv").read_bytes()
    (work / "latin.csv").write_bytes(b"# title: caf\xe9 \x1b]0;owned\x07\n" + text)
    lawful(run(samples.program, "info", "latin.csv", "--json", cwd=work), data="json")
    (work / "latin.csv").write_bytes(b"# title: caf\xe9\n" + text)
    study = samples.surface_study(work, files=["latin.csv", "plain.csv"])
    done(run(samples.program, "study", study, "--no-figures", "--json", cwd=work))


def environments(samples, work, draw):
    """The same bytes for any time zone, language, directory, user; a reason where the environment is broken."""
    study = samples.surface_study(work / "one", names=["A"]) if (work / "one").mkdir() is None else None
    shutil.copytree(work / "one", work / "two")
    base = {"SOURCE_DATE_EPOCH": "1700000000", "TMPDIR": None}
    reference = None
    for i, (folder, env) in enumerate([("one", {}), ("two", {"TZ": "Asia/Kathmandu", "LANG": "de_DE.UTF-8", "LC_ALL": "tr_TR.UTF-8"}),
                                       ("one", {"HOME": "/nonexistent", "USER": "nobody", "TERM": "dumb", "COLUMNS": "1"}),
                                       ("two", {"TMPDIR": "/nonexistent/tmp", "TZ": "EST5EDT"})]):
        shutil.rmtree(work / folder / "study_results", ignore_errors=True)
        outcome = done(run(samples.program, "study", "study.toml", cwd=work / folder, env={**base, **env}, seconds=120))
        results = digests(work / folder / "study_results")
        if reference is None:
            reference = results
        different = [n for n in set(results) | set(reference) if results.get(n) != reference.get(n)]
        require(not different, outcome, f"other bytes with {env}: {sorted(different)[:5]}")
    for epoch in ("99999999999999999999", "-1", "now", "1e9", " 5"):
        refused(run(samples.program, "study", "study.toml", cwd=work / "one", env={"SOURCE_DATE_EPOCH": epoch}), "SOURCE_DATE_EPOCH")
    done(run(samples.program, "psd", "scan_0_0.csv", "--threads", "64", cwd=work / "one"))
    for env in ({"SETAE_CACHE": "/dev/null/x"}, {"SETAE_CACHE": "/proc/nothing"}, {"HOME": None, "SETAE_CACHE": None}, {"PATH": "/nonexistent"}):
        lawful(run(samples.program, "study", "study.toml", "--no-figures", cwd=work / "one", env=env))
    if os.geteuid() == 0:
        os.chmod(work, 0o755)
    outcome = lawful(run(samples.program, "psd", "scan_0_0.csv", "--threads", "8", cwd=work / "one", processes=1))


def cache_entries(samples, work, draw):
    """Entries swapped, shuffled, cut, replaced by folders and pipes: computed again, the same results."""
    study = samples.surface_study(work, names=["A", "B"])
    env = {"SOURCE_DATE_EPOCH": "1700000000"}
    first = done(run(samples.program, "study", study, "--no-figures", cwd=work, env=env))
    cache = work / ".cache"

    def again(what):
        outcome = done(run(samples.program, "study", study, "--no-figures", cwd=work, env=env, seconds=20))
        require(outcome.out == first.out, outcome, f"other numbers from a cache with {what}")

    entries = sorted(cache.rglob("*.entry"))
    kept = {e: e.read_bytes() for e in entries}
    for e, other in zip(entries, entries[1:] + entries[:1]):
        e.write_bytes(kept[other])
    again("entries swapped")
    for e in entries:
        body = bytearray(kept[e])
        at = draw.randrange(len(body))
        body[at] ^= 0xff
        e.write_bytes(bytes(body))
    again("one byte changed")
    for e in entries:
        e.write_bytes(kept[e][:draw.randrange(len(kept[e]))])
    again("entries cut")
    for make in (lambda e: e.mkdir(), lambda e: os.mkfifo(e), lambda e: e.symlink_to("/dev/zero")):
        for e in entries:
            shutil.rmtree(e) if e.is_dir() and not e.is_symlink() else e.unlink(missing_ok=True)
            make(e)
        again("what is no file")
        outcome = lawful(run(samples.program, "cache", "show", "--cache", cache, "--json", cwd=work, seconds=20), data="json")
        require(b"18446744" not in outcome.out and b": -" not in outcome.out, outcome, "a negative size")
    mine = work / "mine" / "ab"
    mine.mkdir(parents=True)
    for name in ("notes.entry", "ab.entry.txt", "0" * 64 + ".entry"):
        (mine / name).write_text("precious\n")
    outcome = lawful(run(samples.program, "cache", "clear", "--cache", work / "mine", cwd=work))
    require(len(list(mine.iterdir())) == 3, outcome, "cache clear removes what it did not write")


def spreadsheet_cells(samples, work, draw):
    """Text that a spreadsheet would take for a formula."""
    names = ["=1+1", "+A", "-A", "@SUM(A1)", "=cmd|' /C calc'!A0"]
    study = samples.surface_study(work, names=names)
    outcome = done(run(samples.program, "study", study, "--no-figures", cwd=work))
    for table in (work / "study_results").glob("*.csv"):
        for row in table.read_text().splitlines()[1:]:
            for cell in re.split(r',(?=(?:[^"]*"[^"]*")*[^"]*$)', row):
                bare = cell.strip('"')
                formula = bare[:1] in "=+@" and bare or re.match(r"-(?![\d.]|inf|nan)", bare)
                require(not formula, outcome, f"{table.name} holds the cell {cell!r}")


def formulas_in_figures(samples, work, draw):
    """Names that are formulas, or end sections of XML, in every file of a study with all its outputs."""
    names = ["=1+1", " =1+1", "\u3000=1", "＝1+1", "@SUM(A1)", "a]]>b", "]]>", "<![CDATA[", "&amp;<script>"]
    study = samples.surface_study(work, names=names)
    done(run(samples.program, "study", study, cwd=work, seconds=120))
    results = work / "study_results"
    outcome = run(samples.program, "--version")
    for table in list(results.rglob("*.csv")):
        rows = csv.reader(line for line in table.read_text().splitlines() if not line.startswith("#"))
        cells = {cell for row in rows for cell in row if cell.lstrip(" \t\u00a0\u3000\u200b\ufeff")[:1] in tuple("=@＝＋－＠")}
        require(not cells, outcome, f"{table.name} holds the cells {sorted(cells)}")
    for picture in results.rglob("*.svg"):
        try:
            xml.dom.minidom.parse(str(picture))
        except xml.parsers.expat.ExpatError as failure:
            require(False, outcome, f"{picture.name} is no XML: {failure}")


def quantities_out_of_range(samples, work, draw):
    """Radii, energies and moduli that nothing has: refused with the line, or the study ends."""
    loops = [p for p in samples.loops if p.parent.name == "loops"][:4]
    for key, unit in (("sphere_radius", "m"), ("surface_energy", "J/m2"), ("youngs_modulus", "Pa")):
        for value in ("1e-300", "1e-30", "1e160", "1e30", "1e-12", "1e12"):
            study = samples.loop_study(work, loops, f'{key} = "{value} {unit}"\n')
            outcome = lawful(run(samples.program, "study", study, "--no-figures", "--json", cwd=work), data="json")
            require(outcome.code != 2 or outcome.says("study.toml:"), outcome, f"{key} of {value} {unit} is refused without the line")
            shutil.rmtree(work / "study_results", ignore_errors=True)


def silent_numbers(samples, work, draw):
    """What gives other numbers without a word: a size or seed below 0, a scan as its own reference, zero bytes in names, odd scales."""
    samples.profile(work, "a.csv")
    refused(run(samples.program, "psd", "a.csv", "--size", "-1 m", cwd=work), "above 0")
    for seed in ("-1", "18446744073709551616", "1.5"):
        refused(run(samples.program, "synthesize", "--seed", seed, "--hurst", "0.8", "-o", "x.nc", cwd=work), "whole number")
    study = samples.surface_study(work, files=["a.csv"])
    plain = study.read_text()
    study.write_text(plain.replace('instrument = "stylus" }', 'instrument = "stylus", references = ["a.csv"] }'))
    refused(run(samples.program, "study", study, "--no-figures", cwd=work), "study.toml:", "itself")
    study.write_text(plain.replace('[surfaces."A"]', '[surfaces."A\\u0000B"]'))
    refused(run(samples.program, "study", study, "--no-figures", cwd=work), "study.toml:", "zero byte")
    lines = (work / "a.csv").read_text().splitlines()
    for height in ("3.4028234663852886e38", "-9999", "1e200"):
        lines[100] = lines[100].split(",")[0] + "," + height
        (work / "spike.csv").write_text("\n".join(lines) + "\n")
        for keep in ("", ", keep_values = true") if height != "-9999" else ("",):  # which a user may call a height
            study.write_text(plain.replace("a.csv", "spike.csv").replace('"stylus" }', f'"stylus"{keep} }}'))
            outcome = lawful(run(samples.program, "study", study, "--no-figures", "--json", cwd=work), data="json")
            require(b'"NO_DATA"' in outcome.out or b'"HEIGHTS_IMPLAUSIBLE"' in outcome.out or outcome.says("spike.csv"), outcome,
                    f"a height of {height} nm{keep} without a word")
            shutil.rmtree(work / "study_results", ignore_errors=True)
    done(run(samples.program, "container", "write", "a.csv", "-o", "c.zip", cwd=work))
    for scale in (0, -5, 1e400):
        with zipfile.ZipFile(work / "c.zip") as old, zipfile.ZipFile(work / "scaled.zip", "w") as new:
            for name in old.namelist():
                content = old.read(name)
                if name in ("index.json", "meta.yml"):
                    content = re.sub(rb'"data_source": 0,?', b'"data_source": 0,"height_scale": %a,' % scale if name == "index.json"
                                     else b'"data_source": 0\n        "height_scale": %a' % scale, content)
                new.writestr(name, content)
        outcome = lawful(run(samples.program, "psd", "scaled.zip", "-o", "o.csv", cwd=work))
        require(outcome.code == 2, outcome, f"a height_scale of {scale} is applied")


def loops_twice(samples, work, draw):
    """One record on several elastomers, as it is and as another program writes it."""
    record = next(p for p in samples.loops if p.parent.name == "loops").read_text()
    names = ["a.csv", "b.csv", "c.csv"]
    for name, content in zip(names, (record, record.replace("\n", "\r\n"), record + "\n")):
        (work / name).write_bytes(content.encode())
    study = samples.loop_study(work, names)
    outcome = lawful(run(samples.program, "study", study, "--no-figures", "--json", cwd=work), data="json")
    require(any(a["code"] == "SAME_MEASUREMENT" for a in outcome.json()["alerts"]), outcome, "one record under three names without a word")


ATTACKS = [formulas_in_figures, quantities_out_of_range, silent_numbers, loops_twice, mutation, special_files, deep_text, impossible_numbers, the_same_twice, odd_names, environments, cache_entries,
           spreadsheet_cells]
