#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The last job of submit.sh for a list of commands: summarise.sh COMMANDS DIR writes DIR/summary.txt, a line a command: its exit code and
# itself. Ends with 1 when one is not done or one's gate failed.
set -euo pipefail
commands=$1 out=$2 code=0
for ((i = 1; i <= commands; ++i)); do
  if [ -e "$out/commands/$i.done" ]; then
    cat "$out/commands/$i.done"
    read -r ended _ <"$out/commands/$i.done"
    [ "$ended" -eq 0 ] || code=1
  else
    echo "not done (see $out/logs/$i.txt; run submit.sh again)"
    code=1
  fi
done >"$out/summary.txt.new"
mv "$out/summary.txt.new" "$out/summary.txt"
exit "$code"
