#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# submit.sh [-n SHARDS] [-o DIR] STUDY.toml|LIST [SBATCH OPTION...]: a study as a Slurm array, one store a shard, merged into DIR/store;
# or a LIST of umbrameter's commands, one a line (tunings, regressions), each with a folder of its own, told in DIR/summary.txt
# (docs/slurm.md). Run again after failures: only what is not done is submitted; each goes on where it was stopped.
# UMBRAMETER names the program (default: umbrameter on PATH).
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "$0")")" && pwd)
fail() { echo "submit: $*" >&2; exit 2; }

shards=8
out=sweep
while getopts n:o:h option; do
  case $option in
    n) shards=$OPTARG ;;
    o) out=$OPTARG ;;
    *) sed -n '3,6s/^# //p' "$0"; exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -ge 1 ] || fail "no study is given (submit.sh [-n SHARDS] [-o DIR] STUDY.toml|LIST [SBATCH OPTION...])"
[[ $shards =~ ^[1-9][0-9]*$ ]] || fail "-n $shards is not a number of shards"
[ -f "$1" ] || fail "'$1' is not a file"
plan_file=$(realpath "$1")
shift
task=shard last=merge
if [[ $plan_file != *.toml ]]; then
  task=command last=summarise
  shards=$(grep -c '' "$plan_file") || fail "'$plan_file' lists no command"
fi
export UMBRAMETER=${UMBRAMETER:-umbrameter}
command -v "$UMBRAMETER" >/dev/null || fail "'$UMBRAMETER' is not a program (set UMBRAMETER)"
command -v sbatch >/dev/null || { echo "submit: sbatch is not installed" >&2; exit 3; }

mkdir -p "$out/${task}s" "$out/logs"
out=$(realpath "$out")
# Tasks of another number, or of another study, hold other runs.
plan="$shards $(sha256sum <"$plan_file" | cut -d' ' -f1)"
if [ -e "$out/plan" ] && [ "$(cat "$out/plan")" != "$plan" ]; then
  fail "'$out' holds ${task}s of another file or number; choose another -o"
fi
echo "$plan" >"$out/plan"

todo=()
for ((i = 1; i <= shards; ++i)); do
  [ -e "$out/${task}s/$i.done" ] || todo+=("$i")
done
dependency=()
if [ ${#todo[@]} -gt 0 ]; then
  array=$(IFS=,; echo "${todo[*]}")
  job=$(sbatch --parsable --job-name=umbrameter --array="$array" --output="$out/logs/%a.txt" "$@" \
        "$here/$task.sh" "$plan_file" "$shards" "$out")
  echo "submit: job $job: ${task}s $array of $shards"
  dependency=(--dependency="afterany:${job%%;*}")
fi
job=$(sbatch --parsable --job-name="umbrameter-$last" --output="$out/logs/$last.txt" "${dependency[@]}" \
      "$here/$last.sh" "$shards" "$out")
echo "submit: job $job: ${last}s into $out"
