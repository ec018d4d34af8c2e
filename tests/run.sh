#!/usr/bin/env bash
# Installs what is missing, checks the format, builds, looks for lint, and runs every test: under the address
# and undefined-behaviour sanitizers, then optimised, but for those that tests/long_tests.txt lists (optimised alone) and
# the command line's others (under the sanitizers alone).
#
#   TAUT_SKIP_LINT=1         without clang-tidy
#   TAUT_SKIP_SANITIZERS=1   without the tests under the sanitizers
#   TAUT_THREAD_SANITIZER=1  also the tests of all that has threads (frames, films, charts, maps) under the thread
#                            sanitizer: a build of its own, too long for every day
#   TAUT_WITHOUT_OSMESA=1    also the tests of pictures in a build without OSMesa, as there will be where Mesa no
#                            longer has it
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { echo "run.sh: $*" >&2; }

# Names of files under some folders, each ended by a zero byte.
files() { find "${@:2}" -name "$1" -type f -print0; }

# Runs of tests, by the names that tests/list_tests.cmake gives them, of what has threads.
threaded='^(unit\.(Simulation|.*AnyOrder)|cli\..*(Render|Film|Compare|Chart|Check|Export|Bench|Stability|Interrupted|Killed|Failed))'

# Configures and builds a preset: all of it, or what is named.
build() {
  cmake --preset "$1" --log-level=WARNING >/dev/null
  cmake --build --preset "$1" "${@:2}" -- --quiet
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

if [ -n "${TAUT_THREAD_SANITIZER:-}" ]; then
  say "building with the thread sanitizer"
  build tsan --target unit_tests cli_tests
  say "testing with the thread sanitizer"
  ctest --preset tsan --parallel 2 --tests-regex "$threaded"
fi

say "building"
build tested

if [ -z "${TAUT_SKIP_LINT:-}" ]; then
  say "looking for lint"
  bash tests/lint.sh
fi

say "testing"
if [ -n "${TAUT_SKIP_SANITIZERS:-}" ]; then
  ctest --preset tested --parallel 2
else
  # The command line's short tests have just passed; what a machine's own instructions decide is tried again.
  ctest --preset tested --parallel 2 --label-exclude cli
  ctest --preset tested --parallel 2 --label-regex cli --label-regex long
fi

if [ -n "${TAUT_WITHOUT_OSMESA:-}" ]; then
  say "building and testing without OSMesa"
  cmake --preset tested -B build/without-osmesa -DTAUT_WITH_OSMESA=OFF --log-level=WARNING >/dev/null
  cmake --build build/without-osmesa --target render_tests -- --quiet
  build/without-osmesa/tests/render_tests --gtest_brief=1
fi
