#!/usr/bin/env bash
# Installs what is missing, builds the fuzzers and runs each for five minutes, or for the given number of seconds.
# Inputs that are worth keeping, and those that found something, are left in build/fuzz.
#
# With address and undefined behaviour sanitizers: fuzz_readers, fuzz_maps, fuzz_surfaces, and fuzz_command.py with
# square_map. With the thread sanitizer: the tests of threads and searches, fuzz_surfaces on four threads, and
# fuzz_command.py with square_map.
set -euo pipefail
extra_packages=(clang python3 catch2)
. "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"
seconds=${1:-300}

cmake --preset fuzz
cmake --build --preset fuzz
cmake --preset thread-sanitizer
cmake --build --preset thread-sanitizer
meshes=$PWD/build/fuzz/data/meshes # absent when libcgal-demo is too
fuzz_command=$PWD/test/Square_parameterization/fuzz/fuzz_command.py
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
printf '\5# seams\n0 1\n6 2\n' > corpus_readers/seams.txt
# a triangle without a keyword, and with one that is glued to the first count; blanks behind a backslash
triangle='3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'
printf '\0\n'"$triangle" > corpus_readers/without_keyword.off
printf '\0OFF'"$triangle" > corpus_readers/glued_keyword.off
printf '\1v 0 0 \\ \n 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 \\' > corpus_readers/blanks.obj
# the same triangle in binary
head='ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty char y\nproperty short z\n'
printf '\2'"$head"'element face 1\nproperty list uchar ushort vertex_index\nend_header\n\0\0\0\0\1\0\0\0\0\1\0\0\3\0\0\1\0\2\0' \
  > corpus_readers/binary.ply
zero='\0\0\0\0' one='\x3f\x80\0\0'
printf '\0OFF BINARY\n\0\0\0\3\0\0\0\1\0\0\0\0'"$zero$zero$zero$one$zero$zero$zero$one$zero"'\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\0' \
  > corpus_readers/binary.off
little_one='\0\0\x80\x3f'
{ printf '\3'; head -c 80 /dev/zero; printf '\1\0\0\0'"$zero$zero$zero$zero$zero$zero$little_one$zero$zero$zero$little_one$zero"'\0\0'; } \
  > corpus_readers/binary.stl
words=../../test/Square_parameterization/fuzz/readers.dict
# a map of 100 faces takes a hundred times as long as without sanitizers
common=(-max_total_time="$seconds" -timeout=600 -rss_limit_mb=4096 -len_control=0 -print_final_stats=1)
bin/fuzz_readers "${common[@]}" -max_len=2048 -dict="$words" corpus_readers
bin/fuzz_maps "${common[@]}" -max_len=160 corpus_maps

# other surfaces and moments each time; every line names its seed, which gives the same ones again
seed=$(date +%s)
disturbances=(--disturbances signals,reader,time-limit --seed "$seed" --seconds "$seconds")
bin/fuzz_surfaces --seed "$seed" --seconds "$seconds"
"$fuzz_command" bin/square_map "${disturbances[@]}"

# the thread sanitizer of g++ 12 wants the addresses that a kernel gives without randomization
fixed=()
! setarch -R true 2> /dev/null || fixed=(setarch -R)
cd ../thread_sanitizer
"${fixed[@]}" bin/flat_core_tests "*team*,*thread*"
"${fixed[@]}" bin/search_tests
"${fixed[@]}" bin/random_surfaces --seed "$seed" --seconds "$seconds" --threads 4 --faces 100
# two signals at once end the process with threads that nobody has joined: that is no leak
TSAN_OPTIONS=report_thread_leaks=0 "${fixed[@]}" "$fuzz_command" bin/square_map "${disturbances[@]}"
