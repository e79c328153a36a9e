#!/usr/bin/env bash
# Installs what is missing, builds the fuzzers and runs each for five minutes, or for the given number of seconds.
# Inputs that are worth keeping, and those that found something, are left in build/fuzz.
set -euo pipefail
extra_packages=(clang)
. "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"
seconds=${1:-300}

cmake --preset fuzz
cmake --build --preset fuzz
meshes=$PWD/build/fuzz/data/meshes # absent when libcgal-demo is too
cd build/fuzz

# small real files give the readers a start: the first byte chooses the format
mkdir -p corpus_readers corpus_maps
for file in "$meshes"/{tetrahedron,cube_quad,triangle,open_cube}.off; do
  [ ! -f "$file" ] || { printf '\0'; cat "$file"; } > "corpus_readers/$(basename "$file")"
done
printf '\1v 0 0 0 1\nv 1 0 0\nv 1 1 0\nv 0 1 1\nvt 0 0\ng a \\\n b\nf 1/1 2//1 3\nf -4 \\\n -2 -1\n' > corpus_readers/sheet.obj
printf '\2ply\nformat ascii 1.0\nelement vertex 3\nproperty short x\nproperty float y\nproperty double z\nelement face 1\n%s\n' \
  $'property list uchar ushort vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 .5\n3 0 1 2' > corpus_readers/triangle.ply
printf '\3solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid x\n' \
  > corpus_readers/triangle.stl
printf '\5# seams\n0 1\n' > corpus_readers/seams.txt
words=../../test/Square_parameterization/fuzz/readers.dict
# a map of 100 faces takes a hundred times as long as without sanitizers
common=(-max_total_time="$seconds" -timeout=600 -rss_limit_mb=4096 -len_control=0 -print_final_stats=1)
bin/fuzz_readers "${common[@]}" -max_len=2048 -dict="$words" corpus_readers
bin/fuzz_maps "${common[@]}" -max_len=160 corpus_maps
