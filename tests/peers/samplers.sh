#!/usr/bin/env bash
# Holds the errors of sampled views to those that three.js's own samplers give (samplers.mjs):
#   samplers.sh MODULES SCRATCH VIEW_SAMPLES
# Exit 77 (skipped) where the other program is not installed.
set -euo pipefail
modules=$1 scratch=$2 samples=$3
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "SKIPPED: $1"; exit 77; }

rm -rf "$scratch"
mkdir -p "$scratch"
command -v node >/dev/null || skip "node is not installed"
chromium=$(command -v chromium) || skip "chromium is not installed"
[[ -d $modules/node_modules/three ]] || skip "three is not installed (npm install --prefix $modules three)"
"$samples" "$scratch"
node "$here/samplers.mjs" "$modules" "$chromium" "$scratch" teapot king bust
