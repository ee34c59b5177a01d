#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench_tune.sh [FOLDER]: measures the tuner and writes the tables of docs/tuning.md. Per scene and technique:
#   grid     two or three parameters, at most 5 % of a dense grid's evaluations, against that grid, on one camera
#   presets  every parameter that does not count work, against the defaults and presets, and on held-out cameras
# What lies in FOLDER already is not measured again. A scene's truths are rendered once for all techniques, and two scenes are
# measured side by side. Needs a build (scripts/build.sh ci), or one that UMBRAMETER names. Half an hour on two idle cores with
# a software rasteriser.
set -euo pipefail
cd "$(dirname "$0")/.."
export program=${UMBRAMETER:-build/ci/cli/umbrameter}
export folder=${1:-build/tune_bench}
scenes=(sphere_terminator contact_hardening comb fence plate stacked_plates box_contact colonnade disk_occluder)
mkdir -p "$folder"

# measure NAME SCENE ARGUMENTS...: leaves FOLDER/NAME.json whole or not at all. Evaluations end the searches, not the clock: a busy
# machine changes no number.
measure() {
  local name=$1 scene=$2
  shift 2
  [ -e "$folder/$name.json" ] && return
  "$program" tune "$scene" "$@" --width 320 --height 180 --spp 256 --time-limit 120min --json --out "$folder/truths/$scene" \
    >"$folder/$name.part" 2>"$folder/$name.log" ||
    { echo "bench_tune: $name failed: $(tail -n 1 "$folder/$name.log")" >&2; return; }
  mv "$folder/$name.part" "$folder/$name.json"
}

measure_scene() {
  local technique parameters steps
  while read -r technique parameters steps; do  # steps of the dense grid, of which 31 evaluations are 5 %
    measure "presets-$1-$technique" "$1" --technique "$technique:map_size=256"
    measure "grid-$1-$technique" "$1" --technique "$technique:map_size=256" --parameters "$parameters" --evaluations 31 \
      --grid "$steps" --cameras 1 --no-coarse
  done <<'TECHNIQUES'
hard bias_texels,normal_offset_texels 25
pcf_disk radius_texels,bias_texels 25
vsm filter_width_texels,bleed_reduction 25
esm filter_width_texels,exponent 25
evsm filter_width_texels,positive_exponent 25
pcss normal_offset_texels,search_focus,average 18
TECHNIQUES
}
export -f measure measure_scene

printf '%s\n' "${scenes[@]}" | xargs -P 2 -I SCENE bash -c 'set -euo pipefail; measure_scene SCENE'
python3 scripts/tuning_tables.py "$folder" docs/tuning.md
