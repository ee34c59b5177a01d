#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sanitize.sh [SECONDS]: address and undefined-behaviour sanitizers over every fuzz target (SECONDS each, default 10) and
# over the small stress suite.
set -euo pipefail
cd "$(dirname "$0")/.."
bash scripts/build.sh sanitize
bash scripts/fuzz.sh "${1:-10}"
# Mesa keeps what it allocated, so leaks are looked for by the fuzz targets alone.
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
  build/sanitize/cli/umbrameter stress suites/stress-small.toml --out "$out"
