#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh Debian 12 machine to a tested tree: installs packages, builds, runs every test through CTest.
# Real models are used when UMBRAMETER_ASSETS names their folder, or when ../shared/models exists.
# Arguments are handed to ctest (for example: -L unit, or -L long for what takes minutes and is left out otherwise).
set -euo pipefail
cd "$(dirname "$0")/.."
bash scripts/build.sh ci
if [ -z "${UMBRAMETER_ASSETS:-}" ] && [ -d ../shared/models ]; then
  UMBRAMETER_ASSETS=$(cd ../shared/models && pwd)
  export UMBRAMETER_ASSETS
fi
[ -n "${UMBRAMETER_ASSETS:-}" ] || echo "test: no real models (set UMBRAMETER_ASSETS): their tests are skipped" >&2
if [ $# -eq 0 ]; then
  echo "test: tests labelled 'long' are left out (scripts/test.sh -L long runs them)" >&2
  set -- -LE long
fi
ctest --preset ci --parallel "$(nproc)" "$@"
