"""Run by Blender without a window: blender -b --factory-startup -P test.py -- STROMAR-CLI SOURCE-FOLDER"""

import json
import os
import subprocess
import sys

import bpy

program, source = sys.argv[sys.argv.index("--") + 1:][:2]
os.environ["STROMAR_DATA"] = source
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import stromar_tree  # noqa: E402
from stromar_tree import build, operators, preferences  # noqa: E402

failures = []


def check(true, what):
    if not true:
        failures.append(what)


stromar_tree.register()
preferences.program = lambda: program
bpy.ops.wm.read_factory_settings(use_empty=True)
stromar_tree.unregister()
stromar_tree.register()


def triangles(collection):
    return sum(len(one.data.polygons) for one in collection.all_objects if one.type == "MESH")


def info(*words):
    run = subprocess.run([program, "info", os.path.join(source, "presets", "quaking_aspen.tree"), *words], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


presets = [item[0] for item in operators.preset_items(None, None)]
check("quaking_aspen.tree" in presets, "presets are listed")

bpy.context.scene.cursor.location = (3, 4, 0)
check(bpy.ops.mesh.stromar_tree(preset="quaking_aspen.tree", seed=13) == {"FINISHED"}, "a tree is added")
root = bpy.context.view_layer.objects.active
collection = root.users_collection[0]
check(tuple(root.location) == (3, 4, 0), "it stands at the cursor")
meshes = {one.name: one for one in collection.all_objects if one.type == "MESH"}
check(sorted(meshes) == ["quaking_aspen_branches_1", "quaking_aspen_branches_2", "quaking_aspen_leaves", "quaking_aspen_trunk"], "objects: %s" % sorted(meshes))
bpy.context.view_layer.update()
top = max((one.matrix_world @ vertex.co).z for one in meshes.values() for vertex in one.data.vertices)
bounds = info("--seed", "13").get("bounds")
check(bounds is None or abs(top - bounds["max"][2]) < 1e-3, "its height is the program's: %s, %s" % (top, bounds))
for one in meshes.values():
    mesh = one.data
    check(not mesh.validate(verbose=False), "%s is valid" % one.name)
    check(len(mesh.uv_layers) == 1 and mesh.attributes.get("occlusion"), "%s has UVs and occlusion" % one.name)
    check(all(image.size[0] > 0 and image.packed_file for material in mesh.materials for image in
              [node.image for node in material.node_tree.nodes if node.type == "TEX_IMAGE"]), "%s has its pictures" % one.name)
leaves = meshes["quaking_aspen_leaves"].data.materials[0]
check(leaves.blend_method == "CLIP" if hasattr(leaves, "blend_method") else True, "leaves are cut out in EEVEE")
check("ShaderNodeBsdfTranslucent" in [node.bl_idname for node in leaves.node_tree.nodes], "light comes through leaves")

first = triangles(collection)
pictures, materials = len(bpy.data.images), len(bpy.data.materials)
root.location = (7, 0, 0)
check(bpy.ops.object.stromar_regrow(seed=14) == {"FINISHED"}, "it grows again")
root = bpy.context.view_layer.objects.active
check(tuple(root.location) == (7, 0, 0), "where it stands")
check(triangles(root.users_collection[0]) != first, "another seed is another tree")
check((len(bpy.data.images), len(bpy.data.materials)) == (pictures, materials), "and leaves nothing behind")
check(bpy.ops.object.stromar_regrow(seed=13) == {"FINISHED"} and triangles(root.users_collection[0]) == first, "the same seed is the same tree")

check(bpy.ops.mesh.stromar_tree(preset="quaking_aspen.tree", seed=13, levels=True, age=0.6, month="10", value_Scale=9.0) == {"FINISHED"}, "with levels of detail")
levels = bpy.context.view_layer.objects.active.users_collection[0].children
counts = [triangles(level) for level in levels]
check(len(counts) == 4 and counts == sorted(counts, reverse=True), "four collections, each coarser: %s" % counts)
check([level.hide_render for level in levels] == [False, True, True, True], "the finest is shown")

before = len(bpy.data.objects)
try:
    bpy.ops.mesh.stromar_tree(file="/no/such.tree")
    check(False, "a missing file is an error")
except RuntimeError as error:
    check("no file" in str(error), "which is told: %s" % error)
check(len(bpy.data.objects) == before, "and adds nothing")

print("ADDON " + ("; ".join(failures) if failures else "fine"))
sys.exit(1 if failures else 0)
