#!/usr/bin/env bash
# tests/bench/verify.sh BURIN FILE...: draws each file with --verify, three views in two styles (BURIN_VERIFY_STYLES,
# BURIN_VERIFY_VIEWS change them), and prints a row each: file, view, style, spans and mm tested, mm and places that rays
# contradict, loose ends of the outer outline, seconds of processor and MB at the peak. BURIN_VERIFY_LIMIT: seconds a
# drawing may take (120). BURIN_VERIFY_OPTIONS: further options of the drawing, say --section y. The places themselves follow, one a line, indented.
set -uo pipefail
burin=$1; shift
limit=${BURIN_VERIFY_LIMIT:-120}
scratch=$(mktemp -d); trap 'rm -rf "$scratch"' EXIT
printf '%-40s %-14s %-10s %7s %9s %9s %6s %5s %7s %6s\n' file view style spans mm wrong_mm places loose cpu_s MB
for file in "$@"; do
  for view in ${BURIN_VERIFY_VIEWS:-iso 0.3,-1,0.45 -0.4,-1,0.55}; do
    for style in ${BURIN_VERIFY_STYLES:-outline engraving}; do
      /usr/bin/time -f '%U %S %M' -o "$scratch/time" timeout "$limit" "$burin" draw "$file" --view="$view" --style "$style" \
        ${BURIN_VERIFY_OPTIONS:-} --verify --no-progress -o "$scratch/d.json" 2>"$scratch/log"
      status=$?
      name=$(basename "$file")
      if ((status != 0)); then
        printf '%-40s %-14s %-10s ended with status %s: %s\n' "$name" "$view" "$style" "$status" "$(tail -1 "$scratch/log")"
        continue
      fi
      read -r user system kb < <(tail -1 "$scratch/time")
      sed -n 's/^burin: verify: \([0-9.]*\) of \([0-9.]*\) mm contradicted ([^)]*) in \([0-9]*\) places, \([0-9]*\) loose ends of the outline; \([0-9]*\) spans tested$/\5 \2 \1 \3 \4/p' \
        "$scratch/log" >"$scratch/row"
      read -r spans mm wrong places loose <"$scratch/row"
      printf '%-40s %-14s %-10s %7s %9s %9s %6s %5s %7.2f %6d\n' "$name" "$view" "$style" "$spans" "$mm" "$wrong" "$places" \
        "$loose" "$(echo "$user + $system" | bc)" "$((kb / 1024))"
      grep -E 'burin: warning: .* at [-0-9.]+,[-0-9.]+ mm of the sheet' "$scratch/log" | sed 's/^burin: warning:/   /'
    done
  done
done
