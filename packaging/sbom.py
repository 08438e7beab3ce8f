#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""sbom.py WHEEL: what a wheel holds beside setae, with versions and licences, as SPDX 2.3 in JSON.

Libraries beside the extension are those that auditwheel put there and named; what is linked in is named by licences.toml.
"""

from __future__ import annotations

import json
import pathlib
import re
import subprocess
import sys
import tomllib
import urllib.parse
import zipfile

HERE = pathlib.Path(__file__).resolve().parent


def version_of(package: str) -> str:
    shown = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True)
    return shown.stdout or "NOASSERTION"


def owner_of(library: str) -> str:
    """Debian's package of a library whose name auditwheel made its own: "libbz2-e4f501c8.so.1.0.4"."""
    name = re.sub(r"-[0-9a-f]{8}(?=\.so)", "", library)
    shown = subprocess.run(["dpkg-query", "-S", f"*/{name}"], capture_output=True, text=True).stdout
    if not shown:  # alternatives are nobody's: the package is called as the library
        return re.sub(r"\.so\.(\d+).*", r"\1", name)
    return shown.split(":")[0]


def bundled(wheel: zipfile.ZipFile) -> dict[str, str]:
    """Version of each package whose libraries the wheel holds."""
    (listed,) = (name for name in wheel.namelist() if name.endswith("auditwheel.cdx.json"))
    found = {}
    for component in json.loads(wheel.read(listed))["components"]:
        kind, _, rest = component["purl"].partition("/")
        if kind == "pkg:deb":
            name, _, version = rest.partition("/")[2].partition("@")
            found[name] = urllib.parse.unquote(version.split("?")[0])
    for library in (pathlib.PurePath(name).name for name in wheel.namelist() if ".libs/" in name and ".so" in name):
        owner = owner_of(library)
        found.setdefault(owner, version_of(owner))
    return found


def package(name: str, version: str, licence: str) -> dict[str, object]:
    identifier = "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)
    return {"SPDXID": identifier, "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION"}


def document(path: pathlib.Path) -> dict[str, object]:
    """@raises KeyError: for a library whose licence licences.toml does not say."""
    licences = tomllib.loads((HERE / "licences.toml").read_text())
    with zipfile.ZipFile(path) as wheel:
        libraries = bundled(wheel)
        made = max(entry.date_time for entry in wheel.infolist())
    own = package("setae", path.name.split("-")[1], "GPL-3.0-or-later")
    others = [package(name, version, licences["libraries"][name]) for name, version in sorted(libraries.items())]
    others += [package(name, version_of(name), licence) for name, licence in licences["linked"].items()]
    others.append(package("nanobind", "NOASSERTION", "BSD-3-Clause"))
    year, month, day, hour, minute, second = made
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": path.name,
        "documentNamespace": f"urn:setae:{path.name}",
        "creationInfo": {"created": f"{year}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z", "creators": ["Tool: packaging/sbom.py"]},
        "hasExtractedLicensingInfos": [{"licenseId": "LicenseRef-public-domain", "extractedText": "The work is in the public domain."}],
        "packages": [own, *others],
        "relationships": [
            {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": own["SPDXID"]},
            *({"spdxElementId": own["SPDXID"], "relationshipType": "CONTAINS", "relatedSpdxElement": other["SPDXID"]} for other in others),
        ],
    }


if __name__ == "__main__":
    print(json.dumps(document(pathlib.Path(sys.argv[1])), indent=2))
