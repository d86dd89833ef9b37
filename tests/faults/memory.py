#!/usr/bin/env python3
"""Bakes that run out of memory: memory.py BURL LIBRARY FOLDER
Every allocation of a small bake is the last one that succeeds, or fails alone; so does every block of 64 KiB and more of larger
bakes, and allocations of bakes on four threads. Unless BURL_ALL_FAULTS is set, about 150 of the first, and fewer formats."""
import os, signal, sys

from common import EVERY, GLIBC_FALLS, Burl, Outcome, Report, Stage, contents, png, problem

SMALL = ["sample:cube", "--size", "16", "--threads", "1"]
LARGE = ["sample:teapot", "--size", "128", "--threads", "1"]
FORMATS = ["glb", "png", "webp", "jpg", "ktx2", "exr", "obj", "gltf", "ply", "mtlx", "stl"]


def every_one(burl, report, action, step):
    """Tries every step-th allocation in one run that forks at each."""
    stage = Stage(burl, f"{action}-{step}", SMALL, "x.glb")
    results = stage.place / "results"
    results.mkdir()
    stage.reset()
    outcome = burl.run([*stage.words, "--recipe", "marble"], stage.place, seconds=1400, calls="memory,large", action=action,
                       fork=f"1:{step}:{stage.out}:{results}")
    report.add(f"{action}: the run without faults", "" if outcome.code == 0 else f"{outcome.code}: {outcome.err}")
    falls = 0
    for line in (results / "log").read_text(errors="backslashreplace").splitlines():
        number, status, changed, err = line.split("\t")
        code = os.waitstatus_to_exitcode(int(status))
        found = contents(results / number) if changed == "1" else stage.old
        wrong = problem(Outcome(code, err.replace("\\n", "\n")), found, stage.old, stage.new, (4,))
        if code == -signal.SIGSEGV and changed == "0" and falls < GLIBC_FALLS:
            falls, wrong = falls + 1, ""
        report.add(f"{action} at allocation {number}", wrong)


def large_blocks(burl, report, ending):
    """Tries every large block of a bake: alone, and with all after it."""
    stage = Stage(burl, f"large-{ending}", LARGE, f"x.{ending}")
    for number in range(1, stage.count("large") + 1, 1 if EVERY else 4):
        for action in ("fail", "fail-on"):
            wrong, _ = stage.run(calls="large", at=number, action=action, codes=(2, 4))
            report.add(f"{ending}: {action} at large block {number}", wrong)


def image_levels(burl, report):
    """Tries every block of 64 KiB and more of a filtered image, whose levels the first thread that needs them makes."""
    (burl.folder / "picture.png").write_bytes(png(300, 200, 6))
    recipe = burl.folder / "image.burl.json"
    recipe.write_text('{"burl": 1, "texture": {"node": "image", "file": "picture.png"}}')
    stage = Stage(burl, "image", ["sample:cube", "--size", "64", "--threads", "4", "--filter", "trapezoid"], "x.glb", str(recipe))
    for number in range(1, stage.count("large") + 1):
        for action in ("fail", "fail-on"):
            wrong, _ = stage.run(calls="large", at=number, action=action, codes=(4,))
            report.add(f"image: {action} at large block {number}", wrong)


def on_threads(burl, report, tries):
    """Bakes on four threads, each with a number of its own, since forks need one thread; numbers are not the same in every run."""
    stage = Stage(burl, "threads", ["sample:teapot", "--size", "128", "--threads", "4", "--levels", "all"], "x.glb")
    for calls, times in ("memory,large", tries), ("large", tries // 3):
        count = stage.count(calls)
        print(f"{count} allocations on four threads ({calls})")
        for i in range(times):
            for action in ("fail", "fail-on"):
                number = 1 + (2 * i + (action == "fail")) * count // (2 * times)
                wrong, _ = stage.run(calls=calls, at=number, action=action, codes=(4,))
                report.add(f"threads: {action} at allocation {number} of {calls}", wrong)


def main():
    burl, report = Burl(*sys.argv[1:4]), Report()
    count = Stage(burl, "count", SMALL, "x.glb").count("memory,large")
    print(f"{count} allocations")
    every_one(burl, report, "fail-on", 1 if EVERY else count // 150)
    every_one(burl, report, "fail", 1 if EVERY else count // 50)
    for ending in FORMATS if EVERY else ["glb"]: large_blocks(burl, report, ending)
    image_levels(burl, report)
    on_threads(burl, report, 600 if EVERY else 9)
    return report.end("memory")


sys.exit(main())
