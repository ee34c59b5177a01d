#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh Debian 12 machine to a first answer: builds the program alone, measures the techniques people know on a few
# telling scenes and one real model, and says in ten lines what came out. The model is of UMBRAMETER_ASSETS or ../shared/models,
# else the bunny that get_models.sh brings; without npm or a network there is none. Arguments are handed to
# `umbrameter validate` (for example: --quality standard).
set -euo pipefail
cd "$(dirname "$0")/.."
start=$SECONDS
phase() { echo "quickstart: [$1/4] $2" >&2; }
# Debian's awk waits for 4 KiB of a pipe, unless it is told not to: that is a minute of a build.
read_at_once=()
awk -W version 2>&1 </dev/null | grep -q mawk && read_at_once=(-W interactive)
progress() { awk "${read_at_once[@]}" -v phase="$1" -f scripts/quickstart_progress.awk >&2; }

phase 1 "packages (scripts/packages.txt, those that the program needs)"
bash scripts/install_packages.sh --program
phase 2 "configuring (some seconds)"
export CCACHE_SLOPPINESS=pch_defines,time_macros
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake --preset release -DUMBRAMETER_TESTS=OFF -DUMBRAMETER_BENCHES=OFF -DUMBRAMETER_PYTHON=OFF \
  -DUMBRAMETER_UNITY=ON -DUMBRAMETER_WARNINGS_AS_ERRORS=OFF "${launcher[@]}" >/dev/null
phase 3 "building (the first time some minutes)"
NINJA_STATUS="@@%f %t " cmake --build --preset release --target umbrameter | progress build
program=build/release/cli/umbrameter

scenes=(contact_hardening fence stacked_plates)
assets=${UMBRAMETER_ASSETS:-}
[ -z "$assets" ] && [ -d ../shared/models ] && assets=$(cd ../shared/models && pwd)
if [ -n "$assets" ] && UMBRAMETER_ASSETS=$assets "$program" scene check assets/bunny >/dev/null 2>&1; then
  export UMBRAMETER_ASSETS=$assets
  scenes+=(assets/bunny)
elif told=$(bash scripts/get_models.sh bunny 2>&1); then
  scenes+=(models/bunny.toml)
else
  echo "quickstart: goes on without a model: $told" >&2
fi
phase 4 "measuring ${#scenes[@]} scenes: ${scenes[*]}"
techniques=()
for id in hard pcf vsm esm pcss; do techniques+=(--technique "$id"); done
{ table=$("$program" validate "${scenes[@]}" "${techniques[@]}" --quality quick --out out "$@" 2>&3); } 3> >(progress measure) ||
  { code=$?; echo "$table"; exit "$code"; }
python3 scripts/quickstart_summary.py out/results.json $((SECONDS - start))
