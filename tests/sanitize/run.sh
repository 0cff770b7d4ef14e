#!/usr/bin/env bash
# Builds everything under sanitizers and runs it: GoogleTest and pytest under address and undefined behavior, the fuzz
# targets, and in full shared values under the thread sanitizer.
#   run.sh BUILD CACHE               what finds most in some minutes, the same every time
#   run.sh BUILD CACHE full          every test, and the fuzz targets for ten minutes each
#   run.sh BUILD CACHE fuzz SECONDS [TARGET...]
# CACHE keeps compiled files, and what the fuzz targets found worth keeping, from one run to the next.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd -P)
project=$(realpath "$here/../..")
build=$1; cache=$2; part=${3:-quick}; shift 2
asan=$build/asan
tsan=$build/tsan
clang=clang++-19
python=/usr/bin/python3
targets=(json formula curve patch tessellation definition build features fit meet)
# What runs for long is worth some minutes more of compiling.
optimized=-O1
[ "$part" != quick ] || optimized=-O0
export CCACHE_DIR=$cache/ccache CCACHE_BASEDIR=$project CCACHE_NOHASHDIR=1 CCACHE_MAXSIZE=1G
export CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=1 SANITIZE_PROJECT=$project
export UBSAN_OPTIONS=print_stacktrace=1
cd "$project"
source tests/sharing/share.sh

# Of the tests that take a quarter of an hour under the sanitizers those that are slow and tell nothing new.
slow_native=-PatchVerbs.AlongOneAxisAreThoseAlongTheOtherOfTheSwappedPatch:PatchFromFormulas.RefusesWhatItCannotFollow
slow_native+=:PatchFromFormulas.LiesWithinTheToleranceAtItsOwnParameters
slow_native+=:CurveFromFormulas.RefusesPolesJumpsAndUndefinedValues
slow_native+=:PatchJoin.MeasuredContinuityIsThatAskedFor:MeetJudge.SurfacesCrossAlongTheCurvesThatSislFinds
slow_native+=:KnotVectorMake.RefusesWhatIsWrongAtAnyPlaceAndNothingElse
slow_native+=:Area.OfASetIsTheSumOfItsPatches:PatchRemoval.*:SecondJudge.*:Reduced.ByOneHasExactlyTheErrorThatItSays
quick_python=(tests/python/test_{bad_input,bad_verbs,arrays,values,json,formula,damaged_definitions}.py
              tests/python/test_{shared_values,extremes}.py)
# These build, install or read sources: nothing of theirs runs in this process.
not_here=(test_architecture test_contributing test_manual test_manual_languages test_matrix test_packaging test_readme test_sharing
          test_stubs)

fail() { echo "$*" >&2; exit 1; }

heading() { printf '\n== %s\n' "$*"; }

# The file of a runtime of clang's.
runtime() { "$clang" -print-file-name="libclang_rt.$1-$(uname -m).$2"; }

# What no test of this kind can do without, where it is not there.
missing() {
  command -v "$clang" >/dev/null || { echo "$clang (package clang-19)"; return; }
  command -v ccache >/dev/null || { echo "ccache (package ccache)"; return; }
  local file
  for file in "$(runtime asan so)" "$(runtime tsan so)" "$(runtime fuzzer a)"; do
    [ -f "$file" ] || { echo "$clang's $(basename "$file") (package libclang-rt-19-dev)"; return; }
  done
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
  local sanitizer=$1 folder=$2 fuzz=OFF start=$SECONDS; shift 2
  [ "$sanitizer" = thread ] || fuzz=ON
  mkdir -p "$folder"
  /usr/bin/cmake -S . -B "$folder" -G Ninja -DPython_EXECUTABLE="$python" -DCMAKE_CXX_COMPILER="$clang" \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$here/compile.sh" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="$optimized -g1" -DSPLINECORE_PRECOMPILED=ON \
    -DSPLINECORE_UNITY=ON -DSPLINEWRIGHT_SANITIZE="$sanitizer" -DSPLINEWRIGHT_FUZZ=$fuzz \
    >"$folder/configure.log" 2>&1 || { cat "$folder/configure.log" >&2; exit 1; }
  /usr/bin/cmake --build "$folder" -j 2 --target "$@" >"$folder/build.log" 2>&1 || {
    grep -A 20 -m 3 -E 'error: |FAILED: ' "$folder/build.log" >&2
    exit 1
  }
  echo "Built for the $sanitizer sanitizer in $((SECONDS - start)) s"
}

# Two processes share the tests of a program.
google_tests() {
  local start=$SECONDS log=$build/${1##*/} side sides=() code=0
  for side in 0 1; do
    GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=$side "$@" --gtest_brief=1 >"$log-$side.log" 2>&1 </dev/null &
    sides+=($!)
  done
  for side in 0 1; do
    wait "${sides[$side]}" || { code=1; tail -n 100 "$log-$side.log" >&2; }
  done
  awk -v seconds=$((SECONDS - start)) '
    /^\[  PASSED  \]/ { passed += $4 }
    /^\[  FAILED  \].*listed below/ { failed += $4 }
    END { printf "%d passed, %d failed in %d s\n", passed, failed, seconds }' "$log"-?.log
  return $code
}

native_tests() {
  heading "GoogleTest under address and undefined behavior"
  google_tests "$asan"/tests/native/splinecore_tests --gtest_filter="$1"
  google_tests "$asan"/tests/native/splinecore_inside_tests
  heading "Inputs that are kept, through the fuzz targets"
  google_tests "$asan"/tests/fuzz/splinewright_replay
}

# The module of the address sanitizer, in a Python that has its runtime.
python_tests() {
  heading "pytest on the module under address and undefined behavior"
  share "$asan/python-logs" env LD_PRELOAD="$(runtime asan so)" PYTHONMALLOC=malloc \
    PYTHONPATH="$asan/python:$project/tests/sharing" \
    ASAN_OPTIONS=detect_leaks=1:malloc_context_size=2:allocator_may_return_null=1 \
    LSAN_OPTIONS="suppressions=$here/leaks.txt:print_suppressions=0" \
    "$python" -m pytest -q -p no:cacheprovider -p sharing "$@"
}

all_python() {
  local ignored=() file
  for file in "${not_here[@]}"; do ignored+=(--ignore="tests/python/$file.py"); done
  python_tests tests/python "${ignored[@]}"
}

thread_tests() {
  heading "Shared values under the thread sanitizer"
  google_tests "$tsan"/tests/sanitize/splinewright_shared_values
  google_tests "$tsan"/tests/native/splinecore_inside_tests
}

thread_python() {
  heading "pytest on shared values under the thread sanitizer"
  LD_PRELOAD=$(runtime tsan so) PYTHONMALLOC=malloc PYTHONPATH=$tsan/python \
    "$python" -m pytest -q -p no:cacheprovider tests/python/test_shared_values.py
}

# How many inputs a target gets that are the same, in the same order, on every machine.
few() {
  case "$1" in
    json) echo 10000 ;; formula) echo 5000 ;; curve) echo 1500 ;; build) echo 1000 ;; tessellation) echo 200 ;;
    *) echo 500 ;;
  esac
}

# fuzz_one SECONDS|few TARGET      For seconds it goes on behind what it finds, from what earlier runs kept, too.
fuzz_one() {
  local long=$1 found=$build/fuzz/$2 flags corpus
  rm -rf "$found"
  if [ "$long" = few ]; then
    flags=(-seed=1 -reload=0 -runs="$(few "$2")")
    corpus=$found/corpus
  else
    flags=(-fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 -max_total_time="$long")
    corpus=$cache/fuzz/$2
  fi
  mkdir -p "$corpus" "$found"
  # The sanitizer keeps every stack that allocates, of which recursions that halve have as many as they have parts.
  ASAN_OPTIONS=allocator_may_return_null=0:malloc_context_size=6 nice "$asan/tests/fuzz/fuzz_$2" "${flags[@]}" \
    -max_len=300 -timeout=120 -rss_limit_mb=3000 -malloc_limit_mb=1500 \
    -artifact_prefix="$found/" "$corpus" "tests/data/fuzz/$2" >"$found/log" 2>&1 || true
  echo "$2: $(grep -aE '^#[0-9]+' "$found/log" | tail -n 1 | tr '\t' ' ')"
  ls "$found" | grep -vxE 'log|corpus' | sed "s#^#  found $found/#"
}

# fuzz SECONDS|few TARGET...      two at a time; fails where one crashed or never ran, not where an input only took long
fuzz() {
  local long=$1; shift
  heading "Fuzz targets, $([ "$long" = few ] && echo "a few inputs" || echo "$long s") each"
  export -f fuzz_one few; export build asan cache
  printf '%s\n' "$@" | xargs -P 2 -I{} bash -c 'fuzz_one "$@"' fuzz_one "$long" {}
  local target folder
  for target in "$@"; do
    folder=$build/fuzz/$target
    if ls "$folder" | grep -qE '^(crash|leak|oom)-'; then
      grep -aE -A 40 -m 1 'ERROR: |runtime error: |terminate called' "$folder/log" >&2
      fail "$target found something. What shows it lies in $folder"
    fi
    grep -qaE 'Done [0-9]+ runs|fuzzed for|timeout after' "$folder/log" || {
      tail -n 20 "$folder/log" >&2
      fail "$target did not run"
    }
  done
}

lacks=$(missing)
if [ -n "$lacks" ]; then
  echo "Sanitizers and fuzz targets are skipped: there is no $lacks"
  exit 0
fi
case "$part" in
  quick)
    build_with address "$asan" splinecore_tests splinecore_inside_tests splinewright_replay _splinecore fuzzers
    native_tests "$slow_native"
    python_tests "${quick_python[@]}"
    fuzz few "${targets[@]}"
    echo "Without slow tests, threads and long fuzzing: ./run sanitize full has them, too"
    ;;
  full)
    build_with address "$asan" splinecore_tests splinecore_inside_tests splinewright_replay _splinecore fuzzers
    build_with thread "$tsan" splinewright_shared_values splinecore_inside_tests _splinecore
    native_tests '*'
    all_python
    thread_tests
    thread_python
    fuzz 600 "${targets[@]}"
    ;;
  fuzz)
    seconds=${2:-}; shift $(($# < 2 ? $# : 2))
    [[ $seconds =~ ^[0-9]+$ ]] || fail "How long is each target to run? ./run sanitize fuzz SECONDS [TARGET...]"
    build_with address "$asan" fuzzers
    fuzz "$seconds" "${@:-${targets[@]}}"
    ;;
  *) fail "./run sanitize [full | fuzz SECONDS [TARGET...]]" ;;
esac
