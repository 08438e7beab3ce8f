#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# study_pages.sh SETAE FOLDER: the pages on keys, alerts and figures of studies are those the program makes from its tables, and
# every alert that a source says stands on its page, as no other does.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" study --documentation "$work" > /dev/null
for page in study-keys.md alerts.md figures.md; do
  diff "$work/$page" "$2/$page" || { echo "differs from the table; make it again: setae study --documentation $2"; exit 1; }
done
sources=$(find src apps -name '*.cpp' -not -path '*/tests/*' -not -name alert_kinds.cpp)
# an alert is the first text between braces or after the function that adds one; words of files look like it, and are left out below
said=$(cat $sources | tr '\n' ' ' |
  grep -oE '(alerts?_?\.(push_back|emplace_back)\( *\{|few\.push_back\( *\{|Finding\{ *\{|add_alert\([a-z_.]+, *|alert\( *([a-z]+, *)?|list\.add\( *|return \{ *\{? *|\? *|: *|\{\{) *"[A-Z_]{4,}" *[,:]' |
  grep -oE '"[A-Z_]+"' | tr -d '"' | grep -vx GWYP | sort -u)
known=$(grep -oE '^### [A-Z_]+$' "$2/alerts.md" | tr -d '# ' | sort)
[ -z "$(uniq -d <<< "$known")" ] || { echo "twice on the page: $(uniq -d <<< "$known")"; exit 1; }
missing=0
for code in $known; do
  grep -q "\"$code\"" $sources || { echo "$code stands on the page, and no source says it"; missing=1; }
done
for code in $said; do
  grep -qx "$code" <<< "$known" || { echo "$code is said, and does not stand on the page"; missing=1; }
done
exit $missing
