#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# replay_texts.sh PROGRAM CORPUS COPIES: the replay of fuzz_text with the samples of each kind of text.
set -eu
failed=0
for folder in "$2"/text_*; do
  kind=${folder##*/text_}
  printf '%s: ' "$kind"
  SETAE_TEXT=$kind "$1" "$folder" "$3" || { echo "$kind failed"; failed=1; }
done
exit "$failed"
