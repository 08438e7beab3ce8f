#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# named_tests.sh BUILD PAGE: every test a page names as `Suite.Name` exists.
set -euo pipefail
tests=$(ctest --test-dir "$1" -N)
missing=0
while read -r name; do
  grep -qE "[./]${name//./\\.}(/|$|[[:space:]])" <<<"$tests" || { echo "$2 names $name, which is no test"; missing=1; }
done < <(grep -oE '`[A-Z][A-Za-z0-9]*\.[A-Z][A-Za-z0-9]*`' "$2" | tr -d '`' | sort -u)
exit $missing
