#!/usr/bin/env bash
# Makes your-asset.webp: an animated leg out of Blender, carved, at three moments. Needs burl, blender, montage and cwebp.
set -euo pipefail
cd "$(dirname "$0")"
scratch=$(mktemp -d)
blender -b --python your-asset.py -- "$scratch/leg.glb" >"$scratch/log" 2>&1
burl bake "$scratch/leg.glb" -o "$scratch/carved.glb" --assign "Wood*=oak" --assign "Metal*=brushed-steel" --size 2048
for moment in 0.2 0.8 1.2; do
    burl render "$scratch/carved.glb" -o "$scratch/$moment.png" --pose "RigAction@$moment" --view 40,15,3.2 --size 320x320 --supersample 4
done
montage "$scratch"/0.2.png "$scratch"/0.8.png "$scratch"/1.2.png -tile 3x1 -geometry +0+0 "$scratch/all.png"
cwebp -quiet -q 85 "$scratch/all.png" -o your-asset.webp
rm -r "$scratch"
