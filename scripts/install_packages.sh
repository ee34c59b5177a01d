#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# install_packages.sh [--program]: installs what scripts/packages.txt lists, or only the part above "tests and benches" that the
# program needs. Safe to run again: does nothing when nothing is missing.
set -euo pipefail
cd "$(dirname "$0")"

stop='^$a'  # matches nothing
[ "${1:-}" = "--program" ] && stop='^# tests and benches'
mapfile -t wanted < <(sed "/$stop/,\$d" packages.txt | grep -vE '^\s*(#|$)')
missing=()
for package in "${wanted[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install_packages: run as root, or install these yourself: ${missing[*]}" >&2; exit 3; }
  as_root=(sudo)
fi
echo "install_packages: ${#missing[@]} packages: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
# What apt says of its progress goes to descriptor 3, all else nowhere. Not to 1: apt hides that one from packages' scripts, and
# those that write would fail. The inner shell opens 3, since sudo closes it.
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive sh -c 'exec 3>&1 >/dev/null && exec apt-get install -y -qq -o APT::Status-Fd=3 -o Dpkg::Use-Pty=0 --no-install-recommends "$@"' \
  sh "${missing[@]}" | awk -v phase=packages -f quickstart_progress.awk >&2
