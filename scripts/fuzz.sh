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
words=../../test/Square_parameterization/fuzz/readers.dict
# a map of 100 faces takes a hundred times as long as without sanitizers
common=(-max_total_time="$seconds" -timeout=600 -rss_limit_mb=4096 -len_control=0 -print_final_stats=1)
bin/fuzz_readers "${common[@]}" -max_len=2048 -dict="$words" corpus_readers
bin/fuzz_maps "${common[@]}" -max_len=160 corpus_maps
