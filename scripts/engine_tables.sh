#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# engine_tables.sh [FOLDER]: runs studies/engines.toml into FOLDER (default out/engines; what is there already stays), and writes the
# tables of docs/engines.md. Needs scripts/install_engines.sh and a build; UMBRAMETER names the program (default ./umbrameter).
set -euo pipefail
cd "$(dirname "$0")/.."
umbrameter=${UMBRAMETER:-./umbrameter}
out=${1:-out/engines}
"$umbrameter" sweep studies/engines.toml --out "$out" || [ $? -eq 1 ]  # 1: a run failed, and its row says why
"$umbrameter" export "$out" --csv --out "$out.csv"
python3 scripts/engine_tables.py "$out.csv" docs/engines.md
