#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The last job of submit.sh: merge.sh SHARDS DIR.
set -euo pipefail
shards=$1 out=$2
missing=()
stores=()
for ((i = 1; i <= shards; ++i)); do
  [ -e "$out/shards/$i.done" ] || missing+=("$i")
  # A shard without runs leaves no store.
  [ -d "$out/shards/$i" ] && stores+=("$out/shards/$i")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "merge: shards ${missing[*]} are not done (see $out/logs); run submit.sh again" >&2
  exit 1
fi
"$UMBRAMETER" merge "${stores[@]}" --out "$out/store"
touch "$out/merged"
