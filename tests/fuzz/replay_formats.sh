#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# replay_formats.sh PROGRAM CORPUS COPIES: the replay of fuzz_topography with the samples of each format.
set -eu
failed=0
for folder in "$2"/topography_*; do
  format=${folder##*/topography_}
  printf '%s: ' "$format"
  SETAE_FORMAT=$format "$1" "$folder" "$3" || { echo "$format failed"; failed=1; }
done
exit "$failed"
