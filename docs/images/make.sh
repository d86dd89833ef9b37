#!/usr/bin/env bash
# Makes all pictures of README.md and docs/guide/ anew, and some of the other shelves, by Burl itself; those of materials are Blender's (materials.sh).
#   docs/images/make.sh build/release/bin            all of them
#   docs/images/make.sh build/release/bin PART...    some: teapot atlases solid mip bumps precision turntable sheet editor tour graph asset figures materials serpentine page grazing blender
# Debian's packages netpbm (atlases, solid, mip, bumps, precision, asset, grazing), webp (editor, tour, graph, asset, materials, page, grazing, blender), blender with
# python3-numpy (asset, materials, blender), nodejs and chromium (page, grazing) are needed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bin=$(cd "${1:?the folder of the programs is missing, such as build/release/bin}" && pwd)
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
burl=$bin/burl

teapot() { # README, docs/guide/first-bake.md
    local recipe=(--recipe wood --set solid.scale=9 --filter trapezoid --quiet)
    "$burl" bake sample:teapot -o "$scratch/teapot.glb" "${recipe[@]}" --size 1024
    "$burl" render "$scratch/teapot.glb" -o "$here/readme-teapot.png" --view 25,24,2.6 --size 480x360 --supersample 3 --ground
    "$burl" bake sample:teapot -o "$scratch/readme-atlas.png" "${recipe[@]}" --size 256
    cp "$scratch/readme-atlas.png" "$here" # without the record of the bake
}

atlases() { # docs/guide/atlases.md, docs/reference/atlases.md
    "$burl" metrics sample:teapot --atlas all --levels --size 512 --image "$scratch/teapot" >"$scratch/metrics"
    local kind
    for kind in {area,quad,patch,chart}-{charts,levels} {area,patch}-scale; do
        pngtopnm "$scratch/teapot-$kind.png" | pamscale 0.5 | pnmquant -quiet 256 | pnmtopng -compression 9 >"$here/$kind.png"
    done
}

bumps() { # docs/guide/bumps.md, docs/reference/bump.md
    local mesh recipe size view
    while read -r mesh recipe size view; do
        "$burl" render "sample:$mesh" --lazy --recipe "$recipe" --view "$view" --size "$size" --supersample 3 -o "$scratch/$mesh.png"
    done <<<'teapot hammered 240x180 30,20,2.6
torus orange-peel 210x180 30,40,3.2
king carved-wood 90x180 30,15,3.5'
    "$burl" bake sample:teapot -o "$scratch/hammered.png" --recipe hammered --size 512 --quiet
    pngtopnm "$scratch/hammered_normal.png" | pamcut -left 160 -top 160 -width 90 -height 180 >"$scratch/normals.ppm"
    local picture
    for picture in teapot torus king; do pngtopnm "$scratch/$picture.png" >"$scratch/$picture.ppm"; done
    pnmcat -lr "$scratch"/{teapot,torus,king,normals}.ppm | pnmtopng -compression 9 >"$here/bumps.png"
}

solid() { # docs/lab/reproduction.md: figures 1, 3 and 6 of "Real-Time Procedural Solid Texturing"
    local axis red green blue kind
    for axis in 0.5,0,0 0,0.5,0 0,0,0.5; do
        red=${green:-} green=${blue:-} blue="{\"node\":\"coordinate\",\"direction\":[$axis],\"offset\":0.5}"
    done
    local points="texture={\"node\":\"combine\",\"red\":$red,\"green\":$green,\"blue\":$blue}" view=(--unlit --supersample 3)
    "$burl" render --direct sample:teapot --recipe noise --set "$points" "${view[@]}" --view 25,24,2.6 --size 256x192 -o "$scratch/1a.png"
    "$burl" bake sample:teapot -o "$scratch/1b.png" --atlas uniform --recipe noise --set "$points" --size 192 --quiet
    "$burl" bake sample:teapot -o "$scratch/1c.png" --atlas uniform --recipe wood --set solid.scale=9 --size 192 --quiet
    "$burl" bake sample:teapot -o "$scratch/teapot.glb" --atlas uniform --recipe wood --set solid.scale=9 --size 1024 --quiet
    "$burl" render "$scratch/teapot.glb" "${view[@]}" --view 25,24,2.6 --size 256x192 -o "$scratch/1d.png"
    "$burl" bake sample:icosphere -o "$scratch/3b.png" --atlas uniform --recipe clouds --size 192 --quiet
    "$burl" bake sample:icosphere -o "$scratch/moon.glb" --atlas uniform --recipe clouds --size 512 --quiet
    "$burl" render "$scratch/moon.glb" "${view[@]}" --view 30,20,3.3 --size 256x192 -o "$scratch/3a.png"
    for kind in uniform area length; do
        "$burl" bake sample:king -o "$scratch/king.glb" --atlas $kind --overscan nearest --recipe stripes --set solid.scale=30 --size 256 --quiet
        "$burl" render "$scratch/king.glb" --unlit --view 35,10,3.3 --size 200x576 --supersample 2 -o "$scratch/6.png"
        pngtopnm "$scratch/6.png" >"$scratch/6$kind.ppm"
    done
    local picture
    for picture in 1a 1b 1c 1d 3a 3b; do pngtopnm "$scratch/$picture.png" >"$scratch/$picture.ppm"; done
    pnmcat -lr "$scratch"/{1a,1b}.ppm >"$scratch/1.ppm"
    pnmcat -lr "$scratch"/{1d,1c}.ppm >"$scratch/2.ppm"
    pnmcat -lr "$scratch"/{3a,3b}.ppm >"$scratch/3.ppm"
    pnmcat -tb -white "$scratch"/{1,2,3}.ppm >"$scratch/left.ppm"
    pnmcat -lr "$scratch"/6{uniform,area,length}.ppm >"$scratch/right.ppm"
    pnmcat -lr -white "$scratch"/{left,right}.ppm | pnmquant -quiet 256 | pnmtopng -compression 9 >"$here/solid-2001.png"
}

mip() { # docs/lab/reproduction.md: pbrt's lookups in MIP levels, trilinear and EWA, beside 16 x 16 samples a pixel
    local lookup floor=(--plane 0,1,0,-0.5 --view 15,14,3.5 --size 240x240 --unlit)
    "$burl" render --direct --plane 0,0,1,0 --view 0,0,12.68638 --size 512x512 --unlit --recipe checks \
        --set 'texture={"node":"checkerboard","a":"#f2ede2","b":"#23303f"}' -o "$scratch/tile.png"
    for lookup in trilinear ewa; do
        echo '{"burl": 1, "name": "floor", "texture": {"node": "map_planar", "vs": [0.25, 0, 0], "vt": [0, 0, 0.25],
            "input": {"node": "image", "file": "tile.png", "lookup": "'$lookup'"}}}' >"$scratch/$lookup.json"
        "$burl" render --direct --recipe "$scratch/$lookup.json" "${floor[@]}" --supersample 1 -o "$scratch/$lookup.png"
        pngtopnm "$scratch/$lookup.png" | pnmpad -white -right 4 >"$scratch/$lookup.ppm"
    done
    "$burl" render --direct --recipe "$scratch/ewa.json" "${floor[@]}" --supersample 16 --filter none -o "$scratch/samples.png"
    pngtopnm "$scratch/samples.png" >"$scratch/samples.ppm"
    pnmcat -lr "$scratch"/{trilinear,ewa,samples}.ppm | pnmquant -quiet 256 | pnmtopng -compression 9 >"$here/mip.png"
}

precision() { # docs/reference/precision.md
    local recipe bits
    for recipe in wood marble; do
        for bits in fixed:8.{3,4,5,6,8} float64; do
            "$burl" render --direct sample:teapot -o "$scratch/precise.png" --recipe $recipe --precision $bits --size 176x128 --view 30,20,2.6
            pngtopnm "$scratch/precise.png" | pnmpad -white -right 2 -bottom 2 >"$scratch/$recipe-$bits.ppm"
        done
        pnmcat -lr "$scratch/$recipe"-{fixed:8.{3,4,5,6,8},float64}.ppm >"$scratch/precise-$recipe.ppm"
    done
    pnmcat -tb "$scratch"/precise-{wood,marble}.ppm | pnmquant -quiet 256 | pnmtopng -compression 9 >"$here/precision.png"
}

turntable() { # docs/guide/pictures.md
    "$burl" render sample:bust --lazy --recipe malachite --turntable 36 --fps 18 --size 240x320 --view 30,12,3.4 \
        --quality 80 -o "$here/turntable.webp"
}

sheet() { # docs/guide/pictures.md
    "$burl" render sample:bust --lazy --recipes 'oak,walnut,carrara,nero-marquina,granite-*,malachite,lapis' --columns 4 --size 200x250 \
        --view 30,12,3.4 --supersample 3 -o "$here/sheet.webp"
}

editor() { # README, docs/guide/textures.md, docs/guide/editor.md
    "$bin/burl-edit" --unseen --recipe marble --script "$here/editor.json" --screenshot-dir "$scratch" --exit
    cwebp -quiet -q 85 "$scratch/editor.png" -o "$here/editor.webp"
}

tour() { # README, docs/guide/editor.md
    mkdir "$scratch/tour"
    "$bin/burl-edit" --unseen --recipe marble --script "$here/editor-tour.json" --screenshot-dir "$scratch/tour" --exit
    img2webp -loop 0 -lossy -q 70 -d 130 "$scratch"/tour/0*.png -o "$here/editor-tour.webp" >"$scratch/log"
}

graph() { # docs/guide/editor.md
    mkdir "$scratch/graph"
    "$bin/burl-edit" --unseen --script "$here/editor-oak.json" --screenshot-dir "$scratch/graph" --exit
    cwebp -quiet -q 82 "$scratch/graph/editor-oak.png" -o "$here/editor-graph.webp"
}

asset() { # docs/guide/your-asset.md
    "$here/your-asset.sh" "$burl"
}

figures() { # README, docs/guide/figures.md
    "$burl" figures -o "$here/../figures"
}

materials() { # README, docs/guide/materials.md
    "$here/materials.sh" "$burl"
}

serpentine() { # docs/guide/materials.md
    "$burl" render sample:bust --direct --recipe "$here/serpentine.mtlx" --size 480x480 -o "$here/serpentine.webp"
}

page() { # docs/guide/web-page.md
    "$burl" bake sample:bust -o "$scratch/malachite.glb" --recipe malachite --size 1024 --quiet
    "$burl" bake sample:bust -o "$scratch/oak.glb" --recipe oak --size 1024 --quiet
    "$burl" page "$scratch/malachite.glb" "$scratch/oak.glb" -o "$scratch/page" >"$scratch/log"
    node "$here/web-page.mjs" "$(command -v chromium)" "$scratch/page/index.html#asset=malachite&show=both&lines=charts&view=30,15,3.3" \
        "$scratch/page.png"
    cwebp -quiet -q 82 "$scratch/page.png" -o "$here/web-page.webp"
}

grazing() { # docs/lab/grazing.md: truth, one lookup and 16 by us, 16 by three.js
    "$here/../../tests/peers/grazing.sh" "$here/../../build/node" "$scratch/grazing" "$burl" >"$scratch/log"
    local picture
    for picture in {floor,hull}-{truth,chart.1,chart.16,chart.three}; do pngtopnm "$scratch/grazing/$picture.png" >"$scratch/$picture.ppm"; done
    for picture in truth chart.1 chart.16 chart.three; do
        pamcut -top 66 -height 94 "$scratch/floor-$picture.ppm" >"$scratch/floor.$picture.ppm"
        pamcut -left 75 -width 170 -top 100 -height 170 "$scratch/hull-$picture.ppm" >"$scratch/hull.$picture.ppm"
    done
    pnmcat -tb "$scratch"/floor.{truth,chart.1,chart.16,chart.three}.ppm >"$scratch/floor.ppm"
    pnmcat -lr "$scratch"/hull.{truth,chart.1,chart.16,chart.three}.ppm >"$scratch/hull.ppm"
    for picture in floor hull; do
        pnmtopng "$scratch/$picture.ppm" >"$scratch/$picture.png"
        cwebp -quiet -q 85 "$scratch/$picture.png" -o "$here/grazing-$picture.webp"
    done
}

blender() { # docs/guide/blender.md
    local run=(blender --background --factory-startup --python-exit-code 1 --python) addon=$here/../../app/blender/burl_addon.py
    mkdir "$scratch/scripts"
    export BLENDER_USER_SCRIPTS=$scratch/scripts
    command "${run[@]}" "$here/blender.py" -- "$addon" "$burl" "$scratch/blender.png" >"$scratch/log"
    command "${run[@]}" "$here/../../tests/peers/blender_addon.py" -- "$addon" "$burl" 512 "$scratch/nodes.png" >"$scratch/log"
    cwebp -quiet -q 85 "$scratch/blender.png" -o "$here/blender.webp"
    cwebp -quiet -q 88 "$scratch/nodes.png" -o "$here/blender-nodes.webp"
}

parts=(teapot atlases solid mip bumps precision turntable sheet editor tour graph asset figures materials serpentine page grazing blender)
for part in "${@:-${parts[@]}}"; do
    [[ " ${parts[*]} " == *" $part "* ]] || { echo "$part is no picture: name some of ${parts[*]}" >&2; exit 1; }
    echo "$part"
    "$part"
done
