#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh PRESET [TARGET...]: installs packages, configures and builds; the one place that knows how.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=$1
shift
bash scripts/install_packages.sh
export CCACHE_SLOPPINESS=pch_defines,time_macros
export CCACHE_BASEDIR="$PWD"  # no object holds the path of the sources
cmake --preset "$preset" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
cmake --build --preset "$preset" ${1:+--target "$@"}
