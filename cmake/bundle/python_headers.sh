#!/usr/bin/env bash
# python_headers.sh SUITE FOLDER: the headers of the Python of a Debian (bookworm, trixie, sid) and of its pybind11 as
# FOLDER/cpXY, from the packages themselves: nothing of them is run. Prints the tag, cpXY. What is there is taken.
# Needs mmdebstrap and a mirror.
set -euo pipefail
suite=$1 folder=$2
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/bare_root.sh"
fail() { printf 'python_headers: %s\n' "$*" >&2; exit 1; }
if [[ -s $folder/$suite ]]; then
  cat "$folder/$suite"
  exit
fi
mkdir -p "$folder"
scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT
bare_root extract "$scratch/root" "$suite" --include=python3-dev,pybind11-dev
headers=$(echo "$scratch"/root/usr/include/python3.*)
[[ -s $headers/Python.h ]] || fail "$suite has no headers of one Python"
tag=cp$(basename "$headers" | tr -dc '0-9')
rm -rf "${folder:?}/$tag"
mkdir "$folder/$tag"
# Python.h of Debian asks for MULTIARCH/python3.X/pyconfig.h.
cp -r "$headers" "$folder/$tag/python"
for machine in "$scratch"/root/usr/include/*/"$(basename "$headers")"; do
  mkdir -p "$folder/$tag/$(basename "$(dirname "$machine")")"
  cp -r "$machine" "$folder/$tag/$(basename "$(dirname "$machine")")/"
done
cp -r "$scratch/root/usr/include/pybind11" "$folder/$tag/"
echo "$tag" | tee "$folder/$suite"
