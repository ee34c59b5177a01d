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
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
# dpkg closes the progress descriptor in packages' scripts, so it must not be their standard output; sudo closes all others,
# so the shell that opens it runs inside.
"${as_root[@]}" sh -c 'exec apt-get install -y -qq -o APT::Status-Fd=3 -o Dpkg::Use-Pty=0 --no-install-recommends "$@" 3>&1 >/dev/null' \
  apt-get "${missing[@]}" |
  awk -v phase=packages -f quickstart_progress.awk >&2
