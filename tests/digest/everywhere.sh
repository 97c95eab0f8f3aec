#!/usr/bin/env bash
# Builds the library and its digest with every compiler, option and processor that is at hand, runs it (on a foreign
# processor's program by qemu, WebAssembly by Node.js), and compares the answers with the committed ones. One line a
# build; build/everywhere/ keeps the builds and what they said.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root=$PWD place=$PWD/build/everywhere
digest=$root/tests/data/digest.txt
export root place digest
. .course/build.sh

configure() { # name cmake-arguments ...
  cmake -G Ninja -S "$root/tests/digest" -B "$place/$1" -DCMAKE_BUILD_TYPE=None "${@:2}"
  cmake --build "$place/$1" --target digest
}

# Runs a digest and says whether it is the committed one.
judge() { # name command ...
  local name=$1 said
  shift
  if said=$("$@" "$digest" 2>&1); then printf '%-34s equal    %s\n' "$name" "${said##*$'\n'}"
  else printf '%-34s UNEQUAL  see %s\n' "$name" "$place/$name.txt"; printf '%s\n' "$said" >"$place/$name.txt"; return 1; fi
}

build() { # name cmake-arguments ...
  configure "$@" >"$place/$1.log" 2>&1 || { printf '%-34s NOT BUILT  see %s\n' "$1" "$place/$1.log"; return 1; }
}

native() { # name compiler flags
  build "$1" -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS="$3" && judge "$1" "$place/$1/digest"
}

# The same program on older processors, as qemu plays them: the kernels are chosen when it runs.
older() { # name
  judge "$1-without-AVX" qemu-x86_64-static -cpu Nehalem "$place/$1/digest"
  judge "$1-with-AVX2" qemu-x86_64-static -cpu Haswell "$place/$1/digest"
}

headers_only="-Dhwy_DIR=$root/tests/digest/headers_only"
# The linker leaves out what the digest does not call: choosing among kernels, which needs more of Highway than headers.
arm64() { # name
  build "$1" "$headers_only" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
    -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_CXX_FLAGS="-O2 -ffunction-sections" \
    -DCMAKE_EXE_LINKER_FLAGS="-static -Wl,--gc-sections" &&
    judge "$1" qemu-aarch64-static "$place/$1/digest"
}

wasm() { # name
  build "$1" "$headers_only" -DCMAKE_TOOLCHAIN_FILE="$root/tests/digest/wasm/toolchain.cmake" &&
    judge "$1" node --no-warnings "$root/tests/digest/wasm/run.mjs" "$place/$1/digest"
}
export -f configure judge build native older arm64 wasm
export headers_only

tasks=()
for compiler in g++ clang++; do
  command -v "$compiler" >/dev/null || continue
  for level in -O0 -O1 -O2 -O3; do tasks+=("native $compiler$level $compiler $level"); done
  tasks+=("native $compiler-without-vectors $compiler '-O2 -DEIGEN_DONT_VECTORIZE'")
  tasks+=("native $compiler-for-this-processor $compiler '-O2 -march=native'")
done
[[ $(uname -m) == x86_64 ]] && command -v qemu-x86_64-static >/dev/null &&
  tasks+=("native g++-on-older-processors g++ -O2 && older g++-on-older-processors")
command -v aarch64-linux-gnu-g++ >/dev/null && command -v qemu-aarch64-static >/dev/null && tasks+=("arm64 arm64")
[[ -d /usr/include/wasm32-wasi ]] && tasks+=("wasm wasm")

mkdir -p "$place"
printf '%s\0' "${tasks[@]}" | xargs -0 -P "$(cores)" -I{} bash -c '{} || touch "$place/unequal"'
[[ ! -e $place/unequal ]] || { rm "$place/unequal"; exit 1; }
