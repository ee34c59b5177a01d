#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the web engines into engines/installed/ (ignored by git), by the versions and checksums of engines/package-lock.json.
# Needs npm. The engines' own install scripts are not run. docs/engines.md says what each adapter needs beside.
set -euo pipefail
cd "$(dirname "$0")/../engines"
command -v npm > /dev/null || { echo "install_engines.sh: npm is not there" >&2; exit 3; }
mkdir -p installed
cp package.json package-lock.json installed/
npm ci --prefix installed --ignore-scripts --no-audit --no-fund
command -v chromium > /dev/null || { echo "install_engines.sh: chromium is not there; scripts/install_packages.sh installs it" >&2; exit 3; }
