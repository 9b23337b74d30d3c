# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The envelope of balls along a trajectory, or of discs in a plane: rings on characteristic circles, in runs.

Where each ball lies within the next there are no circles, and the surface ends in a point on either side. A point x
inside some ball has a least value of |x - t(u)|^2 - r(u)^2: within the domain it is then in a characteristic disc, else
in a ball at an end. So all balls together are what the runs enclose, each with its ends closed.
"""

from dataclasses import replace

import numpy as np

from ..contours import Circle, Section
from ..declared.options import PREFIX
from ..declared.parameters import at, require
from ..declared.wording import near
from ..grids import in_plane
from ..grids.chart import Chart, lengths_around
from ..grids.drawn import affine, drawn
from ..grids.grid import Grid
from ..meshes.joining import joined
from ..meshes.mesh import Mesh, require_few
from ..rings import caps
from ..rings.ends import Flat, Open
from ..self_intersection.folds import TOLD, between, stretches_told
from ..stations import rotations
from ..stations.coarseness import told_coarse
from ..stations.frames import Frames, RotationMinimizing, axes
from ..stations.plane import normal_of
from ..stations.sampling import Count, place
from ..trajectories.arc_length import arc_length
from ..vectors import norms
from .balls import balls
from .characteristic import circles
from .pacing import marks, pace
from .plane_region import region

NONE = "must change more slowly than the path goes on, or the ends be round: each {} lies within the next"
ACROSS = Section(np.array([(-1.0, 0.0), (1.0, 0.0)]), np.array([0, 2]), np.zeros(2, bool), closed=False)


class Envelope:
    """What the mesh of a canal surface is drawn from.

    Attributes
    ----------
    section : Section
        A circle of radius 1, or of discs a line from side to side.
    circles : Circles
    e2, e3 : (k, 3) float array
        The axes of each circle's plane.
    runs : list of (k,) int arrays
        The circles that make a surface each; those at the ends of most are points.
    """

    def __init__(self, shape, factor=1.0, apart=False):
        self.shape, self.trajectory = shape, shape.trajectory
        with at("trajectory"):
            arc_length(self.trajectory)
        flat = shape.is_plane
        with at("trajectory"):
            self.normal = normal_of(self.trajectory) if flat else None
        self.balls = balls(self.trajectory, shape.radius, factor)
        self.section = ACROSS if flat else Circle(1.0, shape.points).section()
        paced = (None, None) if self.balls.is_constant else (pace(self.balls).density, pace(self.balls).way)
        self.stations = place(self.trajectory, shape.samples, marks(self.balls, shape.samples), *paced)
        self.circles = circles(self.stations, self.balls, shape.round_ends, shape.samples, shape.points, apart)
        require_few(len(self.circles.s) * len(self.section.points), "samples")

    @property
    def closed(self):
        return self.stations.closed

    @property
    def sides(self):
        """The axes of each circle's plane, e2 and e3: two (k, 3) float arrays."""
        stations, found = self.stations, self.circles
        if self.normal is not None:
            return np.cross(found.axis, self.normal), np.broadcast_to(self.normal, found.axis.shape)
        e2, e3, _ = axes(RotationMinimizing(), stations, np.zeros(len(stations.u)))
        e2, e3 = e2[found.station], e3[found.station]
        at_corner = np.isin(found.station, stations.corners)
        if at_corner.any():
            tangent = stations.tangent[found.station[at_corner]]
            e2[at_corner] = rotations.turned(e2[at_corner], tangent, found.axis[at_corner])
            e3[at_corner] = np.cross(found.axis[at_corner], e2[at_corner])
        return e2, e3

    @property
    def runs(self):
        """The circles that make a surface each, and whether it is closed: a list of ((k,) int array, bool)."""
        point = self.circles.sizes == 0
        count = len(point)
        nothing = point & np.roll(point, -1)  # between two points
        if not self.closed:
            nothing[-1] = True
        elif not nothing.any():
            return [(np.arange(count), True)]
        order = np.roll(np.arange(count), -1 - np.flatnonzero(nothing)[-1])
        found = np.split(order, np.flatnonzero(nothing[order])[:-1] + 1)
        return [(run, False) for run in found if not point[run].all()]

    def mesh(self, dtype):
        """The surface, of one part for each run."""
        return joined(self.parts(dtype))

    def parts(self, dtype):
        """The meshes of the runs: a list."""
        runs, e2, e3 = self.runs, *self.sides
        require(runs, NONE.format("disc" if self.shape.is_plane else "ball"), self.shape.radius, "radius")
        sizes, centres = self.circles.sizes[:, None], self.circles.centres
        rings = np.stack((centres, sizes * e2, sizes * e3))
        way, total = self.circles.way(self.closed, self.stations.total)
        way = way - way[np.flatnonzero(self.circles.station == 0)[-1]]  # 0 where the trajectory starts
        told = self.told
        return [self.part(run, closed, rings, way, total, told, dtype) for run, closed in runs]

    def part(self, run, closed, rings, way, total, told, dtype):
        """The mesh of one run."""
        points, last, section = self.circles.sizes[run] == 0, len(way) - 1, self.section
        ends = [Flat() if self.shape.flat_ends[side] else Open() for side in (0, 1)]
        inner = (closed or points[0] or run[0] != 0, closed or points[-1] or run[-1] != last)
        grid = Grid(
            rings=len(run),
            tips=tuple(np.flatnonzero(points).tolist()),
            closed=closed,
            creases=(),
            offsets=tuple(section.offsets.tolist()),
            sharp=(),
            caps=caps.at_ends((section, section), ends, inner),
            gaps=tuple(section.gaps.tolist()),
        )
        s = way[run] + np.where(run < run[0], total, 0.0)  # round the start of a closed trajectory
        whole = ~points
        around = lengths_around(section, np.full(2, self.circles.sizes[run][whole].mean()))
        flat = tuple(section.points * self.circles.sizes[run[side]] for side in (0, -1))
        length = total if closed else s[-1] - s[0]
        chart = Chart(grid, self.circles.u[run], s, length, around, flat, self.shape.texture, self.shape.attributes)
        return Mesh(drawn(grid, affine(section.points), rings[:, run], dtype), grid.topology(), chart, told)

    def region(self, dtype):
        """The region that discs visit, each place once, as faces in its plane."""
        e2, normal = self.sides
        origin, x = self.circles.centres[0], e2[0]
        y = np.cross(normal[0], x)
        aside = self.circles.sizes[:, None] * e2
        right, left = ((self.circles.centres + side * aside - origin) @ np.stack((x, y), axis=1) for side in (1, -1))
        strips = []
        for run, closed in self.runs:
            order = np.append(run, run[:1]) if closed else run
            strips.append((left[order], right[order]))
        require(strips, NONE.format("disc"), self.shape.radius, "radius")
        found = region(strips)
        plane = np.stack((origin, x, y))
        return in_plane.flat(found, plane, self.shape.texture, self.shape.attributes, dtype)

    def frames(self, most):
        """The middles, tangents, axes and circles at places spread evenly: `Frames`."""
        steps = self.stations.total / self.balls.largest
        wanted = int(np.clip(steps + (not self.closed), 2, most))
        bare = Envelope(replace(self.shape, samples=Count(wanted), start="open", end="open"))
        found, (e2, e3) = bare.circles, bare.sides
        first = np.flatnonzero(np.diff(found.station, prepend=-1))
        shown = first[np.unique(np.linspace(0, len(first) - 1, min(most, len(first))).round().astype(int))]
        sizes = found.sizes[:, None]
        rings = np.stack((found.centres, sizes * e2, sizes * e3))[:, shown]
        contours = np.einsum("mk,kni->nmi", affine(self.section.points), rings)
        held = (found.u, found.s, found.place, found.axis, e2, e3)
        return Frames(*(values[shown] for values in held), (contours,))

    @property
    def told(self):
        """Sentences for people: what the trajectory says, where balls are swallowed, and where else it folds."""
        domain, generator = self.trajectory.domain, "disc" if self.shape.is_plane else "ball"
        said = [
            f"Radius: from {between(a, b, domain)} it changes faster than the path goes on: each {generator} lies"
            " within a neighbour, and the surface is in parts."
            for a, b in self.balls.swallowed
        ]
        if len(said) > TOLD:
            said[TOLD:] = [f"Radius: {len(said) - TOLD} more such places."]
        stations = self.stations
        bend = norms(stations.bend)
        bend[stations.corners] = 0.0
        values = self.balls.folding(stations.u, stations.s, bend)
        turns = [PREFIX + turned(u, domain) for u in self.circles.turning_back]
        if len(turns) > TOLD:
            turns[TOLD:] = [f"{PREFIX}{len(turns) - TOLD} more such places."]
        coarse = told_coarse(stations, self.shape.samples, self.balls.largest)
        return (*self.trajectory.told, *coarse, *said, *stretches_told(stations, values, backward), *turns)


def turned(u, domain):
    """What is said of circles that turn back at a parameter of a domain."""
    return f"at u = {near(u, *domain)} the circles turn back on one ball, and the surface folds."


def backward(a, b, domain):
    """What is said of circles that run backward between two parameters of a domain."""
    return f"from {between(a, b, domain)} the circles run backward on their balls, and the surface folds."
