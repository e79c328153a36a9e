#!/usr/bin/env bash
# Installs what is missing, builds the release preset and runs square_map with the given arguments.
# Without arguments it maps a real mesh, the bust of Nefertiti, and writes a page that shows the map.
set -euo pipefail
extra_packages=()
. "$(dirname "${BASH_SOURCE[0]}")/build_square_map.sh"

if [ $# -eq 0 ]; then
  "$square_map" "$repository/build/data/meshes/nefertiti.off" -o nefertiti.obj --report nefertiti.html
  echo "wrote nefertiti.obj, and nefertiti.html to look at in a browser" >&2
  exit
fi
exec "$square_map" "$@"
