#!/usr/bin/env bash
# Installs ZIP into a throw-away Blender profile and makes sample scenes in OUTPUT, all or those that are named, two at a time;
# or, of some of the scenes that are here, the small files that go into the zip. With SPLINEWRIGHT_DRAFT pictures are rendered
# quickly.
#   run.sh ZIP OUTPUT [NAME... | small]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1")
mkdir -p "$2"; output=$(realpath "$2")
source "$here/../tests/blender/profile.sh"
make_profile "$zip"
# run_script LOG ARGUMENTS of Blender
run_script() {
  local log=$1; shift
  blender_here --background --python-exit-code 1 "$@" -- "$output" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
}

# Every second scene, from the one of that number on.
make_every_second() {
  local i name log=$profile/log-$1
  for ((i = $1; i < ${#scripts[@]}; i += 2)); do
    run_script "$log" --python "${scripts[i]}"
    name=$(basename "${scripts[i]}" .py)
    printf '[%d of %d] %s\n%s\n' $((i + 1)) ${#scripts[@]} "${name#make_}" \
      "$(sed -n '/\.blend: made/,$p' "$log" | grep -vE '^$|^Blender quit')"
  done
}

if [ "${3:-}" = small ]; then
  for name in vase shampoo mouse hull; do
    run_script "$profile/log" "$here/$name.blend" --python "$here/small_sample.py"
    grep '^packed' "$profile/log"
  done
else
  scripts=("$here"/make_*.py)
  if [ $# -gt 2 ]; then
    scripts=("${@:3}")
    scripts=("${scripts[@]/#/$here/make_}")
    scripts=("${scripts[@]/%/.py}")
  fi
  make_every_second 0 & first=$!
  make_every_second 1 & second=$!
  wait $first
  wait $second
fi
echo "Files are in $output"
