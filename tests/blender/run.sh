#!/usr/bin/env bash
# Installs ZIP into a throw-away profile and runs the tests of this folder inside Blender.
#   run.sh ZIP OUTPUT [PYTEST ARGUMENTS]      BLENDER names another Blender than the one on the path
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1"); output=$2; shift 2
mkdir -p "$output"
source "$here/profile.sh"
make_profile "$zip"
"$blender" --version | head -n 1
SPLINEWRIGHT_ZIP=$zip SPLINEWRIGHT_OUTPUT=$(realpath "$output") \
  blender_here --background --python-exit-code 1 \
  --python "$here/run.py" -- "$@"
