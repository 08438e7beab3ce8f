#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# verb_page.sh SETAE PAGE: the page on verbs is the one the program makes from its table of commands.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" man --documentation "$work/page.md"
diff "$work/page.md" "$2" || { echo "differs from the table; make it again: setae man --documentation $2"; exit 1; }
