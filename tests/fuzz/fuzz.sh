#!/usr/bin/env bash
# Runs libFuzzer on the readers of files: tests/fuzz/fuzz.sh BUILD SECONDS [TARGET...]
# BUILD is a folder of the preset fuzz with burl_fuzz and burl_replay; without targets all are run, as many at a
# time as there are processors. What was learned stays in BUILD/corpus/TARGET for the next run; what went wrong
# lies in BUILD/found/TARGET-*. The limits are those of a file under 1 MB, 2 s and 1 GiB, with ten times the time
# and thrice the memory for the sanitizers; BURL_FUZZ_TIMEOUT sets another time, for machines that others use, too.
set -euo pipefail
build=$(cd "$1" && pwd) seconds=$2
shift 2
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export ASAN_OPTIONS=intercept_tls_get_addr=0:quarantine_size_mb=64:detect_leaks=0

run_target() { # TARGET
    local folder=$build/corpus/$1 log=$build/found/$1.log
    mkdir -p "$folder" "$build/found"
    "$build/bin/burl_replay" "$1" "$folder"
    if BURL_FUZZ=$1 "$build/bin/burl_fuzz" -max_total_time="$seconds" -timeout="${BURL_FUZZ_TIMEOUT:-20}" -rss_limit_mb=3072 \
        -malloc_limit_mb=1024 -detect_leaks=0 -print_final_stats=1 -artifact_prefix="$build/found/$1-" \
        "$folder" >"$log" 2>&1; then
        printf '%s: %s\n' "$1" "$(grep -E '^#[0-9]+' "$log" | tail -1)"
    else
        printf '%s: failed, see %s\n' "$1" "$log"
        return 1
    fi
}

if [[ $# == 0 ]]; then mapfile -t targets < <("$build/bin/burl_replay" || true); else targets=("$@"); fi
if [[ ${#targets[@]} == 1 ]]; then
    run_target "${targets[0]}"
else
    printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -n 1 "$source/tests/fuzz/fuzz.sh" "$build" "$seconds"
fi
