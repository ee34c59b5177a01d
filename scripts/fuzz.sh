#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fuzz.sh [SECONDS] [TARGET...]: builds the libFuzzer targets with sanitizers and runs each for SECONDS (default 15).
# What makes a target fail is left in build/sanitize/fuzz/found/; new inputs that reach new code in .../grown/TARGET.
# `fuzz.sh minimise` writes the smallest set of inputs with the same coverage back to fuzz/corpus/.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-15}
shift || true
targets=("$@")
[ ${#targets[@]} -gt 0 ] || mapfile -t targets < <(basename -s .cpp -a fuzz/*.cpp)
bash scripts/build.sh sanitize "${targets[@]/#/fuzz_}"

folder=build/sanitize/fuzz
mkdir -p "$folder/found"
for target in "${targets[@]}"; do
  mkdir -p "$folder/grown/$target"
  if [ "$seconds" = minimise ]; then
    smallest=$(mktemp -d)
    "$folder/fuzz_$target" -merge=1 -close_fd_mask=3 -max_len=4096 "$smallest" "fuzz/corpus/$target" "$folder/grown/$target"
    find "$smallest" -size +8k -delete
    rm -f "fuzz/corpus/$target"/*
    mv "$smallest"/* "fuzz/corpus/$target"
    continue
  fi
  log="$folder/$target.log"
  if "$folder/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=8192 -close_fd_mask=3 \
       -artifact_prefix="$folder/found/$target-" "$folder/grown/$target" "fuzz/corpus/$target" >"$log" 2>&1; then
    echo "fuzz: $target: $(grep -oE 'Done [0-9]+ runs in [0-9]+ second' "$log" | tail -1)s, nothing found"
  else
    tail -n 40 "$log" >&2
    echo "fuzz: $target fails; its input is in $folder/found/" >&2
    exit 1
  fi
done
