#!/usr/bin/env bash
# Compiles answers.cpp against one installed library with the options that users have, and compares what it answers:
# flags.sh PREFIX EIGEN_INCLUDE_DIR LIBRARIES. What is refused must be refused with a word.
set -euo pipefail
prefix=$1 eigen=$2 libraries=$3
source=$(dirname "${BASH_SOURCE[0]}")/answers.cpp
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

archive=$(find "$prefix" -name 'libfirst_contact_geometry.*' | head -n 1)
compile() { # compiler options ... -> program's name
  local compiler=$1 program
  program=$work/$(printf '%s' "$*" | tr -c 'A-Za-z0-9' _)
  # shellcheck disable=SC2086
  "$1" -std=c++20 "${@:2}" -I "$prefix/include" -isystem "$eigen" "$source" "$archive" $libraries -pthread -o "$program"
  "$program"
}
export -f compile
export prefix eigen libraries source work archive

variants=()
for compiler in g++ clang++; do
  command -v "$compiler" >/dev/null || continue
  for options in -O0 -O3 "-O2 -mavx2 -mfma" "-O2 -march=native" "-O2 -DEIGEN_DONT_VECTORIZE" "-O2 -DNDEBUG" "-O1 -std=c++2b"; do
    case $options in *-m*) [[ $(uname -m) == x86_64 ]] || continue ;; esac
    variants+=("$compiler $options")
  done
done

printf '%s\n' "${variants[@]}" |
  xargs -P 2 -I{} bash -c 'printf "%s %s\n" "$(compile $1 2>"$work/log.$$" || tail -n 3 "$work/log.$$")" "$1"' _ {} | sort | tee "$work/all"
answers=$(cut -d' ' -f1 "$work/all" | sort -u | wc -l)
((answers == 1)) || { echo "the answers depend on the options"; exit 1; }
(($(wc -l <"$work/all") == ${#variants[@]})) || { echo "a variant is missing"; exit 1; }

for compiler in g++ clang++; do
  command -v "$compiler" >/dev/null || continue
  if compile "$compiler" -ffast-math >/dev/null 2>"$work/refused"; then echo "-ffast-math: must be refused"; exit 1; fi
  grep -q 'does not work with -ffast-math' "$work/refused" || { cat "$work/refused"; exit 1; }
done
