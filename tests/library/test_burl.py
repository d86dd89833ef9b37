"""The Python package, held to the program, to numpy and to formulas."""
import __future__
import gc
import inspect
import json
import os
import signal
import subprocess
import sys
import threading
import time

import burl
import numpy as np
import pytest

PROGRAM = os.environ["BURL_PROGRAM"]
POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


@pytest.fixture(scope="module")
def torus():
    return burl.Mesh.read("sample:torus")


def test_a_mesh_of_arrays_has_their_triangles():
    mesh = burl.Mesh(POINTS, FACES, name="corner")
    assert mesh.name == "corner" and mesh.uvs is None
    assert mesh.positions.shape == (4, 3) and mesh.triangles.shape == (4, 3)
    assert mesh.positions.dtype == np.float64 and mesh.triangles.dtype == np.uint32
    np.testing.assert_array_equal(mesh.positions[mesh.triangles], POINTS[FACES])
    uvs = np.arange(24.0).reshape(4, 3, 2)
    np.testing.assert_array_equal(burl.Mesh(POINTS, FACES, uvs).uvs, uvs)


def test_arrays_are_views_that_keep_their_owner(torus):
    mesh = burl.Mesh.read("sample:torus")
    points = mesh.positions
    assert points.base is mesh and not points.flags.writeable
    assert np.shares_memory(points, mesh.positions)
    with pytest.raises(ValueError):
        points[0, 0] = 1
    baked = burl.bake(torus, "marble", size=64)
    color = baked["color"]
    assert np.shares_memory(color, baked.image("color"))
    copy = color.copy()
    del baked, mesh
    gc.collect()
    burl.bake(torus, "oak", size=64)  # would use the memory, were it free
    np.testing.assert_array_equal(color, copy)
    assert points.shape[1] == 3 and np.isfinite(points).all()


@pytest.mark.parametrize(
    "positions, triangles, uvs, sentence",
    [
        (POINTS[:, :2], FACES, None, "positions: has shape (4, 2), and must have shape (n, 3)"),
        (POINTS[0], FACES, None, "positions: has shape (3,), and must have shape (n, 3)"),
        (POINTS, FACES.T[:2], None, "triangles: has shape (2, 4), and must have shape (n, 3)"),
        (POINTS, -FACES, None, "triangles: has -2, which is no number of a point"),
        (POINTS, FACES, np.zeros((4, 2)), "uvs: has shape (4, 2), and must have shape (4, 3, 2)"),
    ],
)
def test_a_wrong_shape_gets_a_sentence(positions, triangles, uvs, sentence):
    with pytest.raises(ValueError) as caught:
        burl.Mesh(positions, triangles, uvs)
    assert str(caught.value) == sentence


def test_a_wrong_type_gets_a_sentence():
    with pytest.raises(TypeError) as caught:
        burl.Mesh(POINTS, FACES.astype(float))
    assert str(caught.value) == "triangles: has float64, and must have whole numbers"
    with pytest.raises(TypeError):
        burl.Mesh("points", FACES)
    with pytest.raises(ValueError) as caught:
        burl.evaluate("oak", np.zeros((5, 2)))
    assert str(caught.value) == "points: has shape (5, 2), and must have shape (n, 3)"


@pytest.mark.parametrize(
    "work, sentence",
    [
        (lambda: burl.bake(3, "oak"), "mesh: is of type int, and must be a path, a sample or a burl.Mesh"),
        (lambda: burl.bake(POINTS, "oak"), "mesh: is of type ndarray, and must be a path, a sample or a burl.Mesh"),
        (lambda: burl.bake("sample:cube", None), "recipe: is of type NoneType, and must be a name, a path or a burl.Recipe"),
        (lambda: burl.evaluate("oak", POINTS, mesh=3), "mesh: is of type int, and must be a path, a sample or a burl.Mesh"),
        (lambda: burl.metrics("sample:cube", 3), "recipe: is of type int, and must be a name, a path or a burl.Recipe"),
        (lambda: burl.Mesh.read(b"cube.obj"), "path: is of type bytes, and must be a path or a sample"),
        (lambda: burl.Recipe.load(3), "path_or_preset: is of type int, and must be a name or a path"),
        (lambda: burl.bake("sample:cube", "oak", size=32).write(3), "path: is of type int, and must be a path"),
    ],
)
def test_what_is_no_path_gets_a_sentence(work, sentence):
    with pytest.raises(TypeError) as caught:
        work()
    assert str(caught.value) == sentence


def test_paths_may_be_those_of_pathlib(tmp_path):
    recipe = tmp_path / "my oak.json"
    recipe.write_text(burl.Recipe.load("oak").to_json())
    baked = burl.bake("sample:cube", recipe, size=32)
    baked.write(tmp_path / "c\u00fcbe.obj")
    assert burl.Mesh.read(tmp_path / "c\u00fcbe.obj").triangles.shape == (12, 3)
    again = burl.bake(tmp_path / "c\u00fcbe.obj", burl.Recipe.load(recipe), size=32)
    assert again.image("color").shape == (32, 32, 3)


@pytest.mark.parametrize(
    "work, kind, word",
    [
        (lambda: burl.Mesh(POINTS, FACES + 1), "usage", "points 0 to 3"),
        (lambda: burl.Mesh.read("/nowhere.obj"), "io", "/nowhere.obj"),
        (lambda: burl.Recipe.load("no-such-wood"), "usage", "no-such-wood"),
        (lambda: burl.Recipe.parse("{"), "invalid_file", "recipe:1"),
        (lambda: burl.bake("sample:cube", "oak", depth=9), "usage", "depth 9"),
        (lambda: burl.bake("sample:cube", "oak", size=64)["colour"], "usage", "color"),
    ],
)
def test_errors_have_kinds(work, kind, word):
    with pytest.raises(burl.Error) as caught:
        work()
    assert caught.value.kind == kind and word in str(caught.value)


def test_files_are_the_programs(torus, tmp_path):
    baked = burl.bake(torus, "oak", size=128, levels=-1)
    assert baked.write(str(tmp_path / "ours.glb")) == []
    theirs = tmp_path / "theirs.glb"
    subprocess.run([PROGRAM, "bake", "sample:torus", "--recipe", "oak", "--size", "128", "--levels", "all", "-o", theirs, "--quiet"], check=True)
    assert (tmp_path / "ours.glb").read_bytes() == theirs.read_bytes()


def test_images_have_the_types_asked_for(torus):
    for depth, dtype in ((8, np.uint8), (16, np.uint16), (32, np.float32)):
        baked = burl.bake(torus, "oak", size=64, depth=depth, packing="separate")
        assert baked.names[0] == "color" and "roughness" in baked.names
        assert baked["color"].shape == (64, 64, 3) and baked["color"].dtype == dtype
        assert baked["roughness"].shape == (64, 64)
        assert baked.is_srgb("color") == (depth != 32) and not baked.is_srgb("roughness")
    codes = burl.bake(torus, "oak", size=64, depth=16, packing="separate")["roughness"]
    assert np.abs(codes / 65535 - baked["roughness"]).max() < 1e-5
    assert burl.bake(torus, "oak", size=64)["orm"].shape == (64, 64, 3)


def test_levels_are_means(torus):
    baked = burl.bake(torus, "marble", size=64, depth=32, levels=-1, atlas="quad")
    assert baked.level_count("color") == 7
    fine, coarse = baked["color"], baked.image("color", 1)
    means = fine.reshape(32, 2, 32, 2, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(coarse, means, atol=1e-6)


def test_texels_show_what_evaluate_says(torus):
    # A triangle's corners lie in the texture where uvs say: the middle of its texels shows its middle.
    recipe = burl.Recipe.load("marble").set("filter.kind", "none").set("solid.space", "object")
    baked = burl.bake(torus, recipe, size=1024, depth=32, atlas="area")
    image = baked["color"]
    middles = baked.uvs.mean(axis=1) * 1024
    column, row = np.floor(middles).astype(int).T
    # The point of a texel's centre, by the map of the triangle's corners.
    corners = baked.uvs * 1024
    edges = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
    offset = np.stack([column + 0.5, row + 0.5], axis=1) - corners[:, 0]
    weights = np.linalg.solve(edges, offset[:, :, None])[:, :, 0]
    p = baked.positions[baked.triangles]
    points = p[:, 0] + weights[:, :1] * (p[:, 1] - p[:, 0]) + weights[:, 1:] * (p[:, 2] - p[:, 0])
    inside = (weights.min(axis=1) > 0) & (weights.sum(axis=1) < 1)
    assert inside.sum() > 500
    expected = burl.evaluate(recipe, points).colors
    np.testing.assert_allclose(image[row, column][inside], expected[inside], atol=1e-4)


def test_evaluate_gives_derivatives():
    points = np.random.default_rng(1).uniform(-1, 1, (200, 3))
    at = burl.evaluate("marble", points)
    assert at.values.shape == (200,) and at.gradients.shape == (200, 3) and at.colors.shape == (200, 3)
    h = 1e-5
    for axis in range(3):
        step = np.eye(3)[axis] * h
        slope = (burl.evaluate("marble", points + step).values - burl.evaluate("marble", points - step).values) / (2 * h)
        np.testing.assert_allclose(at.gradients[:, axis], slope, atol=1e-4 * np.abs(slope).max())
    assert at.colors.base is not None and not at.colors.flags.writeable
    assert burl.evaluate("marble", np.zeros((0, 3))).values.shape == (0,)


def test_metrics_are_the_programs(torus):
    ours = burl.metrics(torus, "marble", atlas="quad", size=64)
    text = subprocess.run([PROGRAM, "metrics", "sample:torus", "--atlas", "quad", "--size", "64", "--json"], check=True, capture_output=True).stdout
    assert ours == json.loads(text)


def test_progress_is_told_and_may_stop(torus):
    told = []
    burl.bake(torus, "oak", size=2048, threads=1, progress=told.append)
    assert told[-1] == ("done", 1.0, None, 0.0)
    assert [state.share for state in told] == sorted(state.share for state in told)
    stages = list(dict.fromkeys(state.stage for state in told))
    assert stages.index("synthesising the texture") < stages.index("deriving normals")
    assert any(state.texels_per_second and state.seconds_left for state in told)
    with pytest.raises(burl.Error) as caught:
        burl.bake(torus, "marble", size=64, progress=lambda state: False)
    assert caught.value.kind == "stopped"
    with pytest.raises(ZeroDivisionError):
        burl.bake(torus, "marble", size=64, progress=lambda state: 1 / 0)


def test_other_threads_run_during_a_bake(torus):
    count, done = 0, False

    def work():
        nonlocal count
        while not done:
            count += 1
            time.sleep(0.001)

    thread = threading.Thread(target=work)
    thread.start()
    start = count
    burl.bake(torus, "wood", size=2048, threads=1)
    ran = count - start
    done = True
    thread.join()
    assert ran > 20


@pytest.mark.parametrize("recipe", ["wood", "oak"])  # a texture alone, and a material
@pytest.mark.parametrize("after", [0.2, 0.8])
def test_ctrl_c_stops_a_bake(recipe, after):
    code = f"import burl; print('ready', flush=True); burl.bake('sample:torus', '{recipe}', size=8192, threads=1)"
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout.readline() == b"ready\n"
    time.sleep(after)
    start = time.monotonic()
    process.send_signal(signal.SIGINT)
    error = process.communicate(timeout=60)[1].decode()
    took = time.monotonic() - start
    assert process.returncode in (-signal.SIGINT, 130) and "KeyboardInterrupt" in error
    assert took < 3, took


WORK = {
    "read": "burl.Mesh.read(sys.argv[1])",
    "evaluate": "burl.evaluate('oak', np.random.default_rng(1).random((4_000_000, 3)))",
    "evaluate a mesh's": "burl.evaluate('oak', np.random.default_rng(1).random((400_000, 3)), mesh='sample:torus')",
    "measure": "burl.metrics('sample:bust', 'oak', atlas='all', size=2048, lookups=True)",
}


@pytest.fixture(scope="module")
def large_mesh(tmp_path_factory):
    """A file that takes seconds to read."""
    path = tmp_path_factory.mktemp("large") / "large.obj"
    side = 1500
    with open(path, "w") as file:
        for i in range(side):
            file.write("".join(f"v {i} {j} {i * j % 7}\n" for j in range(1, side + 1)))
        for i in range(side - 1):
            at = i * side
            file.write("".join(f"f {at + j} {at + j + 1} {at + side + j}\n" for j in range(1, side)))
    return path


@pytest.mark.parametrize("work", WORK)
@pytest.mark.parametrize("after", [0.1, 0.6])
def test_ctrl_c_stops_all_long_work(work, after, large_mesh):
    code = f"import sys, burl, numpy as np; print('ready', flush=True); {WORK[work]}; print('whole')"
    process = subprocess.Popen([sys.executable, "-c", code, str(large_mesh)], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout.readline() == b"ready\n"
    time.sleep(after)
    start = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, error = process.communicate(timeout=60)
    took = time.monotonic() - start
    assert b"KeyboardInterrupt" in error and out == b"", (out, error)
    assert took < 3, took  # a loaded machine; docs/lab/library.md has what an idle one takes


def test_progress_of_other_work_is_told(torus):
    told = []
    burl.evaluate("oak", np.zeros((100_000, 3)), progress=told.append)
    assert told[-1].stage == "done" and {state.stage for state in told} >= {"evaluating the recipe"}
    told.clear()
    burl.metrics("sample:bust", "marble", atlas="patch", size=256, progress=told.append)
    assert {state.stage for state in told} >= {"laying out the atlas", "measuring the atlas", "done"}
    with pytest.raises(burl.Error) as caught:
        burl.metrics(torus, "marble", atlas="quad", size=256, lookups=True, progress=lambda state: False)
    assert caught.value.kind == "stopped"


def test_recipes_change():
    oak = burl.Recipe.load("oak")
    assert oak.name == "Oak" and "oak" in burl.Recipe.names()
    assert json.loads(oak.set("atlas.size", 48).to_json())["atlas"]["size"] == 48
    assert burl.bake("sample:cube", oak.set("atlas.size", 48))["color"].shape[:2] == (48, 48)
    assert burl.version() == burl.__version__


def test_the_stubs_name_everything():
    path = os.path.join(os.path.dirname(burl.__file__), "__init__.pyi")
    stubs = {}
    with open(path) as file:
        exec(compile(file.read(), path, "exec", __future__.annotations.compiler_flag), stubs)
    for name in burl.__all__:
        assert name in stubs, name
    for name in ("Mesh", "Recipe", "Baked"):
        public = {key for key in vars(getattr(burl, name)) if not key.startswith("_")}
        assert public == {key for key in vars(stubs[name]) if not key.startswith("_")}, name
    options = list(inspect.signature(stubs["bake"]).parameters)
    assert all(f"{option}:" in burl.bake.__doc__ for option in options)
