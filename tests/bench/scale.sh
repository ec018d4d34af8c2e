#!/usr/bin/env bash
# How time and memory grow with a scene: sheets of 256² to 1024² masses and chains of a hundred thousand and a
# million links, by every method that can. Prints a table in Markdown. Seconds are those of processors, all threads
# together, which say nearly the same on a busy machine.
#
#   tests/bench/scale.sh build/tested/taut [METHOD…]
set -euo pipefail

program=$(realpath "$1")
shift
methods=("$@")
[ ${#methods[@]} -gt 0 ] || methods=(xpbd verlet euler shake rattle newton dop853 spring-explicit spring-implicit)
most=${TAUT_SCALE_SECONDS:-60}  # for one run, by the clock

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sheet() {
  printf '[world]\nduration = 1\n[[sheet]]\nname = "cloth"\nrows = %d\ncolumns = %d\nfrom = [0, 2, 0]\n' "$1" "$1"
  printf 'to = [2, 2, 0]\ndown = [0, -2, 0]\nmass = 1\npinned = ["top"]\n%s' "$2"
}

chain() {
  printf '[world]\nduration = 1\n[[chain]]\nname = "rope"\nlinks = %d\nlength = 3\nfrom = [0, 2, 0]\n' "$1"
  printf 'to = [2, 2, 0]\nmass = 1\npinned = ["first", "last"]\n%s' "$2"
}

# Seconds and megabytes of a command, as two cells; or why there are none.
measured() {
  local status=0
  timeout "$most" /usr/bin/time -o "$work/usage" -f '%U %S %M' "$@" >"$work/said" 2>&1 || status=$?
  case $status in
    0) awk '{ printf "%.1f | %.0f", $1 + $2, $3 / 1024 }' "$work/usage" ;;
    124) printf 'more than %s | –' "$most" ;;
    2) printf "can't | –" ;;
    *) printf 'fails | –' ;;
  esac
}

echo '| scene | method | first frame (s) | memory (MB) | five frames (s) | memory (MB) |'
echo '|---|---|---|---|---|---|'
for method in "${methods[@]}"; do
  soft=''
  case $method in spring-*) soft='stiffness = 1000' ;; esac
  for size in 256 512 1024; do sheet "$size" "$soft" >"$work/sheet of $size².toml"; done
  for size in 100000 1000000; do chain "$size" "$soft" >"$work/chain of $size links.toml"; done
  for scene in "$work"/*.toml; do
    name=$(basename "$scene" .toml)
    first=$(measured "$program" render "$scene" --method "$method" -o "$work/frames" --overwrite --frames 1 --quiet)
    five=$(measured "$program" render "$scene" --method "$method" -o "$work/frames" --overwrite --frames 1-5 --quiet)
    echo "| $name | $method | $first | $five |"
  done
done
