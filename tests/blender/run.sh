#!/usr/bin/env bash
# Installs ZIP into a throw-away profile and runs the tests of this folder inside Blender: all of them in two processes,
# or as the arguments say in one.
#   run.sh ZIP OUTPUT [PYTEST ARGUMENTS]      BLENDER names another Blender than the one on the path
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1"); output=$2; shift 2
mkdir -p "$output"
source "$here/profile.sh"
make_profile "$zip"
said=$("$blender" --version)             # whole: a program whose reader goes away fails
sed -n '/^Blender /{p;q}' <<<"$said"
export SPLINEWRIGHT_ZIP=$zip SPLINEWRIGHT_OUTPUT=$(realpath "$output")

tests_in_blender() {
  blender_here --background --python-exit-code 1 --python "$here/run.py" -- "$@"
}

if [ $# -gt 0 ]; then
  tests_in_blender "$@"
  exit
fi
source "$here/../sharing/share.sh"
cp -r "$profile" "$profile-1"
trap 'rm -rf "$profile" "$profile-1"' EXIT
one_side() {
  [ "$SHARED_SIDE" = 0 ] || profile=$profile-1
  tests_in_blender "$here"
}
share "$SPLINEWRIGHT_OUTPUT/logs" one_side
