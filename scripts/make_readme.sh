#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_readme.sh [FOLDER]: measures the README's table and draws its picture: docs/images/bunny.png is the page's own figure of
# the same results. Needs a build, chromium and UMBRAMETER_ASSETS. FOLDER keeps the results. About five minutes on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-$(mktemp -d)}
techniques=()
for id in hard pcf pcf_disk vsm evsm esm pcss pcss_vsm edge_mask_quantised penumbra_mask accumulate:light_samples=16; do
  techniques+=(--technique "$id")
done
./umbrameter validate contact_hardening assets/bunny assets/crytek_sponza "${techniques[@]}" --quality quick --out "$folder" >/dev/null
python3 scripts/readme_picture.py "$folder/report.html" assets/bunny hard,pcf,pcss docs/images/bunny.png 330,205
python3 scripts/readme_table.py "$folder/results.json" README.md
