#!/usr/bin/env bash
# Brute force over the corners of one mesh, in slices, on all cores or on several machines:
#
#   scripts/brute_force_on_many.sh MESH WORK [--hosts FILE] [options of square_map]
#
# The outputs are those of `square_map MESH --strategy brute-force [options]`, byte for byte but for the times in the
# report. WORK is a folder for the reports of the slices: the same call goes on where an earlier one was stopped or killed.
#
#   --strategy NAME   brute-force, the default, or quarter-brute-force
#   --hosts FILE      machines that share MESH, WORK and this folder, as map_folder.sh takes them
#
# With SQUARE_MAP in the environment that program is used, and nothing is installed or built.
# Status: that of square_map; 2 also for a call that makes no sense.
set -euo pipefail
export CALLED=brute_force_on_many.sh
. "$(dirname "${BASH_SOURCE[0]}")/folder/run_jobs.sh"

tell_help "${BASH_SOURCE[0]}" "$@"
if [ $# -lt 2 ] || [ -z "$1" ] || [ -z "$2" ]; then
  fail "it takes MESH, and WORK, a folder for the reports of the slices; --help says more"
fi
mesh=$1 work=$(realpath -m -- "$2")
shift 2
options=()
while [ $# -gt 0 ]; do
  case $1 in
    --hosts)
      [ $# -gt 1 ] || fail "$1 needs a value"
      take_hosts "$2"
      shift 2
      ;;
    *) options+=("$1"); shift ;;
  esac
done

find_square_map

plan=$(python3 "$tools/slices.py" plan "$square_map" "$mesh" "$work" --machines "$machines" -- "${options[@]}")
read -r _ jobs memory words < <(grep '^jobs ' <<< "$plan")
prepare_jobs "$square_map" "$work"
sed -n 's/^slice //p' <<< "$plan" | run_jobs "$jobs" 100 "$memory" slices.py map $words
exec python3 "$tools/slices.py" finish "$square_map" "$mesh" "$work" -- "${options[@]}"
