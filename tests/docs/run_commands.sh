#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run_commands.sh SETAE DOCUMENT: in an empty folder, writes each block ```toml file=NAME of a document and runs each command of
# its blocks ```sh, in order, with `setae` on the path and examples/ beside; fails with the first command that does.
set -euo pipefail
program=$(realpath "$1") document=$(realpath "$2") sources=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
ln -s "$program" "$work/bin/setae"
ln -s "$sources/examples" "$work/examples"
export PATH=$work/bin:$PATH SETAE_CACHE=$work/cache
cd "$work"

commands=0 block=
while IFS= read -r line; do
  case $line in
    '```sh') block=sh ;;
    '```toml file='*) block=file; file=${line#*file=}; mkdir -p "$(dirname "$file")"; : > "$file" ;;
    '```'*) block= ;;
    *)
      if [ "$block" = file ]; then
        printf '%s\n' "$line" >> "$file"
      elif [ "$block" = sh ] && [ -n "$line" ]; then
        echo "\$ $line"
        bash -c "$line" > out.txt 2> err.txt || { echo "failed with exit code $?"; cat out.txt err.txt; exit 1; }
        commands=$((commands + 1))
      fi
      ;;
  esac
done < "$document"
[ "$commands" -gt 0 ] || { echo "no command found in $document"; exit 1; }
echo "$commands commands"
# what the text promises is there
for file in mine/adhesion_results/report.html mine/adhesion_results/study.json figure_4.pdf figure_4.csv psd.csv; do
  [ -s "$file" ] || { echo "missing: $file"; exit 1; }
done
