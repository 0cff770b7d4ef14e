#!/usr/bin/env bash
# Installs the headers that the library is built with from their sources, where a system has none or old ones: AlmaLinux 8.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# from REPOSITORY COMMIT OPTION…
from() {
  local source=$scratch/source
  rm -rf "$source" "$scratch/build"
  git init -q "$source"
  git -C "$source" fetch -q --depth 1 "$1" "$2"
  git -C "$source" checkout -q FETCH_HEAD
  cmake -S "$source" -B "$scratch/build" -DBUILD_TESTING=OFF -DBUILD_SHARED_LIBS=OFF "${@:3}" >"$scratch/log" 2>&1 &&
    cmake --install "$scratch/build" >>"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; exit 1; }
}

from https://gitlab.com/libeigen/eigen 3147391d946bb4b6c68edd901f2add6ac1f31f8c -DEIGEN_BUILD_DOC=OFF       # 3.4.0
from https://github.com/g-truc/glm 0af55ccecd98d4e5a8d1fad7de25ba429d60e863 -DGLM_BUILD_LIBRARY=OFF -DGLM_BUILD_TESTS=OFF   # 1.0.1
from https://github.com/nlohmann/json 9cca280a4d0ccf0c08f47a99aa71d1b0e52f8d03 -DJSON_BuildTests=OFF        # 3.11.3
