# What a command needs, in the words of the system at hand: on Debian and Ubuntu it is installed where it is missing; on
# others the line to type is told when something is missing. Needs bash 3.2 alone, as macOS has it.

os_release=/etc/os-release
# debian (also Ubuntu), fedora, arch, macos, msys2, or other.
system_at_hand() {
  case "$(uname -s)" in
    Darwin) echo macos; return ;;
    MINGW* | MSYS* | CYGWIN*) echo msys2; return ;;
  esac
  local names=""
  # shellcheck source=/dev/null
  [[ ! -r "$os_release" ]] || names=$(. "$os_release" && echo "${ID:-} ${ID_LIKE:-}")
  case " $names " in
    *" debian "* | *" ubuntu "*) echo debian ;;
    *" fedora "* | *" rhel "*) echo fedora ;;
    *" arch "*) echo arch ;;
    *) echo other ;;
  esac
}

# The packages of a system for a purpose: course (to build, test and draw), notes, browser, print, bench, fuzz, coverage, format.
packages() {
  case "$1 $2" in
    "debian course") echo g++ cmake ninja-build libeigen3-dev libhwy-dev libgnuplot-iostream-dev libboost-dev libboost-iostreams-dev \
        libboost-filesystem-dev libcli11-dev nlohmann-json3-dev catch2 librapidcheck-dev gnuplot-nox \
        fonts-dejavu-core fonts-dejavu-extra fonts-noto-cjk ;;
    "debian notes") echo doxygen doxygen-awesome-css fonts-texgyre clang lld wasi-libc libc++-dev-wasm32 \
        libclang-rt-dev-wasm32 ;;
    "debian node") echo nodejs npm ;;
    "debian browser") ! grep -qx 'ID=debian' "$os_release" || echo chromium-headless-shell ;;  # Ubuntu's is no package of apt-get's
    "debian print") echo poppler-utils fonts-arphic-uming ;;
    "debian bench") echo libbenchmark-dev libbullet-dev libfcl-dev libembree-dev ;;
    "debian coverage") echo gcovr ;;
    "debian everywhere") echo clang lld g++-aarch64-linux-gnu qemu-user-static wasi-libc libc++-dev-wasm32 \
        libclang-rt-dev-wasm32 ;;
    "debian fuzz") echo clang ;;
    "debian format") echo git clang-format clang-tidy shellcheck ;;
    "fedora course") echo gcc-c++ cmake ninja-build eigen3-devel highway-devel boost-devel cli11-devel json-devel catch-devel gnuplot \
        dejavu-serif-fonts dejavu-sans-fonts google-noto-sans-cjk-fonts ;;
    "fedora notes") echo doxygen nodejs npm chromium poppler-utils ;;
    "arch course") echo gcc cmake ninja eigen highway boost cli11 nlohmann-json catch2 rapidcheck gnuplot ttf-dejavu noto-fonts-cjk ;;
    "arch notes") echo doxygen nodejs npm chromium poppler ;;
    "macos course") echo cmake ninja eigen highway boost cli11 nlohmann-json catch2 gnuplot ;;
    "macos notes") echo doxygen node poppler ;;
    "msys2 course") ucrt gcc cmake ninja eigen3 highway boost cli11 nlohmann-json catch gnuplot ;;
    "msys2 notes") ucrt doxygen nodejs poppler ;;
  esac
}
ucrt() { printf 'mingw-w64-ucrt-x86_64-%s ' "$@"; }

# How packages are installed there, without a question.
installer() {
  local sudo="sudo "
  ((EUID != 0)) || sudo=""
  case "$1" in
    debian) echo "${sudo}apt-get install -y --no-install-recommends" ;;
    fedora) echo "${sudo}dnf install -y" ;;
    arch) echo "${sudo}pacman -Sy --needed --noconfirm" ;;
    macos) echo "brew install" ;;
    msys2) echo "pacman -S --needed --noconfirm" ;;
  esac
}

# The line that installs what these purposes need here; nothing where that is not known.
line_for() {
  local system purpose names=""
  system=$(system_at_hand)
  [[ "$system" != other ]] || return 0
  for purpose in "$@"; do names="$names $(packages "$system" "$purpose")"; done
  [[ "$system" != debian ]] || printf '%s' "$(installer debian | sed 's/ install.*/ update/') && "
  echo "$(installer "$system")$(printf ' %s' $names)"
}

# The same, told to a reader.
advise() {
  local system
  system=$(system_at_hand)
  if [[ "$system" == other ]]; then
    say "Please install, by whatever name they have here: a C++20 compiler, CMake 3.25, Ninja, Eigen 3.4, Highway, Boost, CLI11,"
    say "nlohmann-json, Catch2, gnuplot; RapidCheck for the random tests; Doxygen, Node.js and Chromium for the notes."
    return
  fi
  say "  $(line_for "$@")"
  case "$system" in
    macos) say "and Apple's compiler, if it is not there: xcode-select --install" ;;
    msys2) say "in MSYS2's UCRT64 window. With Visual Studio and vcpkg instead: cmake --preset vcpkg (see README.md)." ;;
  esac
}

# Sees to it that what the purposes need is there.
require() {
  if [[ "$(system_at_hand)" == debian ]] && command -v dpkg-query >/dev/null; then
    local purpose names=""
    for purpose in "$@"; do names="$names $(packages debian "$purpose")"; done
    install_missing $names
  else
    require_commands "$@"
  fi
}

# Elsewhere: the commands at least must be there; what CMake misses is told when it says so.
require_commands() {
  local wanted missing=""
  for wanted in cmake ninja $([[ " $* " != *" notes "* ]] || echo doxygen node npm); do
    command -v "$wanted" >/dev/null || missing="$missing $wanted"
  done
  [[ -n "$missing" ]] || return 0
  say "Not found:$missing. To install all that is needed here:"
  advise "$@"
  exit 1
}

# Debian and Ubuntu. What apt-get says is shown only if it fails.
install_missing() {
  local package missing=""
  for package in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] || missing="$missing $package"
  done
  [[ -n "$missing" ]] || return 0
  local as_root=env
  if ((EUID != 0)); then
    command -v sudo >/dev/null || ask_administrator "$missing"
    as_root=sudo
  fi
  say "Installing:$missing"
  local log
  log=$(mktemp)
  remove_at_end "$log"
  if ! { $as_root DEBIAN_FRONTEND=noninteractive apt-get update && $as_root DEBIAN_FRONTEND=noninteractive \
           apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=300 $missing; } >"$log" 2>&1 </dev/null; then
    tail -n 20 "$log" >&2
    say "They could not be installed."
    ((EUID == 0)) || ask_administrator "$missing"
    exit 1
  fi
}

# For a reader who may not install anything: all that the two commands of the README need, asked for at once.
ask_administrator() {
  local names
  names=$(printf '%s\n' $1 $(packages debian course) $(packages debian notes) $(packages debian node) \
                 $(packages debian browser) | sort -u | tr '\n' ' ')
  say "This needs packages that are not installed:$1"
  say "and you may not install them yourself here. Please ask whoever administers this computer to run, as root:"
  say "  apt-get update && apt-get install -y --no-install-recommends $names"
  say "Then call the same command again: nothing else needs any rights."
  exit 1
}

# A Node.js that is there already will do, whoever installed it.
node_if_missing() { { command -v node && command -v npm; } >/dev/null || echo node; }

# What the notes are made and checked with.
require_notes() {
  require course notes $(node_if_missing) "$@"
  has_packages || install_packages --omit=dev
}
has_packages() { cmp -s docs/package-lock.json docs/node_modules/installed-lock.json; }
install_packages() {
  writable docs
  alone
  say "Installing the notes' packages ..."
  npm ci --prefix docs "$@" --prefer-offline --no-audit --no-fund --loglevel=error >&2
  cp docs/package-lock.json docs/node_modules/installed-lock.json
}

# ESLint is of no use to who only reads the notes.
require_for_format() {
  require course format $(node_if_missing)
  has_packages && [[ -x docs/node_modules/.bin/eslint ]] || install_packages
}

# The tests check the notes as well, where what makes them is there.
require_for_tests() {
  if [[ "$(system_at_hand)" == debian ]] || has_notes_tools; then
    require_notes_and_browser
  else
    require course
    say "The notes are not checked: that needs Doxygen, Node.js, npm, and doxygen-awesome-css in \$DOXYGEN_AWESOME."
  fi
}
has_notes_tools() {
  command -v doxygen >/dev/null && command -v node >/dev/null && command -v npm >/dev/null &&
    [[ -f "${DOXYGEN_AWESOME:-/usr/share/doxygen-awesome-css}/doxygen-awesome.css" ]]
}

# A browser for the checks of the pages: one that is there, or else Debian's. Further purposes may be named.
require_notes_and_browser() {
  local name
  [[ -z "${CHROMIUM:-}" ]] || { require_notes "$@"; return; }
  for name in chromium-headless-shell chromium chromium-browser google-chrome; do
    ! command -v "$name" >/dev/null || { require_notes "$@"; return; }
  done
  require_notes browser "$@"
}
