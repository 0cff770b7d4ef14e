#!/usr/bin/env bash
# Starts ccache with paths as seen from the build: clang's options for precompiled headers it leaves as they are, and would
# find nothing in another clone. SANITIZE_PROJECT is the folder of the project.
up=$(realpath --relative-to=. "$SANITIZE_PROJECT")
arguments=()
for argument in "$@"; do
  if [[ $argument != -D* ]]; then
    argument=${argument//"$PWD/"/}
    argument=${argument//"$SANITIZE_PROJECT/"/"$up/"}
  fi
  arguments+=("$argument")
done
exec ccache "${arguments[@]}"
