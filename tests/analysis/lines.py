#!/usr/bin/env python3
"""Counts the lines of atlas/ and procedural/ that tests have run, from what gcov kept of a build with BURL_LINES:

    cmake --preset lines -DBURL_TESTS=ON && cmake --build build/lines --target atlas_tests procedural_tests
    build/lines/bin/atlas_tests --gtest_filter=-Long*; build/lines/bin/procedural_tests --gtest_filter=-Long*
    tests/analysis/lines.py build/lines

A line counts as run if any copy of it ran: of a template's instances, of a header's users, of the instruction sets that
Highway compiles a kernel for. Exit code 1 where a folder has less than --least percent.
"""
import argparse
import json
import pathlib
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]


def objects_of(build):
    """Returns the .gcno files of atlas/ and procedural/."""
    objects = sorted(path for part in ("atlas", "procedural")
                     for path in (build / part / "CMakeFiles" / f"burl_{part}.dir").rglob("*.gcno"))
    if not objects:
        sys.exit(f"{build} has no .gcno files: build it with the preset lines")
    return objects


def counts_of(objects, build, beginnings):
    """Returns {file: {line: times}} of all files with such a beginning that the objects were compiled from."""
    counts = {}
    for path in objects:
        told = subprocess.run(["gcov", "--json-format", "--stdout", path], cwd=build, capture_output=True, check=True)
        for document in filter(None, told.stdout.decode().splitlines()):
            for entry in json.loads(document)["files"]:
                name = pathlib.Path(build, entry["file"]).resolve()
                if not name.is_relative_to(root):
                    continue
                name = str(name.relative_to(root))
                if not name.startswith(beginnings):
                    continue
                lines = counts.setdefault(name, {})
                for line in entry["lines"]:
                    number = line["line_number"]
                    lines[number] = max(lines.get(number, 0), line["count"])
    return counts


def ranges(numbers):
    """Returns numbers as text, "3-5 9"."""
    runs = []
    for n in sorted(numbers):
        if runs and runs[-1][1] == n - 1:
            runs[-1][1] = n
        else:
            runs.append([n, n])
    return " ".join(str(a) if a == b else f"{a}-{b}" for a, b in runs)


def row(name, lines):
    run = sum(1 for times in lines.values() if times > 0)
    return name, run, len(lines), 100.0 * run / max(len(lines), 1)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--least", type=float, default=92.0, help="percent that each of both folders must have")
    options.add_argument("--below", type=float, default=92.0, help="list files with fewer percent, and their lines")
    asked = options.parse_args()
    build = asked.build.resolve()
    counts = counts_of(objects_of(build), build, ("atlas/", "procedural/"))
    for name, run, of, percent in sorted((row(*item) for item in counts.items()), key=lambda r: r[3]):
        if percent < asked.below:
            idle = ranges(n for n, times in counts[name].items() if times == 0)
            print(f"{percent:6.2f} %  {run:5} of {of:5}  {name}: {idle}")
    short = False
    for part in ("atlas", "procedural"):
        of_part = [row(*item) for item in counts.items() if item[0].startswith(part)]
        run, of = sum(r[1] for r in of_part), sum(r[2] for r in of_part)
        short |= 100.0 * run / of < asked.least
        print(f"{100.0 * run / of:6.2f} %  {run:5} of {of:5}  {part}/, {len(of_part)} files")
    sys.exit(1 if short else 0)


if __name__ == "__main__":
    main()
