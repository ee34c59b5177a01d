#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sanitize.sh [--tests] [SECONDS]: Clang, with address and undefined-behaviour sanitizers: every fuzz target (SECONDS each,
# default 10) and the small stress suite; --tests: the unit tests, too, which take 20 CPU-minutes to build.
set -euo pipefail
cd "$(dirname "$0")/.."
unit_tests=()
if [ "${1:-}" = --tests ]; then
  shift
  mapfile -t unit_tests < <(printf 'umbrameter_test_unit_%s\n' core scenes metrics realtime engines store results lab study report view)
fi
bash scripts/build.sh sanitize umbrameter umbrameter-exact "${unit_tests[@]}"
bash scripts/fuzz.sh "${1:-10}"
# Mesa keeps what it allocated, so leaks are looked for by the fuzz targets alone.
export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
if [ ${#unit_tests[@]} -gt 0 ]; then ctest --test-dir build/sanitize -L unit --parallel "$(nproc)" --output-on-failure; fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
build/sanitize/cli/umbrameter stress suites/stress-small.toml --out "$out"
