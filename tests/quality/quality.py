#!/usr/bin/env python3
"""Measures every kind of atlas on public meshes and judges the figures by the committed table.csv:
  quality.py [--update] [--only MESH,...] BURL LAYOUT_TIMES FOLDER
FOLDER keeps the meshes, which meshes.json names. A row that is more than 3 % worse, or whose layout
takes more than 15 % longer in times of the reference kernel, is printed, and the exit status is 1.
--update writes the table and the page docs/lab/quality.md anew. Meshes that cannot be fetched are
printed and keep their rows; without any, the exit status is 77."""
import argparse, concurrent.futures as futures, csv, json, math, pathlib, subprocess, sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import fetch, page

TABLE = HERE / "table.csv"
KINDS = ["uniform", "area", "length", "quad", "patch", "chart"]
# A column's tolerance (a share of the kept value), and whether less is worse. Errors have a floor
# besides, a hundredth of an 8-bit code, and times one, half of the kernel: below it nothing is worse. "ms" is only told.
ERRORS = ["L0", "L1", "L2", "L3", "L4", "L5", "L6", "long1", "long2", "long3", "trilinear", "16x", "worst"]
HIGHER_IS_WORSE = ERRORS + ["stretch50", "stretch95", "vertices"]
COLUMNS = ["mesh", "kind", *HIGHER_IS_WORSE, "coverage", "kernels", "ms"]
TOLERANCE, TIME_TOLERANCE, FLOOR, TIME_FLOOR = 0.03, 0.15, 0.01 / 255, 0.5


def geometric_mean(values):
    return math.exp(sum(math.log(max(v, 1e-12)) for v in values) / len(values))


def figures(atlas):
    """The columns of one atlas of `burl metrics --levels --json`."""
    lookups = atlas["lookups"]
    row = {f"L{level['level']}": level["rmse"] for level in lookups["levels"] if level["level"] <= 6}
    row |= {f"long{level['level']}": level["rmse"] for level in lookups["grazing_8_to_1"]}
    views = [view["rmse"] for view in lookups["sampled_views"]]
    row |= {sampler: geometric_mean([view[sampler] for view in views]) for sampler in ("trilinear", "16x")}
    row |= {"worst": max(view["16x"] for view in views), "coverage": atlas["coverage"],
            "vertices": atlas["vertex_ratio"], "stretch50": atlas["anisotropy_50_95"][0],
            "stretch95": atlas["anisotropy_50_95"][1]}
    return row


def answer(command):
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if run.returncode: sys.exit(f"{' '.join(map(str, command))}: {run.stderr}")
    return json.loads(run.stdout)


def measured(burl, clock, name, path):
    """The rows of a mesh."""
    told = answer([burl, "metrics", path, "--atlas", "all", "--levels", "--json", "--size", 1024, "--progress", "none"])
    times = answer([clock, path, 5, *KINDS])
    rows = {}
    for kind, atlas in zip(KINDS, told["atlases"], strict=True):
        rows[name, kind] = {"mesh": name, "kind": kind} | figures(atlas) | times[kind]
    return rows


def written(value):
    return value if isinstance(value, str) else f"{value:.4g}"


def read_table(path):
    with open(path, newline="") as file:
        return {(row["mesh"], row["kind"]): {k: v if k in ("mesh", "kind") else float(v) for k, v in row.items()}
                for row in csv.DictReader(file)}


def write_table(path, rows):
    with open(path, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        for row in rows: out.writerow([written(row[column]) for column in COLUMNS])


def is_worse(column, was, now):
    if not math.isfinite(now): return True
    if column == "coverage": return now < was * (1 - TOLERANCE)
    if column == "kernels": return now > max(was, TIME_FLOOR) * (1 + TIME_TOLERANCE)
    if column in ERRORS: return now > max(was * (1 + TOLERANCE), FLOOR)
    return now > was * (1 + TOLERANCE)


def judged(kept, now):
    """What is worse in `now` than in `kept`: a list of (mesh, kind, column, was, is). Rows that the
    table lacks, and figures that a row lacks, are worse."""
    worse = []
    for key, row in now.items():
        was = kept.get(key)
        if was is None:
            worse.append((*key, "not in the table", math.nan, math.nan))
            continue
        for column in [*HIGHER_IS_WORSE, "coverage", "kernels"]:
            value = row.get(column, math.nan)
            if is_worse(column, was[column], value): worse.append((*key, column, was[column], value))
    return worse


def timed_again(clock, paths, kept, now):
    """Measures times that are worse up to three times more, with three times the rounds; the least counts."""
    for _ in range(3):
        for mesh, kind in [worse[:2] for worse in judged(kept, now) if worse[2] == "kernels"]:
            again = answer([clock, paths[mesh], 15, kind])[kind]
            if again["kernels"] < now[mesh, kind]["kernels"]: now[mesh, kind] |= again


def updated(kept, now):
    """The table's rows with those of `now`. Times within the tolerance stay, lest every update change all rows."""
    rows = kept | now
    for key in kept.keys() & now.keys():
        was, time = kept[key]["kernels"], now[key]["kernels"]
        if not is_worse("kernels", was, time) and not is_worse("kernels", time, was):
            rows[key] = now[key] | {column: kept[key][column] for column in ("kernels", "ms")}
    return [rows[key] for key in sorted(rows, key=lambda key: (key[0], KINDS.index(key[1])))]


def judge(clock, paths, kept, now):
    """Prints what is worse; returns how many figures are."""
    timed_again(clock, paths, kept, now)
    worse = judged(kept, now)
    for mesh, kind, column, was, value in worse: print(f"WORSE: {mesh}, {kind}: {column} {was:.4g} -> {value:.4g}")
    better = {key for key, row in now.items() for c in HIGHER_IS_WORSE if key in kept and row[c] < kept[key][c] * (1 - TOLERANCE)}
    if better: print(f"{len(better)} rows have become better; keep that with --update")
    return len(worse)


def arguments():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--update", action="store_true")
    options.add_argument("--only")
    for name in ("burl", "layout_times", "folder"): options.add_argument(name)
    return options.parse_args()


def asked_meshes(only):
    meshes = json.loads((HERE / "meshes.json").read_text())
    names = only.split(",") if only else list(meshes["meshes"])
    for name in names:
        if name not in meshes["meshes"]: sys.exit(f"--only {name}: it must be one of {', '.join(meshes['meshes'])}")
    return meshes | {"meshes": {name: meshes["meshes"][name] for name in names}}


def main():
    asked = arguments()
    paths, absent = fetch.fetch(asked_meshes(asked.only), asked.folder)
    for name, why in absent.items(): print(f"SKIPPED: {name}: {why}")
    if not paths: return 77
    now = {}
    with futures.ThreadPoolExecutor(2) as pool:
        for name, rows in zip(paths, pool.map(lambda mesh: measured(asked.burl, asked.layout_times, *mesh), paths.items())):
            now |= rows
            print(f"{name}: measured", flush=True)
    kept = read_table(TABLE) if TABLE.exists() else {}
    if asked.update:
        timed_again(asked.layout_times, paths, kept, now)
        write_table(TABLE, updated(kept, now))
        page.write(read_table(TABLE))
        return 0
    worse = judge(asked.layout_times, paths, kept, now)
    print(f"{len(now)} rows of {len(paths)} meshes, {len(absent)} meshes skipped, {worse} figures worse")
    return 1 if worse else 0


if __name__ == "__main__": sys.exit(main())
