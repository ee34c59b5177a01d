#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Does the regression gate neither flake nor miss? Records a baseline, checks it again and again without a change (other
# seeds, other thread counts, every GL device that --device names), then puts the selftest's faults through it.
#   scripts/prove_regress.sh [-n CHECKS] [-s SUITE] [-b BINARY] [-d DEVICE]... [-f SCENE]... [-F]
# -f: only these scenes' faults; -F: no faults. Exit code 1 when a check fails or a fault is missed.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
checks=200 suite="$root/suites/small.toml" binary="$root/build/ci/cli/umbrameter" faults=1
devices=() scenes=()
while getopts "n:s:b:d:f:F" option; do
  case $option in
    n) checks=$OPTARG ;;
    s) suite=$OPTARG ;;
    b) binary=$OPTARG ;;
    d) devices+=(--device "$OPTARG") ;;
    f) scenes+=(--scene "$OPTARG") ;;
    F) faults=0 ;;
    *) exit 2 ;;
  esac
done
[ ${#devices[@]} -gt 0 ] || devices=(--device "")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$binary" regress record "$suite" --baseline "$folder" "${devices[@]:0:2}" >/dev/null 2>&1
bad=0 cases=0 undecided=0 better=0 added=0
for ((i = 1; i <= checks; ++i)); do
  d=$((2 * (i % (${#devices[@]} / 2))))
  if ! "$binary" regress check "$suite" --baseline "$folder" --seed $((i + 1)) --threads $((i % 3 + 1)) \
    "${devices[@]:d:2}" --json >"$folder/check.json" 2>"$folder/errors.txt"; then
    bad=$((bad + 1))
    echo "check $i fails:" >&2
    cat "$folder/errors.txt" >&2
    python3 -c 'import json, sys
for c in json.load(open(sys.argv[1]))["cases"]:
    if c["outcome"] == "fail": print(c["scene"], c["label"], c["kind"], c["message"], sep=", ", file=sys.stderr)' "$folder/check.json" || true
    continue
  fi
  read -r n u b a < <(python3 -c 'import json, sys
r = json.load(open(sys.argv[1]))
print(len(r["cases"]), r["undecided"], r["better"], sum(c["pictures"] > 1 for c in r["cases"]))' "$folder/check.json")
  cases=$((cases + n)) undecided=$((undecided + u)) better=$((better + b)) added=$((added + a))
done
echo "$checks checks without a change: $bad fail; of $cases cases $undecided undecided, $better better, $added needed more samples"
if [ "$faults" = 1 ]; then "$binary" regress prove "${scenes[@]}"; fi
[ "$bad" = 0 ]
