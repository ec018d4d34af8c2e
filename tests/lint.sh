#!/usr/bin/env bash
# Looks for lint in app/ and src/: prints what clang-tidy finds, and fails. What was clean once is not looked at
# again until it, a header or the list of checks changes.
#
# Nearly all of clang-tidy's time goes into the headers that files share, so it reads several files as one.
# Where it finds something in them (which may only be two files with a name in common), it reads each half, and
# so on: only what it finds in a file on its own counts.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seen=build/lint/seen
mkdir -p "$seen"

# clang-tidy reads clang's precompiled headers and knows the compile commands from this preset.
cmake --preset lint --log-level=WARNING >/dev/null
cmake --build --preset lint --target taut_common_headers taut_light_headers -- --quiet

headers=$({ cat .clang-tidy; find app src -name '*.h' -type f | sort | xargs cat; } | sha256sum)
export seen headers

mark() { echo "$seen/$({ echo "$headers"; cat "$1"; } | sha256sum | cut --characters=1-32)"; }

look_at() {
  local file status=0
  if [ $# -eq 1 ]; then
    clang-tidy -p build/lint --quiet "$1" 2>/dev/null || return 1
    touch "$(mark "$1")"
    return
  fi
  # The name of the first file, in a folder of its own, gives clang-tidy the first file's compile command.
  local together=build/lint/together/$1
  mkdir -p "$(dirname "$together")"
  printf '#include "%s"\n' "${@/#/$PWD/}" >"$together"
  if clang-tidy -p build/lint --quiet "$together" >/dev/null 2>&1; then
    for file in "$@"; do touch "$(mark "$file")"; done
    return
  fi
  look_at "${@:1:$#/2}" || status=1
  look_at "${@:$#/2+1}" || status=1
  return $status
}
export -f mark look_at

for target in app src/*/; do
  find "$target" -name '*.cpp' -type f | sort | while read -r file; do
    [ -e "$(mark "$file")" ] || echo "$file"
  done | xargs --no-run-if-empty --max-args=6
done | xargs --no-run-if-empty --max-procs=2 --replace bash -c 'look_at {}'
