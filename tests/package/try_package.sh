#!/usr/bin/env bash
# Tries a package where nothing else of taut is: in a bare Debian, made for the purpose, it is installed by apt, makes a
# film from another folder, and is purged; then nothing of it may be left. Needs root, the network and debootstrap.
#
#   bash tests/package/try_package.sh taut_0.1.0_amd64.deb [bookworm|trixie] [--no-recommends]
set -euo pipefail

package=$(readlink --canonicalize-existing "$1")
suite=${2:-bookworm}
recommends=${3:-}
bare=$(mktemp -d)/bare

say() { echo "try_package.sh: $*"; }
inside() { chroot "$bare" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
# All files but those in which dpkg, apt and the loader keep books of their own.
listed() {
  (cd "$bare" && find . -xdev \( -path ./proc -o -path ./var/log -o -path ./var/lib/dpkg -o -path ./var/lib/apt -o -path ./var/cache \) -prune -o -print) | sort
}
leave() {
  umount "$bare/proc" 2>/dev/null || true
  rm -rf "$(dirname "$bare")"
}
trap leave EXIT

say "making a bare $suite"
if [ -n "${TAUT_BARE:-}" ]; then
  cp --archive "$TAUT_BARE" "$bare"  # one made before
else
  debootstrap --variant=minbase "$suite" "$bare" http://deb.debian.org/debian >/dev/null
fi
mount -t proc proc "$bare/proc"
inside apt-get update -qq
say "$(inside sh -c '. /etc/os-release; echo "$PRETTY_NAME"'), $(inside dpkg-query --list | grep --count ^ii) packages"
listed >"$bare.before"

cp "$package" "$bare/var/cache/taut.deb"
say "apt install ./taut.deb ${recommends:+--no-install-recommends}"
inside apt-get install --yes -qq ${recommends:+--no-install-recommends} /var/cache/taut.deb >"$bare.log" 2>&1 || {
  tail -20 "$bare.log"
  exit 1
}
say "$(inside dpkg-query --list | grep --count ^ii) packages"

inside mkdir /tmp/elsewhere
run() {
  say "\$ $*"
  inside sh -c "cd /tmp/elsewhere && $*"
}
run "taut --version"
run "taut list scenes | wc -l"
if [ -z "$recommends" ]; then
  run "taut render hanging-chain --film x.mp4 --no-frames"
  run "ffprobe -v error -show_entries stream=codec_name,width,height,nb_frames -of csv=p=0 x.mp4"
  run "taut chart pendulum --budget 2s --quiet -o chart; ls chart/*.png | wc -l"
else
  run "taut render hanging-chain --film x.mp4 --no-frames || echo status \$?"
fi
run "taut still curtain --at 1s --captions -o curtain.png"
run "taut new rope && taut render rope.toml --frames 1 && ls out/rope"

say "apt purge taut"
inside sh -c 'rm -rf /tmp/elsewhere "$HOME/.cache"'
# With what came along only because others recommend it.
inside apt-get purge --yes -qq --autoremove -o APT::AutoRemove::RecommendsImportant=false \
  -o APT::AutoRemove::SuggestsImportant=false taut >/dev/null 2>&1
inside rm /var/cache/taut.deb
listed >"$bare.after"
if inside find / -xdev -name '*taut*' | grep .; then
  say "that is left of taut"
  exit 1
fi
say "$(inside dpkg-query --list | grep --count ^ii) packages, and no file with taut in its name; beside logs and lists, that differs from before:"
{ diff "$bare.before" "$bare.after" || true; } | sed --quiet '/^[<>]/p'
