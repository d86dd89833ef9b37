"""What a bake costs in Python beyond the program: a hundred meshes, read, baked and written by `burl batch` and by a script.

Usage: python_cost.py FOLDER [ROUNDS [SIZE]], with BURL_PROGRAM set. Prints processor and wall seconds of each; the least of all rounds counts."""
import json
import math
import os
import resource
import subprocess
import sys
import time

FOLDER = sys.argv[1]
ROUNDS = int(sys.argv[2]) if len(sys.argv) > 2 else 3
SIZE = int(sys.argv[3]) if len(sys.argv) > 3 else 512
COUNT = 100
PROGRAM = os.environ["BURL_PROGRAM"]
SCRIPT = f"""
import burl
oak = burl.Recipe.load("oak")
for i in range({COUNT}):
    burl.bake(burl.Mesh.read(f"mesh{{i}}.obj"), oak, size={SIZE}).write(f"python{{i}}.glb")
"""


def torus(path, radius):
    points, faces = [], []
    m, n = 40, 20
    for i in range(m):
        for j in range(n):
            a, b = 2 * math.pi * i / m, 2 * math.pi * j / n
            r = 1 + radius * math.cos(b)
            points.append(f"v {r * math.cos(a):.9g} {radius * math.sin(b):.9g} {r * math.sin(a):.9g}")
            p = [1 + (i + x) % m * n + (j + y) % n for x, y in ((0, 0), (0, 1), (1, 1), (1, 0))]
            faces.append("f {} {} {} {}".format(*p))
    with open(path, "w") as file:
        file.write("\n".join(points + faces) + "\n")


def measured(*words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    subprocess.run(words, cwd=FOLDER, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, time.monotonic() - start


os.makedirs(FOLDER, exist_ok=True)
for i in range(COUNT):
    torus(os.path.join(FOLDER, f"mesh{i}.obj"), 0.2 + 0.005 * i)
bakes = [{"mesh": f"mesh{i}.obj", "recipe": "oak", "output": f"program{i}.glb"} for i in range(COUNT)]
with open(os.path.join(FOLDER, "batch.json"), "w") as file:
    json.dump({"defaults": {"size": SIZE}, "bakes": bakes}, file)
program, python = [], []
for _ in range(ROUNDS):
    program.append(measured(PROGRAM, "batch", "batch.json", "--force", "--quiet"))
    python.append(measured(sys.executable, "-c", SCRIPT))
for i in range(COUNT):
    with open(os.path.join(FOLDER, f"program{i}.glb"), "rb") as a, open(os.path.join(FOLDER, f"python{i}.glb"), "rb") as b:
        assert a.read() == b.read(), i
for name, rounds in (("burl batch", program), ("Python", python)):
    cpu, wall = (min(one[k] for one in rounds) for k in (0, 1))
    print(f"{name}: {cpu:.2f} s of processors, {wall:.2f} s")
print(f"Python costs {100 * (min(python)[0] / min(program)[0] - 1):+.1f} % of processors' time")
