#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# install_engines.sh [FOLDER]: installs the engines that have adapters under engines/, by pinned version.
# The web engines, by the versions and checksums of engines/package-lock.json, go into FOLDER, which UMBRAMETER_ENGINES must name
# then, or into engines/installed/ (ignored by git); their own install scripts are not run. Needs npm. Other versions of two go
# into other_versions/ below: scripts/prove_engine_versions.py changes from one to the other.
# Chromium, Blender and Xvfb are Debian packages, and need root or sudo. docs/engines.md says what each adapter needs.
set -euo pipefail
blender_version=3.4.1
target=$(realpath -m "${1:-$(dirname "$0")/../engines/installed}")
cd "$(dirname "$0")/../engines"
command -v npm > /dev/null || { echo "install_engines.sh: npm is not there" >&2; exit 3; }

install_packages() {  # FROM, a folder with package-lock.json, into TO
  mkdir -p "$2"
  cp "$1/package.json" "$1/package-lock.json" "$2/"
  npm ci --prefix "$2" --ignore-scripts --no-audit --no-fund
}
install_packages . "$target"
install_packages other_versions "$target/other_versions"

wanted=()
command -v chromium > /dev/null || wanted+=(chromium)
command -v Xvfb > /dev/null || wanted+=(xvfb)
dpkg-query -W python3-numpy > /dev/null 2>&1 || wanted+=(python3-numpy)  # for Blender, which comes without
[[ $(dpkg-query -W -f='${Version}' blender 2> /dev/null) == "$blender_version"* ]] || wanted+=("blender=$blender_version*")
[ ${#wanted[@]} -eq 0 ] && exit 0
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || { echo "install_engines.sh: run as root, or install these yourself: ${wanted[*]}" >&2; exit 3; }
  as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${wanted[@]}" > /dev/null
