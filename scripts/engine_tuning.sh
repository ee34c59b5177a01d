#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# engine_tuning.sh [FOLDER]: tunes engines' own parameters on scenes of the library, against the engines' defaults on cameras
# that the search never saw, and writes the table of docs/engines.md. What lies in FOLDER (default out/engine_tuning) already is
# not measured again. Of under_a_bulb no other camera sees enough: its rows say so. Needs scripts/install_engines.sh and a build;
# UMBRAMETER names the program (default ./umbrameter). Half an hour on two cores with a software rasteriser.
set -euo pipefail
cd "$(dirname "$0")/.."
umbrameter=${UMBRAMETER:-./umbrameter}
folder=${1:-out/engine_tuning}
scenes=(contact_hardening plate fence box_contact under_a_bulb colonnade stacked_plates)
engines=(three:type=pcf,shadow.mapSize=1024 babylon:type=pcf,mapSize=1024 playcanvas:type=pcf3,shadowResolution=1024 filament:type=pcf)
mkdir -p "$folder"
for scene in "${scenes[@]}"; do
  for engine in "${engines[@]}"; do
    target=$folder/${engine%%:*}-$scene
    [ -e "$target.json" ] && continue
    # Evaluations end the search, not the clock: a busy machine changes no number.
    "$umbrameter" tune "$scene" --technique "$engine" --width 240 --height 136 --spp 256 --evaluations 40 --time-limit 60min \
      --out "$folder/store" --json > "$target.part" 2> "$target.log" ||
      { echo "engine_tuning: $target failed: $(tail -n 1 "$target.log")" >&2; continue; }
    mv "$target.part" "$target.json"
  done
done
python3 scripts/engine_tuning_table.py "$folder" docs/engines.md
