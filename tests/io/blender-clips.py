# Imports a glTF file with bones into Blender and prints what its armature does as JSON.
import json
import sys

import bpy
import numpy

numpy.bool = bool  # Blender 3.4's importer still uses the alias that NumPy 1.24 dropped

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=sys.argv[sys.argv.index("--") + 1])
armature = next(o for o in bpy.data.objects if o.type == "ARMATURE")
skinned = [o for o in bpy.data.objects if o.type == "MESH" and any(m.type == "ARMATURE" for m in o.modifiers)]


def heads():
    bpy.context.view_layer.update()
    return [tuple(armature.matrix_world @ bone.tail) for bone in armature.pose.bones]


actions = {}
for action in bpy.data.actions:
    armature.animation_data_create()
    armature.animation_data.action = action
    first, last = action.frame_range
    at = []
    for frame in (first, (first + last) / 2, last):
        bpy.context.scene.frame_set(int(round(frame)))
        at.append(heads())
    away = lambda a, b: max(sum((x - y) ** 2 for x, y in zip(p, q)) ** 0.5 for p, q in zip(a, b))
    actions[action.name] = {"curves": len(action.fcurves), "moves": away(at[0], at[1]), "closes": away(at[0], at[2])}
print("STATS " + json.dumps({"bones": len(armature.data.bones), "skinned": len(skinned),
                            "groups": max(len(o.vertex_groups) for o in skinned), "actions": actions}))
