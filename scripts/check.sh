#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# check.sh [--spelling]: what can be checked without a build: format, arrows between rooms, spelling (or that alone; 3 when
# codespell is missing). For a pre-commit hook: ln -s ../../scripts/check.sh .git/hooks/pre-commit
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
if [ "${1:-}" != "--spelling" ]; then
  bash scripts/check_format.sh
  python3 tests/architecture/check_includes.py .
fi
if command -v codespell >/dev/null; then
  codespell
else
  echo "check: codespell is not installed: spelling was not looked at" >&2
  [ "${1:-}" != "--spelling" ] || exit 3
fi
