# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random outlines of lines and arcs as parts have them, and which points are inside of one, by centres and radii."""

import numpy as np
from contour_inputs import ngon, star

from sweep_addon.core.contours import Outline
from sweep_addon.core.declared.parameters import ShapeError


def random_outline(rng):
    """(n, 3) float array: x, y, bulge of a random polygon with fillets, chamfers, notches, bumps, tabs and arcs."""
    vertices = with_lines(rng.choice([skyline, rough_star, regular])(rng))
    for _ in range(rng.integers(3, 9)):
        changed = rng.choice([fillet, fillet, chamfer, notch, round_notch, tab, arc])(rng, vertices)
        if changed is not None and valid(changed, 1e-3):
            vertices = changed
    if not vertices[:, 2].any() or not valid(vertices, 1e-6):
        return random_outline(rng)
    turned = vertices[:, :2] @ turn(rng.uniform(0, 2 * np.pi)) if rng.random() < 0.5 else vertices[:, :2]
    return np.column_stack([turned, vertices[:, 2]])


def valid(vertices, tolerance):
    """Whether an outline neither crosses nor touches itself, as chords within a distance of it show."""
    try:
        Outline([vertices[:, :2]], [vertices[:, 2]], tolerance=tolerance)
    except ShapeError:
        return False
    return True


def skyline(rng):
    """A polygon of right angles: a row of towers on a line."""
    towers = rng.integers(1, 5)
    x = np.cumsum(rng.integers(1, 5, towers + 1)) / 4
    heights = rng.permutation(np.arange(2, 2 + towers)) / 2
    tops = np.stack([np.repeat(x, 2)[1:-1], np.repeat(heights, 2)], axis=1)
    return np.concatenate([[(x[0], 0), (x[-1], 0)], tops[::-1]])


def rough_star(rng):
    return star(rng, rng.integers(4, 12))


def regular(rng):
    return ngon(rng.integers(3, 9), 1.0)


def with_lines(corners):
    return np.column_stack([corners, np.zeros(len(corners))])


def turn(angle):
    return np.array([(np.cos(angle), np.sin(angle)), (-np.sin(angle), np.cos(angle))])


def pick(rng, vertices, lines):
    """A random start of so many consecutive lines, as the index of the second of their vertices; or nothing."""
    straight = vertices[:, 2] == 0
    runs = np.flatnonzero(np.all([np.roll(straight, 1 - k) for k in range(lines)], axis=0))
    return rng.choice(runs) if len(runs) else None


def spliced(vertices, index, inserted):
    """The outline with other vertices in place of one."""
    return np.concatenate([vertices[:index], inserted, vertices[index + 1 :]])


def cut(rng, vertices):
    """A random corner between two lines, its unit directions there, and how far it may be cut back."""
    index = pick(rng, vertices, 2)
    if index is None:
        return None
    before, corner, after = (vertices[(index + k) % len(vertices), :2] for k in (-1, 0, 1))
    lengths = np.hypot(*(corner - before)), np.hypot(*(after - corner))
    if abs(np.cross([*(corner - before), 0], [*(after - corner), 0])[2]) < 0.01 * lengths[0] * lengths[1]:
        return None  # no corner
    back = rng.uniform(0.1, 0.45) * min(lengths)
    return index, corner, (corner - before) / lengths[0], (after - corner) / lengths[1], back


def fillet(rng, vertices):
    if (found := cut(rng, vertices)) is None:
        return None
    index, corner, u, v, back = found
    angle = np.arctan2(u[0] * v[1] - u[1] * v[0], u @ v)
    return spliced(vertices, index, [(*(corner - back * u), np.tan(angle / 4)), (*(corner + back * v), 0.0)])


def chamfer(rng, vertices):
    if (found := cut(rng, vertices)) is None:
        return None
    index, corner, u, v, back = found
    return spliced(vertices, index, [(*(corner - back * u), 0.0), (*(corner + back * v), 0.0)])


def stretch(rng, vertices):
    """A random line, two places on it, its unit direction and the one to its right."""
    index = pick(rng, vertices, 1)
    if index is None:
        return None
    a, b = vertices[index, :2], vertices[(index + 1) % len(vertices), :2]
    s, t = np.sort(rng.uniform(0.1, 0.9, 2))
    length = np.hypot(*(b - a))
    return index, a + s * (b - a), a + t * (b - a), (b - a) / length, (t - s) * length


def notch(rng, vertices):
    """A rectangular notch or bump."""
    if (found := stretch(rng, vertices)) is None:
        return None
    index, p, q, u, width = found
    deep = np.array([u[1], -u[0]]) * width * rng.choice([-1, 1]) * rng.uniform(0.2, 1.5)
    added = [vertices[index], (*p, 0.0), (*(p + deep), 0.0), (*(q + deep), 0.0), (*q, 0.0)]
    return spliced(vertices, index, added)


def round_notch(rng, vertices):
    """A notch or bump that is an arc, up to most of a circle."""
    if (found := stretch(rng, vertices)) is None:
        return None
    index, p, q, _, _ = found
    bulge = rng.choice([-1, 1]) * rng.choice([1.0, rng.uniform(0.1, 3.0)])
    return spliced(vertices, index, [vertices[index], (*p, bulge), (*q, 0.0)])


def tab(rng, vertices):
    """A tab or a slot with a round end."""
    if (found := stretch(rng, vertices)) is None:
        return None
    index, p, q, u, width = found
    way = rng.choice([-1, 1])
    deep = np.array([u[1], -u[0]]) * width * way * rng.uniform(0.2, 1.5)
    added = [vertices[index], (*p, 0.0), (*(p + deep), float(way)), (*(q + deep), 0.0), (*q, 0.0)]
    return spliced(vertices, index, added)


def arc(rng, vertices):
    """An arc in place of a line."""
    index = pick(rng, vertices, 1)
    if index is None:
        return None
    return spliced(vertices, index, [(*vertices[index, :2], rng.uniform(-0.9, 0.9))])


def band(rng):
    """(n, 3) float array: a strip of one width along random arcs and lines that are tangent; it may cross itself."""
    half = rng.choice([0.02, 0.1, 0.3])
    place, angle, bulges = np.zeros(2), 0.0, []
    rails = [[place - (0, half)], [place + (0, half)]]
    for _ in range(rng.integers(1, 7)):
        if rng.random() < 0.2:
            place = place + rng.uniform(0.3, 2) * np.array([np.cos(angle), np.sin(angle)])
            bulges.append(0.0)
        else:
            sweep = rng.uniform(0.3, 5) * rng.choice([-1, 1])
            left = np.sign(sweep) * rng.uniform(1.2 * half, 1.5) * np.array([-np.sin(angle), np.cos(angle)])
            place = place + left - left @ turn(sweep)
            angle += sweep
            bulges.append(np.tan(sweep / 4))
        aside = half * np.array([-np.sin(angle), np.cos(angle)])
        rails[0].append(place - aside)
        rails[1].append(place + aside)
    cap = rng.choice([0.0, 1.0])
    right = np.column_stack([rails[0], [*bulges, cap]])
    left = np.column_stack([rails[1][::-1], [*(-bulge for bulge in bulges[::-1]), cap]])
    return np.concatenate([right, left])


def inside_by_rays(vertices, points):
    """(n,) bool array: whether a ray to the right meets the lines and arcs an odd number of times."""
    x, y = points.T
    crossings = np.zeros(len(points), dtype=int)
    for (ax, ay, bulge), (bx, by, _) in zip(vertices, np.roll(vertices, -1, axis=0), strict=True):
        if bulge == 0:
            meets = (ay <= y) != (by <= y)
            with np.errstate(divide="ignore", invalid="ignore"):
                crossings += meets & (x < ax + (y - ay) / (by - ay) * (bx - ax))
            continue
        flat = (1 - bulge**2) / (4 * bulge)
        cx, cy = (ax + bx) / 2 - (by - ay) * flat, (ay + by) / 2 + (bx - ax) * flat
        radius = np.hypot(ax - cx, ay - cy)
        start, sweep = np.arctan2(ay - cy, ax - cx), 4 * np.arctan(abs(bulge))
        half = np.sqrt(np.maximum(radius**2 - (y - cy) ** 2, 0))
        for side in (half, -half):
            angle = (np.arctan2(y - cy, side) - start) * np.sign(bulge) % (2 * np.pi)
            crossings += (half > 0) & (cx + side > x) & (angle < sweep)
    return crossings % 2 == 1
