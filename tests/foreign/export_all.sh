#!/usr/bin/env bash
# Exports a scene in every format into a folder: export_all.sh TAUT SCENE FOLDER [flags of taut export …]
set -euo pipefail
taut=$1 scene=$2 folder=$3
shift 3
mkdir -p "$folder"
for table in masses links energy orientations; do
  "$taut" export "$scene" --quiet --table "$table" -o "$folder/$table.csv" "$@"
done
for table in energy orientations; do
  "$taut" export "$scene" --quiet --table "$table" -o "$folder/$table.npz" "$@"
done
for ending in npz usda glb; do
  "$taut" export "$scene" --quiet -o "$folder/motion.$ending" "$@"
done
for format in vtp obj ply pc2; do
  "$taut" export "$scene" --quiet --format "$format" -o "$folder/$format" "$@"
done
