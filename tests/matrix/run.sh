#!/usr/bin/env bash
# Packs one zip with a module for every Python, and runs the Blender tests with that very file on the
# Blender of Debian 12 (this system), of Debian 13 and of Debian unstable.
#   run.sh BUILD CACHE       CACHE keeps the roots of the other releases
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
project=$(realpath "$here/../..")
build=$1; cache=$2
if [ "$(id -u)" -ne 0 ]; then
  echo "The matrix makes roots of other Debian releases: run it as root" >&2
  exit 1
fi
mkdir -p "$cache"

in_root() { local suite=$1; shift; "$here/root.sh" run "$cache/$suite" "$project" "$@"; }

# The folder of the build, as seen from inside a root.
inside=/project/${build#"$project"/}

make_root() {
  echo "Preparing a root of Debian $1"
  "$here/root.sh" make "$1" "$cache/$1" >"$build/root-$1.log" 2>&1
}

build_module() {
  echo "Building the module in Debian $1"
  in_root "$1" sh -c "
    cmake -S /project -B $inside/roots/$1 -G Ninja -DCMAKE_BUILD_TYPE=Release -DSPLINEWRIGHT_TESTS=OFF &&
    cmake --build $inside/roots/$1 --target _splinecore &&
    cp -u $inside/roots/$1/python/splinecore/_splinecore.*.so $inside/modules/" >"$build/module-$1.log" 2>&1 ||
    { tail -n 40 "$build/module-$1.log" >&2; return 1; }
}

run_tests() {
  local suite=$1 zip=$2
  echo; echo "== Debian $suite"
  in_root "$suite" sh -c "cd /project && tests/blender/run.sh $inside/$zip $inside/blender-$suite &&
    tests/gui/run.sh $inside/$zip $inside/gui-$suite"
}

suites=()
unstable=
make_root trixie || { tail -n 20 "$build/root-trixie.log" >&2; exit 1; }
suites+=(trixie)
if make_root sid; then
  suites+=(sid)
else
  reason=$(grep -E '^E:' "$build/root-sid.log" | tail -n 1 || true)
  unstable="Debian unstable cannot install its Blender today: ${reason:-$(tail -n 1 "$build/root-sid.log")}"
fi

mkdir -p "$build/modules"
for suite in "${suites[@]}"; do build_module "$suite"; done
rm -f "$build"/splinewright-*.zip
/usr/bin/cmake --build "$build" --target zip >/dev/null
zip=$(basename "$build"/splinewright-*.zip)
echo "Packed $zip with $(ls "$build"/modules | wc -l) modules: $(ls "$build"/modules | tr "\n" " ")"

echo; echo "== Debian bookworm"
"$here/../blender/run.sh" "$build/$zip" "$build/blender"
for suite in "${suites[@]}"; do run_tests "$suite" "$zip"; done
[ -z "$unstable" ] || echo "$unstable"
