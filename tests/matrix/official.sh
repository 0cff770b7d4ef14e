#!/usr/bin/env bash
# The official builds of Blender, which PyPI has as the module bpy: each in an environment of its own.
#   official.sh newest X.Y           the newest patch of X.Y on PyPI; 3 where that cannot be reached, 4 where it has none
#   official.sh make X.Y FOLDER [ROOT]
#       an environment in FOLDER, as seen from inside ROOT where one is given, with the newest patch; what is there stays
#       where PyPI cannot be reached. Prints what it is, or why there is none, with the same codes.
#   official.sh which X.Y FOLDER [ROOT]
#       only says what that would be
#   official.sh program FOLDER PROJECT FILE
#       writes FILE, a program that runs the module as Blender
set -euo pipefail

pip=(/usr/bin/python3 -m pip --disable-pip-version-check)
tools=(pytest)

# The Python that a version is built for.
python_of() { case $1 in 5.0 | 4.*) echo 3.11 ;; *) echo 3.13 ;; esac; }

wheels_only() { echo --python-version "$(python_of "$1")" --only-binary=:all:; }

newest() {
  local said patches
  said=$("${pip[@]}" index versions bpy $(wheels_only "$1") --retries 1 --timeout 20 -vv 2>&1) || true
  patches=$(sed -nE 's/^Available versions: //p' <<<"$said" | tr -d ' ' | tr ',' '\n' | grep -E "^${1//./\\.}\.[0-9]+$" || true)
  if [ -n "$patches" ]; then sort -V <<<"$patches" | tail -n 1; return; fi
  if grep -q 'Could not fetch URL' <<<"$said"; then
    echo "PyPI cannot be reached"
    return 3
  fi
  echo "PyPI has no Blender $1 for Python $(python_of "$1")"
  return 4
}

installed() { cat "$1/.complete" 2>/dev/null; }

inside() { [ -z "$1" ] || echo "chroot $1"; }

# What make() would give: what is there, the newest patch, or why there is none.
which_one() {
  local version=$1 here=${3:-}$2 patch code=0
  patch=$(newest "$version") || code=$?
  case $code in
    0) [ "$(installed "$here" | cut -d ' ' -f 2)" = "$patch" ] && installed "$here" || echo "Blender $patch, to be installed" ;;
    *) if installed "$here"; then echo "  ($patch: as it was kept)"; else echo "Blender $version is left out: $patch"; return $code; fi ;;
  esac
}

make() {
  local version=$1 folder=$2 root=${3:-} here=${3:-}$2 found patch
  found=$(which_one "$@") || { local code=$?; echo "$found"; return $code; }
  if [[ $found = *", to be installed" ]]; then
    patch=$(sed -E 's/Blender (.*),.*/\1/' <<<"$found")
    rm -rf "$here"
    mkdir -p "$here"
    $(inside "$root") "/usr/bin/python$(python_of "$version")" -m venv --without-pip "$folder" >&2
    "${pip[@]}" install -q $(wheels_only "$version") --ignore-requires-python --root-user-action ignore \
      --target "$here/lib/python$(python_of "$version")/site-packages" "bpy==$patch" "${tools[@]}" >&2
    found="Blender $patch with NumPy $(numpy_of "$here")"
    echo "$found" >"$here/.complete"
  fi
  echo "$found"
}

numpy_of() { basename "$(ls -d "$1"/lib/python*/site-packages/numpy-*.dist-info)" .dist-info | cut -d - -f 2; }

program() {
  mkdir -p "$(dirname "$3")"
  printf '#!/bin/sh\nBLENDER=$(realpath "$0") exec %q %q "$@"\n' "$1/bin/python" "$2/tests/blender/as_program.py" >"$3"
  chmod +x "$3"
}

verb=$1; shift
case "$verb" in
  newest | make | program) "$verb" "$@" ;;
  which) which_one "$@" ;;
  *) echo "official.sh newest|make|which|program …" >&2; exit 2 ;;
esac
