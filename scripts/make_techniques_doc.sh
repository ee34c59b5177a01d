#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_techniques_doc.sh [FOLDER]: measures every technique on the built-in scenes and four real models, and writes
# docs/techniques.md. Needs a build (scripts/build.sh ci) and UMBRAMETER_ASSETS. FOLDER keeps the results.
# Five minutes on two cores of a software rasteriser.
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/ci/cli/umbrameter
folder=${1:-$(mktemp -d)}
scenes=()
for file in scenes/library/*.toml; do scenes+=("$(basename "$file" .toml)"); done
scenes+=(assets/bunny assets/dragon assets/crytek_sponza assets/dabrovic_sponza)
techniques=()
for manifest in realtime/techniques/*/technique.toml; do
  id=$(basename "$(dirname "$manifest")")
  [ "$id" = accumulate ] && id="accumulate:light_samples=16" # 64 maps of Sponza take half a minute a frame
  techniques+=(--technique "$id")
done
"$program" validate "${scenes[@]}" "${techniques[@]}" --quality quick --width 320 --height 180 --spp 256 --frames 3 --causes none \
  --out "$folder"
"$program" techniques doc "$folder/results.json" --out docs/techniques.md
