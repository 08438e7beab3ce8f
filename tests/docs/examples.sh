#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# examples.sh SETAE: every command has examples in its help, and each is understood: with --explain nothing of it is run
set -euo pipefail
SETAE=$1
failed=0
checked=0
while read -r command; do
  help=$("$SETAE" help $command)
  lines=$(sed -n '/^Examples:/,/^[A-Z][a-z ]*:$/p' <<< "$help" | sed -n 's/^  setae //p')
  if [ -z "$lines" ]; then
    # a group of commands has no example
    grep -q '^Usage: .* COMMAND' <<< "$help" || { echo "setae $command has no example"; failed=1; }
    continue
  fi
  while read -r line; do
    # without what stands behind a pipe or an arrow
    eval "\"\$SETAE\" ${line%%[|>]*} --explain" > /dev/null || { echo "not understood: setae $line"; failed=1; }
    checked=$((checked + 1))
  done <<< "$lines"
done < <("$SETAE" man | sed -n 's/^\.SS setae \([a-z ]*[a-z]\).*/\1/p')
[ "$checked" -gt 0 ] || { echo "no example is checked"; failed=1; }
exit $failed
