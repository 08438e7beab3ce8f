#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# kept_run.sh ARGUMENTS: runs the program and stores arguments and output in $SETAE_KEPT.
kept=$(mktemp "$SETAE_KEPT/XXXXXXXX")
printf '%s\n' "$@" >"$kept"
"$SETAE_PROGRAM" "$@" >"$kept.out"
status=$?
cat "$kept.out"
exit "$status"
