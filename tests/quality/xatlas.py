#!/usr/bin/env python3
"""Measures xatlas on the meshes of the table, once, for comparison: xatlas.py XATLAS BURL FOLDER
XATLAS is a folder whose node_modules holds xatlas-wasm (tests/peers/unwrap.mjs), FOLDER keeps the
meshes. Writes xatlas.csv, which no test measures anew, and the page docs/lab/quality.md."""
import math, pathlib, subprocess, sys, tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import fetch, page, quality

UNWRAP = HERE.parent / "peers" / "unwrap.mjs"


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode: sys.exit(f"{' '.join(map(str, command))}: {done.stdout}{done.stderr}")


def measured(xatlas, burl, name, path, scratch):
    """The rows of a mesh with padding 0 and 4; times are not taken."""
    run(burl, "bake", path, "-o", scratch / "mesh.obj", "--recipe", "marble", "--size", 1024, "--atlas", "uniform", "--quiet", "--force")
    for padding in (0, 4):
        run("node", UNWRAP, xatlas, scratch / "mesh.obj", scratch / "unwrapped.obj", padding)
        told = quality.answer([burl, "metrics", scratch / "unwrapped.obj", "--uv", "--levels", "--json", "--size", 1024, "--progress", "none"])
        row = {"mesh": name, "kind": f"xatlas {padding}", "kernels": math.nan, "ms": math.nan}
        yield row | quality.figures(told["atlases"][0])


def main():
    xatlas, burl, folder = sys.argv[1:]
    paths, absent = fetch.fetch(quality.asked_meshes(None), folder)
    for name, why in absent.items(): print(f"SKIPPED: {name}: {why}")
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for name, path in sorted(paths.items()):
            rows += measured(xatlas, burl, name, path, pathlib.Path(scratch))
            print(f"{name}: measured", flush=True)
    quality.write_table(HERE / "xatlas.csv", rows)
    page.write(quality.read_table(quality.TABLE))


if __name__ == "__main__": main()
