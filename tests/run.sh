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
  bash tests/lint.sh
fi

say "testing"
ctest --preset tested --parallel 2
