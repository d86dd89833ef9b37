#!/usr/bin/env python3
"""Counts the lines of each reader that its first inputs run (docs/lab/fuzzing.md), without any mutation:

    cmake --preset lines -DBURL_TESTS=ON && cmake --build build/lines --target burl_replay
    tests/fuzz/lines.py build/lines [TARGET...]

Of every target the files below are counted, which are its reader and nothing else: what several readers share stands
where most of it is used. Exit code 1 where a target has less than --least percent.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "tests/analysis"))
import lines  # noqa: E402

readers = {
    "obj": "atlas/read/obj.cpp atlas/read/obj_source.cpp atlas/file/text_scanner.cpp atlas/mesh/mesh_builder.cpp"
           " atlas/mesh/polygon.cpp atlas/mesh/weld.cpp",
    "off": "atlas/read/off.cpp",
    "ply": "atlas/read/ply.cpp atlas/read/ply_file.cpp",
    "stl": "atlas/read/stl.cpp",
    "obj-scene": "app/scene/scene_obj.cpp",
    "gltf": "atlas/gltf/*.cpp atlas/read/gltf.cpp atlas/read/pose.cpp app/scene/scene_gltf.cpp app/scene/gltf_*.cpp"
            " app/kept/document.cpp app/kept/references.cpp",
    "recipe": "app/recipe/edit/check.cpp app/recipe/edit/control_check.cpp"
              " app/recipe/edit/images.cpp app/recipe/edit/key_check.cpp"
              " app/recipe/edit/keyed_recipe.cpp app/recipe/edit/leaves.cpp app/recipe/edit/recipe_json.cpp"
              " app/recipe/graph_check.cpp app/recipe/lattice_check.cpp app/recipe/schema_check.cpp app/recipe/spelling.cpp"
              " procedural/graph/json.cpp procedural/model/members.cpp procedural/model/texture_json.cpp",
    "recipe settings": "app/recipe/edit/controls.cpp app/recipe/edit/formula.cpp app/recipe/edit/settings.cpp"
                       " app/recipe/edit/places.cpp app/recipe/presets.cpp",
    "materialx": "app/materialx/*.cpp app/materialx/values/*.cpp",
    "png picture": "app/image/picture_read.cpp",
    "exr": "app/image/exr_read.cpp",
    "hdr": "app/image/hdr_read.cpp app/light/load_environment.cpp",
    "manifest": "app/bake/batch_manifest.cpp app/bake/batch_matrix.cpp",
    "script": "app/editor/session/script.cpp",
    "points": "app/measure/evaluate_points.cpp",
    "record": "app/bake/up_to_date.cpp",
    # Neither levels nor what meshes of thousands of triangles take.
    "soup": "atlas/blocks/layout*.cpp atlas/blocks/pairing.cpp atlas/blocks/quad*.cpp atlas/blocks/strips.cpp"
            " atlas/chart/chord_split.cpp atlas/chart/cor*.cpp atlas/chart/cov*.cpp atlas/chart/l*.cpp atlas/chart/p*.cpp"
            " atlas/chart/r*.cpp atlas/chart/stretch.cpp atlas/gutter/*.cpp atlas/outline/*.cpp atlas/patch/*.cpp"
            " atlas/solid/block.cpp atlas/solid/solid_atlas.cpp atlas/solid/weights.cpp atlas/uv/*.cpp",
}


def files_of(target):
    """Returns the target's files, relative to the checkout."""
    found = [sorted(root.glob(pattern)) for pattern in readers[target].split()]
    if not all(found):
        sys.exit(f"{target}: a pattern of {readers[target]} is no file")
    return [str(path.relative_to(root)) for some in found for path in some]


def objects_of(build, files):
    """Returns the .gcno files of the units that the files are in."""
    wanted = []
    for path in build.rglob("*.gcno"):
        unit = pathlib.Path(str(path).replace(f"CMakeFiles/{path.relative_to(build).parts[2]}/", "")).with_suffix("")
        text = unit.read_text() if unit.is_file() else f'#include "{unit.relative_to(build)}"'
        if any(f'"{name}"' in text or str(unit).endswith(name) for name in files):
            wanted.append(path)
    return sorted(wanted)


def run_first_inputs(build, targets):
    """Runs the targets' first inputs alone, all counts at zero before; returns how many there were."""
    for path in build.rglob("*.gcda"):
        path.unlink()
    inputs = 0
    for target in targets.split():
        with tempfile.TemporaryDirectory() as folder:
            told = subprocess.run([build / "bin/burl_replay", target, "0"], cwd=folder, capture_output=True, text=True)
        if told.returncode:
            sys.exit(f"burl_replay {target} 0: {told.stdout}{told.stderr}")
        inputs += int(told.stdout.split()[0])
    return inputs


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("targets", nargs="*", help="all of them where none is named")
    options.add_argument("--least", type=float, default=90.0, help="percent that each target must have")
    options.add_argument("--idle", action="store_true", help="print the lines that did not run, file by file")
    asked = options.parse_args()
    build, short = asked.build.resolve(), False
    os.environ.pop("GCOV_PREFIX", None)
    for target in asked.targets or readers:
        inputs = run_first_inputs(build, target)
        files = files_of(target)
        counts = lines.counts_of(objects_of(build, files), build, tuple(files))
        if missing := [name for name in files if name not in counts]:
            sys.exit(f"{target}: no counts of {' '.join(missing)}")
        if asked.idle:
            for name in files:
                if idle := lines.ranges(n for n, times in counts[name].items() if times == 0):
                    print(f"    {lines.row(name, counts[name])[3]:6.2f} %  {name}: {idle}")
        every = [times for name in files for times in counts[name].values()]
        run = sum(1 for times in every if times > 0)
        short |= 100.0 * run < asked.least * len(every)
        print(f"{100.0 * run / len(every):6.2f} %  {run:5} of {len(every):5}  {target}, {len(files)} files, {inputs} inputs", flush=True)
    sys.exit(1 if short else 0)


if __name__ == "__main__":
    main()
