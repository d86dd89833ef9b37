# The picture of docs/guide/blender.md: a material of procedural nodes, the same baked by the add-on, and oak carved by it.
#   BLENDER_USER_SCRIPTS=EMPTY_FOLDER blender --background --factory-startup --python-exit-code 1 --python blender.py -- ADDON BURL OUT.png
import math
import os
import sys

import bpy
from mathutils import Vector

*arguments, out = sys.argv[sys.argv.index("--") + 1 :]
sys.argv = ["blender", "--", *arguments]
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tests/peers"))
from blender_addon import Tree, install


def monkey(x):
    bpy.ops.mesh.primitive_monkey_add(size=2, location=(x, 0, 0))
    thing = bpy.context.active_object
    thing.rotation_euler = (math.radians(-12), 0, math.radians(18))
    thing.modifiers.new("smooth", "SUBSURF").levels = 2
    bpy.ops.object.modifier_apply(modifier="smooth")
    bpy.ops.object.shade_smooth()
    return thing


def cracked():
    t = Tree("nodes")
    edge = t.node("TexVoronoi", {"Vector": t.object(), "Scale": 3.0}, feature="DISTANCE_TO_EDGE").outputs[0]
    noise = t.node("TexNoise", {"Vector": t.object(), "Scale": 7.0, "Detail": 4.0}).outputs["Fac"]
    colors = t.ramp(edge, [(0.0, (0.03, 0.02, 0.02)), (0.12, (0.5, 0.25, 0.12)), (0.4, (0.75, 0.5, 0.3))])
    t.base(t.mix("MULTIPLY", 0.8, colors, noise))
    t.set(t.surface.inputs["Roughness"], t.ramp(edge, [(0.05, (0.9,) * 3), (0.2, (0.35,) * 3)]))
    height = t.ramp(edge, [(0.0, (0,) * 3), (0.15, (1,) * 3)], "EASE")
    t.set(t.surface.inputs["Normal"], t.node("Bump", {"Height": height, "Distance": 0.04}).outputs[0])
    return t.material


def draw(scene):
    scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 64, False
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"].inputs
    sky[0].default_value, sky[1].default_value = (0.75, 0.8, 0.9, 1), 0.6
    bpy.ops.object.light_add(type="AREA", location=(3, -5, 5))
    lamp = bpy.context.active_object
    lamp.data.energy, lamp.data.size = 700, 3
    lamp.rotation_euler = (-lamp.location).to_track_quat("-Z", "Y").to_euler()
    bpy.ops.object.camera_add(location=(-0.15, -9.5, 1.0))
    scene.camera = bpy.context.active_object
    scene.camera.rotation_euler = (Vector((-0.15, 0, -0.1)) - scene.camera.location).to_track_quat("-Z", "Y").to_euler()
    scene.camera.data.lens = 44
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.filepath = 960, 300, out
    bpy.ops.render.render(write_still=True)


install()
settings = bpy.context.scene.burl
settings.size = 1024
for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
material = cracked()
monkey(-2.6).data.materials.append(material)
monkey(0).data.materials.append(material)
bpy.ops.burl.bake_nodes()
monkey(2.6)
settings.material = "oak"
settings.controls["size"].number = 0.2
bpy.ops.burl.carve()
draw(bpy.context.scene)
