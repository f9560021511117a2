# Bends the wood of a glTF file that was exported with --wind attributes, from its vertices and tables alone, and compares with a file of
# the same moment. Written from docs/time-and-wind.md, not from the program. Prints the largest distance of a vertex, and how far the
# vertices have moved from still air.
# Usage: wind-pose.py ATTRIBUTES.glb POSED.glb STRENGTH DEGREES GUSTS SECONDS LOOP
import json
import struct
import sys

import numpy as np


class Glb:
    def __init__(self, path):
        data = open(path, "rb").read()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + size])
        self.buffer = data[20 + size + 8:]

    def view(self, index):
        view = self.json["bufferViews"][index]
        start = view.get("byteOffset", 0)
        return self.buffer[start:start + view["byteLength"]]

    def accessor(self, index):
        accessor = self.json["accessors"][index]
        width = {"VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        return np.frombuffer(self.view(accessor["bufferView"]), np.float32).reshape(accessor["count"], width).astype(float)

    def table(self, name):
        table = self.json["scenes"][0]["extras"]["wind"][name]
        cells = self.view(table["bufferView"])
        width = len(table["columns"])
        columns = {}
        for i, column in enumerate(table["columns"]):
            name, _, kind = column.partition(":")
            columns[name] = np.frombuffer(cells, kind or "float32").reshape(-1, width)[:, i]
        return columns

    def wood(self):
        for mesh in self.json["meshes"]:
            if mesh["name"] == "trunk" or mesh["name"].startswith("branches"):
                yield mesh["primitives"][0]["attributes"]


def lattice(at, seed):
    mask = 0xFFFFFFFF
    h = ((at & mask) * 0x9E3779B1 & mask) ^ seed
    h = (h ^ h >> 16) * 0x7FEB352D & mask
    h = (h ^ h >> 15) * 0x846CA68B & mask
    return (h ^ h >> 16) / 2**31 - 1


def noise(at, seed, steps):
    low = int(np.floor(at))
    f = at - low
    values = [lattice(place % steps if steps else place, seed) for place in (low, low + 1)]
    return values[0] + (values[1] - values[0]) * (6 * f**5 - 15 * f**4 + 10 * f**3)


def rhythm(hertz, loop):
    if loop <= 0:
        return hertz, 0
    steps = max(1, int(np.floor(hertz * loop + 0.5)))
    return steps / loop, steps


def quaternion(turn):
    angle = np.linalg.norm(turn)
    axis = turn / angle if angle > 0 else turn
    return np.append(np.sin(angle / 2) * axis, np.cos(angle / 2))


def times(a, b):
    return np.append(a[3] * b[:3] + b[3] * a[:3] + np.cross(a[:3], b[:3]), a[3] * b[3] - a[:3] @ b[:3])


def turned(q, v):
    q = np.broadcast_to(q, v.shape[:-1] + (4,))
    across = np.cross(q[..., :3], v) + q[..., 3:] * v
    return v + 2 * np.cross(q[..., :3], across)


def push(stem, wind):
    direction, strength, gusts, seconds, loop = wind
    hertz, steps = rhythm(0.8, loop)
    s = strength * (1 + gusts * noise(stem["base"] @ direction / 12 - hertz * seconds, 0x51ED270B, steps))
    hertz, steps = rhythm(stem["angularSpeed"] / (2 * np.pi), loop)
    give = stem["flexibility"] * s
    across = np.cross(stem["axis"], direction)
    sine = np.linalg.norm(across)
    turn = np.zeros(3)
    if sine > 1e-9:
        slender = min(stem["length"] / stem["diameter"], 60) / 60
        sway = 1 + 0.35 * np.sin(2 * np.pi * hertz * seconds + stem["phase"])
        angle = np.arctan2(sine, stem["axis"] @ direction)
        turn = min(0.35 * give * slender * sine * sway, angle) * across / sine
    beat, seed = hertz * seconds, int(stem["seed"])
    turn = turn + 0.05 * give * (noise(beat, seed, steps) * stem["x"] + noise(beat, ~seed & 0xFFFFFFFF, steps) * stem["y"])
    size = np.linalg.norm(turn)
    return turn * min(1, np.pi / 3 / size) if size > 0 else turn


def blend(a, b, part):
    q = (1 - part) * a + part * np.where(np.sum(a * b, -1, keepdims=True) < 0, -b, b)
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def pose(stems, nodes, wind):
    still = np.stack([nodes[c] for c in "xyz"], 1).astype(float)
    along = nodes["along"].astype(float)
    points, turns = still.copy(), np.tile([0, 0, 0, 1.0], (len(still), 1))
    frames = {}

    def place(row, at):
        first, count = int(stems["firstNode"][row]), int(stems["nodes"][row])
        node = first + int(np.clip(np.searchsorted(along[first:first + count], at, "right") - 1, 0, count - 2))
        part = (at - along[node]) / max(along[node + 1] - along[node], 1e-12)
        return node, np.clip(part, 0, 1)

    for row in range(len(stems["length"])):
        stem = {c: float(stems[c][row]) for c in ("length", "diameter", "flexibility", "angularSpeed", "phase")}
        stem["seed"] = stems["seed"][row]
        for vector in ("base", "axis", "x", "y"):
            stem[vector] = np.array([float(stems[vector + "." + c][row]) for c in "xyz"])
        own, parent = int(stems["stem"][row]), int(stems["parent"][row])
        if own == row:
            start, carried = stem["base"], np.array([0, 0, 0, 1.0])
            if parent >= 0:
                node, part = place(parent, float(stems["along"][row]))
                carried = blend(turns[node], turns[node + 1], part)
                axis = (1 - part) * still[node] + part * still[node + 1]
                start = (1 - part) * points[node] + part * points[node + 1] + turned(carried, start - axis)
            frames[row] = carried, push(stem, wind) / stem["length"]
        carried, per_metre = frames[own]
        first, count = int(stems["firstNode"][row]), int(stems["nodes"][row])
        if own != row:
            node, part = place(parent, float(stems["along"][row]))
            start = (1 - part) * points[node] + part * points[node + 1]
        at = start
        for n in range(first, first + count):
            points[n], turns[n] = at, times(carried, quaternion(along[n] * per_metre))
            if n + 1 < first + count:
                middle = times(carried, quaternion((along[n] + along[n + 1]) / 2 * per_metre))
                at = at + turned(middle, still[n + 1] - still[n])
    return still, along, points, turns


def main():
    attributes, posed = Glb(sys.argv[1]), Glb(sys.argv[2])
    strength, degrees, gusts, seconds, loop = map(float, sys.argv[3:8])
    angle = np.radians(degrees)
    direction = np.array([np.cos(angle), 0, -np.sin(angle)])  # glTF's y is up
    stems, nodes = attributes.table("stems"), attributes.table("nodes")
    still, along, points, turns = pose(stems, nodes, (direction, strength, gusts, seconds, loop))
    worst = moved = 0
    for own, other in zip(attributes.wood(), posed.wood()):
        vertices, hang = attributes.accessor(own["POSITION"]), attributes.accessor(own["_STEM"])
        rows = hang[:, 0].astype(int)
        first, count = stems["firstNode"][rows].astype(int), stems["nodes"][rows].astype(int)
        node = np.array([f + np.clip(np.searchsorted(along[f:f + c], a, "right") - 1, 0, c - 2)
                         for f, c, a in zip(first, count, hang[:, 1].astype(np.float32))])
        part = np.clip((hang[:, 1] - along[node]) / np.maximum(along[node + 1] - along[node], 1e-12), 0, 1)[:, None]
        axis = (1 - part) * still[node] + part * still[node + 1]
        turn = blend(turns[node], turns[node + 1], part)
        bent = (1 - part) * points[node] + part * points[node + 1] + turned(turn, vertices - axis)
        worst = max(worst, np.linalg.norm(bent - posed.accessor(other["POSITION"]), axis=1).max())
        moved = max(moved, np.linalg.norm(bent - vertices, axis=1).max())
    print(json.dumps({"worst": worst, "moved": moved}))


main()
