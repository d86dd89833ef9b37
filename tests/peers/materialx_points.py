# Holds the nodes of MaterialX's functions to the shaders that MaterialX's own generator writes, drawn by a browser in float32:
#   materialx_points.py MODULES CHROMIUM BURL SCRATCH [POINTS [TABLE]]
# prints for every case the largest and the RMS difference over POINTS (10000) random points of [-4, 4]^3, relative to values above 1, and
# fails where the RMS is above 1e-5 (of what needs a sine or an arc cosine 3e-4: SwiftShader, the renderer, has rough ones) or more than 1
# point in 500 differs by more than 1e-3 (a jump between cells at float32's rounding).
# MODULES and CHROMIUM are those of materialx_values.mjs. TABLE is a file to write the first 12 points' values to, and the largest
# difference of every case: tests/procedural/materialx/references.json. ONLY=prefix,... runs the cases whose names begin so.
import csv
import json
import os
import random
import struct
import subprocess
import sys

modules, chromium, burl, scratch = (os.path.abspath(path) for path in sys.argv[1:5])
count = int(sys.argv[5]) if len(sys.argv) > 5 else 10000
table_file = os.path.abspath(sys.argv[6]) if len(sys.argv) > 6 else None
here = os.path.dirname(os.path.abspath(__file__))

P = {"node": "point"}
BATCH = 12
ROUGH = ("sin", "cos", "tan", "acos", "rotate3d")
WIDTHS = {"float": 1, "vector2": 2, "vector3": 3, "color3": 3, "vector4": 4}


def channel(of, name):
    return {"node": "split", "input": of, "channel": name}


def vector(x, y, z):
    return {"node": "combine", "red": x, "green": y, "blue": z}


def math(operation, *inputs):
    return {"node": "materialx_math", "operation": operation, **dict(zip("abc", inputs))}


def vector_math(operation, *inputs):
    return {"node": "materialx_vector_math", "operation": operation, **dict(zip("abc", inputs))}


X, Y, Z = (channel(P, name) for name in ("red", "green", "blue"))
# A colour in [0, 1]: an eighth of the point plus a half.
COLOR = vector_math("add", vector_math("multiply", P, 0.125), 0.5)
UNIT = vector_math("normalize", P)
OTHER = vector(0.7, -0.4, 1.3)

# The sources that inputs name: name: (type, nodes, ours).
SOURCES = {
    "p": ("vector3", '<position name="p" type="vector3"><input name="space" type="string" value="object"/></position>', P),
    "x": ("float", '<extract name="x" type="float"><input name="in" type="vector3" nodename="p"/></extract>', X),
    "y": ("float", '<extract name="y" type="float"><input name="in" type="vector3" nodename="p"/>'
                   '<input name="index" type="integer" value="1"/></extract>', Y),
    "z": ("float", '<extract name="z" type="float"><input name="in" type="vector3" nodename="p"/>'
                   '<input name="index" type="integer" value="2"/></extract>', Z),
    "above": ("float", '<absval name="above" type="float"><input name="in" type="float" nodename="x"/></absval>', math("absval", X)),
    "side": ("float", '<multiply name="side" type="float"><input name="in1" type="float" nodename="x"/>'
                      '<input name="in2" type="float" value="0.25"/></multiply>', math("multiply", X, 0.25)),
    "uv": ("vector2", '<combine2 name="uv" type="vector2"><input name="in1" type="float" nodename="x"/>'
                      '<input name="in2" type="float" nodename="y"/></combine2>', P),
    "eighth": ("vector3", '<multiply name="eighth" type="vector3"><input name="in1" type="vector3" nodename="p"/>'
                          '<input name="in2" type="float" value="0.125"/></multiply>', None),
    "half": ("vector3", '<add name="half" type="vector3"><input name="in1" type="vector3" nodename="eighth"/>'
                        '<input name="in2" type="float" value="0.5"/></add>', COLOR),
    "color": ("color3", '<convert name="color" type="color3"><input name="in" type="vector3" nodename="half"/></convert>', COLOR),
    "grey": ("float", '<extract name="grey" type="float"><input name="in" type="vector3" nodename="half"/></extract>',
             channel(COLOR, "red")),
    "unit": ("vector3", '<normalize name="unit" type="vector3"><input name="in" type="vector3" nodename="p"/></normalize>', UNIT),
    "positive": ("vector3", '<absval name="positive" type="vector3"><input name="in" type="vector3" nodename="p"/></absval>',
                 vector_math("absval", P)),
    "sides": ("vector3", '<multiply name="sides" type="vector3"><input name="in1" type="vector3" nodename="p"/>'
                         '<input name="in2" type="float" value="0.25"/></multiply>', vector_math("multiply", P, 0.25)),
    # Shaders ignore constants of inputs that default to geometry, as normals do, and take those of nodes.
    "other": ("vector3", '<constant name="other" type="vector3"><input name="value" type="vector3" value="0.7, -0.4, 1.3"/></constant>', OTHER),
    "up": ("vector3", '<constant name="up" type="vector3"><input name="value" type="vector3" value="0.6, 0.0, 0.8"/></constant>',
           vector(0.6, 0.0, 0.8)),
}
# Whole numbers that depend on the point, as a compiler sees it, so that it does not write loops out, which takes it minutes.
for whole in (1, 3, 6):
    SOURCES[f"whole{whole}"] = ("integer", f'<multiply name="little{whole}" type="float"><input name="in1" type="float" nodename="x"/>'
                                '<input name="in2" type="float" value="0.01"/></multiply>'
                                f'<add name="more{whole}" type="float"><input name="in1" type="float" nodename="little{whole}"/>'
                                f'<input name="in2" type="float" value="{whole}.5"/></add>'
                                f'<floor name="whole{whole}" type="integer"><input name="in" type="float" nodename="more{whole}"/></floor>', whole)
cases = []


def ours_of_value(value):
    if isinstance(value, str):
        return SOURCES[value][2]
    return vector(*value) if isinstance(value, tuple) else value


def case(name, category, kind, inputs, ours):
    """A case: a node of that category and type, its inputs by name: (type, number, tuple or source), and our node."""
    cases.append((name, category, kind, inputs, ours))


def operation(name, kind, inputs, order=None, integer=()):
    """A case of an operation: inputs by name, in our order a, b, c."""
    number = kind == "float" and "p" not in inputs.values()
    typed = {}
    for key, value in inputs.items():
        wide = "color3" if kind == "color3" else "vector3"
        typed[key] = (SOURCES[value][0] if isinstance(value, str) else wide if isinstance(value, tuple) else "float", value)
    sides = [ours_of_value(inputs[key]) for key in order or inputs]
    case(f"{'math' if number else 'vector'} {name}" + ("" if kind in ("float", "vector3") else f" {kind}"), name, kind, typed,
         (math if number else vector_math)(name, *sides))


def moved(node, *offset):
    """A node of ours at the point moved by `offset`."""
    return node | {"position": vector_math("add", P, vector(*offset))}


def noise_cases(name, node, settings, inputs, second):
    """Cases of a noise in all its types: the second of two numbers is a noise of its own where `second` says where, and so is the last of four."""
    category = name.split()[0]
    one, three = {"node": node, **settings}, {"node": node + "_color", **settings}
    two = vector(one, moved(one, *second), 0) if second else three
    for kind, ours in (("float", one), ("vector2", two), ("vector3", three), ("color3", three)):
        # Three sums of fractal3d at once take the software renderer minutes, if it ends at all, and octaves far from 0 have few digits.
        if kind == "float" or (category != "fractal3d" and kind != "vector2") or (kind == "vector2" and "6" not in name):
            case(f"{name} {kind}", category, kind, inputs, ours)
    if category == "fractal3d" or "6" in name:
        return
    source = "four_" + name.replace(" ", "_")
    lines = "".join(f'<input name="{key}" type="{kind}" {"nodename" if isinstance(value, str) else "value"}="{value}"/>'
                    for key, (kind, value) in inputs.items())
    SOURCES[source] = ("vector4", f'<{category} name="{source}" type="vector4">{lines}</{category}>', None)
    case(f"{name} last of vector4", "extract", "float", {"in": ("vector4", source), "index": ("integer", 3)},
         moved(one, *(second or (19, 73, 29))))


for dimensions in (2, 3):
    place = {"texcoord": ("vector2", "uv")} if dimensions == 2 else {"position": ("vector3", "p")}
    settings = {"dimensions": str(dimensions)}
    noise_cases(f"noise{dimensions}d", "materialx_noise", settings, place, None)
    for octaves, lacunarity, diminish in ((1, 2.0, 0.5), (3, 2.0, 0.5), (6, 2.3, 0.7)):
        numbers = {"octaves": octaves, "lacunarity": lacunarity, "diminish": diminish}
        typed = {"octaves": ("integer", f"whole{octaves}"), "lacunarity": ("float", lacunarity), "diminish": ("float", diminish)}
        noise_cases(f"fractal{dimensions}d {octaves}", "materialx_fractal", settings | numbers, place | typed, (19, 193, 17))
    case(f"cellnoise{dimensions}d", f"cellnoise{dimensions}d", "float", place, {"node": "materialx_cellnoise", **settings})
    for kind, color in (("float", ""), ("vector2", "_color"), ("vector3", "_color")):
        for style in ("distance", "solid"):
            for jitter in (0.0, 0.6, 1.0) if kind == "float" else (0.8,):
                typed = {"jitter": ("float", jitter), "style": ("integer", int(style == "solid"))}
                case(f"worley{dimensions}d {kind} {style} {jitter}", f"worleynoise{dimensions}d", kind, place | typed,
                     {"node": "materialx_worley" + color, **settings, "jitter": jitter, "style": style})

for name in ("add", "subtract", "multiply", "divide", "modulo"):
    operation(name, "float", {"in1": "x", "in2": "y"})
    operation(name, "vector3", {"in1": "p", "in2": (0.7, -0.4, 1.3)})
for name in ("power", "min", "max"):
    operation(name, "float", {"in1": "above", "in2": "y"})
    operation(name, "vector3", {"in1": "positive", "in2": (0.7, -0.4, 1.3)})
operation("safepower", "float", {"in1": "x", "in2": "y"})
operation("safepower", "vector3", {"in1": "p", "in2": (0.7, -0.4, 1.3)})
for name in ("absval", "sign", "floor", "ceil", "round", "fract", "sin", "cos", "tan", "exp"):
    operation(name, "float", {"in": "x"})
    operation(name, "vector3", {"in": "p"})
operation("trianglewave", "float", {"in": "x"})
for name in ("sqrt", "ln"):
    operation(name, "float", {"in": "above"})
    operation(name, "vector3", {"in": "positive"})
for name in ("asin", "acos"):
    operation(name, "float", {"in": "side"})
    operation(name, "vector3", {"in": "sides"})
operation("atan2", "float", {"iny": "x", "inx": "y"})
operation("atan2", "vector3", {"iny": "p", "inx": (0.7, -0.4, 1.3)})
for name in ("clamp", "smoothstep"):
    operation(name, "float", {"in": "x", "low": -1.2, "high": 2.1})
    operation(name, "vector3", {"in": "p", "low": (-1.2, 0.3, -0.1), "high": (1.0, 2.0, 0.4)})
operation("smoothstep", "float", {"in": "x", "low": "y", "high": "z"})
operation("clamp", "float", {"in": "x", "low": "y", "high": "z"})
operation("mix", "float", {"bg": "x", "fg": "y", "mix": 0.3})
operation("mix", "vector3", {"bg": "p", "fg": (0.7, -0.4, 1.3), "mix": 0.3})
operation("mix", "vector3", {"bg": "p", "fg": (0.7, -0.4, 1.3), "mix": (0.1, 0.5, 0.8)})
for name in ("burn", "dodge", "screen", "overlay", "difference", "plus", "minus"):
    operation(name, "float", {"bg": "grey", "fg": 0.35, "mix": 0.7})
    operation(name, "float", {"bg": 0.35, "fg": "grey", "mix": 0.7})
    operation(name, "color3", {"bg": "color", "fg": (0.3, 0.8, 0.15), "mix": 0.7})
operation("dotproduct", "float", {"in1": "p", "in2": (0.7, -0.4, 1.3)})
operation("crossproduct", "vector3", {"in1": "p", "in2": (0.7, -0.4, 1.3)})
operation("normalize", "vector3", {"in": "p"})
operation("magnitude", "float", {"in": "p"})
operation("distance", "float", {"in1": "p", "in2": (0.7, -0.4, 1.3)})
operation("rotate3d", "vector3", {"in": "p", "axis": (0.7, -0.4, 1.3), "amount": 50.0})
operation("rotate3d", "vector3", {"in": "p", "axis": (0.7, -0.4, 1.3), "amount": "x"})
operation("reflect", "vector3", {"in": "p", "normal": "other"})
operation("refract", "vector3", {"in": "unit", "normal": "up", "ior": 1.4})
operation("refract", "vector3", {"in": "unit", "normal": "up", "ior": 0.7})
operation("luminance", "color3", {"in": "color", "lumacoeffs": (0.2722287, 0.6740818, 0.0536895)})
operation("rgbtohsv", "color3", {"in": "color"})
operation("hsvtorgb", "color3", {"in": "color"})
for name in ("ifgreater", "ifgreatereq", "ifequal"):
    case(f"math {name}", name, "float", {"value1": ("float", "x"), "value2": ("float", "y"), "in1": ("float", 1.0), "in2": ("float", 0.0)},
         math(name, X, Y))


def document(chosen):
    lines = ['<?xml version="1.0"?>', '<materialx version="1.39"><nodegraph name="all">', *(nodes for _, nodes, _ in SOURCES.values())]
    for number, (_, category, kind, inputs, _) in enumerate(chosen):
        lines.append(f'<{category} name="n{number}" type="{kind}">')
        for key, (kind_of, value) in inputs.items():
            text = ", ".join(map(str, value)) if isinstance(value, tuple) else value
            lines.append(f'<input name="{key}" type="{kind_of}" {"nodename" if isinstance(value, str) else "value"}="{text}"/>')
        lines.append(f'</{category}><output name="o{number}" type="{kind}" nodename="n{number}"/>')
    return "\n".join(lines + ["</nodegraph></materialx>"])


def theirs_of(chosen, points):
    """The answers of the shaders. A browser gets a few at a time: it gives up where compiling many takes it too long."""
    answers = []
    for first in range(0, len(chosen), BATCH):
        answers += theirs_of_batch(chosen[first : first + BATCH], points)
    return answers


def theirs_of_batch(chosen, points):
    with open("points.mtlx", "w") as file:
        file.write(document(chosen))
    with open("points.json", "w") as file:
        json.dump({"position": points}, file)
    with open("jobs.json", "w") as file:
        json.dump([{"document": "points.mtlx", "output": f"all/o{n}", "points": "points.json"} for n in range(len(chosen))], file)
    answer = subprocess.run(["node", os.path.join(here, "materialx_values.mjs"), modules, chromium, "--list", "jobs.json"],
                            capture_output=True, text=True)
    if answer.returncode:
        sys.exit(answer.stderr + answer.stdout[-2000:])
    return json.loads(answer.stdout)


def ours_of(node):
    """The values of a node of ours at the points of points.csv: red, green and blue; a number comes three times."""
    with open("node.json", "w") as file:
        json.dump({"solid": {"space": "object"}, "texture": {"node": "combine", **{key: channel(node, key) for key in ("red", "green", "blue")}}},
                  file)
    answer = subprocess.run([burl, "eval", "node.json", "--points", "points.csv", "--precision", "float64"], capture_output=True, text=True)
    if answer.returncode:
        sys.exit(answer.stderr)
    return [[float(row[key]) for key in ("red", "green", "blue")] for row in csv.DictReader(answer.stdout.splitlines())]


def as_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def main():
    os.makedirs(scratch, exist_ok=True)
    os.chdir(scratch)
    generator = random.Random(4)
    points = [[as_float(generator.uniform(-4, 4)) for _ in range(3)] for _ in range(count)]
    with open("points.csv", "w") as file:
        file.writelines(",".join(map(repr, point)) + "\n" for point in points)
    only = tuple(os.environ["ONLY"].split(",")) if os.environ.get("ONLY") else ("",)
    chosen = [one for one in cases if one[0].startswith(only)]
    rows, bad = [], 0
    for (name, _, kind, _, ours), answer in zip(chosen, theirs_of(chosen, points)):
        if "error" in answer:
            print(f"BAD {name}: {answer['error']}")
            bad += 1
            continue
        width = WIDTHS[kind] if kind != "float" else 1
        differences, jumps = [], 0
        for their, our in zip(answer["values"], ours_of(ours)):
            size = max([1.0] + [abs(float(x)) for x in their])
            difference = max(abs(float(a) - b) for a, b in zip(their[:width], our)) / size
            if difference <= 1e-3:
                differences.append(difference)
            else:
                jumps += 1
        rms = (sum(d * d for d in differences) / len(differences)) ** 0.5 if differences else 1.0
        largest = max(differences, default=1.0)
        fails = rms > (3e-4 if name.split()[-1] in ROUGH else 1e-5) or jumps > count / 500
        bad += fails
        print(f"{'BAD ' if fails else ''}{name}: RMS {rms:.2g}, largest {largest:.2g}, jumps {jumps}", flush=True)
        rows.append({"name": name, "texture": ours, "largest": float(f"{largest:.2g}"), "values": answer["values"][:12]})
    if table_file:
        with open(table_file, "w") as file:
            lines = ",\n".join(json.dumps(row) for row in rows)
            file.write(f'{{"points": {json.dumps(points[:12])},\n"cases": [\n{lines}]}}\n')
    print(f"{bad} of {len(chosen)} cases disagree")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
