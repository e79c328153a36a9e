#!/usr/bin/env bash
# Maps every mesh below a folder, on all cores, or on several machines:
#
#   scripts/map_folder.sh IN OUT [--hosts FILE] [--part K/N] [options of square_map]
#
# Each mesh IN/a/b.off gets a folder OUT/a/b.off with map.obj, map.html, thumbnail.png, report.json and log.txt, or with
# log.txt alone where it has no map. OUT/index.html shows all of them, OUT/summary.csv has their figures. The same call
# goes on where an earlier one was stopped or killed, and tries again what had no map; what it makes are the same bytes as
# in one go, but for the columns seconds and memory_mib of the table.
#
#   -o .glb, --report none       other outputs for each mesh: -o, --report, --svg, --image, --normal-map, --attributes and
#                                --grid-mesh take the ending of the files; none leaves out the map or the page
#   --threads N                  threads of each map; without it one, more for a mesh that is a large part of the work
#   --hosts FILE                 machines that share IN, OUT and this folder under the same names: a line for each as
#                                `parallel --sshloginfile` reads it, such as user@name; the line : is this machine
#   --part K/N                   the K-th of N parts, counted from 1, as map_folder.slurm calls it
#
# With SQUARE_MAP in the environment that program is used, and nothing is installed or built.
# Status: 0 all meshes (of the parts so far) are mapped; 1 some are not; 2 a call that makes no sense.
set -euo pipefail

export CALLED=map_folder.sh
. "$(dirname "${BASH_SOURCE[0]}")/folder/run_jobs.sh"

tell_help "${BASH_SOURCE[0]}" "$@"
if [ $# -lt 2 ] || [ -z "$1" ] || [ -z "$2" ]; then
  fail "it takes IN, the folder of the meshes, and OUT, the folder of the maps; --help says more"
fi
in=$(realpath -m -- "$1") out=$(realpath -m -- "$2")
shift 2
part=1/1 options=()
while [ $# -gt 0 ]; do
  case $1 in
    --hosts | --part) [ $# -gt 1 ] || fail "$1 needs a value" ;;&
    --hosts) take_hosts "$2"; shift 2 ;;
    --part) part=$2; shift 2 ;;
    *) options+=("$1"); shift ;;
  esac
done

find_square_map

plan=$(python3 "$tools/plan_folder.py" "$square_map" "$in" "$out" --machines "$machines" --part "$part" -- "${options[@]}")
prepare_jobs "$square_map" "$out"
words_of "$square_map" "$in" "$out"
while read -r _ threads jobs percent memory <&3; do
  awk -v threads="$threads" '$1 == "meshes" && $2 == threads { print $3 }' <<< "$plan" |
    run_jobs "$jobs" "$percent" "$memory" map_mesh.py "${words[@]}" "$threads"
done 3< <(grep '^pass ' <<< "$plan")

exec python3 "$tools/write_summary.py" "$in" "$out" "$part"
