#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# pre_commit.sh: checks what a commit would take, in a copy of the index: the layout of the changed C++ sources, the spelling of the changed files,
# and the order of modules by their includes where a source changed. `./setup hooks` installs it; `git commit --no-verify` leaves it out.
set -uo pipefail
cd "$(git rev-parse --show-toplevel)" || exit 2
for tool in clang-format-16 codespell python3; do
  command -v "$tool" >/dev/null || { echo "pre-commit: $tool is not found; ./setup hooks installs it" >&2; exit 1; }
done

mapfile -d '' -t changed < <(git diff --cached --name-only --diff-filter=ACMR -z)
[ ${#changed[@]} -gt 0 ] || exit 0
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
printf '%s\0' "${changed[@]}" .clang-format tools/spelling.txt | git checkout-index -z --stdin --prefix="$copy/" || exit 2

sources=() texts=() modules=no
for file in "${changed[@]}"; do
  [ ! -L "$copy/$file" ] || continue
  texts+=("$file")
  case "$file" in *.cpp | *.hpp) sources+=("$file") ;; esac
  case "$file" in src/*.[ch]pp | lab/*.[ch]pp | apps/*.[ch]pp | src/CMakeLists.txt) modules=yes ;; esac
done

failed=0
if [ ${#sources[@]} -gt 0 ] && ! (cd "$copy" && clang-format-16 --dry-run -Werror "${sources[@]}"); then
  echo "pre-commit: layout; clang-format-16 -i ${sources[*]}, then git add" >&2
  failed=1
fi
if [ ${#texts[@]} -gt 0 ] && ! (cd "$copy" && codespell --quiet-level 3 --ignore-words tools/spelling.txt "${texts[@]}" >&2); then
  echo "pre-commit: spelling; correct the words, or add a term of the field to tools/spelling.txt" >&2
  failed=1
fi
if [ $modules = yes ]; then
  git ls-files -z 'src/*.[ch]pp' 'lab/*.[ch]pp' 'apps/*.[ch]pp' src/CMakeLists.txt tools/include_graph.py ':!*/tests/*' ':!*/benchmarks/*' |
    git checkout-index -f -z --stdin --prefix="$copy/" || exit 2
  if ! python3 "$copy/tools/include_graph.py" order; then
    echo "pre-commit: order of modules; a module includes only what stands before it in src/CMakeLists.txt" >&2
    failed=1
  fi
fi
exit $failed
