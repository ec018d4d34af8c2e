#!/usr/bin/env bash
# Installs a build's libraries into a folder, moves that, builds the programs here against it, and runs them.
#
#   bash tests/library/try.sh BUILD
set -euo pipefail
programs=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
there=$(mktemp -d)
trap 'rm -rf "$there"' EXIT

cmake --install "$1" --prefix "$there/first" --component library >/dev/null
mv "$there/first" "$there/moved"
# Not from a registry of packages, nor from anywhere else.
env -u CPATH cmake -S "$programs" -B "$there/build" -G Ninja -DCMAKE_PREFIX_PATH="$there/moved" \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" --log-level=WARNING
cmake --build "$there/build" -- --quiet
for program in step_a_chain judge_two_methods bring_a_method; do
  echo "$program:"
  "$there/build/$program"
done
