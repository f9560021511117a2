"""What stromar-cli writes: a description in JSON and numbers beside it, read without Blender."""

import json
import os
from array import array
from dataclasses import dataclass, field

TYPES = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


@dataclass
class Part:
    """A mesh with one material. Metres, z up; v of the texture coordinates counts upwards."""
    name: str
    material: int
    positions: array  # x y z …
    normals: array
    uvs: array        # u v …
    indices: array    # three per triangle
    occlusion: array  # by vertex, 0 to 1; may be empty


@dataclass
class Material:
    name: str
    cut_out: bool
    cutoff: float
    colour: tuple
    pictures: dict = field(default_factory=dict)  # "colour", "normal", "roughness" → path


@dataclass
class Model:
    parts: list
    materials: list


def z_up(values):
    """Of x y z with y up."""
    turned = array("f", values)
    turned[1::3] = array("f", (-z for z in values[2::3]))
    turned[2::3] = values[1::3]
    return turned


def read(path):
    """A .gltf file as stromar-cli writes it. Raises OSError, ValueError and KeyError for what it is not."""
    folder = os.path.dirname(path)
    with open(path, encoding="utf-8") as file:
        document = json.load(file)
    data = b""
    if document.get("buffers"):
        with open(os.path.join(folder, document["buffers"][0]["uri"]), "rb") as file:
            data = file.read()

    def numbers(index):
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        kind, start = TYPES[accessor["componentType"]], view.get("byteOffset", 0)
        values = array(kind)
        size = accessor["count"] * COMPONENTS[accessor["type"]] * values.itemsize
        values.frombytes(data[start:start + size])
        return values

    def picture(texture):
        if texture is None:
            return None
        return os.path.join(folder, document["images"][document["textures"][texture["index"]]["source"]]["uri"])

    materials = []
    for one in document.get("materials", []):
        surface = one["pbrMetallicRoughness"]
        pictures = {"colour": picture(surface.get("baseColorTexture")), "normal": picture(one.get("normalTexture")),
                    "roughness": picture(surface.get("metallicRoughnessTexture"))}
        materials.append(Material(one["name"], one.get("alphaMode") == "MASK", one.get("alphaCutoff", 0.5),
                                  tuple(surface.get("baseColorFactor", (1, 1, 1, 1))), {use: path for use, path in pictures.items() if path}))
    parts = []
    for mesh in document.get("meshes", []):
        for primitive in mesh["primitives"]:
            attributes = primitive["attributes"]
            uvs = numbers(attributes["TEXCOORD_0"])
            uvs[1::2] = array("f", (1 - v for v in uvs[1::2]))
            occlusion = numbers(attributes["_OCCLUSION"]) if "_OCCLUSION" in attributes else array("f")
            if occlusion.typecode == "B":
                occlusion = array("f", (value / 255 for value in occlusion))
            parts.append(Part(mesh["name"], primitive["material"], z_up(numbers(attributes["POSITION"])), z_up(numbers(attributes["NORMAL"])), uvs,
                              array("I", numbers(primitive["indices"])), occlusion))
    return Model(parts, materials)
