#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench_tune.sh [FOLDER]: measures the tuner and writes the tables of docs/tuning.md. Per scene and technique:
#   grid     two or three parameters, at most 5 % of a dense grid's evaluations, against that grid, on one camera
#   presets  every parameter that does not count work, against the defaults and presets, and on held-out cameras
# What lies in FOLDER already is not measured again. Needs a build (scripts/build.sh ci), or one that UMBRAMETER names. Three
# quarters of an hour on two cores with a software rasteriser.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${UMBRAMETER:-build/ci/cli/umbrameter}
folder=${1:-build/tune_bench}
scenes=(sphere_terminator contact_hardening comb fence plate stacked_plates box_contact colonnade disk_occluder)
size=(--width 320 --height 180 --spp 256)
patience=60min
# technique, parameters, most evaluations (5 % of the grid), steps of the grid
techniques=(
  "hard bias_texels,normal_offset_texels 31 25"
  "pcf_disk radius_texels,bias_texels 31 25"
  "vsm filter_width_texels,bleed_reduction 31 25"
  "esm filter_width_texels,exponent 31 25"
  "evsm filter_width_texels,positive_exponent 31 25"
  "pcss normal_offset_texels,search_focus,average 31 18"
)
mkdir -p "$folder"

# measure NAME ARGUMENTS...: leaves FOLDER/NAME.json whole or not at all.
measure() {
  local target=$folder/$1
  shift
  [ -e "$target.json" ] && return
  "$program" tune "$@" "${size[@]}" --json --out "$target" > "$target.part" 2> "$target.log" ||
    { echo "bench_tune: $target failed: $(tail -n 1 "$target.log")" >&2; return; }
  mv "$target.part" "$target.json"
}

# Evaluations end the searches, not the clock: a busy machine changes no number.
measure_all() {
  local scene line technique parameters evaluations steps
  for scene in "${scenes[@]}"; do
    for line in "${techniques[@]}"; do
      read -r technique parameters evaluations steps <<< "$line"
      "$1" "$scene" "$technique:map_size=256"
    done
  done
}
presets() {
  measure "presets-$1-$technique" "$1" --technique "$2" --evaluations 100 --time-limit "$patience"
}
grid() {
  measure "grid-$1-$technique" "$1" --technique "$2" --parameters "$parameters" --evaluations "$evaluations" \
    --grid "$steps" --cameras 1 --no-coarse --time-limit "$patience"
}

measure_all presets
measure_all grid
python3 scripts/tuning_tables.py "$folder" docs/tuning.md
