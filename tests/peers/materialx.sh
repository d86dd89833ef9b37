#!/usr/bin/env bash
# Holds the nodes of MaterialX's functions (points), and the documents that Burl writes, to the shaders of MaterialX's own
# generator, drawn in Chromium:
#   materialx.sh points|recipes|baked MODULES SCRATCH BURL [POINTS]
# Exit 77 (skipped) where Node, Chromium or the package is not installed.
set -euo pipefail
what=$1 modules=$2 scratch=$3 burl=$4
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "SKIPPED: $1"; exit 77; }

command -v node >/dev/null || skip "node is not installed"
chromium=$(command -v chromium) || skip "chromium is not installed"
[[ -d $modules/node_modules/@needle-tools/materialx ]] ||
    skip "MaterialX is not installed (npm install --prefix $modules @needle-tools/materialx)"
rm -rf "$scratch"
mkdir -p "$scratch"
case $what in
    points)
        command -v python3 >/dev/null || skip "python3 is not installed"
        python3 "$here/materialx_points.py" "$modules" "$chromium" "$burl" "$scratch" "${5:-10000}" ;;
    recipes) node "$here/materialx_recipes.mjs" "$modules" "$chromium" "$burl" "$scratch" ;;
    baked)
        cd "$scratch"
        for material in oak rust lava crackle-glaze ice leather opal; do
            "$burl" bake sample:teapot -o $material.mtlx --recipe $material --size 256 --quiet
        done
        glass='{"texture": {"node": "stripes", "a": "#ff800040", "b": "#2040ff", "period": 0.2},
            "material": {"transmission": 0.5, "sheen": {"node": "scale", "a": "#80ff40", "b": {"node": "coordinate"}}}}'
        echo "$glass" >glass.json
        "$burl" bake sample:bust -o glass.mtlx --recipe glass.json --size 256 --quiet
        "$burl" bake sample:bust -o cut.mtlx --recipe glass.json --set material.alpha=mask --size 256 --quiet
        "$burl" bake sample:bust -o objects.mtlx --recipe rust --normals object --size 256 --quiet
        node "$here/materialx_baked.mjs" "$modules" "$chromium" ./*.mtlx ;;
esac
