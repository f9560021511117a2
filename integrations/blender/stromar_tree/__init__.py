"""Add > Mesh > Stromar Tree: calls stromar-cli and makes meshes of what it writes."""

bl_info = {
    "name": "Stromar Tree",
    "author": "Stromar",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Add > Mesh > Stromar Tree; sidebar of the 3D view, tab Stromar",
    "description": "Trees of Stromar as meshes, with levels of detail",
    "category": "Add Mesh",
}

from . import operators, panel, preferences

MODULES = (preferences, operators, panel)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
