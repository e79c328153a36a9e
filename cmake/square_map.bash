# Completion of square_map for bash. The options, and the names that they take, are those that the program tells itself.
_square_map() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} program=$1 value line
  COMPREPLY=()
  [ "$before" != = ] || before=${COMP_WORDS[COMP_CWORD - 2]}
  if [ "$word" = = ]; then
    word='' before=${COMP_WORDS[COMP_CWORD - 1]}
  fi
  [ "$before" != -o ] || before=--output
  # the kind of value of the option before, if it takes one: NAME, FILE, N, ...
  value=$("$program" --help 2> /dev/null | sed -n "s/^  \(-[a-z] \[ \)\{0,1\}$before\( \]\)\{0,1\} \([^ ]*\).*/\3/p")
  case $before:$value in
    -*:*FILE) mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;&
    --texture:*) mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -W checker -- "$word") ;;
    --aspect:*) mapfile -t COMPREPLY < <(compgen -W best -- "$word") ;;
    --component:*) mapfile -t COMPREPLY < <(compgen -W largest -- "$word") ;;
    --preset:* | -*:NAME)
      line=$("$program" - "$before" '?' 2>&1 < /dev/null | sed -n 's/.* is one of: \(.*\); not .*/\1/p')
      mapfile -t COMPREPLY < <(compgen -W "${line//,/}" -- "$word")
      ;;
    -*:*FILE | -*:[A-Za-z]*) ;;
    *)
      case $word in
        -*) mapfile -t COMPREPLY < <(compgen -W "$("$program" --help | grep -o -- '--[a-z][a-z-]*' | sort -u) -o -q -h" -- "$word") ;;
        *)
          mapfile -t COMPREPLY < <(
            compgen -d -- "$word"
            compgen -f -- "$word" | grep -iE '[.](off|obj|ply|stl)$' || true
          )
          ;;
      esac
      ;;
  esac
}
complete -o filenames -F _square_map square_map
