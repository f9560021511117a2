"""Add > Mesh > Stromar Tree, and to grow a tree again where it stands."""

import os
import subprocess
import tempfile
from contextlib import contextmanager

import bpy

from . import build, model, preferences

KEY = "stromar"  # of the settings that the root of a tree keeps
MONTHS = ("January", "February", "March", "April", "May", "June", "July", "August", "September", "October", "November", "December")
OVERRIDES = (  # parameter, name, help, smallest, largest useful value; 0: as the preset has it
    ("Scale", "Height", "Metres", 0.1, 60),
    ("1Branches", "Branches", "On the trunk", 1, 200),
    ("1Length", "Branch length", "As a part of the trunk's", 0.05, 2),
    ("1DownAngle", "Branch angle", "Degrees from the trunk", 1, 180),
    ("Leaves", "Leaves", "On each stem that bears some", 1, 200),
    ("LeafScale", "Leaf size", "Metres", 0.01, 1),
)
_items = []  # Blender does not keep the texts of an enumeration alive


def preset_items(self, context):
    folder = preferences.presets_folder()
    names = sorted(name for name in os.listdir(folder) if name.endswith(".tree")) if os.path.isdir(folder) else []
    _items[:] = [(name, name[:-5].replace("_", " ").capitalize(), "") for name in names] or [("NONE", "No presets found", "Choose a file, or set the folder in the preferences")]
    return _items


def settings_of(operator):
    values = {"preset": operator.preset, "file": operator.file, "seed": operator.seed, "age": operator.age, "month": int(operator.month),
              "levels": operator.levels}
    for key, *_ in OVERRIDES:
        values[key] = getattr(operator, "value_" + key)
    return values


class GrowError(Exception):
    """What the user should read."""


def tree_file(settings):
    path = bpy.path.abspath(settings["file"]) if settings["file"] else os.path.join(preferences.presets_folder(), settings["preset"])
    if not os.path.isfile(path):
        raise GrowError("there is no file %s" % path)
    return path


@contextmanager
def grown(settings):
    """The models of a tree, the finest first, while their pictures are there."""
    program = preferences.program()
    if not program:
        raise GrowError("stromar-cli is not found; set its path in the preferences of the add-on")
    command = [program, "export", tree_file(settings), "--quiet", "--seed", str(settings["seed"]), "--age", repr(settings["age"]),
               "--lods", "file-each" if settings["levels"] else "none"]
    if settings["month"]:
        command += ["--set", "Season=%d" % settings["month"]]
    for key, *_ in OVERRIDES:
        if settings[key]:
            command += ["--set", "%s=%s" % (key, settings[key] if isinstance(settings[key], int) else round(settings[key], 6))]
    with tempfile.TemporaryDirectory() as folder:
        target = os.path.join(folder, "tree.gltf")
        try:
            run = subprocess.run(command + ["-o", target], capture_output=True, text=True, timeout=600)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise GrowError(str(error)) from error
        if run.returncode != 0:
            raise GrowError(run.stderr.strip() or "stromar-cli failed")
        files = [os.path.join(folder, "tree_LOD%d.gltf" % lod) for lod in range(4)] if settings["levels"] else [target]
        yield [model.read(file) for file in files]


def regrow(root, settings):
    """Makes the objects of a tree anew; where it stands stays. What fails leaves them as they were."""
    with grown(settings) as models:
        build.fill(root.users_collection[0], root, models, root.name)
    root[KEY] = settings


class STROMAR_OT_add(bpy.types.Operator):
    bl_idname = "mesh.stromar_tree"
    bl_label = "Stromar Tree"
    bl_description = "A tree of Stromar"
    bl_options = {"REGISTER", "UNDO"}

    preset: bpy.props.EnumProperty(name="Preset", items=preset_items)
    file: bpy.props.StringProperty(name="File", description="A .tree file instead of a preset", subtype="FILE_PATH")
    seed: bpy.props.IntProperty(name="Seed", default=13, min=0)
    age: bpy.props.FloatProperty(name="Age", description="Of its life", default=1, min=0.01, max=1)
    month: bpy.props.EnumProperty(name="Season", items=[("0", "As in the file", "")] + [(str(i + 1), month, "") for i, month in enumerate(MONTHS)])
    levels: bpy.props.BoolProperty(name="Levels of detail", description="All four, as collections; the finest is shown")

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def execute(self, context):
        title = self.preset[:-5] if not self.file else os.path.splitext(os.path.basename(self.file))[0]
        root = bpy.data.objects.new(title, None)
        collection = bpy.data.collections.new(title)
        context.scene.collection.children.link(collection)
        collection.objects.link(root)
        root.location = context.scene.cursor.location
        try:
            regrow(root, settings_of(self))
        except (GrowError, OSError, ValueError, KeyError) as error:
            bpy.data.objects.remove(root)
            bpy.data.collections.remove(collection)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for one in context.selected_objects:
            one.select_set(False)
        root.select_set(True)
        context.view_layer.objects.active = root
        return {"FINISHED"}


for _key, _name, _help, _low, _high in OVERRIDES:
    _kind = bpy.props.IntProperty if _key in ("1Branches", "Leaves") else bpy.props.FloatProperty
    STROMAR_OT_add.__annotations__["value_" + _key] = _kind(name=_name, description=_help + "; 0: as in the file", default=0, min=0, soft_max=_high)


def root_of(one):
    """The root of the tree that an object belongs to, or None."""
    while one and KEY not in one:
        one = one.parent
    return one


class STROMAR_OT_regrow(bpy.types.Operator):
    bl_idname = "object.stromar_regrow"
    bl_label = "Regrow"
    bl_description = "Grows the tree again where it stands"
    bl_options = {"REGISTER", "UNDO"}

    seed: bpy.props.IntProperty(name="Seed", description="-1: the same", default=-1, min=-1)

    @classmethod
    def poll(cls, context):
        return root_of(context.object) is not None

    def execute(self, context):
        root = root_of(context.object)
        settings = dict(root[KEY].to_dict() if hasattr(root[KEY], "to_dict") else root[KEY])
        if self.seed >= 0:
            settings["seed"] = self.seed
        context.view_layer.objects.active = root
        try:
            regrow(root, settings)
        except (GrowError, OSError, ValueError, KeyError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


def add_to_menu(self, context):
    self.layout.operator(STROMAR_OT_add.bl_idname, icon="OUTLINER_OB_FORCE_FIELD")


def register():
    bpy.utils.register_class(STROMAR_OT_add)
    bpy.utils.register_class(STROMAR_OT_regrow)
    bpy.types.VIEW3D_MT_mesh_add.append(add_to_menu)


def unregister():
    bpy.types.VIEW3D_MT_mesh_add.remove(add_to_menu)
    bpy.utils.unregister_class(STROMAR_OT_regrow)
    bpy.utils.unregister_class(STROMAR_OT_add)
