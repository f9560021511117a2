"""Where the program and its presets are."""

import os
import shutil

import bpy


class StromarPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: bpy.props.StringProperty(name="stromar-cli", description="The program; without a folder it is looked for in the search path",
                                      default="stromar-cli", subtype="FILE_PATH")
    presets: bpy.props.StringProperty(name="Presets", description="A folder of .tree files; empty: those that come with the program", subtype="DIR_PATH")

    def draw(self, context):
        self.layout.prop(self, "program")
        self.layout.prop(self, "presets")


def of_user():
    addon = bpy.context.preferences.addons.get(__package__)
    return addon.preferences if addon else None


def program():
    """The path of stromar-cli, or None."""
    wanted = of_user().program if of_user() else "stromar-cli"
    return shutil.which(bpy.path.abspath(wanted) if os.sep in wanted else wanted)


def presets_folder():
    chosen = of_user().presets if of_user() else ""
    if chosen:
        return bpy.path.abspath(chosen)
    data = os.environ.get("STROMAR_DATA")
    if data:
        return os.path.join(data, "presets")
    found = program()
    return os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(found))), "share", "stromar", "presets") if found else ""


def register():
    bpy.utils.register_class(StromarPreferences)


def unregister():
    bpy.utils.unregister_class(StromarPreferences)
