#!/usr/bin/env bash
# Starts ccache for a project whose headers are precompiled, so that one clone finds what another compiled. SANITIZE_PROJECT is
# the folder of the project.
# Clang refuses a precompiled header whose source lies elsewhere, so each clone makes its own. For ccache a sum of all that it
# was made from stands for it, and paths are as seen from the build.
set -euo pipefail
if [[ " $* " = *" -emit-pch "* ]]; then
  arguments=" $* "
  made=${arguments##* -o } read=${arguments##* -MF }
  made=${made%% *} read=${read%% *}
  "$@"
  sed -e 's/^[^:]*://' -e 's/\\$//' "$read" | xargs sha256sum | cut -d ' ' -f 1 | sha256sum >"$made.sum"
  exit
fi
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
