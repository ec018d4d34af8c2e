#!/usr/bin/env bash
# Installs what is missing, checks format and lint, builds, and runs every test: optimised, then under the
# address and undefined-behaviour sanitizers.
#
#   TAUT_SKIP_LINT=1         without clang-tidy
#   TAUT_SKIP_SANITIZERS=1   without the second run
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { echo "run.sh: $*" >&2; }

# Names of files under some folders, each ended by a zero byte.
files() { find "${@:2}" -name "$1" -type f -print0; }

build_and_test() {
  cmake --preset "$1" --log-level=WARNING
  cmake --build --preset "$1" -- --quiet
  ctest --preset "$1" --parallel 2
}

bash app/setup.sh test

say "checking the format"
{ files '*.h' app src tests; files '*.cpp' app src tests; } | xargs --null clang-format --dry-run --Werror

if [ -z "${TAUT_SKIP_SANITIZERS:-}" ]; then
  say "building and testing with sanitizers"
  build_and_test asan
fi

say "building"
cmake --preset tested --log-level=WARNING
cmake --build --preset tested -- --quiet

if [ -z "${TAUT_SKIP_LINT:-}" ]; then
  say "looking for lint"
  files '*.cpp' app src | xargs --null --max-procs=2 --max-args=8 clang-tidy -p build/tested --quiet
fi

say "testing"
ctest --preset tested --parallel 2
