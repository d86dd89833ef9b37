#!/usr/bin/env python3
"""A program whose memory ends within the library: library.py BURL LIBRARY FOLDER
Allocations of tests/faults/library_user.cpp fail, alone or with all after it. The process must go on: an exception reaches the
program, which tries again, and the second time succeeds where memory is back. Unless BURL_ALL_FAULTS is set, about 240 of them."""
import os, pathlib, signal, sys

from common import EVERY, GLIBC_FALLS, Burl, Report, contents


def judge(code, found, old, new):
    """What is wrong about a process that met a failure: it must end by itself, with the output old or new."""
    if code < 0: return f"ended by {signal.Signals(-code).name}"
    if code not in (0, 4): return f"exit code {code}"
    if set(found) - set(new): return f"left over: {sorted(set(found) - set(new))}"
    if found != (new if code == 0 else old) and code == 0: return "exit code 0 without the output"
    return "" if found in (old, new) else "neither old nor new"


def one_processor():
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})


def every_one(user, report, action, count):
    out, results = user.folder / action / "out", user.folder / action / "results"
    out.mkdir(parents=True), results.mkdir()
    words = [out / "x.glb"]
    outcome = user.run(words, limits=one_processor)
    assert outcome.code == 0 and not outcome.err, outcome.err
    new = contents(out)
    (out / "x.glb").write_bytes(b"old")
    old = contents(out)
    for name in set(new) - {"x.glb"}: (out / name).unlink(), old.pop(name, None)
    step = max(1, user.count(words, "memory,large", limits=one_processor) // count)
    (out / "x.glb").write_bytes(b"old")
    outcome = user.run(words, limits=one_processor, seconds=2400, calls="memory,large", action=action, fork=f"1:{step}:{out}:{results}")
    report.add(f"{action}: the run without faults", "" if outcome.code == 0 else f"{outcome.code}: {outcome.err}")
    falls = 0
    for line in (results / "log").read_text(errors="backslashreplace").splitlines():
        number, status, changed, err = line.split("\t")
        found = contents(results / number) if changed == "1" else old
        code = os.waitstatus_to_exitcode(int(status))
        wrong = judge(code, found, old, new)
        if code == -signal.SIGSEGV and changed == "0" and falls < GLIBC_FALLS: falls, wrong = falls + 1, ""
        report.add(f"{action} at allocation {number}", wrong and f"{wrong}: {err!r}")


def on_threads(user, report, tries):
    """Runs on four threads with a callback, each with a number of its own, since forks need one thread."""
    out = user.folder / "threads/out"
    out.mkdir(parents=True)
    words = [out / "x.glb", 4]
    count = user.count(words, "memory,large")
    new = contents(out)
    for i in range(tries):
        for action in ("fail", "fail-on"):
            number = 1 + (2 * i + (action == "fail")) * count // (2 * tries)
            (out / "x.glb").write_bytes(b"old")
            outcome = user.run(words, calls="memory,large", at=number, action=action)
            code = -signal.SIGALRM if outcome.code is None else outcome.code
            wrong = judge(code, contents(out), {"x.glb": b"old"}, new)
            report.add(f"threads: {action} at allocation {number}", wrong and f"{wrong}: {outcome.err!r}")


def main():
    burl, report = Burl(*sys.argv[1:4]), Report()
    user = Burl(pathlib.Path(sys.argv[1]).parent / "burl_library_user", *sys.argv[2:4])
    every_one(user, report, "fail", 2500 if EVERY else 100)  # whose runs do all that is left
    every_one(user, report, "fail-on", 10000 if EVERY else 100)
    on_threads(user, report, 500 if EVERY else 20)
    return report.end("library")


sys.exit(main())
