#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# examples.sh SETAE: every verb has examples in its help, and each is understood: with --explain nothing of it is run
set -euo pipefail
SETAE=$1
failed=0
verbs() { "$SETAE" help $1 | sed -n '/^Verbs:/,/^Options:/p' | sed -n 's/^  \([a-z-]*\) .*/\1/p'; }
check() {
  local lines
  lines=$("$SETAE" help $1 | sed -n '/^Examples:/,$p' | sed -n 's/^  setae //p')
  [ -n "$lines" ] || { echo "setae $1 has no example"; failed=1; return 0; }
  while read -r line; do
    # without what stands behind a pipe or an arrow
    eval "\"\$SETAE\" ${line%%[|>]*} --explain" > /dev/null || { echo "not understood: setae $line"; failed=1; }
  done <<< "$lines"
}
for verb in $(verbs ""); do
  below=$(verbs "$verb")
  # a group has no example of its own, but a verb with verbs below it has
  if [ -z "$below" ] || "$SETAE" help "$verb" | grep -q '^Examples:'; then check "$verb"; fi
  for second in $below; do check "$verb $second"; done
done
exit $failed
