# The workbook: exercises are built, asked and judged here, with a compiler alone. Used by the course and by a student's copy.

compiler=${CXX:-c++}
made=build/workbook/$(basename "$compiler")
solutions=${SOLUTIONS:-tests/workbook/solutions}
progress_file=.progress

exercises() { local folder; for folder in chapters/[0-9][0-9]_*/exercises/*/; do basename "$folder"; done; }
folder_of() { local folder; for folder in chapters/[0-9][0-9]_*/exercises/"$1"/; do printf '%s\n' "${folder%/}"; done; }
title_of() { sed -n '1s/^# Exercise //p' "$(folder_of "$1")/task.md"; }

must_be_exercise() {
  [[ "$1" != *" "* && " $(exercises | tr '\n' ' ')" == *" $1 "* ]] || { say "course: exercise '$1': must be one of $(exercises | tr '\n' ' ')"; exit 2; }
}
must_be_readable() {
  [[ -f "$1" && -r "$1" ]] || { say "course: answer '$1': must be a file that can be read"; exit 2; }
}
# What is included goes to the compiler between quotation marks, which know no escapes.
must_be_includable() {
  [[ "$2" != *[\"[:cntrl:]]* && "$2" != *\\ ]] ||
    { say "course: $1 '$2': must have no quotation mark, no control character and no backslash at the end of its name"; exit 2; }
}

# An index out of range and an empty optional are to end the program, with either standard library.
compile() {
  "$compiler" -std=c++20 -O1 -ffp-contract=off -D_GLIBCXX_ASSERTIONS \
    -D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_FAST -I chapters "$@"
}

# Is the first file there, and newer than all the others?
is_newer() {
  local file=$1 other
  shift
  [[ -f "$file" ]] || return 1
  for other in "$@"; do [[ "$file" -nt "$other" ]] || return 1; done
}

# The parts of the judge that know no exercise: built once.
build_judges_parts() {
  command -v "$compiler" >/dev/null || { say "course: compiler $compiler: must be there, e.g. g++ or clang++ (CXX=...)"; exit 1; }
  must_be_includable folder "$root"
  mkdir -p "$made"
  local source object running=0
  local parts="value sheet verdict shrink student report drawing run"
  for source in $parts; do
    object=$made/$source.o
    is_newer "$object" chapters/workbook/*.hpp "chapters/workbook/$source.cpp" && continue
    ((running > 0)) || say "Building what judges, once ..."
    rm -f "$object"
    { compile -c "chapters/workbook/$source.cpp" -o "$object.$$" && mv "$object.$$" "$object"; } &
    running=$((running + 1))
    ((running % 2)) || wait
  done
  wait
  for source in $parts; do [[ -f "$made/$source.o" ]] || exit 1; done
}

# All known answers in one file, each in a namespace of its own.
write_catalogue() {
  local n=0 file list=""
  for file in "$@"; do
    list+="KNOWN(\"$file\", known_$n) "  # from the root on, where the judge runs: a copy may be moved
    [[ "$file" == /* ]] || file=$root/$file
    printf 'namespace known_%d {\n#include "%s"\n}\n' "$n" "$file"
    n=$((n + 1))
  done
  printf 'inline std::vector<Known> catalogue() { return {%s}; }\n' "$list"
}

# The judge of an exercise, with the known answers in these files: build_judge ID NAME FILE...
build_judge() {
  local folder program=$made/$1/$2
  folder=$(folder_of "$1")
  shift 2
  is_newer "$program" "$made"/*.o chapters/workbook/judge.cpp "$folder"/{task,probes}.hpp "$@" && return
  mkdir -p "$program.parts"
  write_catalogue "$@" >"$program.parts/catalogue.hpp"
  compile -I "$folder" -I "$program.parts" chapters/workbook/judge.cpp "$made"/*.o -o "$program.$$" && mv "$program.$$" "$program"
}

# The student's program: build_answer ID FILE PROGRAM. What the compiler says goes to PROGRAM.log.
build_answer() {
  (
    ulimit -t 60 2>/dev/null || true  # not every system has it
    LC_ALL=C compile -Wall -Wfatal-errors -Dmain=main_of_the_student -I "$(folder_of "$1")" "-DANSWER=\"$2\"" ${4:-} \
      chapters/workbook/answer.cpp "$made/value.o" -o "$3" >"$3.log" 2>&1
  )
}

# The first error alone: its place, what it says, the line.
show_error() {
  local log=$1
  if grep -q -e 'undefined reference' -e 'multiple definition' "$log"; then
    grep -m1 -e 'undefined reference' -e 'multiple definition' "$log" | sed 's/^.*: /  /'
  elif grep -q 'error:' "$log"; then
    grep -m1 -A2 'error:' "$log" | sed -e '1s|^.*/\([^/:]*:[0-9]\)|\1|' -e 's/^/  /'
    ! grep -m1 'error:' "$log" | grep -q 'workbook/answer.cpp' ||
      printf '  %s\n' "The function must keep its name, its arguments and what it returns: as in answer.hpp when it came."
  else
    head -n 3 "$log"
  fi
}

check_exercise() {
  local id=${1:-} file folder
  if ((!$#)); then
    id=$(next_exercise)
    [[ -n "$id" ]] || { echo "All exercises are solved."; return; }
  fi
  must_be_exercise "$id"
  [[ $# -le 2 ]] || { say "course: check $3: must be an exercise and at most one file"; exit 2; }
  folder=$(folder_of "$id")
  file=$root/$folder/answer.hpp
  if (($# == 2)); then
    [[ -n "$2" ]] || { say "course: answer '': must be a file that can be read"; exit 2; }
    file=$(of_caller "$2")
  fi
  must_be_readable "$file"
  must_be_includable answer "$file"
  build_judges_parts
  build_judge "$id" judge "$folder"/wrong/*.hpp
  echo "$(title_of "$id")"
  ask_student "$id" "$file"
}

ask_student() {
  local id=$1 file=$2 answer=$made/$1/answer status=0 picture=build/workbook/$1
  if ! build_answer "$id" "$file" "$answer"; then
    printf '  it does not compile:\n'
    show_error "$answer.log"
    remember "$id" "does not compile"
    return 1
  fi
  "$made/$id/judge" --figure "$picture.gp" "$answer" || status=$?
  ((status <= 1)) || { say "course: exercise $id: its judge failed"; return 1; }
  ((status == 0)) || show_warning "$answer.log"
  if command -v gnuplot >/dev/null && LC_ALL=C.UTF-8 gnuplot "$picture.gp" 2>/dev/null; then
    printf '  figure      %s\n' "$picture.svg"
  fi
  if ((status == 0)); then remember "$id" right; else remember "$id" "not yet"; fi
  ((status != 0)) || suggest_next "$id"
  return $status
}

show_warning() {
  ! grep -q 'warning:' "$1" || printf '  compiler    %s\n' "$(grep -m1 'warning:' "$1" | sed 's|^.*/\([^/:]*:[0-9]\)|\1|')"
}

suggest_next() {
  local next
  next=$(next_exercise "$1")
  if [[ -n "$next" ]]; then
    printf '  next        %s: %s\n' "$next" "$(folder_of "$next")/task.md"
  else
    printf '  All exercises are solved.\n'
  fi
}

# What is known of an exercise, in a line each. What was right once stays so.
remember() {
  [[ "$(known_of "$1")" != right ]] || return 0
  touch "$progress_file"
  { grep -v "^$1 " "$progress_file" || true; printf '%s %s\n' "$1" "$2"; } >"$progress_file.new"
  mv "$progress_file.new" "$progress_file"
}
known_of() { [[ ! -f "$progress_file" ]] || sed -n "s/^$1 //p" "$progress_file"; }

# The first that is not solved; the first after this one, if any is: next_exercise [ID]
next_exercise() {
  local id first="" passed=0
  for id in $(exercises); do
    if [[ "$(known_of "$id")" != right ]]; then
      ((!passed)) || { echo "$id"; return; }
      [[ -n "$first" ]] || first=$id
    fi
    [[ "$id" != "${1:-}" ]] || passed=1
  done
  echo "$first"
}

show_progress_of_student() {
  local id solved=0 all=0 mark
  for id in $(exercises); do
    mark=$(known_of "$id")
    all=$((all + 1))
    [[ "$mark" != right ]] || solved=$((solved + 1))
    printf '  %-12s %s\n' "${mark:--}" "$(title_of "$id")"
  done
  echo "$solved of $all are right."
}

# What was handed out, also where somebody has written an answer in its place.
handed_out() {
  local stub out=$made/$1/handed_out
  stub=$(folder_of "$1")/answer.hpp
  if git diff --quiet HEAD -- "$stub" 2>/dev/null || ! mkdir -p "$out" || ! git show "HEAD:./$stub" >"$out/answer.hpp" 2>/dev/null; then
    printf '%s\n' "$stub"
  else
    printf '%s\n' "$out/answer.hpp"
  fi
}

# Do stub, wrong answers and solutions draw what they should? For one exercise, or all.
prove_exercises() {
  local id folder status=0
  (($# <= 1)) || { say "course: prove $1 '$2': must be one exercise"; exit 2; }
  (($# == 0)) || [[ "$1" == parts ]] || must_be_exercise "$1"
  build_judges_parts
  [[ "${1:-}" != parts ]] || return 0
  for id in ${1:-$(exercises)}; do
    folder=$(folder_of "$id")
    [[ -d "$solutions/$id" ]] || { say "course: solutions of $id: must be in $solutions/$id (SOLUTIONS=...)"; exit 2; }
    build_judge "$id" prove "$folder"/wrong/*.hpp "$(handed_out "$id")" "$solutions/$id"/*.hpp
    printf '%s: ' "$id"
    "$made/$id/prove" --prove || status=1
  done
  return $status
}
