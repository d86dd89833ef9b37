#!/usr/bin/env python3
"""Bakes that are killed at random moments, by signals, and pairs that write one output: kills.py BURL LIBRARY FOLDER
10 kills and 5 pairs; where BURL_ALL_FAULTS is set, 100 and 50."""
import os, random, signal, subprocess, sys, time

from common import EVERY, Burl, Report, Stage, contents, output_problem

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def begun(stage, recipe):
    return subprocess.Popen([stage.burl.program, *stage.words, "--recipe", recipe, "--force"], cwd=stage.place,
                            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def next_run(stage):
    outcome = stage.burl.run([*stage.words, "--recipe", "marble"], stage.place)
    return outcome.err if outcome.code != 0 else output_problem(contents(stage.out), stage.new, stage.new)


def end_at_random(report, stage, chance, number, seconds):
    """Ends a bake, and looks at each file; a group may be half named by SIGKILL alone."""
    how = signal.SIGKILL if number % 2 == 0 else SIGNALS[number // 2 % 3]
    stage.reset()
    bake = begun(stage, "marble")
    time.sleep(chance.random() * seconds)
    bake.send_signal(how)
    err = bake.communicate()[1].decode()
    found = contents(stage.out)
    wrong = "" if bake.returncode in (0, -how) else f"exit code {bake.returncode}: {err}"
    if how == signal.SIGKILL:
        for name, data in found.items():
            whole = name.endswith((".burl-tmp", ".json")) or data in (stage.old.get(name), stage.new.get(name))
            wrong = wrong or ("" if whole else f"{name} is broken")
    else:
        wrong = wrong or output_problem(found, stage.old, stage.new)
    report.add(f"{how.name} {number}", wrong or next_run(stage))


def pair(report, stage, number):
    """Two bakes of different recipes at once: one of them wins as a whole, and the next run bakes what it is asked for."""
    stage.reset(empty=number % 2 == 0)
    both = [begun(stage, recipe) for recipe in ("marble", "wood")]
    ends = [bake.communicate()[1].decode() for bake in both]
    wrong = "".join(err for bake, err in zip(both, ends) if bake.returncode != 0)
    report.add(f"pair {number}", wrong or output_problem(contents(stage.out), stage.old, stage.new) or next_run(stage))


def main():
    burl, report, chance = Burl(*sys.argv[1:4]), Report(), random.Random(1)
    stage = Stage(burl, "obj", ["sample:cube", "--size", "16", "--normals", "none"], "x.obj")
    start = time.monotonic()
    stage.reset()
    begun(stage, "marble").communicate()
    seconds = 1.2 * (time.monotonic() - start)
    for number in range(100 if EVERY else 10): end_at_random(report, stage, chance, number, seconds)
    for number in range(50 if EVERY else 5): pair(report, stage, number)
    return report.end("kills")


sys.exit(main())
