#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# screen.sh SETAE PAGE: the screen that a page shows is the one the program prints.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" study examples/nanodiamond/published.toml --output "$work/out" --no-figures --no-cache --progress none | sed '/^Results: /,$d' >"$work/printed"
sed -n '/^```text$/,/^```$/p' "$2" | sed '1d;$d' >"$work/shown"
diff "$work/shown" "$work/printed" || { echo "differs from what is printed; copy it into $2"; exit 1; }
[ "$(wc -l <"$work/printed")" -le 38 ]
