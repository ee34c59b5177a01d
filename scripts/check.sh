#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# check.sh: what can be checked without a build: format, spelling, arrows between rooms. For a pre-commit hook:
#   ln -s ../../scripts/check.sh .git/hooks/pre-commit
set -euo pipefail
cd "$(git rev-parse --show-toplevel)"
bash scripts/check_format.sh
python3 tests/architecture/check_includes.py .
if command -v codespell >/dev/null; then
  codespell
else
  echo "check: codespell is not installed: spelling was not looked at" >&2
fi
