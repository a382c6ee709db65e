#!/usr/bin/env bash
# tests/bench/sections/sections.sh BURIN_SECTIONS FILE...: a process a file, so that none takes another down; first all
# rows (file#solid, plane, triangles, whether the part is closed, whether the cut is, how its area stands to OCCT's,
# areas, loops, difference over deflection times perimeter, distance of the loops from the exact faces over the
# deflection, seconds of the cut and of OCCT), then their sum. BURIN_SECTIONS_LIMIT: seconds a file may take (300).
set -uo pipefail
program=$1; shift
rows=$(mktemp); trap 'rm -f "$rows"' EXIT
for file in "$@"; do
  timeout "${BURIN_SECTIONS_LIMIT:-300}" "$program" "$file" >>"$rows" 2>/dev/null || echo "$file - - - - ENDED status $?" >>"$rows"
done
cat "$rows"
awk '$1 == "#" { next } $3 != "-" { n++; closes[$4 " " $5]++; verdict[$6]++; if ($9 != $10 && $6 == "agrees") loops++ }
     $3 == "-" { other[$6]++ }
     END { print n " cuts"; for (k in closes) print "  part and cut: " k, closes[k]; for (k in verdict) print "  area: " k, verdict[k];
           print "  other count of loops where areas agree: " loops + 0; for (k in other) print "  " k, other[k] }' "$rows"
for column in 13 14; do
  awk -v c=$column '$1 != "#" && $3 != "-" { print $c }' "$rows" | sort -g | awk -v c=$column '{ v[NR] = $1 }
    END { if (NR) printf "  seconds %s: median %s, 9 of 10 within %s, longest %s\n", c == 13 ? "of a cut" : "of OCCT", v[int((NR + 1) / 2)], v[int(NR * 0.9 + 0.5)], v[NR] }'
done
