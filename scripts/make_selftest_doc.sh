#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# make_selftest_doc.sh: runs the self-test, and its benign part on real models too, and writes what they print into
# docs/selftest.md. Needs UMBRAMETER_ASSETS; minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${UMBRAMETER:-build/ci/cli/umbrameter}
measured=$(mktemp)
trap 'rm -f "$measured" "$measured.doc"' EXIT
{
  UMBRAMETER_ASSETS='' "$program" selftest || [ $? -eq 1 ]
  printf '\nWith real models, `umbrameter selftest --benign --assets-too`:\n\n'
  "$program" selftest --benign --assets-too || [ $? -eq 1 ]
} >"$measured" 2>/dev/null
awk -v measured="$measured" '
  /^<!-- measured: scripts\/make_selftest_doc.sh/ { print; print ""; while ((getline line < measured) > 0) print line; print ""; skip = 1 }
  /^<!-- to here -->/ { skip = 0 }
  !skip' docs/selftest.md >"$measured.doc"
cp "$measured.doc" docs/selftest.md
