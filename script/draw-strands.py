#!/usr/bin/env python3
"""Draws the strands of a small flat tree as lines in its wood.

Reads `stromar-cli structure --segments` of a tree of strands whose partings lie in one plane; writes an SVG.
"""
import json
import sys

SCALE, MARGIN = 80, 20
COLOURS = ["#2f7ed8", "#d8792f", "#3aa675", "#b54fc0", "#c9a227", "#6b7bd6", "#cf4a63"]


def read(lines):
    """Stems and their segments, by generation and number."""
    stems, segments = {}, {}
    for line in map(json.loads, lines):
        if "radius_base" in line:
            segments.setdefault((line["generation"], line["stem"]), []).append(line)
        else:
            stems[line["generation"], line["index"]] = line
    return stems, segments


def children(stems):
    """The stem that leaves the end of a segment."""
    return {(g - 1, s["parent"], s["segment"]): (g, i) for (g, i), s in stems.items() if s["parent"] >= 0}


def flat(point):
    x = point[0] if abs(point[0]) >= abs(point[1]) else point[1]
    return x, point[2]


def walk(stem, index, low, high, path, tree, out):
    """Hands the strands low..high of a branch on to what it parts into."""
    stems, segments, leaving = tree
    segment = segments[stem][index]
    (x0, z0), (x1, z1) = flat(segment["base"]), flat(segment["end"])
    length = max(1e-9, ((x1 - x0) ** 2 + (z1 - z0) ** 2) ** 0.5)
    right = ((z1 - z0) / length, -(x1 - x0) / length)
    count = high - low
    for strand in range(low, high):
        off = ((strand - low + 0.5) / count - 0.5) * 2
        for (x, z), radius in (((x0, z0), segment["radius_base"]), ((x1, z1), segment["radius_base"])):
            path[strand].append((x + off * radius * right[0], z + off * radius * right[1]))
    out.append((x0, z0, x1, z1, segment["radius_base"], segment["radius_end"], right))
    if index + 1 == len(segments[stem]):
        return
    aside = leaving[stem[0], stem[1], index]
    taken = segments[aside][0]["strands"]
    leader = segments[stem][index + 1]
    leads_right = (flat(leader["end"])[0] - x1) * right[0] > (flat(segments[aside][0]["end"])[0] - x1) * right[0]
    if leads_right:
        walk(aside, 0, low, low + taken, path, tree, out)
        walk(stem, index + 1, low + taken, high, path, tree, out)
    else:
        walk(stem, index + 1, low, high - taken, path, tree, out)
        walk(aside, 0, high - taken, high, path, tree, out)


def smooth(points):
    """A path through the middles of a line of points."""
    text = "M%.1f %.1f" % points[0]
    for a, b in zip(points[1:], points[2:]):
        text += " Q%.1f %.1f %.1f %.1f" % (*a, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    return text + " L%.1f %.1f" % points[-1]


def main():
    stems, segments = read(sys.stdin)
    total = segments[0, 0][0]["strands"]
    path, wood = [[] for _ in range(total)], []
    walk((0, 0), 0, 0, total, path, (stems, segments, children(stems)), wood)
    xs = [x for line in path for x, _ in line]
    zs = [z for line in path for _, z in line]
    left, top = min(xs), max(zs)
    place = lambda p: (MARGIN + (p[0] - left) * SCALE, MARGIN + (top - p[1]) * SCALE)
    width, height = 2 * MARGIN + (max(xs) - left) * SCALE, 2 * MARGIN + (top - min(zs)) * SCALE
    print('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d">' % (width, height, width, height))
    for x0, z0, x1, z1, low, high, (rx, rz) in wood:
        corners = [(x0 - low * rx, z0 - low * rz), (x1 - high * rx, z1 - high * rz), (x1 + high * rx, z1 + high * rz), (x0 + low * rx, z0 + low * rz)]
        print('<polygon points="%s" fill="#d8c3a5" fill-opacity="0.6"/>' % " ".join("%.1f,%.1f" % place(c) for c in corners))
    for i, line in enumerate(path):
        print('<path d="%s" fill="none" stroke="%s" stroke-width="2"/>' % (smooth([place(p) for p in line]), COLOURS[i % len(COLOURS)]))
    print("</svg>")


main()
