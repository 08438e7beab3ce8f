#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Containers written by setae, opened by SurfaceTopography: the same heights, and an index its schema accepts.

    python3 -m venv st-env && st-env/bin/pip install SurfaceTopography
    st-env/bin/python tests/peers/open_containers.py --setae build/bin/setae WRITTEN.zip…

For each measurement: the original as SurfaceTopography reads it (scaled, not levelled) against `setae convert`, and the processed copy
against that original levelled by setae's trend, which SurfaceTopography applies itself. Differences are the largest over all points,
relative to the rms height. An original whose format SurfaceTopography does not read counts as not compared. A profile's copy is opened
by itself: inside containers SurfaceTopography refuses its size, in those it writes itself too. The index is
validated by SurfaceTopography's pydantic schema, index.json and meta.yml alike, where the package has one (from 1.23). Prints a table in
Markdown; exit status 1 where a difference exceeds 1e-9 or the schema refuses.
"""
import argparse, io, json, pathlib, subprocess, sys, tempfile, warnings, zipfile

import numpy as np
import SurfaceTopography
import yaml
from SurfaceTopography import open_topography
from SurfaceTopography.Container.IO import CEReader
from scipy.io import netcdf_file

try:
    from SurfaceTopography.Container.IO.Schema import ContainerMeta
except ImportError:
    ContainerMeta = None

METRES = {"m": 1.0, "mm": 1e-3, "µm": 1e-6, "um": 1e-6, "nm": 1e-9, "Å": 1e-10, "A": 1e-10, "pm": 1e-12}


def metres(topography):
    heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=float), np.nan)
    return heights * METRES[topography.unit]


def by_setae(program, container, channel):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "h.nc"
        subprocess.run([program, "convert", container, path, "--channel", str(channel)], check=True, capture_output=True)
        with netcdf_file(path, mmap=False) as file:
            return np.array(file.variables["heights"][...], dtype=float)


def difference(ours, theirs):
    if ours.shape != theirs.shape:
        return f"shape {ours.shape} and {theirs.shape}"
    if (np.isnan(ours) != np.isnan(theirs)).any():
        return "undefined at other points"
    scale = np.nanstd(ours) or np.nanmax(np.abs(ours)) or 1.0  # of a flat line its height
    return float(np.nanmax(np.abs(ours - theirs)) / scale)


def read_all(container, **options):
    reader = CEReader(container, **options)
    for surface in range(reader.nb_containers):
        member = reader.container(surface)
        for index in range(len(member)):
            try:
                yield member[index]
            except Exception as error:  # whatever a reader of the package throws
                yield error


def opened_by_itself(container, copy, index):
    """The copy of a profile, which the package reads as a file but not through a container's index."""
    if not isinstance(copy, ValueError) or "nonuniform" not in str(copy):
        return copy
    with zipfile.ZipFile(container) as archive:
        surfaces = json.loads(archive.read("index.json"))["surfaces"]
        topographies = [topography for surface in surfaces for topography in surface["topographies"]]
        return open_topography(io.BytesIO(archive.read(topographies[index]["datafile"]["squeezed-netcdf"]))).topography()


def rows(program, container):
    originals = list(read_all(container, ignore_filters=True))
    levelled = list(read_all(container))
    copies = list(read_all(container, datafile_keys=["squeezed-netcdf", "original"]))
    for channel, (original, level, copy) in enumerate(zip(originals, levelled, copies)):
        copy = opened_by_itself(container, copy, channel)
        if isinstance(copy, Exception):
            yield channel, copy, copy
        elif isinstance(original, Exception):
            yield channel, f"not compared: {type(original).__name__}", f"opens, {copy.nb_grid_pts}"
        else:
            yield channel, difference(by_setae(program, container, channel), metres(original)), difference(metres(copy), metres(level))


def schema_errors(container):
    if ContainerMeta is None:
        return
    with zipfile.ZipFile(container) as archive:
        for name, load in ("index.json", lambda text: ContainerMeta.model_validate_json(text)), ("meta.yml", lambda text: ContainerMeta.model_validate(yaml.safe_load(io.BytesIO(text)))):
            try:
                load(archive.read(name))
            except Exception as error:
                yield f"{container}: {name}: {error}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--setae", required=True)
    parser.add_argument("containers", nargs="+")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    version = getattr(SurfaceTopography, "__version__", "")
    print(f"| container (SurfaceTopography {version}) | measurement | original, against setae's heights | processed copy, against the original levelled |")
    print("|---|---|---|---|")
    failed = False
    for container in arguments.containers:
        for message in schema_errors(container):
            failed = True
            print(message, file=sys.stderr)
        for channel, original, copy in rows(arguments.setae, container):
            for value in (original, copy):
                failed = failed or isinstance(value, Exception) or (isinstance(value, float) and not value < 1e-9)
            print(f"| {pathlib.Path(container).name} | {channel} | {original} | {copy} |")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
