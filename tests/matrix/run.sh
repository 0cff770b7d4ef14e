#!/usr/bin/env bash
# Packs one zip with a module for every Python, and runs the Blender tests with that very file: all of them on the Blender
# of Debian 12 (this system); those that a version may change once more, shared by that of Debian 13, that of Debian unstable
# and the official builds but 5.1. Each window is opened on one of Debian's three, workpieces on the oldest or the newest.
#   run.sh BUILD CACHE           CACHE keeps the roots of the other releases and the official builds
#   run.sh BUILD CACHE full      all of it everywhere, with modules by each release's own compiler
#   run.sh BUILD CACHE plan      only says which official builds there are
#   run.sh BUILD CACHE prepare   only makes the roots and the official builds; a run that begins meanwhile waits for that
# From second MATRIX_UNTIL since 1970 on no other official build is begun, which is said of each.
set -euo pipefail
here=$(cd -P "$(dirname "$0")" && pwd)
project=$(realpath "$here/../..")
build=$(realpath "$1"); cache=$2; how=${3:-}
# Official versions, and the release whose Python each is built for.
official=(4.2:bookworm 4.5:bookworm 5.0:bookworm 5.1:trixie 5.2:trixie)
# It has the Python and nearly all else of the one behind it.
only_full=5.1
# Releases and official versions that can be had and share the tests.
others=()
# The folder of the build, as seen from inside a root.
inside=/project/${build#"$project"/}
[ "$inside" != "/project/$build" ] || { echo "the build $build is not inside $project" >&2; exit 2; }

in_root() { local suite=$1; shift; "$here/root.sh" run "$cache/$suite" "$project" "$@"; }

# What it leaves running, if anything, does not keep the lock.
make_root() { "$here/root.sh" make "$1" "$cache/$1" >"$build/root-$1.log" 2>&1 8>&-; }

# By a release's own compiler.
build_in_root() {
  in_root "$1" sh -c "
    cmake -S /project -B $inside/roots/$1 -G Ninja -DCMAKE_BUILD_TYPE=Release -DSPLINEWRIGHT_TESTS=OFF \
      -DSPLINECORE_PRECOMPILED=ON -DSPLINECORE_UNITY=ON &&
    cmake --build $inside/roots/$1 --target _splinecore &&
    cp -u $inside/roots/$1/python/splinecore/_splinecore.*.so $inside/modules/" >"$build/module-$1.log" 2>&1 ||
    { tail -n 40 "$build/module-$1.log" >&2; return 1; }
}

# The version of the Python that a release has.
python_in() { ls "$cache/$1/usr/include" | sed -n 's/^python\(3\.[0-9]*\)$/\1/p'; }

# With the library that is built already, by this system's compiler: its C library is the oldest.
build_here() {
  local suite version folder pythons=() targets=()
  for suite in "$@"; do
    folder=$build/headers/$suite version=$(python_in "$suite")
    mkdir -p "$folder"
    ln -sfn "$cache/$suite/usr/include/"{pybind11,"python$version",*-linux-gnu} "$folder/"
    pythons+=("$version=$folder") targets+=("_splinecore_${version/./}")
  done
  { /usr/bin/cmake -S "$project" -B "$build" -DSPLINECORE_MORE_PYTHONS="$(IFS=\;; echo "${pythons[*]}")" &&
    /usr/bin/cmake --build "$build" --target "${targets[@]}" && cp -u "$build"/more/_splinecore.*.so "$build/modules/"; } \
    >"$build/modules.log" 2>&1 || { tail -n 40 "$build/modules.log" >&2; return 1; }
}

heading() { printf '\n== %s\n' "$*"; }

# Runs a command and remembers its name where it fails.
failed=()
attempt() { local name=$1; shift; "$@" || failed+=("$name"); }

# The windows of a release: all, or its part of those that all share, and of workpieces from start to end every second on the
# oldest release and the others on the newest one.
windows_of() {
  local i name releases=(bookworm "${suites[@]}")
  local shared=() workpieces=("$project"/tests/gui/test_workpiece_*.py)
  for name in "$project"/tests/gui/test_*.py; do
    [[ $how != full && $name = */test_workpiece_* ]] || shared+=("$name")
  done
  for ((i = 0; i < ${#shared[@]}; i++)); do
    [ "$how" != full ] && [ "${releases[i % ${#releases[@]}]}" != "$1" ] || echo "tests/gui/$(basename "${shared[i]}")"
  done
  [ "$how" != full ] && [[ $1 = bookworm || $1 = "${releases[-1]}" ]] || return 0
  local turn=1
  [ "$1" != bookworm ] || turn=0
  for ((i = turn; i < ${#workpieces[@]}; i += 2)); do echo "tests/gui/$(basename "${workpieces[i]}")"; done
}

# Tests that no version changes.
of_any_version() { sed -nE 's/^(test_\w+\.py).*/\1/p' "$here/any_version.txt" | tr '\n' ' '; }

# The tests that one of the others leaves to those beside it; the first Blender leaves none.
left_by() {
  local i=0 name known; known=" $(of_any_version)"
  [ "$how" != full ] && [ "$1" != bookworm ] || return 0
  for name in "$project"/tests/blender/test_*.py; do
    name=$(basename "$name")
    if [[ $known = *" $name "* ]]; then echo "$name"; continue; fi
    [ "${others[i++ % ${#others[@]}]}" = "$1" ] || echo "$name"
  done | tr '\n' ' '
}

said_of_share() { [ "$how" = full ] || echo "without $(wc -w <<<"$1") files, which other Blenders have: ./run matrix full has all"; }

test_debian() {
  local suite=$1 without windows
  windows=$(windows_of "$suite" | tr '\n' ' ')
  without=$(left_by "$suite")
  heading "Debian $suite"
  [ "$how" = full ] || echo "with $(wc -w <<<"$windows") of the windows"
  said_of_share "$without"
  if [ "$suite" = bookworm ]; then
    attempt "Debian $suite" "$here/../blender/run.sh" "$build/$zip" "$build/blender"
    (cd "$project" && "$here/../gui/run.sh" "$build/$zip" "$build/gui" $windows) || failed+=("Debian $suite, windows")
  else
    attempt "Debian $suite" in_root "$suite" sh -c "cd /project && SHARED_WITHOUT='$without' tests/blender/run.sh $inside/$zip \
      $inside/blender-$suite"
    attempt "Debian $suite, windows" in_root "$suite" sh -c "cd /project && tests/gui/run.sh $inside/$zip $inside/gui-$suite $windows"
  fi
}

# folder_of VERSION RELEASE, as seen from inside the root of that release.
folder_of() { [ "$2" = bookworm ] && echo "$cache/official/$1" || echo "/opt/official/$1"; }

# official_build VERB VERSION RELEASE: leaves what it is, or why it is not, in $made.
official_build() {
  local root=
  [ "$3" = bookworm ] || root=$cache/$3
  made=$("$here/official.sh" "$1" "$2" "$(folder_of "$2" "$3")" "$root" 8>&-)
}

# What each official version is, or why it is not.
declare -A is
make_official() {
  local entry version code
  for entry in "${official[@]}"; do
    version=${entry%:*} code=0
    if [ "$how" != full ] && [ "$version" = "$only_full" ]; then
      is[$version]="Blender $version: ./run matrix full alone tries it"
      continue
    fi
    official_build make "$version" "${entry#*:}" || code=$?
    is[$version]=$made
    case $code in 0) others+=("$version") ;; 3 | 4) ;; *) failed+=("Blender $version") ;; esac
  done
}

test_official() {
  local version=$1 release=$2 without folder program=official/$1/blender
  heading "${is[$version]}"
  [[ " ${others[*]} " = *" $version "* ]] || return 0
  if [ "$(date +%s)" -ge "${MATRIX_UNTIL:-9999999999}" ]; then
    echo "left out: the time of this run is over. ./run matrix tries it"
    return
  fi
  without=$(left_by "$version")
  said_of_share "$without"
  folder=$(folder_of "$version" "$release")
  if [ "$release" = bookworm ]; then
    "$here/official.sh" program "$folder" "$project" "$build/$program"
    BLENDER=$build/$program SHARED_WITHOUT=$without attempt "Blender $version" "$here/../blender/run.sh" "$build/$zip" "$build/official/$version"
  else
    "$here/official.sh" program "$folder" /project "$build/$program"
    attempt "Blender $version" in_root "$release" sh -c "cd /project && BLENDER=$inside/$program SHARED_WITHOUT='$without' \
      tests/blender/run.sh $inside/$zip $inside/official/$version"
  fi
}

if [ "$how" = plan ]; then
  for entry in "${official[@]}"; do official_build which "${entry%:*}" "${entry#*:}" || true; echo "$made"; done
  echo "The build $build is $inside in the roots"
  exit
fi
if [ "$(id -u)" -ne 0 ]; then
  echo "The matrix makes roots of other Debian releases: run it as root" >&2
  exit 1
fi
mkdir -p "$cache" "$build/modules"
exec 8>"$cache/.matrix"
flock 8

echo "Preparing roots of Debian trixie and unstable"
make_root sid & sid=$!
make_root trixie || { tail -n 20 "$build/root-trixie.log" >&2; exit 1; }
suites=(trixie) unstable=
if wait $sid; then
  suites+=(sid)
else
  reason=$(grep -E '^E:' "$build/root-sid.log" | tail -n 1 || true)
  unstable="Debian unstable cannot install its Blender today: ${reason:-$(tail -n 1 "$build/root-sid.log")}"
fi
if [ "$how" = prepare ]; then
  make_official
  printf '%s\n' "${is[@]}"
  exit
fi

echo "Building the module for ${suites[*]}"
if [ "$how" = full ]; then
  builders=()
  for suite in "${suites[@]}"; do build_in_root "$suite" & builders+=($!); done
  for builder in "${builders[@]}"; do wait "$builder"; done
else
  build_here "${suites[@]}"
fi
rm -f "$build"/splinewright-*.zip
/usr/bin/cmake --build "$build" --target zip >/dev/null
zip=$(basename "$build"/splinewright-*.zip)
echo "Packed $zip with $(ls "$build"/modules | wc -l) modules: $(ls "$build"/modules | tr "\n" " ")"

others=("${suites[@]}")
make_official
for suite in bookworm "${suites[@]}"; do test_debian "$suite"; done
[ -z "$unstable" ] || { heading "Debian unstable"; echo "$unstable"; }
for entry in "${official[@]}"; do test_official "${entry%:*}" "${entry#*:}"; done

[ ${#failed[@]} -eq 0 ] || { printf '\nFailed:\n'; printf '  %s\n' "${failed[@]}"; exit 1; }
