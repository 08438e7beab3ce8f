#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# made_pages.sh SETAE COMMAND FOLDER: the pages of the folder are those that the command writes.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" "$2" --documentation "$work" > /dev/null
diff -r "$work" "$3" || { echo "the pages differ from the program; write them anew: setae $2 --documentation $3"; exit 1; }
