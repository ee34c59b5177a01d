#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Holds the stated errors of the reference against exact arithmetic in many scenes: how many 95 % intervals hold the exact
# visibility, and whether the mean error stays within its noise. Each scene has a seed of its own. Takes half an hour.
#   scripts/certify_truth.sh [-b UMBRAMETER] [-n POINTS] [SCENE...]
set -euo pipefail
binary=build/ci/cli/umbrameter
points=300
while getopts b:n: option; do
  case $option in
    b) binary=$OPTARG ;;
    n) points=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
scenes=("$@")
if [ ${#scenes[@]} -eq 0 ]; then
  scenes=(comb wire fence colonnade stacked_plates contact_hardening half_plane_disk sphere_terminator
          assets/bunny assets/dragon assets/crytek_sponza assets/desk_fan assets/columns assets/hair)
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
seed=1000
for scene in "${scenes[@]}"; do
  seed=$((seed + 1))
  count=$points
  [ "$scene" = assets/hair ] && count=$((points / 3))  # a point among hairs costs a second and more
  "$binary" reference "$scene" --width 320 --height 180 --spp 16384 --target-se 0.004 --seed $seed \
    --exact-check "$count" --json -o "$folder/reference.exr" 2>/dev/null > "$folder/$seed.json"
  python3 - "$scene" "$folder/$seed.json" "$folder/sum" <<'EOF'
import json, pathlib, sys
scene, file, total = sys.argv[1:]
check = json.load(open(file))["exact_check"]
p = check["penumbra"]
total = pathlib.Path(total)
points, covered = map(int, total.read_text().split()) if total.exists() else (0, 0)
points, covered = points + p["points"], covered + p["covered"]
total.write_text(f"{points} {covered}")
print(f"{scene:22} {p['points']:4} points, {100 * p['coverage']:5.1f} % covered, mean error {p['mean_error']:+.6f} "
      f"= {p['mean_error'] / p['mean_error_noise']:+.2f} of its noise, RMS error {p['rms_error'] / p['rms_se']:.2f} of stated, "
      f"{check['others_wrong']} of {check['others']} others wrong, {check['cpu_time_s']:.0f} CPU s; "
      f"all so far: {points} points, {100 * covered / points:.2f} %", flush=True)
EOF
done
