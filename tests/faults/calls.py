#!/usr/bin/env python3
"""Bakes whose calls of the system fail: calls.py BURL LIBRARY FOLDER
Every call that touches files fails, alone and with all after it, by each of several errors; reads and writes move half; the program
is killed at it; the output's folder vanishes, the disk is full; the mesh is cut, emptied, replaced or grows while it is read. Unless
BURL_ALL_FAULTS is set, every fourth call or less is tried, each with one of these in turn."""
import errno, sys

from common import EVERY, Burl, Report, Stage, contents, output_problem, problem

# A full disk, a broken one, no permission, a read-only one, no descriptors left, what is gone, a signal.
ERRORS = [errno.ENOSPC, errno.EIO, errno.EACCES, errno.EROFS, errno.EMFILE, errno.ENOENT, errno.EINTR]
MESH = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"
OTHER = MESH.replace("v .5 .5 1", "v .5 .5 2")


def without_names(found):
    """The files but for temporary ones, which the next run removes."""
    return {name: data for name, data in found.items() if not name.endswith(".burl-tmp")}


def next_run_problem(stage):
    """What is wrong about the output after the next run, which leaves nothing else."""
    outcome = stage.burl.run([*stage.words, "--recipe", "marble", "--force"], stage.place)
    if outcome.code != 0: return f"the next run fails: {outcome.err!r}"
    return output_problem(contents(stage.out), stage.new, stage.new)


def faults_of_files(report, stage, name, step):
    kinds = [(action, error) for error in ERRORS for action in ("fail", "fail-on")] + [("short", 0)]
    kinds.remove(("fail-on", errno.EINTR))  # such a call is made again
    for number in range(1, stage.count("files") + 1, step):
        for action, error in kinds if step == 1 else [kinds[number // step % len(kinds)]]:
            stage.reset()
            outcome = stage.burl.run([*stage.words, "--recipe", "marble"], stage.place, calls="files", at=number, action=action,
                                     errno=error)
            found = contents(stage.out)
            wrong = problem(outcome, without_names(found), stage.old, stage.new, (2, 4))
            if action == "fail-on" and outcome.code == 2 and "broken" not in wrong and "neither" in wrong:
                wrong = next_run_problem(stage)  # giving old files back failed, too
            if not wrong and found != without_names(found): wrong = next_run_problem(stage)
            report.add(f"{name}: {action} {errno.errorcode.get(error, '')} at call {number}", wrong)


def kills(report, stage, name, step):
    """Kills the bake at every call; the next run leaves nothing but the new output."""
    for number in range(1, stage.count("files") + 1, step):
        stage.reset()
        outcome = stage.burl.run([*stage.words, "--recipe", "marble"], stage.place, calls="files", at=number, action="kill")
        wrong = mixed(without_names(contents(stage.out)), stage) or next_run_problem(stage)
        report.add(f"{name}: killed at call {number}", wrong or ("" if outcome.code == -9 else f"exit code {outcome.code}"))


def mixed(found, stage):
    """What is wrong about the files of a killed run, each of which must be old or new."""
    for name, data in found.items():
        if name.endswith(".json"): continue
        if data not in (stage.old.get(name), stage.new.get(name)): return f"{name} is neither old nor new"
    return ""


def vanished(report, stage, step):
    for number in range(1, stage.count("files") + 1, step):
        stage.reset()
        outcome = stage.burl.run([*stage.words, "--recipe", "marble"], stage.place, calls="files", at=number,
                                 action=f"rm -r {stage.out}")
        found = contents(stage.out) if stage.out.exists() else {}
        wrong = problem(outcome, found, {}, {} if outcome.code == 0 else stage.new, (2,))
        if outcome.code == 0 and found: wrong = "" if found.keys() <= stage.new.keys() else "exit code 0"
        report.add(f"folder gone at call {number}", wrong)


def changed_inputs(burl, report, step):
    """The mesh changes at every call; what comes out is a bake of the old or the new mesh, or a sentence."""
    place = burl.folder / "inputs"
    changes = {"cut": "truncate -s 40", "emptied": "truncate -s 0", "removed": "rm", "replaced": "cp -f other.obj", "grown": "cat other.obj >>"}
    (place / "out").mkdir(parents=True)
    (place / "other.obj").write_text(OTHER)
    words = ["bake", "mesh.obj", "--size", "16", "--threads", "1", "--quiet", "--force", "-o", "out/x.glb"]
    bakes = []
    for text in (MESH, OTHER, MESH + OTHER):
        (place / "mesh.obj").write_text(text)
        assert burl.run(words, place).code == 0
        bakes.append((place / "out/x.glb").read_bytes())
    count = burl.count(words, "files", place)
    for number in range(1, count + 1, step):
        for name, command in changes.items() if step == 1 else [list(changes.items())[number % len(changes)]]:
            for path in (place / "out").iterdir(): path.unlink()
            (place / "mesh.obj").write_text(MESH)
            outcome = burl.run(words, place, calls="files", at=number, action=f"cd {place} && {command} mesh.obj")
            found = contents(place / "out")
            wrong = problem(outcome, found, {}, {} if outcome.code == 0 else {"x.glb": b""}, (2, 3))
            if outcome.code == 0:
                wrong = "" if found.get("x.glb") in bakes else "exit code 0 without a bake of either mesh"
            report.add(f"mesh {name} at call {number}", wrong)


def main():
    burl, report = Burl(*sys.argv[1:4]), Report()
    for out in ("x.obj", "x.glb") if EVERY else ("x.obj",):
        stage = Stage(burl, out, ["sample:cube", "--size", "16", "--threads", "1", "--normals", "none"], out)
        faults_of_files(report, stage, out, 1 if EVERY else 4)
        kills(report, stage, out, 1 if EVERY else 7)
    vanished(report, stage, 1 if EVERY else 9)
    changed_inputs(burl, report, 1 if EVERY else 3)
    return report.end("calls")


sys.exit(main())
