#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# format_pages.sh SETAE FOLDER: the pages on formats are those the program makes from its table.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" formats --documentation "$work"
diff -r "$work" "$2" || { echo "differs from the table; make them again: setae formats --documentation docs/reference/formats"; exit 1; }
