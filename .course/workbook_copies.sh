# A student's own copy of the workbook, an instructor's copy of the solutions, and the grading of many copies.

# A folder of their own, that is not there yet or empty.
must_be_new() {
  [[ -n "$1" ]] || { say "course: $2: must be followed by a folder that is made for it"; exit 2; }
  [[ ! -e "$1" || ( -d "$1" && -z "$(ls -A "$1")" ) ]] || { say "course: $2 $1: must be a folder that is not there yet, or empty"; exit 2; }
  mkdir -p "$1" 2>/dev/null && [[ -w "$1" ]] || { say "course: $2 $1: must be in a folder that can be written to"; exit 2; }
}

# The stub as it was committed, if that is known: not what somebody has written into it since.
stub_of() { git show "HEAD:./$1" 2>/dev/null || cat "$1"; }

# A task as plain Markdown: what only the notes can show is left out.
plain_task() {
  sed -e '/^\\folded /d' -e 's/\[\([^]]*\)\]([^)]*\.md[^)]*)/\1/g' -e 's/\\vec //g' -e 's/\\abs{\([^}]*\)}/|\1|/g' -e 's/\\norm{\([^}]*\)}/|\1|/g' \
    -e 's/\\tfrac\([0-9]\)\([0-9]\)/\1\/\2/g' -e 's/\\cdot/·/g' -e 's/\\times/×/g' -e 's/\\infty/∞/g' -e 's/\\varepsilon/ε/g' \
    -e 's/\\le/≤/g' -e 's/\\ge/≥/g' -e 's/\\[,;]/ /g' "$1" | cat -s
}

copy_workbook() {
  local to folder file
  [[ $# -le 1 ]] || { say "course: workbook $2: must be one folder, or --solutions and a folder"; exit 2; }
  to=$(of_caller "${1:-}")
  [[ -n "${1:-}" ]] || to=""
  must_be_new "$to" workbook
  mkdir -p "$to/.course" "$to/chapters"
  cp -R chapters/workbook "$to/chapters/"
  cp .course/words.sh .course/workbook.sh "$to/.course/"
  cp .course/copy/course .course/copy/README.md LICENSE "$to/"
  printf '/build/\n/.progress\n' >"$to/.gitignore"
  for folder in chapters/[0-9][0-9]_*/exercises/*/; do
    folder=${folder%/}
    mkdir -p "$to/$folder"
    cp -R "$folder"/{task.hpp,probes.hpp,wrong} "$to/$folder/"
    stub_of "$folder/answer.hpp" >"$to/$folder/answer.hpp"
    plain_task "$folder/task.md" >"$to/$folder/task.md"
  done
  begin_history "$to"
  echo "The workbook is in $to. Begin there with: ./course check"
}

begin_history() {
  command -v git >/dev/null || { say "git is not there: the copy has no history"; return; }
  git -C "$1" init -q && git -C "$1" add -A &&
    git -C "$1" -c user.name="First Contact" -c user.email=workbook@localhost commit -qm "The workbook as it was handed out"
}

copy_solutions() {
  must_be_new "${1:+$(of_caller "$1")}" "workbook --solutions"
  local to
  to=$(of_caller "$1")
  [[ -d "$solutions" ]] || { say "course: solutions $solutions: must be a folder (SOLUTIONS=...)"; exit 2; }
  cp -R "$solutions"/. "$to/"
  echo "The solutions are in $to. Without tests/workbook/solutions the course does all but prove them."
}

workbook() {
  case "${1:-}" in
    --solutions) [[ $# -le 2 ]] || { say "course: workbook --solutions $3: must be one folder"; exit 2; }
                 copy_solutions "${2:-}" ;;
    -*) say "course: workbook $1: must be a folder, or --solutions and a folder"; exit 2 ;;
    *) copy_workbook "$@" ;;
  esac
}

# --- grading ------------------------------------------------------------------------------------------------------

# Where a student's answer is: as in the copy, in a folder of the exercise's name, or a file of that name.
answer_of_student() {
  local place
  for place in "$1"/chapters/*/exercises/"$2"/answer.hpp "$1/$2/answer.hpp" "$1/$2.hpp" "$1/$2.cpp"; do
    [[ ! -f "$place" ]] || { printf '%s\n' "$place"; return; }
  done
}

# Does an answer include anything but the compiler's headers, what it is given, and what lies beside it? Names the first.
includes_elsewhere() {
  local header place room=$3
  for header in $(LC_ALL=C compile -M -I "$(folder_of "$1")" "$2" 2>/dev/null | tr -d '\\' | tr ' ' '\n' | grep / || true); do
    place=$(cd "$(dirname "$header")" 2>/dev/null && pwd -P)/
    case "$place" in
      "$room"/* | "$root/chapters/workbook"/* | "$root/$(folder_of "$1")"/ | /usr/* | /opt/* | /Library/* | /Applications/*) ;;
      *) is_of_compiler "$place" || { printf '%s\n' "$header"; return; } ;;
    esac
  done
}

# Where the compiler looks for headers of its own, a folder a line: not every system keeps them in /usr.
folders_of_compiler() {
  local folder
  { LC_ALL=C "$compiler" -E -x c++ -v /dev/null 2>&1 || true; } | sed -n '/^#include </,/^End of/s/^ //p' |
    while IFS= read -r folder; do (cd "${folder% (framework directory)}" 2>/dev/null && pwd -P) || true; done
}
is_of_compiler() {
  local folder
  while IFS= read -r folder; do
    [[ -z "$folder" || "$1" != "$folder"/* ]] || return 0
  done <<<"$compilers_own"
  return 1
}

# What shuts a program in: a room with nothing else in it and no network, or without network alone, or nothing.
find_walls() {
  local room=$1
  walls=() walls_are="none: unshare does not work here" inside=
  if printf 'int main() {}\n' | compile -static -x c++ - -o "$room/answer" 2>/dev/null &&
     unshare -c -n -p -f --kill-child -R "$room" /answer 2>/dev/null; then
    walls=(unshare -c -n -p -f --kill-child -R) walls_are="a room of its own, without network" inside=-static
  elif unshare -rn true 2>/dev/null; then
    walls=(unshare -rn) walls_are="no network"
  fi
}

# One word for one answer. It is built and asked in a room where there is nothing else.
grade_answer() {
  local id=$1 file=$2 room=$3 elsewhere verdict
  rm -rf "$room"
  mkdir -p "$room"
  cp "$file" "$room/answer.hpp"
  elsewhere=$(includes_elsewhere "$id" "$room/answer.hpp" "$room")
  [[ -z "$elsewhere" ]] || { echo "includes"; return; }
  build_judge "$id" judge "$(folder_of "$id")"/wrong/*.hpp
  build_answer "$id" "$room/answer.hpp" "$room/answer" "$inside" || { echo "compile"; return; }
  local command=("$room/answer")
  [[ -z "$inside" ]] || command=("${walls[@]}" "$room" /answer)
  [[ -n "$inside" || -z "${walls[*]-}" ]] || command=("${walls[@]}" "$room/answer")
  verdict=$("$made/$id/judge" --brief --seconds 5 "${command[@]}" 2>/dev/null) || true
  printf '%s\n' "${verdict:-judge}"
}

grade() {
  local from=${1:-} student id file word line json
  [[ -n "$from" && $# -le 1 ]] || { say "course: grade '${*:-}': must be one folder of students' folders"; exit 2; }
  from=$(of_caller "$from")
  [[ -d "$from" ]] || { say "course: grade $1: must be a folder of students' folders"; exit 2; }
  [[ -n "$(find "$from" -mindepth 1 -maxdepth 1 -type d | head -n 1)" ]] || { say "course: grade $1: must be a folder of students' folders"; exit 2; }
  build_judges_parts
  local room
  room=$(mktemp -d)
  remove_at_end "$room"
  room=$(cd "$room" && pwd -P)
  find_walls "$room"
  compilers_own=$(folders_of_compiler)
  say "Students' programs are shut in: $walls_are; 1 GB of memory and 5 s for an answer each."
  json=build/workbook/grades.json
  { printf '{"walls": "%s", "students": {' "$walls_are"; } >"$json"
  local comma="" marks right
  for student in "$from"/*/; do
    [[ -d "$student" ]] || continue
    student=${student%/}
    marks="" right=0 line=""
    for id in $(exercises); do
      file=$(answer_of_student "$student" "$id")
      word=-
      [[ -z "$file" ]] || word=$(grade_answer "$id" "$file" "$room/$id")
      [[ "$word" != right ]] || right=$((right + 1))
      marks+="${marks:+, }\"$id\": \"$word\""
      line+=" $id:$word"
    done
    printf '%-20s %3d of %d %s\n' "$(printable "$(basename "$student")")" "$right" "$(exercises | wc -l)" "$line"
    printf '%s\n"%s": {"right": %d, "answers": {%s}}' "$comma" "$(quoted "$(basename "$student")")" "$right" "$marks" >>"$json"
    comma=,
  done
  printf '\n}}\n' >>"$json"
  echo "The same as JSON: $json"
}

printable() { printf '%s' "$1" | LC_ALL=C tr -d '\000-\037\177'; }
quoted() { printable "$1" | sed 's/[\\"]/\\&/g'; }
