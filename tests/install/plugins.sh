#!/usr/bin/env bash
# plugins.sh PREFIX SOURCE SCRATCH: does what kernel/docs/plugins.md says, line by line, with an installed Burin and an empty
# home; then builds the template, which knows the installed package alone, and draws with it.
set -euo pipefail
prefix=$1 source=$2 scratch=$3
fail() { printf 'install test: %s\n' "$*" >&2; exit 1; }

export HOME=$scratch/home PATH=$prefix/bin:$PATH
unset XDG_DATA_HOME XDG_CACHE_HOME BURIN_PLUGIN_PATH
mkdir -p "$HOME"
awk '/^## A direction/ { on = 1; next } /^## / { on = 0 } on && /^    / && !/^   [^ ]/ { print }' \
  "$source/kernel/docs/plugins.md" | grep -E '^ +(cp|cc|mkdir|burin) ' |
  sed "s#-I/usr/local/include#-I$prefix/include#" >"$scratch/tutorial"
(($(wc -l <"$scratch/tutorial") == 6)) || { cat "$scratch/tutorial"; fail "the tutorial has other steps than these"; }
cd "$source"
# shellcheck disable=SC1091
source "$scratch/tutorial" >"$scratch/said"
grep -q '^spiral 1.0 (' "$scratch/said" || { cat "$scratch/said"; fail "the tutorial's plug-in is not listed"; }
[[ -s $HOME/spiral/vase.svg ]] || fail "the tutorial draws nothing"

cmake -G Ninja -S "$source/samples/plugins/template" -B "$scratch/waves" -DCMAKE_PREFIX_PATH="$prefix" \
  >"$scratch/log" 2>&1 && cmake --build "$scratch/waves" >>"$scratch/log" 2>&1 &&
  cmake --install "$scratch/waves" >>"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "the template does not build"; }
burin draw "$source/samples/vase.ply" -o "$scratch/waves.svg" --quiet --set tone.law=waves --set tone.waves.length=8 ||
  fail "the template's plug-in does not draw"
