#!/usr/bin/env bash
# The extension in throw-away profiles of one Blender, from its zip and from a repository, each with the self-test.
#   installed.sh ZIP REPOSITORY      BLENDER names the program
set -euo pipefail
here=$(cd -P "$(dirname "$0")" && pwd)
profiles=$(mktemp -d)
trap 'rm -rf "$profiles"; [ -z "${server:-}" ] || kill "$server"' EXIT

in_profile() {
  local profile=$profiles/$1; shift
  mkdir -p "$profile"
  BLENDER_USER_RESOURCES=$profile "$BLENDER" --background --python-exit-code 1 "$@" 2>&1 | grep -vE "^(Warning|PROGRESS|STATUS|Info: |Blender quit|$)"
}

in_profile file --python "$here/install.py" -- file "$1"

python3 -m http.server --directory "$2" --bind 127.0.0.1 8749 >/dev/null 2>&1 & server=$!
in_profile repository --python "$here/install.py" -- repository http://127.0.0.1:8749/index.json
