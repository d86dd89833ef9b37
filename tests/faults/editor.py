#!/usr/bin/env python3
"""The editor when its memory ends, and when a signal does: editor.py BURL LIBRARY FOLDER
A script saves a recipe and exports a .glb over old files, without a window; allocations fail, one alone or with all after it. The
editor goes on, or ends by the sentence and exit code 4; each file is old or new. Allocations that Mesa and LLVM make themselves are
spared: they do not look at what they get. Signals come at calls that touch files: no temporary file stays. Unless BURL_ALL_FAULTS is
set, 8 of all and 4 of 64 KiB and more, and 6 signals."""
import json, pathlib, shutil, signal, sys

from common import EVERY, RECORD, Burl, Outcome, Report, contents, is_whole_record

SPARED = "OSMesa,LLVM,glapi,libc.so"
SENTENCE = "burl-edit: out of memory; try a smaller mesh or texture\n"
WORDS = "sample:cube --recipe marble --light headlight --set atlas.size=32 --set atlas.tries=1 --exit --unseen --script".split()


def into(file):
    """The steps of a dialog that saves to a file that is there."""
    return [{"wait": 2}, {"double_click": "file name"}, {"key": "Ctrl+A"}, {"type": file}, {"wait": 2}, {"click": "file ok"},
            {"wait": 2}, {"click": "file replace"}, {"settle": True}, {"wait": 2}]


class Editor(Burl):
    """burl-edit with a folder whose files it replaces."""

    def __init__(self, burl, library, folder):
        super().__init__(pathlib.Path(burl).parent / "burl-edit", library, folder)
        self.out, self.script = self.folder / "out", self.folder / "s.json"
        steps = [{"settle": True}, {"key": "Ctrl+S"}, *into("out/r.json"), {"key": "Ctrl+E"}, *into("out/x.glb")]
        self.script.write_text(json.dumps({"burl_input": 1, "size": [640, 400], "steps": steps}))
        self.reset()
        self.old = contents(self.out)
        assert self.play().code == 0
        self.new = contents(self.out)
        assert all(self.new[name] != self.old[name] for name in self.old)

    def reset(self):
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir()
        for name in ("r.json", "x.glb"): (self.out / name).write_text("old")

    def play(self, **faults):
        self.reset()
        return self.run([*WORDS, self.script], spared=SPARED, **faults)

    def problem(self, outcome):
        """What is wrong about the end of a script that met a fault, and about the files."""
        if outcome.code == 4:
            if outcome.err != SENTENCE: return f"exit code 4 and {outcome.err!r}"
        elif outcome.code != 0: return f"exit code {outcome.code}: {outcome.err!r}"
        found = contents(self.out)
        for name, data in found.items():
            if name.endswith(RECORD) and is_whole_record(data): continue
            if data not in (self.old.get(name), self.new.get(name)): return f"{name} is neither old nor new"
        return "" if set(self.old) <= set(found) else f"lost: {sorted(set(self.old) - set(found))}"

    def signal_problem(self, outcome, number):
        """What is wrong about the end of a script by a signal: it may come when all is done."""
        if outcome.code not in (0, -number): return f"exit code {outcome.code}: {outcome.err!r}"
        left = [name for name in contents(self.out) if name.endswith(".burl-tmp")]
        if left: return f"left over: {left}"
        return self.problem(Outcome(0, ""))


def main():
    editor, report = Editor(*sys.argv[1:4]), Report()
    for calls, tries in ("memory,large", 150 if EVERY else 4), ("large", 50 if EVERY else 2):
        count = editor.count([*WORDS, editor.script], calls, spared=SPARED)
        print(f"{count} allocations ({calls})")
        for i in range(tries):
            for action in ("fail", "fail-on"):
                number = 1 + (2 * i + (action == "fail")) * count // (2 * tries)
                outcome = editor.play(calls=calls, at=number, action=action)
                report.add(f"{action} at {number} of {calls}", editor.problem(outcome))
    count, tries = editor.count([*WORDS, editor.script], "files"), 60 if EVERY else 6
    for i in range(tries):
        number = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)[i % 3]
        outcome = editor.play(calls="files", at=1 + count // 2 + i * count // (2 * tries), action=f"signal:{int(number)}")
        report.add(f"{number.name} at call {1 + count // 2 + i * count // (2 * tries)} of {count}", editor.signal_problem(outcome, number))
    return report.end("editor")


sys.exit(main())
