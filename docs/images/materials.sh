#!/usr/bin/env bash
# Draws the gallery of docs/guide/materials.md: every material of assets/materials on the bust, by Blender.
# Debian's packages blender, python3-numpy (its importer's) and webp are needed.
#   docs/images/materials.sh build/release/bin/burl [NAME...]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
burl=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [[ $# == 0 ]]; then
    set -- $(basename -s .json "$here"/../../assets/materials/*.json)
fi
for name in "$@"; do
    "$burl" bake sample:bust -o "$scratch/$name.glb" --recipe "$name" --size 1024 --quiet
done
blender --background --python-exit-code 1 --python "$here/materials.py" -- "$scratch" 40 "$scratch"/*.glb >"$scratch/log" ||
    { tail -20 "$scratch/log"; exit 1; }
mkdir -p "$here/materials"
for picture in "$scratch"/*.png; do
    cwebp -quiet -q 82 "$picture" -o "$here/materials/$(basename "$picture" .png).webp"
done
