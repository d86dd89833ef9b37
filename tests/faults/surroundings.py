#!/usr/bin/env python3
"""Bakes in odd surroundings: surroundings.py BURL LIBRARY FOLDER
A clock that goes backwards, a locale with decimal commas, names of any bytes, eight open files, no environment, no OSMesa, a full or
closed stdout, a limit on the size of files."""
import os, pathlib, resource, shutil, subprocess, sys

from common import EVERY, RECORD, Burl, Report, Stage, contents, output_problem, problem, sentence_problem

MESH = b"v 0.25 0 0\nv 1.5 0 0\nv 1 1.125 0\nv 0 1 0\nv .5 .5 1e0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"


def comma_locale(folder):
    """A folder with a German locale, made if the system has the means; else nothing."""
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")], capture_output=True) \
        if shutil.which("localedef") else None
    return folder if made and (folder / "de_DE.UTF-8").exists() else None


def same_bake(report, what, stage, **faults):
    """A bake with these faults gives the new output, and is up to date then."""
    env = faults.pop("env", None)
    limits = faults.pop("limits", None)
    stage.reset(empty=True)
    words = [*stage.words, "--recipe", "marble"]
    outcome = stage.burl.run(words, stage.place, env=env, limits=limits, **faults)
    report.add(what, problem(outcome, contents(stage.out), {}, stage.new, ()))
    states = {p.name: p.stat().st_mtime_ns for p in stage.out.iterdir()}
    stage.burl.run(words, stage.place, env=env, limits=limits, **faults)
    report.add(f"{what}, again", "" if {p.name: p.stat().st_mtime_ns for p in stage.out.iterdir()} == states else "it was not up to date")


def files_at_most(count):
    return lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (count, count))


def names(burl, report):
    """Meshes and outputs with every byte in their names."""
    place = os.fsencode(burl.folder / "names")
    os.makedirs(place)
    wanted = [bytes([b]) + b"x" for b in range(1, 256) if b != 0x2f] if EVERY else \
        [bytes(b for b in range(first, first + 51) if b != 0x2f) for first in range(1, 256, 51)]
    for name in wanted + [b"-x", b"\xff\xfe", b"a\nb", b"\xe2\x82", b"." + b"n" * 240]:
        mesh, out = name + b".obj", name + b".glb"
        with open(os.path.join(place, mesh), "wb") as file: file.write(MESH)
        done = subprocess.run([os.fsencode(burl.program), b"bake", b"./" + mesh, b"-o", b"./" + out, b"--size", b"16", b"-q"],
                              cwd=place, stdin=subprocess.DEVNULL, capture_output=True)
        found = set(os.listdir(place))
        wrong = "" if done.returncode == 0 and found == {mesh, out, out + RECORD.encode()} else f"{done.returncode}, {done.stderr}, {found}"
        report.add(f"name {name}", wrong)
        for path in found: os.unlink(os.path.join(place, path))


def refusals(burl, report, stage):
    """Commands that cannot succeed end with a code and a sentence."""
    def refused(what, outcome, code, out=None):
        left = contents(stage.out)
        wrong = f"exit code {outcome.code}: {outcome.err}" if outcome.code != code else sentence_problem(outcome.err)
        report.add(what, wrong or ("" if out else output_problem(left, stage.old, stage.old)))
    stage.reset()
    refused("limit on files", burl.run([*stage.words, "-r", "marble"], stage.place,
                                       limits=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))), 2)
    refused("no OSMesa", burl.run([*stage.words, "-r", "marble", "--synth", "gl"], stage.place, library="OSMesa"), 5)
    refused("no OSMesa, drawing", burl.run(["render", "out/x.obj", "-o", "out/p.png"], stage.place, library="OSMesa"), 5)
    with open("/dev/full", "wb") as full:
        loud = [word for word in stage.words if word != "--quiet"]
        refused("full stdout", burl.run([*loud, "-r", "marble"], stage.place, stdout=full), 2, out="written")


def main():
    burl, report = Burl(*sys.argv[1:4]), Report()
    (burl.folder / "m.obj").write_bytes(MESH)
    stage = Stage(burl, "obj", ["../m.obj", "--size", "16", "--normals", "none"], "x.obj")
    same_bake(report, "clock that goes backwards", stage, clock="back")
    same_bake(report, "eight open files", stage, limits=files_at_most(8))
    same_bake(report, "no environment", stage, env={})
    same_bake(report, "no OSMesa on the host", stage, library="OSMesa")
    same_bake(report, "closed streams", stage, limits=lambda: [os.close(i) for i in (0, 1)])
    locales = comma_locale(burl.folder)
    if locales:
        same_bake(report, "decimal commas", stage, env=burl.environment({"locale": "de_DE.UTF-8"}) | {"LOCPATH": str(locales)})
    else:
        print("no locale with decimal commas could be made")
    names(burl, report)
    refusals(burl, report, stage)
    return report.end("surroundings")


sys.exit(main())
