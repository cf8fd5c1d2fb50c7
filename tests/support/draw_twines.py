# SPDX-License-Identifier: BSD-3-Clause
"""Draws a result of a gear as its twines, coloured by their tension, into an SVG:

    /usr/bin/python3 draw_twines.py FILE.hdf OUT.svg [--every N]

A triangle of netting is a part of the plane that the panel coordinates U, V span: where u = V + U or v = V - U is an
integer runs a twine [bars]. The picture shows every N-th of each direction, obliquely from ahead, and the same from
above and from the side at one scale. Needs h5py and numpy.
"""
import argparse
import math
from collections import defaultdict

import h5py
import numpy as np

WIDTH, HEIGHT = 1280, 780
UNITS = 10  # of the SVG in a pixel, so that coordinates are whole numbers
TENSIONS = (0.3, 100.0)  # ends of the colour scale [N]
CLASSES = 14
PALETTE = ["#2f3f8f", "#2f6d9e", "#27929a", "#3fb87f", "#9fd54f", "#f6e04a", "#ffb347", "#ff7a59"]
WATER = ("#0a2036", "#123a52")
AHEAD = -6.0  # [m] bridles are drawn from here on
EYE, TARGET = (-16, 15, -10.5), (14, -1, -19)  # of the oblique view [m]
OBLIQUE = (60, 30, WIDTH - 60, 590)  # left, top, right, bottom of its netting [pixels]
METRE = 23  # of the view from the side [pixels]


class Gear:
    """Netting in triangles and ropes in bars of a result file, both sides of a half model."""

    def __init__(self, file):
        with h5py.File(file) as f:
            grid = f["VTKHDF"]
            self.points = grid["Points"][: grid["NumberOfPoints"][0]]
            self.parts = [name.decode() for name in f["netloft/parts/name"][:]]
            cells = len(grid["Types"])
            fields = {name: grid["CellData"][name][:cells]
                      for name in ("part", "tension", "tension_u", "tension_v", "panel_corners")}
            connectivity, offsets = grid["Connectivity"][:], grid["Offsets"][:]
            self.is_half = f["netloft/gear"].attrs.get("times", 1) == 2
        corners = np.diff(offsets)
        take = lambda n: np.flatnonzero(corners == n)
        nodes = lambda chosen, n: connectivity[offsets[chosen][:, None] + np.arange(n)]
        netting, bars, points = take(3), take(2), take(1)
        self.triangles, self.part_of_triangle = nodes(netting, 3), fields["part"][netting]
        U, V = (fields["panel_corners"][netting][:, i::2] for i in (0, 1))
        self.twine = {"u": V + U, "v": V - U}
        # along a line of constant u runs the v direction
        self.tension = {"u": fields["tension_v"][netting], "v": fields["tension_u"][netting]}
        self.bars, self.part_of_bar = nodes(bars, 2), fields["part"][bars]
        self.floats = [connectivity[offsets[c]] for c in points if "headline" in self.parts[fields["part"][c]]]

    def smooth_tension(self, family):
        """Of each corner of a triangle: the mean over the triangles of its part that meet there."""
        sums = defaultdict(lambda: np.zeros(2))
        for nodes, part, tension in zip(self.triangles, self.part_of_triangle, self.tension[family]):
            for node in nodes:
                sums[part, node] += (tension, 1)
        return np.array([[sums[part, node][0] / sums[part, node][1] for node in nodes]
                         for nodes, part in zip(self.triangles, self.part_of_triangle)])


def twines(gear, family, every):
    """Lines of points (x, y, z, tension), a part's in one piece each."""
    pieces = defaultdict(dict)  # (part, number) -> edge -> [(other edge, own point, other point)]
    tension = gear.smooth_tension(family)
    for t, nodes in enumerate(gear.triangles):
        w = gear.twine[family][t]
        values = np.column_stack([gear.points[nodes], tension[t]])
        for number in range(math.ceil(w.min() / every), math.floor(w.max() / every) + 1):
            ends = crossings(nodes, w, values, number * every)
            if len(ends) == 2:
                line = pieces[gear.part_of_triangle[t], number]
                for (edge, point), (other, _) in (ends, ends[::-1]):
                    line.setdefault(edge, (point, []))[1].append(other)
    for line in pieces.values():
        yield from chains(line)


def crossings(nodes, w, values, level):
    """Where a triangle's edges cross w = level: [(edge, point)]."""
    level += 1e-7  # passes beside corners
    ends = []
    for i, j in ((0, 1), (1, 2), (2, 0)):
        if (w[i] < level) != (w[j] < level):
            s = (level - w[i]) / (w[j] - w[i])
            ends.append((tuple(sorted((nodes[i], nodes[j]))), (1 - s) * values[i] + s * values[j]))
    return ends


def chains(line):
    """Walks the pieces of one twine from end to end."""
    left = dict(line)
    while left:
        edge = next((e for e in left if sum(o in left for o in left[e][1]) < 2), next(iter(left)))
        chain = []
        while edge is not None:
            point, others = left.pop(edge)
            chain.append(point)
            edge = next((o for o in others if o in left), None)
        if len(chain) > 1:
            yield np.array(chain)


def colour_class(tension):
    low, high = np.log(TENSIONS)
    place = (np.log(np.clip(tension, *TENSIONS)) - low) / (high - low)
    return np.minimum((place * CLASSES).astype(int), CLASSES - 1)


def colour(place):
    """A colour of the palette, `place` from 0 to 1."""
    at = place * (len(PALETTE) - 1)
    k = min(int(at), len(PALETTE) - 2)
    a, b = ([int(c[i:i + 2], 16) for i in (1, 3, 5)] for c in PALETTE[k:k + 2])
    return "#" + "".join(f"{round(x + (at - k) * (y - x)):02x}" for x, y in zip(a, b))


class Oblique:
    """Perspective from `eye` towards `target`, z up; `points` just fit into `box` = (left, top, right, bottom)."""

    def __init__(self, eye, target, points, box):
        self.eye, self.scale, self.centre = np.array(eye), 1, np.zeros(2)
        forward = np.array(target) - self.eye
        self.forward = forward / np.linalg.norm(forward)
        right = np.cross(self.forward, [0, 0, 1])
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.right, self.forward)
        low, high = self(points).min(axis=0), self(points).max(axis=0)
        left_top, right_bottom = np.array(box[:2]), np.array(box[2:])
        self.scale = ((right_bottom - left_top) / (high - low)).min()
        self.centre = (left_top + right_bottom) / 2 - self.scale * (low + high) / 2

    def __call__(self, points):
        d = points - self.eye
        depth = d @ self.forward
        return self.centre + self.scale * np.column_stack([d @ self.right / depth, -(d @ self.up) / depth])


class FromTheSide:
    """Parallel projection: x to the right, z upwards, `scale` pixels a metre; the point (x, z) lies at `at`."""

    def __init__(self, scale, xz, at):
        self.scale, self.origin, self.at = scale, np.array(xz), np.array(at)

    def __call__(self, points):
        return self.at + self.scale * (points[:, [0, 2]] - self.origin) * [1, -1]


def simplified(points, tolerance):
    """Ramer, Douglas and Peucker: which points to keep, so that no other is farther off than `tolerance`."""
    keep, stack = np.zeros(len(points), bool), [(0, len(points) - 1)]
    keep[[0, -1]] = True
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        d = points[b] - points[a]
        inner = points[a + 1:b] - points[a]
        length = np.hypot(*d)
        off = np.abs(inner[:, 0] * d[1] - inner[:, 1] * d[0]) / length if length > 0 else np.hypot(*inner.T)
        k = int(np.argmax(off))
        if off[k] > tolerance:
            keep[a + 1 + k] = True
            stack += [(a, a + 1 + k), (a + 1 + k, b)]
    return keep


def path(points):
    """Relative moves in whole units."""
    p = np.round(points * UNITS).astype(int)
    steps = np.diff(p, axis=0)
    return f"M{p[0][0]} {p[0][1]}l" + " ".join(f"{x} {y}" for x, y in steps).replace(" -", "-")


class Picture:
    def __init__(self):
        self.body = []

    def add_lines(self, lines, view, width, opacity=1.0, tolerance=0.35):
        """Twines by classes of tension."""
        by_class = defaultdict(list)
        for line in lines:
            points, classes = view(line[:, :3]), colour_class(line[:, 3])
            keep = simplified(points, tolerance)
            keep[1:] |= classes[1:] != classes[:-1]
            points, classes = points[keep], classes[keep]
            start = 0
            for i in range(1, len(points)):
                if i == len(points) - 1 or classes[i] != classes[start]:
                    by_class[classes[start]].append(path(points[start:i + 1]))
                    start = i
        self.body.append(f'<g fill="none" stroke-width="{width * UNITS:g}" opacity="{opacity:g}">')
        for c in sorted(by_class):
            self.body.append(f'<path stroke="{colour(c / (CLASSES - 1))}" d="{"".join(by_class[c])}"/>')
        self.body.append("</g>")

    def add_rope(self, points, view, width, stroke="#e8eef2"):
        self.body.append(f'<path fill="none" stroke="{stroke}" stroke-width="{width * UNITS:g}" '
                         f'stroke-linejoin="round" d="{path(view(points))}"/>')

    def add_dots(self, points, view, radius):
        dots = "".join(f'<circle cx="{x * UNITS:.0f}" cy="{y * UNITS:.0f}" r="{radius * UNITS:g}"/>' for x, y in view(points))
        self.body.append(f'<g fill="#ff9f43">{dots}</g>')

    def add_text(self, x, y, text, size=15, fill="#c9d6df", anchor="start"):
        self.body.append(f'<text x="{x * UNITS:g}" y="{y * UNITS:g}" font-size="{size * UNITS}" fill="{fill}" '
                         f'text-anchor="{anchor}">{text}</text>')

    def add_box(self, x, y, width, height, fill):
        self.body.append(f'<rect x="{x * UNITS:.0f}" y="{y * UNITS:.0f}" width="{width * UNITS:.0f}" '
                         f'height="{height * UNITS:.0f}" fill="{fill}"/>')

    def add_line(self, x0, y0, x1, y1, stroke, width):
        self.body.append(f'<path stroke="{stroke}" stroke-width="{width * UNITS:g}" d="M{x0 * UNITS:g} {y0 * UNITS:g}'
                         f'L{x1 * UNITS:g} {y1 * UNITS:g}"/>')

    def svg(self):
        w, h = WIDTH * UNITS, HEIGHT * UNITS
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {w} {h}" '
            'font-family="Helvetica,Arial,sans-serif">',
            f'<defs><linearGradient id="water" x2="0" y2="1"><stop stop-color="{WATER[1]}"/>'
            f'<stop offset="1" stop-color="{WATER[0]}"/></linearGradient></defs>',
            f'<rect width="{w}" height="{h}" fill="url(#water)"/>', *self.body, "</svg>", ""])


def ropes(gear):
    """Points along every rope, in order, cut ahead of the gear."""
    for part in np.unique(gear.part_of_bar):
        bars = gear.bars[gear.part_of_bar == part]
        points = gear.points[np.append(bars[:, 0], bars[-1, 1])]
        inside = points[:, 0] > AHEAD
        if inside.sum() > 1:
            yield points[inside]


def starboard(points):
    """As computed; all that is seen from the side."""
    yield points


def both_sides(points):
    """Of a half model: starboard as computed, port mirrored on y = 0."""
    yield points
    yield points * ([1, -1, 1, 1] if points.shape[1] == 4 else [1, -1, 1])


def draw_view(picture, gear, lines, view, sides, width):
    """Netting, the lower half first, then ropes and floats; `width` of a twine in pixels."""
    seen = lambda chosen: [side for line in chosen for side in sides(line)]
    picture.add_lines(seen([line for is_lower, line in lines if is_lower]), view, width, 0.6)
    picture.add_lines(seen([line for is_lower, line in lines if not is_lower]), view, width)
    for points in seen(ropes(gear)):
        picture.add_rope(points, view, 2.7 * width)
    for points in seen([gear.points[gear.floats]]):
        picture.add_dots(points, view, 4 * width)


def draw_scale(picture, x, y):
    """Colours and tensions."""
    width, height = 22, 10
    for c in range(CLASSES):
        picture.add_box(x + c * width, y, width + 0.5, height, colour(c / (CLASSES - 1)))
    low, high = (math.log10(t) for t in TENSIONS)
    for tension in (0.3, 1, 3, 10, 30, 100):
        place = (math.log10(tension) - low) / (high - low)
        picture.add_text(x + place * CLASSES * width, y + 28, f"{tension:g}", 14, anchor="middle")
    picture.add_text(x + CLASSES * width + 24, y + 28, "N", 14)
    picture.add_text(x, y - 10, "tension in a twine", 15)


def by_height(lines):
    """Whether each line belongs to the lower half of the gear, which is drawn first."""
    middle = np.mean([line[:, 2].mean() for line in lines])
    return [(line[:, 2].mean() < middle, line) for line in lines]


def draw_oblique(picture, gear, lines):
    netting = gear.points[np.unique(gear.triangles)]
    sides = both_sides if gear.is_half else starboard
    view = Oblique(EYE, TARGET, np.vstack(list(sides(netting))), OBLIQUE)
    draw_view(picture, gear, lines, view, sides, 0.8)


def draw_side(picture, gear, lines):
    """On a scale of metres, over the lowest point."""
    top, bed, x0 = OBLIQUE[3] + 30, HEIGHT - 70, 110
    picture.add_box(0, top, WIDTH, HEIGHT - top, WATER[0])
    view = FromTheSide(METRE, (0, gear.points[:, 2].min()), (x0, bed))
    picture.add_line(0, bed + 1, WIDTH, bed + 1, "#8a7a5c", 2)
    draw_view(picture, gear, lines, view, starboard, 0.6)
    for x in range(0, 50, 10):
        at = x0 + METRE * x
        picture.add_line(at, bed + 4, at, bed + 12, "#8fa3b0", 1)
        picture.add_text(at, bed + 30, f"{x} m", 13, anchor="middle")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("svg")
    parser.add_argument("--every", type=int, default=6, help="twines drawn of each direction: every N-th")
    return parser.parse_args()


def main():
    options = parse()
    gear, picture = Gear(options.file), Picture()
    lines = by_height([line for family in "uv" for line in twines(gear, family, options.every)])
    draw_oblique(picture, gear, lines)
    draw_side(picture, gear, lines)
    draw_scale(picture, WIDTH - 370, 54)
    with open(options.svg, "w") as out:
        out.write(picture.svg())


if __name__ == "__main__":
    main()
