#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `setae convert` writes, opened by the field's own packages: the same heights, sizes, undefined points, the same way round.

    python3 -m venv peers-env && peers-env/bin/pip install SurfaceTopography gwyfile surfalize
    peers-env/bin/python tests/peers/open_what_we_write.py --setae build/bin/setae

A map of 7 × 5 points with an undefined one, no two heights alike and unequal pixels, and a line of 7, are written in every format, and
each of these files into a container; so is a contour with standard errors. A
package that is not installed is left out. Prints a table in Markdown; exit status 1 where a package that reads a format disagrees,
77 (skipped) where no package is installed.
"""
import argparse, importlib, os, pathlib, subprocess, sys, tempfile, warnings

sys.path = [entry for entry in sys.path if pathlib.Path(entry or ".").resolve() != pathlib.Path(__file__).resolve().parent]
SKIPPED = 77
try:
    import numpy as np
except ImportError:
    print("skipped: no numpy")
    sys.exit(SKIPPED)

MAP_SIZE, LINE_SIZE = (7.7e-6, 4e-6), (2.1e-5,)  # m
ENDINGS = ("x3p", "sdf", "gwy", "nc", "npy", "txt", "csv")
#: what a package cannot be asked, though setae writes it
UNREAD = {
    ("SurfaceTopography", "x3p", "line"): "reads only surfaces",
    ("SurfaceTopography", "csv", "map"): "reads only matrices without commas",
    ("surfalize", "x3p", "line"): "reads only surfaces",
}


def test_map():
    i, j = np.meshgrid(np.arange(7), np.arange(5), indexing="ij")
    heights = 1e-9 * (1 + 3 * i + 100 * j + (7 * i + 13 * j) % 11) / 3
    heights[5, 1] = np.nan
    return heights


def test_line():
    return test_map()[:, 3]


def plain(heights):
    return np.ma.filled(np.ma.asarray(heights, dtype=float), np.nan)


def by_surface_topography(path, kind, package):
    reader = package.open_topography(str(path))
    given = {}
    if path.suffix in (".npy", ".csv") and kind == "map":
        given = {"physical_sizes": MAP_SIZE, "unit": "m"}
    elif path.suffix == ".npy":
        given = {"physical_sizes": LINE_SIZE, "unit": "m"}
    elif path.suffix in (".csv", ".txt") and kind == "line":
        given = {"unit": "m"}
    topography = reader.topography(**given)
    topography = topography.to_unit("m")
    size = np.array(topography.physical_sizes)
    return plain(topography.heights()), size


def by_gwyfile(path, kind, package):
    field = next(iter(package.util.get_datafields(package.load(str(path))).values()))
    heights = field.data.T.copy()
    container = package.load(str(path))
    if "/0/mask" in container:
        heights[container["/0/mask"].data.T > 0.5] = np.nan
    return heights, np.array([field.xreal, field.yreal])


def by_surfalize(path, kind, package):
    surface = package.Surface.load(str(path))
    heights = surface.data.T.copy() * 1e-6
    return heights, np.array([surface.step_x * heights.shape[0], surface.step_y * heights.shape[1]]) * 1e-6


def by_container(path, kind, package):
    """What `setae container write` put in, as the package's own reader of containers gives it."""
    from SurfaceTopography.Container.IO import CEReader

    topography = CEReader(str(path), ignore_filters=True).container(0)[0].to_unit("m")
    return plain(topography.heights()), np.array(topography.physical_sizes)


def contained(setae, path, kind):
    """A container of a written file."""
    size = " x ".join(f"{length!r} m" for length in (MAP_SIZE if kind == "map" else LINE_SIZE))
    target = path.with_name(f"container_of_{path.name}.zip")
    subprocess.run([setae, "container", "write", str(path), "-o", str(target), "--size", size, "--unit", "m"], check=True, capture_output=True)
    return target


PEERS = {
    "SurfaceTopography": (by_surface_topography, ENDINGS),
    "gwyfile": (by_gwyfile, ("gwy",)),
    "surfalize": (by_surfalize, ("x3p", "sdf")),
}


def compare(heights, size, expected, expected_size):
    if heights.ndim == 2 and expected.ndim == 1 and heights.shape[1] == 1:  # a line that is a map of one row
        heights, size = heights[:, 0], size[:1]
    if heights.shape != expected.shape:
        return False, f"shape {heights.shape}"
    if not np.array_equal(np.isnan(heights), np.isnan(expected)):
        return False, f"{np.isnan(heights).sum()} undefined, expected {np.isnan(expected).sum()}"
    height = np.nanmax(np.abs(heights / expected - 1))
    extent = np.max(np.abs(size / np.array(expected_size) - 1))
    told = f"heights within {height:.1e}, sizes within {extent:.1e}"
    return height < 1e-14 and extent < 1e-14, told


EXPECTED = {"map": (test_map(), MAP_SIZE), "line": (test_line(), LINE_SIZE), "contour": (np.array([1e-9, 3e-9, 2e-9]), (7e-9,))}
CONTOUR = "# format: setae profile\n# version: 1\nx [m],h [m],standard_error [m]\n0,1e-9,1e-11\n2e-9,3e-9,1e-11\n7e-9,2e-9,1e-11\n"


def judged(label, open_by, path, kind, package):
    """Whether a package reads a file as it was meant; prints its row of the table."""
    try:
        same, told = compare(*open_by(path, kind, package), *EXPECTED[kind])
    except Exception as error:  # whatever the package throws is its answer
        same, told = False, f"{type(error).__name__}: {str(error)[:80]}"
    print(f"{label} | {'same' if same else 'DIFFERS'}: {told} |")
    return same


def write(setae, folder, kind, ending):
    """The path written, or what setae says instead."""
    source, size = folder / f"{kind}.npy", " x ".join(f"{length!r} m" for length in (MAP_SIZE if kind == "map" else LINE_SIZE))
    np.save(source, test_map() if kind == "map" else test_line())
    target = folder / f"written_{kind}.{ending}"
    run = subprocess.run([setae, "convert", str(source), str(target), "--size", size, "--unit", "m"], capture_output=True, text=True)
    return (target, None) if run.returncode == 0 else (None, run.stderr.strip())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--setae", required=True, help="the program")
    setae = os.path.abspath(parser.parse_args().setae)
    warnings.simplefilter("ignore")
    packages = {}
    for name in PEERS:
        try:
            packages[name] = importlib.import_module(name)
        except ImportError:
            print(f"{name}: not installed, left out", file=sys.stderr)
    if not packages:
        print("skipped: none of " + ", ".join(PEERS))
        return SKIPPED
    failed = False
    print("| format | written | opened by | result |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for ending in ENDINGS:
            for kind in ("map", "line"):
                path, refusal = write(setae, folder, kind, ending)
                if path is None:
                    failed = failed or not (ending == "gwy" and kind == "line")
                    print(f"| .{ending} | {kind} | | refused: {refusal.split(': ')[-1]} |")
                    continue
                for peer, package in packages.items():
                    open_by, endings = PEERS[peer]
                    if ending not in endings:
                        continue
                    label = f"| .{ending} | {kind} | {peer} {getattr(package, '__version__', '')}"
                    if (peer, ending, kind) in UNREAD:
                        print(f"{label} | {UNREAD[peer, ending, kind]} |")
                    else:
                        failed = not judged(label, open_by, path, kind, package) or failed
                if package := packages.get("SurfaceTopography"):
                    label = f"| container of .{ending} | {kind} | SurfaceTopography {package.__version__}"
                    failed = not judged(label, by_container, contained(setae, path, kind), kind, package) or failed
        if package := packages.get("SurfaceTopography"):
            path = folder / "contour.csv"
            path.write_text(CONTOUR)
            told = f"| container of a contour with errors | profile | SurfaceTopography {package.__version__}"
            container = folder / "contour.zip"
            subprocess.run([setae, "container", "write", str(path), "-o", str(container)], check=True, capture_output=True)
            failed = not judged(told, by_container, container, "contour", package) or failed
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
