# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a solid visits: how far points are from the nearest of all its poses.

`f(p) = min over t of d(p, A(t))`, where d is the signed distance. Outside it is the distance from the set of all points
visited; where it is negative p has been visited. All poses are taken as a tree of stretches: a stretch whose middle
pose is farther than another by more than the solid moves within it holds no nearest one.
"""

from functools import cache, cached_property

import numpy as np

from ..offsets.any_field import AnyField
from ..variation.motion import Poses
from ..vectors import dot, norms, unit

FAN = 4  # parts of a stretch
TOP = 8  # stretches at most that a search begins with
CHUNK = 20_000  # points at a time
WIDTHS = (1.0, 0.25, 0.0625)  # of the parabolas in time that are put through three distances, in poses
SOME, PARTS = 33, 5  # poses, and points along each side of the lattice, where a deformation is looked at
DIFFERENCE = 1e-4  # of a step of the lattice, or of its size: over which slopes are taken
OUTWARD, OUT = 4, 0.5  # how often points inside are moved out, and how far beyond the surface, in steps of the lattice
CLEAR = 0.2  # steps of the lattice: what is found nearer to the surface may be on its other side
EXACTLY = (4.0, 1.0, 0.25, 0.0625)  # of those through exact distances, where the lattice has told the time roughly
FLAT = 1e-9  # of a step of the lattice: a parabola that bends less has no least place


class Visited(AnyField):
    """The field of all points that a moving solid visits; hints are the times of nearest poses.

    Parameters
    ----------
    field : Field
        Of the solid.
    motion : Motion
    poses : Poses
        So close to each other that what is between them is told by the two beside it.
    closed : bool
        Whether the last pose leads to the first.
    """

    def __init__(self, field, motion, poses, closed):
        self.field, self.motion, self.poses, self.closed = field, motion, poses, closed
        leg = np.cumsum(np.diff(poses.s, prepend=-1.0) == 0)  # where it stands twice it turns, and passes over nothing
        self.first, self.last = np.searchsorted(leg, leg), np.searchsorted(leg, leg, side="right") - 1
        self.told = None  # is told of the points that are asked for
        self.inverses = np.linalg.inv(poses.matrix)
        self.scales = 1 / np.linalg.norm(self.inverses, 2, axis=(1, 2))  # the least that a length becomes
        if motion.deforms:
            self.scales *= least_stretch(motion, field.box(3), poses.thinned(SOME))

    @cached_property
    def levels(self):
        """Of each level, single poses first: its stretches' middle poses, and how far the solid moves from these."""
        corners = self.motion.posed(self.field.box(PARTS if self.motion.deforms else 2), self.poses)  # (n, k, 3)
        count = len(corners)
        levels = [(np.arange(count), np.zeros(count))]
        size = 1
        while -(-count // size) > TOP:
            size *= FAN
            first = np.arange(0, count, size)
            middle = np.minimum(first + size // 2, count - 1)
            others = np.minimum(first[:, None] + np.arange(size), count - 1)
            levels.append((middle, norms(corners[others] - corners[middle][:, None]).max(axis=(1, 2))))
        return levels

    def evaluate(self, points, hints=None, reach=np.inf):
        """The values no farther from 0 than they are, and the times of the nearest poses: (n,), (n, 1)."""
        values, times = self.searched(points, hints)
        return np.sign(values) * np.maximum(np.abs(values) - self.field.error, 0.0), times[:, None]

    def inside(self, points, hints=None):
        """Whether points have been visited: of those that are found just outside the time is asked exactly."""
        values, times = self.searched(points, hints)
        near = np.flatnonzero(np.abs(values) <= self.field.error)
        values[near] = self.exact(points[near], times[near])[0]
        near = near[(values[near] >= 0) & (values[near] <= CLEAR * self.field.step)]
        values[near] = self.exact(points[near], *self.nearer(points[near], times[near]))[0]
        return values < 0

    def normals(self, points, hints=None):
        """The values, the normals of the surface where it is nearest, and the times of the nearest poses.

        All are told from outside, where f is the distance; points that are not clear of the surface are moved out for
        it. Inside, a depth is that in one pose alone, and the normal that of one of its faces, which a moving edge
        leaves inside; so it takes some moves, until one is clear, and not just past that face.
        """
        _, times = self.searched(points, hints)
        values, normals = self.exact(points, times)
        places, inside = points.copy(), np.flatnonzero(values <= CLEAR * self.field.step)
        for _ in range(OUTWARD):
            out = OUT * self.field.step - values[inside]
            places[inside] += out[:, None] * normals[inside]
            _, times[inside] = self.searched(places[inside], times[inside, None])
            values[inside], normals[inside] = self.exact(places[inside], times[inside])
            inside = inside[values[inside] <= CLEAR * self.field.step]
            if not len(inside):
                break
        times, feet = self.nearer(places, times)
        values, normals = self.exact(places, times, feet)
        foot = places - values[:, None] * normals
        return dot(points - foot, normals), normals, times[:, None]

    def off(self, vertices):
        """How far some `Vertices` are found to be from the surface: outside from the nearest pose, inside as deep."""
        off, within = np.abs(vertices.values), np.flatnonzero(vertices.values < 0)
        depths = -self.exact(vertices.places[within], vertices.hints[within, 0])[0]
        off[within] = np.maximum(off[within], depths)
        return off

    def searched(self, points, hints=None):
        """The values to within the field's error, and the times of the nearest poses: two (n,)."""
        values, times = np.empty(len(points)), np.empty(len(points))
        for start in range(0, len(points), CHUNK):
            some = slice(start, start + CHUNK)
            known = None if hints is None else hints[some, 0]
            if self.told:
                self.told(len(points[some]))
            values[some], times[some] = self.settled(points[some], self.nearest(points[some], known))
        return values, times

    def nearest(self, points, known):
        """The number of the nearest pose, (n,); of so few points that all pairs fit into memory."""
        count = len(points)
        pose = np.zeros(count, dtype=int) if known is None else np.round(known).astype(int) % len(self.scales)
        best = self.rough(points, pose)
        stretches = len(self.levels[-1][0])
        point, node = np.repeat(np.arange(count), stretches), np.tile(np.arange(stretches), count)
        for level in reversed(range(len(self.levels))):
            middle, reach = self.levels[level]
            at = middle[node]
            far = self.rough(points[point], at)
            first = np.flatnonzero(np.diff(point, prepend=-1))  # points rise
            least = np.repeat(np.minimum.reduceat(far, first), np.diff(np.append(first, len(point))))
            found = np.flatnonzero((far == least) & (far < best[point]))
            best[point[found]], pose[point[found]] = far[found], at[found]
            if level:
                kept = np.flatnonzero(far - reach[node] < best[point])
                children = node[kept, None] * FAN + np.arange(FAN)
                there = children < len(self.levels[level - 1][0])
                point, node = np.broadcast_to(point[kept, None], children.shape)[there], children[there]
                if not len(point):
                    break
        return pose

    def settled(self, points, pose):
        """The least value near a pose and its time, by parabolas through it and the times beside it."""
        time = pose.astype(float)
        least = self.rough(points, time)
        for width in WIDTHS:
            before, after = (self.rough(points, self.held(time, side)) for side in (-width, width))
            moved = self.held(time, width * least_of(before, least, after, FLAT * self.field.step))
            there = self.rough(points, moved)
            time, least = np.where(there < least, moved, time), np.minimum(there, least)
        return least, time

    def nearer(self, points, times):
        """Times near some at which the exact distance is least, by parabolas; and feet of points there."""
        here, feet = self.distances(points, self.between(times))
        for width in EXACTLY:
            sides = (self.between(self.held(times, side)) for side in (-width, width))
            before, after = (self.distances(points, side, feet)[0] for side in sides)
            moved = self.held(times, width * least_of(before, here, after, FLAT * self.field.step))
            there, feet = self.distances(points, self.between(moved), feet)
            times, here = np.where(there < here, moved, times), np.minimum(there, here)
        return times, feet

    def held(self, time, step):
        """Times that are so much later, and still on their leg of the motion."""
        if self.closed:
            return (time + step) % len(self.scales)
        pose = time.astype(int)
        return np.clip(time + step, self.first[pose], self.last[pose])

    def between(self, time):
        """A function of the names of what is known of all poses that gives it at times, (k,): between those beside.

        What is asked for twice is calculated once.
        """
        if time.dtype.kind == "i":
            return cache(lambda name: self.known[name][0].take(time, axis=0))
        first = np.minimum(time.astype(int), len(self.scales) - 1)  # also of a number of a pose itself
        part = time - first

        def at(name):
            before, changes = (values.take(first, axis=0) for values in self.known[name])
            return before + part.reshape(-1, *(1,) * (before.ndim - 1)) * changes

        return cache(at)

    @cached_property
    def known(self):
        """Of each name what is known of all poses, (n, ...), and how that changes until the next one."""
        known = {"inverse": self.inverses, "scale": self.scales, **self.poses._asdict()}
        del known["told"]
        after = np.arange(1, len(self.scales) + 1)
        after[-1] = 0 if self.closed else after[-1] - 1
        return {name: (values, values[after] - values) for name, values in known.items()}

    def posed(self, points, at):
        """Points (n, 3) as a solid has them at times that `between` knows; and how far some are from any of it.

        What a deformation takes nowhere near is farther by as much.
        """
        places = np.einsum("nij,nj->ni", at("inverse"), points - at("origin"))
        if self.motion.deforms:
            return self.motion.undeformed(places, **{name: at(name) for name in "tus"})
        return places, 0.0

    def rough(self, points, time):
        """The distance from the solid at times, by interpolation, or less."""
        at = self.between(time)
        places, missed = self.posed(points, at)
        return at("scale") * self.field.rough(places) + missed

    def distances(self, points, at, hints=None):
        """How far points are from the solid, and where it is nearest, as it is itself: (n,), (n, 3).

        That is from where its own nearest place is at times that `between` knows: a little farther than they are, where
        axes are scaled by different factors. Hints are places of the solid itself near that.
        """
        places, missed = self.posed(points, at)
        values, found = self.field.signed(places, hints)
        then = Poses(*map(at, Poses._fields[:-1]), ())
        return np.sign(values) * norms(points - self.motion.each(found.places, then)) + missed, found.places

    def exact(self, points, times, hints=None):
        """The distance from the solid at times, and its normals there: (n,), (n, 3).

        Where axes are scaled by different factors it is that to first order: the value over its slope. Hints are places
        of the solid itself near where it is nearest.
        """
        at = self.between(times)
        if self.motion.deforms:
            values, feet = self.distances(points, at, hints)
            slopes = self.slopes(points, at, feet)
        else:
            values, normals = self.field.exact(self.posed(points, at)[0], hints)
            slopes = np.einsum("nij,ni->nj", at("inverse"), normals)
        steep = norms(slopes)
        return values / np.where(steep > 0, steep, 1.0), unit(slopes)

    def slopes(self, points, at, feet):
        """The slopes of the distance from a deformed solid, by differences at times that are kept: (n, 3)."""
        step, slopes = DIFFERENCE * self.field.step, np.empty((len(points), 3))
        for axis, way in enumerate(step * np.eye(3)):
            ahead, behind = (self.distances(points + side * way, at, feet)[0] for side in (1, -1))
            slopes[:, axis] = (ahead - behind) / (2 * step)
        return slopes


def least_stretch(motion, points, poses):
    """The least that a deformation makes of a length, at points (k, 3) in some poses."""
    step = DIFFERENCE * float(np.ptp(points, axis=0).max())
    here = motion.deformed(points, poses)
    slopes = np.stack([motion.deformed(points + step * axis, poses) - here for axis in np.eye(3)], axis=3) / step
    return min(float(np.linalg.svd(slopes, compute_uv=False)[..., -1].min()), 1.0)


def least_of(before, here, after, flat):
    """Where a parabola through values at -1, 0 and 1 is least, at most 1 away; it goes down where it hardly bends."""
    bend = before - 2 * here + after
    bends = bend > flat
    return np.clip(np.where(bends, (before - after) / np.where(bends, 2 * bend, 1.0), np.sign(before - after)), -1, 1)
