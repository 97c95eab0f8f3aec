# The options of verify, bench and mutants, looked at before anything is built or installed. Each takes the words that
# follow the command.

must_be_whole() {  # COMMAND OPTION VALUE LEAST MOST
  [[ "$3" =~ ^[0-9]{1,15}$ ]] && ((10#$3 >= $4 && 10#$3 <= $5)) ||
    { say "course: $1 $2 '$3': must be a whole number from $4 to $5"; exit 2; }
}
must_be_once() {  # COMMAND OPTION, and the options before it in $given
  [[ "$given " != *" $2 "* ]] || { say "course: $1 $2: must be given only once"; exit 2; }
  given="$given $2"
}

verify_options() {
  local given=""
  while (($#)); do
    case "$1" in
      --count=* | --seed=*) set -- "${1%%=*}" "${1#*=}" "${@:2}"; continue ;;
      --count | --seed)
        must_be_once verify "$1"
        must_be_whole verify "$1" "${2-}" 0 999999999999999
        shift ;;
      *) say "course: verify '$1': must be --count or --seed, and a whole number"; exit 2 ;;
    esac
    shift
  done
}

bench_options() {
  local given=""
  while (($#)); do
    case "$1" in
      --out=* | --judged=* | --repetitions=* | --sides=*) set -- "${1%%=*}" "${1#*=}" "${@:2}"; continue ;;
      --out | --judged | --repetitions | --sides) must_be_once bench "$1" ;;
    esac
    case "$1" in
      --own) set -- "" "$@" ;;
      --out) [[ -n "${2-}" && "$2" != --* ]] || { say "course: bench --out '${2-}': must name a folder"; exit 2; } ;;
      --judged) must_be_whole bench --judged "${2-}" 1 5000 ;;
      --repetitions) must_be_whole bench --repetitions "${2-}" 1 1000000 ;;
      --sides)
        must_be_whole bench --sides "${2-}" 1 11585  # of two triangles each: a tree holds 2^28
        while [[ "${3-}" == [0-9]* ]]; do must_be_whole bench --sides "$3" 1 11585; shift; done ;;
      *) say "course: bench '$1': must be --repetitions N, --sides N ..., --judged N, --out DIR or --own"; exit 2 ;;
    esac
    shift 2
  done
}

mutants_options() {
  local given="" least
  while (($#)); do
    case "$1" in
      --count=* | --seed=* | --jobs=*) set -- "${1%%=*}" "${1#*=}" "${@:2}"; continue ;;
      --count | --seed | --jobs)
        must_be_once mutants "$1"
        [[ "$1" == --seed ]] && least=0 || least=1
        must_be_whole mutants "$1" "${2-}" "$least" 1000000
        shift ;;
      *) [[ -n "$1" && "$1" != -* && ( -e "common/first_contact/$1" || -e "$1" ) ]] ||
           { say "course: mutants '$1': must be a folder or a file of common/first_contact, or --count, --seed or --jobs"; exit 2; } ;;
    esac
    shift
  done
}
