#!/usr/bin/env bash
# Holds moments of an animated, skinned document that was baked back into itself to what three.js draws of it, unlit:
#   animated.sh MODULES SCRATCH BURL GLTF_SAMPLES
# `burl render --pose` must agree to 45 dB on the object's pixels. Exit 77 (skipped) where the other program is not installed.
set -euo pipefail
modules=$1 scratch=$2 burl=$3 samples=$4
here=$(cd "$(dirname "$0")" && pwd)
view=30,20,3.5 side=256
skip() { echo "SKIPPED: $1"; exit 77; }

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
command -v node >/dev/null || skip "node is not installed"
chromium=$(command -v chromium) || skip "chromium is not installed"
[[ -d $modules/node_modules/three ]] || skip "three is not installed (npm install --prefix $modules three)"
"$samples" .
pictures=()
for name in skin_animated skin_bytes morph_animated two_materials_skin; do
    "$burl" bake kept_$name.gltf -o $name.glb --recipe oak --size 512 --quiet
    for moment in 0.1 0.5 0.9; do pictures+=("$name.glb@$moment"); done
done
node "$here/three_js.mjs" "$modules" "$chromium" unlit $view $side "${pictures[@]}"
bad=0
for picture in "${pictures[@]}"; do
    file=${picture%@*} moment=${picture#*@} animation="move rotation"
    if [[ $file == morph* ]]; then animation="move weights"; fi
    ours=${file%.glb}@$moment.png
    "$burl" render "$file" -o "$ours" --pose "$animation@$moment" --unlit --filter mip --view $view --size ${side}x$side
    line=$("$burl" diff "$ours" "${file%.glb}@$moment.three.png" --surface --tolerance 1)
    echo "$picture: $line"
    awk '{ for (i = 1; i < NF; ++i) if ($i == "PSNR" && $(i + 1) + 0 < 45) exit 1 }' <<<"$line" || bad=$((bad + 1))
done
echo "$bad of ${#pictures[@]} pictures below 45 dB"
[[ $bad == 0 ]]
