#!/usr/bin/env bash
# Installs the extension for Linux into official builds and Debian's Blender, from the file and from the repository, and
# runs the self-test in each.
#   in_blender.sh DIST BUILD CACHE
set -euo pipefail
here=$(cd -P "$(dirname "$0")" && pwd)
project=$(realpath "$here/../..")
dist=$(realpath "$1"); build=$(realpath "$2"); cache=$3
matrix=$project/tests/matrix
inside=/project/${build#"$project"/}
zip=$(ls "$dist"/splinewright-*-linux-x64.zip)

heading() { printf '\n== %s\n' "$*"; }

# VERSION RELEASE: the Blender of PyPI, in this system or in a root of the Debian whose Python it is built for.
try_official() {
  local folder=$cache/official/$1 root= made code=0
  [ "$2" = bookworm ] || { folder=/opt/official/$1; root=$cache/$2; }
  [ -z "$root" ] || "$matrix/root.sh" make "$2" "$root" >"$build/root-$2.log" 2>&1
  made=$("$matrix/official.sh" make "$1" "$folder" "$root") || code=$?
  heading "$made"
  case $code in 0) ;; 3 | 4) return ;; *) exit 1 ;; esac
  local program=release/official/$1/blender
  if [ -z "$root" ]; then
    "$matrix/official.sh" program "$folder" "$project" "$build/$program"
    BLENDER=$build/$program "$here/installed.sh" "$zip" "$dist/repository"
  else
    "$matrix/official.sh" program "$folder" /project "$build/$program"
    "$matrix/root.sh" run "$root" "$project" sh -c "cd /project && BLENDER=$inside/$program native/release/installed.sh \
      ${zip/#$project//project} ${dist/#$project//project}/repository"
  fi
}

for entry in 4.2:bookworm 4.5:bookworm 5.0:bookworm 5.1:trixie 5.2:trixie; do try_official "${entry%:*}" "${entry#*:}"; done
