#!/usr/bin/env bash
# Installs ZIP into a throw-away Blender profile and makes every sample scene in OUTPUT; or, of some of the scenes that are here,
# the small files that go into the zip.
#   run.sh ZIP OUTPUT [small]
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
  for script in "$here"/make_*.py; do
    run_script --python "$script"
    sed -n '/\.blend: made/,$p' "$profile/log" | grep -vE '^$|^Blender quit'
  done
fi
echo "Files are in $output"
