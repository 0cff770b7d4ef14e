# To be sourced. make_profile ZIP makes a throw-away Blender profile with the add-on installed and
# enabled in it; blender_here runs Blender in that profile.

blender=${BLENDER:-blender}

make_profile() {
  profile=$(mktemp -d)
  trap 'rm -rf "$profile"' EXIT
  local here=${BASH_SOURCE[0]%/*}
  if is_extension_blender; then
    blender_here --command extension validate "$1"
  fi
  blender_here --background --python-exit-code 1 --python "$here/install.py" -- "$1" >"$profile/install.log" 2>&1 ||
    { cat "$profile/install.log" >&2; return 1; }
}

# Extensions came with Blender 4.2.
is_extension_blender() {
  local version
  version=$("$blender" --version | sed -nE 's/^Blender ([0-9]+\.[0-9]+).*/\1/p')
  [ "$(printf '%s\n' 4.2 "$version" | sort -V | head -n 1)" = 4.2 ]
}

blender_here() {
  HOME=$profile XDG_CONFIG_HOME=$profile/.config XDG_CACHE_HOME=$profile/.cache \
    PYTHONDONTWRITEBYTECODE=1 "$blender" "$@"
}
