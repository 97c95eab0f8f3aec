#!/usr/bin/env bash
# What a student and an instructor meet: every verdict in its own word, refusals, a copy, a class.
#   bash tests/workbook/verdicts.sh ROOT
set -uo pipefail
cd "$1" || exit
failed=0 passed=0
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

check() {  # NAME, then a command that must succeed
  local name=$1
  shift
  if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $name"; fi
}
says() { [[ "$1" == *"$2"* ]] || { printf '%s\n' "$1"; return 1; }; }
refused() {  # ARGUMENTS: one line, status 2
  local said status
  said=$(./course "$@" 2>&1)
  status=$?
  [[ $status == 2 && $(printf '%s\n' "$said" | wc -l) -eq 1 && "$said" == *"must be"* ]] || { printf '%s\n' "$said"; return 1; }
}

check "an unknown exercise is refused" refused check 9z
check "a file that is not there is refused" refused check 1a "$place/none.hpp"
check "too many words are refused" refused check 1a "$place" "$place"
check "a copy needs a folder" refused workbook
check "a copy does not go where something is" refused workbook chapters
check "an unknown option is refused" refused workbook --all
check "solutions need a folder" refused workbook --solutions
check "a class that is not there is refused" refused grade "$place/none"
check "a class must be named" refused grade

(cd "$place" && "$OLDPWD/course" workbook "$place/copy") >"$place/said" 2>&1
check "a copy is made" [ -f "$place/copy/chapters/01_plane/exercises/1a/task.md" ]
check "without solutions" eval '! find "$place/copy" | grep -q solution'
check "its tasks are plain Markdown" eval '! grep -rqF -e "{{" -e "\\" -e ".md)" --include=task.md "$place/copy"'

# Everything below is typed into the copy, which holds all that it needs.
head='std::optional<double> touch_time(Plane E, Point S0, Vector V, double r)'
verdict() {  # WORDS, then what is typed
  local words=$1
  shift
  printf '#include "task.hpp"\n%s\n' "$*" >"$place/my.hpp"
  says "$(cd "$place" && copy/course check 1a my.hpp 2>&1)" "$words"
}
ln -s "$place/copy/course" "$place/by_link"
check "a copy works by a link" says "$(cd / && "$place/by_link" progress 2>&1)" "1a"
check "an exercise without a name is refused" eval '! (cd "$place" && copy/course check "" >/dev/null 2>&1)'
check "no escape reaches the terminal" eval '! (cd "$place" && copy/course $'"'"'\e[31mred'"'"' 2>&1) | grep -q $'"'"'\e'"'"''
printf '%s\n' '#include "task.hpp"' 'double effective_radius(const Box& box, Vector N) {
  return (std::abs(dot(N, box.R)) + std::abs(dot(N, box.S)) + std::abs(dot(N, box.T))) / 2; }' >"$place/2a.hpp"
check "after an exercise comes the next one" says "$(cd "$place" && copy/course check 2a 2a.hpp 2>&1)" "next        2b"
check "as handed out" says "$(cd "$place" && copy/course check 2>&1)" "as shipped"
check "an index out of range" verdict "a crash (" "$head { std::vector<double> a(3); return a[7]; }"
check "an empty optional" verdict "a crash (" "$head { std::optional<double> t; return *t; }"
check "a recursion without end" verdict "a crash (" "$head { return touch_time(E, S0, V, r).value() + 1; }"
check "an endless loop" verdict "an endless loop" "$head { for (volatile int i = 0;;) i = i; }"
check "not a number" verdict "(NaN) came out" "$head { return std::sqrt(-1 - r); }"
check "an exception" verdict "an exception: not yet" "#include <stdexcept>
$head { throw std::runtime_error(\"not yet\"); }"
check "an end" verdict "the program ended itself" "#include <cstdlib>
$head { std::exit(0); }"
check "all memory" verdict "more memory than there is" "$head { std::vector<double> a; for (;;) a.resize(2 * a.size() + 1); }"
check "a slip is shown short, with its line" verdict "my.hpp:2:" "$head { double t = 1 return t; }"
check "another name is explained" verdict "must keep its name" "std::optional<double> touchtime(Plane, double) { return 1; }"
check "what is not there to be linked" verdict "undefined" "double more(double); $head { return more(r); }"
check "what is printed is shown" verdict "you printed here" "#include <iostream>
$head { std::cout << \"here\\n\"; return r; }"
check "a flood of words hurts nobody" verdict "expected" "#include <iostream>
$head { for (int i = 0; i < 30000; ++i) std::cerr << \"much to say\\n\"; return r; }"
check "a program of one's own beside it" verdict "right" "static std::optional<double> touch_time(const Plane& e, const Point& s, Vector v, float)
  ; int main() { return 0; }
static std::optional<double> touch_time(const Plane& e, const Point& s, Vector v, double r) {
  const double l = norm(e.N), gap = dot(e, s) / l - r, way = dot(e.N, v) / l;
  if (gap + way > 0) return {};
  return -gap / way; }"

mkdir -p "$place/class"/{ann/1a,bob,cy/1a,di,eve/1a,'f"x'}
answer='#include "task.hpp"
'"$head"
printf '%s { if (dot(E, S0 + V) > r * norm(E.N)) return {}; return (dot(E, S0) - r * norm(E.N)) / -dot(E.N, V); }' "$answer" >"$place/class/ann/1a/answer.hpp"
printf '#include <cstdlib>\n#include <filesystem>\n%s { std::filesystem::remove_all("%s"); return 1; }' "$answer" "$place/class/ann" >"$place/class/bob/1a.hpp"
printf '#include "%s/class/ann/1a/answer.hpp"\n' "$place" >"$place/class/cy/1a/answer.hpp"
printf '%s { for (volatile int i = 0;;) i = i; }' "$answer" >"$place/class/di/1a.cpp"
printf '%s { return }' "$answer" >"$place/class/eve/1a/answer.hpp"
table=$(./course grade "$place/class" 2>&1)
row_of() { printf '%s\n' "$table" | grep "^$1 "; }
check "a right answer" says "$(row_of ann)" " 1a:right"
if [[ "$table" == *"a room of its own"* ]]; then
  check "another's folder cannot be removed" [ -f "$place/class/ann/1a/answer.hpp" ]
  check "another's answer cannot be included" says "$(row_of cy)" " 1a:includes"
else
  check "who shuts nobody in says so" says "$table" "Students' programs are shut in: no"
fi
check "who hangs is told so" says "$(row_of di)" " 1a:endless"
check "what does not compile" says "$(row_of eve)" " 1a:compile"
check "nothing handed in" says "$(row_of 'f"x')" " 1a:-"
check "the table as JSON" grep -qF '"ann": {"right": 1, "answers": {"1a": "right"' build/workbook/grades.json

echo "workbook: $passed passed, $failed failed"
exit $((failed > 0))
