# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts that pages are checked with or made of, each one file of a package of npm, fetched once and known by its digest."""

import hashlib
import io
import os
import tarfile
import urllib.request

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


def script(package, folder):
    """Text of a package's script, which is kept in the folder; OSError without network."""
    name, version, member, expected = package
    path = os.path.join(folder, f"{name}-{version}.js")
    if not os.path.exists(path):
        url = f"https://registry.npmjs.org/{name}/-/{name}-{version}.tgz"
        with urllib.request.urlopen(url, timeout=30) as answer:
            archive = answer.read()
        digest = hashlib.sha512(archive).hexdigest()
        if digest != expected:
            raise SystemExit(f"{url}: SHA-512 {digest}, expected {expected}")
        with tarfile.open(fileobj=io.BytesIO(archive)) as files:
            text = files.extractfile("package/" + member).read()
        os.makedirs(folder, exist_ok=True)
        with open(path + ".part", "wb") as file:
            file.write(text)
        os.replace(path + ".part", path)
    with open(path, encoding="utf-8") as file:
        return file.read()
