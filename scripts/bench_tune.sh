#!/usr/bin/env bash
# bench_tune.sh [FOLDER]: measures the tuner and writes the tables of docs/tuning.md. Per scene and technique:
#   grid     two or three parameters, at most 5 % of a dense grid's evaluations, against that grid, on one camera
#   presets  every parameter that does not count work, against the defaults and presets, and on held-out cameras
# What lies in FOLDER already is not measured again. Needs a build (scripts/build.sh ci). Half an hour on two cores of a
# software rasteriser.
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/ci/cli/umbrameter
folder=${1:-build/tune_bench}
scenes=(box_contact colonnade comb contact_hardening disk_occluder fence plate sphere_terminator stacked_plates)
size=(--width 160 --height 90 --spp 256)
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

for scene in "${scenes[@]}"; do
  for line in "${techniques[@]}"; do
    read -r technique parameters evaluations steps <<< "$line"
    measure "presets-$scene-$technique" "$scene" --technique "$technique:map_size=256" --evaluations 100 \
      --time-limit 20s
    measure "grid-$scene-$technique" "$scene" --technique "$technique:map_size=256" --parameters "$parameters" \
      --evaluations "$evaluations" --grid "$steps" --cameras 1 --time-limit 10min
  done
done
python3 scripts/tuning_tables.py "$folder" docs/tuning.md
