#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# made_page.sh SETAE VERB PAGE: the page is the one that the verb makes.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" "$2" --documentation "$work/page.md"
diff "$work/page.md" "$3" || { echo "differs from what the program says; make it again: setae $2 --documentation $3"; exit 1; }
