#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# schema_pages.sh SETAE FOLDER: the pages on names and quantities of JSON are as the program makes them.
set -eu
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
"$1" schema --documentation "$made"
for page in json.md quantities.md; do diff "$made/$page" "$2/$page"; done
