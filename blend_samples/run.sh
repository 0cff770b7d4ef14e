#!/usr/bin/env bash
# Installs ZIP into a throw-away Blender profile and makes every sample scene in OUTPUT.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1")
mkdir -p "$2"; output=$(realpath "$2")
source "$here/../tests/blender/profile.sh"
make_profile "$zip"
for script in "$here"/make_*.py; do
  blender_here --background --python-exit-code 1 --python "$script" -- "$output" >"$profile/log" 2>&1 ||
    { cat "$profile/log" >&2; exit 1; }
  sed -n '/\.blend: made/,$p' "$profile/log" | grep -vE '^$|^Blender quit'
done
echo "Files are in $output"
