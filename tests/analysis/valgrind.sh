#!/usr/bin/env bash
# Bakes of 16 x 16 texels under valgrind's memcheck: every kind of atlas and a few formats and materials, without a wrong
# read, a jump by a value that was never written, or a lost block. Where no valgrind is installed the exit code is 77.
# Usage: valgrind.sh BURL FOLDER
set -euo pipefail
burl=$1 folder=$2 here=$(cd "$(dirname "$0")" && pwd)
command -v valgrind >/dev/null || exit 77
rm -rf "$folder"
mkdir -p "$folder"

# The processor that valgrind shows has no AVX-512, so kernels run on AVX2. Only blocks that are surely lost count: threads
# that still run at the end keep their stacks.
failed=0
check() { # ARGUMENTS...
    if ! valgrind --quiet --suppressions="$here/valgrind.supp" --error-exitcode=99 --leak-check=full \
        --show-leak-kinds=definite --errors-for-leak-kinds=definite "$burl" "$@" --quiet >"$folder/log" 2>&1; then
        echo "valgrind: burl $*"
        cat "$folder/log"
        failed=1
    fi
}

for kind in uniform area length quad patch chart; do
    check bake sample:cube --atlas "$kind" --size 16 --levels all -o "$folder/$kind.glb"
done
check bake "$folder/chart.glb" --atlas uv --size 16 -o "$folder/uv.png"
check bake sample:cube --recipe oak --size 16 -o "$folder/oak.gltf"
check bake sample:cube --recipe marble --size 16 --filter exact -o "$folder/exact.exr"
check bake sample:cube --recipe gold --size 16 --depth 16 -o "$folder/gold.obj"
for kernel in direct share scanline; do
    check bake sample:cube --size 16 --kernel "$kernel" -o "$folder/$kernel.png"
done
check bake sample:cube --recipe marble --size 16 --precision fixed:8.8 -o "$folder/fixed.png"
exit $failed
