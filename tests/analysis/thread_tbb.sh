#!/usr/bin/env bash
# Builds oneTBB with the thread sanitizer into FOLDER and prints the folder of its library. Without it the sanitizer does not
# see that a loop's tasks begin after its call and end before its return, and reports each hand-over as a race.
# Usage: LD_LIBRARY_PATH=$(thread_tbb.sh FOLDER) build/thread/bin/atlas_tests
set -euo pipefail
archive=onetbb_2021.8.0.orig.tar.xz
mkdir -p "$1"
cd "$1"
folder=$PWD
[[ -e $archive ]] || curl -sfO "http://deb.debian.org/debian/pool/main/o/onetbb/$archive"
tar xf "$archive"
{
    cmake -S oneTBB-2021.8.0 -B build -G Ninja -DTBB_TEST=OFF -DTBB_STRICT=OFF -DCMAKE_BUILD_TYPE=RelWithDebInfo \
        -DCMAKE_CXX_FLAGS="-fsanitize=thread -O1"
    ninja -C build tbb
} >build.log 2>&1 || { echo "thread_tbb.sh: see $folder/build.log" >&2; exit 1; }
library=$(find "$folder/build" -name libtbb.so.12)
dirname "${library:?there is no libtbb.so.12}"
