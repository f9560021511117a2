"""The settings of the tree in hand, in the sidebar of the 3D view."""

import bpy

from . import operators


class STROMAR_PT_tree(bpy.types.Panel):
    bl_label = "Stromar Tree"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Stromar"

    @classmethod
    def poll(cls, context):
        return operators.root_of(context.object) is not None

    def draw(self, context):
        root = operators.root_of(context.object)
        column = self.layout.column()
        for key, name in [("seed", "Seed"), ("age", "Age"), ("month", "Month (0: as in the file)")] + [(key, name) for key, name, *_ in operators.OVERRIDES]:
            column.prop(root, '["%s"]["%s"]' % (operators.KEY, key), text=name)
        column.operator(operators.STROMAR_OT_regrow.bl_idname, icon="FILE_REFRESH").seed = -1


def register():
    bpy.utils.register_class(STROMAR_PT_tree)


def unregister():
    bpy.utils.unregister_class(STROMAR_PT_tree)
