#!/usr/bin/env python3
"""A disk that is full: disk.py BURL LIBRARY FOLDER
Outputs of every kind are written over older ones on a file system in memory, in a mount namespace of its own, that has no room, some,
or enough. Exit code 77 where the machine lets nobody mount one. Unless BURL_ALL_FAULTS is set, with two amounts of room."""
import json, os, pathlib, shutil, subprocess, sys

from common import EVERY, RECORD, Burl, Report, is_whole_record, sentence_problem

INSIDE = "BURL_DISK_INSIDE"
DISK = 16 << 20  # bytes
PAGE = 4096
SMALL = "--size 32 --quiet --force"
SHOWN = "sample:cube --direct --size 48x48"
LATE = (RECORD, "r.json")  # they are written once the output has its name
WRITTEN = (0, 7)  # exit codes of runs that wrote all: 7 is diff's
# What is written, with {} for the recipe; the first files' folder is the disk.
KINDS = {ending: f"bake sample:cube {SMALL} --recipe {{}} -o disk/x.{ending}"
         for ending in "glb gltf obj mtlx ply stl png jpg webp ktx2 exr".split()} | {
    "frames": f"bake sample:cube {SMALL} --recipe {{}} --animate solid.scale=1:2 --frames 3 -o disk/x.png",
    "masks": f"bake sample:cube {SMALL} --recipe {{}} --channels occlusion,curvature -o disk/x.png",
    "solid map": f"bake sample:cube {SMALL} --recipe {{}} --solid-map disk/s.exr -o disk/x.png",
    "shader": f"bake sample:cube {SMALL} --recipe {{}} --emit-glsl disk/s.frag -o disk/x.glb",
    "report": f"bake sample:cube {SMALL} --recipe {{}} --report disk/r.json -o disk/x.png",
    "picture": f"render {SHOWN} --recipe {{}} -o disk/p.png",
    "gif": f"render {SHOWN} --recipe {{}} --turntable 3 -o disk/p.gif",
    "apng": f"render {SHOWN} --recipe {{}} --turntable 3 -o disk/p.apng",
    "webp": f"render {SHOWN} --recipe {{}} --turntable 3 -o disk/p.webp",
    "page": "page {}/x.glb -o disk",
    "diff": "diff {}/x.png oak/x.png -o disk/d.png",
}


class Disk:
    """A folder of a few pages' room, and runs over old outputs in it."""

    def __init__(self, burl):
        self.burl, self.place = burl, burl.folder / "disk"
        self.place.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK}", "none", self.place], check=True)

    def empty(self):
        for path in self.place.iterdir(): shutil.rmtree(path) if path.is_dir() else path.unlink()

    def found(self):
        """The files, with those of folders."""
        return {str(path.relative_to(self.place)): path.read_bytes() for path in self.place.rglob("*") if path.is_file()}

    def room(self):
        state = os.statvfs(self.place)
        return state.f_bavail * state.f_frsize

    def made(self, words):
        self.empty()
        outcome = self.burl.run(words)
        assert outcome.code in WRITTEN, outcome.err
        return self.found()

    def run(self, words, old, room):
        """The outcome of a run over old files that leaves so much room at first, and the files after it."""
        self.empty()
        for name, data in old.items():
            (self.place / name).parent.mkdir(exist_ok=True)
            (self.place / name).write_bytes(data)
        filler = self.place / "filler"
        filler.write_bytes(b"\0" * (self.room() - room))
        outcome = self.burl.run(words)
        filler.unlink()
        return outcome, self.found()


def problem(outcome, found, old, new):
    """What is wrong about a run on a disk with little room."""
    if set(found) - set(old) - set(new): return f"left over: {sorted(set(found) - set(old) - set(new))}"
    if "r.json" in found: json.loads(found["r.json"])  # it has times
    found, old, new = ({n: data for n, data in files.items() if not n.endswith(LATE)} for files in (found, old, new))
    if outcome.code in WRITTEN: return "" if found == new else f"exit code {outcome.code} without the new output"
    if outcome.code != 2: return f"exit code {outcome.code}: {outcome.err!r}"
    if any(name in outcome.err for name in LATE) and found == new: return ""  # it had no room after the output
    if found != old: return f"neither as before nor new: {sorted(n for n in {**old, **found} if found.get(n) != old.get(n))}"
    return sentence_problem(outcome.err)


def full(disk, report, kind, command):
    old, new = (disk.made(command.format(recipe).split()) for recipe in ("wood", "marble"))
    assert old != new
    bytes_of_new = sum(len(data) for data in new.values())
    enough = 2 * PAGE * len(new) + 2 * bytes_of_new
    rooms = {0, PAGE, bytes_of_new // 4, bytes_of_new // 2, bytes_of_new - PAGE, enough} if EVERY else {0, bytes_of_new // 2}
    for room in sorted(max(one, 0) // PAGE * PAGE for one in rooms):
        outcome, found = disk.run(command.format("marble").split(), old, room)
        wrong = problem(outcome, found, old, new)
        if room == 0 and outcome.code == 0: wrong = "exit code 0 without room"
        if room >= enough // PAGE * PAGE and outcome.code not in WRITTEN: wrong = f"it fails with room: {outcome.err!r}"
        damaged = [name for name in found if name.endswith(RECORD) and found[name] != old.get(name) and not is_whole_record(found[name])]
        report.add(f"{kind} with {room} bytes of room for {bytes_of_new}", wrong or (f"damaged: {damaged}" if damaged else ""))


def main():
    burl, report = Burl(*sys.argv[1:4]), Report()
    disk = Disk(burl)
    for recipe in ("wood", "marble", "oak"):
        (burl.folder / recipe).mkdir()
        for ending in ("glb", "png"):
            words = f"bake sample:cube --size 16 --quiet --recipe {recipe} -o {recipe}/x.{ending}"
            assert burl.run(words.split()).code == 0
    for kind, command in KINDS.items(): full(disk, report, kind, command)
    return report.end("disk")


def in_a_namespace():
    """Runs this program in a mount namespace; its exit code."""
    for unshare in (["unshare", "-m"], ["unshare", "-rm"]):
        probe = [*unshare, "mount", "-t", "tmpfs", "none", "/mnt"]
        if shutil.which("unshare") and subprocess.run(probe, capture_output=True).returncode == 0:
            return subprocess.run([*unshare, sys.executable, *sys.argv], env=os.environ | {INSIDE: "1"}).returncode
    print("disk: skipped; no file system can be mounted here")
    return 77


sys.exit(main() if INSIDE in os.environ else in_a_namespace())
