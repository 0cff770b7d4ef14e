#!/usr/bin/env bash
# Installs ZIP into a throw-away profile and drives real windows under Xvfb, two scripts at a time; pictures and what each
# prints go to OUTPUT.
#   run.sh ZIP OUTPUT [SCRIPT…]         without one every test_*.py beside this file
# SPLINEWRIGHT_SCREEN=1920x1080 gives windows of that size, for pictures; places of clicks are those of 1280x800.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
zip=$(realpath "$1"); output=$2; shift 2
scripts=("$@")
[ $# -gt 0 ] || scripts=("$here"/test_*.py)
screen=${SPLINEWRIGHT_SCREEN:-1280x800}
mkdir -p "$output"
source "$here/../blender/profile.sh"
make_profile "$zip"
said=$("$blender" --version)
sed -n '/^Blender /{p;q}' <<<"$said"
export SPLINEWRIGHT_OUTPUT=$(realpath "$output")
# A quarter of the work of a short script is to compile shaders: they are kept from one script to the next.
export MESA_SHADER_CACHE_DIR=$SPLINEWRIGHT_OUTPUT/shaders

# Starts an X server on a display that nobody has, with its picture in FOLDER, and leaves its number and process.
start_display() {
  mkdir "$1/frames"
  # Without the lock of a caller, which it would keep if that is killed.
  Xvfb -displayfd 4 -screen 0 ${screen}x24 -fbdir "$1/frames" -nolisten tcp 4>"$1/display" >/dev/null 2>&1 8>&- &
  server=$!
  local tries
  for tries in {1..600}; do
    [ -s "$1/display" ] && { DISPLAY=:$(cat "$1/display"); return; }
    kill -0 $server 2>/dev/null || break
    sleep 0.1
  done
  echo "Xvfb does not start" >&2
  return 1
}

run_script() {
  local own start=$SECONDS code=0 server
  own=$(mktemp -d)
  cp -r "$profile" "$own/home"
  start_display "$own" || return
  XVFB_FRAMES=$own/frames DISPLAY=$DISPLAY profile=$own/home timeout 1200 bash -c '
    source "$0"; blender_here --enable-event-simulate --python-exit-code 1 --window-geometry 0 0 ${2/x/ } --python "$1"
    ' "$here/../blender/profile.sh" "$1" "$screen" || code=$?
  kill $server
  wait $server 2>/dev/null || true
  rm -rf "$own"
  return $code
}

# Every second script, from the one of that number on.
run_every_second() {
  local i name said=
  for ((i = $1; i < ${#scripts[@]}; i += 2)); do
    name=$(basename "${scripts[i]}" .py)
    local start=$SECONDS log=$output/$name.log
    # What Blender calls to draw prints its errors and goes on.
    if run_script "${scripts[i]}" >"$log" 2>&1 && ! grep -q '^Traceback' "$log"; then said=passed; else said=failed; echo "-- $log"; cat "$log"; fi
    echo "$said" >"$output/$name.said"
    printf '  %-38s %-28s %6d s\n' "$name.py" "$said" $((SECONDS - start))
  done
}

start=$SECONDS
rm -f "$output"/*.said
run_every_second 0 & first=$!
run_every_second 1
wait $first
passed=$(cat "$output"/*.said | grep -c passed || true)
echo "$passed passed, $((${#scripts[@]} - passed)) failed in $((SECONDS - start)) s"
[ "$passed" = ${#scripts[@]} ]
