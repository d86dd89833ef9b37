#!/usr/bin/env bash
# Holds pictures of materials by `burl render` to those that other programs draw of the same .glb under the same light:
#   compare.sh three.js|cycles MODULES SCRATCH BURL
# three.js must agree to 32 dB on the object's pixels under two soft boxes, Cycles to 30 dB under a sun and a constant sky (diffuse
# materials and rough metals, whose light it sums over many paths and without MIP levels; Blender's importer leaves the occlusion
# map out, so those files have none). Exit 77 (skipped) where the other program is not installed.
set -euo pipefail
peer=$1 modules=$2 scratch=$3 burl=$4
here=$(cd "$(dirname "$0")" && pwd)
view=30,20,3.5 side=256
skip() { echo "SKIPPED: $1"; exit 77; }

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
command -v node >/dev/null || skip "node is not installed"

draw_by_three_js() {
    local chromium
    chromium=$(command -v chromium) || skip "chromium is not installed"
    [[ -d $modules/node_modules/three ]] || skip "three is not installed (npm install --prefix $modules three)"
    node "$here/three_js.mjs" "$modules" "$chromium" environment.hdr $view $side "$@"
}

draw_by_cycles() {
    command -v blender >/dev/null || skip "blender is not installed"
    blender --background --python-exit-code 1 --python "$here/cycles.py" -- environment.hdr $view $side 128 4 "$@" >cycles.log 2>&1 ||
        { tail -20 cycles.log; exit 1; }
}

light=boxes
case $peer in
    three.js) suffix=three bound=32 mesh=bust set=() draw=(--tone neutral)
        materials="oak cherry carrara granite-grey malachite gold brushed-steel hammered-copper rust leather crackle-glaze lava" ;;
    cycles) suffix=cycles bound=30 mesh=icosphere set=(--set material.occlusion=1) draw=(--tone none --filter linear --supersample 8)
        side=128 light=sun materials="sandstone concrete brick-wall cast-iron rust hammered-copper" ;;
esac
node "$here/environment.mjs" environment.hdr $light
files=()
for material in $materials; do
    "$burl" bake sample:$mesh -o $material.glb --recipe $material --size 512 --quiet "${set[@]}"
    files+=("$material.glb")
done
if [[ $peer == three.js ]]; then draw_by_three_js "${files[@]}"; else draw_by_cycles "${files[@]}"; fi
bad=0
for material in $materials; do
    "$burl" render $material.glb -o $material.png --light environment.hdr "${draw[@]}" --view $view --size ${side}x$side
    line=$("$burl" diff $material.png $material.$suffix.png --surface --tolerance 1)
    echo "$material: $line"
    awk -v bound=$bound '{ for (i = 1; i < NF; ++i) if ($i == "PSNR" && $(i + 1) + 0 < bound) exit 1 }' <<<"$line" || bad=$((bad + 1))
done
echo "$bad of $(wc -w <<<"$materials") materials below $bound dB"
[[ $bad == 0 ]]
