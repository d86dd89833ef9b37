#!/bin/sh
# Validates every sample of the exporter, and with the program every mesh x atlas x overscan and every
# material on three meshes:
#   validate_matrix.sh MODULES SCRATCH GLTF_SAMPLES SAMPLE_MESHES [BURL]
# Exit 77 (skipped) where Node or the validator is not installed.
set -e
modules=$1 scratch=$2 samples=$3 meshes=$4 burl=$5
here=$(dirname "$0")
nasty=$here/../../assets/meshes/nasty
if ! command -v node >/dev/null; then
    echo "SKIPPED: node is not installed"
    exit 77
fi
if ! [ -d "$modules/node_modules/gltf-validator" ]; then
    echo "SKIPPED: gltf-validator is not installed (npm install --prefix $modules gltf-validator)"
    exit 77
fi
rm -rf "$scratch"
mkdir -p "$scratch"
"$samples" "$scratch"
if [ -n "$burl" ]; then
    for mesh in "$meshes"/*.obj "$meshes"/*.glb "$nasty"/*.obj; do
        for atlas in uniform area length quad patch; do
            for overscan in nearest bilinear; do
                out=$scratch/$(basename "$mesh" | tr . _).$atlas.$overscan.glb
                "$burl" bake "$mesh" -o "$out" --atlas $atlas --overscan $overscan --size 512 --levels 9 \
                    >/dev/null 2>&1 || { echo "burl bake failed on $mesh, $atlas, $overscan"; exit 1; }
            done
        done
    done
    for atlas in uniform quad patch; do
        "$burl" bake "$meshes/king.obj" -o "$scratch/bumps.$atlas.glb" --atlas $atlas --size 512 --recipe hammered \
            >/dev/null 2>&1 || { echo "burl bake failed on bumps, $atlas"; exit 1; }
    done
    for atlas in uniform quad patch; do
        "$burl" bake "$meshes/king.obj" -o "$scratch/strips.$atlas.glb" --atlas $atlas --size 512 --strips \
            >/dev/null 2>&1 || { echo "burl bake failed on strips, $atlas"; exit 1; }
    done
    for source in "$scratch"/kept_*.gltf; do # documents of other programs, baked back into themselves
        for atlas in quad patch; do
            "$burl" bake "$source" -o "${source%.gltf}.$atlas.glb" --atlas $atlas --size 128 --recipe hammered \
                >/dev/null 2>&1 || { echo "burl bake failed on $source, $atlas"; exit 1; }
        done
        "$burl" bake "$source" -o "${source%.gltf}.strips.glb" --size 128 --recipe hammered --strips \
            >/dev/null 2>&1 || { echo "burl bake failed on $source, strips"; exit 1; }
        "$burl" bake "$source" -o "${source%.gltf}.webp.glb" --size 128 --recipe hammered --picture-format webp \
            >/dev/null 2>&1 || { echo "burl bake failed on $source, webp"; exit 1; }
    done
    for coding in jpeg webp webp:80; do
        for file in glb gltf; do
            "$burl" bake "$meshes/king.obj" -o "$scratch/pictures.$(echo $coding | tr : .).$file" --size 256 --levels 3 \
                --recipe brushed-steel --picture-format $coding \
                >/dev/null 2>&1 || { echo "burl bake failed on $coding, $file"; exit 1; }
        done
    done
    for recipe in "$here"/../../assets/materials/*.json; do
        material=$(basename "$recipe" .json)
        for mesh in torus teapot cad_part; do
            "$burl" bake "$meshes/$mesh.obj" -o "$scratch/$material.$mesh.glb" --recipe $material --size 128 \
                >/dev/null 2>&1 || { echo "burl bake failed on $material, $mesh"; exit 1; }
        done
    done
fi
exec node "$here/validate_glb.mjs" "$modules" "$scratch"/*.glb "$scratch"/*.gltf
