# Pictures of materials by Blender's path tracer, a program that knows of Burl nothing but its .glb files:
#   blender --background --python materials.py -- FOLDER SAMPLES FILE.glb...
# writes FOLDER/NAME.png, the whole object, and FOLDER/NAME-close.png.
import os
import sys

import numpy

numpy.bool = bool  # Debian 12: Blender's importer uses a name that numpy dropped

import bpy
from mathutils import Vector

folder, samples, *files = sys.argv[sys.argv.index("--") + 1 :]
middle = (0, 0, 1.0)
views = {"": ((1.55, -5.0, 1.75), middle, 85), "-close": ((0.8, -2.1, 1.55), (0.05, 0, 1.0), 85)}


def aim(thing, target):
    thing.rotation_euler = (Vector(target) - thing.location).to_track_quat("-Z", "Y").to_euler()


def add(name, data, place, target):
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    thing.location = place
    aim(thing, target)
    return thing


def add_light(name, place, size, power):
    light = bpy.data.lights.new(name, "AREA")
    light.size, light.energy = size, power
    add(name, light, place, middle)


def add_floor():
    bpy.ops.mesh.primitive_plane_add(size=60)
    material = bpy.data.materials.new("floor")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"].inputs
    surface["Base Color"].default_value = (0.25, 0.25, 0.26, 1)
    surface["Roughness"].default_value = 0.8
    bpy.context.object.data.materials.append(material)


def studio():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = int(samples)
    scene.cycles.use_denoising = False  # Debian builds Blender without a denoiser
    scene.cycles.max_bounces = 6
    scene.render.resolution_x, scene.render.resolution_y = 240, 300
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"].inputs
    sky[0].default_value, sky[1].default_value = (0.55, 0.6, 0.68, 1), 0.3
    add_light("key", (2.5, -2.5, 3.5), 1.5, 130)
    add_light("fill", (-3, -2, 1.5), 3, 35)
    add_light("rim", (-1.5, 3, 2.5), 1, 90)
    add_floor()
    return scene


for file in files:
    name = os.path.splitext(os.path.basename(file))[0]
    for suffix, (place, target, lens) in views.items():
        scene = studio()
        bpy.ops.import_scene.gltf(filepath=file)
        camera = bpy.data.cameras.new("camera")
        camera.lens = lens
        scene.camera = add("camera", camera, place, target)
        scene.render.filepath = os.path.join(folder, name + suffix + ".png")
        bpy.ops.render.render(write_still=True)
