#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# tidy.sh [FILE...]: clang-tidy-16 with .clang-tidy's short list over every source of ours, or over FILEs. Needs build/ci configured
# (scripts/build.sh ci). Twenty minutes of processor time for all.
set -euo pipefail
cd "$(dirname "$0")/.."
[ -e build/ci/compile_commands.json ] || { echo "tidy: build/ci is not configured (scripts/build.sh ci)" >&2; exit 3; }
files=("$@")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(git ls-files '*.cpp' | grep -E '^(core|scenes|metrics|reference|realtime|engines|store|results|lab|study|report|view|cli|python)/')
# GCC's precompiled headers are not Clang's; every file names what it uses.
mkdir -p build/tidy
sed -E 's#( -Winvalid-pch)? -include [^ ]+/cmake_pch\.hxx##' build/ci/compile_commands.json >build/tidy/compile_commands.json
printf '%s\0' "${files[@]}" | xargs -0 -P "$(nproc)" -n 1 \
  clang-tidy-16 -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option 2> >(grep -v 'warnings\? generated' >&2)
