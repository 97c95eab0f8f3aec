#!/usr/bin/env bash
# The launcher, without building anything: what it refuses, what it advises on each system, that it works alone, that a
# moved build is noticed.   bash tests/launcher.sh ROOT
set -uo pipefail
cd "$1" || exit
failed=0 passed=0

check() {  # NAME, then a command that must succeed
  local name=$1
  shift
  if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $name"; fi
}
says() { [[ "$1" == *"$2"* ]]; }
silent_of() { [[ "$1" != *"$2"* ]]; }

refused() {  # ARGUMENTS: one line, status 2, nothing printed else
  local said status
  said=$(./course "$@" 2>&1)
  status=$?
  [[ $status == 2 && $(printf '%s\n' "$said" | wc -l) -eq 1 && "$said" == *"must"* ]]
}
check "an unknown format is refused" refused figures --format bmp
check "an unknown theme is refused" refused figures --theme=sepia
check "an unknown language is refused" refused figures --lang fr
check "an option without its value is refused" refused figures --format --theme grey
check "an unknown option is refused" refused figures --colour red
check "an unknown figure is refused" refused figures figure-99
check "a style that is not there is refused" refused figures --style no-such-style.gp
check "the book's own figures are not overwritten by others" refused figures --format pdf --into figures
check "an unknown program is refused" refused run chess
check "an unknown command is refused" refused draw
check "a program that takes no exercise is refused" refused run slide --mine
check "a copy that is none is refused" refused run plane --mine=/no-such-folder

check "a folder to be made among the book's own figures is refused" refused figures --into figures/mine
check "so is one reached by a way round" refused figures --into=docs/../figures/mine/of/them
check "a style must be a file, not a folder" refused figures --style /
check "an empty style is refused" refused figures --style ''
check "a program is named by its letters, not by a pattern" refused run 'p.*e'
check "nor by two lines" refused run $'plane\nbox'
check "a line break in a command makes no second line of its refusal" refused $'fig\nures'
check "two names for the tests are refused" refused test plane box
check "verify looks at its options before it builds" refused verify --count many
for wrong in --count --seed= '--count=1 --count 2' 5 '--count 99999999999999999999'; do
  # shellcheck disable=SC2086
  check "verify $wrong is refused" refused verify $wrong
done
for wrong in --foo --repetitions '--sides 10 x' '--judged 0' '--own --own=1' --out=; do
  # shellcheck disable=SC2086
  check "bench $wrong is refused" refused bench $wrong
done
for wrong in '--count x' --jobs=0 no-such-folder -x; do
  # shellcheck disable=SC2086
  check "mutants $wrong is refused" refused mutants $wrong
done
check "an empty copy is refused" refused run plane --mine=
check "two exercises are not proven at once" refused prove 1a 2a
check "nor one that is not there" refused prove 9z
for command in "" run figures test fuzz check "check 1a" grade prove verify bench mutants notes; do
  # shellcheck disable=SC2086
  check "an empty word is refused, and shown: $command" eval "refused $command '' && says \"\$(./course $command '' 2>&1)\" \"''\""
done
check "two exercises at once are refused" refused check '1a 1b'
mkdir -p build
check "a language that the book does not speak is refused" refused notes --pdf --lang fr
check "the book is printed or photographed" refused notes --pdf --screenshot
check "there is one picture of the book, in English" refused notes --lang zh-TW --screenshot
check "what takes nothing is not begun with something" refused clean all
check "clean --help explains, and removes nothing" eval 'says "$(./course clean --help)" "usage: ./course" && [ -d build ]'
linked=$(mktemp -d)
ln -s "$PWD/course" "$linked/course"
ln -s course "$linked/again"
mkdir -p "$linked/elsewhere/$(basename "$PWD")"
check "it works when it is called by a link to a link" says "$("$linked/again" help 2>&1)" "usage: ./course"
check "it works where CDPATH leads elsewhere" \
  says "$(cd .. && CDPATH=$linked/elsewhere bash "$(basename "$OLDPWD")/course" help 2>&1)" "usage: ./course"
books=$PWD/figures/01_plane
ln -s "$books" "$linked/01_plane"
check "a folder with a link into the book's figures is refused" refused figures --into "$linked"
rm -rf "$linked"

say() { printf '%s\n' "$*"; }
root=$PWD
. .course/options.sh
. .course/needs.sh
. .course/build.sh
. .course/figures.sh

advice_on() {  # KERNEL, ID: what is advised there
  (kernel=$1
   uname() { echo "$kernel"; }
   os_release=$(mktemp)
   echo "ID=$2" >"$os_release"
   advise course notes
   rm -f "$os_release")
}
own_words() {  # KERNEL, ID, WORDS
  local advice
  advice=$(advice_on "$1" "$2")
  says "$advice" "$3" || return 1
  [[ "$2" == debian ]] || silent_of "$advice" "libeigen3-dev"
}
check "Debian's own words" own_words Linux debian "apt-get install -y --no-install-recommends g++ cmake"
check "Fedora's own words" own_words Linux fedora "dnf install -y gcc-c++ cmake"
check "Arch's own words" own_words Linux arch "pacman -Sy --needed --noconfirm gcc cmake"
check "Homebrew's own words" own_words Darwin none "brew install cmake ninja"
check "MSYS2's own words" own_words MINGW64_NT-10.0 none "mingw-w64-ucrt-x86_64-cmake"
check "elsewhere it is said what it is" own_words FreeBSD none "by whatever name they have here"

allowed() { ("$@") >/dev/null 2>&1; }
check "verify has its options" allowed verify_options --count 5 --seed=0
check "bench has its options" allowed bench_options --sides 10 100 --own --repetitions=3 --out build/x --judged 5000
check "mutants have their options" allowed mutants_options --count 5 sweep --seed=0 common/first_contact/sweep/course.cpp
missing_from() { local log; log=$(mktemp); cat >"$log"; explain_configure "$log"; rm -f "$log"; }
said=$(printf '%s\n' 'CMake Error at tests/CMakeLists.txt:3 (find_package):' \
  '  Could not find a package configuration file provided by "Catch2" with any of' | missing_from)
check "a package that CMake misses is named, with what to install" says "$said" "CMake does not find: Catch2. To install"

check "a chapter by its program" [ "$(figures_named plane)" == 01_plane ]
check "a figure by its name" [ "$(figures_named figure-13)" == 07_tween_bounce/figure-13 ]
figure_options bunny figure-13
check "figures of one name in two chapters, and another" [ "$names" == " 04_general_sphere/bunny 05_slide/bunny 07_tween_bounce/figure-13" ]
check "the second of them is wanted" is_wanted build/drawn/05_slide/bunny.svg
check "no other is" eval "! is_wanted build/drawn/05_slide/figure-10.svg"
check "each figure that an essay shows has a caption" [ "$(captions | grep -c $'\t..*\t..*')" -eq "$(captions | wc -l)" ]
check "no formula is left in a caption" silent_of "$(captions)" "\\"

elsewhere=$(mktemp -d)
trap 'rm -rf "$elsewhere"' EXIT
cp -R .course "$elsewhere/"
cd "$elsewhere" || exit
root=$PWD
unset FIRST_CONTACT_ALONE
mkdir -p build/dev build/at-work
echo 999999999 >build/at-work/process
said=$(alone; ls build)
check "a lock that was left is taken over" says "$said" "at-work"
mkdir -p build/at-work
echo 999999999 >build/at-work/process
for _ in 1 2 3 4 5 6; do (alone >/dev/null 2>&1; echo in >>turns; sleep 0.1; echo out >>turns) & done
wait
check "of six that find it one at a time is at work" [ "$(tr '\n' ' ' <turns)" == "$(printf 'in out %.0s' 1 2 3 4 5 6)" ]
sleep 30 &
other=$!
mkdir -p build/at-work
echo $other >build/at-work/process
(alone; echo in) >waiting 2>&1 &
second=$!
sleep 1.5
check "a second run waits, and says for whom" grep -q "process $other" waiting
check "and does not begin" [ "$(grep -c '^in$' waiting)" == 0 ]
kill $other 2>/dev/null
wait $second
check "it goes on when the first has ended" grep -q '^in$' waiting
echo "CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere/else" >build/dev/CMakeCache.txt
forget_if_moved dev >/dev/null
check "a build of another folder is forgotten" [ ! -e build/dev ]
mkdir -p build/dev
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/dev/CMakeCache.txt
forget_if_moved dev
check "a build of this folder is kept" [ -e build/dev/CMakeCache.txt ]


. .course/words.sh
. .course/workbook.sh
. .course/workbook_copies.sh
printf '%s\n' '\abs{x} and \norm{y}, \vec v' >task
check "formulas of a task are plain" [ "$(plain_task task)" == "|x| and |y|, v" ]
touch "$(printf 'a\nb.hpp')" 'a"b.hpp' 'a\'
for name in "$(printf 'a\nb.hpp')" 'a"b.hpp' 'a\'; do
  said=$(exercises() { echo 1a; }; caller=$PWD; check_exercise 1a "$name" 2>&1)
  check "an answer that cannot be included is refused: $name" [ "$?: ${said##*: }" == \
    "2: must have no quotation mark, no control character and no backslash at the end of its name" ]
done

# A compiler whose headers lie in no folder that one would expect.
mkdir -p own/include other
touch own/include/vector other/a.hpp
cat >compiler <<'END'
#!/bin/sh
here=$(cd "$(dirname "$0")" && pwd -P)
case "$*" in
  *" -M "*) printf 'answer.o: answer.hpp \\\n %s %s\n' "$here/own/include/vector" "$here/other/a.hpp" ;;
  *) printf '#include <...> search starts here:\n %s\n %s (framework directory)\nEnd of search list.\n' "$here/none" "$here/own/include" >&2 ;;
esac
END
chmod +x compiler
compiler=$PWD/compiler
compilers_own=$(folders_of_compiler)
check "the compiler's own headers may be included, no others" [ "$(includes_elsewhere 1a answer.hpp "$PWD/room")" == "$(pwd -P)/other/a.hpp" ]

# A command that stops who called it, in the midst of a command of the launcher.
mkdir stops rest class class/ann
printf '#!/bin/sh\nkill -"${SIGNAL:-TERM}" $PPID\n' >stops/cmake
chmod +x stops/cmake
export TMPDIR=$PWD/rest
stopped() {  # STATUS, then what is done
  local status=$1
  shift
  (caller=$PWD PATH=$PWD/stops:$PATH
   build_judges_parts() { :; }
   find_walls() { cmake; }
   set -e
   "$@") >/dev/null 2>&1
  [[ $? == "$status" && ! -e build/at-work && -z "$(ls rest)" ]]
}
check "who is stopped while it builds leaves no file" stopped 143 make dev plane
check "nor who is interrupted" eval "SIGNAL=INT stopped 130 make dev plane"
check "nor who is stopped while it grades" stopped 143 grade class
unset TMPDIR

echo "launcher: $passed passed, $failed failed"
exit $((failed > 0))
