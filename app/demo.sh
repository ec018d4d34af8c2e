#!/usr/bin/env bash
# From nothing to films: installs what is missing, builds taut, and renders the showcases with films into out/.
# Running it again is quick, because what is there already is kept.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scenes=(hanging-chain curtain breaking-cloth)

bash app/setup.sh run
cmake --preset release --log-level=WARNING
cmake --build --preset release -- --quiet

# What a taut that moves or draws otherwise or another version of a scene made is replaced: status 4 says that this is the case.
render() {
  local status=0
  build/release/taut render "$@" || status=$?
  if [ "$status" -eq 4 ]; then
    build/release/taut render "$@" --overwrite
  else
    return "$status"
  fi
}

for scene in "${scenes[@]}"; do
  render "scenes/$scene.toml" -o "out/$scene" --film "out/$scene.mp4"
done

echo
echo "Done. Films, and the frames they are made of:"
for scene in "${scenes[@]}"; do
  echo "  $PWD/out/$scene.mp4   $PWD/out/$scene/"
done
