#!/usr/bin/env bash
# Installs ZIP into a throw-away profile and drives real windows under Xvfb; pictures go to OUTPUT.
#   run.sh ZIP OUTPUT [SCRIPT…]         without one every test_*.py beside this file
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1"); output=$2; shift 2
scripts=("$@")
[ $# -gt 0 ] || scripts=("$here"/test_*.py)
mkdir -p "$output"
source "$here/../blender/profile.sh"
make_profile "$zip"
mkdir "$profile/frames"
export HOME=$profile XDG_CONFIG_HOME=$profile/.config XDG_CACHE_HOME=$profile/.cache PYTHONDONTWRITEBYTECODE=1
export XVFB_FRAMES=$profile/frames SPLINEWRIGHT_OUTPUT=$(realpath "$output")
for script in "${scripts[@]}"; do
  timeout 300 xvfb-run -a -s "-screen 0 1280x800x24 -fbdir $profile/frames" \
    "$blender" --enable-event-simulate --python-exit-code 1 --window-geometry 0 0 1280 800 --python "$script"
done
