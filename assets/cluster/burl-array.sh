#!/bin/sh
# A Slurm job array that bakes a manifest, each task a part of it:
#   sbatch --array=1-100 burl-array.sh night.json
# Further arguments go to `burl batch`, which gets --shard, --jobs and --progress from here. A task that is requeued finds what it has done up to date.
#SBATCH --job-name=burl
#SBATCH --requeue
#SBATCH --cpus-per-task=2
#SBATCH --output=burl-%A_%a.log
set -eu
if [ $# -eq 0 ] || [ -z "${SLURM_ARRAY_TASK_COUNT:-}" ]; then
    echo "usage: sbatch --array=1-N burl-array.sh MANIFEST.json [options of burl batch]" >&2
    exit 1
fi
count=$SLURM_ARRAY_TASK_COUNT
if [ $((SLURM_ARRAY_TASK_MAX - SLURM_ARRAY_TASK_MIN + 1)) -ne "$count" ]; then
    echo "burl-array.sh: every number of an array is a part, so none may be left out: sbatch --array=1-$count" >&2
    exit 1
fi
exec burl batch "$@" --shard "$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))/$count" \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" --progress none
