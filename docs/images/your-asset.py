# A leg with an armature, an animation, two materials and UVs, as a glTF: blender -b --python your-asset.py -- OUT.glb
import sys

import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.mesh.primitive_cylinder_add(vertices=48, depth=4, location=(0, 0, 2))
leg = bpy.context.object
leg.name = 'Leg'
bpy.ops.object.mode_set(mode='EDIT')
bpy.ops.mesh.select_all(action='SELECT')
bpy.ops.mesh.subdivide(number_cuts=8)
bpy.ops.uv.smart_project()
bpy.ops.object.mode_set(mode='OBJECT')
bpy.ops.object.shade_smooth()
leg.data.use_auto_smooth = True
for name in ('Wood leg', 'Metal foot'):
    leg.data.materials.append(bpy.data.materials.new(name))
for polygon in leg.data.polygons:
    polygon.material_index = 1 if polygon.center.z < -1 else 0

armature = bpy.data.armatures.new('Rig')
rig = bpy.data.objects.new('Rig', armature)
bpy.context.collection.objects.link(rig)
bpy.context.view_layer.objects.active = rig
bpy.ops.object.mode_set(mode='EDIT')
lower, upper = armature.edit_bones.new('lower'), armature.edit_bones.new('upper')
lower.head, lower.tail = (0, 0, 0), (0, 0, 2)
upper.head, upper.tail, upper.parent = (0, 0, 2), (0, 0, 4), lower
bpy.ops.object.mode_set(mode='OBJECT')
leg.select_set(True)
rig.select_set(True)
bpy.context.view_layer.objects.active = rig
bpy.ops.object.parent_set(type='ARMATURE_AUTO')
bone = rig.pose.bones['upper']
bone.rotation_mode = 'QUATERNION'
for frame, turn in ((1, (1, 0, 0, 0)), (20, (0.92, 0.38, 0, 0)), (40, (1, 0, 0, 0))):
    bone.rotation_quaternion = turn
    bone.keyframe_insert('rotation_quaternion', frame=frame)
bpy.ops.export_scene.gltf(filepath=sys.argv[sys.argv.index('--') + 1])
