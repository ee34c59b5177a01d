#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_selftest_doc.sh: runs the self-test, its benign part on real models, and the causes, and writes what they print into
# docs/selftest.md. Needs UMBRAMETER_ASSETS; about six minutes of two idle cores.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${UMBRAMETER:-build/ci/cli/umbrameter}
measured=$(mktemp)
trap 'rm -f "$measured" "$measured.doc"' EXIT
# A missed target is measured, too.
ask() { "$program" selftest "$@" || [ $? -eq 1 ]; }
{
  UMBRAMETER_ASSETS='' ask --trials 400
  printf '\nWith real models, `umbrameter selftest --benign --assets-too`:\n\n'
  ask --benign --assets-too
  printf '\nWhat mends the faults, `umbrameter selftest --causes`:\n\n'
  UMBRAMETER_ASSETS='' ask --causes
} >"$measured" 2>/dev/null
awk -v measured="$measured" '
  /^<!-- measured: scripts\/make_selftest_doc.sh/ { print; print ""; while ((getline line < measured) > 0) print line; print ""; skip = 1 }
  /^<!-- to here -->/ { skip = 0 }
  !skip' docs/selftest.md >"$measured.doc"
cp "$measured.doc" docs/selftest.md
