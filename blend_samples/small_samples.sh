#!/usr/bin/env bash
# Installs ZIP into a throw-away Blender profile and packs small files of some sample scenes, for the zip, into OUTPUT.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1")
mkdir -p "$2"; output=$(realpath "$2")
source "$here/../tests/blender/profile.sh"
make_profile "$zip"
for name in vase shampoo mouse hull; do
  blender_here --background --python-exit-code 1 "$here/$name.blend" --python "$here/small_sample.py" -- "$output" >"$profile/log" 2>&1 ||
    { cat "$profile/log" >&2; exit 1; }
  grep '^packed' "$profile/log"
done
