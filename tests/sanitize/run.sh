#!/usr/bin/env bash
# Builds everything under sanitizers and runs it: GoogleTest and pytest under address and undefined behaviour,
# shared values under the thread sanitizer, and the fuzz targets.
#   run.sh BUILD CACHE               what finds most in some minutes
#   run.sh BUILD CACHE full          every test, and the fuzz targets for a minute each
#   run.sh BUILD CACHE fuzz SECONDS [TARGET...]
# CACHE keeps compiled files, and what the fuzz targets found worth keeping, from one run to the next.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
project=$(realpath "$here/../..")
build=$1; cache=$2; part=${3:-quick}; shift 2
asan=$build/asan
tsan=$build/tsan
clang=clang++-19
python=/usr/bin/python3
targets=(json formula curve patch tessellation definition build)
export CCACHE_DIR=$cache/ccache CCACHE_BASEDIR=$project CCACHE_NOHASHDIR=1 CCACHE_MAXSIZE=1G
export UBSAN_OPTIONS=print_stacktrace=1
cd "$project"

# Of the tests that take a quarter of an hour under the sanitizers those that are slow and tell nothing new.
slow_native=-PatchVerbs.AlongOneAxisAreThoseAlongTheOtherOfTheSwappedPatch:PatchFromFormulas.RefusesWhatItCannotFollow
slow_native+=:Area.OfASetIsTheSumOfItsPatches:PatchRemoval.*:SecondJudge.*:Reduced.ByOneHasExactlyTheErrorThatItSays
quick_python=(test_bad_input test_bad_verbs test_arrays test_values test_json test_formula test_damaged_definitions
              test_shared_values test_extremes)
# These build and install, or read sources: nothing of theirs runs in this process.
not_here=(test_architecture test_packaging test_readme test_stubs)

fail() { echo "$*" >&2; exit 1; }

heading() { printf '\n== %s\n' "$*"; }

# The file of a runtime of clang's.
runtime() {
  local file
  file=$("$clang" -print-file-name="libclang_rt.$1-$(uname -m).$2" 2>/dev/null) || true
  [ -f "$file" ] || fail "There is no $1 runtime of $clang: install the package libclang-rt-19-dev"
  echo "$file"
}

require_clang() {
  command -v "$clang" >/dev/null || fail "There is no $clang: install the package clang-19"
  runtime asan so >/dev/null; runtime tsan so >/dev/null; runtime fuzzer a >/dev/null
}

# Names instead of addresses in what a sanitizer prints.
for symbolizer in llvm-symbolizer-19 llvm-symbolizer addr2line; do
  if command -v "$symbolizer" >/dev/null; then
    export {ASAN,TSAN,UBSAN}_SYMBOLIZER_PATH="$(command -v "$symbolizer")"
    break
  fi
done

# build_with address|thread FOLDER TARGET...
build_with() {
  local sanitizer=$1 folder=$2 fuzz=OFF; shift 2
  [ "$sanitizer" = thread ] || fuzz=ON
  mkdir -p "$folder"
  /usr/bin/cmake -S . -B "$folder" -G Ninja -DPython_EXECUTABLE="$python" -DCMAKE_CXX_COMPILER="$clang" \
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -DSPLINEWRIGHT_SANITIZE="$sanitizer" -DSPLINEWRIGHT_FUZZ=$fuzz \
    >"$folder/configure.log" 2>&1 || { cat "$folder/configure.log" >&2; exit 1; }
  /usr/bin/cmake --build "$folder" --target "$@" >"$folder/build.log" 2>&1 || { tail -n 60 "$folder/build.log" >&2; exit 1; }
}

native_tests() {
  heading "GoogleTest under address and undefined behaviour"
  "$asan"/tests/native/splinecore_tests --gtest_brief=1 --gtest_filter="$1"
  "$asan"/tests/fuzz/splinewright_replay --gtest_brief=1
}

# python_under RUNTIME FOLDER TEST...      the module of FOLDER, in a Python that has the runtime
python_under() {
  local preload=$1 folder=$2; shift 2
  LD_PRELOAD=$preload PYTHONMALLOC=malloc PYTHONPATH=$folder/python \
    "$python" -m pytest -q -p no:cacheprovider "$@"
}

python_tests() {
  heading "pytest on the module under address and undefined behaviour"
  ASAN_OPTIONS=detect_leaks=1:malloc_context_size=2:allocator_may_return_null=1 \
    LSAN_OPTIONS=suppressions=$here/leaks.txt:print_suppressions=0 \
    python_under "$(runtime asan so)" "$asan" "$@"
}

thread_tests() {
  heading "Shared values under the thread sanitizer"
  "$tsan"/tests/sanitize/splinewright_shared_values --gtest_brief=1
  python_under "$(runtime tsan so)" "$tsan" tests/python/test_shared_values.py
}

# fuzz_one SECONDS TARGET      For long it goes on behind what it finds, from what earlier runs kept, too; in a short
# run the same inputs come in the same order every time, and the first finding ends it.
fuzz_one() {
  local seconds=$1 found=$build/fuzz/$2 flags=(-seed=1)
  local corpus=$found/corpus
  rm -rf "$found"
  if [ "$seconds" -ge 60 ]; then
    flags=(-fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1)
    corpus=$cache/fuzz/$2
  fi
  mkdir -p "$corpus" "$found"
  ASAN_OPTIONS=allocator_may_return_null=0 nice "$asan/tests/fuzz/fuzz_$2" "${flags[@]}" \
    -max_total_time="$seconds" -max_len=300 -timeout=120 -rss_limit_mb=3000 -malloc_limit_mb=1500 \
    -artifact_prefix="$found/" "$corpus" "tests/data/fuzz/$2" >"$found/log" 2>&1 || true
  echo "$2: $(grep -aE '^#[0-9]+' "$found/log" | tail -n 1 | tr '\t' ' ')"
  ls "$found" | grep -vxE 'log|corpus' | sed "s#^#  found $found/#"
}

# fuzz SECONDS TARGET...      two at a time; fails where one crashed or never ran, not where an input only took long
fuzz() {
  local seconds=$1; shift
  heading "Fuzz targets, $seconds s each"
  export -f fuzz_one; export build asan cache
  printf '%s\n' "$@" | xargs -P 2 -I{} bash -c 'fuzz_one "$@"' fuzz_one "$seconds" {}
  local target folder
  for target in "$@"; do
    folder=$build/fuzz/$target
    if ls "$folder" | grep -qE '^(crash|leak|oom)-'; then
      grep -aE -A 40 -m 1 'ERROR: |runtime error: |terminate called' "$folder/log" >&2
      fail "$target found something. What shows it lies in $folder"
    fi
    grep -qaE 'Done [0-9]+ runs|fuzzed for|timeout after' "$folder/log" || { tail -n 20 "$folder/log" >&2; fail "$target did not run"; }
  done
}

all_python() {
  local ignored=()
  for file in "${not_here[@]}"; do ignored+=(--ignore="tests/python/$file.py"); done
  python_tests tests/python "${ignored[@]}"
}

require_clang
case "$part" in
  quick)
    build_with address "$asan" splinecore_tests splinewright_replay _splinecore fuzzers
    build_with thread "$tsan" splinewright_shared_values _splinecore
    native_tests "$slow_native"
    python_tests $(printf 'tests/python/%s.py ' "${quick_python[@]}")
    thread_tests
    fuzz 20 "${targets[@]}"
    ;;
  full)
    build_with address "$asan" splinecore_tests splinewright_replay _splinecore fuzzers
    build_with thread "$tsan" splinewright_shared_values _splinecore
    native_tests '*'
    all_python
    thread_tests
    fuzz 60 "${targets[@]}"
    ;;
  fuzz)
    seconds=${2:-}; shift $(($# < 2 ? $# : 2))
    [[ $seconds =~ ^[0-9]+$ ]] || fail "How long is each target to run? ./run sanitize fuzz SECONDS [TARGET...]"
    build_with address "$asan" fuzzers
    fuzz "$seconds" "${@:-${targets[@]}}"
    ;;
  *) fail "./run sanitize [full | fuzz SECONDS [TARGET...]]" ;;
esac
