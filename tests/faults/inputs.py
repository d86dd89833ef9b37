#!/usr/bin/env python3
"""Inputs that change while they are read: inputs.py BURL LIBRARY FOLDER
At calls that touch files, a glTF, its .bin, one of its images, or the image of a recipe is cut, emptied, removed, replaced or grows.
What comes out is a bake of the old or of the new input, or a sentence; and the next run does not take the output for up to date where
it is not. Unless BURL_ALL_FAULTS is set, at every 47th call, else at every fourth."""
import json, shutil, sys

from common import EVERY, RECORD, Burl, Report, contents, problem

CHANGES = {"cut": "truncate -s 60 {0}", "emptied": "truncate -s 0 {0}", "removed": "rm {0}", "replaced": "cp -f ../other/{0} {0}",
           "swapped": "cp ../other/{0} new && mv new {0}", "grown": "cat ../other/{0} >> {0}"}


class Inputs:
    """A folder of inputs with another version of each, and the bake that reads them."""

    def __init__(self, burl, name, file, words):
        self.burl, self.place, self.file = burl, burl.folder / name, file
        for folder in ("in", "kept", "other", "out"): (self.place / folder).mkdir(parents=True)
        self.words = ["bake", *words, "--size", "16", "--threads", "1", "--quiet", "-o", "../out/x.glb"]

    def run(self, *more, **faults):
        return self.burl.run([*self.words, *more], self.place / "in", **faults)

    def reset(self):
        for folder in ("in", "out"):
            shutil.rmtree(self.place / folder)
            (self.place / folder).mkdir()
        for path in (self.place / "kept").iterdir(): shutil.copy2(path, self.place / "in")

    def bake(self):
        """A bake of the inputs as they are; none where they cannot be baked."""
        outcome = self.run("--force")
        return (self.place / "out/x.glb").read_bytes() if outcome.code == 0 else None

    def changed(self, command):
        """The bake of the inputs after a change."""
        self.reset()
        self.burl.run(["list", "noises"], self.place / "in", calls="files", at=1, action=command)
        return self.bake()

    def next_run_problem(self):
        """What is wrong about the output that the next run leaves, or says to be up to date."""
        first = self.run()
        kept = (self.place / "out/x.glb").read_bytes()
        now = self.bake()
        if now is None: return "" if first.code != 0 else "up to date with an input that cannot be read"
        return "" if kept == now else "the next run takes an older bake for up to date"

    def try_all(self, report, step):
        self.reset()
        old = self.bake()
        self.reset()
        count = self.burl.count(self.words, "files", self.place / "in")
        for name, template in CHANGES.items():
            command = f"cd {self.place}/in && " + template.format(self.file)
            new = self.changed(command)
            for number in range(1 + len(name) % step, count + 1, step):
                self.reset()
                outcome = self.run(calls="files", at=number, action=command)
                found = contents(self.place / "out")
                wrong = problem(outcome, found, {}, {} if outcome.code == 0 else {"x.glb": b""}, (2, 3, 5))
                if outcome.code == 0:
                    wrong = "" if found["x.glb"] in (old, new) else "exit code 0 without a bake of either"
                    wrong = wrong or self.next_run_problem()
                report.add(f"{self.file} {name} at call {number}", wrong)


def with_two_materials(path):
    """Doubles the first triangles of a glTF, with a material that is called "kept"."""
    document = json.loads(path.read_text())
    first = document["meshes"][0]["primitives"][0]
    document["materials"].append(document["materials"][first["material"]] | {"name": "kept"})
    document["materials"][first["material"]]["name"] = "baked"
    document["meshes"].append({"primitives": [first | {"material": len(document["materials"]) - 1}]})
    document["nodes"].append({"mesh": len(document["meshes"]) - 1, "translation": [3, 0, 0]})
    document["scenes"][0]["nodes"].append(len(document["nodes"]) - 1)
    path.write_text(json.dumps(document))


def gltf(burl, file):
    """A glTF with two materials, of which one is baked and the other keeps its images."""
    inputs = Inputs(burl, file, file, ["m.gltf", "--material", "baked", "--recipe", "marble"])
    for folder, recipe, scale in ("kept", "oak", "1"), ("other", "walnut", "2"):
        words = ["bake", "sample:cube", "--size", "16", "--quiet", "--recipe", recipe, "--scale", scale, "-o", f"{folder}/m.gltf"]
        outcome = burl.run(words, inputs.place)
        assert outcome.code == 0, outcome.err
        (inputs.place / folder / ("m.gltf" + RECORD)).unlink()
        with_two_materials(inputs.place / folder / "m.gltf")
    return inputs


def image(burl):
    inputs = Inputs(burl, "image", "i.png", ["sample:cube", "--recipe", "r.json"])
    recipe = {"burl": 1, "texture": {"node": "image", "file": "i.png"}}
    for folder, preset in ("kept", "wood"), ("other", "marble"):
        words = ["bake", "sample:cube", "--size", "32", "--quiet", "--recipe", preset, "-o", f"{folder}/i.png"]
        assert burl.run(words, inputs.place).code == 0
        (inputs.place / folder / ("i.png" + RECORD)).unlink()
        (inputs.place / folder / "r.json").write_text(json.dumps(recipe))
    return inputs


def mesh(burl):
    inputs = Inputs(burl, "mesh", "m.obj", ["m.obj", "--recipe", "marble"])
    for folder, top in ("kept", 1), ("other", 2):
        (inputs.place / folder / "m.obj").write_text(
            f"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 {top}\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
    return inputs


def main():
    burl, report = Burl(*sys.argv[1:4]), Report()
    for inputs in (mesh(burl), image(burl), *(gltf(burl, file) for file in ("m.gltf", "m.bin", "m.png"))):
        inputs.try_all(report, 4 if EVERY else 47)
    return report.end("inputs")


sys.exit(main())
