#!/usr/bin/env python3
"""Changes one constant at a time and asks the tests whether they notice (mutation testing):

    tests/analysis/mutate.py build/release tests/analysis/mutants.json [NUMBER...]

The list says of each mutant: "file", the text "from" that stands there once, the text "to" that takes its place, the
"program" and the "tests", a filter of GoogleTest. Nothing of the checkout or the build folder changes: changed files lie
in a folder of their own, which the compiler looks into first; only the objects that read the file are compiled again
(those of tests, never: a list names files that no test includes), and the program is linked anew. "killed" means a test
failed, "hung" that it took more than two minutes, "survived" that nobody noticed. Exit code 1 where one survived that is
not marked with "why".
"""
import concurrent.futures
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]


def told_by_ninja(build, tool, *words):
    return subprocess.run(["ninja", "-C", build, "-t", tool, *words], capture_output=True, check=True, text=True).stdout


def readers_of(build):
    """Returns {file below the checkout: [objects that read it]}."""
    readers, target = {}, ""
    for line in told_by_ninja(build, "deps").splitlines():
        if line and not line.startswith(" "):
            target = line.split(":")[0]
        elif line.strip():
            path = (build / line.strip()).resolve()
            if path.is_relative_to(root):
                readers.setdefault(str(path.relative_to(root)), []).append(target)
    return readers


def compile_mutant(build, entry, overlay, mutant, output):
    words = shlex.split(entry["command"])
    while os.path.basename(words[0]) == "ccache":
        words.pop(0)
    words[words.index("-o") + 1] = str(output)
    for option in ("-MD",):
        words.remove(option)
    for option in ("-MT", "-MF"):
        at = words.index(option)
        del words[at:at + 2]
    source = (build / words[-1]).resolve()
    if source == root / mutant["file"]:
        words[-1] = str(overlay / mutant["file"])
    words[1:1] = [f"-I{overlay}", "-w", "-Wno-error"]
    made = subprocess.run(words, cwd=build, capture_output=True, text=True)
    return made.returncode == 0 or made.stderr


def link_and_run(build, program, objects, tests, folder):
    command = told_by_ninja(build, "commands", f"bin/{program}").splitlines()[-1]
    command = command.split("&&")[1] if command.startswith(": &&") else command
    words = shlex.split(command)
    while os.path.basename(words[0]) == "ccache":
        words.pop(0)
    at = words.index("-o")
    words[at + 1] = str(folder / program)
    words[at:at] = [str(o) for o in objects]
    linked = subprocess.run(words, cwd=build, capture_output=True, text=True)
    if linked.returncode:
        return "no program: " + linked.stderr[-300:]
    try:
        ran = subprocess.run([folder / program, f"--gtest_filter={tests}", "--gtest_brief=1", "--gtest_fail_fast"],
                             cwd=build, capture_output=True, text=True, timeout=120)
    except subprocess.TimeoutExpired:
        return "hung"
    if " 0 tests from" in ran.stdout:
        return "no such tests"
    return "survived" if ran.returncode == 0 else "killed"


def outcome_of(build, commands, readers, mutant, folder):
    text = (root / mutant["file"]).read_text()
    if text.count(mutant["from"]) != 1:
        return f"\"{mutant['from']}\" stands there {text.count(mutant['from'])} times"
    overlay = folder / "overlay"
    (overlay / mutant["file"]).parent.mkdir(parents=True)
    (overlay / mutant["file"]).write_text(text.replace(mutant["from"], mutant["to"]))
    library = [o for o in readers.get(mutant["file"], []) if o.startswith(("atlas/CMake", "procedural/CMake"))]
    if not library:
        return "nobody reads it"
    outputs = [folder / f"{i}.o" for i in range(len(library))]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        made = list(pool.map(lambda o, out: compile_mutant(build, commands[o], overlay, mutant, out), library, outputs))
    for one in made:
        if one is not True:
            return "does not compile: " + one[-300:]
    return link_and_run(build, mutant["program"], outputs, mutant["tests"], folder)


def main():
    build, mutants = pathlib.Path(sys.argv[1]).resolve(), json.loads(pathlib.Path(sys.argv[2]).read_text())
    chosen = {int(n) for n in sys.argv[3:]} or set(range(1, len(mutants) + 1))
    commands = {entry["output"]: entry for entry in json.loads(told_by_ninja(build, "compdb"))}
    readers = readers_of(build)
    survived = 0
    for number, mutant in enumerate(mutants, 1):
        if number not in chosen:
            continue
        folder = pathlib.Path(tempfile.mkdtemp(prefix="mutant"))
        try:
            outcome = outcome_of(build, commands, readers, mutant, folder)
        finally:
            shutil.rmtree(folder)
        survived += outcome == "survived" and "why" not in mutant
        change = f"{mutant['from']} -> {mutant['to']}".replace("\n", " ")
        print(f"{number:3} {outcome:9} {mutant['file']}: {change}", flush=True)
    sys.exit(1 if survived else 0)


if __name__ == "__main__":
    main()
