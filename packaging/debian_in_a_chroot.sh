#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# debian_in_a_chroot.sh PACKAGE.deb STUDY.toml: installs the package in a bare Debian 12 and runs a study there. Needs root
# and debootstrap; exit code 77 (skipped) without them. The folder goes afterwards.
set -euo pipefail
package=$(realpath "$1") study=$(realpath "$2")
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "skipped: a bare Debian takes root and debootstrap"
  exit 77
fi
root=$(mktemp -d)
chmod 755 "$root" # packages are fetched by a user of their own
trap 'rm -rf --one-file-system "$root"' EXIT
if ! debootstrap --variant=minbase bookworm "$root" >"$root.log" 2>&1; then
  tail -3 "$root.log"
  echo "skipped: debootstrap could not make a bare Debian; $root.log says why"
  exit 77
fi
rm "$root.log"
cp "$package" "$root/setae.deb"
mkdir "$root/study"
cp "$study" "$root/study/study.toml"
# security updates lie beside the packages on the server that debootstrap took
sed -n 's|/debian/* bookworm main|/debian-security bookworm-security main|p' "$root/etc/apt/sources.list" >"$root/etc/apt/sources.list.d/security.list"
inside() { chroot "$root" env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get update -qq
inside apt-get install -y -qq --no-install-recommends /setae.deb >/dev/null
inside setae --version
inside setae study /study/study.toml --output /study/results
test -n "$(find "$root/study/results" -name "*.svg" -size +1k)"
inside test -e /usr/include/setae/core/units.hpp
inside apt-get remove -y -qq setae >/dev/null
inside test ! -e /usr/bin/setae
echo "installed, ran a study with its figures, and was removed again"
