#!/usr/bin/env bash
# What completion offers at the end of command lines: test_completion.sh SQUARE_MAP COMPLETION
set -u # as in the shells that complete: no -e
program=$(realpath "$1")
. "$2"
cd "$(mktemp -d)"
trap 'rm -r "$PWD"' EXIT
touch a.off a.txt b.json
mkdir folder

# check EXPECTED WORD...: the last word is the one to be completed
check() {
  local expected=$1
  shift
  COMP_WORDS=(square_map "$@") COMP_CWORD=$#
  _square_map "$program" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  local found
  found=$(printf '%s\n' "${COMPREPLY[@]}" | sort | paste -sd ' ')
  [ "$found" = "$expected" ] || { echo "after '$*': '$found', not '$expected'"; exit 1; }
}
check 'a.off folder' ''
check 'b.json' a.off --json b
check 'a.txt' a.off -o a.t
check 'optimal' a.off --minimizer o
check 'best none shortest' a.off --cut ''
check 'fixed' a.off --border=f --border fi
check 'fixed' a.off --border = fi
check 'fixed sliding' a.off --border =
check 'paper' a.off --preset ''
check 'best' a.off --aspect b
check 'checker' a.off --texture che
check 'hybrid' --strategy hy
check '--cut --cut-disk --cut-weight' a.off --cut
check '' a.off --seed ''
# each option is offered
for option in $("$program" --help | sed -n 's/^  \(-[a-z] \[ \)\{0,1\}\(--[a-z-]*\).*/\2/p'); do
  COMP_WORDS=(square_map a.off "$option") COMP_CWORD=2
  _square_map "$program" "$option" a.off
  [[ " ${COMPREPLY[*]} " == *" $option "* ]] || { echo "$option is not offered"; exit 1; }
done
echo passed
