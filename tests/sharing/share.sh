# To be sourced. `share LOGS COMMAND…` runs COMMAND, which runs pytest with the plugin beside this file, in two processes
# that share its test files, and says what came of all of them. COMMAND finds 0 or 1 in SHARED_SIDE; each keeps what it
# prints in LOGS/side-N.log, and what failed is shown.

share() {
  local logs=$1 start=$SECONDS side code=0 sides=() summary=${BASH_SOURCE[0]%/*}/summary.py; shift
  mkdir -p "$logs"
  SHARED_FOLDER=$(mktemp -d)
  export SHARED_FOLDER SHARED_OUTPUT=3
  for side in 0 1; do
    SHARED_SIDE=$side "$@" 3>&1 >"$logs/side-$side.log" 2>&1 </dev/null &
    sides+=($!)
  done
  for side in 0 1; do
    wait "${sides[$side]}" || { code=1; show_failures "$logs/side-$side.log"; }
  done
  python3 "$summary" "$SHARED_FOLDER" "$((SECONDS - start))" || code=1
  rm -rf "$SHARED_FOLDER"
  return $code
}

# From the first failure on; the end where there is none, since it crashed or never began.
show_failures() {
  local first='^=+ (FAILURES|ERRORS) =+$'
  echo "-- $1"
  if grep -qE "$first" "$1"; then sed -nE "/$first/,\$p" "$1"; else tail -n 60 "$1"; fi
}
