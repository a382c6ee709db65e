#!/usr/bin/env bash
# tests/bench/judge/judge.sh BUILD HLR MODEL...: the feature lines of each CAD part beside OCCT's hidden-line removal,
# two views each, and the times of both. HLR is a program `HLR exact|poly FILE OUT.json dx dy dz` that prints the visible
# lines of OCCT's exact or polygonal algorithm on the view plane, with its own seconds. A row: model, view, algorithm;
# length of our lines (mm) and the share with a partner; the same of theirs; spans that rays call wrong: ours too
# many, ours missing, theirs too many, theirs missing; seconds of theirs (meshing, hiding) and of ours less reading.
# Our seams are drawn, and count as partners only.
set -uo pipefail
build=$(cd "$1" && pwd); hlr=$2; shift 2
scratch=$(mktemp -d); trap 'rm -rf "$scratch"' EXIT
limit=${BURIN_JUDGE_LIMIT:-60}
printf '%-34s %-12s %-6s %8s %7s %8s %7s %6s %7s %6s %7s %8s %8s %8s\n' model view other ours % theirs % extra missing \
  o.extra o.miss mesh_s hlr_s burin_s
for model in "$@"; do
  for view in 1,-1,1 -0.4,-1,0.55; do
    read -r -a v <<<"${view//,/ }"
    name=$(basename "$model")
    "$build/bin/burin" draw "$model" --style outline --set feature.seams=true --view="$view" -o "$scratch/d.json" --verbose 2>"$scratch/log" || {
      printf '%-34s %-12s %s\n' "$name" "$view" "$(grep 'burin: error' "$scratch/log")"; continue; }
    ours=$(awk '/^burin: stage read/ { r += $4 } /^burin: total/ { t = $3 } END { printf "%.3f", t - r }' "$scratch/log")
    for other in poly exact; do
      timeout "$limit" "$hlr" "$other" "$model" "$scratch/o.json" "${v[@]}" >/dev/null 2>&1
      status=$?
      if ((status != 0)); then
        why="ended with status $status"; ((status == 124)) && why="no answer within $limit s"
        printf '%-34s %-12s %-6s %s; burin %s s\n' "$name" "$view" "$other" "$why" "$ours"; continue
      fi
      row=$("$build/bin/burin_judge" "$model" "$scratch/d.json" "$other=$scratch/o.json" 2>&1) || {
        printf '%-34s %-12s %s\n' "$name" "$view" "$row"; continue; }
      read -r -a fields <<<"$row"
      printf '%-34s %-12s %-6s %8s %7s %8s %7s %6s %7s %6s %7s %8s %8s %8s\n' "$name" "$view" "${fields[0]}" "${fields[1]}" \
        "${fields[2]}" "${fields[3]}" "${fields[4]}" "${fields[6]}" "${fields[8]}" "${fields[10]}" "${fields[12]}" \
        "${fields[14]}" "${fields[16]}" "$ours"
    done
  done
done
