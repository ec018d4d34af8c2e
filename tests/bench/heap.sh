#!/usr/bin/env bash
# What a step takes while balls that are let go over a funnel fall into a heap, and how many times as much for ten
# times as many. Prints a table in Markdown: milliseconds of a processor a step, over the frames of each part of the run.
#
#   tests/bench/heap.sh build/tested/taut [SECONDS COUNT…]
set -euo pipefail

program=$(realpath "$1")
seconds=${2:-3}
shift $(($# < 2 ? $# : 2))
counts=("$@")
[ ${#counts[@]} -gt 0 ] || counts=(1000 10000 100000)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A block of balls of 0.1 m, 0.13 m apart, over four slopes that meet in one point; 8 MiB hold 100,000.
heap() {
  printf '[world]\nduration = %s\n[solve]\nmethod = "xpbd"\nsteps_per_second = 240\n' "$seconds"
  printf '[camera]\neye = [0, 8, 14]\ntarget = [0, 1, 0]\n'
  for slope in '0.3, 1, 0' '-0.3, 1, 0' '0, 1, 0.3' '0, 1, -0.3'; do
    printf '[[plane]]\npoint = [0, 0, 0]\nnormal = [%s]\nfriction = 0.5\n' "$slope"
  done
  awk -v count="$1" 'BEGIN {
    srand(1); side = int(count ^ (1 / 3)) + 1; gap = 0.13
    for (i = 0; i < count; ++i)
      printf "[[mass]]\nname=\"m%d\"\nposition=[%.3f,%.2f,%.3f]\nradius=0.05\ncollides=true\n", i,
             (i % side - side / 2) * gap + 0.02 * rand() - 0.01, 0.3 * gap * side + 0.5 + int(i / side) % side * gap,
             (int(i / side / side) - side / 2) * gap + 0.02 * rand() - 0.01
  }'
}

echo '| balls | part of the run (s) | a step (ms) |'
echo '|---|---|---|'
for count in "${counts[@]}"; do
  heap "$count" >"$work/heap.toml"
  "$program" render "$work/heap.toml" --size 64x48 --no-frames --film "$work/heap.mp4" --metrics "$work/heap.csv" \
    --overwrite --quiet
  # 240 steps a second are eight a frame of 30.
  python3 - "$work/heap.csv" "$count" "$seconds" <<'PYTHON'
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1])))[1:]
parts = 6
for part in range(parts):
    some = rows[len(rows) * part // parts:len(rows) * (part + 1) // parts]
    begin, end = float(some[0]["time"]), float(some[-1]["time"])
    step = sum(float(row["simulate_seconds"]) for row in some) / len(some) / 8 * 1000
    print(f"| {sys.argv[2]} | {begin:.2f}–{end:.2f} | {step:.2f} |")
PYTHON
done
