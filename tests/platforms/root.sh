#!/usr/bin/env bash
# root.sh SUITE COMMAND...: runs a command of ./dev in another Debian, e.g. `root.sh trixie test -R cli`. Its root stays in
# build/roots/SUITE, so that the second run has its packages and its compiler cache; what is built there is in
# build/roots/SUITE.build. Needs root, mmdebstrap and a mirror. The status is that of the command.
set -euo pipefail
suite=$1
shift
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
fail() { printf 'dev: error: %s\n' "$*" >&2; exit 1; }
. "$source/tests/install/bare_root.sh"
((EUID == 0)) || fail "only root makes a root of $suite"
root=$source/build/roots/$suite
if [[ ! -e $root/made ]]; then
  rm -rf --one-file-system "$root"
  mkdir -p "$(dirname "$root")"
  bare_root apt "$root" "$suite"
  touch "$root/made"
fi
mkdir -p "$root/burin" "$root.build" "$root/data"
# Mounts of its own go with the process.
status=0
unshare --mount --pid --fork bash -euo pipefail -c '
  root=$1 source=$2
  shift 2
  mount --bind "$source" "$root/burin"
  mount --bind "$root.build" "$root/burin/build"
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  exec chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 /burin/dev "$@"
' root.sh "$root" "$source" "$@" 2>&1 | tee "$root.log" || status=$?
# What a whole run of the tests came to stands in the page.
said=$(sed -n 's/^\([0-9]*% tests passed.*\)$/\1/p' "$root.log" | tail -n 1)
if [[ $1 == test && $# == 1 && -n $said ]]; then
  "$source/tests/platforms/table.py" add "Debian $(sed 's|.*/||' "$root/etc/debian_version")" "./dev test" \
    "$(chroot "$root" bash -c 'echo "g++ $(g++ -dumpfullversion), $(python3 --version)"')" "$said"
fi
exit "$status"
