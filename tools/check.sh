#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check.sh [REVISION|all]: layout of every source, spelling of every file, words of pages and of the program, order of modules by their
# includes, no address of a package registry, and clang-tidy on the sources that differ from REVISION (without one: that are not committed yet)
# or on all of them (an hour of processor time).
# `./setup check` installs what it needs.
set -uo pipefail
cd "$(dirname "$0")/.."
since=${1:-HEAD}
failed=0

mapfile -t sources < <(git ls-files '*.cpp' '*.hpp')
clang-format-16 --dry-run -Werror "${sources[@]}" || failed=1
git ls-files -z ':!docs/figures/*.svg' | xargs -0 codespell --quiet-level 3 --ignore-words tools/spelling.txt || failed=1
tools/words.py || failed=1
tools/include_graph.py order || failed=1
tests/package/registries.py || failed=1

if [ "$since" = all ]; then
  mapfile -t tidy < <(git ls-files 'src/*.cpp' 'lab/*.cpp' 'apps/*.cpp' ':!*/tests/*' ':!*/benchmarks/*')
else
  mapfile -t tidy < <(git diff --name-only --diff-filter=d "$since" -- 'src/*.cpp' 'lab/*.cpp' 'apps/*.cpp' ':!*/tests/*' ':!*/benchmarks/*')
fi
if [ ${#tidy[@]} -gt 0 ]; then
  # clang cannot read what g++ compiled of headers, and reads each source by itself
  cmake --preset release -B build-check -DSETAE_PRECOMPILED=OFF -DSETAE_TOGETHER=OFF -DSETAE_TESTS=OFF >/dev/null || exit 2
  printf '%s\n' "${tidy[@]}" | xargs -P "$(nproc)" -n 4 clang-tidy-16 -p build-check --quiet || failed=1
fi
printf 'check: %d sources laid out, %d read by clang-tidy: %s\n' "${#sources[@]}" "${#tidy[@]}" "$([ $failed = 0 ] && echo 'nothing found' || echo 'see above')"
exit $failed
