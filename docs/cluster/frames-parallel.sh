#!/usr/bin/env bash
# Simulates a scene once and draws its frames in several processes at a time, by GNU parallel. Stopped at any
# moment and run again, it goes on.
#   bash docs/cluster/frames-parallel.sh SCENE SHARDS FOLDER [render's flags, such as --size 1920x1080]
set -eu
scene=$1 shards=$2 folder=$3
shift 3
taut=${TAUT:-taut}

"$taut" simulate "$scene" -o "$folder/motion"
# Two tries a shard: one that was stopped goes on from the frames that it has. --halt: when one is lost for good
# the others still end whole.
seq "$shards" | parallel --will-cite --retries 2 --halt soon,fail=1 \
  "$taut" render --motion "$folder/motion" -o "$folder/frames" --threads 1 --quiet --shard "{}/$shards" "$@"
"$taut" merge "$folder/frames" --film "$folder/film.mp4"
