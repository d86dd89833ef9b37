# Holds the nodes of Blender's functions to Blender itself, whose geometry nodes evaluate the same textures at the vertices of a mesh:
#   blender --background --factory-startup --python-exit-code 1 --python blender_points.py -- BURL SCRATCH [POINTS [TABLE]]
# prints for every case the largest and the RMS difference over POINTS (10000) random points of [-2, 2]^3, and fails where a texture's
# RMS difference is above 1e-4 (jumps between cells at float32's rounding apart: at most 1 point in 500 may differ by more than 1e-3).
# TABLE is a file to write the first 12 points' values to: tests/procedural/blender/references.json.
import json
import os
import subprocess
import sys

import bpy
import numpy

arguments = sys.argv[sys.argv.index("--") + 1 :]
burl, scratch = arguments[:2]
count = int(arguments[2]) if len(arguments) > 2 else 10000
P = {"node": "point"}


def half(x):
    return {"node": "blender_vector_math", "operation": "multiply", "a": P, "b": x}


def noise(**more):
    return {"node": "blender_noise", "vector": P, **more}


# Name, type, properties, inputs by name or index, output, our JSON. A texture's vector is the position.
cases = []


def case(name, kind, properties, inputs, output, ours):
    cases.append((name, kind, properties, inputs, output, ours))


for detail, roughness, distortion in ((0, 0.5, 0), (2, 0.5, 0), (3.6, 0.8, 0), (15, 0.3, 0), (2.5, 0.6, 1.3)):
    settings = {"Scale": 2.7, "Detail": detail, "Roughness": roughness, "Distortion": distortion}
    ours = {"scale": 2.7, "detail": detail, "roughness": roughness, "distortion": distortion}
    case(f"noise {detail} {roughness} {distortion}", "TexNoise", {}, settings, "Fac", noise(**ours))
    case(f"noise colour {detail}", "TexNoise", {}, settings, "Color", noise(**ours) | {"node": "blender_noise_color"})
for kind in ("MULTIFRACTAL", "RIDGED_MULTIFRACTAL", "HYBRID_MULTIFRACTAL", "FBM", "HETERO_TERRAIN"):
    for detail in (0.4, 1, 2, 5.3):
        numbers = {"scale": 1.9, "detail": detail, "dimension": 0.7, "lacunarity": 2.2, "offset": 0.6, "gain": 1.4}
        inputs = {key.capitalize(): value for key, value in numbers.items()}
        ours = {"node": "blender_musgrave", "vector": P, "kind": kind.lower().replace("_multifractal", ""), **numbers}
        case(f"musgrave {kind.lower()} {detail}", "TexMusgrave", {"musgrave_type": kind}, inputs, "Fac", ours)
for feature in ("F1", "F2", "SMOOTH_F1", "DISTANCE_TO_EDGE", "N_SPHERE_RADIUS"):
    metrics = ("EUCLIDEAN", "MANHATTAN", "CHEBYCHEV", "MINKOWSKI") if "F" in feature[:1] + feature[7:8] else ("EUCLIDEAN",)
    for metric in metrics:
        numbers = {"scale": 2.3, "smoothness": 0.6, "exponent": 1.7, "randomness": 0.8}
        inputs = {key.capitalize(): value for key, value in numbers.items()}
        ours = {"node": "blender_voronoi", "vector": P, "feature": feature.lower(), "metric": metric.lower(), **numbers}
        properties = {"feature": feature, "distance": metric}
        radius = feature == "N_SPHERE_RADIUS"
        case(f"voronoi {feature.lower()} {metric.lower()}", "TexVoronoi", properties, inputs, "Radius" if radius else "Distance", ours)
        if feature in ("F1", "F2", "SMOOTH_F1"):
            for output in ("Color", "Position"):
                more = ours | {"node": "blender_voronoi_color", "gives": output.lower()}
                case(f"voronoi {feature.lower()} {metric.lower()} {output.lower()}", "TexVoronoi", properties, inputs, output, more)
for kind in ("BANDS", "RINGS"):
    for direction in ("X", "Y", "Z", "DIAGONAL"):
        profile = {"X": "SIN", "Y": "SAW", "Z": "TRI", "DIAGONAL": "SIN"}[direction]
        distortion = {"X": 0, "Y": 0, "Z": 2.4, "DIAGONAL": 1.5}[direction]
        side = "SPHERICAL" if direction == "DIAGONAL" else direction
        properties = {"wave_type": kind, "bands_direction": direction, "rings_direction": side, "wave_profile": profile}
        inputs = {"Scale": 0.7, "Distortion": distortion, "Detail": 2.3, "Detail Scale": 1.4, "Detail Roughness": 0.6, "Phase Offset": 0.9}
        ours = {"node": "blender_wave", "vector": P, "kind": kind.lower(), "direction": "all" if direction == "DIAGONAL" else direction.lower(),
                "profile": {"SIN": "sine", "SAW": "saw", "TRI": "triangle"}[profile], "scale": 0.7, "distortion": distortion,
                "detail": 2.3, "detail_scale": 1.4, "detail_roughness": 0.6, "phase": 0.9}
        case(f"wave {kind.lower()} {direction.lower()}", "TexWave", properties, inputs, "Fac", ours)
for depth, distortion in ((0, 1.0), (1, 0.7), (2, 1.0), (5, 1.6), (10, 0.8)):
    case(f"magic {depth}", "TexMagic", {"turbulence_depth": depth}, {"Scale": 1.3, "Distortion": distortion}, "Color",
         {"node": "blender_magic", "vector": P, "depth": depth, "scale": 1.3, "distortion": distortion})
for kind in ("LINEAR", "QUADRATIC", "EASING", "DIAGONAL", "SPHERICAL", "QUADRATIC_SPHERE", "RADIAL"):
    case(f"gradient {kind.lower()}", "TexGradient", {"gradient_type": kind}, {}, "Fac",
         {"node": "blender_gradient", "vector": P, "kind": kind.lower()})
for offset, every, squash, squashed in ((0.5, 2, 1, 2), (0.3, 3, 1.6, 2), (0.5, 1, 0.7, 3)):
    numbers = {"scale": 3.0, "mortar": 0.05, "smooth": 0.4, "bias": -0.1, "width": 0.6, "height": 0.3}
    inputs = {"Scale": 3.0, "Mortar Size": 0.05, "Mortar Smooth": 0.4, "Bias": -0.1, "Brick Width": 0.6, "Row Height": 0.3,
              "Color1": (0, 0, 0, 1), "Color2": (1, 1, 1, 1), "Mortar": (0, 0, 1, 1)}
    properties = {"offset": offset, "offset_frequency": every, "squash": squash, "squash_frequency": squashed}
    ours = {"node": "blender_brick", "vector": P, **numbers, **properties}
    tint, mortar = ours | {"gives": "tint"}, ours | {"gives": "mortar"}
    case(f"brick mortar {every}", "TexBrick", properties, inputs, "Fac", mortar)
    case(f"brick colour {every}", "TexBrick", properties, inputs, "Color",
         {"node": "blender_mix", "amount": mortar, "a": tint, "b": {"node": "combine", "blue": 1}})
case("checker", "TexChecker", {}, {"Scale": 2.6}, "Fac", {"node": "blender_checker", "vector": P, "scale": 2.6})
case("white noise", "TexWhiteNoise", {}, {}, "Value", {"node": "blender_white_noise", "vector": P})
case("white noise colour", "TexWhiteNoise", {}, {}, "Color", {"node": "blender_white_noise_color", "vector": P})

channel = {axis: {"node": "split", "input": P, "channel": axis} for axis in ("red", "green", "blue")}
operations = """ADD SUBTRACT MULTIPLY DIVIDE MULTIPLY_ADD POWER LOGARITHM SQRT INVERSE_SQRT ABSOLUTE EXPONENT MINIMUM MAXIMUM LESS_THAN
GREATER_THAN SIGN COMPARE SMOOTH_MIN SMOOTH_MAX ROUND FLOOR CEIL TRUNC FRACT MODULO WRAP SNAP PINGPONG SINE COSINE TANGENT ARCSINE
ARCCOSINE ARCTANGENT ARCTAN2 SINH COSH TANH RADIANS DEGREES""".split()
for operation in operations:
    case(f"math {operation.lower()}", "Math", {"operation": operation}, {0: "x", 1: "y", 2: "z"}, 0,
         {"node": "blender_math", "operation": operation.lower(), "a": channel["red"], "b": channel["green"], "c": channel["blue"]})
vectors = """ADD SUBTRACT MULTIPLY DIVIDE MULTIPLY_ADD CROSS_PRODUCT PROJECT REFLECT REFRACT FACEFORWARD DOT_PRODUCT DISTANCE LENGTH SCALE
NORMALIZE ABSOLUTE MINIMUM MAXIMUM FLOOR CEIL FRACTION MODULO WRAP SNAP SINE COSINE TANGENT""".split()
three = {"node": "combine", "red": 0.7, "green": -0.4, "blue": 1.3}
other = {"node": "combine", "red": -0.6, "green": 0.8, "blue": 0.35}
for operation in vectors:
    number = operation in ("DOT_PRODUCT", "DISTANCE", "LENGTH")
    case(f"vector {operation.lower()}", "VectorMath", {"operation": operation},
         {0: "position", 1: (0.7, -0.4, 1.3), 2: (-0.6, 0.8, 0.35), 3: 0.8}, 1 if number else 0,
         {"node": "blender_vector_math", "operation": operation.lower(), "a": P, "b": three, "c": other, "scale": 0.8})
for curve in ("LINEAR", "STEPPED", "SMOOTHSTEP", "SMOOTHERSTEP"):
    case(f"map range {curve.lower()}", "MapRange", {"interpolation_type": curve, "clamp": False},
         {0: "x", 1: -0.7, 2: 1.2, 3: 0.3, 4: 2.0, 5: 3.5}, 0,
         {"node": "blender_map_range", "curve": curve.lower(), "input": channel["red"], "from_low": -0.7, "from_high": 1.2,
          "to_low": 0.3, "to_high": 2.0, "steps": 3.5})
modes = """MIX DARKEN MULTIPLY BURN LIGHTEN SCREEN DODGE ADD OVERLAY SOFT_LIGHT LINEAR_LIGHT DIFFERENCE SUBTRACT DIVIDE HUE SATURATION
COLOR VALUE""".split()
for mode in modes:
    case(f"mix {mode.lower()}", "MixRGB", {"blend_type": mode}, {0: 0.7, 1: "colour", 2: (0.3, 0.8, 0.15, 1)}, 0,
         {"node": "blender_mix", "mode": mode.lower(), "amount": 0.7, "b": {"node": "combine", "red": 0.3, "green": 0.8, "blue": 0.15},
          "a": {"node": "blender_voronoi_color", "vector": P, "scale": 3}})


def evaluate(kind, properties, inputs, output, points):
    """The values of a node's output at points, float32, three numbers each."""
    mesh = bpy.data.meshes.new("points")
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set("co", points.ravel())
    thing = bpy.data.objects.new("points", mesh)
    bpy.context.scene.collection.objects.link(thing)
    tree = bpy.data.node_groups.new("points", "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    begin, end = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    store = tree.nodes.new("GeometryNodeStoreNamedAttribute")
    store.data_type, store.domain = "FLOAT_VECTOR", "POINT"
    store.inputs["Name"].default_value = "result"
    position = tree.nodes.new("GeometryNodeInputPosition").outputs[0]
    parts = tree.nodes.new("ShaderNodeSeparateXYZ")
    tree.links.new(position, parts.inputs[0])
    cells = tree.nodes.new("ShaderNodeTexVoronoi")
    cells.inputs["Scale"].default_value = 3
    tree.links.new(position, cells.inputs["Vector"])
    sources = {"position": position, "x": parts.outputs[0], "y": parts.outputs[1], "z": parts.outputs[2], "colour": cells.outputs["Color"]}
    node = tree.nodes.new("ShaderNode" + kind)
    for key, value in properties.items():
        setattr(node, key, value)
    if kind.startswith("Tex"):
        tree.links.new(position, node.inputs["Vector"])
    for key, value in inputs.items():
        if isinstance(value, str):
            tree.links.new(sources[value], node.inputs[key])
        else:
            node.inputs[key].default_value = value
    tree.links.new(begin.outputs[0], store.inputs["Geometry"])
    tree.links.new(node.outputs[output], next(s for s in store.inputs if s.name == "Value" and s.enabled))
    tree.links.new(store.outputs[0], end.inputs[0])
    thing.modifiers.new("points", "NODES").node_group = tree
    data = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.attributes["result"].data
    values = numpy.empty(3 * len(points), numpy.float32)
    data.foreach_get("vector", values)
    bpy.data.objects.remove(thing)
    bpy.data.node_groups.remove(tree)
    return values.reshape(-1, 3)


def ours_of(json_node, points):
    """The values of a node of ours at the points of points.csv, three numbers each."""
    columns = []
    for axis in ("red", "green", "blue"):
        recipe = {"solid": {"space": "object"}, "texture": {"node": "split", "input": json_node, "channel": axis}}
        with open("node.json", "w") as file:
            json.dump(recipe, file)
        answer = subprocess.run([burl, "eval", "node.json", "--points", "points.csv", "--precision", "float64", "--json"], capture_output=True,
                                text=True)
        if answer.returncode:
            sys.exit(answer.stderr)
        columns.append([point["float64"]["value"] for point in json.loads(answer.stdout)["points"]])
    return numpy.array(columns).T


def main():
    os.makedirs(scratch, exist_ok=True)
    os.chdir(scratch)
    points = numpy.random.default_rng(4).uniform(-2, 2, (count, 3)).astype(numpy.float32)
    numpy.savetxt("points.csv", points, fmt="%.9g", delimiter=",")
    table, bad = [], []
    for name, kind, properties, inputs, output, ours in cases:
        if os.environ.get("ONLY") and not name.startswith(tuple(os.environ["ONLY"].split(","))): continue
        theirs = evaluate(kind, properties, inputs, output, points)
        if kind == "TexGradient":  # geometry nodes do not clamp it, Cycles does
            theirs = numpy.clip(theirs, 0, 1)
        difference = numpy.abs(ours_of(ours, points) - theirs).max(axis=1)
        relative = difference / numpy.maximum(1, numpy.abs(theirs).max(axis=1))
        jumps = relative > 1e-3
        rms = float(numpy.sqrt(numpy.mean(relative[~jumps] ** 2))) if not jumps.all() else 1.0
        fails = rms > 1e-4 or jumps.sum() > count / 500
        print(f"{'BAD ' if fails else ''}{name}: RMS {rms:.2g}, largest {relative[~jumps].max(initial=0):.2g}, jumps {jumps.sum()}")
        bad += [name] if fails else []
        table.append({"name": name, "texture": ours, "values": [[float(f"{x:.6g}") for x in row] for row in theirs[:12]]})
    if len(arguments) > 3:
        with open(arguments[3], "w") as file:
            rows = ",\n".join(json.dumps(row) for row in table)
            file.write(f'{{"points": {json.dumps(points[:12].astype(float).tolist())},\n"cases": [\n{rows}]}}\n')
    print(f"{len(bad)} of {len(cases)} cases disagree")
    if bad:
        sys.exit(1)


if __name__ == "__main__":
    main()
