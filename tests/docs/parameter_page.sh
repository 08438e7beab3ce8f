#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# parameter_page.sh SETAE PAGE: the page on parameters is the one the program makes from its table.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$2" "$work/page.md"
"$1" params --documentation "$work/page.md"
diff "$work/page.md" "$2" || { echo "differs from the table; make it again: setae params --documentation docs/reference/parameters.md"; exit 1; }
