#!/usr/bin/env bash
# What is parallel, under the thread sanitizer: tests, bakes, a batch, frames, and the editor with a script that saves and exports.
# Exit code 1 where there is a report. First build the preset thread:
#   cmake --preset thread -DBURL_TESTS=ON && cmake --build build/thread --target atlas_tests procedural_tests app_tests burl burl-edit
# Usage: thread.sh build/thread FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) bin=$(cd "$1/bin" && pwd)
mkdir -p "$2"
cd "$2"
library=$("$here/thread_tbb.sh" tbb)
export LD_LIBRARY_PATH=$library TSAN_OPTIONS="suppressions=$here/thread.supp:exitcode=66"

failed=0
check() { # NAME PROGRAM ARGUMENTS...
    local name=$1 program=$2 code=0 seconds=$SECONDS
    shift 2
    timeout 900 "$bin/$program" "$@" >"$name.log" 2>&1 || code=$?
    reports=$(grep -c "WARNING: ThreadSanitizer" "$name.log" || true)
    echo "$name: exit code $code, $reports reports, $((SECONDS - seconds)) s"
    [[ $code == 0 && $reports == 0 ]] || failed=1
}

rm -rf out
mkdir out
check atlas atlas_tests --gtest_filter='*Thread*:-Long*'
check procedural procedural_tests --gtest_filter='Invariance.Threads*:*Thread*:*Stop*:-Long*'
check bake burl bake sample:cube --recipe oak --size 64 --threads 4 --levels all --quiet -o out/oak.glb
check batch burl batch sample:cube sample:torus sample:icosphere --recipe marble --recipe oak --size 64 --with levels=1 --jobs 3 \
    --quiet --report out/r.json -o 'out/{mesh}_{recipe}.glb'
check masks burl bake sample:torus --recipe gold --size 64 --threads 4 --channels occlusion,curvature --quiet -o out/gold.gltf
check frames burl render sample:torus --direct --recipe marble --size 64x64 --turntable 4 -o out/t.gif
echo '{"burl_input": 1, "size": [640, 400], "steps": [{"settle": true}, {"click": "tab:Parameters"}, {"wait": 2},
    {"drag": "solid.scale", "by": [30, 0]}, {"settle": true}, {"click": "tab:Library"}, {"wait": 20},
    {"key": "Ctrl+S"}, {"wait": 2}, {"double_click": "file name"}, {"key": "Ctrl+A"}, {"type": "out/r.json"}, {"wait": 2},
    {"click": "file ok"}, {"wait": 2}, {"click": "file replace"}, {"wait": 2}, {"key": "Ctrl+E"}, {"wait": 2},
    {"double_click": "file name"}, {"key": "Ctrl+A"}, {"type": "out/x.glb"}, {"wait": 2}, {"click": "file ok"},
    {"settle": true}, {"wait": 2}]}' >s.json
check editor burl-edit sample:cube --recipe marble --light headlight --set atlas.size=64 --set atlas.tries=1 --exit --unseen \
    --script s.json
if [[ -x $bin/app_tests ]]; then
    check app app_tests --gtest_filter='JobQueue*:EditJobQueue*:EditBaker*:EditWorker*:EditExport*:EditThumbnails*:EditFigures*:EditLevels*:'\
'EditViewMaker*:FileWatch*:Batch*:*Thread*:Pipeline*:TextureCache*:Progress*:-Long*:Gl*'
fi
exit $failed
