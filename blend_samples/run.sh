#!/usr/bin/env bash
# Installs ZIP into a throw-away Blender profile and makes sample scenes in OUTPUT, all or those that are named; or, of some of the
# scenes that are here, the small files that go into the zip. With SPLINEWRIGHT_DRAFT pictures are rendered quickly.
#   run.sh ZIP OUTPUT [NAME... | small]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1")
mkdir -p "$2"; output=$(realpath "$2")
source "$here/../tests/blender/profile.sh"
make_profile "$zip"
run_script() {
  blender_here --background --python-exit-code 1 "$@" -- "$output" >"$profile/log" 2>&1 || { cat "$profile/log" >&2; exit 1; }
}
if [ "${3:-}" = small ]; then
  for name in vase shampoo mouse hull; do
    run_script "$here/$name.blend" --python "$here/small_sample.py"
    grep '^packed' "$profile/log"
  done
else
  scripts=("$here"/make_*.py)
  if [ $# -gt 2 ]; then
    scripts=("${@:3}")
    scripts=("${scripts[@]/#/$here/make_}")
    scripts=("${scripts[@]/%/.py}")
  fi
  count=0
  for script in "${scripts[@]}"; do
    name=${script##*/make_}
    echo "[$((++count)) of ${#scripts[@]}] ${name%.py}"
    run_script --python "$script"
    sed -n '/\.blend: made/,$p' "$profile/log" | grep -vE '^$|^Blender quit'
  done
fi
echo "Files are in $output"
