#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# examples.sh SETAE: every command has examples in its help, and each is accepted: with --explain no example is run
set -euo pipefail
SETAE=$1
failed=0
checked=0
# lines "  NAME   description" before the options: a name is followed by two blanks
commands() { "$SETAE" help $1 | sed -n '/^Options:/q; s/^  \([a-z][a-z-]*\)  .*/\1/p'; }
check() {
  local lines
  lines=$("$SETAE" help $1 | sed -n '/^Examples:/,$p' | sed -n 's/^  setae //p')
  [ -n "$lines" ] || { echo "setae $1 has no example"; failed=1; return 0; }
  while read -r line; do
    # without the text after a pipe or an arrow
    eval "\"\$SETAE\" ${line%%[|>]*} --explain" > /dev/null || { echo "not accepted: setae $line"; failed=1; }
    checked=$((checked + 1))
  done <<< "$lines"
}
for command in $(commands ""); do
  below=$(commands "$command")
  # a group has no example of its own, but a command with subcommands has
  if [ -z "$below" ] || "$SETAE" help "$command" | grep -q '^Examples:'; then check "$command"; fi
  for second in $below; do check "$command $second"; done
done
[ "$checked" -gt 50 ] || { echo "$checked examples found; expected more than 50"; failed=1; }
exit $failed
