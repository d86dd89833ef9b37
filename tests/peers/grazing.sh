#!/usr/bin/env bash
# Pictures of a carved floor and of a hull at 5 degrees, by `burl render` and by three.js with 16 lookups a pixel, held to the texture
# itself:
#   grazing.sh MODULES SCRATCH BURL [XATLAS]
# prints a PSNR for every picture, and leaves the pictures in SCRATCH. Charts must not be worse than patches by more than 0.5 dB
# anywhere, nor than the bounds below; 16 lookups must win 3 dB over one. Where XATLAS, a folder whose node_modules holds
# xatlas-wasm, is named, its unwrapping is drawn as well. Without node exit 77 (skipped), without Chromium or three.js our pictures alone.
set -euo pipefail
modules=$1 scratch=$2 burl=$3 xatlas=${4:-}
here=$(cd "$(dirname "$0")" && pwd)
command -v node >/dev/null || { echo "SKIPPED: node is not installed"; exit 77; }
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
node "$here/grazing_meshes.mjs" .
kinds=(chart patch)
[[ -z $xatlas ]] || kinds+=(xatlas0 xatlas4)
chromium=$(command -v chromium) && [[ -d $modules/node_modules/three ]] || { chromium= && echo "SKIPPED: three.js draws nothing, chromium or three is absent"; }

bake() { # MESH KIND RECIPE...
    local mesh=$1 kind=$2
    shift 2
    if [[ $kind == xatlas* ]]; then
        node "$here/unwrap.mjs" "$xatlas" "$mesh.obj" "$mesh-$kind.obj" "${kind#xatlas}"
        "$burl" bake "$mesh-$kind.obj" -o "$mesh-$kind.glb" --atlas uv "$@" --size 1024 --quiet
    else
        "$burl" bake "$mesh.obj" -o "$mesh-$kind.glb" --atlas "$kind" "$@" --size 1024 --quiet
    fi
}

draw() { # MESH VIEW SIZE RECIPE...
    local mesh=$1 look=(--unlit --view "$2" --size "$3") size=$3 view=$2 kind lookups pictures=()
    shift 3
    "$burl" render --direct "$mesh.obj" -o "$mesh-truth.png" "$@" "${look[@]}" --supersample 16
    "$burl" render "$mesh-places.obj" -o "$mesh-places.png" "${look[@]}" --supersample 1
    "$burl" render "$mesh-places.obj" -o "$mesh-places-mean.png" "${look[@]}" --supersample 8
    for kind in "${kinds[@]}"; do
        bake "$mesh" "$kind" "$@"
        for lookups in 1 16; do
            "$burl" render "$mesh-$kind.glb" -o "$mesh-$kind.$lookups.png" "${look[@]}" --supersample 1 --filter mip --anisotropy "$lookups"
            pictures+=("$mesh-$kind.$lookups.png")
        done
        [[ -z $chromium ]] || pictures+=("$mesh-$kind.three.png")
    done
    [[ -z $chromium ]] || node "$here/grazing.mjs" draw "$modules" "$chromium" "$view" "$size" 16 $(printf "$mesh-%s.glb " "${kinds[@]}")
    node "$here/grazing.mjs" psnr "$mesh-truth.png" "$mesh-places.png" "$mesh-places-mean.png" "${pictures[@]}" | tee -a psnr
}

draw floor 20,5,1.1 640x160 --recipe marble --set solid.scale=12
draw plain 20,5,1.1 640x160 --recipe marble --set solid.scale=12
draw hull 0,5,1.8 320x320 --recipe wood --set solid.scale=14
awk '
    { dB[$1] = $2; if ($3 < 5000) { print "FAILED: " $1 " has " $3 " pixels"; bad = 1 } }
    function atLeast(name, bound) { if (!(dB[name] >= bound)) { print "FAILED: " name " has " dB[name] " dB, not " bound; bad = 1 } }
    END {
        atLeast("floor-chart.16", 32.5); atLeast("plain-chart.16", 45); atLeast("hull-chart.16", 38.5)
        atLeast("floor-chart.16", dB["floor-patch.16"] - 0.5); atLeast("hull-chart.16", dB["hull-patch.16"] - 0.5)
        atLeast("plain-chart.16", dB["plain-patch.16"] - 0.5)
        atLeast("floor-chart.16", dB["floor-chart.1"] + 3); atLeast("hull-chart.16", dB["hull-chart.1"] + 3)
        if ("hull-chart.three" in dB) {
            atLeast("floor-chart.three", 32.5); atLeast("plain-chart.three", 42.5); atLeast("hull-chart.three", 41.5)
            atLeast("floor-chart.three", dB["floor-patch.three"] - 0.5); atLeast("hull-chart.three", dB["hull-patch.three"] - 0.5)
        }
        exit bad
    }' psnr
