#!/usr/bin/env bash
# The nodes of MaterialX's functions, held to the shaders of MaterialX's own generator; exit 77 (skipped) where node, Chromium or the
# package @needle-tools/materialx is not installed, which ./check --full fetches:
#   materialx.sh MODULES SCRATCH BURL [POINTS]
set -euo pipefail
modules=$1 scratch=$2 burl=$3
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "SKIPPED: $1"; exit 77; }
for program in node chromium python3; do
    command -v $program >/dev/null || skip "$program is not installed"
done
[[ -d $modules/node_modules/@needle-tools/materialx ]] || skip "@needle-tools/materialx is not in $modules"
rm -rf "$scratch"
mkdir -p "$scratch"
python3 "$here/materialx_points.py" "$modules" "$(command -v chromium)" "$burl" "$scratch" "${4:-10000}"
