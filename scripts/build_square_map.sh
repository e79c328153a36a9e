#!/usr/bin/env bash
# Installs what is missing and builds the release preset; sourced by the scripts that run square_map, which find it in
# $square_map. With SQUARE_MAP in the environment that program is used, and nothing is installed or built.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
square_map=${SQUARE_MAP:-$repository/build/bin/square_map}
[ -z "${SQUARE_MAP:-}" ] || return 0

caller_folder=$PWD
. "$repository/scripts/set_up.sh"
# a first build needs no tests; a later one keeps what the folder was configured for
configuration=()
[ -f build/CMakeCache.txt ] || configuration=(-DCGAL_EXT_BUILD_TESTS=OFF -DCGAL_EXT_BUILD_BENCHMARKS=OFF)
{
  cmake --preset release "${configuration[@]}"
  cmake --build --preset release --target square_map
} > build.log 2>&1 || { cat build.log >&2; exit 1; }
rm -f build.log
cd "$caller_folder"
