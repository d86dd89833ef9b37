#!/usr/bin/env bash
# Makes your-asset.webp: an animated leg out of Blender, carved, at three moments. Needs Debian's blender, netpbm and webp.
#   docs/images/your-asset.sh build/release/bin/burl
set -euo pipefail
burl=$(realpath "$1")
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
blender -b --python your-asset.py -- "$scratch/leg.glb" >"$scratch/log" 2>&1
"$burl" bake "$scratch/leg.glb" -o "$scratch/carved.glb" --assign "Wood*=oak" --assign "Metal*=brushed-steel" --size 2048
for moment in 0.2 0.8 1.2; do
    "$burl" render "$scratch/carved.glb" -o "$scratch/$moment.png" --pose "RigAction@$moment" --view 40,15,3.2 --size 320x320 --supersample 4
done
for moment in 0.2 0.8 1.2; do pngtopnm "$scratch/$moment.png" >"$scratch/$moment.ppm"; done
pnmcat -lr "$scratch"/{0.2,0.8,1.2}.ppm | pnmtopng >"$scratch/all.png"
cwebp -quiet -q 85 "$scratch/all.png" -o your-asset.webp
