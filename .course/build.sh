# Building: one at a time in this folder, with its progress shown; what it says is shown if it fails.

# Programs that are made here: 01_plane is the folder of "plane".
chapters() { local folder; for folder in chapters/[0-9][0-9]_*/; do basename "$folder"; done; }
programs() { chapters | sed 's/^[0-9]*_//'; }

cores() { nproc 2>/dev/null || sysctl -n hw.ncpu 2>/dev/null || echo 2; }

# The folder must be one that can be written to: looked at before anything is begun.
writable() {
  local folder
  for folder in "$@"; do
    mkdir -p "$folder" 2>/dev/null && [[ -w "$folder" ]] && continue
    say "course: $folder cannot be written to; it must be a folder of your own, and so must $root"
    exit 1
  done
}

# What is removed when the launcher ends, also where it is stopped by a signal.
remains=()
remove_at_end() {
  remains+=("$1")
  trap 'rm -rf "${remains[@]}" || true' EXIT
  trap 'exit 129' HUP
  trap 'exit 130' INT
  trap 'exit 143' TERM
}

# For who becomes another program, and so has no end of its own.
remove_now() {
  ((${#remains[@]} == 0)) || rm -rf "${remains[@]}"
  remains=()
  trap - EXIT HUP INT TERM
}

# Another ./course at work in the same folder is waited for. A lock left by one that was killed is taken over.
alone() {
  [[ -z "${FIRST_CONTACT_ALONE:-}" ]] || return 0
  writable build
  local told=""
  until mkdir build/at-work 2>/dev/null || take_over; do
    [[ -n "$told" ]] || say "Another ./course (process $(at_work)) is at work in this folder: waiting for it;"
    [[ -n "$told" ]] || say "if there is none, remove build/at-work."
    told=yes
    sleep 1
  done
  echo $$ >build/at-work/process
  remove_at_end "$root/build/at-work"
  export FIRST_CONTACT_ALONE=yes
}

at_work() { cat build/at-work/process 2>/dev/null || echo unknown; }

# Of several that find the same lock of a dead process one alone can make the folder that has its number.
take_over() {
  local owner
  owner=$(at_work)
  [[ "$owner" != unknown && -n "$owner" ]] && ! kill -0 "$owner" 2>/dev/null &&
    mkdir "build/at-work/after-$owner" 2>/dev/null && [[ "$(at_work)" == "$owner" ]]
}

no_longer_alone() {
  remove_now
  unset FIRST_CONTACT_ALONE
}

# A build knows where it was made; a folder that was moved or copied since is built anew.
forget_if_moved() {
  local cache=build/$1/CMakeCache.txt
  [[ -f "$cache" ]] || return 0
  local here
  for here in "$PWD" "$(pwd -P)" "$(cygpath -m "$PWD" 2>/dev/null)"; do
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$here" "$cache" || return 0
  done
  say "The course was built in another folder: building anew."
  rm -rf "build/$1"
}

# Counts on one line of a terminal, or a line at each quarter elsewhere; the rest of what Ninja says is passed on.
show_progress() {
  local line now all told=0
  while IFS= read -r line; do
    case "$line" in
      "["[0-9]*/[0-9]*"]"*)
        now=${line%%/*} now=${now#[} all=${line#*/} all=${all%%]*}
        if [[ -t 2 ]]; then
          printf '\r  %s of %s ' "$now" "$all" >&2
        elif ((now * 4 >= all * (told + 1) && all > 20)); then
          told=$((now * 4 / all))
          say "  $now of $all"
        fi ;;
    esac
  done
  [[ ! -t 2 ]] || printf '\r%20s\r' "" >&2
}

# CMake's complaint of a package that it does not find, as what to install; anything else whole.
explain_configure() {
  local missing
  missing=$(sed -n -e 's/.*Could not find a package configuration file provided by "\([^"]*\)".*/ \1/p' \
                -e 's/^ *Could NOT find \([A-Za-z0-9_]*\).*/ \1/p' \
                -e 's/.*No CMAKE_CXX_COMPILER could be found.*/ a C++ compiler/p' "$1" | sort -u | tr -d '\n')
  if [[ -z "$missing" ]]; then
    cat "$1" >&2
  else
    say "CMake does not find:$missing. To install all that is needed here:"
    advise course
  fi
}

# Builds targets of a preset, all of them if none is named.
make() {
  local preset=$1 log
  shift
  alone
  forget_if_moved "$preset"
  log=$(mktemp)
  remove_at_end "$log"
  if ! cmake --preset "$preset" ${FIRST_CONTACT_WERROR:+-DFIRST_CONTACT_WERROR="$FIRST_CONTACT_WERROR"} \
         ${FIRST_CONTACT_MINE:+-DFIRST_CONTACT_MINE="$FIRST_CONTACT_MINE"} >"$log" 2>&1; then
    explain_configure "$log"
    exit 1
  fi
  if ! NINJA_STATUS='[%f/%t] ' cmake --build --preset "$preset" ${1:+--target "$@"} 2>&1 | tee "$log" | show_progress; then
    sed -n '/^FAILED/,$p' "$log" | grep -v '^\[[0-9]*/' >&2 || cat "$log" >&2
    exit 1
  fi
}
