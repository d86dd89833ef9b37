#!/usr/bin/env python3
"""Small files that ask for much: small.py BURL LIBRARY FOLDER
Each holds one thing many times in at most 1.3 MB. It is refused or baked (at --size 16, or 1024 where its shape is odd) within SECONDS of processor time and MEBIBYTES of
memory, or within what its own row allows, which docs/reference/limits.md gives; a slower machine may take as much longer as it takes
for a yardstick."""
import base64, json, math, os, random, struct, subprocess, sys, threading

from common import EVERY, Burl, Report, png, sentence_problem

SECONDS, MEBIBYTES = 2.0, 1024
CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
ONE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)


class Case:
    """A file's name and bytes, with what is done with it, {} being the name, and the exit code of that."""

    def __init__(self, name, data, command="bake {} --size 16 -o out.glb", often=False, code=0, seconds=SECONDS, mebibytes=MEBIBYTES, beside=()):
        self.name, self.data, self.command, self.often, self.code = name, data, command, often, code
        self.seconds, self.mebibytes, self.beside = seconds, mebibytes, beside


def lines(count, line):
    return "".join(line(i) + "\n" for i in range(count))


def obj_cases():
    grid = 115
    rough = lines(grid * grid, lambda i: f"v {i % grid} {i // grid} {i % grid * (i // grid) % 3}") + "".join(
        f"f {i} {i + 1} {i + grid}\nf {i + 1} {i + grid + 1} {i + grid}\n" for y in range(grid - 1) for i in range(y * grid + 1, y * grid + grid))
    yield Case("soup.obj", lines(20000, lambda i: f"v {i} {i % 7} {i % 11}") + lines(
        30000, lambda i: f"f {1 + i % 20000} {1 + i * 7 % 20000} {1 + i * 13 % 20000}"), often=True)
    yield Case("round-a-point.obj", lines(40000, lambda i: f"v {i} {i * i % 101} 0") + lines(39997, lambda i: f"f 1 {i + 2} {i + 3}"))
    for kind in ("quad", "area", "patch", "chart"):
        yield Case("same-triangle.obj", CORNERS + "f 1 2 3\n" * 110000, f"bake {{}} --size 16 -o out.glb --atlas {kind}", code=4 if kind == "area" else 0)
    yield Case("polygon.obj", lines(50000, lambda i: f"v {i} {i * i % 997} 0") + "f " + " ".join(map(str, range(1, 50001))) + "\n", often=True)
    yield Case("star.obj", lines(40000, lambda i: f"v {math.cos(2.4 * i) * (1 + i % 2):.4f} {math.sin(2.4 * i) * (1 + i % 2):.4f} 0")
               + "f " + " ".join(map(str, range(1, 40001))) + "\n")
    yield Case("one-edge.obj", "v 0 0 0\nv 1 0 0\n" + lines(30000, lambda i: f"v 0 {i} 1") + lines(30000, lambda i: f"f 1 2 {i + 3}"))
    yield Case("groups.obj", CORNERS + lines(30000, lambda i: f"g a{i} b{i} c{i}\nf 1 2 3"), "bake {} --size 16 -o out.obj", often=True)
    yield Case("materials.obj", "mtllib none.mtl\n" + CORNERS + lines(40000, lambda i: f"usemtl m{i}\nf 1 2 3"))
    yield Case("weld.obj", lines(30000, lambda i: f"v {i * 1e-9} 0 {i % 3}") + lines(29990, lambda i: f"f {i + 1} {i + 2} {i + 3}"),
               "bake {} --size 16 -o out.glb --weld 0.1")
    random.seed(1)  # what lies beside its charts leads round and round in triangles far below a texel
    yield Case("far-and-near.obj", "v 40000 0 0\n" + lines(90, lambda i: "v %.3f %.3f %.3f" % tuple(random.random() for _ in range(3)))
               + lines(180, lambda i: "f %d %d %d" % tuple(1 + random.randrange(91) for _ in range(3))),
               "bake {} --size 256 -o out.glb --atlas chart", often=True, mebibytes=256)
    yield Case("lines.obj", CORNERS + "f 1 2 3\n" + "l 1 2\n" * 150000)
    for kind in ("uniform", "length", "quad", "patch", "chart"):
        yield Case("rough-grid.obj", rough, f"bake {{}} --size 16 -o out.glb --atlas {kind}", code=4 if kind in ("uniform", "length") else 0)


def other_mesh_cases():
    random.seed(1)
    def stl(count, triangle): return bytes(80) + struct.pack("<I", count) + b"".join(triangle() for _ in range(count))
    yield Case("same.stl", stl(19999, lambda: struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)))
    yield Case("loose.stl", stl(19999, lambda: struct.pack("<12fH", *(random.uniform(-1, 1) for _ in range(12)), 0)), often=True)
    head = "ply\nformat {} 1.0\nelement vertex {}\n{}element face {}\nproperty list uchar int vertex_indices\nend_header\n"
    place = "property float x\nproperty float y\nproperty float z\n"
    yield Case("claims.ply", head.format("ascii", 10**9, place, 1) + "0 0 0\n", often=True, code=3)
    yield Case("empty-faces.ply", head.format("binary_little_endian", 3, place, 900000).encode() + bytes(900036), often=True, code=3)
    yield Case("no-places.ply", head.format("binary_little_endian", 10**9, "", 1).encode() + bytes(36), often=True, code=3)


def odd_points(odd, count):
    """Points of eight kinds: one far away, of all magnitudes, on a grid, in a plane, on a helix, on a line, of five magnitudes, almost in a plane."""
    r, kind = random.Random(odd), odd % 8
    if kind == 0: return [[10 ** r.uniform(2, 9), 0, 0]] + [[r.random() for _ in range(3)] for _ in range(count - 1)]
    if kind == 1: return [[r.gauss(0, 1) * 10 ** r.uniform(-6, 3) for _ in range(3)] for _ in range(count)]
    if kind == 2: return [[r.randrange(6), r.randrange(6), r.randrange(3)] for _ in range(count)]
    if kind == 4: return [[math.cos(i), math.sin(i), i * 10 ** r.uniform(-4, 0)] for i in range(count)]
    if kind == 5: return [[i, i * i % 7 * 1e-5, i % 3 * 1e-9] for i in range(count)]
    return [[r.random() * 10 ** (i % 5 * (kind == 6)) for _ in range(2)] + [r.random() * {3: 0, 6: 1, 7: 1e-7}[kind]] for i in range(count)]


def odd_cases():
    """Random meshes of odd shapes, which ask for much where a texture is not small: at --size 1024."""
    for odd in range(48):
        r = random.Random(odd)
        count, faces, mode = r.choice((10, 40, 100, 400)), r.choice((30, 100, 300, 1000)), r.randrange(4)
        def corner(i, k):
            if mode == 0: return r.randrange(count)
            if mode == 1: return (i + k) % count
            if mode == 2: return 0 if k == 0 else 1 + (i + k) % (count - 1)
            return (i * i + k * (1 + i % 3)) % count
        points = odd_points(odd, count)
        text = lines(count, lambda i: "v %r %r %r" % tuple(points[i])) + lines(faces, lambda i: "f %d %d %d" % tuple(1 + corner(i, k) for k in range(3)))
        for kind in ("patch", "quad", "chart"):
            yield Case(f"odd-{odd}.obj", text, f"bake {{}} --size 1024 -j 2 -r marble -o out.glb --atlas {kind}", seconds=4, mebibytes=256)


def gltf(count, points, indices=None, mode=4, **more):
    """A glTF of one mesh in one node, and what `more` replaces."""
    data = points + (indices or b"")
    views, accessors = [{"buffer": 0, "byteLength": len(points)}], [
        {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3", "min": [-9, -9, -9], "max": [9, 9, 9]}]
    primitive = {"attributes": {"POSITION": 0}, "mode": mode}
    if indices:
        views.append({"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)})
        accessors.append({"bufferView": 1, "componentType": 5123, "count": len(indices) // 2, "type": "SCALAR"})
        primitive["indices"] = 1
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(more.get("nodes", [0]))))}],
                       "nodes": [{"mesh": 0}], "meshes": [{"primitives": [primitive]}], "accessors": accessors, "bufferViews": views,
                       "buffers": [{"byteLength": len(data), "uri": uri}]} | more)


def gltf_cases():
    unshared, corners = "bake {} --size 16 -o out.glb --unshare-instances", {"attributes": {"POSITION": 0}}
    count = 30000
    circle = b"".join(struct.pack("<3f", math.cos(i), math.sin(i), 0) for i in range(count))
    fan = b"".join(struct.pack("<3H", 0, 1 + i, 2 + i) for i in range(count - 2))
    yield Case("fan.gltf", gltf(count, circle, fan))
    yield Case("fan-mode.gltf", gltf(count, circle, None, 6))
    many = [{"mesh": 0, "translation": [i, 0, 0]} for i in range(20000)]
    for command in ("bake {} --size 16 -o out.glb", unshared, "bake {} --size 16 -o out.obj"):
        yield Case("instances.gltf", gltf(3, ONE, nodes=many), command)
    yield Case("primitives.gltf", gltf(3, ONE, meshes=[{"primitives": [corners] * 20000}]),
               "bake {} --size 16 -o out.glb --atlas-per material")
    yield Case("materials.gltf", gltf(3, ONE, materials=[{"name": f"m{i}"} for i in range(12000)],
                                      meshes=[{"primitives": [corners | {"material": i} for i in range(12000)]}]),
               "bake {} --size 16 -o out.glb --assign m*=marble", often=True)
    chain = [{"mesh": 0}] + [{"children": [i + 1]} if i < 24999 else {} for i in range(1, 25000)]
    yield Case("chain.gltf", gltf(3, ONE, nodes=chain, scenes=[{"nodes": [0, 1]}]), often=True)
    channel = {"sampler": 0, "target": {"node": 0, "path": "translation"}}
    yield Case("channels.gltf", gltf(3, ONE, animations=[{"channels": [channel] * 20000, "samplers": [{"input": 0, "output": 0}]}]),
               "bake {} --size 16 -o out.glb --pose walk", code=1)
    # What is asked for is six million triangles.
    yield Case("large-instances.gltf", gltf(count, circle, fan, nodes=[{"mesh": 0}] * 200), unshared, seconds=60, mebibytes=3000)


def tree(depth, leaf):
    return leaf() if depth == 0 else {"node": "add", "a": tree(depth - 1, leaf), "b": tree(depth - 1, leaf)}


def recipe(node, **more):
    stops = [[0, "#000000"], [1, "#ffffff"]]
    return json.dumps({"burl": 1, "texture": {"node": "color_map", "stops": stops, "input": node}} | more)


def doubled(steps, reference):
    """Definitions of which each uses the one before twice."""
    return {"n0": {"node": "fbm"}} | {f"n{i}": {"node": "add", "a": reference(i - 1, 1.1), "b": reference(i - 1, 1.2)} for i in range(1, steps + 1)}


def recipe_cases():
    bake = "bake sample:cube --recipe {} --size 16 -o out.png"
    warps = fbm = {"node": "fbm", "octaves": 8}
    for _ in range(60): warps = {"node": "warp", "strength": 0.1, "input": warps}
    number = iter(range(1, 1 << 20))
    def distinct(): return {"node": "transform", "scale": [1 + next(number) * .01, 1, 1], "input": {"node": "fbm", "octaves": 16}}
    yield Case("warps.burl.json", recipe(warps), bake, often=True)
    yield Case("tree.burl.json", recipe(tree(12, lambda: fbm)), bake, code=3)
    yield Case("octaves.burl.json", recipe(tree(7, distinct)), bake)
    yield Case("octaves-gl.burl.json", recipe(tree(7, distinct)), bake + " --synth gl", often=True, code=5)
    yield Case("shared.burl.json", recipe("n24", define=doubled(24, lambda i, _: f"n{i}")), bake, often=True)
    yield Case("turned.burl.json", recipe("n24", define=doubled(24, lambda i, s: {"node": "transform", "scale": [s, 1, 1], "input": f"n{i}"})),
               bake, often=True, code=3)
    yield Case("samples.burl.json", recipe(tree(8, lambda: fbm)), bake + " --filter supersample:1000")
    yield Case("strokes.burl.json", json.dumps({"burl": 1, "paint": [{"points": [[i % 7, i % 5, i % 3]] * 3, "radius": 1} for i in range(9000)]}), bake)
    yield Case("keys.burl.json", json.dumps({"burl": 1, "animation": {"tracks": [
        {"path": "solid.scale", "keys": [[i * .01, 1 + i % 3] for i in range(20000)]}]}}), bake)
    yield Case("deep.burl.json", '{"burl":1,"texture":' + '{"node":"add","a":' * 20000 + "1" + "}" * 20001, bake, often=True, code=3)


def image_cases():
    bake = "bake sample:cube --recipe {} --size 16 -o out.png"
    def image(name, *picture, command=bake, **more):
        data = png(*picture)
        return Case(name + ".burl.json", json.dumps({"burl": 1, "texture": {"node": "image", "file": name + ".png"}}), command,
                    beside=[(name + ".png", data)], **more)
    yield image("rgb", 8192, 8192, 2)
    yield image("palette", 8192, 8192, 3)
    yield image("rgb16", 8192, 8192, 2, 16)
    yield image("transparent", 8192, 8192, 6)
    yield image("odd", 8191, 8191, 0)
    yield image("odd-transparent", 8191, 8191, 6, often=True)
    filtered = bake + " --filter trapezoid"
    yield image("rgb-filtered", 8192, 8192, 2, command=filtered)
    yield image("transparent-filtered", 8192, 8192, 6, command=filtered)
    yield image("odd-filtered", 8191, 8191, 2, command=filtered)
    yield image("odd-transparent-filtered", 8191, 8191, 6, command=filtered, seconds=3)
    yield Case("render.obj", "mtllib render.mtl\n" + CORNERS + "vt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n",
               "render {} --size 16x16 -o out.png", seconds=12, mebibytes=2048,
               beside=[("render.mtl", b"newmtl a\nmap_Kd render.png\n"), ("render.png", png(16384, 16384, 0))])


def other_cases():
    bakes = [{"mesh": "sample:cube", "size": 16, "output": f"o{i}.png"} for i in range(15000)]
    yield Case("bakes.json", json.dumps({"bakes": bakes}), "batch {} --dry-run", seconds=15)
    lists = {"size": list(range(1, 11)), "rotate": list(range(10)), "seconds": list(range(1, 11)), "fps": list(range(1, 56))}
    wrong = {"mesh": "sample:cube", "output": "a.png", "sise": 1} | lists
    yield Case("wrong.json", json.dumps({"bakes": [wrong]}), "batch {} --dry-run", often=True, code=3)
    yield Case("points.csv", "0.1,0.2,0.3\n" * 80000, "eval marble --points {}")
    yield Case("nodes.mtlx", '<?xml version="1.0"?><materialx version="1.38">' + "".join(
        f'<add name="a{i}" type="float"><input name="in1" type="float" nodename="a{i - 1}"/>'
        f'<input name="in2" type="float" nodename="a{i - 1}"/></add>' for i in range(1, 7000)) + "</materialx>", "show {}", often=True, code=3)


YARDSTICK = "bake sample:torus --recipe marble --size 512 --filter supersample:100 --threads 1 -o yardstick.png --force --quiet"
YARDSTICK_SECONDS = .69  # of the processor that the limits were measured on


def measure(burl, words, late):
    """Runs burl, for at most so many seconds. Returns its exit code, the processor's seconds, the most MiB and what it said."""
    with open(burl.folder / "err.txt", "w+", errors="backslashreplace") as err:
        child = subprocess.Popen([burl.program, *words], cwd=burl.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=err)
        timer = threading.Timer(late, child.kill)
        timer.start()
        _, status, used = os.wait4(child.pid, 0)
        timer.cancel()
        err.seek(0)
        return os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime, used.ru_maxrss // 1024, err.read()


def slowness(burl):
    """How many times slower this machine is, now, than the one whose seconds are the limits; at least 1, at most 4."""
    code, seconds, _, said = measure(burl, YARDSTICK.split(), 60)
    if code: sys.exit(f"{YARDSTICK}: {said}")
    return min(max(seconds / YARDSTICK_SECONDS, 1), 4)


def problem(case, burl, slower):
    """What is wrong about a case's run on a machine that is so many times slower than that of the limits."""
    for name, data in [(case.name, case.data.encode() if isinstance(case.data, str) else case.data), *case.beside]:
        (burl.folder / name).write_bytes(data)
    words = [word.replace("{}", case.name) for word in case.command.split()]
    for output in burl.folder.glob("out.*"): output.unlink()
    words += {"bake": ["--force", "--quiet"], "batch": ["--quiet"]}.get(words[0], [])
    code, seconds, mebibytes, said = measure(burl, words, 100 * case.seconds)
    print(f"{words[0]} {case.name} {' '.join(words[2:])}: exit code {code}, {seconds:.2f} s, {mebibytes} MiB", flush=True)
    if code != case.code: return f"exit code {code} instead of {case.code}: {said}"
    if "-o" in words and (burl.folder / words[words.index("-o") + 1]).exists() != (code == 0): return "an output is missing, or left over"
    if mebibytes > case.mebibytes: return f"{mebibytes} MiB"
    if seconds > slower * case.seconds: return f"{seconds:.2f} s on a machine that is {slower:.1f} times slower"
    return sentence_problem(said) if code else ""


def main():
    burl, report = Burl(*sys.argv[1:4]), Report()
    slower = slowness(burl)
    print(f"{slower:.2f} times slower than the machine of the limits")
    for cases in (obj_cases, odd_cases, other_mesh_cases, gltf_cases, recipe_cases, image_cases, other_cases):
        for case in cases():
            if EVERY or case.often: report.add(f"{case.name}: {case.command}", problem(case, burl, slower))
    return report.end("small")


sys.exit(main())
