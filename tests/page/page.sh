#!/usr/bin/env bash
# Makes a page of two objects, and one of two materials, uses them in a headless Chromium (use_page.mjs, use_materials.mjs), and holds what it shows to `burl render`:
#   page.sh SCRATCH BURL
# Exit 77 (skipped) where Chromium or Node is not installed, or burl was built without the viewer of pages.
set -euo pipefail
scratch=$1 burl=$2
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "SKIPPED: $1"; exit 77; }
command -v node >/dev/null || skip "node is not installed"
chromium=$(command -v chromium) || skip "chromium is not installed"

rm -rf "$scratch"
mkdir -p "$scratch/pictures"
cd "$scratch"
for material in oak gold; do "$burl" bake sample:bust -o $material.glb --recipe $material --size 256 --quiet; done
"$burl" page oak.glb gold.glb -o page >/dev/null 2>page.log || {
    grep -q "without the viewer" page.log && skip "built without the viewer of pages"
    cat page.log
    exit 1
}
mv page elsewhere # nothing of it names where it was made
node "$here/use_page.mjs" "$chromium" elsewhere pictures
"$burl" bake "$here/pair.gltf" -o pair.glb --assign a=oak --assign b=gold --atlas-per recipe --size 64 --quiet
"$burl" page pair.glb -o pair >/dev/null
node "$here/use_materials.mjs" "$chromium" pair

size=$(cat pictures/size) bad=0
"$burl" render gold.glb -o studio.png --light studio --size "$size"
"$burl" render oak.glb -o sun.png --light sun --turn-light 90 --size "$size"
"$burl" render oak.glb -o base.png --unlit --supersample 1 --size "$size"
while read -r name bound; do
    line=$("$burl" diff $name.png pictures/$name.png --surface --tolerance 1)
    echo "$name: $line"
    awk -v bound="$bound" '{ for (i = 1; i < NF; ++i) if ($i == "PSNR" && $(i + 1) + 0 < bound) exit 1 }' <<<"$line" || bad=$((bad + 1))
done <<<"studio 28
sun 32
base 34"
echo "$bad of 3 pictures below their bound"
[[ $bad == 0 ]]
