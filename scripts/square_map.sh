#!/usr/bin/env bash
# Installs what is missing, builds the release preset and runs square_map with the given arguments.
# Without arguments it maps a real mesh, the bust of Nefertiti, and writes a page that shows the map.
set -euo pipefail
caller_folder=$PWD
extra_packages=()
. "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"

# a first build needs no tests; a later one keeps what the folder was configured for
configuration=()
[ -f build/CMakeCache.txt ] || configuration=(-DCGAL_EXT_BUILD_TESTS=OFF -DCGAL_EXT_BUILD_BENCHMARKS=OFF)
{
  cmake --preset release "${configuration[@]}"
  cmake --build --preset release --target square_map
} > build.log 2>&1 || { cat build.log >&2; exit 1; }
rm -f build.log

square_map=$PWD/build/bin/square_map
default_mesh=$PWD/build/data/meshes/nefertiti.off
cd "$caller_folder"
if [ $# -eq 0 ]; then
  "$square_map" "$default_mesh" -o nefertiti.obj --report nefertiti.html
  echo "wrote nefertiti.obj, and nefertiti.html to look at in a browser" >&2
  exit
fi
exec "$square_map" "$@"
