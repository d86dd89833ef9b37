#!/usr/bin/env python3
"""Prints how wrong the time left of a bake is: time_left.py BURL FOLDER [SIZE] [CASE...].

A case is the arguments of a bake, "sample:teapot -r oak -o a.glb". For each: its seconds, and the
largest errors of `seconds_left`, in percent of the time that was left, from a third of the way to
nine tenths, and from there to the last half second."""
import json, subprocess, sys

CASES = ["-r marble -o a.png", "-r marble -o a.glb", "-r marble -o a.glb --levels all",
         "-r marble -o a.exr", "-r marble -o a.glb --picture-format jpeg",
         "-r marble -o a.glb --picture-format webp", "-r oak -o a.glb",
         "-r oak -o a.glb --levels all", "-r oak -o a.glb --normals none",
         "-r hammered -o a.glb", "-r bricks -o a.glb", "-r bumpy -o a.glb"]


def states(burl, folder, arguments, size):
    command = [burl, "bake", "sample:teapot", *arguments.split(), "--size", str(size), "-q",
               "--force", "--progress", "json"]
    run = subprocess.run(command, cwd=folder, stderr=subprocess.PIPE, text=True)
    if run.returncode: sys.exit(run.stderr)
    return [json.loads(line) for line in run.stderr.splitlines() if line.startswith("{")]


def worst(states, first, last):
    """The state of the largest error between two times, and the error."""
    end = states[-1]["seconds"]
    errors = [(0.0, states[0])]
    for state in states[:-1]:
        left = end - state["seconds"]
        if not first <= state["seconds"] < last: continue
        if state["seconds_left"] is None: errors.append((float("inf"), state))
        else: errors.append((state["seconds_left"] / left - 1.0, state))
    return max(errors, key=lambda one: abs(one[0]))


def main():
    burl, folder, size = sys.argv[1], sys.argv[2], sys.argv[3] if sys.argv[3:] else "8192"
    for case in sys.argv[4:] or CASES:
        told = states(burl, folder, case, size)
        end = told[-1]["seconds"]
        row = [f"{case:44} {end:6.1f} s"]
        for first, last in ((end / 3, 0.9 * end), (0.9 * end, end - 0.5)):
            error, state = worst(told, first, last)
            row.append(f"{100 * error:+5.0f} % ({state['task']}, at {state['seconds'] / end:.2f})")
        print("  ".join(row), flush=True)
        starts = {}
        for state in told: starts.setdefault(state["task"], state["seconds"])
        if "-v" in sys.argv: print(starts)


main()
