#!/usr/bin/env bash
# Simulates a scene once and exports that in every format into a folder:
# export_all.sh TAUT SCENE FOLDER FRAMES_PER_SECOND
set -euo pipefail
taut=$1 scene=$2 folder=$3 rate=$4
mkdir -p "$folder"
"$taut" simulate "$scene" --quiet --fps "$rate" -o "$folder/simulated"
export_as() { "$taut" export --quiet --motion "$folder/simulated" "$@"; }
for table in masses links energy orientations; do export_as --table "$table" -o "$folder/$table.csv"; done
for table in energy orientations; do export_as --table "$table" -o "$folder/$table.npz"; done
for ending in npz usda glb; do export_as -o "$folder/motion.$ending"; done
for format in vtp obj ply pc2; do export_as --format "$format" -o "$folder/$format"; done
