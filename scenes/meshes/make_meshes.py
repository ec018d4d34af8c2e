#!/usr/bin/env python3
"""Makes the meshes of the scenes: python3 make_meshes.py [FOLDER]. The same numbers every time.

grid.obj    a rectangle of quads
disk.obj    a round cloth of triangles around random points (Bowyer, 1981; Watson, 1981)
poncho.obj  a ring of triangles: a round cloth with a hole for the neck
shirt.obj   a tube of quads with two holes for the arms; groups: collar and hem
knot.obj    a closed tube of quads along a trefoil knot: a solid
"""

import math
import random
import sys
from pathlib import Path


def text(value):
    return f"{value:.4f}".rstrip("0").rstrip(".").replace("-0", "0", value == 0) or "0"


def write(file, about, vertices, faces, groups=()):
    """Faces are written group by group: those that `groups` name ([name, faces]), then the others."""
    lines = [f"# {about}; made by make_meshes.py"]
    lines += ["v " + " ".join(text(value) for value in vertex) for vertex in vertices]
    named = {face for _, some in groups for face in some}
    parts = list(groups) + [("rest", [face for face in faces if face not in named])]
    for name, some in parts if groups else [(None, faces)]:
        if name:
            lines.append(f"g {name}")
        lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in some]
    file.write_text("\n".join(lines) + "\n")


def grid(folder, rows=16, columns=21, step=0.05):
    vertices = [(step * column, -step * row, 0) for row in range(rows) for column in range(columns)]
    corner = lambda row, column: row * columns + column
    faces = [
        (corner(r, c), corner(r + 1, c), corner(r + 1, c + 1), corner(r, c + 1))
        for r in range(rows - 1)
        for c in range(columns - 1)
    ]
    write(folder / "grid.obj", "a rectangle of quads, 1 m by 0.75 m", vertices, faces)


def circle_around(a, b, c):
    """Centre and squared radius of the circle through three points."""
    ax, ay, bx, by, cx, cy = *a, *b, *c
    d = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
    a2, b2, c2 = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
    x = (a2 * (by - cy) + b2 * (cy - ay) + c2 * (ay - by)) / d
    y = (a2 * (cx - bx) + b2 * (ax - cx) + c2 * (bx - ax)) / d
    return x, y, (x - ax) ** 2 + (y - ay) ** 2


def delaunay(points):
    """Triangles, each of whose circles holds no other point; counterclockwise."""
    count = len(points)
    points = points + [(-50, -50), (50, -50), (0, 80)]
    outer = (count, count + 1, count + 2)
    triangles = {outer: circle_around(*(points[i] for i in outer))}
    for number in range(count):
        x, y = points[number]
        bad = [t for t, (cx, cy, r2) in triangles.items() if (x - cx) ** 2 + (y - cy) ** 2 < r2]
        edges = {}
        for t in bad:
            for edge in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
                edges[tuple(sorted(edge))] = None if tuple(sorted(edge)) in edges else edge
            del triangles[t]
        for edge in edges.values():
            if edge:
                made = (*edge, number)
                triangles[made] = circle_around(*(points[i] for i in made))
    return sorted(t for t in triangles if max(t) < count)


def flat(a, b, c):
    """Whether three points lie nearly on a line, as neighbours on a border do."""
    area = abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
    return area < 0.15 * max(math.dist(a, b), math.dist(b, c), math.dist(c, a)) ** 2


def disk(folder, radius=0.62, apart=0.037):
    chance = random.Random(7)
    border = round(2 * math.pi * radius / apart)
    points = [
        (radius * math.cos(2 * math.pi * i / border), radius * math.sin(2 * math.pi * i / border))
        for i in range(border)
    ]
    misses = 0
    while misses < 4000:  # darts that keep their distance
        r, angle = (radius - 0.7 * apart) * math.sqrt(chance.random()), 2 * math.pi * chance.random()
        dart = (r * math.cos(angle), r * math.sin(angle))
        if all((dart[0] - x) ** 2 + (dart[1] - y) ** 2 > (0.8 * apart) ** 2 for x, y in points):
            points.append(dart)
        else:
            misses += 1
    # Points on one circle have no one way of being joined: a hair's breadth decides it.
    faces = delaunay([(x + 1e-6 * chance.random(), y + 1e-6 * chance.random()) for x, y in points])
    faces = [face for face in faces if min(face) >= border or not flat(*(points[i] for i in face))]
    write(folder / "disk.obj", "a round cloth, 1.24 m wide", [(x, 0, -y) for x, y in points], faces)


def poncho(folder, neck=0.115, radius=0.66, apart=0.042):
    chance = random.Random(3)
    rings = round((radius - neck) / (0.87 * apart)) + 1
    vertices, faces, ring_starts = [], [], []
    for ring in range(rings):
        r = neck + (radius - neck) * ring / (rings - 1)
        count = max(24, round(2 * math.pi * r / apart))
        start = chance.random()
        ring_starts.append((len(vertices), count, start))
        for i in range(count):
            angle = 2 * math.pi * (i + start) / count
            vertices.append((r * math.cos(angle), 0, -r * math.sin(angle)))
    for (inner, few, inner_turn), (outer, many, outer_turn) in zip(ring_starts, ring_starts[1:]):
        # Round both rings at once: the next triangle takes a side of the ring that is behind.
        i = 0
        j = round(inner_turn / few * many - outer_turn)
        end_i, end_j = few, j + many
        while i < end_i or j < end_j:
            next_inner = (i + 1 + inner_turn) / few if i < end_i else math.inf
            next_outer = (j + 1 + outer_turn) / many if j < end_j else math.inf
            a, b = inner + i % few, outer + j % many
            if next_inner < next_outer:
                faces.append((a, b, inner + (i + 1) % few))
                i += 1
            else:
                faces.append((a, b, outer + (j + 1) % many))
                j += 1
    write(folder / "poncho.obj", "a round cloth, 1.32 m wide, with a hole for the neck", vertices, faces)


def shirt(folder, around=54, rows=22, radius=0.24, height=0.62):
    hole_centre, hole_high, hole_wide = 0.12, 0.105, 0.085  # m below the collar; half axes
    step = height / (rows - 1)
    place = {}
    for row in range(rows):
        for side in range(around):
            angle, down = 2 * math.pi * side / around, step * row
            place[row, side] = [angle, down]

    def inside(angle, down):
        across = radius * math.remainder(angle, math.pi)  # from the nearer arm, at 0 and at half a turn
        return (across / hole_wide) ** 2 + ((down - hole_centre) / hole_high) ** 2

    cells = []
    for row in range(rows - 1):
        for side in range(around):
            corners = [(row, side), (row + 1, side), (row + 1, (side + 1) % around), (row, (side + 1) % around)]
            middle = 2 * math.pi * (side + 0.5) / around
            if inside(middle, step * (row + 0.5)) > 1:
                cells.append(corners)
    uses = {}
    for corners in cells:
        for corner in corners:
            uses[corner] = uses.get(corner, 0) + 1
    for corner, count in uses.items():  # the border of a hole is drawn onto the ellipse
        row, side = corner
        if count == 4 or row in (0, rows - 1):
            continue
        angle, down = place[corner]
        far = math.sqrt(inside(angle, down))
        nearest = round(angle / math.pi) * math.pi
        place[corner] = [nearest + (angle - nearest) / far, hole_centre + (down - hole_centre) / far]
    number = {corner: i for i, corner in enumerate(sorted(uses))}
    vertices = []
    for corner in sorted(uses):
        angle, down = place[corner]
        vertices.append((radius * math.cos(angle), -down, -0.62 * radius * math.sin(angle)))
    faces = {tuple(number[corner] for corner in corners): corners for corners in cells}
    collar = [face for face, corners in faces.items() if corners[0][0] == 0]
    hem = [face for face, corners in faces.items() if corners[1][0] == rows - 1]
    write(folder / "shirt.obj", "a tube with two holes for the arms, 0.62 m long", vertices, list(faces),
          [("collar", collar), ("hem", hem)])


def knot(folder, around=132, across=16, size=0.15, tube=0.082):
    """A trefoil about the y axis; the tube's cross-sections stand on the curve as its principal normals do."""
    middle = lambda t: (
        size * (2 + math.cos(3 * t)) * math.cos(2 * t),
        -size * 1.25 * math.sin(3 * t),
        size * (2 + math.cos(3 * t)) * math.sin(2 * t),
    )
    minus = lambda a, b: tuple(x - y for x, y in zip(a, b))
    cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    unit = lambda a: tuple(x / math.hypot(*a) for x in a)
    vertices, faces = [], []
    step = 1e-3
    for i in range(around):
        t = 2 * math.pi * i / around
        at, before, after = middle(t), middle(t - step), middle(t + step)
        along = unit(minus(after, before))
        bend = tuple(b + a - 2 * m for b, a, m in zip(before, after, at))
        side = unit(cross(along, bend))
        out = cross(side, along)
        for j in range(across):
            angle = 2 * math.pi * j / across
            vertices.append(
                tuple(m + tube * (math.cos(angle) * o + math.sin(angle) * s) for m, o, s in zip(at, out, side))
            )
            here, there = i * across, (i + 1) % around * across
            faces.append((here + j, here + (j + 1) % across, there + (j + 1) % across, there + j))
    write(folder / "knot.obj", "a closed tube along a trefoil knot, 1.06 m wide", vertices, faces)


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
    for make in (grid, disk, poncho, shirt, knot):
        make(folder)


if __name__ == "__main__":
    main()
