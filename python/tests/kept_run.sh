#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# kept_run.sh ARGUMENTS: runs the program, and keeps in $SETAE_KEPT what it was told and what it printed.
kept=$(mktemp "$SETAE_KEPT/XXXXXXXX")
printf '%s\n' "$@" >"$kept"
"$SETAE_PROGRAM" "$@" >"$kept.out"
status=$?
cat "$kept.out"
exit "$status"
