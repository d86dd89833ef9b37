# Draws .glb files with Blender's path tracer under an environment map, as another program shows what we export:
#   blender --background --python-exit-code 1 --python cycles.py -- ENVIRONMENT.hdr AZIMUTH,ELEVATION,DISTANCE SIDE SAMPLES BOUNCES FILE.glb...
# writes FILE.cycles.png beside each: linear light clipped and encoded to sRGB, over the grey of `burl render`, which also pixels
# of the outline have. Camera as `burl render` has it (docs/reference/rendering.md).
import math
import os
import sys

import numpy

numpy.bool = bool  # Debian 12: Blender's importer uses a name that numpy dropped

import bpy
from mathutils import Vector

environment, view, side, samples, bounces, *files = sys.argv[sys.argv.index("--") + 1 :]
azimuth, elevation, distance = (float(x) for x in view.split(","))
side = int(side)


def empty_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = int(samples)
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.sample_clamp_indirect = 0
    scene.cycles.max_bounces = int(bounces)
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0
    scene.render.film_transparent = True
    scene.render.resolution_x = scene.render.resolution_y = side
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGBA"
    return scene


def light(scene):
    scene.world = bpy.data.worlds.new("environment")
    scene.world.use_nodes = True
    nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(os.path.abspath(environment))
    links.new(picture.outputs["Color"], nodes["Background"].inputs["Color"])


def sphere_of(scene):
    points = []
    for thing in scene.objects:
        if thing.type == "MESH":
            points += [thing.matrix_world @ vertex.co for vertex in thing.data.vertices]
    points = numpy.array(points)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return Vector(centre), float(numpy.linalg.norm(points - centre, axis=1).max())


def aim(scene):
    centre, radius = sphere_of(scene)
    a, e = math.radians(azimuth), math.radians(elevation)
    # glTF's (x, y, z) is Blender's (x, -z, y).
    towards = Vector((math.cos(e) * math.sin(a), -math.cos(e) * math.cos(a), math.sin(e)))
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(35)
    camera.clip_start, camera.clip_end = 1e-3 * radius, 1e3 * radius
    scene.camera = bpy.data.objects.new("camera", camera)
    scene.collection.objects.link(scene.camera)
    scene.camera.location = centre + distance * radius * towards
    scene.camera.rotation_euler = (-towards).to_track_quat("-Z", "Y").to_euler()


def write_png(linear, path):
    c = numpy.clip(linear[:, :3], 0, 1)
    codes = numpy.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)
    codes[linear[:, 3] < 1] = 176 / 255
    picture = bpy.data.images.new("picture", side, side)
    picture.pixels[:] = numpy.column_stack([codes, numpy.ones(len(codes))]).astype(numpy.float32).ravel()
    picture.filepath_raw, picture.file_format = path, "PNG"
    picture.save()


for file in files:
    scene = empty_scene()
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(file))
    light(scene)
    aim(scene)
    out = file[: -len(".glb")] + ".cycles"
    scene.render.filepath = os.path.abspath(out + ".exr")
    bpy.ops.render.render(write_still=True)
    drawn = bpy.data.images.load(os.path.abspath(out + ".exr"))
    linear = numpy.array(drawn.pixels[:]).reshape(-1, 4)
    os.remove(out + ".exr")
    write_png(linear, os.path.abspath(out + ".png"))
