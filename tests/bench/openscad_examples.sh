#!/usr/bin/env bash
# Draws every example of the Debian package openscad: openscad_examples.sh BURIN [FOLDER].
# One line each: name, exit status, seconds, what was recognised or what is wrong.
set -uo pipefail
burin=$1
folder=${2:-$(mktemp -d)}
failed=0
while IFS= read -r file; do
  name=$(basename "$file" .scad)
  start=$(date +%s.%N)
  "$burin" draw "$file" -o "$folder/$name.svg" --verbose 2>"$folder/$name.log"
  status=$?
  said=$(grep -o 'approximate: .*\|error: .*' "$folder/$name.log" | head -1)
  printf '%-22s %s %6.1f  %s\n' "$name" "$status" "$(echo "$(date +%s.%N) - $start" | bc)" "$said"
  [[ $status -eq 0 || $said == *'2-D object'* || $said == *'makes nothing'* ]] || failed=1
done < <(find /usr/share/openscad/examples -name '*.scad' | sort)
exit "$failed"
