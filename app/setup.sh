#!/usr/bin/env bash
# Installs what taut needs and is not there yet; the one place with the list of packages (Debian 12 and its
# kin). Quick when nothing is missing.
#
#   bash app/setup.sh          what building and running needs
#   bash app/setup.sh test     that, and what tests, checks and benchmarks need
set -euo pipefail

to_build=(ca-certificates cmake ninja-build g++ pkg-config
  libeigen3-dev libfmt-dev nlohmann-json3-dev libcli11-dev libtomlplusplus-dev
  libglm-dev libhwy-dev libosmesa6-dev libegl-dev libgl-dev libstb-dev libisal-dev libtiff-dev)
to_run=(ffmpeg gnuplot-nox fonts-dejavu-core)
to_test=(libgtest-dev libbenchmark-dev libbullet-dev libmujoco-dev libdeflate-dev libgmp-dev clang libclang-rt-dev clang-format clang-tidy pngcheck ccache parallel
  chromium-headless-shell)

case "${1:-run}" in
  run) wanted=("${to_build[@]}" "${to_run[@]}") ;;
  test) wanted=("${to_build[@]}" "${to_run[@]}" "${to_test[@]}") ;;
  *)
    echo "setup.sh: say run or test, not \"$1\"" >&2
    exit 2
    ;;
esac

say() { echo "setup.sh: $*" >&2; }

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v dpkg-query >/dev/null; then
  say "this is not a Debian-like system, so nothing was installed; taut needs: ${wanted[*]}"
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    say "these packages are missing, and without root or sudo they can't be installed: ${missing[*]}"
    exit 1
  fi
  as_root=(sudo)
fi

run_apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet --quiet "$@" >/dev/null; }

say "installing ${missing[*]}"
run_apt update || say "the list of packages could not be brought up to date; trying with the one there is"
if ! run_apt install --yes --no-install-recommends "${missing[@]}"; then
  say "a package could not be installed; the reason stands above. Needed: ${missing[*]}"
  exit 1
fi
