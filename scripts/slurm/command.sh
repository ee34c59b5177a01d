#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A task of submit.sh's array: command.sh LIST COMMANDS DIR runs one line of LIST in DIR/commands/<line>, its answer in answer.txt.
# Paths in LIST are absolute, or relative to that folder. Done is what has an answer: 0, or 1, a gate that failed.
set -euo pipefail
list=$1 out=$3 i=$SLURM_ARRAY_TASK_ID
folder=$out/commands/$i
mkdir -p "$folder"
cd "$folder"
line=$(sed -n "${i}p" "$list")
code=0
eval "\"\$UMBRAMETER\" $line --threads ${SLURM_CPUS_PER_TASK:-0}" >answer.txt || code=$?
[ "$code" -le 1 ] || exit "$code"
echo "$code $line" >"$out/commands/$i.done"
