#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_selftest_doc.sh: runs the self-test, its benign part on real models, and the causes, and writes what they print into
# docs/selftest.md. Needs UMBRAMETER_ASSETS; about six minutes of two idle cores.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${UMBRAMETER:-build/ci/cli/umbrameter}
measured=$(mktemp)
trap 'rm -f "$measured" "$measured.doc"' EXIT
models=()
while read -r scene; do models+=(--scene "$scene"); done < <("$program" scene list --json | python3 -c '
import json, sys
for scene in json.load(sys.stdin)["scenes"]:
    if scene["needs_assets"] and not scene["missing_assets"]: print(scene["name"])')
# A missed target is measured, too.
ask() { "$program" selftest "$@" || [ $? -eq 1 ]; }
{
  UMBRAMETER_ASSETS='' ask --trials 400
  printf '\nWith real models, `umbrameter selftest --benign --scene NAME...`:\n\n'
  ask --benign "${models[@]}"
  printf '\nWhat mends the faults, `umbrameter selftest --causes`:\n\n'
  UMBRAMETER_ASSETS='' ask --causes
} >"$measured" 2>/dev/null
awk -v measured="$measured" '
  /^<!-- measured: scripts\/make_selftest_doc.sh/ { print; print ""; while ((getline line < measured) > 0) print line; print ""; skip = 1 }
  /^<!-- to here -->/ { skip = 0 }
  !skip' docs/selftest.md >"$measured.doc"
cp "$measured.doc" docs/selftest.md
