# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts that pages are checked with or made of, each one file of a package of npm, fetched once and known by its digest."""

import hashlib
import os
import subprocess
import tarfile
import tempfile

AXE = (
    "axe-core",
    "4.14.1",
    "axe.min.js",
    "1477dafa598d8d065f273d6af302aa203c02e83131707b7fa648cd41bd3d6b734f8c22a0dab86ee6a6f64b8afbe804b214d36db85a2826965edfb3a0b9d546b5",
)
# a worker of files that no server hands out: by it the site's search works in a folder
IFRAME_WORKER = (
    "iframe-worker",
    "1.0.4",
    "shim/index.js",
    "ae879a688f8b8352c935f8290a3a117bff96cc48f2f7e674f0ba04beef393023db063c26faa5f3f00839534e651dae95d42cac6721b313448e900b52500e6aed",
)


def fetched(package, version, folder):
    """Path of a package's archive, which npm puts into the folder; OSError without npm or network."""
    command = ["npm", "pack", f"{package}@{version}", "--pack-destination", folder, "--loglevel=error", "--ignore-scripts", "--prefer-offline",
               "--fetch-retries=1", "--fetch-retry-mintimeout=1000", "--fetch-timeout=30000"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if run.returncode:
        raise OSError(f"npm cannot fetch {package} {version}: {run.stderr.strip()}")
    return os.path.join(folder, f"{package}-{version}.tgz")


def script(package, folder):
    """Text of a package's script, which is kept in the folder; OSError without npm or network."""
    name, version, member, expected = package
    path = os.path.join(folder, f"{name}-{version}.js")
    if not os.path.exists(path):
        with tempfile.TemporaryDirectory() as scratch:
            archive = fetched(name, version, scratch)
            with open(archive, "rb") as file:
                digest = hashlib.sha512(file.read()).hexdigest()
            if digest != expected:
                raise SystemExit(f"{name} {version}: SHA-512 {digest}, expected {expected}")
            with tarfile.open(archive) as files:
                text = files.extractfile("package/" + member).read()
        os.makedirs(folder, exist_ok=True)
        with open(path + ".part", "wb") as file:
            file.write(text)
        os.replace(path + ".part", path)
    with open(path, encoding="utf-8") as file:
        return file.read()
