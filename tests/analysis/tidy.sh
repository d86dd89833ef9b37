#!/usr/bin/env bash
# clang-tidy over atlas/, procedural/ and app/, by the units that they are built of, with the checks of .clang-tidy. Prints what
# tidy.waived does not list, and the files that clang cannot parse; exit code 1 where there is a finding.
# Usage: tidy.sh BUILD [PATTERN], a folder of its own for the commands, and which units
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) root=$(cd "$(dirname "$0")/../.." && pwd)
command -v clang-tidy >/dev/null || exit 77
cmake -S "$root" -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBURL_TESTS=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
build=$(cd "$1" && pwd)
python3 - "$build/compile_commands.json" "$root" "${2:-}" >"$build/tidy.files" <<'PYTHON'
import json, re, sys
files = [entry["file"] for entry in json.load(open(sys.argv[1]))]
ours = re.compile(re.escape(sys.argv[2]) + r"/(build/[^/]*/)?(\S*/)?(atlas|procedural|app)/")
print(*(file for file in files if ours.match(file) and "/assets/" not in file and re.search(sys.argv[3], file)), sep="\n")
PYTHON
xargs -a "$build/tidy.files" -P "${TIDY_JOBS:-1}" -I{} clang-tidy --quiet -p "$build" --extra-arg=-ferror-limit=0 \
    --extra-arg=-Wno-everything {} >"$build/tidy.log" 2>/dev/null || true
sed -n "s#^$root/##p" "$build/tidy.log" | grep -E ": (warning|error): " | sort -u >"$build/tidy.found" || true
echo "$(wc -l <"$build/tidy.files") units; not parsed by clang:"
grep -E "clang-diagnostic-error" "$build/tidy.found" | sed 's/:.*//' | sort -u || true
grep -vE "clang-diagnostic-error" "$build/tidy.found" >"$build/tidy.warnings" || true
failed=0
while IFS= read -r line; do
    file=${line%%:*} check=${line##*[}
    if ! grep -qF "$file ${check%]}:" "$here/tidy.waived"; then
        echo "$line"
        failed=1
    fi
done <"$build/tidy.warnings"
exit $failed
