# Imports a model into Blender and prints what it found as JSON.
import json
import sys

import bpy
import numpy
from mathutils import Vector

numpy.bool = bool  # Blender 3.4's importer still uses the alias that NumPy 1.24 dropped

path = sys.argv[sys.argv.index("--") + 1]
bpy.ops.wm.read_factory_settings(use_empty=True)
if path.endswith((".glb", ".gltf")):
    bpy.ops.import_scene.gltf(filepath=path)
elif path.endswith(".fbx"):
    bpy.ops.import_scene.fbx(filepath=path)
elif path.endswith(".dae"):
    bpy.ops.wm.collada_import(filepath=path)
elif hasattr(bpy.ops.wm, "obj_import"):
    bpy.ops.wm.obj_import(filepath=path)
else:
    bpy.ops.import_scene.obj(filepath=path)
meshes = [o for o in bpy.data.objects if o.type == "MESH"]
corners = [o.matrix_world @ Vector(c) for o in meshes for c in o.bound_box]
print("STATS " + json.dumps({
    "triangles": sum(len(o.data.polygons) for o in meshes),
    "objects": sorted(o.name for o in meshes),
    "materials": sorted({m.name for o in meshes for m in o.data.materials}),
    "images": sorted(list(i.size) for i in bpy.data.images if i.size[0] > 0),
    "without_uv": sum(1 for o in meshes if not o.data.uv_layers),
    "min": [min(c[i] for c in corners) for i in range(3)],
    "max": [max(c[i] for c in corners) for i in range(3)],
}))
