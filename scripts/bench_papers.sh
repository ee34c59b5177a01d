#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench_papers.sh [FOLDER [OPTION...]]: runs the papers' studies and writes the tables of docs/papers.md. What lies in FOLDER
# already is not measured again. OPTIONs go to every `bench`, such as --width 320 --height 180. Needs a build
# (scripts/build.sh ci), or one that UMBRAMETER names, and UMBRAMETER_ASSETS. Ten minutes on two cores of a software rasteriser.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${UMBRAMETER:-build/ci/cli/umbrameter}
folder=${1:-build/paper_bench}
shift || true
mkdir -p "$folder"
for study in paper-a paper-bc paper-d paper-e paper-e-light-size static_loops; do
  target=$folder/$study
  [ -e "$target.json" ] && continue
  "$program" bench "studies/papers/$study.toml" --out "$folder/truths" --json "$@" > "$target.part" 2> "$target.log" ||
    { echo "bench_papers: $study failed: $(tail -n 1 "$target.log")" >&2; continue; }
  mv "$target.part" "$target.json"
done
python3 scripts/paper_tables.py "$folder" docs/papers.md
