"""From a model to objects of Blender: meshes by foreach_set, materials for Cycles and EEVEE."""

import os
from array import array

import bpy

LOD_NAME = "LOD%d"


def picture(path, colour):
    image = bpy.data.images.load(path, check_existing=False)
    image.colorspace_settings.name = "sRGB" if colour else "Non-Color"
    image.pack()  # the file is in a temporary folder
    image.name = os.path.basename(path)
    return image


def make_material(source, tree):
    material = bpy.data.materials.new("%s_%s" % (tree, source.name))
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    surface = nodes["Principled BSDF"]
    specular = surface.inputs.get("Specular IOR Level") or surface.inputs.get("Specular")
    specular.default_value = 0.3

    def texture(use, height):
        node = nodes.new("ShaderNodeTexImage")
        node.image = picture(source.pictures[use], use == "colour")
        node.location = (-700, height)
        return node

    surface.inputs["Base Color"].default_value = source.colour
    surface.inputs["Roughness"].default_value = 0.7 if source.cut_out else 0.9
    if "colour" in source.pictures:
        colour = texture("colour", 300)
        links.new(colour.outputs["Color"], surface.inputs["Base Color"])
        if source.cut_out:
            links.new(colour.outputs["Alpha"], surface.inputs["Alpha"])
            add_light_through(material, colour, surface)
    if "roughness" in source.pictures:
        channels = nodes.new("ShaderNodeSeparateColor")
        channels.location = (-350, 0)
        links.new(texture("roughness", 0).outputs["Color"], channels.inputs["Color"])
        links.new(channels.outputs["Green"], surface.inputs["Roughness"])
    if "normal" in source.pictures:
        bump = nodes.new("ShaderNodeNormalMap")
        bump.location = (-350, -300)
        links.new(texture("normal", -300).outputs["Color"], bump.inputs["Color"])
        links.new(bump.outputs["Normal"], surface.inputs["Normal"])
    if source.cut_out:
        material.use_backface_culling = False
        if hasattr(material, "blend_method"):
            material.blend_method = "CLIP"
            material.alpha_threshold = source.cutoff
        if hasattr(material, "shadow_method"):
            material.shadow_method = "CLIP"
    return material


def add_light_through(material, colour, surface):
    """Leaves against the light are bright: a part of the light is let through in the colour of the picture."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    output = nodes["Material Output"]
    through, opaque, mix, cut = (nodes.new(kind) for kind in
                                 ("ShaderNodeBsdfTranslucent", "ShaderNodeBsdfTransparent", "ShaderNodeMixShader", "ShaderNodeMixShader"))
    for node, place in ((through, (0, -400)), (opaque, (300, -400)), (mix, (300, 0)), (cut, (550, 0))):
        node.location = place
    output.location = (800, 0)
    links.new(colour.outputs["Color"], through.inputs["Color"])
    mix.inputs["Fac"].default_value = 0.35
    surface.inputs["Alpha"].default_value = 1
    for link in list(surface.inputs["Alpha"].links):
        links.remove(link)
    links.new(surface.outputs["BSDF"], mix.inputs[1])
    links.new(through.outputs["BSDF"], mix.inputs[2])
    links.new(colour.outputs["Alpha"], cut.inputs["Fac"])
    links.new(opaque.outputs["BSDF"], cut.inputs[1])
    links.new(mix.outputs["Shader"], cut.inputs[2])
    links.new(cut.outputs["Shader"], output.inputs["Surface"])


def make_mesh(part, name, material):
    mesh = bpy.data.meshes.new(name)
    corners = len(part.indices)
    triangles = corners // 3
    mesh.vertices.add(len(part.positions) // 3)
    mesh.vertices.foreach_set("co", part.positions)
    mesh.loops.add(corners)
    mesh.loops.foreach_set("vertex_index", part.indices)
    mesh.polygons.add(triangles)
    mesh.polygons.foreach_set("loop_start", array("i", range(0, corners, 3)))
    if bpy.app.version < (4, 1, 0):  # later it follows from the starts
        mesh.polygons.foreach_set("loop_total", array("i", (3,)) * triangles)
        mesh.use_auto_smooth = True
    mesh.polygons.foreach_set("use_smooth", array("b", (1,)) * triangles)
    uv = mesh.uv_layers.new(name="UVMap")
    values = array("f", bytes(8 * corners))
    values[0::2] = array("f", (part.uvs[2 * v] for v in part.indices))
    values[1::2] = array("f", (part.uvs[2 * v + 1] for v in part.indices))
    uv.data.foreach_set("uv", values)
    if part.occlusion:
        mesh.attributes.new("occlusion", "FLOAT", "POINT").data.foreach_set("value", part.occlusion)
    mesh.materials.append(material)
    mesh.update(calc_edges=True)
    mesh.normals_split_custom_set_from_vertices([part.normals[i:i + 3] for i in range(0, len(part.normals), 3)])
    return mesh


def forget(collection):
    """The meshes, materials and pictures of a tree that are used nowhere else."""
    for child in list(collection.children):
        forget(child)
        bpy.data.collections.remove(child)
    for one in list(collection.objects):
        if one.type != "MESH":
            continue
        mesh = one.data
        bpy.data.objects.remove(one)
        materials = [material for material in mesh.materials if material]
        if mesh.users == 0:
            bpy.data.meshes.remove(mesh)
        for material in materials:
            if material.users > 0:
                continue
            images = [node.image for node in material.node_tree.nodes if node.type == "TEX_IMAGE" and node.image]
            bpy.data.materials.remove(material)
            for image in images:
                if image.users == 0:
                    bpy.data.images.remove(image)


def fill(collection, root, models, name):
    """The levels of detail as collections in one, all but the finest hidden; objects hang on the root."""
    forget(collection)
    for lod, model in enumerate(models):
        target = collection
        if len(models) > 1:
            target = bpy.data.collections.new("%s_%s" % (name, LOD_NAME % lod))
            collection.children.link(target)
        materials = [make_material(source, name) for source in model.materials]
        for part in model.parts:
            title = "%s_%s" % (name, part.name)
            one = bpy.data.objects.new(title, make_mesh(part, title, materials[part.material]))
            one.parent = root
            target.objects.link(one)
        target.hide_render = target.hide_viewport = lod > 0
        for material in materials:
            if material.users == 0:
                bpy.data.materials.remove(material)
