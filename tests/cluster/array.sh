#!/bin/bash
# Which parts assets/cluster/burl-array.sh asks for, told by variables as Slurm sets them: array.sh SOURCE FOLDER
set -euo pipefail
script=$1/assets/cluster/burl-array.sh folder=$2
mkdir -p "$folder"
printf '#!/bin/sh\necho "$@"\n' >"$folder/burl"
chmod +x "$folder/burl"
export PATH=$folder:$PATH
asked() { # ID MIN MAX COUNT
    SLURM_ARRAY_TASK_ID=$1 SLURM_ARRAY_TASK_MIN=$2 SLURM_ARRAY_TASK_MAX=$3 SLURM_ARRAY_TASK_COUNT=$4 SLURM_CPUS_PER_TASK=2 \
        "$script" night.json --quiet 2>&1
}
fail() { echo "FAILED: $*"; exit 1; }
[[ $(asked 3 1 9 9) == "batch night.json --quiet --shard 3/9 --jobs 2 --progress none" ]] || fail "a part of nine"
[[ $(asked 10 10 19 10) == *"--shard 1/10 "* ]] || fail "an array that begins at ten"
for sparse in "3 1 9 5" "7 3 7 2"; do # --array=1-9:2 and 3,7
    if text=$(asked $sparse); then fail "parts are left out: $text"; fi
    [[ $text == *"none may be left out"* ]] || fail "$text"
done
