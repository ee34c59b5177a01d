#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A task of submit.sh's array: shard.sh STUDY SHARDS DIR. Done is what ended with 0.
set -euo pipefail
study=$1 shards=$2 out=$3 i=$SLURM_ARRAY_TASK_ID
"$UMBRAMETER" sweep "$study" --shard "$i/$shards" --out "$out/shards/$i" --threads "${SLURM_CPUS_PER_TASK:-0}"
touch "$out/shards/$i.done"
