# What tests of packages share; sourced by them, after `set -euo pipefail`. It makes a folder, $scratch, that goes when the test
# ends; what else is to be undone before stands in a function `undo`.

# skip_unless_root TEST TOOL...: ends the test, well, where it cannot be done.
skip_unless_root() {
  local test=$1 tool
  shift
  ((EUID == 0)) || { echo "$test: skipped: only root makes a root folder"; exit 0; }
  for tool in "$@"; do
    command -v "$tool" >/dev/null || { echo "$test: skipped: $tool is not there"; exit 0; }
  done
  scratch=$(mktemp -d)
  trap 'undo; rm -rf --one-file-system "$scratch"' EXIT
  trap 'exit 130' INT TERM
}

# bare_root VARIANT TARGET [SUITE [OPTION...]]: a bare Debian (12 where no suite is named) as a folder or a .tar, from the mirrors of
# this machine, where they are Debian's own and of that suite. Options are mmdebstrap's.
bare_root() {
  local mirrors=() file suite=${3:-bookworm}
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources; do
    [[ -s $file ]] && grep -q "$suite" "$file" && mirrors+=("$file")
  done
  # The lists of a moving suite may be days old on a mirror; their signatures are looked at all the same.
  mmdebstrap --quiet --variant="$1" --aptopt='Acquire::Check-Valid-Until "false"' "${@:4}" "$suite" "$2" "${mirrors[@]}" ||
    fail "no bare root; is there a mirror of $suite?"
}
