#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# with_python.sh MODULE SCRIPT ARGUMENTS…: runs a script with the first interpreter that has the module: $SETAE_PEERS_PYTHON, the environment
# of ./setup peers, python3. Exit code 77 (skipped) where there is none. Looked for here, when tests run: what is installed then counts.
set -euo pipefail
module=$1
shift
for python in "${SETAE_PEERS_PYTHON:-}" "${XDG_CACHE_HOME:-$HOME/.cache}/setae/peers/bin/python" python3; do
  if [ -n "$python" ] && "$python" -c "import $module" 2>/dev/null; then
    exec "$python" "$@"
  fi
done
echo "skipped: no python3 with the module $module"
exit 77
