#!/usr/bin/env bash
# workbench.sh BUILD ARCHIVE [SUITE...]: all tests of the workbench, without a window and with one, in the FreeCAD of each Debian
# (12, 13 and sid where none is named), with the add-on and the kernel of ARCHIVE, which ./dev addon --python made; windows have a
# screen of their own. WORKBENCH_TESTS, a regular expression, chooses tests ("gui.pages"). The roots stay in build/roots, so that a
# second run has FreeCAD there; what tests print and the pictures that they take, too. Adds two rows to the table of platforms,
# and ends with 1 where a test failed. Needs root, mmdebstrap, unzip and a mirror.
set -euo pipefail
build=$(realpath "$1") archive=$(realpath "$2")
shift 2
[[ $# -gt 0 ]] || set -- bookworm trixie sid
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
fail() { printf 'workbench: %s\n' "$*" >&2; exit 1; }
. "$source/tests/install/bare_root.sh"
undo() { :; }
skip_unless_root "workbench" mmdebstrap unzip
wanted=${WORKBENCH_TESTS:-.} status=0

# try NAME COMMAND...: a test, whose words go into a file; counts it.
try() {
  local name=$1 ended=0
  shift
  [[ $name =~ $wanted ]] || return 0
  "$@" >"$logs/$name.log" 2>&1 || ended=$?
  case $ended in
    0) passed+=("$name"); cases=$((cases + $(sed -n 's/^Ran \([0-9]*\) tests\{0,1\} in.*/\1/p' "$logs/$name.log" | tail -n 1 | grep . || echo 1))) ;;
    77) skipped+=("$name") ;;
    *) failed+=("$name") ;;
  esac
  printf '%s %s: %s\n' "$suite" "$name" "$ended" >&2
}

# row WHAT: what was counted, as a row of the table, where all tests were run.
row() {
  local result="${#passed[@]} of $((${#passed[@]} + ${#failed[@]})) modules, $cases tests, pass"
  ((${#failed[@]} == 0)) || { result+="; failed: ${failed[*]}"; status=1; }
  ((${#skipped[@]} == 0)) || result+="; skipped: ${skipped[*]}"
  echo "$suite, Debian $debian, $versions: $1: $result"
  [[ $wanted != . ]] || "$source/tests/platforms/table.py" add "Debian ${debian#*/}" "$1" "$versions" "$result"
}

for suite in "$@"; do
  root=$source/build/roots/$suite.freecad
  logs=$root.logs
  if [[ ! -e $root/made ]]; then
    rm -rf --one-file-system "$root"
    mkdir -p "$source/build/roots"
    bare_root apt "$root" "$suite" --include=freecad,python3-pivy,python3-numpy,xvfb,xauth,openscad,fonts-liberation,fonts-osifont,git,imagemagick
    touch "$root/made"
  fi
  mkdir -p "$root/burin" "$root/data" "$root/build" "$root/logs" "$logs"
  rm -rf "$root/addon" && unzip -q "$archive" -d "$root/addon"
  inside() {
    unshare --mount --pid --fork bash -euo pipefail -c '
      root=$1 source=$2 build=$3 logs=$4
      shift 4
      mount --bind -o ro "$source" "$root/burin"
      mount --bind "$build" "$root/build"
      mount --bind "$logs" "$root/logs"
      [[ ! -d $source/../shared/data ]] || mount --bind "$(realpath "$source/../shared/data")" "$root/data"
      mount -t proc proc "$root/proc"
      mount --rbind /dev "$root/dev"
      exec chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin:/usr/games HOME=/root LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 \
        BURIN_TEST_DATA=/data BURIN_SOURCE_DIR=/burin BURIN_ADDON=/addon/Burin BURIN_TEST_TIMEOUT=400 "$@"' \
      inside "$root" "$source" "$build" "$logs" "$@"
  }
  native=/addon/Burin/freecad/burin_wb/native
  debian=$(cat "$root/etc/debian_version")
  versions="FreeCAD $(inside dpkg-query -f '${Version}' -W freecad | sed 's/[+~-].*//'), $(inside python3 --version | sed 's/\.[0-9]*$//')"

  passed=() failed=() skipped=() cases=0
  for file in "$source"/tests/freecad/headless/test_*.py; do
    module=$(basename "$file" .py)
    try "headless.${module#test_}" inside env BURIN_PYTHON_PATH="$native" /burin/tests/freecad/headless/run.sh "$module" /tmp/headless
  done
  row "the workbench, without a window"

  passed=() failed=() skipped=() cases=0
  while IFS=$'\t' read -r name script kernel words; do
    [[ -n $name && $name != \#* ]] || continue
    kernel=${kernel/built/$native} words=${words/#-/}
    # shellcheck disable=SC2086  # words
    try "gui.$name" inside env ${words/@build@//build} /usr/bin/python3 /burin/tests/freecad/gui/run.py "$kernel" "/logs/$name" \
      "/burin/tests/freecad/gui/$script.py" </dev/null
  done <"$source/tests/freecad/gui/windows.tsv"
  row "the workbench, with a window"
done
exit "$status"
