#!/usr/bin/env bash
# Exports two scenes in every format and has other programs read them back: NumPy and pandas, VTK, Blender, and
# three.js in Chromium. Installs them (Debian 12; 200 MB), as root or by sudo. What it says stands in docs/exports.md.
#
#   bash tests/foreign/read_back.sh [TAUT [PICTURE.png]]     the picture: what the browser draws
set -euo pipefail
cd "$(dirname "$0")/../.."
taut=$(realpath "${1:-build/release/taut}")
picture=${2:-}
here=tests/foreign
packages=(python3-numpy python3-pandas python3-vtk9 blender chromium-headless-shell libjs-three)
if ! dpkg-query --show "${packages[@]}" >/dev/null 2>&1; then
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get install --yes --no-install-recommends "${packages[@]}" >/dev/null
fi
python=/usr/bin/python3 # Debian's own, which has its packages
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

read_back() {
  local scene=$1 cloth=$2 rate=$3
  echo "$(basename "$scene" .toml), $rate frames a second"
  bash "$here/export_all.sh" "$taut" "$scene" "$folder/$cloth" "$rate"
  "$python" "$here/check_arrays.py" "$folder/$cloth" "$cloth"
  "$python" "$here/check_usda.py" "$folder/$cloth" "$cloth"
  "$python" "$here/check_vtk.py" "$folder/$cloth" "$cloth"
  blender --background --python-exit-code 1 --python "$here/check_blender.py" -- "$folder/$cloth" "$cloth" |
    grep 'as the CSV says'
  "$python" "$here/check_browser.py" "$folder/$cloth" "$cloth" ${picture:+"$picture"}
}

read_back "$here/shapes.toml" cloth 10
read_back torn-flag flag 4
