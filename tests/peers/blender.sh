#!/usr/bin/env bash
# The nodes of Blender's functions and the add-on, held to Blender where it is installed; exit 77 (skipped) where it is not:
#   blender.sh points|addon SCRATCH BURL
set -euo pipefail
what=$1 scratch=$2 burl=$3
here=$(cd "$(dirname "$0")" && pwd)
command -v blender >/dev/null || { echo "SKIPPED: blender is not installed"; exit 77; }
rm -rf "$scratch"
mkdir -p "$scratch"
blend=(blender --background --factory-startup --python-exit-code 1 --python)
export BLENDER_USER_SCRIPTS=$scratch/scripts
mkdir -p "$BLENDER_USER_SCRIPTS"
case $what in
    points) "${blend[@]}" "$here/blender_points.py" -- "$burl" "$scratch/points" 2000 ;;
    addon) "${blend[@]}" "$here/blender_addon.py" -- "$here/../../app/blender/burl_addon.py" "$burl" 512 | grep -v '^Fra:' ;;
esac
