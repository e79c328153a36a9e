#!/usr/bin/env bash
# Runs jobs with GNU parallel, here or on several machines; sourced by map_folder.sh and brute_force_on_many.sh.
# Names pass through it as words of plain ASCII, which meshes.py makes.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
hosts=() machines=1

fail() {
  echo "$CALLED: $*" >&2
  exit 2
}

# tell_help SCRIPT [ARGUMENT]...: prints the comment that the script begins with, and ends, when the first argument asks for it
tell_help() {
  [ "${2:-}" = --help ] || [ "${2:-}" = -h ] || return 0
  local help
  help=$(sed -n '2,/^set -euo/{/^#/s/^# \{0,1\}//p}' "$1")
  echo "$help"
  exit
}

# take_hosts FILE: the machines to run on
take_hosts() {
  [ -r "$1" ] || fail "the file of the machines '$1' cannot be read"
  machines=$(grep -cv '^ *\(#\|$\)' "$1") || fail "the file of the machines '$1' names none"
  hosts=(--sshloginfile "$(realpath -- "$1")")
}

# words_of NAME...: a word for each, in $words
words_of() {
  mapfile -t words < <(python3 "$tools/meshes.py" "$@")
}

# find_square_map: installs what jobs need, and sets $square_map
find_square_map() {
  extra_packages=(parallel python3)
  [ ${#hosts[@]} -eq 0 ] || extra_packages+=(openssh-client)
  . "$tools/../build_square_map.sh"
}

# prepare_jobs PROGRAM OUT: finds Python, and that every machine sees the same program and folders
prepare_jobs() {
  export PARALLEL_HOME=$2/.map_folder/parallel PARALLEL_SHELL=/bin/sh
  mkdir -p "$PARALLEL_HOME"
  joblog=$2/.map_folder/joblog
  progress=()
  [ ! -t 2 ] || progress=(--bar)
  if [ ${#hosts[@]} -eq 0 ]; then # the program itself: what stands for it may take longer to start than a small map
    python=$(python3 -c 'import sys; print(sys.executable)')
    return
  fi
  python=python3
  local words
  words_of "$1" "$2"
  local here
  here=$(python3 "$tools/map_mesh.py" --check "${words[@]}")
  parallel --will-cite --quote --nonall --tag "${hosts[@]}" python3 "$tools/map_mesh.py" --check "${words[@]}" |
    awk -F '\t' -v here="$here" '$2 != here { print; exit 1 }' >&2 ||
    fail "each machine must see the meshes, the folders, the scripts and square_map as this one does, under the same names"
}

# run_jobs JOBS PERCENT BYTES SCRIPT WORD...: runs the script with the words and one line of the input; so many jobs at a
# time, or on other machines as many as that percentage of their cores; none is begun while less memory is free
run_jobs() {
  local jobs=$1 percent=$2 memory=$3 script=$4
  shift 4
  [ ${#hosts[@]} -eq 0 ] || jobs=$percent%
  # what became of a job is seen in what it leaves
  parallel --will-cite --quote --ungroup --retries 3 --jobs "$jobs" --memfree "$memory" "${hosts[@]}" "${progress[@]}" \
    --joblog "+$joblog" "$python" "$tools/$script" "$@" '{}' || true
}
