#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# processing_page.sh SETAE PAGE: the page on steps is the one the program makes from its table.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" level --documentation "$work/page.md"
diff "$work/page.md" "$2" || { echo "differs from the table; make it again: setae level --documentation $2"; exit 1; }
