#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh Debian 12 machine to out/report.html: installs packages, builds, validates the built-in scenes.
# Arguments are handed to `umbrameter validate` (for example: --quality standard).
set -euo pipefail
cd "$(dirname "$0")/.."
bash scripts/build.sh release umbrameter
build/release/cli/umbrameter validate --quality quick --out out "$@"
echo "quickstart: open out/report.html"
