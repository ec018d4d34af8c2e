#!/usr/bin/env bash
# Installs what is missing, checks the format, builds, looks for lint, and runs every test: under the address
# and undefined-behaviour sanitizers, then optimised.
#
#   TAUT_SKIP_LINT=1         without clang-tidy
#   TAUT_SKIP_SANITIZERS=1   without the tests under the sanitizers
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { echo "run.sh: $*" >&2; }

# Names of files under some folders, each ended by a zero byte.
files() { find "${@:2}" -name "$1" -type f -print0; }

build() {
  cmake --preset "$1" --log-level=WARNING >/dev/null
  cmake --build --preset "$1" -- --quiet
}

# What was clean once is not looked at again until it, a header or the list of checks changes.
lint() {
  local seen=build/tested/lint-seen headers
  mkdir -p "$seen"
  headers=$({ cat .clang-tidy; files '*.h' app src | sort --zero-terminated | xargs --null cat; } | sha256sum)
  export seen headers
  # shellcheck disable=SC2016  # for the shells that xargs starts
  files '*.cpp' app src | xargs --null --max-procs=2 --max-args=1 bash -c '
    mark=$seen/$({ echo "$headers"; cat "$1"; } | sha256sum | cut --characters=1-32)
    [ -e "$mark" ] && exit
    clang-tidy -p build/tested --quiet "$1" 2>/dev/null || exit 1
    touch "$mark"' lint
}

bash app/setup.sh test

say "checking the format"
{ files '*.h' app src tests; files '*.cpp' app src tests; } | xargs --null clang-format --dry-run --Werror

if [ -z "${TAUT_SKIP_SANITIZERS:-}" ]; then
  say "building with sanitizers"
  build asan
  say "testing with sanitizers"
  ctest --preset asan --parallel 2
fi

say "building"
build tested

if [ -z "${TAUT_SKIP_LINT:-}" ]; then
  say "looking for lint"
  lint
fi

say "testing"
ctest --preset tested --parallel 2
