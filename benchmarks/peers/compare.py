#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""setae beside SurfaceTopography: the same bytes in, the same run, one core and two.

    ./setup peers                  installs the package in an environment of its own, builds, and runs

or by hand, with a Python that has SurfaceTopography:

    python benchmarks/peers/compare.py --program build-bench/bin/peer_tasks --write docs/development/performance.md [--only TASK,...] [--sweep 16384]

Every measurement is a process of its own, bound to one core or two; time is the best of several runs, memory what the process
holds at most beside its input. The tables replace what stands between the lines "<!-- NAME: begin -->" and "<!-- NAME: end -->".
"""
import argparse
import datetime
import importlib.metadata
import json
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

CORES = {1: {0}, 2: {0, 1}}


# ---- input, made once and read by both ----------------------------------------------------------------------------------------

def self_affine(points, hurst=0.8, rolloff=4, seed=1):
    """Heights of a self-affine map of 1 m x 1 m, rms slope 0.1."""
    rng = np.random.default_rng(seed)
    q = np.hypot(np.fft.fftfreq(points, 1 / points)[:, None], np.fft.rfftfreq(points, 1 / points)[None, :])
    amplitude = np.where(q > 0, np.maximum(q, rolloff), 1.0) ** (-1 - hurst)
    amplitude[0, 0] = 0
    heights = np.fft.irfft2(amplitude * np.fft.rfft2(rng.standard_normal((points, points))), s=(points, points))
    return heights * (0.1 / (np.sqrt(np.mean(np.diff(heights, axis=0) ** 2)) * points))


def map_of(points):
    return lambda: self_affine(points)


def polyline():
    rng = np.random.default_rng(2)
    x = np.sort(rng.uniform(0, 1, 3000))
    return np.stack([x, np.cumsum(rng.standard_normal(3000)) * 1e-4])


def one_hole():
    """A disc of 10^5 pixels in 1024 x 1024."""
    heights = self_affine(1024)
    x, y = np.ogrid[:1024, :1024]
    heights[(x - 512) ** 2 + (y - 512) ** 2 < 1e5 / np.pi] = np.nan
    return heights


def small_holes():
    """2000 squares of 4 x 4 pixels in 1024 x 1024."""
    heights = self_affine(1024)
    for i, j in np.random.default_rng(3).integers(2, 1018, (2000, 2)):
        heights[i:i + 4, j:j + 4] = np.nan
    return heights


# ---- what the package does ----------------------------------------------------------------------------------------------------

def topography(heights):
    import SurfaceTopography
    return SurfaceTopography.Topography(np.ma.masked_invalid(heights) if np.isnan(heights).any() else heights, (1.0, 1.0), unit="m")


def peer_polyline(columns):
    import SurfaceTopography
    return SurfaceTopography.NonuniformLineScan(columns[0], columns[1], unit="m")


def numbers(values):
    return [float(v) for v in np.ravel(values)]


def peer_rms(heights):
    t = topography(heights)
    return numbers([t.rms_height_from_area(), t.rms_gradient(), t.rms_laplacian()])


def peer_bearing(heights):
    levels = np.linspace(heights.min(), heights.max(), 101)
    return numbers(topography(heights).bearing_area()(levels))


def nothing(_):
    return []


def variance_of_gradient(derivative_x, derivative_y):
    return np.mean(derivative_x ** 2 + derivative_y ** 2)


PEER = {
    "psd_area": lambda h: nothing(topography(h).power_spectrum_from_area()),
    "psd_lines": lambda h: nothing(topography(h).power_spectrum_from_profile()),
    "acf_area": lambda h: nothing(topography(h).autocorrelation_from_area()),
    "acf_lines": lambda h: numbers(topography(h - h.mean()).autocorrelation_from_profile(resampling_method=None, reliable=False)[1][1:101]),
    "variable_bandwidth": lambda h: numbers(topography(h).variable_bandwidth_from_area(reliable=False)[1][::-1]),
    "slope_of_lines": lambda h: nothing(topography(h).scale_dependent_slope_from_profile()),
    "differences_of_map": lambda h: nothing(topography(h).scale_dependent_statistical_property(variance_of_gradient)),
    "tip_cutoff": lambda h: numbers(topography(h).scanning_probe_reliability_cutoff(1e-3)),
    "bearing_area": peer_bearing,
    "rms": peer_rms,
    "polyline_psd": lambda columns: nothing(peer_polyline(columns).power_spectrum_from_profile()),
    "fill": lambda h: numbers(topography(h).interpolate_undefined_data().heights()[512]),
}

# name in the table, task, input, file it is kept in, yardstick
CASES = [
    ("C_iso of 4096², window and radial bins", "psd_area", map_of(4096), "map4096", "transform"),
    ("C1D of the lines of 4096²", "psd_lines", map_of(4096), "map4096", "read"),
    ("autocorrelation of the area, 4096²", "acf_area", map_of(4096), "map4096", "transform"),
    ("autocorrelation of the lines of 4096²", "acf_lines", map_of(4096), "map4096", "read"),
    ("variable bandwidth of the area, 4096²", "variable_bandwidth", map_of(4096), "map4096", "read"),
    ("scale-dependent slope of the lines of 2048²", "slope_of_lines", map_of(2048), "map2048", "read"),
    ("scale-dependent statistics of 2048² on the default grid", "differences_of_map", map_of(2048), "map2048", "read"),
    ("tip cutoff of 2048²", "tip_cutoff", map_of(2048), "map2048", "read"),
    ("bearing area of 2048² at 101 heights", "bearing_area", map_of(2048), "map2048", "read"),
    ("rms height, gradient and curvature of 4096²", "rms", map_of(4096), "map4096", "read"),
    ("spectrum of a polyline of 3000 random points at 2000 wavevectors", "polyline_psd", polyline, "polyline", None),
    ("one hole of 10⁵ pixels filled in 1024²", "fill", one_hole, "one_hole", "copy"),
    ("2000 holes of 4 × 4 pixels filled in 1024²", "fill", small_holes, "small_holes", "copy"),
]
# beside Gwyddion: name in the table, task, input, file, points a side
GWYDDION = [
    ("C1D of the lines of 4096²", "psd_lines", map_of(4096), "map4096", 4096),
    ("radial spectrum of 4096²", "psd_area", map_of(4096), "map4096", 4096),
    ("autocorrelation of the lines of 4096²", "acf_lines", map_of(4096), "map4096", 4096),
    ("autocorrelation of the area, 4096²", "acf_area", map_of(4096), "map4096", 4096),
    ("mean, rms, skewness of 4096² heights", "moments", map_of(4096), "map4096", 4096),
    ("area of the surface, 4096²", "true_area", map_of(4096), "map4096", 4096),
    ("cubic background of 4096² subtracted", "background", map_of(4096), "map4096", 4096),
    ("Gaussian filter of 20 pixels, 4096²", "gaussian", map_of(4096), "map4096", 4096),
    ("one hole of 10⁵ pixels filled in 1024²", "fill", one_hole, "one_hole", 1024),
    ("dilation of 1024² by a tip of 41²", "dilation", map_of(1024), "map1024", 1024),
]
SWEPT = ["psd_area", "psd_lines", "acf_area", "acf_lines", "variable_bandwidth", "slope_of_lines", "differences_of_map", "tip_cutoff", "bearing_area", "rms"]


# ---- measuring ----------------------------------------------------------------------------------------------------------------

def on_cores(count):
    return lambda: os.sched_setaffinity(0, CORES[count])


def run_json(command, cores):
    environment = dict(os.environ, OMP_NUM_THREADS=str(cores), OPENBLAS_NUM_THREADS=str(cores))
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=on_cores(cores), env=environment)
    if done.returncode:
        sys.exit(f"{' '.join(command)}: {done.stderr[-2000:]}")
    return json.loads(done.stdout.splitlines()[-1])


def held_memory():
    with open("/proc/self/status") as status:
        return {line.split(":")[0]: 1024.0 * float(line.split()[1]) for line in status if line.startswith(("VmRSS", "VmHWM"))}


def peer_process(task, path):
    """One task of the package in this process: the best of as many runs as fit into five seconds, at least one."""
    values = np.load(path)
    best, memory, begin = np.inf, 0.0, time.perf_counter()
    topography(self_affine(16))  # imports are not timed
    while best == np.inf or time.perf_counter() - begin < 5.0:
        with open("/proc/self/clear_refs", "w") as peak:
            peak.write("5")
        before = held_memory()["VmRSS"]
        start = time.perf_counter()
        found = PEER[task](values)
        seconds = time.perf_counter() - start
        if best == np.inf:
            memory = held_memory()["VmHWM"] - before
        best = min(best, seconds)
    print(json.dumps({"seconds": best, "memory": memory, "values": found}))


def measured(program, folder, case):
    title, task, make, kept, yardstick = case
    path = kept_input(folder, make, kept)
    option = "--polyline" if kept == "polyline" else "--input"
    row = {"title": title}
    for cores in CORES:
        row[f"ours{cores}"] = run_json([program, task, option, path, "--threads", str(cores), "--repeat", "7"], cores)
        row[f"peer{cores}"] = run_json([sys.executable, __file__, "--peer", task, "--input", path], cores)
    if yardstick:
        row["yardstick"] = run_json([program, yardstick, option, path, "--repeat", "7"], 1)
    print(title, {key: value["seconds"] for key, value in row.items() if key != "title"}, flush=True)
    return row


def kept_input(folder, make, kept):
    path = os.path.join(folder, kept + ".npy")
    if not os.path.exists(path):
        np.save(path, make())
    return path


def beside_gwyddion(program, gwyddion, folder, case):
    title, task, make, kept, points = case
    path = kept_input(folder, make, kept)
    row = {"title": title}
    for cores in CORES:
        row[f"ours{cores}"] = run_json([program, task, "--input", path, "--threads", str(cores), "--repeat", "7"], cores)
        row[f"peer{cores}"] = run_json([gwyddion, task, path, str(points), "3"], cores)
    print(title, {key: value["seconds"] for key, value in row.items() if key != "title"}, flush=True)
    return row


# ---- tables -------------------------------------------------------------------------------------------------------------------

def seconds(value):
    return f"{value:.3g} s" if value >= 0.9995 else f"{1e3 * value:.2g} ms" if value < 0.01 else f"{1e3 * value:.0f} ms"


def megabytes(value):
    return f"{value / 1e6:.0f} MB" if value < 9.995e8 else f"{value / 1e9:.2g} GB"


def difference(row):
    ours, peer = np.array(row["ours1"]["values"]), np.array(row["peer1"]["values"])
    if ours.size == 0 or ours.size != peer.size:
        return "—"
    return f"{np.max(np.abs(ours - peer)) / np.max(np.abs(peer)):.0e}"


def comparison_table(rows):
    lines = ["| task | setae, 1 core | 2 cores | memory | SurfaceTopography, 1 core | 2 cores | memory | times faster on 2 cores | largest difference | yardstick of the run, 1 core |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for row in rows:
        yardstick = f"{row['yardstick']['title']}: {seconds(row['yardstick']['seconds'])}" if "yardstick" in row else ""
        ratio = row["peer2"]["seconds"] / row["ours2"]["seconds"]
        cells = [row["title"], seconds(row["ours1"]["seconds"]), seconds(row["ours2"]["seconds"]), megabytes(row["ours2"]["memory"]),
                 seconds(row["peer1"]["seconds"]), seconds(row["peer2"]["seconds"]), megabytes(row["peer2"]["memory"]), f"{ratio:.2g}" if ratio < 100 else f"{ratio:.0f}",
                 difference(row), yardstick]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def gwyddion_table(rows):
    lines = ["| task | setae, 1 core | 2 cores | Gwyddion, 1 core | 2 cores | times faster on 1 core | on 2 cores |", "|---|---|---|---|---|---|---|"]
    for row in rows:
        times = [row[key]["seconds"] for key in ("ours1", "ours2", "peer1", "peer2")]
        ratios = [f"{times[2] / times[0]:.2g}", f"{times[3] / times[1]:.2g}"]
        lines.append("| " + " | ".join([row["title"], *map(seconds, times), *ratios]) + " |")
    return lines


def sweep_table(program, largest):
    sizes = [points for points in (1024, 2048, 4096, 8192, 16384) if points <= largest]
    lines = ["| task | " + " | ".join(f"{points}²" for points in sizes) + " | ns a point, first and last | memory at the largest |", "|---|" + "---|" * (len(sizes) + 2)]
    for task in SWEPT:
        found = [run_json([program, task, "--points", str(points), "--threads", "2", "--repeat", "3" if points < 8192 else "1"], 2) for points in sizes]
        per_point = [1e9 * f["seconds"] / points ** 2 for f, points in zip(found, sizes)]
        print(task, per_point, flush=True)
        lines.append(f"| {found[0]['title']} | " + " | ".join(seconds(f["seconds"]) for f in found) +
                     f" | {per_point[0]:.3g}, {per_point[-1]:.3g} | {megabytes(found[-1]['memory'])} |")
    return lines


def processor():
    with open("/proc/cpuinfo") as info:
        return next((line.split(":")[1].strip() for line in info if line.startswith("model name")), platform.machine())


def replace_section(text, name, lines):
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    if begin not in text or end not in text:
        sys.exit(f"the page has no lines '{begin.strip()}' and '{end}'")
    head, rest = text.split(begin, 1)
    return head + begin + "\n".join(lines) + "\n" + end + rest.split(end, 1)[1]


def write(path, sections):
    with open(path, encoding="utf-8") as page:
        text = page.read()
    for name, lines in sections.items():
        text = replace_section(text, name, lines)
    with open(path + ".part", "w", encoding="utf-8") as page:
        page.write(text)
    os.replace(path + ".part", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build-bench/bin/peer_tasks")
    parser.add_argument("--gwyddion", help="program made of gwyddion.c; its table is written too")
    parser.add_argument("--only-gwyddion", action="store_true", help="no other table")
    parser.add_argument("--write", help="page whose tables are replaced")
    parser.add_argument("--only", help="tasks, separated by commas; nothing is written then")
    parser.add_argument("--sweep", type=int, default=16384, help="largest map of the sweep over sizes, 0 for none")
    parser.add_argument("--peer", help=argparse.SUPPRESS)
    parser.add_argument("--input", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.peer:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        return peer_process(arguments.peer, arguments.input)
    wanted = arguments.only.split(",") if arguments.only else None
    if len(os.sched_getaffinity(0)) < 2:
        sys.exit("two cores are needed")
    sections = {}
    if arguments.gwyddion:
        with tempfile.TemporaryDirectory() as folder:
            rows = [beside_gwyddion(arguments.program, arguments.gwyddion, folder, case) for case in GWYDDION if not wanted or case[1] in wanted]
        version = subprocess.run(["pkg-config", "--modversion", "gwyddion"], capture_output=True, text=True).stdout.strip()
        sections["gwyddion"] = [f"Measured on {datetime.date.today()} with `./setup peers` on two cores ({processor()}), Gwyddion {version}.", "", *gwyddion_table(rows)]
        print("\n".join(sections["gwyddion"]))
        if arguments.only_gwyddion:
            if arguments.write and not wanted:
                write(arguments.write, sections)
            return
    with tempfile.TemporaryDirectory() as folder:
        rows = [measured(arguments.program, folder, case) for case in CASES if not wanted or case[1] in wanted]
    stamp = (f"Measured on {datetime.date.today()} with `./setup peers` on two cores ({processor()}), NumPy {np.__version__}, "
             f"SurfaceTopography {importlib.metadata.version('SurfaceTopography')}.")
    sections["peers"] = [stamp, "", *comparison_table(rows)]
    print("\n".join(sections["peers"]))
    if arguments.sweep and not wanted:
        sections["sweep"] = sweep_table(arguments.program, arguments.sweep)
        print("\n".join(sections["sweep"]))
    if arguments.write and not wanted:
        write(arguments.write, sections)


if __name__ == "__main__":
    main()
