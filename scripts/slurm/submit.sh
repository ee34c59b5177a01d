#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# submit.sh [-n SHARDS] [-o DIR] STUDY [SBATCH OPTION...]: a study as a Slurm array, one store a shard, merged into DIR/store
# when all are done (docs/slurm.md). Run again after failures: only shards that are not done are submitted; each goes on where it was
# stopped. UMBRAMETER names the program (default: umbrameter on PATH).
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "$0")")" && pwd)
fail() { echo "submit: $*" >&2; exit 2; }

shards=8
out=sweep
while getopts n:o:h option; do
  case $option in
    n) shards=$OPTARG ;;
    o) out=$OPTARG ;;
    *) sed -n '3,5s/^# //p' "$0"; exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -ge 1 ] || fail "no study is given (submit.sh [-n SHARDS] [-o DIR] STUDY [SBATCH OPTION...])"
[[ $shards =~ ^[1-9][0-9]*$ ]] || fail "-n $shards is not a number of shards"
study=$(realpath "$1")
[ -f "$study" ] || fail "'$1' is not a file"
shift
export UMBRAMETER=${UMBRAMETER:-umbrameter}
command -v "$UMBRAMETER" >/dev/null || fail "'$UMBRAMETER' is not a program (set UMBRAMETER)"
command -v sbatch >/dev/null || { echo "submit: sbatch is not installed" >&2; exit 3; }

mkdir -p "$out/shards" "$out/logs"
out=$(realpath "$out")
# Shards of another number, or of another study, hold other runs.
plan="$shards $(sha256sum <"$study" | cut -d' ' -f1)"
if [ -e "$out/plan" ] && [ "$(cat "$out/plan")" != "$plan" ]; then
  fail "'$out' holds shards of another study or number of shards; choose another -o"
fi
echo "$plan" >"$out/plan"

todo=()
for ((i = 1; i <= shards; ++i)); do
  [ -e "$out/shards/$i.done" ] || todo+=("$i")
done
dependency=()
if [ ${#todo[@]} -gt 0 ]; then
  array=$(IFS=,; echo "${todo[*]}")
  job=$(sbatch --parsable --job-name=umbrameter --array="$array" --output="$out/logs/%a.txt" "$@" \
        "$here/shard.sh" "$study" "$shards" "$out")
  echo "submit: job $job: shards $array of $shards"
  dependency=(--dependency="afterany:${job%%;*}")
fi
job=$(sbatch --parsable --job-name=umbrameter-merge --output="$out/logs/merge.txt" "${dependency[@]}" \
      "$here/merge.sh" "$shards" "$out")
echo "submit: job $job: merges into $out/store"
