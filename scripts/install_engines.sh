#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# install_engines.sh [FOLDER]: installs the web engines, by the versions and checksums of engines/package-lock.json, into FOLDER, which
# UMBRAMETER_ENGINES must name then, or into engines/installed/ (ignored by git).
# Needs npm. The engines' own install scripts are not run. docs/engines.md says what each adapter needs beside.
set -euo pipefail
target=$(realpath -m "${1:-$(dirname "$0")/../engines/installed}")
cd "$(dirname "$0")/../engines"
command -v npm > /dev/null || { echo "install_engines.sh: npm is not there" >&2; exit 3; }
mkdir -p "$target"
cp package.json package-lock.json "$target/"
npm ci --prefix "$target" --ignore-scripts --no-audit --no-fund
command -v chromium > /dev/null || { echo "install_engines.sh: chromium is not there; scripts/install_packages.sh installs it" >&2; exit 3; }
