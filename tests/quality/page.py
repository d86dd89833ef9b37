"""The tables of docs/lab/quality.md, from table.csv and meshes.json: each stands between two comments of the page."""
import csv, json, math, pathlib, re, statistics

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs" / "lab" / "quality.md"
KINDS = ["uniform", "area", "length", "quad", "patch", "chart"]
ERRORS = ["L0", "L1", "L2", "L3", "L4", "L5", "L6", "long1", "long2", "long3", "trilinear", "16x", "worst"]


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def small(value):
    return f"{value:.4f}".lstrip("0") if value < 1 else f"{value:.3f}"


def figures(row):
    cells = [f"{-20 * math.log10(row['L0']):.1f}"] + [small(row[c]) for c in ERRORS[1:]]
    return cells + [f"{row['coverage']:.3f}".lstrip("0"), f"{row['stretch50']:.2f}, {row['stretch95']:.2f}",
                    f"{row['vertices']:.2f}", f"{row['kernels']:.2f}", f"{row['ms']:.3g}"]


def mean(rows):
    numbers = [k for k in rows[0] if k not in ("mesh", "kind")]
    return {k: math.exp(sum(math.log(max(row[k], 1e-12)) for row in rows) / len(rows)) for k in numbers}


def quotients(rows, others, kind, column):
    """Per mesh a kind's error over the smaller one of xatlas with padding 0 and 4."""
    better = {}
    for other in others: better[other["mesh"]] = min(other[column], better.get(other["mesh"], math.inf))
    return sorted(rows[mesh, kind][column] / error for mesh, error in better.items() if (mesh, kind) in rows)


def beside(rows, others, kind):
    """A row of figures per column: meshes at or below xatlas, at or below 1.15 of it, and the median and the largest quotient."""
    cells = []
    for column in ERRORS[:-1]:
        of = quotients(rows, others, kind, column)
        cells.append(f"{sum(q <= 1 for q in of)}, {sum(q <= 1.15 for q in of)}; {statistics.median(of):.2f}, {of[-1]:.2f}")
    return [kind, *cells]


def tables(rows, others, meshes):
    """The page's tables by name; `others` are xatlas's rows."""
    heads = ["L0 dB", *(f"L{level}" for level in range(1, 7)), "8:1 L1", "L2", "L3", "trilinear", "16x", "16x worst",
             "coverage", "stretch", "vertices", "kernels", "ms"]
    by_kind = {kind: [row for (_, k), row in rows.items() if k == kind] for kind in KINDS}
    result = {"means": table(["kind", *heads], [[kind, *figures(mean(of))] for kind, of in by_kind.items() if of])}
    for kind in ("chart", "patch"):
        result[kind] = table(["mesh", *heads], [[row["mesh"], *figures(row)] for row in by_kind[kind]])
    result["meshes"] = table(["mesh", "what it is", "from", "sha256 begins"], [
        [name, mesh["what"], mesh["archive"], f"`{mesh['sha256'][:12]}`"] for name, mesh in sorted(meshes["meshes"].items())])
    result["xatlas"] = table(["kind", "L0", *heads[1:12]], [beside(rows, others, kind) for kind in ("chart", "patch")])
    return result


def filled(text, rows, others, meshes):
    """The page's text with its tables anew."""
    for name, lines in tables(rows, others, meshes).items():
        text = re.sub(rf"(<!-- table {name} -->\n).*?(<!-- end -->)", lambda m: f"{m[1]}{lines}\n{m[2]}", text, flags=re.S)
    return text


def refreshed(rows):
    """The page's text for a table's rows by mesh and kind."""
    with open(HERE / "xatlas.csv", newline="") as file:
        others = [{k: v if k in ("mesh", "kind") else float(v) for k, v in row.items()} for row in csv.DictReader(file)]
    return filled(PAGE.read_text(), rows, others, json.loads((HERE / "meshes.json").read_text()))


def write(rows):
    PAGE.write_text(refreshed(rows))
