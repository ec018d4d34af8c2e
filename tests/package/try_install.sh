#!/usr/bin/env bash
# Installs a build's program into a folder, moves that, and runs it as somebody would who has nothing else of taut: with
# an empty environment, from another folder. Fails where it needs anything of its source or of its build.
#
#   bash tests/package/try_install.sh BUILD
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "$1" && pwd)
there=$(mktemp -d)
trap 'rm -rf "$there"' EXIT

fail() {
  echo "try_install.sh: $*" >&2
  exit 1
}

cmake --install "$build" --prefix "$there/first" --component program >/dev/null
mv "$there/first" "$there/moved"
mkdir "$there/elsewhere"
cd "$there/elsewhere"
taut() { env -i PATH=/usr/bin:/bin "$there/moved/bin/taut" "$@"; }

for wanted in share/taut/scenes/curtain.toml share/doc/taut/README.md share/man/man1/taut.1 share/man/man1/taut-render.1 \
  share/bash-completion/completions/taut share/zsh/site-functions/_taut share/fish/vendor_completions.d/taut.fish; do
  [ -s "$there/moved/$wanted" ] || fail "$wanted is missing"
done
diff --recursive "$source/scenes" "$there/moved/share/taut/scenes" || fail "not all scenes are there as they are"

taut --version >version
grep --quiet '^taut [0-9]' version || fail "no version"
grep --quiet --fixed-strings "$source" "$there/moved/bin/taut" && fail "the program knows where its source lay"
[ "$(taut generate words scenes | wc --lines)" -eq "$(find "$source/scenes" -maxdepth 1 -name '*.toml' | wc --lines)" ] ||
  fail "it doesn't find its scenes"
taut list scenes --json >scenes.json
grep --quiet --fixed-strings "\"$there/moved/share/taut/scenes/bola.toml\"" scenes.json ||
  fail "its scenes are not those beside it"
taut render hanging-chain --size 64x48 --frames 1 --captions -o frames --quiet
[ -s frames/frame-000001.png ] || fail "no frame"

# Through a link, as in ~/bin, its scenes are found, too.
ln -s "$there/moved/bin/taut" taut
env -i ./taut still bola --at 0 --size 64x48 -o bola.png --quiet

# What it opens, where that can be watched.
if command -v strace >/dev/null && strace -o /dev/null true 2>/dev/null; then
  strace --follow-forks -e trace=%file -o opened "$there/moved/bin/taut" render bola --size 64x48 --frames 1 -o bola --quiet
  ! grep --fixed-strings -e "$source" -e "$build" opened || fail "it looked for that"
fi
