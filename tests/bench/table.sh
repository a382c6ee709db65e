#!/usr/bin/env bash
# tests/bench/table.sh BUILD [RUNS]: times the whole command on meshes of 100,000 and of 1,000,000 triangles, and prints a
# table: the median of RUNS runs (3), seconds a stage, peak memory, and the total over the time to read the file
# and build the tree of rays alone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$(cd "$1" && pwd)
runs=${2:-3}
burin=$build/bin/burin
scratch=$build/bench
meshes=$scratch/meshes
stages=(read build curvature field cover trace features visibility compose write)
mkdir -p "$meshes"
[[ -s $meshes/knot_1m.stl && $meshes/knot_1m.stl -nt $build/bin/burin_samples ]] ||
  "$build/bin/burin_samples" large "$meshes"

echo
echo "machine: $(nproc) cores, $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1)"
BURIN_BENCH_MESHES=$meshes "$build/bin/burin_bench" --benchmark_filter='^baseline/' --benchmark_format=json \
  2>/dev/null >"$scratch/baseline.json"
# baseline MESH: seconds of reading plus tree.
baseline() {
  awk -v name="\"name\": \"baseline/$1/" 'index($0, name) { found = 1 }
    found && /"(read|tree)":/ { gsub(/[",]/, ""); sum += $2 }
    found && /}/ { printf "%.4f", sum; exit }' "$scratch/baseline.json"
}

printf '%-11s %-10s' mesh style
printf ' %8s' "${stages[@]}" total MB 'x read+tree'
echo
for mesh in knot_100k moai_100k knot_1m moai_1m; do
  base=$(baseline "$mesh")
  for style in outline technical engraving; do
    for ((run = 0; run < runs; ++run)); do
      log=$scratch/$mesh-$style-$run.log
      /usr/bin/time -f 'burin: peak %M' "$burin" draw "$meshes/$mesh.stl" --style "$style" \
        -o "$scratch/$mesh-$style.svg" --verbose 2>"$log" || { cat "$log" >&2; exit 1; }
    done
    # The run with the median total speaks for the others.
    pick=$(for ((run = 0; run < runs; ++run)); do
      printf '%s %s\n' "$(awk '/^burin: total/ { print $3 }' "$scratch/$mesh-$style-$run.log")" "$run"
    done | sort -n | sed -n "$(((runs + 1) / 2))p" | cut -d' ' -f2)
    awk -v mesh="$mesh" -v style="$style" -v names="${stages[*]}" -v base="$base" '
      /^burin: stage/ { time[$3] += $4 }
      /^burin: total/ { total = $3 }
      /^burin: peak/ { peak = $3 / 1024 }
      END {
        printf "%-11s %-10s", mesh, style
        n = split(names, stage, " ")
        for (i = 1; i <= n; ++i) printf " %8.3f", time[stage[i]]
        printf " %8.3f %8.0f %8.2f\n", total, peak, (base > 0 ? total / base : 0)
      }' "$scratch/$mesh-$style-$pick.log"
  done
done
