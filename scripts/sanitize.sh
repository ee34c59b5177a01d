#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sanitize.sh [SECONDS]: Clang, with address and undefined-behaviour sanitizers: the unit tests, every fuzz target (SECONDS each,
# default 10) and the small stress suite.
set -euo pipefail
cd "$(dirname "$0")/.."
mapfile -t unit_tests < <(printf 'umbrameter_test_unit_%s\n' core scenes metrics realtime engines study view)
bash scripts/build.sh sanitize umbrameter umbrameter-exact "${unit_tests[@]}"
bash scripts/fuzz.sh "${1:-10}"
# Mesa keeps what it allocated, so leaks are looked for by the fuzz targets alone.
export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
ctest --test-dir build/sanitize -L unit --parallel "$(nproc)" --output-on-failure
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
build/sanitize/cli/umbrameter stress suites/stress-small.toml --out "$out"
